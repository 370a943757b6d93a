//! Rays that start very far from a grid, in units of its cells.
//!
//! `f64` cannot place them directly, so the origin is moved along the ray to
//! the box: `org + base * dir` with `base` a sum of up to five numbers, each
//! step shrinking the distance by about 2^50. The sum is formed without error
//! (expansions, Shewchuk 1997), then rounded once, so the local origin is as
//! good as if the ray had started at the box.

use glam::DVec3;

const STEPS: usize = 5;
/// Terms of an exact local origin: the origin, the corner, two per step.
const TERMS: usize = 2 + 2 * STEPS;

/// Where a ray is to be moved to: a box by its lowest corner and its sides, and how far
/// from the corner, along each axis, is near enough.
pub(super) struct Goal {
    pub lo: DVec3,
    pub extent: DVec3,
    pub reach: DVec3,
}

/// A ray with its origin moved to a box.
pub(super) struct Moved {
    /// The new origin, relative to the box's lowest corner.
    pub o: [f64; 3],
    pub part: Part,
}

/// A part of a ray by a parameter that is that of the whole ray less a base.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub low: f64,
    pub high: f64,
    /// Give or take `slack`.
    pub base: f64,
    pub slack: f64,
}

impl Part {
    /// Of the ray's own parameter.
    pub fn new(low: f64, high: f64) -> Self {
        Self { low, high, base: 0.0, slack: 0.0 }
    }
}

/// Moves an origin that is beyond reach; `None` if the ray misses the box. `exact` is
/// the ray's origin and direction, [`super::course::Course::exact`].
#[cold]
#[inline(never)]
pub(super) fn rebase(goal: &Goal, exact: &[[f64; 3]; 2], t0: f64, t1: f64) -> Option<Moved> {
    let [org, dir] = exact.map(DVec3::from_array);
    let Goal { lo, extent, reach } = *goal;
    let mut steps = [0.0; STEPS];
    let mut o = org - lo;
    for step in 0..STEPS {
        if !o.abs().cmpgt(reach).any() {
            break;
        }
        steps[step] = entry(extent, o, dir);
        o = DVec3::from_array(core::array::from_fn(|k| place(org[k], lo[k], dir[k], &steps)));
    }
    // A ray that meets the box is in reach by now: each step places the entry
    // to within 2^-50 of the distance that was left.
    if o.abs().cmpgt(reach).any() {
        return None;
    }
    let base: f64 = steps.iter().sum();
    let mut slack = steps.iter().map(|b| b.abs()).sum::<f64>() * 1e-15;
    // The bounds are compared as parameters of the whole ray.
    let s0 = (t0 - base - slack) - t0.abs().min(f64::MAX) * 1e-15;
    let s1 = (t1 - base + slack) + t1.abs().min(f64::MAX) * 1e-15;
    // Parameters within the box are off by their own rounding too.
    let across = (extent + o.abs()).max_element() / dir.abs().max_element();
    slack += across * 1e-15;
    Some(Moved { o: o.to_array(), part: Part { low: s0, high: s1, base, slack } })
}

/// The parameter at which the ray has passed the near planes of the box.
fn entry(extent: DVec3, o: DVec3, dir: DVec3) -> f64 {
    let mut near = f64::NEG_INFINITY;
    for k in 0..3 {
        if dir[k] != 0.0 {
            near = near.max((-o[k] / dir[k]).min((extent[k] - o[k]) / dir[k]));
        }
    }
    near
}

/// `org - lo + dir * sum(base)`, rounded about once.
fn place(org: f64, lo: f64, dir: f64, base: &[f64; STEPS]) -> f64 {
    let mut terms = [0.0; TERMS];
    terms[0] = org;
    terms[1] = -lo;
    for (i, &b) in base.iter().enumerate() {
        // 27 low bits off: both products with the 24 bits of an f32 are exact.
        let high = f64::from_bits(b.to_bits() & !0x07ff_ffff);
        terms[2 + 2 * i] = high * dir;
        terms[3 + 2 * i] = (b - high) * dir;
    }
    sum(&terms)
}

/// The sum of `terms`, with an error of a few units in its last place.
fn sum(terms: &[f64; TERMS]) -> f64 {
    let mut expansion = [0.0f64; TERMS];
    for (len, &term) in terms.iter().enumerate() {
        let mut carry = term;
        for e in &mut expansion[..len] {
            let sum = carry + *e;
            let back = sum - carry;
            *e = (carry - (sum - back)) + (*e - back);
            carry = sum;
        }
        expansion[len] = carry;
    }
    expansion.iter().sum()
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn places_what_cancels() {
        let (far, dir) = (1e20_f32, -0.3_f32);
        let near = -f64::from(far) / f64::from(dir);
        // far + dir * (near + more) = dir * more, exactly, but for near's rounding.
        let rest = place(f64::from(far), 0.0, f64::from(dir), &[near, 0.0, 0.0, 0.0, 0.0]);
        assert!(rest.abs() < 1e5);
        let moved = place(f64::from(far), 0.0, f64::from(dir), &[near, 2.0, 0.0, 0.0, 0.0]);
        assert!((moved - rest - 2.0 * f64::from(dir)).abs() < 1e-9);
    }
}
