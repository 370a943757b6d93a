//! A binary tree over single triangles, built from above, that can be changed.
//!
//! What is split between items b and b + 1 is node b (Karras 2012 numbers a tree along a curve
//! so): each part of the items has nodes of its own, whoever splits it, and of a node and one
//! below it the lower is to the left.

use super::MOST;
use super::item::Item;
use super::split::{Bins, Care, Part, split, surface};
use crate::Error;
use crate::build::control::{Control, Parts, TASKS, parts};
use crate::build::scratch::cut;
use glam::Vec3A;

/// Levels of nodes whose splits are chosen; below, triangles are halved.
const CHOSEN: u32 = 96;
/// Triangles that it is no use to share.
const FEW: usize = 1024;
/// Pieces that wait: one for each power of two below the most triangles, and one.
const WAITING: usize = MOST.ilog2() as usize + 1;
/// What the root is under.
pub const NONE: u32 = (1 << 30) - 1;

/// The tree. The boxes of the triangles, as many as `triangles`, are followed by those of the
/// nodes, one fewer; a box is known by its place among all.
pub struct Binary<'a> {
    pub triangles: usize,
    boxes: &'a mut [Item],
    /// The two boxes below each node.
    below: &'a mut [[u32; 2]],
    pub root: u32,
}

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

impl<'a> Binary<'a> {
    /// Builds it over the items in the first half of `boxes`, two at least.
    pub fn build(
        boxes: &'a mut [Item],
        below: &'a mut [[u32; 2]],
        care: Care,
        control: &mut Control<'_>,
    ) -> Result<Self, Error> {
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
            control.each(&mut works, |work| work.run(care))?;
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
        let mut tree = Self { triangles: n, boxes, below, root: NONE };
        tree.link();
        Ok(tree)
    }

    /// Tells each node what is below it: the node above is known.
    fn link(&mut self) {
        let n = self.triangles as u32;
        for i in n..2 * n - 1 {
            let above = self.above(i);
            if above == NONE {
                self.root = i;
            } else {
                self.below[(above - n) as usize][usize::from(i > above)] = i;
            }
        }
    }

    #[inline(always)]
    pub fn corners(&self, i: u32) -> (Vec3A, Vec3A) {
        self.boxes[i as usize].corners()
    }

    /// Half the surface of a box.
    pub fn surface(&self, i: u32) -> f32 {
        let (lo, hi) = self.corners(i);
        surface(lo, hi)
    }

    /// What is below a box; `None` for a triangle.
    #[inline(always)]
    pub fn below(&self, i: u32) -> Option<[u32; 2]> {
        self.below.get((i as usize).wrapping_sub(self.triangles)).copied()
    }

    #[inline(always)]
    pub fn above(&self, i: u32) -> u32 {
        self.boxes[i as usize].above()
    }

    /// How many triangles a node holds; a triangle's place in the soup.
    pub fn number(&self, i: u32) -> u32 {
        self.boxes[i as usize].number()
    }

    pub fn set_number(&mut self, i: u32, number: u32) {
        self.boxes[i as usize].set_number(number);
    }

    /// The box beside one that is not the root.
    #[inline(never)]
    pub fn beside(&self, i: u32) -> u32 {
        let [a, b] = self.below[self.above(i) as usize - self.triangles];
        a ^ b ^ i
    }

    /// Puts a box below a node in the place of another.
    pub fn replace(&mut self, node: u32, old: u32, new: u32) {
        let below = &mut self.below[node as usize - self.triangles];
        below[usize::from(below[1] == old)] = new;
        self.boxes[new as usize].set_above(node);
    }

    /// Puts two boxes below a node.
    pub fn join(&mut self, node: u32, below: [u32; 2]) {
        self.below[node as usize - self.triangles] = below;
        for i in below {
            self.boxes[i as usize].set_above(node);
        }
    }

    /// Makes the box of a node that of what is below; whether it was another.
    #[inline(never)]
    pub fn fit(&mut self, node: u32) -> bool {
        let [a, b] = self.below[node as usize - self.triangles].map(|i| self.corners(i));
        let (lo, hi) = (a.0.min(b.0), a.1.max(b.1));
        let old = self.corners(node);
        let new = &mut self.boxes[node as usize];
        new.set_corners(lo, hi);
        (lo.cmpne(old.0) | hi.cmpne(old.1)).any()
    }
}

impl Work<'_> {
    fn run(&mut self, care: Care) {
        let mut bins = Bins::new();
        let mut waiting = Waiting { pieces: [const { None }; WAITING], count: 0 };
        waiting.push(self.piece);
        while let Some(piece) = waiting.pop() {
            self.split(&piece, &mut waiting, care, &mut bins);
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
    fn split(&mut self, piece: &Piece, waiting: &mut Waiting, care: Care, bins: &mut Bins) {
        let Piece { first, part, depth, above } = *piece;
        let start = self.piece.first;
        let items = &mut self.items[first - start..][..part.len];
        self.done += part.len;
        let parts = split(items, &part, (depth < CHOSEN).then_some(care), bins);
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

#[cfg(test)]
pub mod tests {
    use super::*;
    use bytemuck::Zeroable;
    use std::{vec, vec::Vec};

    /// So many small boxes at random, some flat, and room for those of nodes.
    pub fn boxes(seed: u32, count: usize) -> Vec<Item> {
        let mut state = seed.wrapping_mul(747_796_405) + 1;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 24) as f32
        };
        let mut boxes = vec![Item::zeroed(); 2 * count - 1];
        for (i, item) in boxes[..count].iter_mut().enumerate() {
            let lo = Vec3A::new(next(), next(), next());
            let size = Vec3A::new(next(), next(), if i % 3 == 0 { 0.0 } else { next() });
            item.set_corners(lo, lo + size * 0.1);
            item.set_number(i as u32);
        }
        boxes
    }

    /// The sum of all nodes' surfaces; each triangle is in the tree once, and boxes fit.
    pub fn total(tree: &mut Binary<'_>) -> f64 {
        let (mut sum, mut seen) = (0.0, vec![false; tree.triangles]);
        let mut waiting = vec![tree.root];
        while let Some(i) = waiting.pop() {
            if let Some(below) = tree.below(i) {
                assert!(below.iter().all(|&part| tree.above(part) == i));
                assert!(!tree.fit(i));
                sum += f64::from(tree.surface(i));
                waiting.extend(below);
            } else {
                let number = tree.number(i) as usize;
                assert!(!core::mem::replace(&mut seen[number], true));
            }
        }
        assert!(seen.iter().all(|&seen| seen));
        sum
    }

    #[test]
    fn it_is_a_tree() {
        // More than one task has, too.
        for count in [2, 3, 100, 5000] {
            let (mut boxes, mut below) = (boxes(7, count), vec![[0; 2]; count - 1]);
            let built = Binary::build(&mut boxes, &mut below, Care::HIGH, &mut Control::default());
            let mut tree = built.expect("not cancelled");
            assert_eq!(tree.number(tree.root) as usize, count);
            assert!(total(&mut tree) > 0.0);
        }
    }
}
