//! Grids that are not aligned to the axes (section 7.2).
//!
//! A turned grid lies in coordinates of its own: a rotation of places relative to its
//! origin, which is near its middle. Its triangles are turned into these and rounded to
//! `f32` before their footprints are found. That moves a corner by less than 2^-24 of
//! its distance from the origin on each axis, so by less than 2^-14 of a voxel with at
//! most [`MOST`] voxels on either side of it; the walk's error bound (`trace::local`) is
//! 2^-12 of a voxel below the padding of footprints with so few voxels.
//!
//! Grids that refer to a turned one see the box, aligned, of its triangles.

use super::frame::Grid;
use crate::aabb::Aabb;
use crate::arena::layout::{Frame, TURNED, Triangle};
use bytemuck::{Pod, Zeroable};
use glam::DVec3;

/// Largest voxel count of a turned grid along an axis.
pub const MOST: u32 = 512;

/// How a grid is turned.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct Turn {
    /// Its axes, unit vectors.
    axes: [[f64; 3]; 3],
    origin: [f64; 3],
    /// Of the aligned box of what it holds: the lowest corner, and the sides.
    lo: [f64; 3],
    extent: [f64; 3],
}

impl Turn {
    /// Of a grid over objects of box `aligned` that is to have these axes.
    pub fn new(axes: &[DVec3; 3], origin: DVec3, aligned: &Grid) -> Self {
        let (lo, extent) = (aligned.lo, aligned.extent);
        Self { axes: axes.map(|a| a.to_array()), origin: origin.to_array(), lo, extent }
    }

    /// The grid, not yet cut, around what lies between these ends of its axes; `None` where
    /// `f32` or the walk's `f64` could not tell places in it well enough.
    pub fn grid(&self, [lo, hi]: [DVec3; 2], level: u32, scene: &Aabb) -> Option<Grid> {
        // Thin boxes get some room, or their voxels would be as thin as rounding errors.
        let longest = (hi - lo).max_element();
        let room = DVec3::splat(longest / f64::from(1 << 20));
        let [lo, hi] = [lo - room, hi + room].map(|p| p.as_vec3().to_array());
        let grid = Grid::around(&Aabb { lo, hi }, level, scene);
        let far = DVec3::from(self.origin).abs().max_element() + longest;
        let least = grid.least.max(far / f64::from(1u32 << 31) / 16.0);
        let told = grid.extent.iter().all(|&side| side >= least);
        let held = (1e-25..1e30).contains(&longest);
        (told && held).then_some(Grid { least, flags: u32::from(TURNED), ..grid })
    }

    /// A triangle in the grid's coordinates. Ids and mask are not those of the triangle.
    pub fn local(&self, triangle: &Triangle) -> Triangle {
        let corners = triangle.corners().map(|corner| {
            let from = DVec3::from(corner.map(f64::from)) - DVec3::from(self.origin);
            self.axes.map(|axis| DVec3::from(axis).dot(from) as f32)
        });
        Triangle::new(&corners, 0, 0, 0)
    }

    /// The arena's record.
    pub fn record(&self, unit: f64) -> Frame {
        let [x, y, z] = &self.axes;
        Frame {
            axes: [0, 1, 2].map(|k| [x[k], y[k], z[k], 0.0]),
            origin: [0, 1, 2, 3].map(|k| if k < 3 { self.origin[k] * unit } else { 0.0 }),
        }
    }
}

/// The lowest and the highest corner of grid `number`'s box or, if it is turned, of the
/// aligned box of what it holds.
pub fn place(grids: &[Grid], turns: &[Turn], number: usize) -> [[f64; 3]; 2] {
    let grid = &grids[number];
    let (lo, extent) = match turns.get(number) {
        Some(turn) if grid.is_turned() => (turn.lo, turn.extent),
        _ => (grid.lo, grid.extent),
    };
    [lo, [0, 1, 2].map(|k| lo[k] + extent[k])]
}
