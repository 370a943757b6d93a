//! A ray seen from a grid: where it enters, how it steps.
//!
//! The ray is placed in `f64` and walked in `f32`, in units of voxels and, along
//! axes on which it descends, mirrored, so that it ascends on all. Its parameter
//! s starts at 0 where the walk of the grid starts.
//!
//! Error bound. Let n be the grid's largest count, at most 2^11, and e = 2^-24.
//! In `f64`, `org - lo` and what is computed from it is off by less than
//! 2^-14 voxels: the build keeps `cell >= 2^-35 |lo|`, and origins more than 2^36
//! voxels away are moved first (`rebase`). In `f32`, a plane is off by the rounding
//! of the place (n e / 2), of its product with the pace (n e), of the pace (three
//! times n e) and of the sum (n e); the voxel at s by that of the place twice and of
//! the speed (twice n e). At s the ray is thus within `5.5 n e + 2^-14`, less than
//! `2^-10`, of the voxel that the walk is in. Footprints, and grids that cover a voxel,
//! are padded by `2^-10` (`build::overlap`, `build::frame`).
//!
//! The computed parameters, whatever their error, partition the line without gaps:
//! a hit at t is found in the voxel whose interval contains t, so the walk's end
//! needs no padding at all.

use super::counters::Count;
use super::course::{Course, Mirror};
use super::rebase::{Goal, Part, rebase};
use super::turned::{Turned, turned};
use crate::arena::Sections;
use crate::arena::layout::{BOX_CELLS, BOX_MARGIN, COVERS, EXIT_MAX, Grid, TURNED};
use crate::ray::Ray;
use crate::simd::Lanes;
use glam::DVec3;

/// Farthest origin, in voxels, that `f64` walks from directly.
pub(super) const REACH: f64 = (1u64 << 36) as f64;

/// Where a ray is moved to that begins farther away.
fn goal(grid: &Grid) -> Goal {
    let cell = DVec3::from_array(grid.cell.map(f64::from));
    let extent = cell * DVec3::from_array(grid.n.map(f64::from));
    Goal { lo: grid.lo.into(), extent, reach: cell * REACH }
}

/// Three lanes, and 0 in the fourth.
#[inline(always)]
pub(super) fn load<L: Lanes>(l: L, [x, y, z]: [f64; 3]) -> L::F64 {
    l.load_f64(&[x, y, z, 0.0])
}

/// A ray in a grid's own frame.
#[derive(Clone, Copy)]
pub(super) struct Local<L: Lanes> {
    /// Where the ray is at s = 0.
    pub start: L::F32,
    /// Voxels per s, and its reciprocal.
    pub speed: L::F32,
    pub pace: L::F32,
    /// Plane p is at s = p pace + zero.
    pub zero: L::F32,
    /// The first voxel of the walk.
    pub at: L::I32,
    /// The last voxel along each axis.
    pub last: L::I32,
    /// All ones on mirrored axes, and the counts there; 0 on others.
    down: L::I32,
    back: L::I32,
    pub mirror: &'static Mirror,
    /// Number of the first voxel, and voxels in a row and in a plane.
    pub first: u32,
    pub nx: u32,
    pub plane: u32,
    pub span: Span,
}

/// How far a ray goes in a grid, in s and in tau.
#[derive(Clone, Copy)]
pub(super) struct Span {
    /// Parameter tau at s = 0, give or take `slack`.
    base: f64,
    slack: f64,
    /// The ray has left the grid, or the part of it that is wanted, at s.
    end: f32,
}

/// Where the boxes of a list's references are along the ray.
#[derive(Clone, Copy)]
pub(super) struct Boxes {
    /// On each axis a box begins at s = bound near[0] + near[1], with the bits of the
    /// bound as they are in its word, and ends likewise.
    pub near: [[f32; 4]; 2],
    pub far: [[f32; 4]; 2],
    pub mirror: &'static Mirror,
    /// The part of the ray in question.
    pub range: [f32; 2],
}

/// A step: where the ray leaves an exit box, and the voxel there.
pub(super) struct Step<L: Lanes> {
    pub out: f32,
    pub to: L::I32,
}

