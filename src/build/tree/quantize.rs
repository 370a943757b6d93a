//! Nodes in less: their bounds in steps of a power of two, rounded outward.

use crate::arena::node::{Node, PARTS, QuantizedNode};

/// The exponent of the smallest step, 2^-24, as in an `f32`: less than a descent's margins.
const LEAST: u8 = 127 - 24;

/// A node whose boxes hold those of another.
pub fn quantize(node: &Node) -> QuantizedNode {
    let mut to = QuantizedNode {
        bounds: [[0; PARTS]; 6],
        parts: node.parts,
        origin: [0.0; 3],
        exponents: [LEAST; 3],
        reserved: 0,
    };
    for k in 0..3 {
        axis(node, &mut to, k);
    }
    to
}

/// Bounds along an axis. What a descent makes of them, the origin and so many steps in one rounding,
/// is no more than a lower bound and no less than an upper one if the real number is, as these are
/// `f32`; and where `f64` rounds that number to a bound, so does `f32`.
fn axis(node: &Node, to: &mut QuantizedNode, k: usize) {
    let [lower, upper] = [&node.bounds[2 * k], &node.bounds[2 * k + 1]];
    let (mut lo, mut hi) = (f32::INFINITY, f32::NEG_INFINITY);
    for i in (0..PARTS).filter(|&i| node.parts[i] != 0) {
        (lo, hi) = (lo.min(lower[i]), hi.max(upper[i]));
    }
    to.origin[k] = lo;
    let steps = |to: &QuantizedNode, x: f32| (f64::from(x) - f64::from(lo)) / f64::from(to.step(k));
    let at =
        |to: &QuantizedNode, steps: u8| f64::from(lo) + f64::from(to.step(k)) * f64::from(steps);
    while at(to, u8::MAX) < f64::from(hi) {
        to.exponents[k] += 1;
    }
    for i in 0..PARTS {
        // A box that is inverted stays so.
        let (mut below, mut above) = (u8::MAX, 0);
        if node.parts[i] != 0 {
            below = steps(to, lower[i]) as u8;
            above = steps(to, upper[i]) as u8;
            while at(to, below) > f64::from(lower[i]) {
                below -= 1;
            }
            while at(to, above) < f64::from(upper[i]) {
                above += 1;
            }
        }
        (to.bounds[2 * k][i], to.bounds[2 * k + 1][i]) = (below, above);
    }
}
