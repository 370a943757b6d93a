//! Claims of section 6: which calls there are, and on which level.

use super::{Claim, Evidence, Verdict};
use crate::measure::Built;
use crate::sheet::number;
use hug::Calls;

pub fn claims(e: &Evidence<'_>) -> Vec<Claim> {
    vec![
        few_hits(e),
        level(
            e,
            &Place {
                what: "In the wide view most tests come from the HUG's highest level",
                paper: "85.6 %",
                notation: "u.f3.sqrt2",
                frame: 0,
                below_top: 0,
            },
        ),
        level(
            e,
            &Place {
                what: "In the wide view most tests come from the recursive grid's highest level",
                paper: "79.5 %",
                notation: "r50",
                frame: 0,
                below_top: 0,
            },
        ),
        level(
            e,
            &Place {
                what: "In the zoom the HUG's tests move to level 0",
                paper: "57.9 %",
                notation: "u.f3.sqrt2",
                frame: 1,
                below_top: 2,
            },
        ),
        level(
            e,
            &Place {
                what: "In the zoom the recursive grid's tests move one level down, to level 2",
                paper: "79.4 %",
                notation: "r50",
                frame: 1,
                below_top: 1,
            },
        ),
        further(e),
    ]
}

fn share(part: u64, whole: u64) -> f64 {
    100.0 * part as f64 / whole.max(1) as f64
}

fn few_hits(e: &Evidence<'_>) -> Claim {
    let what = "Fewer than 5 % of the polygon tests are hits";
    let paper = "3.0 % (HUG), 3.6 % (r50)";
    let (Some(kitchen), Some(hug), Some(r50)) =
        (e.scene("kit"), e.kitchen("u.f3.sqrt2"), e.kitchen("r50"))
    else {
        return Claim::missing(what, paper, "kit.u.f3.sqrt2 and kit.r50");
    };
    let of = |calls: Calls| calls.percent_hits();
    let (of_hug, of_r50) = (of(hug.calls(0)), of(r50.calls(0)));
    let rays = kitchen.frames.first().map_or(1, |f| f.primary.len() + f.shadow.len());
    let a_ray = |n: u64| number(n as f64 / rays as f64);
    Claim {
        what,
        paper,
        ours: format!("{} % (HUG), {} % (r50)", number(of_hug), number(of_r50)),
        verdict: Verdict::of(of_hug < 5.0 && of_r50 < 5.0, of_hug.min(of_r50) < 7.5),
        reason: format!(
            "wide view, a ray: {} tests and {} hits (HUG), {} and {} (r50)",
            a_ray(hug.calls(0).tests),
            a_ray(hug.calls(0).hits),
            a_ray(r50.calls(0).tests),
            a_ray(r50.calls(0).hits)
        ),
    }
}

/// Where the paper finds most tests.
struct Place {
    what: &'static str,
    paper: &'static str,
    notation: &'static str,
    frame: usize,
    /// Levels below the outermost.
    below_top: usize,
}

fn level(e: &Evidence<'_>, place: &Place) -> Claim {
    let built: Option<&Built> = e.kitchen(place.notation);
    let Some((built, rendered)) = built.and_then(|b| Some((b, b.rendered.get(place.frame)?)))
    else {
        return Claim::missing(place.what, place.paper, "the kitchen in that structure");
    };
    let levels = &rendered.profile.levels()[..built.stats.levels().len()];
    let total = rendered.profile.total();
    let tests: Vec<f64> = levels.iter().rev().map(|l| share(l.tests, total.tests)).collect();
    let there = tests.get(place.below_top).copied().unwrap_or(0.0);
    let largest = tests.iter().copied().fold(0.0, f64::max);
    let voxels: Vec<String> =
        levels.iter().rev().map(|l| number(share(l.voxels, total.voxels))).collect();
    let list: Vec<String> = tests.iter().map(|&x| number(x)).collect();
    Claim {
        what: place.what,
        paper: place.paper,
        ours: format!("{} %", number(there)),
        verdict: Verdict::of(there >= 50.0, there == largest),
        reason: format!(
            "{}, from the outermost level down: %pit {}; %vt {}",
            built.name,
            list.join(", "),
            voxels.join(", ")
        ),
    }
}

/// What makes the costs differ by the paper's account: how far the test goes.
fn further(e: &Evidence<'_>) -> Claim {
    let what = "The ray-polygon test goes further in the structures that make fewer tests: %s2 of \
                r50 is about 4 times that of r500";
    let paper = "6.63 against 1.69 %";
    let pair = e.scene("csb").and_then(|s| {
        let frame = s.frames.iter().position(|f| f.view == "desk")?;
        Some((frame, s.find("r50")?, s.find("r500")?))
    });
    let Some((frame, r50, r500)) = pair else {
        return Claim::missing(what, paper, "csbc.r50 and csbc.r500");
    };
    let (fine, coarse) = (r50.calls(frame), r500.calls(frame));
    let (a, b) = (fine.percent_passed_2(), coarse.percent_passed_2());
    let ratio = a / b.max(f64::MIN_POSITIVE);
    Claim {
        what,
        paper,
        ours: format!("{} against {} %", number(a), number(b)),
        verdict: Verdict::of(ratio >= 2.5, ratio >= 1.3),
        reason: format!(
            "a factor of {}; tests {} against {}; %s1 {} and {}",
            number(ratio),
            fine.tests,
            coarse.tests,
            number(fine.percent_passed_1()),
            number(coarse.percent_passed_1())
        ),
    }
}
