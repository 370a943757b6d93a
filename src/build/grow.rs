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

/// A grid whose voxels' boxes are grown.
pub struct Grower<'a> {
    pub n: [usize; 3],
    pub spans: &'a [Span],
    pub draft: &'a Draft<'a>,
    pub clearance: &'a Clearance<'a>,
}

/// A block that grows.
struct Growth<'a> {
    block: Block,
    /// How far each face may still move: -x, +x, -y and so on.
    left: [usize; 6],
    /// The lowest voxel's number, and its place in the clearances.
    voxel: usize,
    index: usize,
    /// From a voxel to the next along each axis, in numbers and in places.
    strides: [usize; 3],
    steps: [usize; 3],
    clearance: &'a Clearance<'a>,
}

impl<'a> Grower<'a> {
    /// The box of an empty voxel with a cube of this reach around it.
    pub fn empty(&self, at: [usize; 3], radius: usize) -> Block {
        let mut growth = self.start(at, radius, EXIT_MAX as usize);
        growth.expand(|_| false);
        growth.block
    }

    /// The box of a voxel with a list.
    pub fn listed(&self, at: [usize; 3], span: Span) -> Block {
        let own = self.draft.list(span);
        let mut growth = self.start(at, 0, LISTED_MAX);
        growth.expand(|voxel| {
            let span = self.spans[voxel];
            span.count as usize <= own.len() && subset(self.draft.list(span), own)
        });
        growth.block
    }

    /// Whether the voxel of this number refers to nothing that `span` does not.
    pub fn adds_nothing(&self, voxel: usize, span: Span) -> bool {
        let other = self.spans[voxel];
        other.count <= span.count && subset(self.draft.list(other), self.draft.list(span))
    }

    fn start(&self, at: [usize; 3], radius: usize, most: usize) -> Growth<'a> {
        let lo = at.map(|x| x.saturating_sub(radius));
        let hi = core::array::from_fn(|k| (at[k] + radius + 1).min(self.n[k]));
        let left = core::array::from_fn(|face| {
            let k = face / 2;
            if face % 2 == 0 {
                lo[k].min(most + lo[k] - at[k])
            } else {
                (self.n[k] - hi[k]).min(at[k] + 1 + most - hi[k])
            }
        });
        let strides = [1, self.n[0], self.n[0] * self.n[1]];
        Growth {
            block: Block { lo, hi },
            left,
            voxel: lo[0] + lo[1] * strides[1] + lo[2] * strides[2],
            index: self.clearance.index(lo),
            strides,
            steps: [1, self.clearance.row, self.clearance.plane],
            clearance: self.clearance,
        }
    }
}

impl Growth<'_> {
    /// Moves the faces outward in turns, as far as is certainly free, but at first
    /// by one layer, then two, four: no direction starves another. A face that was
    /// stopped stays so, for its layers only grow. `harmless`: whether a voxel that
    /// refers to something may be in the block.
    #[inline(always)]
    fn expand(&mut self, harmless: impl Fn(usize) -> bool) {
        let mut step = 1;
        while self.left != [0; 6] {
            self.push::<0>(step, &harmless);
            self.push::<1>(step, &harmless);
            self.push::<2>(step, &harmless);
            self.push::<3>(step, &harmless);
            self.push::<4>(step, &harmless);
            self.push::<5>(step, &harmless);
            step *= 2;
        }
    }

    #[inline(always)]
    fn push<const FACE: usize>(&mut self, step: usize, harmless: &impl Fn(usize) -> bool) {
        if self.left[FACE] == 0 {
            return;
        }
        let (k, up) = (FACE / 2, FACE % 2 == 1);
        let layers = if up { self.block.hi[k] - self.block.lo[k] } else { 0 };
        let (index, voxel) = (
            self.index + layers * self.steps[k] - usize::from(!up) * self.steps[k],
            self.voxel + layers * self.strides[k] - usize::from(!up) * self.strides[k],
        );
        let by = self.free(k, index, voxel, harmless).min(step).min(self.left[FACE]);
        self.left[FACE] = if by == 0 { 0 } else { self.left[FACE] - by };
        if up {
            self.block.hi[k] += by;
        } else {
            self.block.lo[k] -= by;
            self.index -= by * self.steps[k];
            self.voxel -= by * self.strides[k];
        }
    }

    /// How many layers, the one behind a face and those behind that, are certainly
    /// free: empty cubes around some of the layer's voxels cover it. `index` and
    /// `voxel`: its lowest voxel.
    #[inline(always)]
    fn free(
        &self,
        k: usize,
        index: usize,
        voxel: usize,
        harmless: &impl Fn(usize) -> bool,
    ) -> usize {
        let [a, b] = [if k == 0 { 1 } else { 0 }, if k == 2 { 1 } else { 2 }];
        let sides = [a, b].map(|axis| self.block.hi[axis] - self.block.lo[axis]);
        let (mut depth, mut j) = (usize::MAX, 0);
        while j < sides[1] {
            let (mut least, mut i) = (usize::MAX, 0);
            while i < sides[0] {
                let mut room =
                    usize::from(self.clearance.at(index + i * self.steps[a] + j * self.steps[b]));
                if room == 0 {
                    if !harmless(voxel + i * self.strides[a] + j * self.strides[b]) {
                        return 0;
                    }
                    room = 1;
                }
                least = least.min(room);
                i += room;
            }
            depth = depth.min(least);
            j += least;
        }
        depth
    }
}

/// Whether ascending `a` has nothing that ascending `b` lacks.
#[inline(always)]
fn subset(a: &[u32], b: &[u32]) -> bool {
    let mut rest = b.iter();
    a.iter().all(|&x| rest.by_ref().find(|&&y| y >= x) == Some(&x))
}
