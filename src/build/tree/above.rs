//! A binary tree over single triangles, built from above: items split in two and again, by boxes of
//! least expected cost by surface area (MacDonald & Booth 1990), among the borders of a few bins
//! (Wald 2007).
//!
//! What is split between items b and b + 1 is node b (Karras 2012 numbers a tree along a curve
//! so): each part of the items has nodes of its own, whoever splits it, and of a node and one
//! below it the lower is to the left. Where it becomes deep, items are halved instead.

use super::MOST;
use super::binary::{Binary, NONE};
use super::item::Item;
use super::split::{Bins, Part, split};
use crate::Error;
use crate::build::control::{Control, Parts, TASKS, parts};
use crate::build::scratch::cut;

/// Levels of nodes whose splits are chosen; below, triangles are halved.
const CHOSEN: u32 = 96;
/// Triangles that it is no use to share.
const FEW: usize = 1024;
/// Pieces that wait: one for each power of two below the most triangles, and one.
const WAITING: usize = MOST.ilog2() as usize + 1;
/// Some items that are to be split: the first of them, how many levels there are above, and
/// the node above.
#[derive(Clone, Copy)]
struct Piece {
    first: usize,
    part: Part,
    depth: u32,
    above: u32,
}

/// A piece and what is its own: its items and nodes.
struct Work<'a> {
    piece: Piece,
    triangles: usize,
    items: &'a mut [Item],
    nodes: &'a mut [Item],
    below: &'a mut [[u32; 2]],
    /// Whether to split what is left, too; else it is in `left`.
    all: bool,
    left: [Option<Piece>; 2],
    done: usize,
}

/// Pieces that wait.
struct Waiting {
    pieces: [Option<Piece>; WAITING],
    count: usize,
}

impl Waiting {
    fn push(&mut self, piece: Piece) {
        self.pieces[self.count] = Some(piece);
        self.count += 1;
    }

    fn pop(&mut self) -> Option<Piece> {
        self.count = self.count.checked_sub(1)?;
        self.pieces[self.count]
    }
}

/// What is left of some records.
struct Rest<'a, T> {
    records: &'a mut [T],
    at: usize,
}

impl<'a, T> Rest<'a, T> {
    /// Records by their places among all; those before are not taken any more.
    fn take(&mut self, first: usize, len: usize) -> &'a mut [T] {
        cut(&mut self.records, first - self.at);
        self.at = first + len;
        cut(&mut self.records, len)
    }
}

/// Builds it over the items in the first half of `boxes`, two at least.
pub fn build<'a>(
    boxes: &'a mut [Item],
    below: &'a mut [[u32; 2]],
    control: &mut Control<'_>,
) -> Result<Binary<'a>, Error> {
    let n = below.len() + 1;
    let (items, nodes) = boxes.split_at_mut(n);
    let mut pieces: Parts<Piece> = [const { None }; TASKS];
    pieces[0] = Some(Piece { first: 0, part: Part::of(items), depth: 0, above: NONE });
    // So that fewer than half of the tasks leave two pieces.
    let share = FEW.max(2 * n / TASKS + 1);
    let mut done = 0;
    while pieces[0].is_some() {
        let mut items = Rest { records: &mut *items, at: 0 };
        let mut nodes = Rest { records: &mut *nodes, at: 0 };
        let mut below = Rest { records: &mut *below, at: 0 };
        let mut waiting = pieces.iter().map_while(Option::as_ref);
        let mut works = parts(|| {
            let piece = *waiting.next()?;
            let (first, len) = (piece.first, piece.part.len);
            Some(Work {
                piece,
                triangles: n,
                items: items.take(first, len),
                nodes: nodes.take(first, len - 1),
                below: below.take(first, len - 1),
                all: len <= share,
                left: [None; 2],
                done: 0,
            })
        });
        control.each(&mut works, Work::run)?;
        pieces = [const { None }; TASKS];
        let mut next = pieces.iter_mut();
        for work in works.iter().map_while(Option::as_ref) {
            control.count(work.done);
            done += if work.all { work.items.len() } else { 0 };
            for (left, to) in work.left.iter().flatten().zip(next.by_ref()) {
                *to = Some(*left);
            }
        }
        control.at(done, n)?;
    }
    let mut tree = Binary { triangles: n, boxes, below, root: NONE };
    link(&mut tree);
    Ok(tree)
}

/// Tells each node what is below it: the node above is known.
fn link(tree: &mut Binary<'_>) {
    let n = tree.triangles as u32;
    for i in n..2 * n - 1 {
        let above = tree.above(i);
        if above == NONE {
            tree.root = i;
        } else {
            tree.below[(above - n) as usize][usize::from(i > above)] = i;
        }
    }
}

impl Work<'_> {
    fn run(&mut self) {
        let mut bins = Bins::new();
        let mut waiting = Waiting { pieces: [const { None }; WAITING], count: 0 };
        waiting.push(self.piece);
        while let Some(piece) = waiting.pop() {
            self.split(&piece, &mut waiting, &mut bins);
            if !self.all {
                break;
            }
        }
        for (to, left) in self.left.iter_mut().zip(&waiting.pieces[..waiting.count]) {
            *to = *left;
        }
    }

    /// Makes a node of a piece; what is left of it waits.
    #[inline(never)]
    fn split(&mut self, piece: &Piece, waiting: &mut Waiting, bins: &mut Bins) {
        let Piece { first, part, depth, above } = *piece;
        let start = self.piece.first;
        let items = &mut self.items[first - start..][..part.len];
        self.done += part.len;
        let parts = split(items, &part, depth < CHOSEN, bins);
        let len = parts[0].len;
        let border = first + len - 1;
        let node = (self.triangles + border) as u32;
        let to = &mut self.nodes[border - start];
        to.set_corners(part.lo, part.hi);
        to.set_number(part.len as u32);
        to.set_above(above);
        // The smaller part is split first, so that at most one a power of two waits; what is left
        // to others is in order.
        let small = usize::from(!self.all || parts[1].len < len);
        for side in [1 - small, small] {
            let (part, first) = (parts[side], first + side * len);
            if part.len > 1 {
                waiting.push(Piece { first, part, depth: depth + 1, above: node });
            } else {
                self.items[first - start].set_above(node);
                self.below[border - start][side] = first as u32;
            }
        }
    }
}
