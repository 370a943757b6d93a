//! A ray seen from a grid: where it enters, how it steps.
//!
//! Error bound of the walk. For axis x, with e = 2^-53, a plane's parameter is
//! `(p * cell - o) * inv`, where `o = org - lo`; its error, as a distance along
//! x, is at most `e (3 |o| + 4 extent + 2 |lo|)`, and the entry voxel's
//! coordinate has no more. The build keeps `cell >= 2^-35 |lo|` and
//! `extent <= 2^11 cell`; [`Local::enter`] takes this path only if `|o| <= 2^36
//! cell` on every axis. So a point of the ray at parameter t lies within
//! `2^-14` of a cell of the voxel that the walk is in at t. Footprints are padded by
//! `2^-10` and boxes by `2^-12` of a cell (`build::frame`), which covers this
//! and what the build rounds. The parameters themselves partition the line
//! exactly, whatever their error: a hit at t is found in the voxel whose interval
//! contains t, so the walk's end needs no padding at all.

use glam::DVec3;

use super::rebase::rebase;
use crate::arena::layout::Grid;

/// Farthest origin, in cells, that `f64` walks from directly.
pub(super) const REACH: f64 = (1u64 << 36) as f64;

/// A ray in a grid's own frame: position `o + s d` for `s` in `[s0, s1]`.
pub(super) struct Local {
    /// Origin relative to the grid's lowest corner.
    pub o: DVec3,
    pub s0: f64,
    pub s1: f64,
    /// The ray's `t` is `s + base`, give or take `slack`.
    pub base: f64,
    pub slack: f64,
}

impl Local {
    /// The part of the ray in `[t0, t1]` that can lie in the grid's box.
    #[inline(always)]
    pub fn enter(
        grid: &Grid,
        org: DVec3,
        dir: DVec3,
        inv: DVec3,
        t0: f64,
        t1: f64,
    ) -> Option<Self> {
        let o = org - DVec3::from_array(grid.lo);
        if o.abs().cmpgt(DVec3::from_array(grid.cell) * REACH).any() {
            return rebase(grid, org, dir, inv, t0, t1);
        }
        let (s0, s1) = slab(grid, o, dir, inv);
        let (s0, s1) = (s0.max(t0), s1.min(t1));
        (s0 <= s1).then_some(Self {
            o,
            s0,
            s1,
            base: 0.0,
            slack: 0.0,
        })
    }

    /// A lower bound of the `t` that `s` stands for.
    #[inline(always)]
    pub fn t_low(&self, s: f64) -> f64 {
        s + self.base - self.slack
    }

    /// An upper bound of it.
    #[inline(always)]
    pub fn t_high(&self, s: f64) -> f64 {
        s + self.base + self.slack
    }
}

/// Where the line is inside the box; an empty interval if nowhere.
#[inline(always)]
pub(super) fn slab(grid: &Grid, o: DVec3, dir: DVec3, inv: DVec3) -> (f64, f64) {
    let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
    for k in 0..3 {
        if dir[k] == 0.0 {
            if o[k] < 0.0 || o[k] > grid.extent[k] {
                return (f64::INFINITY, f64::NEG_INFINITY);
            }
        } else {
            let (a, b) = (-o[k] * inv[k], (grid.extent[k] - o[k]) * inv[k]);
            near = near.max(a.min(b));
            far = far.min(a.max(b));
        }
    }
    (near, far)
}
