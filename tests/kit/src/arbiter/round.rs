//! From rationals back to floats.

use num_bigint::BigUint;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// Digits after the leading one, and the exponent of the smallest denormal.
const FRACTION_BITS: i64 = 23;
const LEAST_EXPONENT: i64 = -149;

/// The float nearest to `x`, ties to even; infinite from halfway past the largest finite float;
/// zero is positive.
pub fn round_to_f32(x: &BigRational) -> f32 {
    if x.is_zero() {
        return 0.0;
    }
    let (numer, denom) = (x.numer().magnitude(), x.denom().magnitude());
    let last = (floor_log2(numer, denom) - FRACTION_BITS).max(LEAST_EXPONENT);
    // How many times 2^last goes into |x|: at most 25 bits.
    let (whole, rest) = match last {
        0.. => numer.div_rem(&(denom << last)),
        _ => (numer << -last).div_rem(denom),
    };
    let divisor = if last >= 0 { denom << last } else { denom.clone() };
    let mut count = whole.to_u64().expect("at most 25 bits");
    let twice = rest << 1;
    if twice > divisor || (twice == divisor && count % 2 == 1) {
        count += 1;
    }
    if count == 0 {
        return 0.0;
    }
    if last > 104 {
        return if x.is_negative() { f32::NEG_INFINITY } else { f32::INFINITY };
    }
    // Both factors and their product are doubles without error, so the cast is exact, or
    // overflows where it should.
    let magnitude = (count as f64 * f64::from_bits(((last + 1023) as u64) << 52)) as f32;
    if x.is_negative() { -magnitude } else { magnitude }
}

/// The e with 2^e <= numer / denom < 2^(e+1).
fn floor_log2(numer: &BigUint, denom: &BigUint) -> i64 {
    let e = numer.bits() as i64 - denom.bits() as i64;
    let reaches = match e {
        0.. => numer >= &(denom << e),
        _ => &(numer << -e) >= denom,
    };
    if reaches { e } else { e - 1 }
}

/// The float nearest to the root of `square`, which is not negative: as [`round_to_f32`].
pub fn root_to_f32(square: &BigRational) -> f32 {
    // Twice as many digits as a float's middle needs, then one that says whether there are more.
    let digits = 60;
    let (numer, denom) = (square.numer().magnitude(), square.denom().magnitude());
    let scale = (digits - square_log2(square)).max(0) as u64;
    let floor = ((numer << (2 * scale)) / denom).sqrt();
    let rest = &floor * &floor * denom != numer << (2 * scale);
    let root = (floor << 1u8) + BigUint::from(u8::from(rest));
    round_to_f32(&BigRational::new(root.into(), (BigUint::from(1u8) << (scale + 1)).into()))
}

/// About the logarithm of the root.
fn square_log2(square: &BigRational) -> i64 {
    (square.numer().bits() as i64 - square.denom().bits() as i64) / 2
}
