//! The point of a triangle nearest to another, in integers.
//!
//! On a common power of two coordinates are integers of 277 bits, differences have 278.
//! The longest numbers are those of `point::nearest` inside the triangle: a determinant
//! of 838 bits, squared, over the square of a normal, 1116; rounding the root multiplies
//! by 50 more. 28 limbs of 64 bits hold them.

use super::int;
use super::quotient;
use super::round::{decide, power};
use super::span::Span;
use crate::point::{Number, Spot, nearest};

type Int = int::Int<28>;

impl Number for Int {
    fn zero() -> Self {
        Self::ZERO
    }

    fn one() -> Self {
        Self::shifted(1, 0)
    }

    fn add(&self, other: &Self) -> Self {
        Self::add(self, other)
    }

    fn sub(&self, other: &Self) -> Self {
        Self::sub(self, other)
    }

    fn mul(&self, other: &Self) -> Self {
        Self::mul(self, other)
    }

    fn sign(&self) -> Option<i32> {
        Some(self.signum())
    }
}

#[inline(never)]
fn integer(span: Span, x: f32) -> Int {
    match span.split(x) {
        (0, _) => Int::ZERO,
        (m, place) => Int::shifted(m, place),
    }
}

#[inline(never)]
fn vector(span: Span, [x, y, z]: [f32; 3]) -> [Int; 3] {
    [integer(span, x), integer(span, y), integer(span, z)]
}

/// A point and a triangle.
pub struct Pair {
    corners: [[Int; 3]; 3],
    spot: Spot<Int>,
    /// The exponent of the unit of coordinates.
    exponent: i32,
}

impl Pair {
    /// `None` for a triangle without area.
    pub fn new(p: [f32; 3], [a, b, c]: [[f32; 3]; 3]) -> Option<Self> {
        let points = [p, a, b, c];
        let span = Span::of(points.as_flattened());
        let p = vector(span, p);
        let corners = [vector(span, a), vector(span, b), vector(span, c)];
        let spot = nearest(&p, &corners)?;
        (spot.den.signum() > 0).then_some(Self { corners, spot, exponent: span.exponent() })
    }

    /// The rounded distance.
    pub fn distance(&self) -> f32 {
        root(&self.spot.square, &self.spot.den, self.exponent)
    }

    /// The rounded weights of the second and the third corner.
    pub fn weights(&self) -> (f32, f32) {
        let Spot { u, v, den, .. } = &self.spot;
        (quotient(u, den, 0), quotient(v, den, 0))
    }

    /// The rounded point.
    pub fn place(&self) -> [f32; 3] {
        [0, 1, 2].map(|k| {
            quotient(&self.spot.coordinate(&self.corners, k), &self.spot.den, self.exponent)
        })
    }
}

/// `sqrt(num / den) * 2^scale` to the nearest `f32`, ties to even.
///
/// As [`super::round::nearest`]: the root of the leading bits is off by less than 2^-50 of
/// itself, and the square of the one middle that is left open, an integer of at most 50
/// bits times a power of four, tells the rest.
fn root(num: &Int, den: &Int, scale: i32) -> f32 {
    if num.signum() == 0 {
        return 0.0;
    }
    let about = num.leading() as f64 / den.leading() as f64;
    // About times 2^exponent, and that even.
    let exponent = num.bits() as i32 - den.bits() as i32;
    let odd = exponent & 1;
    let about = crate::math::sqrt(about * power(odd));
    decide(about, (exponent - odd) / 2 + scale, |m, place| {
        // sqrt(num / den) 2^scale against m 2^place.
        let shift = 2 * (scale - place);
        let left = num.shl(shift.max(0) as u32);
        let right = den.times(m).times(m).shl((-shift).max(0) as u32);
        left.cmp_magnitude(&right)
    })
}