impl<L: Lanes> Local<L> {
    /// The part of the ray in `[t0, t1]`, of tau, that can lie in a grid's box.
    #[inline(always)]
    pub fn enter(
        l: L,
        sections: &Sections<'_>,
        number: u32,
        course: &Course<L>,
        ray: &Ray,
        range: [f64; 2],
    ) -> Option<Self> {
        let grid = sections.grid(number);
        if grid.flags & TURNED != 0 {
            turned(l, &Turned { grid, frame: sections.frame(number), course, ray, range })
        } else {
            Self::enter_aligned(l, grid, course, ray, range)
        }
    }

    /// [`Local::enter`] for a grid that is not turned.
    #[inline(always)]
    pub fn enter_aligned(
        l: L,
        grid: &Grid,
        course: &Course<L>,
        ray: &Ray,
        [t0, t1]: [f64; 2],
    ) -> Option<Self> {
        let records = grid.lanes();
        let wide = l.widen(l.load_f32(records.inv_cell));
        let mut place = l.mul_f64(l.sub_f64(course.org, l.load_f64(records.lo)), wide);
        let mut part = Part::new(t0, t1);
        if l.any_beyond(place, REACH) {
            let moved = rebase(&goal(grid), &course.exact(ray), t0, t1)?;
            (place, part) = (l.mul_f64(load(l, moved.o), wide), moved.part);
        }
        Self::at(l, grid, course, place, part)
    }

    /// The part of the ray in the box of a grid, from a point `place` of it: in voxels, from
    /// the lowest corner.
    #[inline(always)]
    pub fn at(l: L, grid: &Grid, course: &Course<L>, place: L::F64, part: Part) -> Option<Self> {
        let records = grid.lanes();
        let inv_cell = l.load_f32(records.inv_cell);
        let counts = l.load_u16(records.n);
        let n = l.i32_to_f64(counts);
        let speed = l.mul_f64(course.dir, l.widen(inv_cell));
        let Part { mut low, mut high, base, slack } = part;
        let mut there = l.add_f64(place, l.mul_f64(l.splat_f64(low), speed));
        // What was moved begins up to `slack` off the voxel that the grid covers: many voxels.
        if (grid.flags & COVERS == 0 || slack > 0.0) && l.any_outside(there, n) {
            let pace = l.div_f64(l.splat_f64(1.0), speed);
            let a = l.mul_f64(l.sub_f64(l.splat_f64(0.0), place), pace);
            let b = l.mul_f64(l.sub_f64(n, place), pace);
            let near = l.highest3(l.min_f64(a, b));
            let far = l.lowest3(l.max_f64(a, b));
            low = if near > low { near } else { low };
            high = if far < high { far } else { high };
            if low > high {
                return None;
            }
            there = l.add_f64(place, l.mul_f64(l.splat_f64(low), speed));
        }
        let start = l.narrow(l.mirror_f64(there, n, course.dir));
        let steps = l.mul_f32(course.speed, inv_cell);
        // Infinite in the idle lane, whose planes are then never reached.
        let pace = l.div_f32(l.splat_f32(1.0), steps);
        let last = l.sub(counts, l.splat_i32(1));
        Some(Self {
            start,
            speed: steps,
            pace,
            zero: l.minus_f32(l.mul_f32(start, pace)),
            at: l.max(l.min(l.truncate(start), last), l.splat_i32(0)),
            last,
            down: course.down,
            back: l.and(counts, course.down),
            mirror: course.mirror,
            first: grid.first,
            nx: u32::from(grid.n[0]),
            plane: u32::from(grid.n[0]) * u32::from(grid.n[1]),
            span: Span { base: low + base, slack, end: above(high - low) },
        })
    }

    /// The number of voxel `at`, which must lie in the grid.
    #[inline(always)]
    pub fn number(&self, l: L, at: L::I32) -> u32 {
        // Where the axis is mirrored !at + n is n - 1 - at.
        let [x, y, z, _] = l.array(l.add(l.xor(at, self.down), self.back)).map(|x| x as u32);
        let rows = z.wrapping_mul(self.plane).wrapping_add(y.wrapping_mul(self.nx));
        rows.wrapping_add(x).wrapping_add(self.first)
    }

