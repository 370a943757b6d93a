//! A structure beside the recursive grid of its memory, and beside that of its cost.

use super::contest::Contest;
use super::curves::RECURSIVE;
use super::entry::Entry;
use super::equal::{CostCurve, Reading};
use crate::sheet::number;

/// What is set against memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ordinate {
    /// Nanoseconds a ray, medians.
    Time,
    /// Voxels and tests a ray.
    Work,
}

impl Ordinate {
    pub const ALL: [Self; 2] = [Self::Time, Self::Work];

    pub fn text(self) -> &'static str {
        match self {
            Self::Time => "time, ns a ray",
            Self::Work => "voxels and tests a ray",
        }
    }

    pub fn file(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::Work => "work",
        }
    }

    pub fn of(self, entry: &Entry, set: usize) -> f64 {
        match self {
            Self::Time => entry.costs[set].time.median,
            Self::Work => entry.costs[set].work(),
        }
    }
}

/// A structure for a set of rays, by one ordinate.
pub struct Judged {
    pub megabytes: f64,
    pub cost: f64,
    /// The recursive grid's cost in as much memory.
    pub equal_memory: Reading,
    /// The recursive grid's megabytes at the same cost.
    pub equal_cost: Reading,
    /// Megabytes of the triangles, which both need besides.
    triangles: f64,
}

impl Judged {
    /// `None` without a recursive grid.
    pub fn new(contest: &Contest, entry: &Entry, set: usize, ordinate: Ordinate) -> Option<Self> {
        let points = contest.curve(RECURSIVE).map(|e| (e.megabytes(), ordinate.of(e, set)));
        let curve = CostCurve::new(points)?;
        let (megabytes, cost) = (entry.megabytes(), ordinate.of(entry, set));
        Some(Self {
            megabytes,
            cost,
            equal_memory: curve.cost_at(megabytes),
            equal_cost: curve.memory_at(cost),
            triangles: entry.triangle_bytes as f64 / f64::from(1 << 20),
        })
    }

    /// How many times as fast as the recursive grid in the same memory.
    pub fn faster(&self) -> Option<f64> {
        Some(self.equal_memory.at()? / self.cost)
    }

    /// The share of memory needed of that of the recursive grid with the same cost.
    pub fn smaller(&self) -> Option<f64> {
        Some(self.megabytes / self.equal_cost.at()?)
    }

    /// The same of memory with the triangles.
    pub fn smaller_with_triangles(&self) -> Option<f64> {
        let other = self.equal_cost.at()?;
        Some((self.megabytes + self.triangles) / (other + self.triangles))
    }

    /// Where there is no recursive grid of this memory.
    pub fn beyond_memory(&self) -> Option<String> {
        match self.equal_memory {
            Reading::At(_) => None,
            Reading::Below(least) => Some(format!("smaller than any ({} MB)", number(least))),
            Reading::Above(most) => Some(format!("larger than any ({} MB)", number(most))),
        }
    }

    /// Where there is none of this cost.
    pub fn beyond_cost(&self) -> Option<String> {
        match self.equal_cost {
            Reading::At(_) => None,
            Reading::Below(least) => Some(format!("cheaper than any ({})", number(least))),
            Reading::Above(first) => Some(format!("dearer than the smallest ({})", number(first))),
        }
    }
}
