//! Claims of section 6: which calls there are, and where.

use super::{Claim, Evidence, Verdict};
use crate::sheet::number;

pub fn claims(e: &Evidence<'_>) -> Vec<Claim> {
    vec![few_hits(e)]
}

fn few_hits(e: &Evidence<'_>) -> Claim {
    let what = "Fewer than 5 % of the polygon tests are hits";
    let paper = "3.0 % (HUG), 3.6 % (r50)";
    let (Some(hug), Some(r50)) = (e.kitchen("u.f3.sqrt2"), e.kitchen("r50")) else {
        return Claim::missing(what, paper, "kit.u.f3.sqrt2 and kit.r50");
    };
    let share = |built: &crate::measure::Built| {
        let c = &built.rendered[0].counters;
        100.0 * c.hits as f64 / c.tests.max(1) as f64
    };
    let (of_hug, of_r50) = (share(hug), share(r50));
    let tests = |built: &crate::measure::Built, rays: usize| {
        number(built.rendered[0].counters.tests as f64 / rays as f64)
    };
    let frame = e.scene("kit").map_or(1, |s| s.frames[0].primary.len() + s.frames[0].shadow.len());
    Claim {
        what,
        paper,
        ours: format!("{} % (HUG), {} % (r50)", number(of_hug), number(of_r50)),
        verdict: Verdict::of(of_hug < 5.0 && of_r50 < 5.0, of_hug.min(of_r50) < 10.0),
        reason: format!(
            "{} and {} tests a ray, of which at most a few can be hits that move the limit nearer",
            tests(hug, frame),
            tests(r50, frame)
        ),
    }
}
