//! Rays in grids that are turned (section 7.2; `build::turn`).
//!
//! The ray is placed relative to the frame's origin and turned, in `f64`; from there on
//! the grid is one like any other, and its triangles are met where they are, by the
//! ray as it is. With `|org - origin|` at most 2^36 voxels, a rotation is off by 2^-50 of
//! that, 2^-14 of a voxel, and so is the direction's over that distance: with grids of
//! at most 512 voxels along an axis, whose planes are off by less than 2^-12 of a voxel,
//! the walk's bound holds. Farther origins are first moved to a cube around the frame's.

use super::course::Course;
use super::local::{Local, REACH, load};
use super::rebase::{Goal, Part, rebase};
use crate::arena::layout::{Frame, Grid};
use crate::ray::Ray;
use crate::simd::{Kernel, Lanes};
use glam::DVec3;

/// A ray that comes to a turned grid.
pub(super) struct Turned<'a, L: Lanes> {
    pub grid: &'a Grid,
    pub frame: &'a Frame,
    pub course: &'a Course<L>,
    pub ray: &'a Ray,
    /// The part of it in question, of tau.
    pub range: [f64; 2],
}

/// [`Local::enter`] for a turned grid.
#[cold]
#[inline(never)]
pub(super) fn turned<L: Lanes>(l: L, turned: &Turned<'_, L>) -> Option<Local<L>> {
    l.run(turned)
}

impl<L: Lanes> Kernel<L> for &Turned<'_, L> {
    type Out = Option<Local<L>>;
    #[inline(always)]
    fn run(self, l: L) -> Option<Local<L>> {
        let Turned { grid, frame, course, ray, range: [t0, t1] } = *self;
        let exact = course.exact(ray);
        let mut from = frame.relative(exact[0]);
        let mut part = Part::new(t0, t1);
        let cell = DVec3::from_array(grid.cell.map(f64::from));
        let reach = cell.min_element() * REACH;
        if l.any_beyond(load(l, from), reach) {
            let goal = around(grid, frame, cell, reach);
            let moved = rebase(&goal, &exact, t0, t1)?;
            let corner = frame.relative(goal.lo.to_array());
            from = [0, 1, 2].map(|k| moved.o[k] + corner[k]);
            part = moved.part;
        }
        let [x, y, z] = frame.turn(from);
        let place = [x - grid.lo[0], y - grid.lo[1], z - grid.lo[2]];
        let wide = l.widen(l.load_f32(grid.lanes().inv_cell));
        let course = course.turned(l, frame.turn(exact[1]));
        Local::at(l, grid, &course, l.mul_f64(load(l, place), wide), part)
    }
}

/// A cube around the frame's origin that holds the grid, whichever way it is turned.
fn around(grid: &Grid, frame: &Frame, cell: DVec3, reach: f64) -> Goal {
    let corner = DVec3::from_array(grid.lo).abs();
    let half = (corner + cell * DVec3::from_array(grid.n.map(f64::from))).element_sum();
    let [x, y, z, _] = frame.origin;
    let lo = DVec3::new(x, y, z) - half;
    Goal { lo, extent: DVec3::splat(2.0 * half), reach: DVec3::splat(reach) }
}
