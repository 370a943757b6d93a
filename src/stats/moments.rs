//! Means and standard deviations from counts and sums of squares.

use crate::simd::fpenv;

/// A mean and a standard deviation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    /// The mean.
    pub mean: f64,
    /// The standard deviation, of the whole population.
    pub deviation: f64,
}

impl Moments {
    pub(super) fn new(count: u64, sum: u64, squares: u128) -> Self {
        if count == 0 {
            return Self::default();
        }
        fpenv::with_default(|| {
            let mean = sum as f64 / count as f64;
            let variance = (squares as f64 / count as f64 - mean * mean).max(0.0);
            Self { mean, deviation: crate::math::sqrt(variance) }
        })
    }
}