    /// Where the boxes of the references of voxel `at` are; `range` is the part of the
    /// ray, in s, that is in its exit box `exit`.
    #[inline(always)]
    pub fn boxes(&self, l: L, at: L::I32, exit: u32, range: [f32; 2]) -> Boxes {
        let (near, far) =
            (reach(l, exit, &self.mirror.near.shift), reach(l, exit, &self.mirror.far.shift));
        let margin = l.splat_f32(BOX_MARGIN);
        let low = l.sub_f32(l.to_f32(l.sub(at, near)), margin);
        let side = l.to_f32(l.add(l.add(near, far), l.splat_i32(1)));
        let side = l.add_f32(side, l.add_f32(margin, margin));
        let cell = l.mul_f32(side, l.splat_f32(1.0 / BOX_CELLS as f32));
        let width = l.mul_f32(cell, self.pace);
        let start = l.mul_add::<false>(low, self.pace, self.zero);
        // Cells are counted from the lower end, mirrored or not.
        let last = l.mul_f32(width, l.splat_f32((BOX_CELLS - 1) as f32));
        let start = l.add_f32(start, l.mask_f32(last, self.down));
        let near = l.mul_f32(width, l.load_f32(&self.mirror.near.unit));
        let far = l.mul_f32(width, l.load_f32(&self.mirror.far.unit));
        Boxes {
            near: [l.array_f32(near), l.array_f32(start)],
            far: [l.array_f32(far), l.array_f32(l.add_f32(start, width))],
            mirror: self.mirror,
            range,
        }
    }

    /// Leaves the exit box `exit` of voxel `at`. Where steps are counted it
    /// is rounded once, so that their number depends on no instruction set.
    #[inline(always)]
    pub fn step<C: Count>(&self, l: L, at: L::I32, exit: u32) -> Step<L> {
        // The planes behind the box, and where the ray is at the first of them.
        let behind = l.add(l.add(at, l.splat_i32(1)), reach(l, exit, &self.mirror.far.shift));
        let leave = mul_add::<C, L>(l, l.to_f32(behind), self.pace, self.zero);
        let lowest = l.lowest(leave);
        // Off the axis of the exit the position says where, inside the box.
        let exits = l.equal(leave, lowest);
        let low = l.select(exits, at, behind);
        let high = l.sub(l.sub(behind, l.splat_i32(1)), exits);
        let position = l.truncate(mul_add::<C, L>(l, lowest, self.speed, self.start));
        Step { out: l.first(lowest), to: l.min(l.max(position, low), high) }
    }
}

impl Span {
    /// In no grid yet.
    pub const NONE: Self = Self { base: 0.0, slack: 0.0, end: 0.0 };

    /// Where the walk stops if no t above `limit`, rounded, is wanted; tau is `per_t` times t.
    #[inline(always)]
    pub fn stop(&self, limit: f32, per_t: f64) -> f32 {
        // That of `beyond(limit)`, in an order in which little has to wait for the limit. It
        // is no NaN, so neither is this.
        let t = f64::from(limit);
        let start = self.slack - self.base + per_t * f64::from(f32::MIN_POSITIVE);
        let room = t.abs() * (per_t * f64::from(f32::EPSILON)) + start;
        let limit = above(t * per_t + room);
        if limit < self.end { limit } else { self.end }
    }

    /// A lower bound of the tau that `s` stands for.
    #[inline(always)]
    pub fn low(&self, s: f32) -> f64 {
        f64::from(s) + self.base - self.slack
    }

    /// An upper bound of it.
    #[inline(always)]
    pub fn high(&self, s: f32) -> f64 {
        f64::from(s) + self.base + self.slack
    }
}

#[inline(always)]
fn mul_add<C: Count, L: Lanes>(l: L, a: L::F32, b: L::F32, c: L::F32) -> L::F32 {
    if C::COUNTS { l.mul_add::<true>(a, b, c) } else { l.mul_add::<false>(a, b, c) }
}

/// How far an exit box reaches beyond its voxel, on the sides that `shifts` are of.
#[inline(always)]
fn reach<L: Lanes>(l: L, exit: u32, shifts: &[u32; 4]) -> L::I32 {
    let word = l.splat_i32(exit as i32);
    l.and(l.shift_right(word, l.load_u32(shifts)), l.splat_i32(EXIT_MAX as i32))
}

/// An `f32` greater than `x`, but for infinity.
#[inline(always)]
pub(super) fn above(x: f64) -> f32 {
    (x.abs() * f64::from(f32::EPSILON) + (x + f64::from(f32::MIN_POSITIVE))) as f32
}
