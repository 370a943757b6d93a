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
pub struct Frame<'a> {
    grid: &'a Grid,
    /// The lowest corner in voxels, and cells per voxel.
    low: [f64; 3],
    scale: [f64; 3],
}

impl<'a> Frame<'a> {
    /// That of the exit box `exit` of voxel `at`.
    pub fn new(grid: &'a Grid, at: [usize; 3], exit: u32) -> Self {
        let reach = |i: usize| f64::from(exit >> (i as u32 * EXIT_BITS) & EXIT_MAX);
        let margin = f64::from(BOX_MARGIN);
        let side = |k: usize| reach(2 * k) + 1.0 + reach(2 * k + 1) + 2.0 * margin;
        Self {
            grid,
            low: [0, 1, 2].map(|k| at[k] as f64 - reach(2 * k) - margin),
            scale: [0, 1, 2].map(|k| f64::from(BOX_CELLS) / side(k)),
        }
    }

    /// The box of a triangle.
    pub fn of_triangle(&self, triangle: &Triangle) -> u32 {
        let rows = [&triangle.x, &triangle.y, &triangle.z];
        self.word(|k| {
            let [a, b, c] = *rows[k];
            [a.min(b).min(c), a.max(b).max(c)].map(f64::from)
        })
    }

    /// The box of a grid.
    pub fn of_grid(&self, grid: &Grid) -> u32 {
        self.word(|k| [grid.lo[k], grid.lo[k] + grid.extent[k]])
    }

    fn word(&self, bounds: impl Fn(usize) -> [f64; 2]) -> u32 {
        let mut word = 0;
        for k in 0..3 {
            let place = |x: f64| (x - self.grid.lo[k]) * self.grid.inv_cell[k] - self.low[k];
            let [lo, hi] = bounds(k);
            let cell = |x: f64| x.clamp(0.0, f64::from(BOX_CELLS - 1)) as u32;
            let first = cell((place(lo) - PADDING) * self.scale[k]);
            let last = cell((place(hi) + PADDING) * self.scale[k]);
            word |= (first | last << EXIT_BITS) << (2 * k as u32 * EXIT_BITS);
        }
        word
    }
}
