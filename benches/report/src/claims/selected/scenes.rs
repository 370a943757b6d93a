//! Claims about kinds of scenes.

use super::tuned::{PRIMARY, Tuned};
use super::{Claim, Verdict};
use crate::selected::{Comparison, Judged, Ordinate, Walk};
use crate::sheet::number;

pub fn architecture(all: &[Comparison]) -> Claim {
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

pub fn less_favourable(all: &[Comparison]) -> Claim {
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
