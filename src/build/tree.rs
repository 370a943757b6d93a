//! The tree of boxes: nodes of eight parts and leaves of up to eight triangles.
//!
//! A binary tree over single triangles comes first. At the default quality it is joined from
//! below (`below`): triangles lie along a Morton curve (`curve`), and of those near each other
//! there (`near`) the two whose box is least become a node, in rounds. With care it is split from
//! above (`above`, `split`), which rays find a little better and takes three times as long, and
//! subtrees are moved to where they cost less (`reinsert`). Either way its nodes become the nodes
//! of eight parts that cost least (`costs`, `collapse`) or, should these be too many, those of the
//! largest parts; numbers are given level by level (`numbers`). Should they then be too many still,
//! or too deep, there is no tree. Compact arenas get its nodes in less (`quantize`).
//! What is cut into tasks does not depend on who does them, nor does the tree.

mod above;
mod below;
mod binary;
mod collapse;
mod costs;
mod curve;
mod item;
mod near;
mod numbers;
mod quantize;
mod reinsert;
mod rows;
mod split;

use super::control::Control;
use super::frame::unit;
use super::gather::Soup;
use super::scratch::Scratch;
use crate::Error;
use crate::arena::node::{LEAF_SHIFT, MAX_DEPTH, NODE_SHIFT, Node, TREE_UNITS};
use collapse::Collapse;
use costs::Costs;
use curve::{Key, sorted};
use item::{Frame, Item, items};
use numbers::{Named, Rest, level};
pub use quantize::quantize;
use reinsert::reinsert;
use rows::{Rows, WORDS};

/// Triangles above which parts' places do not fit a node's words.
pub const MOST: usize = 1 << (32 - LEAF_SHIFT);

// Nor are there more nodes than that.
const _: () = assert!(capacity(MOST - 1) < 1 << (32 - NODE_SHIFT));

/// By how much a descent meets boxes early and late, where the ray begins in the scene
/// (`trace::descent`).
const MARGIN: f64 = 3.0 / (1 << 20) as f64;

/// Most nodes over so many triangles. One without nodes below holds nine triangles at least,
/// but for the root; one with such has eight parts, so these are a seventh of all leaves.
pub const fn capacity(triangles: usize) -> usize {
    if triangles == 0 || triangles >= MOST { 0 } else { triangles / 9 + triangles / 7 + 2 }
}

/// Bytes for a tree's nodes, and those that are needed only while it is built.
pub fn records(triangles: usize) -> [(usize, usize); 3] {
    let binary = 2 * size_of::<Item>() + size_of::<[u32; 2]>() + size_of::<Costs>();
    let nodes = capacity(triangles);
    [(nodes, size_of::<Node>()), (nodes, size_of::<u32>()), (triangles, binary)]
}

// Twice what is to be joined, and keys in place of once that, fit in the memory of nodes: for nine
// and for seven triangles there is one, and two more.
const _: () =
    assert!(16 * size_of::<Node>() / 4 >= 63 * 2 * WORDS && 4 * WORDS == size_of::<[Key; 2]>());

