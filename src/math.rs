//! Functions that `core` lacks, the same bits with and without `std`.

/// Numbers in the order of finite floats; both zeros have the same.
pub fn ordered(x: f32) -> u32 {
    let bits = (x + 0.0).to_bits();
    if bits >> 31 == 0 { bits | 1 << 31 } else { !bits }
}

/// The cube root of a positive number, to about an ulp. Newton's iteration
/// from a third of the exponent; only additions, products and quotients, so
/// every platform computes the same bits (no libm's `cbrt` promises that).
pub fn cbrt(x: f64) -> f64 {
    if x <= 0.0 || !x.is_finite() {
        return x;
    }
    let mut y = f64::from_bits(x.to_bits() / 3 + (682 << 52));
    for _ in 0..6 {
        y -= (y - x / (y * y)) / 3.0;
    }
    y
}

/// The square root of a positive number, to about an ulp, by Newton's iteration.
pub fn sqrt(x: f64) -> f64 {
    if x <= 0.0 || !x.is_finite() {
        return x;
    }
    let mut y = f64::from_bits((x.to_bits() >> 1) + (1023 << 51));
    for _ in 0..5 {
        y = 0.5 * (y + x / y);
    }
    y
}

/// The exponential function, to about 1e-9, the same bits everywhere; 0 and infinity
/// beyond 600.
pub fn exp(x: f64) -> f64 {
    if x.is_nan() || x.abs() > 600.0 {
        return if x < 0.0 { 0.0 } else { f64::INFINITY };
    }
    let half = if x < 0.0 { -0.5 } else { 0.5 };
    let exponent = (x / core::f64::consts::LN_2 + half) as i32;
    let rest = x - f64::from(exponent) * core::f64::consts::LN_2;
    // |rest| <= 0.35: twelve terms.
    let sum = (1..=12).rev().fold(1.0, |sum, k| 1.0 + sum * rest / f64::from(k));
    sum * f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// The natural logarithm, to about 1e-9: enough for histograms, and the same
/// bits everywhere.
pub fn ln(x: f64) -> f64 {
    if x <= 0.0 || !x.is_finite() {
        return f64::NEG_INFINITY;
    }
    let bits = x.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i32 - 1023;
    let m = f64::from_bits(bits & 0x000f_ffff_ffff_ffff | 1023 << 52);
    // ln m = 2 artanh((m - 1) / (m + 1)), m in [1, 2): |z| <= 1/3.
    let z = (m - 1.0) / (m + 1.0);
    let mut power = z;
    let mut sum = 0.0;
    for k in 0..10 {
        sum += power / f64::from(2 * k + 1);
        power *= z * z;
    }
    2.0 * sum + f64::from(exponent) * core::f64::consts::LN_2
}

#[cfg(test)]
mod tests {
    use super::{cbrt, exp, ln, sqrt};

    #[test]
    fn close_to_the_real_functions() {
        for e in -300..300 {
            let x = 1.37 * 10f64.powi(e);
            assert!((cbrt(x) / x.cbrt() - 1.0).abs() < 1e-15, "{x}");
            assert!((sqrt(x) / x.sqrt() - 1.0).abs() < 1e-15, "{x}");
            assert!((ln(x) - x.ln()).abs() < 1e-8, "{x}");
        }
        for x in (-590..590).map(f64::from) {
            assert!((exp(x) / x.exp() - 1.0).abs() < 1e-12, "{x}");
            assert!((exp(x / 977.0) / (x / 977.0).exp() - 1.0).abs() < 1e-12, "{x}");
        }
        assert_eq!((exp(-1e9), exp(f64::INFINITY), exp(0.0)), (0.0, f64::INFINITY, 1.0));
        assert_eq!(cbrt(0.0), 0.0);
    }
}
