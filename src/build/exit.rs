//! Exit boxes: how far a ray can go before it meets anything new.
//!
//! The exit box of a voxel is a block of voxels around it, none of which refers
//! to anything that the voxel itself does not refer to; a ray that has met the
//! voxel's list leaves the block in one step. Related are proximity clouds
//! (Cohen & Sheffer 1994), macro-regions (Devillers 1988) and the cells of
//! irregular grids (Perard-Gayot, Kalojanov & Slusallek 2017). Boxes are grown
//! inside one grid only, greedily: the largest empty cube, then slabs in each of
//! the six directions; a summed-volume table tells in eight reads whether a block is
//! empty. Cost: one or two dozen such questions for an empty voxel.

use super::draft::{Draft, Span};
use super::frame::Grid;
use crate::arena::layout::{EXIT_BITS, EXIT_MAX};

/// A voxel with a longer list keeps to itself: comparing lists costs more than
/// the step it saves.
const LONG: u32 = 16;
/// Reach that a voxel with a list may grow to.
const LISTED_MAX: u32 = 7;

/// How many voxels of a grid are filled, for every block at its lowest corner.
pub struct Exits<'a> {
    grid: Grid,
    draft: &'a Draft<'a>,
    table: &'a [u32],
}

/// Entries of the table for a grid.
fn table_len(grid: &Grid) -> usize {
    grid.n.iter().map(|&n| n as usize + 1).product()
}

impl<'a> Exits<'a> {
    /// Sums up a grid's filled voxels; `None` if `memory` is too small.
    pub fn new(grid: &Grid, draft: &'a Draft<'a>, memory: &'a mut [u32]) -> Option<Self> {
        let table = memory.get_mut(..table_len(grid))?;
        let [nx, ny, nz] = grid.n.map(|n| n as usize);
        let (row, plane) = (nx + 1, (nx + 1) * (ny + 1));
        table[..plane].fill(0);
        let mut spans = draft.spans(grid).iter();
        for z in 1..=nz {
            table[z * plane..z * plane + row].fill(0);
            for y in 1..=ny {
                let at = z * plane + y * row;
                table[at] = 0;
                let mut filled = 0;
                for (x, span) in (1..=nx).zip(&mut spans) {
                    filled += u32::from(span.count > 0);
                    // This row, plus what lies below in y, plus in z, less both.
                    table[at + x] = filled + table[at + x - row] + table[at + x - plane]
                        - table[at + x - plane - row];
                }
            }
        }
        Some(Self { grid: *grid, draft, table })
    }

    /// Filled voxels in the block from `lo` up to, without, `hi`.
    fn filled(&self, lo: [u32; 3], hi: [u32; 3]) -> u32 {
        let (row, plane) = (
            self.grid.n[0] as usize + 1,
            (self.grid.n[0] as usize + 1) * (self.grid.n[1] as usize + 1),
        );
        let at =
            |x: u32, y: u32, z: u32| self.table[z as usize * plane + y as usize * row + x as usize];
        let slice = |z: u32| {
            (at(hi[0], hi[1], z).wrapping_sub(at(lo[0], hi[1], z)))
                .wrapping_sub(at(hi[0], lo[1], z).wrapping_sub(at(lo[0], lo[1], z)))
        };
        slice(hi[2]).wrapping_sub(slice(lo[2]))
    }

    /// The exit box of voxel `at`, in the arena's form. `radius` is that of the
    /// largest empty cube around the voxel before it in x, if there is one, and
    /// becomes this one's.
    pub fn grow(&self, at: [u32; 3], span: Span, radius: &mut u32) -> u32 {
        let mut block = Block { lo: at, hi: at.map(|x| x + 1) };
        let empty = |b: &Block| self.filled(b.lo, b.hi) == 0;
        if span.count == 0 {
            // The largest cube first, so that no direction starves another. Next
            // to a cube of radius r is one of at least r - 1, at most r + 1.
            let mut r = radius.saturating_sub(1);
            while r < EXIT_MAX && empty(&self.cube(at, r + 1)) {
                r += 1;
            }
            *radius = r;
            block = self.cube(at, r);
            self.expand(&mut block, at, EXIT_MAX, empty);
        } else {
            *radius = 0;
            if span.count <= LONG {
                let own = self.draft.list(span);
                self.expand(&mut block, at, LISTED_MAX, |slab| self.adds_nothing(slab, own));
            }
        }
        block.encode(at)
    }

    fn cube(&self, at: [u32; 3], radius: u32) -> Block {
        Block {
            lo: at.map(|x| x.saturating_sub(radius)),
            hi: core::array::from_fn(|k| (at[k] + radius + 1).min(self.grid.n[k])),
        }
    }

    /// Moves the faces outward in turns, each by slabs of twice the last thickness
    /// that fitted, or half the last that did not. A face stopped by a slab of one
    /// voxel stays stopped, for its slabs only grow.
    fn expand(&self, block: &mut Block, at: [u32; 3], most: u32, fits: impl Fn(&Block) -> bool) {
        let mut thickness = [1u32; 6];
        while thickness != [0; 6] {
            for (face, by) in thickness.iter_mut().enumerate().filter(|(_, by)| **by > 0) {
                let (k, up) = (face / 2, face % 2 == 1);
                let (lo, hi) = (block.lo[k], block.hi[k]);
                let room = if up {
                    (self.grid.n[k] - hi).min(at[k] + 1 + most - hi)
                } else {
                    lo.min(most - (at[k] - lo))
                };
                *by = room.min(*by);
                if *by == 0 {
                    continue;
                }
                let mut slab = *block;
                if up {
                    (slab.lo[k], slab.hi[k]) = (hi, hi + *by);
                } else {
                    (slab.lo[k], slab.hi[k]) = (lo - *by, lo);
                }
                if fits(&slab) {
                    block.lo[k] = lo.min(slab.lo[k]);
                    block.hi[k] = hi.max(slab.hi[k]);
                    *by *= 2;
                } else {
                    *by /= 2;
                }
            }
        }
    }

    /// Whether every voxel of a slab refers only to what `own` refers to.
    fn adds_nothing(&self, slab: &Block, own: &[u32]) -> bool {
        if self.filled(slab.lo, slab.hi) == 0 {
            return true;
        }
        let spans = self.draft.spans(&self.grid);
        let [nx, ny, _] = self.grid.n;
        (slab.lo[2]..slab.hi[2]).all(|z| {
            (slab.lo[1]..slab.hi[1]).all(|y| {
                let row = ((z * ny + y) * nx) as usize;
                let cells = &spans[row + slab.lo[0] as usize..row + slab.hi[0] as usize];
                cells.iter().all(|&span| subset(self.draft.list(span), own))
            })
        })
    }
}

/// Whether ascending `a` has nothing that ascending `b` lacks.
fn subset(a: &[u32], b: &[u32]) -> bool {
    let mut b = b.iter();
    a.len() <= b.len() && a.iter().all(|x| b.any(|y| x == y))
}

/// A block of voxels from `lo` up to, without, `hi`.
#[derive(Clone, Copy)]
pub struct Block {
    lo: [u32; 3],
    hi: [u32; 3],
}

impl Block {
    fn encode(&self, at: [u32; 3]) -> u32 {
        let mut word = 0;
        for k in (0..3).rev() {
            let (down, up) = (at[k] - self.lo[k], self.hi[k] - 1 - at[k]);
            word = word << (2 * EXIT_BITS) | up << EXIT_BITS | down;
        }
        word
    }
}
