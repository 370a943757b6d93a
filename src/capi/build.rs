//! Building, opening, freeing.

use core::ffi::c_void;

use super::callbacks::Callbacks;
use super::desc::Parsed;
use super::guard::{guard, overlap};
use super::memory::{Allocator, Block};
use super::types::{
    HUG_BUILD_KEEP_SCRATCH, HUG_ERROR_ALIGNMENT, HUG_ERROR_INVALID_VALUE, HUG_ERROR_NULL,
    HUG_ERROR_OVERLAP, HUG_OK, HUG_OPEN_TRUSTED, hug_build_desc, hug_status,
};
use crate::Error;
use crate::arena::{self, View};
use crate::build;

/// A built or opened scene. A pointer to one points at its arena's first byte.
#[allow(non_camel_case_types)]
pub struct hug_scene(());

/// Builds a scene from triangles.
///
/// Memory comes from the descriptor's alloc and free, or from the default
/// allocator (in a library without one: HUG_ERROR_NULL). On success *out is
/// the scene, to be passed to hug_free; on failure it is NULL. Triangles with
/// a coordinate that is not finite, or with no area, are dropped and counted
/// (hug_stats). Cost: near linear in triangles and references.
///
/// With progress, the build can be watched and cancelled; with parallel_for, parts
/// of it run on the caller's threads. Nothing of a build that failed or was
/// cancelled stays allocated.
///
/// Threads: builds of different scenes may run at the same time.
///
/// # Safety
/// desc and what it points to must be readable, out writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_build(
    desc: *const hug_build_desc,
    out: *mut *mut hug_scene,
) -> hug_status {
    if out.is_null() {
        return HUG_ERROR_NULL;
    }
    // SAFETY: not NULL, writable by contract.
    unsafe { out.write(core::ptr::null_mut()) };
    guard(|| {
        // SAFETY: readable by contract.
        let parsed = unsafe { Parsed::read(desc) }?;
        let allocator = Allocator::new(&parsed.desc)?;
        let mut scratch = Block::scratch(&allocator, parsed.scratch_bytes()?)?;
        let keep = parsed.desc.flags & HUG_BUILD_KEEP_SCRATCH != 0;
        let block = Callbacks::new(&parsed.desc).run(|control| {
            let (soup, scratch) = parsed.soup(scratch.bytes())?;
            let plan = build::plan_with(soup, &parsed.options, scratch, control)?;
            let bytes = plan.arena_bytes();
            // Triangles that have moved may be in more voxels.
            let room = if keep { bytes / 2 } else { 0 };
            let size = bytes.checked_add(room).ok_or(Error::Overflow)?;
            let mut block = Block::scene(&allocator, size)?;
            plan.write_with(block.bytes(), control)?;
            Ok(block)
        })?;
        let kept = keep.then_some(scratch);
        // SAFETY: out was checked above.
        unsafe { out.write(block.into_scene(kept)) };
        Ok(())
    })
}

/// Frees a scene that hug_build returned. NULL is ignored. Scenes from
/// hug_build_into and hug_open live in the caller's memory: never pass them.
///
/// # Safety
/// No query may be running on the scene, and it must not be freed twice.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_free(scene: *mut hug_scene) {
    if !scene.is_null() {
        // SAFETY: by contract the scene came from hug_build.
        unsafe { Block::free_scene(scene) };
    }
}

/// Upper bounds on the memory that hug_build_into needs for this descriptor:
/// linear in the number of triangles (and in counts, if given). alloc and free
/// are not used. The bounds are multiples of 64.
///
/// # Safety
/// desc must be readable, arena_bytes and scratch_bytes writable or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_measure(
    desc: *const hug_build_desc,
    arena_bytes: *mut usize,
    scratch_bytes: *mut usize,
) -> hug_status {
    guard(|| {
        if arena_bytes.is_null() || scratch_bytes.is_null() {
            return Err(Error::Null);
        }
        // SAFETY: readable by contract.
        let parsed = unsafe { Parsed::read(desc) }?;
        let (arena, scratch) = (parsed.sizes()?.arena, parsed.scratch_bytes()?);
        // SAFETY: not NULL, writable by contract.
        unsafe {
            arena_bytes.write(arena);
            scratch_bytes.write(scratch);
        }
        Ok(())
    })
}

