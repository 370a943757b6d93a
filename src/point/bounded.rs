//! `f64` that know how wrong they may be.
//!
//! The bound of an operation's error follows from those of its operands, plus a rounding,
//! 2^-53 of the result, counted twice. The bounds are themselves rounded, each time by a
//! part in 2^52 or so, of which no number here has more than a hundred: they are used
//! with a part in a million more. Numbers are made of at most six coordinates each:
//! between 2^-894 and 2^780, bounds above 2^-1000, so nothing overflows or is lost below.

use super::Number;
use crate::math::sqrt;

/// Twice the distance from 1 to the middle between it and the next number.
const ROUNDING: f64 = f64::EPSILON;
/// Of a bound, for what was lost in computing it.
const ROOM: f64 = 1.0 + 1e-6;

/// A number within `error` of `x`.
#[derive(Clone, Copy)]
pub struct Bounded {
    x: f64,
    error: f64,
}

impl Bounded {
    pub fn vector(v: [f32; 3]) -> [Self; 3] {
        v.map(|x| Self { x: x.into(), error: 0.0 })
    }

    fn rounded(x: f64, error: f64) -> Self {
        Self { x, error: error + x.abs() * ROUNDING }
    }

    /// Its least and largest value.
    fn ends(&self) -> [f64; 2] {
        [self.x - self.error * ROOM, self.x + self.error * ROOM]
    }

    /// The bounds of `sqrt(num / den)` as `f32`, if `den` is positive and `num` not
    /// negative.
    #[inline(never)]
    pub fn root(num: &Self, den: &Self) -> Option<[f32; 2]> {
        let ([low, high], [least, most]) = (num.ends(), den.ends());
        // Quotients and roots are good to a part in 10^15.
        let room = 1e-14;
        (least > 0.0).then(|| {
            let low = if low > 0.0 { sqrt(low / most) } else { 0.0 };
            [(low * (1.0 - room)) as f32, (sqrt(high / least) * (1.0 + room)) as f32]
        })
    }

    /// `num / den` as `f32`, if its rounding is certain; `den` is not negative.
    #[inline(never)]
    pub fn quotient(num: &Self, den: &Self) -> Option<f32> {
        let [least, _] = den.ends();
        let q = num.x / den.x;
        let error = (num.error + q.abs() * den.error) / least * ROOM + q.abs() * (4.0 * ROUNDING);
        let (low, high) = ((q - error) as f32, (q + error) as f32);
        // Adding +0 turns -0 into +0 and changes nothing else.
        (least > 0.0 && low == high).then_some(low + 0.0)
    }
}

impl Number for Bounded {
    fn zero() -> Self {
        Self { x: 0.0, error: 0.0 }
    }

    fn one() -> Self {
        Self { x: 1.0, error: 0.0 }
    }

    fn add(&self, other: &Self) -> Self {
        Self::rounded(self.x + other.x, self.error + other.error)
    }

    fn sub(&self, other: &Self) -> Self {
        Self::rounded(self.x - other.x, self.error + other.error)
    }

    fn mul(&self, other: &Self) -> Self {
        let error = self.x.abs() * other.error + (other.x.abs() + other.error) * self.error;
        Self::rounded(self.x * other.x, error)
    }

    fn sign(&self) -> Option<i32> {
        let [low, high] = self.ends();
        if low > 0.0 {
            Some(1)
        } else if high < 0.0 {
            Some(-1)
        } else if low == high {
            Some(0)
        } else {
            None
        }
    }
}
