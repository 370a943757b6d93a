//! A binary tree over single triangles that can be changed.

use super::item::Item;
use glam::Vec3A;

/// What the root is under.
pub const NONE: u32 = (1 << 30) - 1;

/// The tree. The boxes of the triangles, as many as `triangles`, are followed by those of the
/// nodes, one fewer; a box is known by its place among all.
pub struct Binary<'a> {
    pub triangles: usize,
    pub boxes: &'a mut [Item],
    /// The two boxes below each node.
    pub below: &'a mut [[u32; 2]],
    pub root: u32,
}

/// Half the surface of a box.
#[inline(always)]
pub fn surface(lo: Vec3A, hi: Vec3A) -> f32 {
    let side = hi - lo;
    side.x * side.y + side.y * side.z + side.z * side.x
}

impl<'a> Binary<'a> {
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

#[cfg(test)]
pub mod tests {
    use super::super::above;
    use super::*;
    use crate::build::control::Control;
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

    /// A tree from above.
    pub fn built<'a>(boxes: &'a mut [Item], below: &'a mut [[u32; 2]]) -> Binary<'a> {
        above::build(boxes, below, &mut Control::default()).expect("not cancelled")
    }

    #[test]
    fn from_above() {
        // More than one task has, too.
        for count in [2, 3, 100, 5000] {
            let (mut boxes, mut below) = (boxes(7, count), vec![[0; 2]; count - 1]);
            let mut tree = built(&mut boxes, &mut below);
            assert_eq!(tree.number(tree.root) as usize, count);
            assert!(total(&mut tree) > 0.0);
        }
    }
}
