//! Nodes in less: their bounds in steps of a power of two, rounded outward.

use crate::Error;
use crate::arena::node::{Node, PARTS, QuantizedNode};
use crate::build::control::{Control, TASKS, parts};

/// The exponent of the smallest step, 2^-24, as in an `f32`: less than a descent's margins.
const LEAST: u8 = 127 - 24;

/// Nodes of a task.
const SHARE: usize = 1024;

/// Makes nodes whose boxes hold those of others.
pub fn quantize(
    from: &[Node],
    to: &mut [QuantizedNode],
    control: &mut Control<'_>,
) -> Result<(), Error> {
    for (from, to) in from.chunks(SHARE * TASKS).zip(to.chunks_mut(SHARE * TASKS)) {
        let mut some = from.chunks(SHARE).zip(to.chunks_mut(SHARE));
        let mut tasks = parts(|| some.next());
        control.each(&mut tasks, |(from, to)| {
            to.iter_mut().zip(*from).for_each(|(to, node)| *to = one(node));
        })?;
        control.tick(from.len(), 0, 1)?;
    }
    Ok(())
}

/// A node whose boxes hold those of another.
fn one(node: &Node) -> QuantizedNode {
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
        // A box that is inverted stays so, if not by so much.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Parts that begin and end at these places along each axis; none of the others.
    fn node(ends: &[[f32; 2]]) -> Node {
        let (lo, hi) = ([f32::INFINITY; PARTS], [f32::NEG_INFINITY; PARTS]);
        let bounds = [lo, hi, lo, hi, lo, hi];
        let mut node = Node { bounds, parts: [0; PARTS], reserved: [0; PARTS] };
        for (i, ends) in ends.iter().enumerate() {
            node.parts[i] = 1;
            for (row, bounds) in node.bounds.iter_mut().enumerate() {
                bounds[i] = ends[row % 2];
            }
        }
        node
    }

    /// Flat and of any size, at steps, next to them, and where these are lost in rounding: what is
    /// there is inside by what a descent computes, fused or not, and by little; what is not is
    /// inverted.
    #[test]
    fn inside_and_hardly_larger() {
        let step = 1.0 / 128.0;
        let all: [&[[f32; 2]]; 9] = [
            &[[0.0, 0.0]],
            &[[0.7, 0.7], [0.7, 0.7]],
            &[[0.0, 255.0 * step]],
            &[[0.0, (255.0f32 * step).next_up()], [step, 7.0 * step]],
            &[[step.next_down(), 1.0], [0.0, step.next_up()], [1.0f32.next_down(), 1.0]],
            &[[f32::from_bits(1), 1e-38], [0.0, 2e-45], [1e-20, 1e-7]],
            &[[-1e-9, 1e-9], [-0.0, 1.9], [1.0, 1.0f32.next_up()]],
            &[[1.5, 1.5f32.next_up()], [1.5f32.next_down(), 1.5]],
            &[[0.0, 0.1], [0.1, 0.3], [0.3, 0.7], [0.5, 1.1], [1.0, 2.0], [0.2, 2.0], [0.0, 2.0]],
        ];
        for ends in all {
            let (from, to) = (node(ends), one(&node(ends)));
            assert_eq!(from.parts, to.parts);
            for (row, bounds) in to.bounds.iter().enumerate() {
                let (step, origin) = (to.step(row / 2), to.origin[row / 2]);
                for (i, &steps) in bounds.iter().enumerate() {
                    let steps = f32::from(steps);
                    let computed = steps * step + origin;
                    assert_eq!(computed.to_bits(), steps.mul_add(step, origin).to_bits());
                    let true_one = from.bounds[row][i];
                    let outward =
                        if row % 2 == 0 { true_one - computed } else { computed - true_one };
                    assert!(i >= ends.len() || (0.0..=1.5 * step).contains(&outward), "{ends:?}");
                }
            }
            for i in ends.len()..PARTS {
                assert!((0..3).all(|k| to.bounds[2 * k][i] > to.bounds[2 * k + 1][i]));
            }
        }
    }
}
