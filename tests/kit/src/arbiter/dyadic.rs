//! Finite floats as integers times a common power of two.

use num_bigint::BigInt;

/// A vector of integers.
pub type Vector = [BigInt; 3];

/// A finite float as m 2^e, e as small as its encoding allows.
fn split(x: f32) -> (i32, i32) {
    let bits = x.to_bits();
    let (field, fraction) = ((bits >> 23) & 0xff, bits & 0x7f_ffff);
    let (m, e) = match field {
        0 => (fraction, -149),
        _ => (fraction | 0x80_0000, field as i32 - 150),
    };
    (if x.is_sign_negative() { -(m as i32) } else { m as i32 }, e)
}

/// The largest power of two (its exponent, at most) that divides all of `values`; 0 if all are 0.
pub fn common_exponent<'a>(values: impl IntoIterator<Item = &'a f32>) -> i32 {
    values
        .into_iter()
        .map(|&x| split(x))
        .filter(|(m, _)| *m != 0)
        .map(|(m, e)| e + m.trailing_zeros() as i32)
        .min()
        .unwrap_or(0)
}

/// `v` in units of 2^exponent, which must divide it.
pub fn scaled(v: [f32; 3], exponent: i32) -> Vector {
    v.map(|x| {
        let (m, e) = split(x);
        // Zero has an exponent of its own, which may be far below.
        let shift = if m == 0 { 0 } else { e - exponent };
        if shift >= 0 { BigInt::from(m) << shift } else { BigInt::from(m >> -shift) }
    })
}

pub fn sub(a: &Vector, b: &Vector) -> Vector {
    [&a[0] - &b[0], &a[1] - &b[1], &a[2] - &b[2]]
}

pub fn cross(a: &Vector, b: &Vector) -> Vector {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

pub fn dot(a: &Vector, b: &Vector) -> BigInt {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}
