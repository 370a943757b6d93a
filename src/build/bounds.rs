//! The boxes of references: where in a voxel's exit box a triangle or a grid can be.
//!
//! A ray that comes to a list looks at these first, eight at a time, and at nothing of
//! what they refer to unless it meets their boxes (`trace::bounds`). They are padded by
//! 2^-9 of a voxel: twice the walk's error (`trace::local`), so that half is left for
//! the rounding of the look.

use super::frame::Grid;
use crate::arena::layout::{BOX_CELLS, BOX_MARGIN, EXIT_BITS, EXIT_MAX, Triangle};

/// In voxels.
const PADDING: f64 = 1.0 / 512.0;

/// An exit box, cut into cells.
pub struct Frame {
    /// On each axis a place x is in cell x scale + lower or, a little larger, x scale +
    /// upper. Off by 2^-17 of a voxel at most: no coordinate is more than 2^35 of them.
    scale: [f64; 3],
    lower: [f64; 3],
    upper: [f64; 3],
}

/// The cell of a place, or the nearest.
#[inline(always)]
fn cell(x: f64) -> u32 {
    let x = if x > 0.0 { x } else { 0.0 };
    let last = f64::from(BOX_CELLS - 1);
    (if x < last { x } else { last }) as i32 as u32
}

/// The least and the greatest of three finite numbers. `f32::min` takes NaN into account.
#[inline(always)]
fn ends([a, b, c]: [f32; 3]) -> [f32; 2] {
    let least = |a: f32, b: f32| if a < b { a } else { b };
    let most = |a: f32, b: f32| if a > b { a } else { b };
    [least(least(a, b), c), most(most(a, b), c)]
}

impl Frame {
    /// That of the exit box `exit` of voxel `at`.
    pub fn new(grid: &Grid, at: [usize; 3], exit: u32) -> Self {
        let reach = |i: usize| f64::from(exit >> (i as u32 * EXIT_BITS) & EXIT_MAX);
        let margin = f64::from(BOX_MARGIN);
        let mut frame = Self { scale: [0.0; 3], lower: [0.0; 3], upper: [0.0; 3] };
        for (k, &at) in at.iter().enumerate() {
            let side = reach(2 * k) + 1.0 + reach(2 * k + 1) + 2.0 * margin;
            let cells = f64::from(BOX_CELLS) / side;
            // The lowest corner, in voxels from the origin of all coordinates.
            let low = at as f64 - reach(2 * k) - margin + grid.lo[k] * grid.inv_cell[k];
            frame.scale[k] = grid.inv_cell[k] * cells;
            frame.lower[k] = (-low - PADDING) * cells;
            frame.upper[k] = (-low + PADDING) * cells;
        }
        frame
    }

    /// The box of a triangle.
    pub fn of_triangle(&self, triangle: &Triangle) -> u32 {
        let [x, y, z] = [ends(triangle.x), ends(triangle.y), ends(triangle.z)];
        self.word([x[0], y[0], z[0]].map(f64::from), [x[1], y[1], z[1]].map(f64::from))
    }

    /// The box of what lies between two corners.
    #[inline(always)]
    pub fn word(&self, lo: [f64; 3], hi: [f64; 3]) -> u32 {
        let mut word = 0;
        for k in 0..3 {
            let first = cell(lo[k] * self.scale[k] + self.lower[k]);
            let last = cell(hi[k] * self.scale[k] + self.upper[k]);
            word |= (first | last << EXIT_BITS) << (2 * k as u32 * EXIT_BITS);
        }
        word
    }
}
