//! Memory for the easy door: the caller's allocator, or the default one.

use core::ffi::c_void;

use super::build::hug_scene;
use super::types::{hug_alloc_fn, hug_build_desc, hug_free_fn};
use crate::Error;
use crate::arena::ALIGN;
#[cfg(feature = "alloc")]
use crate::simd::ask_for_large;

/// Where memory comes from.
#[derive(Clone, Copy)]
pub struct Allocator {
    alloc: hug_alloc_fn,
    free: hug_free_fn,
    user: *mut c_void,
}

/// Stands right before a scene's arena and tells [`Block::free_scene`] how to
/// free it: the arena itself holds no pointers.
#[repr(C, align(64))]
struct Prefix {
    allocator: Allocator,
    size: usize,
    /// The scratch memory that is kept for [`super::hug_rebuild`], or NULL.
    scratch: *mut u8,
    scratch_size: usize,
}

const _: () = assert!(size_of::<Prefix>() <= ALIGN);

impl Allocator {
    /// The descriptor's allocator; both functions or none.
    pub fn new(desc: &hug_build_desc) -> Result<Self, Error> {
        let default = cfg!(feature = "alloc");
        match (desc.alloc, desc.free) {
            (Some(_), Some(_)) => {}
            (None, None) if default => {}
            _ => return Err(Error::Null),
        }
        Ok(Self { alloc: desc.alloc, free: desc.free, user: desc.user })
    }

    /// `size` bytes of any values, aligned to 64.
    fn get(&self, size: usize) -> Result<*mut u8, Error> {
        let memory = match self.alloc {
            // SAFETY: the caller's function, called as documented.
            Some(alloc) => unsafe { alloc(size, ALIGN, self.user) }.cast(),
            None => default_alloc(size)?,
        };
        if memory.is_null() {
            return Err(Error::OutOfMemory);
        }
        if !(memory as usize).is_multiple_of(ALIGN) {
            // SAFETY: it came from `alloc` just now.
            unsafe { self.put(memory, size) };
            return Err(Error::Alignment);
        }
        Ok(memory)
    }

    /// # Safety
    /// `memory` came from [`Allocator::get`] with this size.
    unsafe fn put(&self, memory: *mut u8, size: usize) {
        match self.free {
            // SAFETY: the caller's function, called as documented.
            Some(free) => unsafe { free(memory.cast(), size, self.user) },
            // SAFETY: by the caller.
            None => unsafe { default_free(memory, size) },
        }
    }
}

/// C's own allocator, where there is one: memory from it is a caller's like any other, and need
/// not be cleared, which for all that a bound asks for would take as long as a pass of the build.
#[cfg(all(feature = "std", any(unix, windows)))]
mod plain {
    use core::ffi::c_void;

    unsafe extern "C" {
        fn malloc(size: usize) -> *mut c_void;
        fn free(memory: *mut c_void);
    }

    pub fn get(size: usize) -> *mut u8 {
        // SAFETY: any size will do. Compilers know `malloc`, and are not to know that it was that.
        core::hint::black_box(unsafe { malloc(size) }).cast()
    }

    /// # Safety
    /// `memory` came from [`get`].
    pub unsafe fn put(memory: *mut u8, _: usize) {
        // SAFETY: by the caller.
        unsafe { free(memory.cast()) };
    }
}

/// The program's allocator, of which Rust wants memory cleared before it is looked at.
#[cfg(all(feature = "alloc", not(all(feature = "std", any(unix, windows)))))]
mod plain {
    use core::alloc::Layout;

    fn layout(size: usize) -> Option<Layout> {
        Layout::from_size_align(size, align_of::<usize>()).ok()
    }

    pub fn get(size: usize) -> *mut u8 {
        // SAFETY: the size is not 0.
        layout(size)
            .map_or(core::ptr::null_mut(), |layout| unsafe { alloc::alloc::alloc_zeroed(layout) })
    }

    /// # Safety
    /// `memory` came from [`get`] with this size.
    pub unsafe fn put(memory: *mut u8, size: usize) {
        if let Some(layout) = layout(size) {
            // SAFETY: by the caller; the layout is the one it was made with.
            unsafe { alloc::alloc::dealloc(memory, layout) };
        }
    }
}

