//! Which numbers nodes and triangles get: level by level, in the order in which they are named.

use super::MARGIN;
use super::collapse::Collapse;
use crate::Error;
use crate::arena::node::{LEAF, LEAF_SHIFT, NODE, NODE_SHIFT, Node, PARTS};
use crate::build::control::{Control, TASKS, parts};
use crate::build::scratch::cut;

/// Nodes of a task.
const SHARE: usize = 32;

/// Nodes of a level, made by one task, and what they name.
struct Share<'a> {
    nodes: &'a mut [Node],
    /// What the nodes are in the binary tree.
    known: &'a [u32],
    named: Named,
}

/// What is named, or named so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Named {
    pub nodes: usize,
    pub triangles: usize,
    /// Triangles in leaves whose boxes have twice the surface with a descent's margins, or more.
    pub tiny: usize,
}

/// What the numbers after those of a level are for.
pub struct Rest<'a> {
    pub known: &'a mut [u32],
    pub order: &'a mut [u32],
}

/// Half the surface of a box.
fn surface([x, y, z]: [f64; 3]) -> f64 {
    x * y + y * z + z * x
}

/// Makes the nodes of a level and names what is below them, from the numbers of `before` on;
/// `None` if there is not enough room for all.
pub fn level(
    tree: &Collapse<'_, '_>,
    mut nodes: &mut [Node],
    known: &[u32],
    before: Named,
    mut rest: Rest<'_>,
    control: &mut Control<'_>,
) -> Result<Option<Named>, Error> {
    let share = SHARE.max(nodes.len().div_ceil(TASKS));
    let mut some = known.chunks(share);
    let mut shares = parts(|| {
        let known = some.next()?;
        Some(Share { nodes: cut(&mut nodes, known.len()), known, named: Named::default() })
    });
    control.each(&mut shares, |share| {
        for (node, i) in share.nodes.iter_mut().zip(share.known) {
            *node = tree.node(*i);
            count(node, &mut share.named);
        }
    })?;
    let mut named = before;
    let mut to_name = shares.iter_mut().flatten();
    let mut tasks = parts(|| {
        let share = to_name.next()?;
        let Named { nodes, triangles, tiny } = share.named;
        let first = named;
        named.nodes += nodes;
        named.triangles += triangles;
        named.tiny += tiny;
        // Fewer than that if there is no room for all.
        let nodes = nodes.min(rest.known.len());
        let known = cut(&mut rest.known, nodes);
        let order = cut(&mut rest.order, triangles);
        Some((share, first, Rest { known, order }))
    });
    // Names are given only if there are enough.
    if tasks.iter().flatten().any(|(share, _, rest)| rest.known.len() < share.named.nodes) {
        return Ok(None);
    }
    control.each(&mut tasks, |(share, first, rest)| {
        for node in &mut *share.nodes {
            name(tree, node, first, rest);
            arrange(node);
        }
    })?;
    Ok(Some(named))
}

/// The sides of the box of a node's part.
fn sides(node: &Node, part: usize) -> [f64; 3] {
    let bound = |row: usize| f64::from(node.bounds[row][part]);
    [0, 1, 2].map(|k| bound(2 * k + 1) - bound(2 * k))
}

/// Counts what the parts of a node are, by the numbers of their triangles.
fn count(node: &Node, named: &mut Named) {
    for (i, &len) in node.parts.iter().enumerate() {
        if len > LEAF {
            named.nodes += 1;
        } else if len > 0 {
            named.triangles += len as usize;
            let met = surface(sides(node, i).map(|side| side + 2.0 * MARGIN));
            if met > 2.0 * surface(sides(node, i)) {
                named.tiny += len as usize;
            }
        }
    }
}

/// Gives the parts of a node their places. A part is the number of its triangles until then, and in
/// the word that is reserved is which box of the binary tree it is.
fn name(tree: &Collapse<'_, '_>, node: &mut Node, next: &mut Named, rest: &mut Rest<'_>) {
    for (part, reserved) in node.parts.iter_mut().zip(&mut node.reserved) {
        let (len, i) = (*part, core::mem::take(reserved));
        if len > LEAF {
            cut(&mut rest.known, 1)[0] = i;
            *part = (next.nodes as u32) << NODE_SHIFT | NODE;
            next.nodes += 1;
        } else if len > 0 {
            tree.triangles(i, cut(&mut rest.order, len as usize));
            *part = (next.triangles as u32) << LEAF_SHIFT | len;
            next.triangles += len as usize;
        }
    }
}

/// Puts the largest part of a node first: where any hit will do, it is most likely to be there
/// (surface area traversal order, Nah & Manocha 2014).
fn arrange(node: &mut Node) {
    let Node { bounds, parts, .. } = *node;
    let mut order = [(0.0, 0); PARTS];
    for (i, &part) in parts.iter().enumerate() {
        let size = if part != 0 { surface(sides(node, i)) } else { -1.0 };
        let mut to = i;
        while to > 0 && order[to - 1].0 < size {
            order[to] = order[to - 1];
            to -= 1;
        }
        order[to] = (size, i);
    }
    for (to, &(_, from)) in order.iter().enumerate() {
        node.parts[to] = parts[from];
        for (row, bounds) in node.bounds.iter_mut().zip(&bounds) {
            row[to] = bounds[from];
        }
    }
}
