//! From a binary tree to nodes of eight parts: those that cost least of all (Ylitie, Karras &
//! Laine 2017), by dynamic programming.

use super::binary::{Binary, NONE};
use crate::Error;
use crate::arena::layout::{LEAF, Node, PARTS};
use crate::build::control::Control;

/// What it costs to meet a node, a leaf and each triangle of it, in instructions.
const OF_NODE: f32 = 67.0;
const OF_LEAF: f32 = 190.0;
const OF_TRIANGLE: f32 = 3.0;

/// The least cost of what is below a box, times its surface, as one part, two at most, and so
/// on.
pub type Costs = [f32; PARTS - 1];

/// The costs of all nodes of a binary tree.
pub struct Collapse<'a, 'b> {
    tree: Binary<'b>,
    costs: &'a mut [Costs],
}

impl<'a, 'b> Collapse<'a, 'b> {
    /// Looks at every node after those below.
    pub fn new(
        tree: Binary<'b>,
        costs: &'a mut [Costs],
        control: &mut Control<'_>,
    ) -> Result<Self, Error> {
        let mut all = Self { tree, costs };
        // Down to the node at hand, or up from what is below it.
        let (mut node, mut from) = (all.tree.root, NONE);
        while let Some([a, b]) = all.tree.below(node) {
            let next = if from == all.tree.above(node) {
                a
            } else if from == a {
                b
            } else {
                all.count(node, [a, b]);
                control.tick(1, 0, 1)?;
                (from, node) = (node, all.tree.above(node));
                continue;
            };
            if all.tree.below(next).is_some() {
                (from, node) = (node, next);
            } else {
                from = next;
            }
        }
        Ok(all)
    }

    pub fn root(&self) -> u32 {
        self.tree.root
    }

    /// Triangles below a box.
    pub fn len(&self, i: u32) -> u32 {
        if self.tree.below(i).is_some() { self.tree.number(i) } else { 1 }
    }

    fn leaf(&self, i: u32, len: u32) -> f32 {
        self.tree.surface(i) * (OF_LEAF + OF_TRIANGLE * len as f32)
    }

    #[inline(never)]
    fn costs(&self, i: u32) -> Costs {
        match self.costs.get((i as usize).wrapping_sub(self.tree.triangles)) {
            Some(costs) => *costs,
            None => [self.leaf(i, 1); PARTS - 1],
        }
    }

    fn count(&mut self, node: u32, below: [u32; 2]) {
        let len = self.len(below[0]) + self.len(below[1]);
        self.tree.set_number(node, len);
        let [a, b] = below.map(|i| self.costs(i));
        let mut costs = [0.0; PARTS - 1];
        costs[0] = if len <= LEAF {
            self.leaf(node, len)
        } else {
            self.tree.surface(node) * OF_NODE + cheapest(&a, &b, PARTS).0
        };
        for parts in 2..PARTS {
            costs[parts - 1] = costs[0].min(cheapest(&a, &b, parts).0);
        }
        self.costs[node as usize - self.tree.triangles] = costs;
    }

    /// The parts of a node: the boxes that they are in the binary tree.
    #[inline(never)]
    fn parts(&self, node: u32) -> ([u32; PARTS], usize) {
        let (mut found, mut count) = ([0; PARTS], 0);
        let mut waiting = [(node, PARTS); PARTS];
        let mut left = 1;
        while left > 0 {
            left -= 1;
            let (i, parts) = waiting[left];
            let costs = self.costs(i);
            let split = parts == PARTS || parts > 1 && costs[parts - 1] < costs[0];
            match self.tree.below(i) {
                Some([a, b]) if split => {
                    let (_, first) = cheapest(&self.costs(a), &self.costs(b), parts);
                    waiting[left] = (b, parts - first);
                    waiting[left + 1] = (a, first);
                    left += 2;
                }
                _ => {
                    found[count] = i;
                    count += 1;
                }
            }
        }
        (found, count)
    }

