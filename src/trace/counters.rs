//! What a walk counts, or does not.

use crate::ray::Ray;
use crate::simd::Isa;
use crate::triangle::Corners;

/// What queries did; a counted query adds to it. The same numbers on every
/// machine and instruction set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Grids whose box was tested (the paper's #bbi).
    pub grids: u64,
    /// Voxels traversed (#vt).
    pub voxels: u64,
    /// Ray-triangle tests (#pit), one per reference met.
    pub tests: u64,
    /// Tests that met the triangle within the ray's range (#pi).
    pub hits: u64,
}

/// Counts events, or compiles to nothing.
pub(crate) trait Count: Copy {
    /// Whether it counts.
    const COUNTS: bool = true;
    /// Whether it wants to look at every triangle that is tested.
    const LOOKS: bool = false;
    /// Whether it keeps the arguments of calls (`walk::replay`).
    const KEEPS: bool = false;
    /// A level, as what comes back to it keeps it: nothing, if levels are not told apart.
    type Level: Copy;
    fn of(level: u8) -> Self::Level;
    /// What follows happens on this level, until told otherwise.
    fn level(&mut self, _: Self::Level) {}
    fn grid(&mut self) {}
    fn voxel(&mut self) {}
    fn tests(&mut self, _: usize) {}
    fn hit(&mut self) {}
    fn look(&mut self, _: &Ray, _: &impl Corners) {}
    /// The ray comes to a grid, with this part of it.
    fn keep_grid(&mut self, _: u32, _: [f64; 2]) {}
    /// The ray, in this voxel and with this part of it, meets the list at a place.
    fn keep_list(&mut self, _: u32, _: [i32; 4], _: [f32; 2]) {}
    /// Whether the walk has to end here, unfinished.
    fn spent(&self) -> bool {
        false
    }
}

/// The best instruction set of x86-64 that walks are compiled for which count so: a kernel
/// for each would make the library a third larger, and what counts is not in a hurry.
pub(super) const fn best<C: Count>() -> Isa {
    if C::COUNTS { Isa::Portable } else { Isa::Avx512 }
}

/// Counts nothing.
#[derive(Clone, Copy)]
pub(crate) struct Uncounted;

impl Count for Uncounted {
    const COUNTS: bool = false;
    type Level = ();
    fn of(_: u8) {}
}

impl Count for Counters {
    type Level = ();
    fn of(_: u8) {}
    fn grid(&mut self) {
        self.grids += 1;
    }
    fn voxel(&mut self) {
        self.voxels += 1;
    }
    fn tests(&mut self, n: usize) {
        self.tests += n as u64;
    }
    fn hit(&mut self) {
        self.hits += 1;
    }
}
