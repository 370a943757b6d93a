//! Quotients of integers, rounded once to `f32`.

use core::cmp::Ordering;

/// A positive integer.
pub trait Magnitude {
    fn bits(&self) -> u32;
    /// The 64 leading bits, the first of them 1.
    fn leading(&self) -> u64;
    fn shl(&self, by: u32) -> Self;
    fn times(&self, by: u32) -> Self;
    fn compare(&self, other: &Self) -> Ordering;
}

/// `2^e`, a normal number.
pub fn power(e: i32) -> f64 {
    f64::from_bits(((e + 1023) as u64) << 52)
}

/// `num / den * 2^scale` to the nearest `f32`, ties to even.
///
/// The quotient of the leading bits, each cut and rounded, is off by less than
/// 2^-51 of itself, so at most one boundary between two `f32` lies within 2^-50 of
/// it: the middle between its neighbours, an integer `m` of at most 25 bits times a
/// power of two. Which side of it the quotient is on a product tells, which has
/// no more bits than `num` or 26 more than `den`.
pub fn nearest<M: Magnitude>(num: M, den: M, scale: i32) -> f32 {
    let about = num.leading() as f64 / den.leading() as f64;
    let exponent = num.bits() as i32 - den.bits() as i32;
    decide(about, exponent + scale, |m, place| {
        let shift = scale - place;
        let left = num.shl(shift.max(0) as u32);
        let right = den.times(m).shl((-shift).max(0) as u32);
        left.compare(&right)
    })
}

/// What is within a part in 2^50 of `about * 2^exponent`, with `about` from 1/2 to 2, to
/// the nearest `f32`, ties to even; `compare` compares it with `m * 2^place`.
pub fn decide(about: f64, exponent: i32, compare: impl FnOnce(u32, i32) -> Ordering) -> f32 {
    // It is between 2^(exponent - 1) and 2^(exponent + 1).
    if exponent > 129 {
        return f32::INFINITY;
    }
    if exponent < -152 {
        return 0.0;
    }
    let about = about * power(exponent);
    let (low, high) = ((about * (1.0 - power(-50))) as f32, (about * (1.0 + power(-50))) as f32);
    if low == high {
        return low;
    }
    let above = if high == f32::INFINITY { power(128) } else { f64::from(high) };
    let middle = (0.5 * (f64::from(low) + above)).to_bits();
    let m = (middle >> 28) as u32 & 0x00ff_ffff | 1 << 24;
    match compare(m, (middle >> 52) as i32 - 1023 - 24) {
        Ordering::Less => low,
        Ordering::Greater => high,
        Ordering::Equal if low.to_bits() & 1 == 0 => low,
        Ordering::Equal => high,
    }
}
