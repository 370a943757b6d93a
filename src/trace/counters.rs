//! What a walk counts, or does not.

use super::budget::Budget;
use super::profile::Profile;
use crate::ray::Ray;
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
pub(crate) trait Count {
    /// What a walk counts with.
    type Meter<'m>: Count
    where
        Self: 'm;
    fn meter(&mut self) -> Self::Meter<'_>;
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

/// Counts nothing.
#[derive(Clone, Copy)]
pub(crate) struct Uncounted;

impl Count for Uncounted {
    type Meter<'m> = Self;
    fn meter(&mut self) -> Self {
        Self
    }
    const COUNTS: bool = false;
    type Level = ();
    fn of(_: u8) {}
}

impl Count for Counters {
    type Meter<'m> = Meter<'m>;
    fn meter(&mut self) -> Meter<'_> {
        Meter::Counters(self)
    }
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

/// Any of those that count: walks that each were compiled for one of them would make the
/// library a tenth larger.
pub(crate) enum Meter<'m> {
    Counters(&'m mut Counters),
    Profile(&'m mut Profile),
    Budget(&'m mut Budget),
}

/// Calls the same function of whichever it is.
macro_rules! each {
    ($meter:expr, $one:ident => $call:expr) => {
        match $meter {
            Meter::Counters($one) => $call,
            Meter::Profile($one) => $call,
            Meter::Budget($one) => $call,
        }
    };
}

impl Count for Meter<'_> {
    const LOOKS: bool = true;
    type Meter<'n>
        = Meter<'n>
    where
        Self: 'n;
    fn meter(&mut self) -> Meter<'_> {
        match self {
            Self::Counters(counters) => Meter::Counters(counters),
            Self::Profile(profile) => Meter::Profile(profile),
            Self::Budget(budget) => Meter::Budget(budget),
        }
    }
    type Level = u8;
    fn of(level: u8) -> u8 {
        level
    }
    fn level(&mut self, level: u8) {
        if let Self::Profile(profile) = self {
            profile.level(level);
        }
    }
    fn grid(&mut self) {
        each!(self, one => one.grid());
    }
    fn voxel(&mut self) {
        each!(self, one => one.voxel());
    }
    fn tests(&mut self, n: usize) {
        each!(self, one => one.tests(n));
    }
    fn hit(&mut self) {
        each!(self, one => one.hit());
    }
    fn look(&mut self, ray: &Ray, triangle: &impl Corners) {
        each!(self, one => one.look(ray, triangle));
    }
    fn spent(&self) -> bool {
        each!(self, one => one.spent())
    }
}
