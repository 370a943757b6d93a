//! From a binary tree to nodes of eight parts: those that cost least of all (Ylitie, Karras &
//! Laine 2017), by dynamic programming.

use super::binary::{Binary, NONE};
use super::costs::{Costs, cheapest, joined, of_triangle};
use crate::Error;
use crate::arena::node::{LEAF, Node, PARTS};
use crate::build::control::Control;

/// The costs of all nodes of a binary tree.
pub struct Collapse<'a, 'b> {
    tree: Binary<'b>,
    costs: &'a mut [Costs],
    /// Whether nodes are to be few, whatever they cost.
    few: bool,
}

impl<'a, 'b> Collapse<'a, 'b> {
    /// With the costs that are known.
    pub fn new(tree: Binary<'b>, costs: &'a mut [Costs]) -> Self {
        Self { tree, costs, few: false }
    }

    /// Counts the costs: of every node after those below.
    pub fn count_all(&mut self, control: &mut Control<'_>) -> Result<(), Error> {
        let all = self;
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
        Ok(())
    }

    pub fn root(&self) -> u32 {
        self.tree.root
    }

    /// From now on the largest part of a node is parted next, while there is room: one without
    /// nodes below then holds nine triangles at least, and one with such has eight parts.
    pub fn keep_few(&mut self) {
        self.few = true;
    }

    /// Triangles below a box.
    pub fn len(&self, i: u32) -> u32 {
        if self.tree.below(i).is_some() { self.tree.number(i) } else { 1 }
    }

    #[inline(never)]
    fn costs(&self, i: u32) -> Costs {
        match self.costs.get((i as usize).wrapping_sub(self.tree.triangles)) {
            Some(costs) => *costs,
            None => of_triangle(self.tree.surface(i)),
        }
    }

    fn count(&mut self, node: u32, below: [u32; 2]) {
        let [a, b] = below.map(|i| self.len(i));
        self.tree.set_number(node, a + b);
        let costs = below.map(|i| self.costs(i));
        let costs = joined(self.tree.surface(node), a + b, costs, [a == 1, b == 1]);
        self.costs[node as usize - self.tree.triangles] = costs;
    }

    /// The parts of a node: the boxes that they are in the binary tree.
    #[inline(never)]
    fn parts(&self, node: u32) -> ([u32; PARTS], usize) {
        if self.few {
            return self.large_parts(node);
        }
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

    /// The same, where nodes are to be few.
    fn large_parts(&self, node: u32) -> ([u32; PARTS], usize) {
        let (mut found, mut count) = ([node; PARTS], 1);
        while count < PARTS {
            let size = |i: usize| self.tree.surface(found[i]);
            let large = (0..count).filter(|&i| self.len(found[i]) > LEAF);
            let Some(i) = large.reduce(|a, b| if size(b) > size(a) { b } else { a }) else {
                break;
            };
            let Some(below) = self.tree.below(found[i]) else { break };
            [found[i], found[count]] = below;
            count += 1;
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

#[cfg(test)]
mod tests {
    use super::super::binary::tests::{boxes, built};
    use super::super::costs::{OF_NODE, of_leaf};
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
            len @ ..=LEAF => f64::from(of_leaf(tree.tree.surface(part), len)),
            _ => greedy(tree, part),
        });
        below.sum::<f64>() + f64::from(size(node) * OF_NODE)
    }

    /// The cost of what a node was made.
    fn made(tree: &Collapse<'_, '_>, node: u32) -> f64 {
        let (parts, count) = tree.parts(node);
        let below = parts[..count].iter().map(|&part| match tree.len(part) {
            len @ ..=LEAF => f64::from(of_leaf(tree.tree.surface(part), len)),
            _ => made(tree, part),
        });
        below.sum::<f64>() + f64::from(tree.tree.surface(node) * OF_NODE)
    }

    #[test]
    fn no_dearer_than_greedy_and_what_was_counted() {
        for seed in 0..5 {
            let (mut boxes, mut below) = (boxes(seed, 900), vec![[0; 2]; 899]);
            let mut costs = vec![[0.0; PARTS]; 899];
            let mut control = Control::default();
            let mut tree = Collapse::new(built(&mut boxes, &mut below), &mut costs);
            tree.count_all(&mut control).expect("not cancelled");
            let (made, greedy) = (made(&tree, tree.root()), greedy(&tree, tree.root()));
            let counted = f64::from(tree.costs(tree.root())[0]);
            assert!((made / counted - 1.0).abs() < 1e-4, "{made} {counted}");
            assert!(made < greedy, "{made} {greedy}");
        }
    }
}
