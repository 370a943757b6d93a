//! What it costs to meet what is below a box, as so many parts of a node.

use crate::arena::node::{LEAF, PARTS};

/// What it costs to meet a node, a leaf and each triangle of it, in instructions.
pub const OF_NODE: f32 = 67.0;
const OF_LEAF: f32 = 190.0;
const OF_TRIANGLE: f32 = 3.0;

/// The least cost of what is below a box, times its surface, as one part, two at most, and so
/// on.
pub type Costs = [f32; PARTS];

/// That of a triangle, by half the surface of its box.
#[inline(always)]
pub fn of_triangle(surface: f32) -> Costs {
    [of_leaf(surface, 1); PARTS]
}

/// That of a leaf.
#[inline(always)]
pub fn of_leaf(surface: f32, len: u32) -> f32 {
    surface * (OF_LEAF + OF_TRIANGLE * len as f32)
}

/// That of a box around two others, over so many triangles.
#[inline(always)]
pub fn joined(surface: f32, len: u32, [a, b]: [Costs; 2], alone: [bool; 2]) -> Costs {
    let mut costs = least([&a, &b], alone);
    let one =
        if len <= LEAF { of_leaf(surface, len) } else { surface * OF_NODE + costs[PARTS - 1] };
    for cost in &mut costs {
        *cost = if *cost < one { *cost } else { one };
    }
    costs
}

/// The least costs of two boxes in up to eight parts; of one part it is infinite. Which of them
/// are triangles is known.
#[inline(always)]
fn least([a, b]: [&Costs; 2], [triangle, other]: [bool; 2]) -> Costs {
    // Parts of a triangle are one.
    if triangle || other {
        let (one, rest) = if triangle { (a, b) } else { (b, a) };
        let mut least = [f32::INFINITY; PARTS];
        for (least, rest) in least[1..].iter_mut().zip(rest) {
            *least = one[0] + rest;
        }
        return least;
    }
    let mut shifted = [f32::INFINITY; 2 * PARTS];
    shifted[PARTS..].copy_from_slice(b);
    let mut least = [f32::INFINITY; PARTS];
    for (first, a) in a[..PARTS - 1].iter().enumerate() {
        for (parts, least) in least.iter_mut().enumerate() {
            let cost = a + shifted[PARTS - 1 + parts - first];
            *least = if cost < *least { cost } else { *least };
        }
    }
    least
}

/// The least cost of two boxes in so many parts, and how many of these the first has.
#[inline(never)]
pub fn cheapest(a: &Costs, b: &Costs, parts: usize) -> (f32, usize) {
    let mut best = (f32::INFINITY, 1);
    for first in 1..parts {
        let cost = a[first - 1] + b[parts - first - 1];
        if cost < best.0 {
            best = (cost, first);
        }
    }
    best
}
