//! Claims of section 7.5, and of section 8 from it: the HUG at equal memory and at equal time.

mod clusterings;
mod scenes;
mod tuned;

use self::tuned::{HUG, PRIMARY, TARGET, Tuned, time};
use super::{Claim, Verdict};
use crate::selected::equal::Reading;
use crate::selected::{Comparison, Entry, Judged, Walk};
use crate::sheet::number;

const NEEDED: &str = "the scene in rMAXP and u.f2.ALPHA";

pub fn claims(all: &[Comparison]) -> Vec<Claim> {
    vec![
        tuning(all),
        equal_time(
            all,
            "kit",
            "Tuned, a two-level HUG is as fast as the recursive grid in half the memory: kitchen",
            "3.99 against 7.87 MB, 45 s",
        ),
        equal_memory(
            all,
            "kit",
            "At equal memory it is 2.3 times as fast: kitchen",
            "2.3 (103 s against 45, 4 MB)",
        ),
        equal_time(all, "csb", "The same in half the memory: building", "\"the same\""),
        equal_memory(
            all,
            "csb",
            "Two to three times as fast in the same memory: building",
            "2 to 3",
        ),
        scenes::architecture(all),
        scenes::less_favourable(all),
        clusterings::either(all),
    ]
}

/// A figure where there is one.
fn or_not(x: Option<f64>) -> String {
    x.map_or("out of range".into(), number)
}

fn tuning(all: &[Comparison]) -> Claim {
    let what = "Tuning the world's subdivision improves the two-level HUG: kitchen";
    let paper = "\"the first improvement\"";
    let missing = || Claim::missing(what, paper, NEEDED);
    let Some(tuned) = Tuned::of(all, "kit", Walk::Steps, false) else { return missing() };
    let curve = || tuned.contest.curve(HUG);
    let (Some(one), Some(best)) =
        (curve().find(|e| e.value == "1"), curve().min_by(|a, b| time(a).total_cmp(&time(b))))
    else {
        return missing();
    };
    let (faster, larger) = (time(one) / time(best), best.megabytes() / one.megabytes());
    let calls = |e: &Entry| {
        let calls = e.costs[PRIMARY].calls;
        (calls.tests as f64, calls.voxels as f64)
    };
    Claim {
        what,
        paper,
        ours: format!(
            "{} is {} times as fast as alpha = 1, in {} times the memory",
            best.name,
            number(faster),
            number(larger)
        ),
        verdict: Verdict::of(faster >= 1.1, faster >= 1.03),
        reason: format!(
            "primary rays, steps of one voxel: {} times the tests of alpha = 1 and {} times its \
             voxels; tests are cheap beside steps here, eight triangles being rejected at once",
            number(calls(best).0 / calls(one).0),
            number(calls(best).1 / calls(one).1)
        ),
    }
}

fn equal_time(all: &[Comparison], short: &str, what: &'static str, paper: &'static str) -> Claim {
    let Some(tuned) = Tuned::of(all, short, Walk::Steps, false) else {
        return Claim::missing(what, paper, NEEDED);
    };
    let share = tuned.judged.smaller();
    let faster_than_all = matches!(tuned.judged.equal_cost, Reading::Below(_));
    let at_equal = match share {
        Some(share) => format!("{} of the memory of the recursive grid as fast", number(share)),
        None => format!(
            "no recursive grid as fast and no faster: {}",
            tuned.judged.beyond_cost().unwrap_or_default()
        ),
    };
    let ours = match tuned.share_of_target() {
        Some(of_target) => format!("{at_equal}; {} of that of {TARGET}", number(of_target)),
        None => format!("{at_equal}; no HUG as fast as {TARGET}"),
    };
    let exits = Tuned::of(all, short, Walk::Exits, false).and_then(|t| t.judged.smaller());
    Claim {
        what,
        paper,
        ours,
        verdict: match share {
            Some(share) => Verdict::of(share <= 0.6, share <= 0.9),
            // The smallest recursive grid is faster already, or none is as fast.
            None => Verdict::of(faster_than_all, false),
        },
        reason: format!(
            "{}; share of memory at equal voxels and tests: {}, at equal time with exit boxes: {}; \
             the least over alpha: {}",
            tuned.figures(),
            or_not(tuned.by_work().and_then(|j| j.smaller())),
            or_not(exits),
            tuned.along(Judged::smaller, false)
        ),
    }
}

fn equal_memory(all: &[Comparison], short: &str, what: &'static str, paper: &'static str) -> Claim {
    let Some(tuned) = Tuned::of(all, short, Walk::Steps, true) else {
        return Claim::missing(what, paper, NEEDED);
    };
    let faster = tuned.judged.faster();
    let ours = match faster {
        Some(faster) => format!("{} times as fast", number(faster)),
        None => format!(
            "no recursive grid of its memory: {}",
            tuned.judged.beyond_memory().unwrap_or_default()
        ),
    };
    let exits = Tuned::of(all, short, Walk::Exits, true).and_then(|t| t.judged.faster());
    Claim {
        what,
        paper,
        ours,
        verdict: match faster {
            Some(faster) => Verdict::of(faster >= 1.8, faster >= 1.1),
            None => Verdict::NotMeasured,
        },
        reason: format!(
            "{}; times as many voxels and tests of the recursive grid in this memory: {}; times as \
             fast with exit boxes: {}; the most over alpha: {}",
            tuned.figures(),
            or_not(tuned.by_work().and_then(|j| j.faster())),
            or_not(exits),
            tuned.along(Judged::faster, true)
        ),
    }
}
