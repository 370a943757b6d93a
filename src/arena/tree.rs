//! Deciding whether untrusted nodes are a tree over all triangles.
//!
//! Nodes and triangles are named one after the other (`node`), so that one pass with
//! two counters tells that each has one place, and where each level of the tree ends.

use super::node::{AnyNode, LEAF, LEAF_SHIFT, MAX_DEPTH, NODE, NODE_SHIFT};
use crate::Error;

/// Checks the nodes of an arena of so many triangles. What their boxes say does not matter: any
/// numbers lead to a part or past it.
pub fn check<N: AnyNode>(nodes: &[N], triangles: u64) -> Result<(), Error> {
    if nodes.is_empty() {
        return Ok(());
    }
    if triangles < u64::from(LEAF) {
        return Err(Error::Corrupt);
    }
    let (mut next, mut first) = (1u64, 0u64);
    let (mut depth, mut level_end) = (1, 1);
    for (number, node) in (0..).zip(nodes) {
        if number == level_end {
            (depth, level_end) = (depth + 1, next);
        }
        // Nothing before it has named this node, or the way to it is too long.
        if number >= next || depth > MAX_DEPTH || !node.is_clean() {
            return Err(Error::Corrupt);
        }
        let mut parts = *node.parts();
        parts.sort_unstable();
        for part in parts {
            let expected = match part & NODE {
                NODE => {
                    next += 1;
                    (next - 1) << NODE_SHIFT | u64::from(NODE)
                }
                0 => 0,
                count @ 1..=LEAF => {
                    first += u64::from(count);
                    (first - u64::from(count)) << LEAF_SHIFT | u64::from(count)
                }
                _ => return Err(Error::Reference),
            };
            if u64::from(part) != expected {
                return Err(Error::Reference);
            }
        }
    }
    if next != nodes.len() as u64 || first != triangles {
        return Err(Error::Reference);
    }
    Ok(())
}
