//! Which of a list's boxes are in reach of a packet.

use super::lines::Lines;
use super::{Packet, Part};
use crate::arena::layout::{BOX_CELLS, BOX_MARGIN, EXIT_BITS, EXIT_MAX, GRID_BIT, LIST_HEAD};
use crate::simd::{Kernel, Lanes};
use crate::trace::query::Query;

/// More than what is rounded here, in voxels.
const ROOM: f32 = 1.0 / 2048.0;

/// The list of a voxel, and the distances between which it is of interest, in voxels.
#[derive(Clone, Copy)]
pub(super) struct List {
    pub at: [i32; 3],
    pub place: u32,
    pub exit: u32,
    pub len: u32,
    pub range: [f64; 2],
}

/// A bound of the boxes of a list, as the bits that `mask` has of a word, times `scale`.
#[derive(Clone, Copy)]
struct Bound {
    mask: [u32; 8],
    scale: f32,
}

/// The boxes of a list along an axis begin at `near`, end at `far + cell`, counted from
/// `low`, a place in the grid.
struct Side {
    near: Bound,
    far: Bound,
    low: f64,
    cell: f32,
}

impl Side {
    #[inline(always)]
    fn new(axis: usize, at: i32, exit: u32) -> Self {
        let reach = |upper: u32| exit >> (EXIT_BITS * (2 * axis as u32 + upper)) & EXIT_MAX;
        let (below, above) = (reach(0) as f32, reach(1) as f32);
        let cell = (below + 1.0 + above + 2.0 * BOX_MARGIN) / BOX_CELLS as f32;
        let bound = |upper: u32| {
            let shift = EXIT_BITS * (2 * axis as u32 + upper);
            Bound { mask: [EXIT_MAX << shift; 8], scale: cell / (1u32 << shift) as f32 }
        };
        let low = f64::from(at) - f64::from(below + BOX_MARGIN);
        Self { near: bound(0), far: bound(1), low, cell }
    }
}

/// [`Packet::look`], compiled for the packet's instruction set.
struct Look<'w, 'a, 't, Q, L> {
    packet: &'w mut Packet<'a, 't, Q, L>,
    lines: &'w Lines,
    part: Part,
    list: &'w List,
}

impl<Q: Query, L: Lanes> Kernel<L> for Look<'_, '_, '_, Q, L> {
    type Out = ();
    #[inline(always)]
    fn run(self, _: L) {
        self.packet.boxes(self.lines, self.part, self.list);
    }
}

impl<Q: Query, L: Lanes> Packet<'_, '_, Q, L> {
    /// Keeps the triangles of a list whose boxes are in reach, and goes through its grids.
    #[inline(never)]
    pub(super) fn look(&mut self, lines: &Lines, part: Part, list: &List) {
        let lanes = self.lanes;
        lanes.run(Look { packet: self, lines, part, list });
    }

    #[inline(always)]
    fn boxes(&mut self, lines: &Lines, part: Part, list: &List) {
        let (l, sections) = (self.lanes, self.sections);
        let &List { at, place, exit, len, range: [near, far] } = list;
        let z = if self.down { lines.n[2] - 1 - at[2] } else { at[2] };
        let x = Side::new(self.axes[0], at[0], exit);
        let y = Side::new(self.axes[1], at[1], exit);
        let z = Side::new(self.axes[2], z, exit);
        // Where cell 0 begins, the way the rays go or turned, from `near` on.
        let begin = (z.low - lines.at[2] - near) as f32;
        let turned = (f64::from(lines.n[2]) - z.low - lines.at[2] - near) as f32;
        let depth = l.splat_wide((far - near) as f32 + ROOM);
        let edge = |at: f64, slope: f64, low: f64, room: f32| {
            let steep = slope as f32;
            (steep, (at + slope * near - low) as f32 + room * (1.0 + steep.abs()))
        };
        let slopes = &lines.slopes;
        let edges = [
            edge(lines.at[0], slopes.x[0], x.low, -ROOM),
            edge(lines.at[0], slopes.x[1], x.low, ROOM),
            edge(lines.at[1], slopes.y[0], y.low, -ROOM),
            edge(lines.at[1], slopes.y[1], y.low, ROOM),
        ];
        self.work = self.work.saturating_add(6 + len / 3);
        let refs = place + LIST_HEAD as u32;
        let mut i = 0;
        while i < len {
            let words = l.words(sections.eight(refs + len + i));
            let first = place_of(l, words, &z.near);
            let last = place_of(l, words, &z.far);
            let (first, last) = if self.down {
                let turned = l.splat_wide(turned);
                (
                    l.sub_wide(turned, l.add_wide(last, l.splat_wide(z.cell))),
                    l.sub_wide(turned, first),
                )
            } else {
                let begin = l.splat_wide(begin);
                (
                    l.add_wide(begin, first),
                    l.add_wide(begin, l.add_wide(last, l.splat_wide(z.cell))),
                )
            };
            let room = l.splat_wide(-ROOM);
            let mut met = l.at_most(first, depth) & l.at_most(room, last);
            let first = l.max_wide(first, room);
            let last = l.min_wide(last, depth);
            for (side, [low, high]) in [(&x, [edges[0], edges[1]]), (&y, [edges[2], edges[3]])] {
                let lowest = l.min_wide(along(l, low, first), along(l, low, last));
                let highest = l.max_wide(along(l, high, first), along(l, high, last));
                let end = l.add_wide(place_of(l, words, &side.far), l.splat_wide(side.cell));
                let begin = place_of(l, words, &side.near);
                met &= l.at_most(lowest, end) & l.at_most(begin, highest);
            }
            met &= !u32::MAX.checked_shl(len - i).unwrap_or(0);
            let mut these = [0; 8];
            l.compress(sections.eight(refs + i), met, &mut these);
            let count = met.count_ones() as usize;
            for &r in &these[..count] {
                self.keep(r, part, near, lines);
            }
            i += L::WIDE as u32;
        }
    }

    /// Keeps what a reference refers to for [`Packet::meet`], or goes through it at once.
    #[inline(always)]
    fn keep(&mut self, r: u32, part: Part, near: f64, lines: &Lines) {
        if r & GRID_BIT != 0 {
            self.meet_apart(part, lines);
            self.grid_apart(r & !GRID_BIT, part, near / lines.scale);
            self.nearer = true;
            return;
        }
        if !self.tables.is_new(r, lines.bounds.rays) {
            return;
        }
        self.sections.fetch_triangle(self.lanes, r);
        if self.tables.due.push(r) {
            self.meet_apart(part, lines);
        }
    }
}

/// The places that bounds of boxes stand for.
#[inline(always)]
fn place_of<L: Lanes>(l: L, words: L::Words, bound: &Bound) -> L::Wide {
    l.mul_wide(l.field(words, &bound.mask), l.splat_wide(bound.scale))
}

/// Where a line is at some distances, from its slope and its start.
#[inline(always)]
fn along<L: Lanes>(l: L, (slope, start): (f32, f32), at: L::Wide) -> L::Wide {
    l.mul_add_wide(l.splat_wide(slope), at, l.splat_wide(start))
}
