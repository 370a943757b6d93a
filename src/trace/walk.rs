//! The walk: front to back through a grid's voxels, and through the grids that
//! they point to.
//!
//! A three-dimensional DDA. A grid below is walked only over the part of the
//! ray inside the voxel that points to it, so a grid in many voxels costs its
//! own steps and one entry per voxel, the order stays front to back, and no
//! list of visited grids is needed (design: a grid referenced by several
//! voxels must not be walked again and again). Recursion is as deep as the
//! levels, at most 16.

use glam::DVec3;

use super::counters::Count;
use super::local::Local;
use super::query::{Query, visible};
use crate::arena::layout::{GRID_BIT, Grid};
use crate::arena::{Sections, View};
use crate::ray::Ray;
use crate::triangle::Line;

/// A query on its way.
pub(crate) struct Walk<'a, Q, C> {
    sections: Sections<'a>,
    ray: &'a Ray,
    line: &'a Line,
    org: DVec3,
    dir: DVec3,
    inv: DVec3,
    query: &'a mut Q,
    counters: &'a mut C,
}

impl<'a, Q: Query, C: Count> Walk<'a, Q, C> {
    pub fn new(
        view: &View<'a>,
        ray: &'a Ray,
        line: &'a Line,
        query: &'a mut Q,
        counters: &'a mut C,
    ) -> Self {
        let dir = DVec3::from_array(ray.dir.map(f64::from));
        Self {
            sections: view.sections(),
            ray,
            line,
            org: DVec3::from_array(ray.org.map(f64::from)),
            dir,
            inv: dir.recip(),
            query,
            counters,
        }
    }

    /// Walks the scene from its outermost grid.
    pub fn run(mut self) {
        // A t that rounds to tmin may lie below it, one that rounds to tmax above.
        let (t0, t1) = (self.ray.tmin.next_down(), self.ray.tmax.next_up());
        let world = self.sections.grid(0);
        self.grid(world, f64::from(t0), f64::from(t1));
    }

    /// Walks `grid` where the ray's parameter is in `[t0, t1]`; `true` if the
    /// query wants no more.
    fn grid(&mut self, grid: &Grid, t0: f64, t1: f64) -> bool {
        self.counters.grid();
        let Some(local) = Local::enter(grid, self.org, self.dir, self.inv, t0, t1) else {
            return false;
        };
        let mut at = [0i32; 3];
        let mut exit = [f64::INFINITY; 3];
        let mut step = [0i32; 3];
        for k in 0..3 {
            let x = (local.o[k] + self.dir[k] * local.s0) * grid.inv_cell[k];
            at[k] = (x as i32).clamp(0, grid.n[k] as i32 - 1);
            if self.dir[k] != 0.0 {
                step[k] = if self.dir[k] > 0.0 { 1 } else { -1 };
                exit[k] = self.plane(grid, &local, k, at[k]);
            }
        }
        let mut s = local.s0;
        loop {
            let axis = if exit[0] <= exit[1] && exit[0] <= exit[2] {
                0
            } else if exit[1] <= exit[2] {
                1
            } else {
                2
            };
            let end = exit[axis].min(local.s1);
            // Beyond the limit, compared as the hits' t are: after rounding.
            if local.t_low(s) as f32 > self.query.limit() {
                return false;
            }
            if self.voxel(grid, &local, at, s, end) {
                return true;
            }
            at[axis] += step[axis];
            let inside = (0..grid.n[axis] as i32).contains(&at[axis]);
            if exit[axis] >= local.s1 || !inside {
                return false;
            }
            s = s.max(end);
            exit[axis] = self.plane(grid, &local, axis, at[axis]);
        }
    }

    /// The parameter at which the ray leaves voxels of coordinate `at`.
    #[inline(always)]
    fn plane(&self, grid: &Grid, local: &Local, axis: usize, at: i32) -> f64 {
        let plane = at + i32::from(self.dir[axis] > 0.0);
        (f64::from(plane) * grid.cell[axis] - local.o[axis]) * self.inv[axis]
    }

    /// Meets what the voxel refers to; the ray is in it for `[s, end]`.
    #[inline(always)]
    fn voxel(&mut self, grid: &Grid, local: &Local, at: [i32; 3], s: f64, end: f64) -> bool {
        self.counters.voxel();
        let [x, y, z] = at.map(|i| i as usize);
        let (nx, ny) = (grid.n[0] as usize, grid.n[1] as usize);
        let number = grid.first as usize + (z * ny + y) * nx + x;
        for &r in self.sections.refs(number) {
            if r & GRID_BIT != 0 {
                let below = self.sections.grid(r & !GRID_BIT);
                if self.grid(below, local.t_low(s), local.t_high(end)) {
                    return true;
                }
            } else if self.triangle(r) {
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn triangle(&mut self, number: u32) -> bool {
        self.counters.test();
        let triangle = self.sections.triangle(number);
        if !visible(self.ray, triangle) {
            return false;
        }
        match self.line.meet(&triangle.corners, self.query.limit()) {
            Some(t) => {
                self.counters.hit();
                self.query.meet(t, triangle, number)
            }
            None => false,
        }
    }
}
