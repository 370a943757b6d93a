//! Exact arithmetic, for the few decisions that `f64` leaves open.
//!
//! The deciding quantities are polynomials of degree three in `f32` inputs, so
//! integers settle their signs, and one long division rounds their quotients
//! correctly to `f32`. Only a ray within a part in 10^5 or so of a triangle's
//! edge, or a `t` next to a rounding boundary, comes here. Cost: 0.3 to 3 us,
//! by the spread of the exponents; no allocation.

mod int;

use core::cmp::Ordering;

pub use int::Int;

/// A vector of integers times a power of two.
type Vector = [Int; 3];

fn cross(a: &Vector, b: &Vector) -> Vector {
    let minor = |i: usize, j: usize| a[i].mul(&b[j]).sub(&a[j].mul(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn dot(a: &Vector, b: &Vector) -> Int {
    a[0].mul(&b[0]).add(&a[1].mul(&b[1])).add(&a[2].mul(&b[2]))
}

fn sub(a: &Vector, b: &Vector) -> Vector {
    [a[0].sub(&b[0]), a[1].sub(&b[1]), a[2].sub(&b[2])]
}

/// Mantissa and exponent of a finite `f32`, read from its bits: the caller's
/// denormals-are-zero mode must not reach this code.
fn split(x: f32) -> (i64, i32) {
    let bits = x.to_bits();
    let exponent = (bits >> 23 & 0xff) as i32;
    let fraction = i64::from(bits & 0x007f_ffff);
    let (m, e) = if exponent == 0 {
        (fraction, -149)
    } else {
        (fraction | 1 << 23, exponent - 150)
    };
    (if bits >> 31 == 1 { -m } else { m }, e)
}

/// The least exponent among the non-zero values.
fn exponent<'a>(values: impl Iterator<Item = &'a f32>) -> i32 {
    values
        .map(|&x| split(x))
        .filter(|&(m, _)| m != 0)
        .map(|(_, e)| e)
        .min()
        .unwrap_or(0)
}

fn vector(v: &[f32; 3], exponent: i32) -> Vector {
    v.map(|x| match split(x) {
        (0, _) => Int::ZERO,
        (m, e) => Int::shifted(m, (e - exponent) as u32),
    })
}

/// A ray's meeting with the plane and the three edge planes of a triangle, in
/// exact integers.
pub struct Meeting {
    /// `dir . (b x c)` and its cyclic companions: the weights of the corners
    /// times their sum, for `a, b, c` the corners seen from the origin.
    pub weight: [Int; 3],
    /// Their sum, `dir . ((b - a) x (c - a))`.
    pub det: Int,
    /// `a . (b x c)`; `t` is this over `det`, times `2^scale`.
    height: Int,
    scale: i32,
}

impl Meeting {
    pub fn new(org: &[f32; 3], dir: &[f32; 3], triangle: &[[f32; 3]; 3]) -> Self {
        let place = exponent(org.iter().chain(triangle.as_flattened()));
        let heading = exponent(dir.iter());
        let o = vector(org, place);
        let [a, b, c] = triangle.map(|v| sub(&vector(&v, place), &o));
        let d = vector(dir, heading);
        let bc = cross(&b, &c);
        let weight = [
            dot(&d, &bc),
            dot(&d, &cross(&c, &a)),
            dot(&d, &cross(&a, &b)),
        ];
        let det = weight[0].add(&weight[1]).add(&weight[2]);
        Self {
            weight,
            det,
            height: dot(&a, &bc),
            scale: place - heading,
        }
    }

    /// Whether the ray's line meets the closed triangle, away from its plane.
    pub fn pierces(&self) -> bool {
        let sign = self.det.signum();
        sign != 0 && self.weight.iter().all(|w| w.signum() * sign >= 0)
    }

    /// The parameter of the meeting, rounded once.
    pub fn t(&self) -> f32 {
        quotient(&self.height, &self.det, self.scale)
    }

    /// The weight of corner `k`, rounded once.
    pub fn weight(&self, k: usize) -> f32 {
        quotient(&self.weight[k], &self.det, 0)
    }
}

/// Whether the triangle has no area.
pub fn degenerate(triangle: &[[f32; 3]; 3]) -> bool {
    let place = exponent(triangle.as_flattened().iter());
    let [a, b, c] = triangle.map(|v| vector(&v, place));
    cross(&sub(&b, &a), &sub(&c, &a))
        .iter()
        .all(|n| n.signum() == 0)
}

/// `num / den * 2^scale` to the nearest `f32`, ties to even; zero is +0.
///
/// The quotient is cut to 26 bits or more with a sticky last bit (rounding to
/// odd), so the conversion through `f64` rounds only once, denormals included.
fn quotient(num: &Int, den: &Int, scale: i32) -> f32 {
    if num.signum() == 0 {
        return 0.0;
    }
    let shift = 26 - (num.bits() as i32 - den.bits() as i32);
    let mut rest = num.abs().shl(shift.max(0) as u32);
    let den_abs = den.abs().shl((-shift).max(0) as u32);
    let mut q = 0u64;
    for bit in (0..=27).rev() {
        let part = den_abs.shl(bit);
        if rest.cmp_magnitude(&part) != Ordering::Less {
            rest = rest.sub(&part);
            q |= 1 << bit;
        }
    }
    let odd = q << 1 | u64::from(rest.signum() != 0);
    let magnitude = odd as f64 * power(scale - shift - 1);
    let signed = if num.signum() == den.signum() {
        magnitude
    } else {
        -magnitude
    };
    signed as f32 + 0.0
}

/// `2^e`; |e| stays below 1000 for quotients of the polynomials above.
fn power(e: i32) -> f64 {
    f64::from_bits(((e + 1023) as u64) << 52)
}