/// Memory aligned to 64, of an allocator that is asked for room to align: of those that clear memory
/// some clear what is zero already, if asked for more alignment than their own.
#[cfg(feature = "alloc")]
fn default_alloc(size: usize) -> Result<*mut u8, Error> {
    let memory = plain::get(size.checked_add(ALIGN).ok_or(Error::Overflow)?);
    if memory.is_null() {
        return Ok(memory);
    }
    ask_for_large(memory, size);
    // From a word to 64 bytes, the word before the block says how many.
    let skip = ALIGN - memory as usize % ALIGN;
    // SAFETY: there is room for 64 bytes more, and a word before an aligned address.
    unsafe {
        let block = memory.add(skip);
        block.cast::<usize>().sub(1).write(skip);
        Ok(block)
    }
}

/// # Safety
/// `memory` came from [`default_alloc`] with this size.
#[cfg(feature = "alloc")]
unsafe fn default_free(memory: *mut u8, size: usize) {
    // SAFETY: by the caller.
    unsafe {
        let skip = memory.cast::<usize>().sub(1).read();
        plain::put(memory.sub(skip), size + ALIGN);
    }
}

#[cfg(not(feature = "alloc"))]
fn default_alloc(_: usize) -> Result<*mut u8, Error> {
    Err(Error::Null)
}

#[cfg(not(feature = "alloc"))]
unsafe fn default_free(_: *mut u8, _: usize) {}

/// An allocated block, freed when dropped unless it becomes a scene.
pub struct Block {
    allocator: Allocator,
    memory: *mut u8,
    size: usize,
    /// Bytes before the usable part.
    head: usize,
}

impl Block {
    pub fn scratch(allocator: &Allocator, size: usize) -> Result<Self, Error> {
        Self::new(allocator, size.max(ALIGN), 0)
    }

    /// Room for an arena, behind a prefix.
    pub fn scene(allocator: &Allocator, size: usize) -> Result<Self, Error> {
        Self::new(allocator, size.checked_add(ALIGN).ok_or(Error::Overflow)?, ALIGN)
    }

    fn new(allocator: &Allocator, size: usize, head: usize) -> Result<Self, Error> {
        Ok(Self { allocator: *allocator, memory: allocator.get(size)?, size, head })
    }

    /// Where the block came from.
    pub fn allocator(&self) -> Allocator {
        self.allocator
    }

    pub fn bytes(&mut self) -> &mut [u8] {
        // SAFETY: owned, and of whatever values a caller's memory has, as that which
        // [`hug_build_into`](super::hug_build_into) is given; what a build has not written it
        // does not look at.
        unsafe {
            core::slice::from_raw_parts_mut(self.memory.add(self.head), self.size - self.head)
        }
    }

    /// Gives the block away as a scene handle, with scratch memory to keep.
    pub fn into_scene(self, kept: Option<Self>) -> *mut hug_scene {
        let (scratch, scratch_size) =
            kept.as_ref().map_or((core::ptr::null_mut(), 0), |s| (s.memory, s.size));
        core::mem::forget(kept);
        let Self { allocator, size, .. } = self;
        let prefix = Prefix { allocator, size, scratch, scratch_size };
        // SAFETY: the block starts with room for the prefix, aligned to 64.
        let scene = unsafe {
            self.memory.cast::<Prefix>().write(prefix);
            self.memory.add(ALIGN)
        };
        core::mem::forget(self);
        scene.cast()
    }

    /// A scene's block again, and the scratch memory it keeps.
    ///
    /// # Safety
    /// `scene` came from [`Block::into_scene`] and is not used until it does so again.
    pub unsafe fn of_scene(scene: *mut hug_scene) -> (Self, Option<Self>) {
        // SAFETY: the prefix lies right before the scene.
        let (memory, prefix) = unsafe {
            let memory = scene.cast::<u8>().sub(ALIGN);
            (memory, memory.cast::<Prefix>().read())
        };
        let Prefix { allocator, size, scratch, scratch_size } = prefix;
        let kept = Self { allocator, memory: scratch, size: scratch_size, head: 0 };
        let block = Self { allocator, memory, size, head: ALIGN };
        if scratch.is_null() {
            core::mem::forget(kept);
            return (block, None);
        }
        (block, Some(kept))
    }

    /// # Safety
    /// `scene` came from [`Block::into_scene`] and is not used any more.
    pub unsafe fn free_scene(scene: *mut hug_scene) {
        // SAFETY: by the caller; both are freed when dropped.
        drop(unsafe { Self::of_scene(scene) });
    }
}

impl Drop for Block {
    fn drop(&mut self) {
        // SAFETY: owned, with the size it was allocated with.
        unsafe { self.allocator.put(self.memory, self.size) };
    }
}
