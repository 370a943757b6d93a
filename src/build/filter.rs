//! The filter of lengths (Definition 1): which level a triangle belongs to.

use crate::aabb::Aabb;
use crate::math::ln;
use crate::options::{Filter, MAX_LEVELS};

/// Classes of the histogram of logarithms of lengths.
const CLASSES: usize = 128;

/// A filter fitted to a scene: the bounds `f_1 < ... < f_m` of its levels.
#[derive(Clone, Copy, Debug)]
pub struct Levels {
    bounds: [f64; MAX_LEVELS + 1],
    count: usize,
}

impl Levels {
    /// Fits `filter` to the lengths of at least one object.
    pub fn fit(filter: &Filter, boxes: &[Aabb]) -> Self {
        let (mut low, mut high) = (f64::INFINITY, 0.0f64);
        for length in boxes.iter().map(Aabb::diagonal) {
            low = low.min(length);
            high = high.max(length);
        }
        let mut levels = Self { bounds: [high; MAX_LEVELS + 1], count: 1 };
        levels.bounds[0] = low;
        match filter {
            Filter::TwoLevels(share) => levels.cut(f64::from(*share) * high),
            Filter::ThreeLevels => {
                for threshold in otsu(boxes, low, high) {
                    levels.cut(threshold);
                }
            }
            Filter::Thresholds { count, at } => {
                for &threshold in &at[..*count] {
                    levels.cut(f64::from(threshold));
                }
            }
        }
        levels.bounds[levels.count] = high;
        levels
    }

    fn cut(&mut self, threshold: f64) {
        self.bounds[self.count] = threshold;
        self.count += 1;
    }

    /// Number of levels.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The level of an object of this length: level k holds `[f_k, f_{k+1})`.
    pub fn of(&self, length: f64) -> usize {
        self.bounds[1..self.count].iter().filter(|&&f| length >= f).count()
    }

    /// The middle of a level's interval, Definition 1's average length.
    pub fn middle(&self, level: usize) -> f64 {
        0.5 * (self.bounds[level] + self.bounds[level + 1])
    }
}

/// Two thresholds that split the logarithms of the lengths into three classes
/// of least variance within (Otsu 1979): lengths spread over decades, and their
/// logarithms gather around the sizes of the things modelled.
fn otsu(boxes: &[Aabb], low: f64, high: f64) -> [f64; 2] {
    let (start, span) = (ln(low), (ln(high) - ln(low)).max(1e-9));
    let class =
        |length: f64| (((ln(length) - start) / span * CLASSES as f64) as usize).min(CLASSES - 1);
    let mut histogram = [0u32; CLASSES];
    for b in boxes {
        histogram[class(b.diagonal())] += 1;
    }
    // Prefix sums of counts and of counts times class.
    let mut mass = [[0.0f64; 2]; CLASSES + 1];
    for (i, &count) in histogram.iter().enumerate() {
        let count = f64::from(count);
        mass[i + 1] = [mass[i][0] + count, mass[i][1] + count * i as f64];
    }
    // Maximising the variance between classes minimises that within them.
    let between = |from: usize, to: usize| {
        let (count, sum) = (mass[to][0] - mass[from][0], mass[to][1] - mass[from][1]);
        if count > 0.0 { sum * sum / count } else { 0.0 }
    };
    let (mut best, mut at) = (-1.0, [1, 2]);
    for i in 1..CLASSES - 1 {
        for j in i + 1..CLASSES {
            let score = between(0, i) + between(i, j) + between(j, CLASSES);
            if score > best {
                (best, at) = (score, [i, j]);
            }
        }
    }
    // Back from a class's lower bound to the shortest length in it or above.
    at.map(|bound| {
        let lengths = boxes.iter().map(Aabb::diagonal).filter(|&d| class(d) >= bound);
        lengths.fold(high, f64::min)
    })
}
