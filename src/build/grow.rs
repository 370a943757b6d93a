//! Growing one exit box: faces move outward in turns until something stops them.

use super::draft::{Draft, Span};
use super::masks::Masks;
use super::rows::{Rows, UNION};
use crate::arena::layout::EXIT_MAX;

/// Reach that a voxel with a list may grow to.
const LISTED_MAX: usize = 7;

/// Whether some columns of row y, z may all be in a block. Not a type of its own for each who asks,
/// or growing would be in the library twice, ten kilobytes each.
type Harmless<'a> = &'a dyn Fn(u64, usize, usize) -> bool;

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
    pub masks: &'a Masks<'a>,
    pub rows: Rows<'a>,
}

/// A block that grows.
struct Growth<'a> {
    block: Block,
    /// How far each face may still move: -x, +x, -y and so on.
    left: [usize; 6],
    /// The faces that may, a bit each.
    open: u32,
    rows: Rows<'a>,
    /// The place of the row of the lowest voxel.
    place: usize,
    /// The bit of voxel 0 of a row, wrapping.
    zero: usize,
    /// The bits of the block's columns, and those of voxels in its rows that refer to
    /// something.
    columns: u64,
    taken: u64,
}

impl Grower<'_> {
    /// The box of an empty voxel with a cube of this reach around it.
    pub fn empty(&self, at: [usize; 3], radius: usize) -> Block {
        self.grow(at, radius, EXIT_MAX as usize, 63, &|_, _, _| false)
    }

    /// The box of a voxel with a list.
    pub fn listed(&self, at: [usize; 3], list: &[u32]) -> Block {
        let window = self.masks.window(at[0]);
        let open = self.open(at, list);
        if open == 0 {
            return Block { lo: at, hi: at.map(|x| x + 1) };
        }
        self.grow(at, 0, LISTED_MAX, open, &|columns, y, z| {
            let columns = columns & self.rows.at(self.masks.place(window, y, z));
            let first = (z * self.n[1] + y) * self.n[0] + at[0];
            self.add_nothing(columns, first.wrapping_sub(window.bit), list)
        })
    }

    /// Whether the voxels of which there are bits, the first of number `first`, refer to nothing that
    /// `list` does not. Apart, as it would be there for each face.
    #[inline(never)]
    fn add_nothing(&self, mut columns: u64, first: usize, list: &[u32]) -> bool {
        while columns != 0 {
            if !self.adds_nothing(first.wrapping_add(columns.trailing_zeros() as usize), list) {
                return false;
            }
            columns &= columns - 1;
        }
        true
    }

    /// The faces of voxel `at` behind which there is a voxel that refers to nothing that
    /// `list` does not.
    #[inline(always)]
    fn open(&self, at: [usize; 3], list: &[u32]) -> u32 {
        let window = self.masks.window(at[0]);
        let place = self.masks.place(window, at[1], at[2]);
        let strides = [1, self.n[0], self.n[0] * self.n[1]];
        let number = at[0] + at[1] * strides[1] + at[2] * strides[2];
        let row = self.rows.at(place);
        let mut open = 0;
        for k in 0..3 {
            let beside = |up: bool| match k {
                0 if up => row >> (window.bit + 1),
                0 => row >> (window.bit - 1),
                _ if up => self.rows.at(place + self.rows.steps[k - 1]) >> window.bit,
                _ => self.rows.at(place - self.rows.steps[k - 1]) >> window.bit,
            };
            let free = |up: bool, number: usize| {
                u32::from(beside(up) & 1 == 0 || self.adds_nothing(number, list))
            };
            if at[k] > 0 {
                open |= free(false, number - strides[k]) << (2 * k);
            }
            if at[k] + 1 < self.n[k] {
                open |= free(true, number + strides[k]) << (2 * k + 1);
            }
        }
        open
    }

    /// Whether the voxel of this number refers to nothing that `list` does not.
    #[inline(always)]
    pub fn adds_nothing(&self, voxel: usize, list: &[u32]) -> bool {
        let span = self.spans[voxel];
        span.count as usize <= list.len() && subset(self.draft.list(span), list)
    }

    /// Moves the faces of a block around voxel `at` outward in turns, at first by one
    /// layer, then two, four: no direction starves another. A face that was stopped
    /// stays so, for its layers only grow; so do those not in `open`.
    #[inline(never)]
    fn grow(
        &self,
        at: [usize; 3],
        radius: usize,
        most: usize,
        open: u32,
        harmless: Harmless<'_>,
    ) -> Block {
        let lo = at.map(|x| x.saturating_sub(radius));
        let hi = [0, 1, 2].map(|k| (at[k] + radius + 1).min(self.n[k]));
        let down = |k: usize| lo[k].min(most + lo[k] - at[k]);
        let up = |k: usize| (self.n[k] - hi[k]).min(at[k] + 1 + most - hi[k]);
        let window = self.masks.window(at[0]);
        // Along x no further than the window.
        let [before, after] = [window.bit + lo[0] - at[0], 64 + at[0] - window.bit - hi[0]];
        let left = [down(0).min(before), up(0).min(after), down(1), up(1), down(2), up(2)];
        let mut growth = Growth {
            block: Block { lo, hi },
            left,
            open,
            rows: self.rows,
            place: self.masks.place(window, lo[1], lo[2]),
            zero: window.bit.wrapping_sub(at[0]),
            columns: 0,
            taken: 0,
        };
        growth.columns = growth.columns();
        growth.taken = self.rows.block(growth.place, [hi[1] - lo[1], hi[2] - lo[2]]);
        let mut step = 1;
        while growth.open != 0 {
            growth.push_x::<0>(step, harmless);
            growth.push_x::<1>(step, harmless);
            growth.push::<2>(step, harmless);
            growth.push::<3>(step, harmless);
            growth.push::<4>(step, harmless);
            growth.push::<5>(step, harmless);
            step *= 2;
        }
        growth.block
    }
}

