//! What was measured of one structure.

use hug::Calls;
use hug_bench::figures::Spread;
use hug_bench::notation::Notation;

/// What a ray of a set costs in a structure.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// Nanoseconds a ray.
    pub time: Spread,
    pub rays: u64,
    pub calls: Calls,
}

impl Cost {
    pub fn each(&self, calls: u64) -> f64 {
        calls as f64 / self.rays.max(1) as f64
    }

    /// Voxels and tests a ray: counted, so the same on every machine.
    pub fn work(&self) -> f64 {
        self.each(self.calls.voxels + self.calls.tests)
    }
}

/// One structure, measured.
pub struct Entry {
    /// As in the paper: `kit.u.f2.sqrt2`.
    pub name: String,
    pub curve: String,
    /// The value of the curve's parameter.
    pub value: String,
    pub notation: Notation,
    /// The whole arena.
    pub bytes: u64,
    /// Of these, the triangles' own, the same in every structure.
    pub triangle_bytes: u64,
    /// Sum of %vol.
    pub volume: f64,
    /// CPU seconds of a build.
    pub build: Spread,
    /// One of each of [`SETS`](super::SETS).
    pub costs: [Cost; 2],
}

impl Entry {
    /// Grids, voxels and references, in units of 2^20 bytes.
    pub fn megabytes(&self) -> f64 {
        (self.bytes - self.triangle_bytes) as f64 / f64::from(1 << 20)
    }
}
