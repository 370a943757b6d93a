//! Grids and voxels one by one, for drawings and for statistics of one's own.

use crate::arena::View;
use crate::arena::layout::TURNED;
use crate::simd::fpenv;

/// Where a grid lies and how it is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridShape {
    /// Lowest corner, in the units of the scene; of a turned grid in its own coordinates.
    pub lower: [f64; 3],
    /// Highest corner.
    pub upper: [f64; 3],
    /// Voxels along x, y, z.
    pub counts: [u32; 3],
    /// Level; 0 is the deepest.
    pub level: u32,
    /// The grid's own coordinates, if it is turned (`Options::orientation`).
    pub frame: Option<GridFrame>,
}

/// Coordinates of a grid's own: a place p is at `axes[k] . (p - origin)` along axis k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridFrame {
    /// Unit vectors at right angles.
    pub axes: [[f64; 3]; 3],
    /// In the units of the scene.
    pub origin: [f64; 3],
}

impl View<'_> {
    /// Number of grids; 0 for an empty scene.
    #[must_use]
    pub fn grid_count(&self) -> usize {
        self.grids().len()
    }

    /// Grid number `number`, if there is one: 0 is the outermost, and a grid comes
    /// after those that refer to it.
    #[must_use]
    pub fn grid_shape(&self, number: usize) -> Option<GridShape> {
        let grid = self.grids().get(number)?;
        Some(fpenv::with_default(|| {
            let unit = self.header().unit;
            let side = |k: usize| f64::from(grid.n[k]) / f64::from(grid.inv_cell[k]);
            GridShape {
                lower: grid.lo.map(|x| x / unit),
                upper: [0, 1, 2].map(|k| (grid.lo[k] + side(k)) / unit),
                counts: grid.n.map(u32::from),
                level: u32::from(grid.level),
                frame: (grid.flags & TURNED != 0).then(|| {
                    let own = self.sections().frame(number as u32);
                    let axis = |k: usize| [0, 1, 2].map(|i| own.axes[i][k]);
                    GridFrame {
                        axes: [axis(0), axis(1), axis(2)],
                        origin: [0, 1, 2].map(|k| own.origin[k] / unit),
                    }
                }),
            }
        }))
    }

    /// How many triangles and how many grids a voxel of a grid refers to, if there
    /// are such.
    #[must_use]
    pub fn voxel_counts(&self, grid: usize, at: [u32; 3]) -> Option<(u64, u64)> {
        let grid = self.grids().get(grid)?;
        let n = grid.n.map(u32::from);
        if at.iter().zip(n).any(|(&at, n)| at >= n) {
            return None;
        }
        let inside = (at[2] as usize * n[1] as usize + at[1] as usize) * n[0] as usize;
        Some(self.sections().counts(grid.first as usize + inside + at[0] as usize))
    }
}
