//! The walk: front to back through a grid's voxels, and through the grids that
//! they point to.
//!
//! A step leaves not the voxel but its exit box (`build::exit`), so that what
//! holds nothing new is crossed at once; where boxes are single voxels this is
//! the plain 3-D DDA. The next voxel is looked up by position, on the axis of
//! the exit by count, so each step strictly advances. A grid below is walked only
//! over the part of the ray inside the block that points to it: a grid in many
//! voxels costs its own steps and one entry per voxel, the order stays front to
//! back, and no list of visited grids is needed. Recursion is as deep as the
//! levels, at most 16.

use super::counters::Count;
use super::local::{Course, Local};
use super::query::{Query, visible};
use super::sieve::Sieve;
use crate::arena::layout::{EMPTY, EXIT_BITS, EXIT_MAX, GRID, GRID_BIT, LIST, PAYLOAD, TAG_SHIFT};
use crate::arena::{Sections, View};
use crate::ray::Ray;
use crate::simd::{Kernel, Lanes};
use crate::triangle::Line;

/// A query on its way.
pub(crate) struct Walk<'a, Q, C, L: Lanes> {
    lanes: L,
    sections: Sections<'a>,
    ray: &'a Ray,
    line: Line,
    sieve: Sieve<L>,
    course: Course<L>,
    /// All ones in the lanes of axes along which the ray descends.
    descends: L::I32,
    /// Where an exit box's word has the reach along the ray, and its mask.
    shift: L::I32,
    mask: L::I32,
    pub query: Q,
    counters: &'a mut C,
}

/// [`Walk::grid`], compiled for the walk's instruction set.
struct Enter<'w, 'a, Q, C, L: Lanes> {
    walk: &'w mut Walk<'a, Q, C, L>,
    number: u32,
    t0: f64,
    t1: f64,
}

impl<Q: Query, C: Count, L: Lanes> Kernel<L> for Enter<'_, '_, Q, C, L> {
    type Out = bool;
    #[inline(always)]
    fn run(self, _: L) -> bool {
        self.walk.grid(self.number, self.t0, self.t1)
    }
}

impl<'a, Q: Query, C: Count, L: Lanes> Walk<'a, Q, C, L> {
    #[inline(always)]
    pub fn new(lanes: L, view: &View<'a>, ray: &'a Ray, query: Q, counters: &'a mut C) -> Self {
        let down = ray.dir.map(|d| i32::from(d < 0.0));
        let bits = EXIT_BITS as i32;
        let shift = |k: usize| bits * (2 * k as i32 + 1 - down[k]);
        let most = EXIT_MAX as i32;
        Self {
            lanes,
            sections: view.sections(),
            ray,
            line: Line::new(ray),
            sieve: Sieve::new(lanes, ray, view.bounds()),
            course: Course::new(lanes, ray),
            descends: lanes.i32([-down[0], -down[1], -down[2], 0]),
            shift: lanes.i32([shift(0), shift(1), shift(2), 0]),
            mask: lanes.i32([most, most, most, 0]),
            query,
            counters,
        }
    }

    /// Walks the scene from its outermost grid.
    #[inline(always)]
    pub fn run(&mut self) {
        // A t that rounds to tmin may lie below it, one that rounds to tmax above.
        let (t0, t1) = (self.ray.tmin.next_down(), self.ray.tmax.next_up());
        self.grid(0, f64::from(t0), f64::from(t1));
    }

    /// The line that triangles are met with.
    pub fn line(&self) -> &Line {
        &self.line
    }

    /// Walks a grid where the ray's parameter is in `[t0, t1]`; `true` if the
    /// query wants no more.
    #[inline(always)]
    fn grid(&mut self, number: u32, t0: f64, t1: f64) -> bool {
        self.counters.grid();
        let l = self.lanes;
        let grid = self.sections.grid(number);
        let Some(local) = Local::enter(l, grid, &self.course, t0, t1) else {
            return false;
        };
        let (row, plane) = (grid.n[0] as usize, grid.n[0] as usize * grid.n[1] as usize);
        let n = l.i32([grid.n[0] as i32, grid.n[1] as i32, grid.n[2] as i32, 1]);
        let (zero, last) = (l.splat_i32(0), l.sub(n, l.splat_i32(1)));
        let first = grid.first as usize;

        let entry = l.truncate(l.mul_add(l.splat_f64(local.s0), local.speed, local.start));
        let mut at = l.min(l.max(entry, zero), last);
        let mut s = local.s0;
        loop {
            // Beyond the limit, where t rounds to more than the limit's f32.
            if local.t_low(s) > self.query.beyond() {
                return false;
            }
            let [x, y, z, _] = l.array(at);
            let voxel =
                self.sections.voxel(first + z as usize * plane + y as usize * row + x as usize);
            self.counters.voxel();
            let (tag, payload) = (voxel >> TAG_SHIFT, voxel & PAYLOAD);
            let (exit, refs) = match tag {
                EMPTY => (payload, &[][..]),
                LIST => self.sections.list(payload),
                _ => (0, &[][..]),
            };
            // The last voxel of the exit box, then the plane behind it.
            let reach = l.and(l.shift_right(l.splat_i32(exit as i32), self.shift), self.mask);
            let end = l.add(at, l.sub(l.xor(reach, self.descends), self.descends));
            let behind = l.add(l.add(end, l.splat_i32(1)), self.descends);
            let leave = l.mul_add(l.to_f64(behind), local.per_plane, local.at_zero);
            let lowest = l.lowest(leave);
            let out = l.first(lowest);
            let until = if out < local.s1 { out } else { local.s1 };
            if tag != EMPTY && self.meet(tag, payload, refs, local.t_low(s), local.t_high(until)) {
                return true;
            }
            if out >= local.s1 {
                return false;
            }
            s = if out > s { out } else { s };
            // Off the axis of the exit the position says where, inside the box.
            let position = l.truncate(l.mul_add(lowest, local.speed, local.start));
            let inside = l.min(l.max(position, l.min(at, end)), l.max(at, end));
            let next = l.add(l.add(end, l.splat_i32(1)), l.add(self.descends, self.descends));
            at = l.select_eq(leave, lowest, next, inside);
            if l.outside(at, n) {
                return false;
            }
        }
    }

    /// Meets what a voxel refers to; the ray is in its exit box for `[t0, t1]`.
    #[inline(always)]
    fn meet(&mut self, tag: u32, payload: u32, refs: &[u32], t0: f64, t1: f64) -> bool {
        if tag == GRID {
            return self.below(payload, t0, t1);
        }
        for &r in refs {
            if r & GRID_BIT != 0 {
                if self.below(r & !GRID_BIT, t0, t1) {
                    return true;
                }
            } else if self.triangle(r) {
                return true;
            }
        }
        false
    }

    fn below(&mut self, number: u32, t0: f64, t1: f64) -> bool {
        self.lanes.run(Enter { walk: self, number, t0, t1 })
    }

    #[inline(always)]
    fn triangle(&mut self, number: u32) -> bool {
        self.counters.test();
        let triangle = self.sections.triangle(number);
        if self.sieve.holds && self.sieve.out(triangle) || self.query.known(number) {
            return false;
        }
        self.decide(number)
    }

    /// The exact test of what the sieve let through.
    #[inline(never)]
    fn decide(&mut self, number: u32) -> bool {
        let triangle = self.sections.triangle(number);
        if !visible(self.ray, triangle) {
            return false;
        }
        match self.query.meet(&self.line, triangle, number) {
            Some(done) => {
                self.counters.hit();
                done
            }
            None => false,
        }
    }
}
