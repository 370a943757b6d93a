//! Where a line meets a triangle, in `f64`, and how far off that may be.
//!
//! On the edges `e1 = b - a`, `e2 = c - a` (Moeller & Trumbore 1997), whose
//! smallness keeps the errors small. With e = 2^-53, a difference of two `f32`
//! carries a relative error e; a product of three factors, two of them differences,
//! 4e; the sum of six such products 3e more of its magnitudes. With s the sum of
//! |dir| and m1, m2, m0 the largest coordinates of e1, e2 and `a - org`, the six
//! products of a determinant sum up to at most `2 s m m` of the two m involved, of
//! the height to `6 m0 m1 m2`: errors `14 e s m m` and `48 e m0 m1 m2`. The third
//! weight, `det - u - v`, carries the errors of the three and rounds twice more, by
//! at most `4 e s m m` for each of them; used are 20 and 64, which leaves room for
//! squares of e and for the rounding of the bounds. Magnitudes lie within 2^-450 and
//! 2^400, so `f64` neither overflows nor loses bits to underflow.

use super::{Corners, Vector, three};
use crate::simd::Pair;

/// Half the distance from 1 to the next number.
pub const E: f64 = 1.0 / (1u64 << 53) as f64;

/// For each axis the two others, in cyclic order.
const CYCLE: [(usize, usize); 3] = [(1, 2), (2, 0), (0, 1)];

/// Where a line meets a triangle: `u`, `v` and `t` are these over `det`.
pub struct Estimate {
    u: f64,
    v: f64,
    height: f64,
    det: f64,
    /// Bounds of their errors.
    u_error: f64,
    v_error: f64,
    height_error: f64,
    det_error: f64,
}

/// A triangle as seen from the origin of rays: what does not depend on their directions.
pub struct Apex {
    /// The products of the way to the first corner with the edges.
    pub(super) sides: [Pair; 3],
    pub(super) normal: Vector,
    pub(super) height: f64,
    /// Bounds of errors: of the height; and of the weights and the determinant, for a
    /// direction whose components sum up to 1.
    pub(super) height_error: f64,
    pub(super) errors: Pair,
    pub(super) det_error: f64,
}

/// On which side of its three edges a line passes a triangle.
pub enum Sides {
    Outside,
    Inside,
    Unsure,
}

impl Sides {
    /// From two weights and the sum of all three, and the sum of the bounds of their errors.
    #[inline(always)]
    pub fn of([u, v, det]: [f64; 3], error: f64) -> Self {
        let w = det - u - v;
        let (lowest, highest) = (min(min(u, v), w), max(max(u, v), w));
        if max(lowest, -highest) > error {
            Self::Inside
        } else if min(-lowest, highest) > error {
            Self::Outside
        } else {
            Self::Unsure
        }
    }
}

/// Bounds of a quotient, as `f32`; equal if the rounding is certain.
pub struct Range {
    pub low: f32,
    pub high: f32,
}

