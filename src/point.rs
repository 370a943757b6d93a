//! The nearest point, defined: how far is a point from a triangle, and where is it
//! nearest?
//!
//! The distance is what real arithmetic says: that of `p` and the one point of the closed
//! triangle that is nearest to it. It is rounded once to `f32`, and range and order are
//! decided on the rounded number. The point's coordinates and weights are the real ones,
//! each rounded once. So the point need not lie at exactly that distance, nor in the
//! triangle, but no nearer numbers exist.
//!
//! `nearest` is written once, for any kind of number. With `bounded`, `f64` that know
//! how wrong they are, it decides nearly always; what they leave open `exact::spot`
//! decides with integers.

mod bounded;

use crate::exact::spot::Pair;
use crate::triangle::Corners;
use bounded::Bounded;

/// What `nearest` computes with.
pub trait Number: Sized {
    fn zero() -> Self;
    fn one() -> Self;
    fn add(&self, other: &Self) -> Self;
    fn sub(&self, other: &Self) -> Self;
    fn mul(&self, other: &Self) -> Self;
    /// -1, 0 or 1, if it is certain.
    fn sign(&self) -> Option<i32>;
}

type Vector<N> = [N; 3];

/// The nearest point of a triangle `a, b, c`: `((den - u - v) a + u b + v c) / den`.
pub struct Spot<N> {
    /// The square of the distance is this over `den`.
    pub square: N,
    pub u: N,
    pub v: N,
    pub den: N,
}

impl<N: Number> Spot<N> {
    /// `den` times the point's coordinate `k`.
    #[inline(never)]
    pub fn coordinate(&self, [a, b, c]: &[Vector<N>; 3], k: usize) -> N {
        let along = |to: &Vector<N>, weight: &N| to[k].sub(&a[k]).mul(weight);
        a[k].mul(&self.den).add(&along(b, &self.u)).add(&along(c, &self.v))
    }
}

fn sub<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [a[0].sub(&b[0]), a[1].sub(&b[1]), a[2].sub(&b[2])]
}

/// Not inlined, as `cross`: there are many of them.
#[inline(never)]
fn dot<N: Number>(a: &Vector<N>, b: &Vector<N>) -> N {
    a[0].mul(&b[0]).add(&a[1].mul(&b[1])).add(&a[2].mul(&b[2]))
}

#[inline(never)]
fn cross<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    let minor = |i: usize, j: usize| a[i].mul(&b[j]).sub(&a[j].mul(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// The nearest point to `p`, if the signs that tell are certain: a corner if `p` is in
/// the corner's normal cone, else on an edge if it is beyond the edge and between its
/// ends, else inside (Ericson, Real-Time Collision Detection, 5.1.5, with his areas as
/// products of vectors, which cancel less).
#[inline(never)]
pub fn nearest<N: Number>(p: &Vector<N>, [a, b, c]: &[Vector<N>; 3]) -> Option<Spot<N>> {
    let (ab, ac, bc) = (sub(b, a), sub(c, a), sub(c, b));
    let (ap, bp, cp) = (sub(p, a), sub(p, b), sub(p, c));
    let corner = |to: &Vector<N>, u, v| Spot { square: dot(to, to), u, v, den: N::one() };
    // Each edge from each of its ends: is `p` beyond it?
    let a_to_b = dot(&ab, &ap).sign()?;
    let a_to_c = dot(&ac, &ap).sign()?;
    if a_to_b <= 0 && a_to_c <= 0 {
        return Some(corner(&ap, N::zero(), N::zero()));
    }
    let b_to_a = -dot(&ab, &bp).sign()?;
    let b_to_c = dot(&bc, &bp).sign()?;
    if b_to_a <= 0 && b_to_c <= 0 {
        return Some(corner(&bp, N::one(), N::zero()));
    }
    let c_to_a = -dot(&ac, &cp).sign()?;
    let c_to_b = -dot(&bc, &cp).sign()?;
    if c_to_a <= 0 && c_to_b <= 0 {
        return Some(corner(&cp, N::zero(), N::one()));
    }
    let n = cross(&ab, &ac);
    let square = |v: &Vector<N>| dot(v, v);
    let side = cross(&ab, &ap);
    let v = dot(&n, &side);
    if a_to_b >= 0 && b_to_a >= 0 && v.sign()? <= 0 {
        let u = dot(&ab, &ap);
        return Some(Spot { square: square(&side), u, v: N::zero(), den: square(&ab) });
    }
    let side = cross(&ap, &ac);
    let u = dot(&n, &side);
    if a_to_c >= 0 && c_to_a >= 0 && u.sign()? <= 0 {
        let v = dot(&ac, &ap);
        return Some(Spot { square: square(&side), u: N::zero(), v, den: square(&ac) });
    }
    let side = cross(&bc, &bp);
    if b_to_c >= 0 && c_to_b >= 0 && dot(&n, &side).sign()? <= 0 {
        let (v, den) = (dot(&bc, &bp), square(&bc));
        return Some(Spot { square: square(&side), u: den.sub(&v), v, den });
    }
    let height = dot(&n, &ap);
    Some(Spot { square: height.mul(&height), u, v, den: square(&n) })
}

/// The rounded distance of `p` from a triangle, if it is at most `limit`; all are finite,
/// but for `limit`.
pub fn distance(p: [f32; 3], triangle: &impl Corners, limit: f32) -> Option<f32> {
    let corners = triangle.all();
    let near = nearest(&Bounded::vector(p), &corners.map(Bounded::vector));
    let range = near.and_then(|spot| Bounded::root(&spot.square, &spot.den));
    let distance = match range {
        Some([low, high]) if low == high => low,
        Some([low, _]) if low > limit => return None,
        _ => Pair::new(p, corners)?.distance(),
    };
    (distance <= limit && distance < f32::INFINITY).then_some(distance)
}

/// The point of a triangle that is nearest to `p`, and its weights.
pub fn place(p: [f32; 3], triangle: &impl Corners) -> ([f32; 3], (f32, f32)) {
    let corners = triangle.all();
    let certain = |corners: &[Vector<Bounded>; 3]| {
        let spot = nearest(&Bounded::vector(p), corners)?;
        let of = |num: &Bounded| Bounded::quotient(num, &spot.den);
        let at = |k| of(&spot.coordinate(corners, k));
        Some(([at(0)?, at(1)?, at(2)?], (of(&spot.u)?, of(&spot.v)?)))
    };
    certain(&corners.map(Bounded::vector))
        .or_else(|| Pair::new(p, corners).map(|pair| (pair.place(), pair.weights())))
        .unwrap_or_default()
}
