//! The tree of boxes: triangles split in two and again, by boxes of least surface, into nodes
//! of eight parts and leaves of up to eight triangles.
//!
//! Splits are those of least expected cost by surface area (MacDonald & Booth 1990) among
//! the borders of a few bins (Wald 2007). A node is split at the part of the largest surface
//! until it has eight parts (`level`). Level by level, a node is a task: its triangles lie
//! together, and those of a level in the order of its nodes. Numbers are given between levels
//! (`numbers`), so the tree does not depend on who did what. Where it becomes deep, triangles
//! are halved instead, so that its depth, and with it the work, is bounded: there are at most
//! [`CHOSEN`] + log2 n levels, and of each a triangle is in at most seven splits.
//!
//! With more care, there is a binary tree first (`binary`), in which subtrees are moved
//! (`reinsert`), and whose nodes are joined to those of least cost (`collapse`). Should that
//! become too deep or too large, it is as if there had been no binary tree.

mod binary;
mod collapse;
mod item;
mod level;
mod numbers;
mod reinsert;
mod split;

use super::control::Control;
use super::frame::unit;
use super::gather::Soup;
use super::scratch::Scratch;
use crate::Error;
use crate::arena::layout::{MAX_DEPTH, Node, PART_SHIFT, TREE_UNITS};
use binary::Binary;
use collapse::{Collapse, Costs};
use item::{Item, items};
use level::split_level;
use numbers::Numbers;
use reinsert::reinsert;

pub use split::Care;

/// Levels of nodes whose splits are chosen; below, triangles are halved.
const CHOSEN: usize = 36;
/// Triangles above which parts' places do not fit a node's words.
pub const MOST: usize = 1 << (32 - PART_SHIFT);

/// By how much a descent meets boxes early and late, where the ray begins in the scene
/// (`trace::descent`).
const MARGIN: f64 = 3.0 / (1 << 20) as f64;

/// Most nodes over so many triangles. One without nodes below holds nine triangles at least,
/// but for the root; one with such has eight parts, so these are a seventh of all leaves.
pub fn capacity(triangles: usize) -> usize {
    if triangles == 0 || triangles >= MOST { 0 } else { triangles / 9 + triangles / 7 + 2 }
}

/// Working memory.
pub struct Memory<'s> {
    items: &'s mut [Item],
    nodes: &'s mut [Node],
    /// Of each node that is named, the first of its items, or what it was in the binary tree,
    /// and the number of its triangles.
    ranges: &'s mut [[u32; 2]],
    below: &'s mut [[u32; 2]],
    costs: &'s mut [Costs],
}

impl<'s> Memory<'s> {
    /// For up to so many triangles, and so many in a binary tree: all or none.
    pub fn take([triangles, binary]: [usize; 2], scratch: &mut Scratch<'s>) -> Result<Self, Error> {
        let nodes = capacity(triangles);
        Ok(Self {
            items: scratch.take(triangles + binary)?,
            nodes: scratch.take(nodes)?,
            ranges: scratch.take(nodes)?,
            below: scratch.take(binary)?,
            costs: scratch.take(binary)?,
        })
    }

    /// Bytes for these.
    pub fn records([triangles, binary]: [usize; 2]) -> [(usize, usize); 3] {
        let nodes = capacity(triangles);
        [
            (triangles, size_of::<Item>()),
            (nodes, size_of::<Node>() + size_of::<[u32; 2]>()),
            (binary, size_of::<Item>() + size_of::<[u32; 2]>() + size_of::<Costs>()),
        ]
    }

