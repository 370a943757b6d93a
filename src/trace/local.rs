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
use crate::ray::Ray;
use crate::simd::Lanes;

/// Farthest origin, in cells, that `f64` walks from directly.
pub(super) const REACH: f64 = (1u64 << 36) as f64;

/// A ray as every grid uses it, in lanes x, y, z and an idle one.
///
/// Where the ray does not move along an axis, and in the idle lane, `inv` is 0
/// and `far` infinite: `plane * inv + far` is then the parameter of a plane that is
/// never reached, with no NaN on the way.
#[derive(Clone, Copy)]
pub(super) struct Course<L: Lanes> {
    pub org: L::F64,
    pub dir: L::F64,
    pub inv: L::F64,
    /// 0 where the ray moves, else infinity.
    pub far: L::F64,
    /// Whether the ray is parallel to a coordinate plane.
    parallel: bool,
    /// The same for what is done one axis at a time.
    pub o: DVec3,
    pub d: DVec3,
}

impl<L: Lanes> Course<L> {
    #[inline(always)]
    pub fn new(l: L, ray: &Ray) -> Self {
        let (o, d) = (ray.org.map(f64::from), ray.dir.map(f64::from));
        let inv = d.map(|d| if d == 0.0 { 0.0 } else { 1.0 / d });
        let far = d.map(|d| if d == 0.0 { f64::INFINITY } else { 0.0 });
        Self {
            org: l.f64([o[0], o[1], o[2], 0.0]),
            dir: l.f64([d[0], d[1], d[2], 0.0]),
            inv: l.f64([inv[0], inv[1], inv[2], 0.0]),
            far: l.f64([far[0], far[1], far[2], f64::INFINITY]),
            parallel: d.contains(&0.0),
            o: DVec3::from_array(o),
            d: DVec3::from_array(d),
        }
    }
}

/// A ray in a grid's own frame, for the part of it in `[s0, s1]`.
pub(super) struct Local<L: Lanes> {
    /// Plane p of an axis is at parameter `p * per_plane + at_zero`.
    pub per_plane: L::F64,
    pub at_zero: L::F64,
    /// The ray, in voxels, is at `s * speed + start`.
    pub speed: L::F64,
    pub start: L::F64,
    pub s0: f64,
    pub s1: f64,
    /// The ray's `t` is `s + base`, give or take `slack`.
    pub base: f64,
    pub slack: f64,
}

impl<L: Lanes> Local<L> {
    /// The part of the ray in `[t0, t1]` that can lie in the grid's box.
    #[inline(always)]
    pub fn enter(l: L, grid: &Grid, course: &Course<L>, t0: f64, t1: f64) -> Option<Self> {
        let [lo, extent, cell, inv_cell] = grid.lanes().map(|a| l.f64(a));
        let mut o = l.sub_f64(course.org, lo);
        let (mut low, mut high, mut base, mut slack) = (t0, t1, 0.0, 0.0);
        if l.any_beyond(o, l.mul_f64(cell, l.splat_f64(REACH))) {
            let moved = rebase(grid, course.o, course.d, t0, t1)?;
            o = l.f64([moved.o[0], moved.o[1], moved.o[2], 0.0]);
            (low, high, base, slack) = (moved.s0, moved.s1, moved.base, moved.slack);
        }
        if course.parallel && beside(l, grid, course, o) {
            return None;
        }
        let minus_o = l.sub_f64(l.splat_f64(0.0), o);
        let a = l.mul_f64(minus_o, course.inv);
        let b = l.mul_f64(l.add_f64(extent, minus_o), course.inv);
        let near = l.first(l.highest(l.sub_f64(l.min_f64(a, b), course.far)));
        let far = l.first(l.lowest(l.add_f64(l.max_f64(a, b), course.far)));
        let s0 = if near > low { near } else { low };
        let s1 = if far < high { far } else { high };
        (s0 <= s1).then(|| Self {
            per_plane: l.mul_f64(cell, course.inv),
            at_zero: l.add_f64(a, course.far),
            speed: l.mul_f64(course.dir, inv_cell),
            start: l.mul_f64(o, inv_cell),
            s0,
            s1,
            base,
            slack,
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

/// Whether a ray that does not move along some axis passes the box there.
#[cold]
fn beside<L: Lanes>(l: L, grid: &Grid, course: &Course<L>, o: L::F64) -> bool {
    let o = l.array_f64(o);
    (0..3).any(|k| course.d[k] == 0.0 && (o[k] < 0.0 || o[k] > grid.extent[k]))
}
