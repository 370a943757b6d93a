//! A build by name: geometries and settings one after the other.

use alloc::vec::Vec;
use core::ops::ControlFlow;

use crate::build::{Control, Threads};
use crate::{Error, Geometry, Options, Quality, Scene, Structure};

/// What to build; from [`Scene::builder`].
///
/// ```
/// use hug::{Geometry, Quality, Scene};
/// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let (walls, glass) = ([[0, 1, 2]], [[2, 1, 0]]);
/// let scene = Scene::builder()
///     .mesh(&vertices, &walls)
///     .geometry(Geometry::from_mesh(&vertices, &glass).with_mask(2))
///     .quality(Quality::High)
///     .build()?;
/// assert_eq!(hug::Stats::of(&scene.view()).triangles, 2);
/// # Ok::<(), hug::Error>(())
/// ```
#[derive(Default)]
#[must_use]
pub struct Builder<'a> {
    soup: Vec<Geometry<'a>>,
    options: Options,
    control: Control<'a>,
}

impl<'a> Builder<'a> {
    /// Adds a geometry, whose id is the number of those before it.
    pub fn geometry(mut self, geometry: Geometry<'a>) -> Self {
        self.soup.push(geometry);
        self
    }

    /// Adds packed vertices and triangles.
    pub fn mesh(self, vertices: &'a [[f32; 3]], indices: &'a [[u32; 3]]) -> Self {
        self.geometry(Geometry::from_mesh(vertices, indices))
    }

    /// Sets all options at once.
    pub fn options(mut self, options: Options) -> Self {
        self.options = options;
        self
    }

    /// Sets the structure.
    pub fn structure(mut self, structure: Structure) -> Self {
        self.options.structure = structure;
        self
    }

    /// Sets how fine a structure AUTO builds.
    pub fn quality(mut self, quality: Quality) -> Self {
        self.options.quality = quality;
        self
    }

    /// Lends threads; see [`Control::with_threads`].
    pub fn threads(mut self, threads: &'a dyn Threads) -> Self {
        self.control = self.control.with_threads(threads);
        self
    }

    /// Watches the build, and may break it off; see [`Control::with_progress`].
    ///
    /// ```
    /// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let mut stop = |_| core::ops::ControlFlow::Break(());
    /// let built = hug::Scene::builder().mesh(&vertices, &[[0, 1, 2]]).progress(&mut stop).build();
    /// assert_eq!(built.err(), Some(hug::Error::Cancelled));
    /// ```
    pub fn progress(mut self, progress: &'a mut dyn FnMut(f64) -> ControlFlow<()>) -> Self {
        self.control = self.control.with_progress(progress);
        self
    }

    /// Builds the scene. The vertices may go then.
    ///
    /// # Errors
    /// As [`Scene::build_with`].
    pub fn build(mut self) -> Result<Scene, Error> {
        Scene::build_with(&self.soup, &self.options, &mut self.control)
    }
}