impl Growth<'_> {
    #[inline(always)]
    fn columns(&self) -> u64 {
        let [lo, hi] = [self.block.lo[0], self.block.hi[0]].map(|x| self.zero.wrapping_add(x));
        u64::MAX << lo & u64::MAX >> (64 - hi)
    }

    #[inline(always)]
    fn push_x<const FACE: usize>(&mut self, step: usize, harmless: Harmless<'_>) {
        let most = step.min(self.left[FACE]);
        if self.open >> FACE & 1 == 0 || most == 0 {
            self.open &= !(1 << FACE);
            return;
        }
        let up = FACE == 1;
        let Block { lo, hi } = self.block;
        let edge = self.zero.wrapping_add(if up { hi[0] } else { lo[0] });
        let free = if up {
            (self.taken >> edge).trailing_zeros()
        } else {
            (self.taken << (64 - edge)).leading_zeros()
        };
        let mut by = most.min(free as usize);
        while by < most {
            let column = 1 << if up { edge + by } else { edge - 1 - by };
            if self.taken & column != 0
                && !(lo[2]..hi[2]).all(|z| (lo[1]..hi[1]).all(|y| harmless(column, y, z)))
            {
                break;
            }
            by += 1;
        }
        self.left[FACE] -= by;
        if by < most || self.left[FACE] == 0 {
            self.open &= !(1 << FACE);
        }
        if up {
            self.block.hi[0] += by;
        } else {
            self.block.lo[0] -= by;
        }
        self.columns = self.columns();
    }

    #[inline(always)]
    fn push<const FACE: usize>(&mut self, step: usize, harmless: Harmless<'_>) {
        if self.open >> FACE & 1 == 0 {
            return;
        }
        let (k, up) = (FACE / 2, FACE % 2 == 1);
        let Block { lo, hi } = self.block;
        let sides = [hi[1] - lo[1], hi[2] - lo[2]];
        let stride = self.rows.steps[k - 1];
        let mut place = if up { self.place + sides[k - 1] * stride } else { self.place };
        let most = step.min(self.left[FACE]);
        let mut by = 0;
        while by + UNION <= most {
            let first = if up { place } else { place - UNION * stride };
            let layers = if k == 1 {
                self.rows.union_of_four::<1>(first, sides[1])
            } else {
                self.rows.union_of_four::<0>(first, sides[0])
            };
            if layers & self.columns != 0 {
                break;
            }
            self.taken |= layers;
            place = if up { place + UNION * stride } else { first };
            by += UNION;
        }
        while by < most {
            let first = if up { place } else { place - stride };
            let layer = if k == 1 {
                self.rows.union::<1>(first, sides[1])
            } else {
                self.rows.union::<0>(first, sides[0])
            };
            if layer & self.columns != 0 {
                let at = if up { hi[k] + by } else { lo[k] - 1 - by };
                let free = if k == 1 {
                    (lo[2]..hi[2]).all(|z| harmless(self.columns, at, z))
                } else {
                    (lo[1]..hi[1]).all(|y| harmless(self.columns, y, at))
                };
                if !free {
                    break;
                }
            }
            self.taken |= layer;
            place = if up { place + stride } else { first };
            by += 1;
        }
        self.left[FACE] -= by;
        if by < most || self.left[FACE] == 0 {
            self.open &= !(1 << FACE);
        }
        if up {
            self.block.hi[k] += by;
        } else {
            self.block.lo[k] -= by;
            self.place -= by * stride;
        }
    }
}

/// Whether ascending `a` has nothing that ascending `b` lacks.
#[inline(always)]
fn subset(a: &[u32], b: &[u32]) -> bool {
    let mut rest = b.iter();
    a.iter().all(|&x| rest.by_ref().find(|&&y| y >= x) == Some(&x))
}
