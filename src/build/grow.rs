//! Growing one exit box: faces move outward in turns until something stops them.

use super::clearance::Clearance;
use super::draft::{Draft, Span};
use crate::arena::layout::EXIT_MAX;

/// Reach that a voxel with a list may grow to.
const LISTED_MAX: usize = 7;

/// A block of voxels from `lo` up to, without, `hi`.
#[derive(Clone, Copy)]
pub struct Block {
    pub lo: [usize; 3],
    pub hi: [usize; 3],
}

impl Block {
    pub fn one(at: [usize; 3]) -> Self {
        Self { lo: at, hi: at.map(|x| x + 1) }
    }
}

/// A grid whose voxels' boxes are grown.
pub struct Grower<'a> {
    pub n: [usize; 3],
    pub spans: &'a [Span],
    pub draft: &'a Draft<'a>,
    pub clearance: &'a Clearance<'a>,
}

/// The voxels behind one face of a block, a rectangle along two axes.
struct Layer {
    /// The rectangle's lowest voxel, and its sides along both axes.
    at: [usize; 3],
    axes: [usize; 2],
    sides: [usize; 2],
}

impl Grower<'_> {
    /// The box of an empty voxel with a cube of this reach around it.
    pub fn empty(&self, at: [usize; 3], radius: usize) -> Block {
        let block = Block {
            lo: at.map(|x| x.saturating_sub(radius)),
            hi: core::array::from_fn(|k| (at[k] + radius + 1).min(self.n[k])),
        };
        self.expand(block, at, EXIT_MAX as usize, |layer| self.clear(layer))
    }

    /// The box of a voxel with a list.
    pub fn listed(&self, at: [usize; 3], span: Span) -> Block {
        let own = self.draft.list(span);
        self.expand(Block::one(at), at, LISTED_MAX, |layer| self.adds_nothing(layer, own))
    }

    /// Whether the voxel of this number refers to just what `span` does.
    pub fn same_list(&self, span: Span, voxel: usize) -> bool {
        let other = self.spans[voxel];
        other.count == span.count && self.draft.list(other) == self.draft.list(span)
    }

    /// Moves the faces outward in turns, by as many layers as `open` says can be
    /// had, but at first by one, then two, four: no direction starves another. A
    /// face that was stopped stays so, for its layers only grow.
    #[inline(always)]
    fn expand(
        &self,
        mut block: Block,
        at: [usize; 3],
        most: usize,
        open: impl Fn(&Layer) -> usize,
    ) -> Block {
        let (mut moving, mut step) = (0x3fu32, 1);
        while moving != 0 {
            let mut left = moving;
            while left != 0 {
                let face = left.trailing_zeros() as usize;
                left &= left - 1;
                let (k, up) = (face / 2, face % 2 == 1);
                let (lo, hi) = (block.lo[k], block.hi[k]);
                let room = if up {
                    (self.n[k] - hi).min(at[k] + 1 + most - hi)
                } else {
                    lo.min(most - (at[k] - lo))
                };
                let by = if room == 0 {
                    0
                } else {
                    let axes = [if k == 0 { 1 } else { 0 }, if k == 2 { 1 } else { 2 }];
                    let mut layer = Layer {
                        at: block.lo,
                        axes,
                        sides: axes.map(|axis| block.hi[axis] - block.lo[axis]),
                    };
                    layer.at[k] = if up { hi } else { lo - 1 };
                    room.min(step).min(open(&layer))
                };
                if by == 0 {
                    moving &= !(1 << face);
                } else if up {
                    block.hi[k] = hi + by;
                } else {
                    block.lo[k] = lo - by;
                }
            }
            step *= 2;
        }
        block
    }

    /// How many layers, this one and those behind it, are certainly empty: empty
    /// cubes around some of its voxels cover it.
    fn clear(&self, layer: &Layer) -> usize {
        let strides = layer.axes.map(|k| [1, self.clearance.row, self.clearance.plane][k]);
        let (mut depth, mut j) = (usize::MAX, 0);
        let start = self.clearance.index(layer.at);
        while j < layer.sides[1] {
            let (mut least, mut i) = (usize::MAX, 0);
            while i < layer.sides[0] {
                let room = usize::from(self.clearance.at(start + i * strides[0] + j * strides[1]));
                if room == 0 {
                    return 0;
                }
                least = least.min(room);
                i += room;
            }
            depth = depth.min(least);
            j += least;
        }
        depth
    }

    /// 1 if every voxel of a layer refers only to what `own` refers to, else 0.
    fn adds_nothing(&self, layer: &Layer, own: &[u32]) -> usize {
        let strides = layer.axes.map(|k| [1, self.n[0], self.n[0] * self.n[1]][k]);
        let steps = layer.axes.map(|k| [1, self.clearance.row, self.clearance.plane][k]);
        let first = layer.at[0] + self.n[0] * (layer.at[1] + self.n[1] * layer.at[2]);
        let start = self.clearance.index(layer.at);
        let mut j = 0;
        while j < layer.sides[1] {
            let (mut least, mut i) = (usize::MAX, 0);
            while i < layer.sides[0] {
                let room = usize::from(self.clearance.at(start + i * steps[0] + j * steps[1]));
                if room == 0 {
                    let span = self.spans[first + i * strides[0] + j * strides[1]];
                    if !subset(self.draft.list(span), own) {
                        return 0;
                    }
                }
                least = least.min(room.max(1));
                i += room.max(1);
            }
            j += least;
        }
        1
    }
}

/// Whether ascending `a` has nothing that ascending `b` lacks.
fn subset(a: &[u32], b: &[u32]) -> bool {
    let mut b = b.iter();
    a.len() <= b.len() && a.iter().all(|x| b.any(|y| x == y))
}
