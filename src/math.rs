//! Functions that `core` lacks, the same bits with and without `std`.

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
    use super::{cbrt, ln, sqrt};

    #[test]
    fn close_to_the_real_functions() {
        for e in -300..300 {
            let x = 1.37 * 10f64.powi(e);
            assert!((cbrt(x) / x.cbrt() - 1.0).abs() < 1e-15, "{x}");
            assert!((sqrt(x) / x.sqrt() - 1.0).abs() < 1e-15, "{x}");
            assert!((ln(x) - x.ln()).abs() < 1e-8, "{x}");
        }
        assert_eq!(cbrt(0.0), 0.0);
    }
}
