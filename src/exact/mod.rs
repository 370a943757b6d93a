//! Exact arithmetic, for the few decisions that `f64` leaves open.
//!
//! The deciding quantities are polynomials of degree three in `f32` inputs, so
//! integers settle their signs, and one long division rounds their quotients
//! correctly to `f32`. Only a ray within a part in 10^5 or so of a triangle's
//! edge, or a `t` next to a rounding boundary, comes here. Cost: 0.3 to 3 us,
//! by the spread of the exponents; no allocation.

mod int;

use core::cmp::Ordering;

use int::Int;

/// A vector of integers times a power of two.
type Vector<const N: usize> = [Int<N>; 3];

fn cross<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    let minor = |i: usize, j: usize| a[i].mul(&b[j]).sub(&a[j].mul(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn dot<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Int<N> {
    a[0].mul(&b[0]).add(&a[1].mul(&b[1])).add(&a[2].mul(&b[2]))
}

fn sub<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [a[0].sub(&b[0]), a[1].sub(&b[1]), a[2].sub(&b[2])]
}

/// Mantissa and exponent of a finite `f32`, read from its bits.
fn split(x: f32) -> (i64, i32) {
    let bits = x.to_bits();
    let exponent = (bits >> 23 & 0xff) as i32;
    let fraction = i64::from(bits & 0x007f_ffff);
    let (m, e) =
        if exponent == 0 { (fraction, -149) } else { (fraction | 1 << 23, exponent - 150) };
    (if bits >> 31 == 1 { -m } else { m }, e)
}

/// The range of exponents of the bits of some numbers: on a power of two of
/// `low` they are integers of `width` bits.
#[derive(Clone, Copy)]
struct Span {
    low: i32,
    width: u32,
}

impl Span {
    fn of<'a>(values: impl Iterator<Item = &'a f32>) -> Self {
        let (mut low, mut high) = (i32::MAX, i32::MIN);
        for (m, e) in values.map(|&x| split(x)) {
            if m != 0 {
                low = low.min(e);
                high = high.max(e + 24);
            }
        }
        if low > high {
            Self { low: 0, width: 0 }
        } else {
            Self { low, width: (high - low) as u32 }
        }
    }

    fn vector<const N: usize>(&self, v: &[f32; 3]) -> Vector<N> {
        v.map(|x| match split(x) {
            (0, _) => Int::ZERO,
            (m, e) => Int::shifted(m, (e - self.low) as u32),
        })
    }
}

/// A ray and a triangle whose meeting `f64` could not decide.
pub struct Case<'a> {
    org: &'a [f32; 3],
    dir: &'a [f32; 3],
    triangle: &'a [[f32; 3]; 3],
    place: Span,
    heading: Span,
}

impl<'a> Case<'a> {
    pub fn new(org: &'a [f32; 3], dir: &'a [f32; 3], triangle: &'a [[f32; 3]; 3]) -> Self {
        let place = Span::of(org.iter().chain(triangle.as_flattened()));
        Self { org, dir, triangle, place, heading: Span::of(dir.iter()) }
    }

    /// Whether a determinant, and what its division needs, fits 4 limbs.
    fn narrow(&self) -> bool {
        2 * self.place.width + self.place.width.max(self.heading.width) + 8 + 28 <= 256
    }

    /// The rounded `t`, if the ray's line pierces the closed triangle.
    pub fn t(&self) -> Option<f32> {
        if self.narrow() { Meeting::<4>::new(self).t() } else { Meeting::<14>::new(self).t() }
    }

    /// The rounded weights of the second and the third corner.
    pub fn weights(&self) -> (f32, f32) {
        if self.narrow() {
            Meeting::<4>::new(self).weights()
        } else {
            Meeting::<14>::new(self).weights()
        }
    }
}

/// A ray's meeting with the plane and the three edge planes of a triangle, in
/// exact integers.
struct Meeting<const N: usize> {
    /// `dir . (b x c)` and its cyclic companions: the weights of the corners
    /// times their sum, for `a, b, c` the corners seen from the origin.
    weight: [Int<N>; 3],
    /// Their sum, `dir . ((b - a) x (c - a))`.
    det: Int<N>,
    /// `a . (b x c)`; `t` is this over `det`, times `2^scale`.
    height: Int<N>,
    scale: i32,
}

impl<const N: usize> Meeting<N> {
    fn new(case: &Case<'_>) -> Self {
        let o = case.place.vector(case.org);
        let [a, b, c] = case.triangle.map(|v| sub(&case.place.vector(&v), &o));
        let d = case.heading.vector(case.dir);
        let bc = cross(&b, &c);
        let weight = [dot(&d, &bc), dot(&d, &cross(&c, &a)), dot(&d, &cross(&a, &b))];
        let det = weight[0].add(&weight[1]).add(&weight[2]);
        Self { weight, det, height: dot(&a, &bc), scale: case.place.low - case.heading.low }
    }

    fn t(&self) -> Option<f32> {
        let sign = self.det.signum();
        let pierced = sign != 0 && self.weight.iter().all(|w| w.signum() * sign >= 0);
        pierced.then(|| quotient(&self.height, &self.det, self.scale))
    }

    fn weights(&self) -> (f32, f32) {
        (quotient(&self.weight[1], &self.det, 0), quotient(&self.weight[2], &self.det, 0))
    }
}

/// Whether the triangle has no area.
pub fn degenerate(triangle: &[[f32; 3]; 3]) -> bool {
    let place = Span::of(triangle.as_flattened().iter());
    let [a, b, c] = triangle.map(|v| place.vector::<14>(&v));
    cross(&sub(&b, &a), &sub(&c, &a)).iter().all(|n| n.signum() == 0)
}

/// `num / den * 2^scale` to the nearest `f32`, ties to even; zero is +0.
///
/// The quotient is cut to 26 bits or more with a sticky last bit (rounding to
/// odd), so the conversion through `f64` rounds only once, denormals included.
fn quotient<const N: usize>(num: &Int<N>, den: &Int<N>, scale: i32) -> f32 {
    if num.signum() == 0 {
        return 0.0;
    }
    let shift = 26 - (num.bits() as i32 - den.bits() as i32);
    let mut rest = num.abs().shl(shift.max(0) as u32);
    // The quotient has 26 or 27 bits.
    let mut part = den.abs().shl((-shift).max(0) as u32 + 27);
    let mut q = 0u64;
    for _ in 0..28 {
        q <<= 1;
        if rest.cmp_magnitude(&part) != Ordering::Less {
            rest = rest.sub(&part);
            q |= 1;
        }
        part = part.halved();
    }
    let odd = q << 1 | u64::from(rest.signum() != 0);
    let magnitude = odd as f64 * power(scale - shift - 1);
    let signed = if num.signum() == den.signum() { magnitude } else { -magnitude };
    signed as f32 + 0.0
}

/// `2^e`; |e| stays below 1000 for quotients of the polynomials above.
fn power(e: i32) -> f64 {
    f64::from_bits(((e + 1023) as u64) << 52)
}
