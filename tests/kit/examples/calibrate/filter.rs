//! Three levels of length: Otsu's rule over the logarithm of the length.

pub const LEVELS: usize = 3;
const BINS: usize = 128;

/// Level k holds the lengths in [limits[k], limits[k + 1]).
pub struct Levels {
    limits: [f64; LEVELS + 1],
}

impl Levels {
    /// The two thresholds, at edges of histogram bins, that maximise the variance between classes.
    pub fn otsu(lengths: &[f64]) -> Self {
        let min = lengths.iter().copied().fold(f64::INFINITY, f64::min);
        let max = lengths.iter().copied().fold(0.0, f64::max);
        let (from, span) = (min.ln(), (max / min).ln());
        let mut histogram = [0.0; BINS];
        for d in lengths {
            let bin = ((d.ln() - from) / span * BINS as f64) as usize;
            histogram[bin.min(BINS - 1)] += 1.0;
        }
        // Variance between classes is, but for a constant, the sum of (sum of values)^2 / count.
        let score = |bins: core::ops::Range<usize>| {
            let count: f64 = histogram[bins.clone()].iter().sum();
            let sum: f64 = bins.map(|i| histogram[i] * (i as f64 + 0.5)).sum();
            if count > 0.0 { sum * sum / count } else { 0.0 }
        };
        let pairs = (1..BINS).flat_map(|a| (a + 1..BINS).map(move |b| (a, b)));
        let rated = pairs.map(|(a, b)| (score(0..a) + score(a..b) + score(b..BINS), a, b));
        let (_, a, b) = rated.max_by(|x, y| x.0.total_cmp(&y.0)).expect("bins");
        let edge = |bin: usize| (from + span * bin as f64 / BINS as f64).exp();
        Self { limits: [min, edge(a), edge(b), max] }
    }

    pub fn bounds(&self) -> [f64; LEVELS + 1] {
        self.limits
    }

    pub fn midpoint(&self, level: usize) -> f64 {
        (self.limits[level] + self.limits[level + 1]) / 2.0
    }

    pub fn members(&self, lengths: &[f64], level: usize) -> Vec<u32> {
        let level_of = |d: f64| self.limits[1..LEVELS].iter().filter(|&&l| d >= l).count();
        (0..lengths.len() as u32).filter(|&i| level_of(lengths[i as usize]) == level).collect()
    }
}