    /// A node. Its parts have no places yet: they are how many triangles there are, and, in the
    /// words that are reserved, which boxes of the binary tree.
    #[inline(never)]
    pub fn node(&self, i: u32) -> Node {
        let (parts, count) = self.parts(i);
        let (lo, hi) = ([f32::INFINITY; PARTS], [f32::NEG_INFINITY; PARTS]);
        let mut node =
            Node { bounds: [lo, hi, lo, hi, lo, hi], parts: [0; PARTS], reserved: [0; PARTS] };
        for (at, &part) in parts[..count].iter().enumerate() {
            let (lo, hi) = self.tree.corners(part);
            for k in 0..3 {
                (node.bounds[2 * k][at], node.bounds[2 * k + 1][at]) = (lo[k], hi[k]);
            }
            (node.parts[at], node.reserved[at]) = (self.len(part), part);
        }
        node
    }

    /// The triangles below a box, as many as there is room for.
    pub fn triangles(&self, i: u32, to: &mut [u32]) {
        let mut waiting = [i; LEAF as usize + 1];
        let mut left = 1;
        for to in to {
            left -= 1;
            while let Some([a, b]) = self.tree.below(waiting[left]) {
                (waiting[left], waiting[left + 1]) = (b, a);
                left += 1;
            }
            *to = self.tree.number(waiting[left]);
        }
    }
}

/// The least cost of two boxes in so many parts, and how many of these the first has.
#[inline(never)]
fn cheapest(a: &Costs, b: &Costs, parts: usize) -> (f32, usize) {
    let mut best = (f32::INFINITY, 1);
    for first in 1..parts {
        let cost = a[first - 1] + b[parts - first - 1];
        if cost < best.0 {
            best = (cost, first);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::super::binary::tests::boxes;
    use super::super::split::Care;
    use super::*;
    use std::{vec, vec::Vec};

    /// By surface, the cost of what is below a node if the largest part is always split next.
    fn greedy(tree: &Collapse<'_, '_>, node: u32) -> f64 {
        let size = |i: u32| tree.tree.surface(i);
        let mut parts: Vec<u32> = vec![node];
        while parts.len() < PARTS {
            let large = (0..parts.len()).filter(|&k| tree.len(parts[k]) > LEAF);
            let Some(k) = large.max_by(|&a, &b| size(parts[a]).total_cmp(&size(parts[b]))) else {
                break;
            };
            let part = parts.swap_remove(k);
            parts.extend(tree.tree.below(part).into_iter().flatten());
        }
        let below = parts.into_iter().map(|part| match tree.len(part) {
            len @ ..=LEAF => f64::from(tree.leaf(part, len)),
            _ => greedy(tree, part),
        });
        below.sum::<f64>() + f64::from(size(node) * OF_NODE)
    }

    /// The cost of what a node was made.
    fn made(tree: &Collapse<'_, '_>, node: u32) -> f64 {
        let (parts, count) = tree.parts(node);
        let below = parts[..count].iter().map(|&part| match tree.len(part) {
            len @ ..=LEAF => f64::from(tree.leaf(part, len)),
            _ => made(tree, part),
        });
        below.sum::<f64>() + f64::from(tree.tree.surface(node) * OF_NODE)
    }

    #[test]
    fn no_dearer_than_greedy_and_what_was_counted() {
        for seed in 0..5 {
            let (mut boxes, mut below) = (boxes(seed, 900), vec![[0; 2]; 899]);
            let mut costs = vec![[0.0; PARTS - 1]; 899];
            let mut control = Control::default();
            let tree = Binary::build(&mut boxes, &mut below, Care::HIGH, &mut control);
            let tree = Collapse::new(tree.expect("a tree"), &mut costs, &mut control);
            let tree = tree.expect("not cancelled");
            let (made, greedy) = (made(&tree, tree.root()), greedy(&tree, tree.root()));
            let counted = f64::from(tree.costs(tree.root())[0]);
            assert!((made / counted - 1.0).abs() < 1e-4, "{made} {counted}");
            assert!(made < greedy, "{made} {greedy}");
        }
    }
}
