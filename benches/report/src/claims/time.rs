//! Claims about time.

use super::{Claim, Evidence, Verdict};
use crate::measure::Built;
use crate::sheet::number;
use hug::Calls;

pub fn claims(e: &Evidence<'_>) -> Vec<Claim> {
    vec![
        uniform_slower(e),
        root_two(e),
        growth(
            e,
            "u.f3.sqrt2",
            "From the wide view to the bowl view time grows: HUG",
            "1.29",
            1.29,
        ),
        growth(
            e,
            "r50",
            "From the wide view to the bowl view time grows: recursive grid",
            "1.37",
            1.37,
        ),
    ]
}

fn uniform_slower(e: &Evidence<'_>) -> Claim {
    let what = "On the kitchen the uniform grid is about 5 times slower than the other two";
    let paper = "5";
    let (Some(g), Some(hug), Some(r50)) =
        (e.kitchen_uniform(), e.kitchen("u.f3.sqrt2"), e.kitchen("r50"))
    else {
        return Claim::missing(what, paper, "the kitchen in a uniform grid, u.f3.sqrt2 and r50");
    };
    let ratios: Vec<[f64; 2]> = g
        .rendered
        .iter()
        .enumerate()
        .filter_map(|(i, r)| {
            Some([r.seconds.median / hug.time(i)?, r.seconds.median / r50.time(i)?])
        })
        .collect();
    let text = |r: &[f64; 2]| format!("{} and {}", number(r[0]), number(r[1]));
    let wide = ratios.first().copied().unwrap_or([0.0; 2]);
    let views: Vec<String> = ratios.iter().map(text).collect();
    let most = ratios.iter().flatten().copied().fold(0.0, f64::max);
    let per = |b: &Built, of: fn(&Calls) -> u64| {
        let views = 0..g.rendered.len();
        let ratios = views.map(|v| of(&g.calls(v)) as f64 / of(&b.calls(v)).max(1) as f64);
        ratios.map(number).collect::<Vec<_>>().join(" and ")
    };
    Claim {
        what,
        paper,
        ours: format!("slower than HUG and r50, view by view: {}", views.join("; ")),
        verdict: Verdict::of(wide.iter().all(|&r| r >= 3.0), most >= 3.0),
        reason: format!(
            "view by view it makes {} times the tests of the HUG and {} times those of r50, but \
             traverses {} and {} times their voxels; a test costs little here, eight triangles \
             being rejected at once",
            per(hug, |c| c.tests),
            per(r50, |c| c.tests),
            per(hug, |c| c.voxels),
            per(r50, |c| c.voxels)
        ),
    }
}

fn root_two(e: &Evidence<'_>) -> Claim {
    let what = "The sqrt(2) criterion pays in time and costs little memory";
    let paper = "\"substantial\", \"no significant\" overhead";
    let (Some(one), Some(root)) = (e.kitchen("u.f3.1"), e.kitchen("u.f3.sqrt2")) else {
        return Claim::missing(what, paper, "kit.u.f3.1 and kit.u.f3.sqrt2");
    };
    let (Some(before), Some(after)) = (one.time(0), root.time(0)) else {
        return Claim::missing(what, paper, "a view of the kitchen");
    };
    let (faster, larger) = (before / after, root.megabytes() / one.megabytes());
    let c = |b: &Built| (b.calls(0).tests as f64, b.calls(0).voxels as f64);
    let (fewer, more) = (c(one).0 / c(root).0, c(root).1 / c(one).1);
    Claim {
        what,
        paper,
        ours: format!("{} times as fast, {} times the memory", number(faster), number(larger)),
        verdict: Verdict::of(faster >= 1.05 && larger <= 1.25, faster >= 1.05 || larger <= 1.25),
        reason: format!(
            "kit.u.f3, wide view: tests fall by a factor of {}, voxels traversed grow by {}; \
             where tests are cheap beside steps the two cancel",
            number(fewer),
            number(more)
        ),
    }
}

fn growth(
    e: &Evidence<'_>,
    notation: &str,
    what: &'static str,
    paper: &'static str,
    factor: f64,
) -> Claim {
    let missing = || Claim::missing(what, paper, "two views of the kitchen");
    let Some(built) = e.kitchen(notation) else { return missing() };
    let (Some(wide), Some(bowl)) = (built.rendered.first(), built.rendered.get(1)) else {
        return missing();
    };
    let ratio = bowl.seconds.median / wide.seconds.median;
    let per = |a: u64, b: u64| number(a as f64 / b.max(1) as f64);
    Claim {
        what,
        paper,
        ours: number(ratio),
        verdict: Verdict::of((ratio / factor - 1.0).abs() <= 0.15, ratio > 1.0),
        reason: format!(
            "{}: tests grow by {}, voxels by {}, grids by {}",
            built.name,
            per(bowl.profile.total().tests, wide.profile.total().tests),
            per(bowl.profile.total().voxels, wide.profile.total().voxels),
            per(bowl.profile.total().grids, wide.profile.total().grids)
        ),
    }
}
