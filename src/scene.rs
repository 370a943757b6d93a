//! The easy door: a scene that owns its arena.

use alloc::vec::Vec;

use crate::arena::View;
use crate::arena::block::Block;
use crate::build::{Control, measure, plan_with};
use crate::{Error, Geometry, Options};

/// A built scene. Queries are on its [`View`]; any number of threads can share it.
#[derive(Clone)]
pub struct Scene {
    arena: Block,
}

impl Scene {
    /// Builds a scene from triangles. Those with a coordinate that is not
    /// finite, or without area, are dropped and counted ([`crate::Stats`]).
    /// Cost: near linear in triangles and references.
    ///
    /// # Errors
    /// As [`crate::build::plan`]; [`Error::OutOfMemory`].
    pub fn build(soup: &[Geometry<'_>], options: &Options) -> Result<Self, Error> {
        Self::build_with(soup, options, &mut Control::default())
    }

    /// [`Scene::build`] with the caller's threads, and telling how far it is.
    ///
    /// # Errors
    /// As [`Scene::build`]; [`Error::Cancelled`], [`Error::Unfinished`].
    pub fn build_with(
        soup: &[Geometry<'_>],
        options: &Options,
        control: &mut Control<'_>,
    ) -> Result<Self, Error> {
        let sizes = measure(soup, options)?;
        // Not aligned, so that an allocator can hand out zeroed pages as they are:
        // most of what the bound asks for is never touched.
        let mut scratch: Vec<u8> =
            bytemuck::allocation::try_zeroed_vec(sizes.scratch).map_err(|()| Error::OutOfMemory)?;
        let plan = plan_with(soup, options, &mut scratch, control)?;
        let mut arena = Block::zeroed(plan.arena_bytes()).ok_or(Error::OutOfMemory)?;
        plan.write_with(arena.bytes_mut(), control)?;
        Ok(Self { arena })
    }

    /// The scene, ready for queries.
    #[must_use]
    pub fn view(&self) -> View<'_> {
        self.arena.view()
    }
}