    /// Builds the tree over all triangles of a soup of two or more, and orders them as its
    /// leaves are. Where most triangles are in leaves so small beside the scene's extent that
    /// the descent's margins, which are in proportion to that, double their boxes' surface, there
    /// are no nodes: grids have coordinates of their own.
    pub fn build(
        self,
        soup: &Soup<'_>,
        order: &mut [u32],
        care: Care,
        control: &mut Control<'_>,
    ) -> Result<&'s [Node], Error> {
        let Self { items: memory, nodes, ranges, below, costs } = self;
        if !TREE_UNITS.contains(&unit(&soup.bounds)) {
            return Ok(&[]);
        }
        let n = soup.triangles.len();
        items(soup, &mut memory[..n], control)?;
        let mut found = None;
        if !below.is_empty() {
            let (boxes, below) = (&mut memory[..2 * n - 1], &mut below[..n - 1]);
            let mut tree = Binary::build(boxes, below, care, control)?;
            reinsert(&mut tree, order, control)?;
            let tree = Collapse::new(tree, &mut costs[..n - 1], control)?;
            let numbers = Numbers::new([tree.root(), n as u32], ranges, order);
            found = collapse(&tree, nodes, numbers, control)?;
        }
        let [count, tiny] = match found {
            Some(found) => found,
            None => {
                let numbers = Numbers::new([0, n as u32], ranges, order);
                from_above(&mut memory[..n], nodes, numbers, care, control)?
            }
        };
        Ok(if 2 * tiny > n { &[] } else { &nodes[..count] })
    }
}

/// Splits items into nodes; how many there are, and how many triangles are in tiny leaves.
fn from_above(
    items: &mut [Item],
    nodes: &mut [Node],
    mut numbers: Numbers<'_>,
    care: Care,
    control: &mut Control<'_>,
) -> Result<[usize; 2], Error> {
    let (mut level, mut depth) = (0..1, 0);
    while !level.is_empty() {
        let some = &mut nodes[level.clone()];
        let ranges = &numbers.ranges[level.clone()];
        split_level(some, ranges, items, (depth < CHOSEN).then_some(care), control)?;
        for node in some {
            numbers.give(node, &|start, to| {
                for (to, item) in to.iter_mut().zip(&items[start as usize..]) {
                    *to = item.number();
                }
            });
        }
        control.at(numbers.first, items.len())?;
        level = level.end..numbers.next;
        depth += 1;
    }
    Ok([numbers.next, numbers.tiny])
}

/// Writes the nodes of a binary tree; what [`from_above`] says, or `None` if they are too many or too
/// deep.
fn collapse(
    tree: &Collapse<'_, '_>,
    nodes: &mut [Node],
    mut numbers: Numbers<'_>,
    control: &mut Control<'_>,
) -> Result<Option<[usize; 2]>, Error> {
    let (mut level, mut depth) = (0..1, 0);
    while !level.is_empty() {
        if depth == MAX_DEPTH {
            return Ok(None);
        }
        for i in level.clone() {
            let node = &mut nodes[i];
            *node = tree.node(numbers.ranges[i][0]);
            if !numbers.give(node, &|part, to| tree.triangles(part, to)) {
                return Ok(None);
            }
        }
        control.at(numbers.first, tree.len(tree.root()) as usize)?;
        level = level.end..numbers.next;
        depth += 1;
    }
    Ok(Some([numbers.next, numbers.tiny]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::Zeroable;
    use std::{vec, vec::Vec};

    /// Where the nodes of least cost are more than there is room for, triangles are split as if
    /// there had been no binary tree.
    #[test]
    fn too_many_nodes() {
        const COUNT: usize = 900;
        let mut control = Control::default();
        let (mut boxes, mut below) = (binary::tests::boxes(1, COUNT), vec![[0; 2]; COUNT - 1]);
        let mut costs = vec![[0.0; 7]; COUNT - 1];
        let (mut order, mut ranges) = (vec![0; COUNT], vec![[0; 2]; capacity(COUNT)]);
        let mut nodes = vec![Node::zeroed(); capacity(COUNT)];
        let mut tree =
            Binary::build(&mut boxes, &mut below, Care::HIGH, &mut control).expect("not cancelled");
        reinsert(&mut tree, &mut order, &mut control).expect("not cancelled");
        let tree = Collapse::new(tree, &mut costs, &mut control).expect("not cancelled");
        let root = [tree.root(), COUNT as u32];
        let numbers = Numbers::new(root, &mut ranges[..9], &mut order);
        let found = collapse(&tree, &mut nodes, numbers, &mut control);
        assert_eq!(found, Ok(None));
        let numbers = Numbers::new([0, COUNT as u32], &mut ranges, &mut order);
        let [count, _] =
            from_above(&mut boxes[..COUNT], &mut nodes, numbers, Care::HIGH, &mut control)
                .expect("not cancelled");
        assert!((9..=capacity(COUNT)).contains(&count));
        order.sort_unstable();
        assert_eq!(order, (0..COUNT as u32).collect::<Vec<_>>());
    }
}
