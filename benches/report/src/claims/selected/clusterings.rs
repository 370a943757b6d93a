//! The two clusterings beside each other.

use super::tuned::{HUG, PRIMARY, time};
use super::{Claim, Verdict};
use crate::selected::{Comparison, Entry, Walk};
use crate::sheet::number;

const COMPONENTS: &str = "u.f2.ALPHA+components";
/// Factors nearer to 1 than this do not matter.
const SAME: f64 = 1.1;

/// Components over projections, geometric means over all that both curves have.
struct Beside {
    short: &'static str,
    time: f64,
    work: f64,
    memory: f64,
    /// The fastest of one over the fastest of the other.
    best: f64,
}

impl Beside {
    fn of(all: &[Comparison], short: &'static str) -> Option<Self> {
        let contest = all.iter().find(|c| c.short == short)?.contest(Walk::Steps)?;
        let pairs: Vec<(&Entry, &Entry)> = contest
            .curve(HUG)
            .filter_map(|old| {
                Some((old, contest.curve(COMPONENTS).find(|new| new.value == old.value)?))
            })
            .collect();
        let mean = |of: fn(&Entry) -> f64| {
            let logs: f64 = pairs.iter().map(|(old, new)| (of(new) / of(old)).ln()).sum();
            (logs / pairs.len() as f64).exp()
        };
        let fastest = |curve| contest.curve(curve).map(time).min_by(f64::total_cmp);
        (!pairs.is_empty()).then_some(Self {
            short,
            time: mean(time),
            work: mean(|e| e.costs[PRIMARY].work()),
            memory: mean(Entry::megabytes),
            best: fastest(COMPONENTS)? / fastest(HUG)?,
        })
    }

    fn same(&self) -> bool {
        [self.time, self.best].iter().all(|x| (1.0 / SAME..=SAME).contains(x))
    }
}

pub fn either(all: &[Comparison]) -> Claim {
    let what = "For scenes prone to clustering either clustering does: kitchen, building";
    let paper = "\"does not really matter\"";
    let found: Option<Vec<Beside>> =
        ["kit", "csb"].into_iter().map(|short| Beside::of(all, short)).collect();
    let Some(found) = found else {
        let needed = "the kitchen and the building in u.f2.ALPHA, with and without +components";
        return Claim::missing(what, paper, needed);
    };
    let list = |of: &dyn Fn(&Beside) -> String| {
        found.iter().map(|b| format!("{} {}", b.short, of(b))).collect::<Vec<_>>().join(", ")
    };
    Claim {
        what,
        paper,
        ours: format!(
            "components over projections, time of a primary ray: {}",
            list(&|b| number(b.time))
        ),
        verdict: Verdict::of(found.iter().all(Beside::same), found.iter().any(Beside::same)),
        reason: format!(
            "u.f2, clusters of any size, steps of one voxel; geometric means over alpha; voxels \
             and tests: {}; memory: {}; the fastest over the fastest: {}",
            list(&|b| number(b.work)),
            list(&|b| number(b.memory)),
            list(&|b| number(b.best))
        ),
    }
}
