//! Claims of section 7.5, and of section 8 from it: the HUG at equal memory and at equal time.

mod tuned;

use self::tuned::{HUG, PRIMARY, Tuned, time};
use super::{Claim, Verdict};
use crate::selected::equal::Reading;
use crate::selected::{Comparison, Entry, Judged, Ordinate, Walk};
use crate::sheet::number;
use crate::tables::selected::beyond;

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
        architecture(all),
        less_favourable(all),
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
    let ours = match share {
        Some(share) => format!("{} of the memory", number(share)),
        None => format!("no recursive grid to compare with: {}", beyond(&tuned.judged)),
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
        None => format!("no recursive grid to compare with: {}", beyond(&tuned.judged)),
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

fn architecture(all: &[Comparison]) -> Claim {
    let what = "The improved HUG is three times faster than the recursive grid on architecture \
                (section 8)";
    let paper = "3";
    let best = |short| {
        let contest = all.iter().find(|c| c.short == short)?.contest(Walk::Steps)?;
        let hugs = contest.entries.iter().filter(|e| e.curve.starts_with("u."));
        let ratios = hugs.filter_map(|e| {
            let faster = Judged::new(contest, e, PRIMARY, Ordinate::Time)?.faster()?;
            Some((faster, e.name.clone()))
        });
        let best = ratios.clone().max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((best, ratios.count()))
    };
    let (Some((kitchen, kitchens)), Some((building, buildings))) = (best("kit"), best("csb"))
    else {
        return Claim::missing(what, paper, "the kitchen and the building in rMAXP and HUGs");
    };
    let text = |(x, name): &(f64, String)| format!("{} ({name})", number(*x));
    Claim {
        what,
        paper,
        ours: format!("at best {}, {}", text(&kitchen), text(&building)),
        verdict: Verdict::of(
            kitchen.0 >= 2.5 && building.0 >= 2.5,
            kitchen.0 >= 1.5 || building.0 >= 1.5,
        ),
        reason: format!(
            "over the {kitchens} and {buildings} HUGs in whose memory there is a recursive grid of MAXP \
             from 10 to 1000; primary rays, steps of one voxel"
        ),
    }
}

fn less_favourable(all: &[Comparison]) -> Claim {
    let what = "On the garden and the city the HUG does less well than on architecture";
    let paper = "\"the situation is less favorable\"";
    let ratio = |short| {
        let tuned = Tuned::of(all, short, Walk::Steps, true)?;
        Some((tuned.judged.faster()?, tuned.hug.volume))
    };
    let scenes = ["kit", "csb", "gar", "city"];
    let found: Option<Vec<(f64, f64)>> = scenes.into_iter().map(ratio).collect();
    let Some(found) = found else {
        return Claim::missing(
            what,
            paper,
            "kitchen, building, garden and city, each with a recursive grid of the HUG's memory",
        );
    };
    let list = |of: fn(&(f64, f64)) -> f64| {
        let each = scenes.iter().zip(&found).map(|(s, f)| format!("{s} {}", number(of(f))));
        each.collect::<Vec<_>>().join(", ")
    };
    let [kitchen, building, garden, city] = [0, 1, 2, 3].map(|i| found[i].0);
    Claim {
        what,
        paper,
        ours: format!("times as fast at equal memory: {}", list(|f| f.0)),
        verdict: Verdict::of(
            garden.max(city) < kitchen.min(building),
            garden + city < kitchen + building,
        ),
        reason: format!(
            "the tuned two-level HUG, primary rays; where clusters overlap a ray crosses the same \
             space in several grids: sum of %vol {}",
            list(|f| f.1)
        ),
    }
}
