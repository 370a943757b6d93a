//! A triangle and four lines from one point in lanes: what [`super::estimate`] finds of one.
//!
//! Sums are of as many terms, in another order, and fused operations leave roundings out: the
//! bounds of errors, which depend on neither, are the same.

use super::Vector;
use super::estimate::Apex;
use crate::simd::Lanes;

/// What four lines and a triangle, or a triangle each, have to do with each other; a bit for each line.
pub struct Four<L: Lanes> {
    /// Those that pass the triangle for certain.
    pub outside: u32,
    /// Those that pierce it for certain, at a t whose rounding is certain.
    pub inside: u32,
    /// Those whose weights' rounding is certain too.
    pub weighed: u32,
    /// Those that come from the side to which the triangle's normal points, if inside.
    pub front: u32,
    pub t: L::F32,
    pub u: L::F32,
    pub v: L::F32,
}

impl<L: Lanes> Four<L> {
    /// From u, v, the determinant and the height, u, v and t being these over the determinant, and
    /// the bounds of their errors.
    #[inline(always)]
    pub fn of(
        l: L,
        [u, v, det, height]: [L::F64; 4],
        [u_error, v_error, det_error]: [L::F64; 3],
        height_error: L::F64,
    ) -> Self {
        let zero = l.splat_f64(0.0);
        let w = l.sub_f64(l.sub_f64(det, u), v);
        let lowest = l.min_f64(l.min_f64(u, v), w);
        let highest = l.max_f64(l.max_f64(u, v), w);
        let error = l.add_f64(l.add_f64(u_error, v_error), det_error);
        let inside = l.above_f64(l.max_f64(lowest, l.sub_f64(zero, highest)), error);
        let outside = l.above_f64(l.min_f64(l.sub_f64(zero, lowest), highest), error);
        let inverse = l.div_f64(l.splat_f64(1.0), det);
        let twice = l.abs_f64(l.add_f64(inverse, inverse));
        let quotient = Quotient { inverse, twice, det_error };
        let (t, t_known) = quotient.of(l, height, height_error);
        let (u, u_known) = quotient.of(l, u, u_error);
        let (v, v_known) = quotient.of(l, v, v_error);
        let known = l.above_f64(l.abs_f64(det), l.mul_f64(det_error, l.splat_f64(2.5)));
        let front = l.above_f64(det, zero);
        let (inside, weighed) = (inside & t_known, u_known & v_known & known);
        Self { outside, inside, weighed, front, t, u, v }
    }
}

/// What quotients by the determinant have in common.
struct Quotient<L: Lanes> {
    inverse: L::F64,
    /// Twice the size of that.
    twice: L::F64,
    det_error: L::F64,
}

impl<L: Lanes> Quotient<L> {
    /// The rounded quotients, and for which of them that is certain.
    #[inline(always)]
    fn of(&self, l: L, num: L::F64, error: L::F64) -> (L::F32, u32) {
        let q = l.mul_f64(num, self.inverse);
        let error = l.mul_add_f64(l.abs_f64(q), self.det_error, error);
        let error = l.mul_f64(error, self.twice);
        let (low, high) = (l.narrow(l.sub_f64(q, error)), l.narrow(l.add_f64(q, error)));
        // Adding +0 turns -0 into +0 and changes nothing else.
        (l.add_f32(low, l.splat_f32(0.0)), l.same(low, high))
    }
}

#[inline(always)]
fn dot<L: Lanes>(l: L, dir: &[L::F64; 3], a: Vector) -> L::F64 {
    let sum = l.mul_f64(dir[2], l.splat_f64(a[2]));
    let sum = l.mul_add_f64(dir[1], l.splat_f64(a[1]), sum);
    l.mul_add_f64(dir[0], l.splat_f64(a[0]), sum)
}

impl Apex {
    /// Four lines from the point that the triangle is seen from, given the components of their
    /// directions.
    #[inline(always)]
    pub fn four<L: Lanes>(&self, l: L, dir: [L::F64; 3]) -> Four<L> {
        let [x, y, z] = &self.sides;
        let zero = l.splat_f64(0.0);
        let u = dot(l, &dir, [x.second(), y.second(), z.second()]);
        let v = l.sub_f64(zero, dot(l, &dir, [x.first(), y.first(), z.first()]));
        let det = l.sub_f64(zero, dot(l, &dir, self.normal));
        let size = l.add_f64(l.abs_f64(dir[0]), l.abs_f64(dir[1]));
        let size = l.add_f64(size, l.abs_f64(dir[2]));
        let (u_error, v_error) = (self.errors.second(), self.errors.first());
        let height = l.splat_f64(self.height);
        let error = |error: f64| l.mul_f64(size, l.splat_f64(error));
        let errors = [error(u_error), error(v_error), error(self.det_error)];
        Four::of(l, [u, v, det, height], errors, l.splat_f64(self.height_error))
    }
}
