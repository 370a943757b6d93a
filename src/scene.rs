//! The easy door: a scene that owns its arena.

use alloc::vec::Vec;

use crate::arena::View;
use crate::arena::block::Block;
use crate::build::{Control, measure, plan_with};
use crate::simd::ask_for_large;
use crate::{Builder, Error, Geometry, Options};

/// A built scene. Queries are on its [`View`]; any number of threads can share it.
#[derive(Clone)]
pub struct Scene {
    arena: Block,
}

impl Scene {
    /// A scene to be built of what is named one after the other.
    pub fn builder<'a>() -> Builder<'a> {
        Builder::default()
    }

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
    /// ```
    /// use hug::build::{Control, Task, Threads};
    /// struct Scoped;
    /// impl Threads for Scoped {
    ///     fn run(&self, tasks: &mut [Task<'_>]) {
    ///         std::thread::scope(|scope| {
    ///             for task in tasks {
    ///                 scope.spawn(|| task.run());
    ///             }
    ///         });
    ///     }
    /// }
    /// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let (mesh, options) = ([hug::Geometry::from_mesh(&vertices, &[[0, 1, 2]])], hug::Options::default());
    /// let mut control = Control::default().with_threads(&Scoped);
    /// let scene = hug::Scene::build_with(&mesh, &options, &mut control)?;
    /// assert_eq!(scene.view().bytes(), hug::Scene::build(&mesh, &options)?.view().bytes());
    /// # Ok::<(), hug::Error>(())
    /// ```
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
        ask_for_large(scratch.as_ptr(), scratch.len());
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
