//! Boxes, blocks of voxels, and where they lie.

use crate::arena::Sections;
use crate::arena::layout::{self, EXIT_BITS, EXIT_MAX, Grid, TURNED, Triangle};
use crate::triangle::Corners;

/// How much blocks are grown, in voxels.
const PAD: f64 = 1.0 / 256.0;
/// Of the square of a distance, for roundings.
const BELOW: f64 = 1.0 - 1e-12;

/// A box, by its lowest and highest corner.
#[derive(Clone, Copy)]
pub struct Bounds {
    pub lo: [f64; 3],
    pub hi: [f64; 3],
}

impl Bounds {
    pub const EVERYWHERE: Self = Self { lo: [f64::NEG_INFINITY; 3], hi: [f64::INFINITY; 3] };

    /// The box of a triangle.
    pub fn of(triangle: &Triangle) -> Self {
        let along = |k| triangle.along(k).map(f64::from);
        Self {
            lo: core::array::from_fn(|k| along(k).into_iter().fold(f64::INFINITY, f64::min)),
            hi: core::array::from_fn(|k| along(k).into_iter().fold(f64::NEG_INFINITY, f64::max)),
        }
    }

    /// What it has in common with another.
    pub fn meet(&self, other: &Self) -> Self {
        Self {
            lo: core::array::from_fn(|k| self.lo[k].max(other.lo[k])),
            hi: core::array::from_fn(|k| self.hi[k].min(other.hi[k])),
        }
    }

    pub fn is_empty(&self) -> bool {
        (0..3).any(|k| self.lo[k] >= self.hi[k])
    }

    /// A box around this one in the coordinates of a turned grid. An infinite one stays so.
    pub fn turned(&self, frame: &layout::Frame) -> Self {
        let middle = core::array::from_fn(|k| 0.5 * self.lo[k] + 0.5 * self.hi[k]);
        let half: [f64; 3] = core::array::from_fn(|k| 0.5 * self.hi[k] - 0.5 * self.lo[k]);
        if !half.iter().chain(&middle).all(|x| x.is_finite()) {
            return Self::EVERYWHERE;
        }
        let from = frame.relative(middle);
        let middle = frame.turn(from);
        let far = from.iter().fold(0.0f64, |far, x| far.max(x.abs()));
        let reach: [f64; 3] = core::array::from_fn(|k| {
            let along = |i: usize| frame.axes[i][k].abs() * half[i];
            // What rounding may take away, many times over.
            (along(0) + along(1) + along(2)) * (1.0 + 1e-12) + far * 1e-12
        });
        Self {
            lo: core::array::from_fn(|k| middle[k] - reach[k]),
            hi: core::array::from_fn(|k| middle[k] + reach[k]),
        }
    }

    /// At most the square of the distance from `p`.
    pub fn square(&self, p: &[f64; 3]) -> f64 {
        let off = |k: usize| (self.lo[k] - p[k]).max(p[k] - self.hi[k]).max(0.0);
        let [x, y, z] = [off(0), off(1), off(2)];
        (x * x + y * y + z * z) * BELOW
    }
}

/// A block of a grid's voxels, first and last.
#[derive(Clone, Copy)]
pub struct Block {
    pub lo: [u32; 3],
    pub hi: [u32; 3],
}

impl Block {
    /// Whether it lies in the exit box `exit` of voxel `at`, one of its own.
    pub fn inside(&self, exit: u32, at: [u32; 3]) -> bool {
        let reach = |side: u32| exit >> (side * EXIT_BITS) & EXIT_MAX;
        (0..3).all(|k| {
            let side = 2 * k as u32;
            at[k] - self.lo[k] <= reach(side) && self.hi[k] - at[k] <= reach(side + 1)
        })
    }
}

/// The part of a grid that is searched, and the centre's place in it.
pub struct Frame<'a> {
    pub grid: &'a Grid,
    /// The sides of a voxel.
    pub cell: [f64; 3],
    /// The centre, in the grid's coordinates, and the voxel that is nearest to it.
    pub p: [f64; 3],
    pub at: [u32; 3],
    part: Bounds,
    /// If these are its own, a part of space around it, in those of the scene.
    turned: Option<Bounds>,
}

impl<'a> Frame<'a> {
    pub fn new(sections: &Sections<'a>, number: u32, p: &[f64; 3], part: Bounds) -> Self {
        let grid = sections.grid(number);
        let cell = grid.inv_cell.map(|x| 1.0 / f64::from(x));
        let mut frame = Self { grid, cell, p: *p, at: [0; 3], part, turned: None };
        if grid.flags & TURNED != 0 {
            let own = sections.frame(number);
            frame.p = own.turn(own.relative(*p));
            frame.part = part.turned(own);
            frame.turned = Some(part);
        }
        frame.at = core::array::from_fn(|k| frame.voxel(frame.p[k], k));
        frame
    }

    /// The number, along axis `k`, of the voxel at `x` or one beside it, or of the last.
    fn voxel(&self, x: f64, k: usize) -> u32 {
        // Saturates, as all casts do.
        let n = (x - self.grid.lo[k]) * f64::from(self.grid.inv_cell[k]);
        (n as u32).min(u32::from(self.grid.n[k]) - 1)
    }

    /// Where voxel `i` begins along axis `k`: voxels share out all of space.
    #[inline(never)]
    fn plane(&self, i: u32, k: usize) -> f64 {
        if i == 0 {
            f64::NEG_INFINITY
        } else if i == u32::from(self.grid.n[k]) {
            f64::INFINITY
        } else {
            self.grid.lo[k] + f64::from(i) * self.cell[k]
        }
    }

    /// The voxels that the part meets; it is not empty.
    pub fn block(&self) -> Block {
        let (mut lo, mut hi) = ([0; 3], [0; 3]);
        for k in 0..3 {
            let [from, to] = [self.part.lo[k], self.part.hi[k]];
            let mut i = self.voxel(from, k);
            while self.plane(i, k) > from {
                i -= 1;
            }
            while self.plane(i + 1, k) <= from {
                i += 1;
            }
            lo[k] = i;
            i = self.voxel(to, k).max(i);
            while i > lo[k] && self.plane(i, k) >= to {
                i -= 1;
            }
            while self.plane(i + 1, k) < to {
                i += 1;
            }
            hi[k] = i;
        }
        Block { lo, hi }
    }

    /// The part of space that is the part's and the block's.
    pub fn share(&self, block: &Block) -> Bounds {
        let space = Bounds {
            lo: core::array::from_fn(|k| self.plane(block.lo[k], k)),
            hi: core::array::from_fn(|k| self.plane(block.hi[k] + 1, k)),
        };
        // Nothing is lost if it is larger, and places in a turned grid are not worth turning back.
        self.turned.unwrap_or_else(|| space.meet(&self.part))
    }

    /// A box of all that the block refers to in the part.
    pub fn bounds(&self, block: &Block) -> Bounds {
        let plane = |k: usize, n: f64| self.grid.lo[k] + n * self.cell[k];
        let grown = Bounds {
            lo: core::array::from_fn(|k| plane(k, f64::from(block.lo[k]) - PAD)),
            hi: core::array::from_fn(|k| plane(k, f64::from(block.hi[k]) + (1.0 + PAD))),
        };
        grown.meet(&self.part)
    }
}
