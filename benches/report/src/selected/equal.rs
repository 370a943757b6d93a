//! The recursive grid at equal memory, and at equal cost: between those built, by interpolation
//! of the logarithms; beyond them, not at all.

/// What a curve says of a given memory or cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reading {
    At(f64),
    /// The given is less than the curve has anywhere: that end of it.
    Below(f64),
    /// It is more: that end of the curve.
    Above(f64),
}

impl Reading {
    pub fn at(self) -> Option<f64> {
        match self {
            Self::At(value) => Some(value),
            _ => None,
        }
    }
}

/// Cost over memory, least memory first. Structures of the same size are as a rule the same, timed
/// twice: their geometric mean counts, for the least would only be the luckiest.
#[derive(Clone, Debug)]
pub struct CostCurve(Vec<(f64, f64)>);

impl CostCurve {
    /// Of points of memory and cost; `None` unless one of them is positive and finite.
    pub fn new(points: impl IntoIterator<Item = (f64, f64)>) -> Option<Self> {
        let proper = |x: f64| x.is_finite() && x > 0.0;
        let mut points: Vec<(f64, f64)> =
            points.into_iter().filter(|p| proper(p.0) && proper(p.1)).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mean = |same: &[(f64, f64)]| {
            let logs: f64 = same.iter().map(|p| (p.1 / same[0].1).ln()).sum();
            (same[0].0, same[0].1 * (logs / same.len() as f64).exp())
        };
        let points: Vec<(f64, f64)> = points.chunk_by(|a, b| a.0 == b.0).map(mean).collect();
        (!points.is_empty()).then_some(Self(points))
    }

    /// What a structure of this memory costs. Below and above: the least and the most memory.
    pub fn cost_at(&self, memory: f64) -> Reading {
        let (first, last) = (self.0[0].0, self.0[self.0.len() - 1].0);
        let next = self.0.partition_point(|p| p.0 < memory);
        match self.0.get(next) {
            None => Reading::Above(last),
            Some(&(here, cost)) if here == memory => Reading::At(cost),
            Some(_) if next == 0 => Reading::Below(first),
            Some(&b) => Reading::At(between(self.0[next - 1], b, memory)),
        }
    }

    /// The least memory with which the cost is this or less. Below: the least cost of all, which
    /// is more than the given. Above: the cost with the least memory, which is less: how far that
    /// memory could fall is not known.
    pub fn memory_at(&self, cost: f64) -> Reading {
        let (memory, first) = self.0[0];
        if first == cost {
            return Reading::At(memory);
        }
        if first < cost {
            return Reading::Above(first);
        }
        // The cost need not fall all the way: where it first comes to the given.
        let turned = |p: (f64, f64)| (p.1, p.0);
        let crossing = self.0.windows(2).find(|pair| pair[1].1 <= cost);
        match crossing {
            Some(pair) => Reading::At(between(turned(pair[0]), turned(pair[1]), cost)),
            None => Reading::Below(self.0.iter().map(|p| p.1).fold(f64::INFINITY, f64::min)),
        }
    }
}

/// The line through two points of different x, on logarithmic scales.
fn between(a: (f64, f64), b: (f64, f64), x: f64) -> f64 {
    let share = (x / a.0).ln() / (b.0 / a.0).ln();
    a.1 * (b.1 / a.1).powf(share)
}