/// Builds the tree over all triangles of a soup of two or more, and orders them as its leaves
/// are; with `care`, better and later. `nodes` are at least [`capacity`]; what else is needed
/// is of no use afterwards. Where most triangles are in leaves so small beside the scene's
/// extent that the descent's margins, which are in proportion to that, double their boxes'
/// surface, there are no nodes: grids have coordinates of their own.
pub fn build<'s>(
    soup: &Soup<'_>,
    nodes: &'s mut [Node],
    order: &mut [u32],
    care: bool,
    mut scratch: Scratch<'_>,
    control: &mut Control<'_>,
) -> Result<&'s [Node], Error> {
    if !TREE_UNITS.contains(&unit(&soup.bounds)) {
        return Ok(&[]);
    }
    let n = soup.triangles.len();
    let boxes = scratch.take::<Item>(2 * n - 1)?;
    let below = scratch.take::<[u32; 2]>(n - 1)?;
    let costs = scratch.take::<Costs>(n - 1)?;
    let known = scratch.take::<u32>(nodes.len())?;
    let frame = Frame::new(&soup.bounds);
    // Keys are in the first half of what is needed, the sorted ones behind the others.
    let (keys, words) = bytemuck::cast_slice_mut::<Node, u32>(nodes).split_at_mut(WORDS * n);
    let mut now = Rows::new(&mut words[..WORDS * n]);
    control.pass(0.16)?;
    let sorted = sorted(soup, &frame, bytemuck::cast_slice_mut(keys), control)?;
    control.pass(0.2)?;
    items(soup, &frame, sorted, (&mut boxes[..n], &mut now), control)?;
    let rows = [now, Rows::new(keys)];
    control.pass(0.34)?;
    let tree = if care {
        let mut tree = above::build(boxes, below, control)?;
        reinsert(&mut tree, order, control)?;
        tree
    } else {
        below::build(boxes, below, rows, order, costs, control)?
    };
    let mut tree = Collapse::new(tree, costs);
    if care {
        tree.count_all(control)?;
    }
    control.pass(0.4)?;
    let mut found = collapse(&tree, nodes, known, order, control)?;
    if found.is_none() {
        tree.keep_few();
        found = collapse(&tree, nodes, known, order, control)?;
    }
    Ok(match found {
        Some(named) if 2 * named.tiny <= n => &nodes[..named.nodes],
        _ => &[],
    })
}

/// Writes the nodes of a binary tree, and the order of triangles; `known` is for what nodes were in
/// the binary tree, as many as there may be. `None` if they are too many or too deep.
fn collapse(
    tree: &Collapse<'_, '_>,
    nodes: &mut [Node],
    known: &mut [u32],
    order: &mut [u32],
    control: &mut Control<'_>,
) -> Result<Option<Named>, Error> {
    known[0] = tree.root();
    let (mut all, mut depth) = (0..1, 0);
    let mut named = Named { nodes: 1, ..Named::default() };
    while !all.is_empty() {
        if depth == MAX_DEPTH {
            return Ok(None);
        }
        let (above, known) = known.split_at_mut(all.end);
        let rest = Rest { known, order: &mut order[named.triangles..] };
        let some = &mut nodes[all.clone()];
        let Some(all_named) = level(tree, some, &above[all.clone()], named, rest, control)? else {
            return Ok(None);
        };
        named = all_named;
        control.count(all.len());
        control.at(named.triangles, tree.len(tree.root()) as usize)?;
        all = all.end..named.nodes;
        depth += 1;
    }
    Ok(Some(named))
}

#[cfg(test)]
mod tests {
    use super::binary::tests::{boxes, built};
    use super::*;
    use bytemuck::Zeroable;
    use std::{vec, vec::Vec};

    /// Where the nodes of least cost are more than there is room for, fewer are made.
    #[test]
    fn too_many_nodes() {
        const COUNT: usize = 900;
        let (mut boxes, mut below) = (boxes(1, COUNT), vec![[0; 2]; COUNT - 1]);
        let mut costs = vec![[0.0; 8]; COUNT - 1];
        let (mut order, mut known) = (vec![0; COUNT], vec![0; capacity(COUNT)]);
        let mut nodes = vec![Node::zeroed(); capacity(COUNT)];
        let mut control = Control::default();
        let mut tree = built(&mut boxes, &mut below);
        reinsert(&mut tree, &mut order, &mut control).expect("not cancelled");
        let mut tree = Collapse::new(tree, &mut costs);
        tree.count_all(&mut control).expect("not cancelled");
        let found = collapse(&tree, &mut nodes, &mut known[..9], &mut order, &mut control);
        assert_eq!(found, Ok(None));
        tree.keep_few();
        let found = collapse(&tree, &mut nodes, &mut known, &mut order, &mut control);
        let named = found.expect("not cancelled").expect("few");
        assert_eq!(named.triangles, COUNT);
        assert!((9..=capacity(COUNT)).contains(&named.nodes));
        order.sort_unstable();
        assert_eq!(order, (0..COUNT as u32).collect::<Vec<_>>());
    }
}