#[inline(always)]
fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// One instruction, unlike `f64::max`, which minds NaN.
#[inline(always)]
fn max(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[inline(always)]
fn min(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The sizes of the coordinates, summed.
#[inline(always)]
fn sum(a: &Vector) -> f64 {
    a[0].abs() + a[1].abs() + a[2].abs()
}

#[inline(always)]
fn largest(a: [Pair; 3]) -> Pair {
    a[0].abs().max(a[1].abs()).max(a[2].abs())
}

impl Apex {
    /// In pairs of what belongs to `e1` and what belongs to `e2`.
    #[inline(always)]
    pub fn new(org: &Vector, triangle: &impl Corners) -> Self {
        let at = three(|k| triangle.along(k));
        let first = three(|k| Pair::widen(at[k][0], at[k][0]));
        let edges = three(|k| Pair::widen(at[k][1], at[k][2]).sub(first[k]));
        let to = three(|k| first[k].sub(Pair::splat(org[k])));
        // to x e1 and to x e2, whose products with dir are -v and u.
        let sides = three(|k| {
            let (i, j) = CYCLE[k];
            to[i].mul(edges[j]).sub(to[j].mul(edges[i]))
        });
        // e1 x e2
        let normal = three(|k| {
            let (i, j) = CYCLE[k];
            let products = edges[i].mul(edges[j].swap());
            products.first() - products.second()
        });
        let m0 = largest(to);
        let m = largest(edges);
        let area = m.first() * m.second();
        Self {
            sides,
            normal,
            height: -dot(normal, three(|k| to[k].first())),
            height_error: (64.0 * E) * m0.first() * area,
            errors: m0.mul(m).mul(Pair::splat(20.0 * E)),
            det_error: (20.0 * E) * area,
        }
    }
}

impl Apex {
    /// `(v1 - v0) x (v2 - v0)` in `f64`, then rounded.
    #[inline(always)]
    pub fn normal(&self) -> [f32; 3] {
        three(|k| self.normal[k] as f32)
    }
}

/// [`Apex::normal`] of a triangle, bit for bit.
#[inline(always)]
pub fn normal(triangle: &impl Corners) -> [f32; 3] {
    // What depends on the origin is not computed.
    Apex::new(&[0.0; 3], triangle).normal()
}

impl Estimate {
    #[inline(always)]
    pub fn new(apex: &Apex, dir: &Vector) -> Self {
        let d = three(|k| Pair::splat(dir[k]));
        let sides = &apex.sides;
        let weights = d[0].mul(sides[0]).add(d[1].mul(sides[1])).add(d[2].mul(sides[2]));
        let size = sum(dir);
        let errors = apex.errors.mul(Pair::splat(size));
        Self {
            u: weights.second(),
            v: -weights.first(),
            height: apex.height,
            det: -dot(apex.normal, *dir),
            u_error: errors.second(),
            v_error: errors.first(),
            height_error: apex.height_error,
            det_error: apex.det_error * size,
        }
    }

    #[inline(always)]
    pub fn sides(&self) -> Sides {
        Sides::of([self.u, self.v, self.det], self.u_error + self.v_error + self.det_error)
    }

    /// Whether the line comes from the side to which `e1 x e2` points, if it is inside:
    /// then `det` is well beyond its error.
    #[inline(always)]
    pub fn is_front(&self) -> bool {
        self.det > 0.0
    }

    /// `t`, if the sides are not unsure.
    #[inline(always)]
    pub fn t(&self) -> Range {
        self.quotient(self.height, self.height_error)
    }

    /// The weights of the second and the third corner, if `det` is known well enough
    /// for their rounding to be certain.
    #[inline(always)]
    pub fn rounded_weights(&self) -> Option<(f32, f32)> {
        let (u, v) = (self.quotient(self.u, self.u_error), self.quotient(self.v, self.v_error));
        let known = self.det.abs() > 2.5 * self.det_error;
        // Adding +0 turns -0 into +0 and changes nothing else.
        (known & (u.low == u.high) & (v.low == v.high)).then_some((u.low + 0.0, v.low + 0.0))
    }

    /// `num / det`, for |det| above 5/2 of its error bound; where all weights are
    /// beyond the sum of the bounds, on one side, |det| is nearly thrice that.
    ///
    /// The least true |det| is then above 2/3 of the one computed, so the quotient is
    /// off by 3/2 of `(error + |q| det_error) / |det|`, with 14 and 48 for 20 and 64
    /// in the errors, and by three roundings. As |det| is at most about
    /// `2 s m1 m2`, each of them is less than `3 e s m1 m2 |q| / |det|`. Twice the
    /// bound is more: 2 * 20 > 3/2 * 14 + 3 * 3, and 2 * 64 > 3/2 * 48.
    #[inline(always)]
    fn quotient(&self, num: f64, error: f64) -> Range {
        let inverse = 1.0 / self.det;
        let q = num * inverse;
        let error = (error + q.abs() * self.det_error) * (2.0 * inverse.abs());
        Range { low: (q - error) as f32, high: (q + error) as f32 }
    }
}
