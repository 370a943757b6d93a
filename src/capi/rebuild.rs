//! Building a scene anew in the memory that it has.

use core::mem::ManuallyDrop;

use super::build::hug_scene;
use super::callbacks::Callbacks;
use super::desc::Parsed;
use super::guard::guard;
use super::memory::Block;
use super::types::{hug_build_desc, hug_status};
use crate::build;
use crate::{Error, Options};

/// Builds a scene of hug_build anew, in place: for triangles that have moved. The
/// bytes are those that hug_build would make.
///
/// Nothing is allocated for a scene that was built with HUG_BUILD_KEEP_SCRATCH;
/// for others the scratch memory is, by the scene's allocator, and freed again.
/// alloc, free and user of desc are not used, and HUG_BUILD_KEEP_SCRATCH in it
/// changes nothing. HUG_ERROR_BUFFER_TOO_SMALL if what is there does not suffice: the
/// arena for the new structure, which has room for half as much again with
/// HUG_BUILD_KEEP_SCRATCH, or the kept scratch memory (more triangles, or options with
/// larger bounds in hug_measure).
///
/// After an error the scene is as it was before, with one exception: a build that
/// fails or is cancelled when it has begun to write, about half-way, leaves an
/// empty scene.
///
/// Threads: no query may be running on the scene, and none may begin before this
/// returns.
///
/// # Safety
/// scene must come from hug_build; desc and what it points to must be readable, and
/// lie outside of the scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_rebuild(
    scene: *mut hug_scene,
    desc: *const hug_build_desc,
) -> hug_status {
    guard(|| {
        if scene.is_null() {
            return Err(Error::Null);
        }
        // SAFETY: readable by contract.
        let parsed = unsafe { Parsed::read(desc) }?;
        // SAFETY: the scene came from hug_build and is ours until this returns, when
        // the prefix still says what it did: nothing is to be dropped.
        let (block, kept) = unsafe { Block::of_scene(scene) };
        let (mut block, mut kept) = (ManuallyDrop::new(block), ManuallyDrop::new(kept));
        let arena = block.bytes();
        parsed.apart_from(arena.as_ptr() as usize, arena.len())?;
        match &mut *kept {
            Some(scratch) => {
                let scratch = scratch.bytes();
                parsed.apart_from(scratch.as_ptr() as usize, scratch.len())?;
                rebuild(&parsed, scratch, arena)
            }
            None => {
                let allocator = block.allocator();
                let mut scratch = Block::scratch(&allocator, parsed.scratch_bytes()?)?;
                rebuild(&parsed, scratch.bytes(), block.bytes())
            }
        }
    })
}

fn rebuild(parsed: &Parsed<'_>, scratch: &mut [u8], arena: &mut [u8]) -> Result<(), Error> {
    let written = Callbacks::new(&parsed.desc).run(|control| {
        let (soup, scratch) = parsed.soup(scratch)?;
        let plan = build::plan_with(soup, &parsed.options, scratch, control)?;
        if plan.arena_bytes() > arena.len() {
            return Err(Error::BufferTooSmall);
        }
        Ok(plan.write_with(arena, control))
    })?;
    if written.is_err() {
        // What was there is gone. An empty scene takes less memory than any other.
        build::plan(&[], &Options::default(), scratch)?.write(arena)?;
    }
    written
}