/// Builds a scene in memory of the caller's, calling no allocator. The bytes
/// are those that hug_build makes. scratch may be reused or freed afterwards;
/// arena holds the scene, must stay in place and unchanged while it is used,
/// and may be moved, copied or saved and passed to hug_open. scratch must be
/// aligned to 16, arena to 64.
///
/// # Safety
/// desc and what it points to must be readable, scratch and arena writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_build_into(
    desc: *const hug_build_desc,
    scratch: *mut c_void,
    scratch_bytes: usize,
    arena: *mut c_void,
    arena_bytes: usize,
    out: *mut *const hug_scene,
) -> hug_status {
    if out.is_null() {
        return HUG_ERROR_NULL;
    }
    // SAFETY: not NULL, writable by contract.
    unsafe { out.write(core::ptr::null()) };
    guard(|| {
        if scratch.is_null() || arena.is_null() {
            return Err(Error::Null);
        }
        if !(scratch as usize).is_multiple_of(16) || !(arena as usize).is_multiple_of(64) {
            return Err(Error::Alignment);
        }
        if isize::try_from(scratch_bytes).is_err() || isize::try_from(arena_bytes).is_err() {
            return Err(Error::Overflow);
        }
        if overlap(scratch as usize, scratch_bytes, arena as usize, arena_bytes)? {
            return Err(Error::Overlap);
        }
        // SAFETY: readable by contract.
        let parsed = unsafe { Parsed::read(desc) }?;
        parsed.apart_from(scratch as usize, scratch_bytes)?;
        parsed.apart_from(arena as usize, arena_bytes)?;
        // SAFETY: writable by contract, and apart from each other and from the input.
        let (scratch, arena) = unsafe {
            (
                core::slice::from_raw_parts_mut(scratch.cast::<u8>(), scratch_bytes),
                core::slice::from_raw_parts_mut(arena.cast::<u8>(), arena_bytes),
            )
        };
        let (soup, scratch) = parsed.soup(scratch)?;
        Callbacks::new(&parsed.desc).run(|control| {
            build::build_into_with(soup, &parsed.options, scratch, arena, control).map(|_| ())
        })?;
        // SAFETY: out was checked above.
        unsafe { out.write(arena.as_ptr().cast()) };
        Ok(())
    })
}

/// Uses an arena that was saved, copied or mapped as a scene, in place.
///
/// bytes must be aligned to 64 and stay in place and unchanged while the scene
/// is used. Unless flags has HUG_OPEN_TRUSTED the bytes are checked once, in
/// time linear in len; after HUG_OK no query reads outside of them. len may be
/// larger than the arena.
///
/// # Safety
/// len bytes must be readable, out writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_open(
    bytes: *const c_void,
    len: usize,
    flags: u32,
    out: *mut *const hug_scene,
) -> hug_status {
    if out.is_null() {
        return HUG_ERROR_NULL;
    }
    // SAFETY: not NULL, writable by contract.
    unsafe { out.write(core::ptr::null()) };
    if bytes.is_null() {
        return HUG_ERROR_NULL;
    }
    if flags & !HUG_OPEN_TRUSTED != 0 {
        return HUG_ERROR_INVALID_VALUE;
    }
    if !(bytes as usize).is_multiple_of(arena::ALIGN) {
        return HUG_ERROR_ALIGNMENT;
    }
    if (bytes as usize).checked_add(len).is_none() || isize::try_from(len).is_err() {
        return super::types::HUG_ERROR_OVERFLOW;
    }
    if overlap(bytes as usize, len, out as usize, size_of_val(&out)).unwrap_or(true) {
        return HUG_ERROR_OVERLAP;
    }
    guard(|| {
        // SAFETY: readable by contract.
        let slice = unsafe { core::slice::from_raw_parts(bytes.cast::<u8>(), len) };
        if flags & HUG_OPEN_TRUSTED == 0 {
            View::open(slice)?;
        } else {
            arena::check_header(slice)?;
        }
        // SAFETY: out was checked above.
        unsafe { out.write(bytes.cast()) };
        Ok(())
    })
}

/// The scene's arena, for saving: hug_data(scene, &len) returns its first byte
/// and sets len to its size. Writing these bytes to a file and passing them to
/// hug_open later, also in another process, gives the same scene. NULL for
/// NULL; len may be NULL.
///
/// # Safety
/// scene must be valid or NULL, len writable or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_data(scene: *const hug_scene, len: *mut usize) -> *const c_void {
    let size = if scene.is_null() {
        0
    } else {
        // SAFETY: a valid scene by contract.
        unsafe { View::from_ptr(scene.cast()) }.bytes().len()
    };
    if !len.is_null() {
        // SAFETY: not NULL, writable by contract.
        unsafe { len.write(size) };
    }
    scene.cast()
}

const _: () = assert!(HUG_OK == 0);
