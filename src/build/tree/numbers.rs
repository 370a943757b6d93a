//! Which numbers nodes and triangles get.

use super::MARGIN;
use crate::arena::layout::{LEAF, NODE, Node, PART_SHIFT, PARTS};

/// The numbers of nodes and triangles to come.
pub struct Numbers<'a> {
    pub next: usize,
    pub first: usize,
    /// Of each node that has a number, where it is among what it is made of, and its triangles.
    pub ranges: &'a mut [[u32; 2]],
    order: &'a mut [u32],
    /// Triangles in leaves whose boxes have twice the surface with a descent's margins, or more.
    pub tiny: usize,
}

/// Half the surface of a box.
fn surface([x, y, z]: [f64; 3]) -> f64 {
    x * y + y * z + z * x
}

impl<'a> Numbers<'a> {
    /// With a number for the root.
    pub fn new(root: [u32; 2], ranges: &'a mut [[u32; 2]], order: &'a mut [u32]) -> Self {
        ranges[0] = root;
        Self { next: 1, first: 0, ranges, order, tiny: 0 }
    }

    /// Gives the parts of a node their places, and puts the largest first: where any hit will do,
    /// it is most likely to be there (surface area traversal order, Nah & Manocha 2014). A part
    /// is the number of its triangles until then, and in the word that is reserved is where it
    /// is; `leaf` tells the triangles of one. False if there are too many nodes.
    pub fn give(&mut self, node: &mut Node, leaf: &dyn Fn(u32, &mut [u32])) -> bool {
        let bounds = node.bounds;
        let sides = |i: usize| {
            [0, 1, 2].map(|k| f64::from(bounds[2 * k + 1][i]) - f64::from(bounds[2 * k][i]))
        };
        let mut order = [(0.0, 0); PARTS];
        for (i, (part, start)) in node.parts.iter_mut().zip(&mut node.reserved).enumerate() {
            let (len, start) = (*part, core::mem::take(start));
            *part = if len > LEAF {
                let Some(range) = self.ranges.get_mut(self.next) else { return false };
                *range = [start, len];
                self.next += 1;
                (self.next as u32 - 1) << PART_SHIFT | NODE
            } else if len > 0 {
                let met = surface(sides(i).map(|side| side + 2.0 * MARGIN));
                if met > 2.0 * surface(sides(i)) {
                    self.tiny += len as usize;
                }
                leaf(start, &mut self.order[self.first..][..len as usize]);
                self.first += len as usize;
                (self.first as u32 - len) << PART_SHIFT | len
            } else {
                0
            };
            let size = if len > 0 { surface(sides(i)) } else { -1.0 };
            let mut to = i;
            while to > 0 && order[to - 1].0 < size {
                order[to] = order[to - 1];
                to -= 1;
            }
            order[to] = (size, i);
        }
        let parts = node.parts;
        for (to, &(_, from)) in order.iter().enumerate() {
            node.parts[to] = parts[from];
            for (row, bounds) in node.bounds.iter_mut().zip(&bounds) {
                row[to] = bounds[from];
            }
        }
        true
    }
}
