//! Claims about time, and about time for memory.

use super::{Claim, Evidence, Verdict};
use crate::measure::{Built, Subject};
use crate::sheet::number;
use hug::Calls;

pub fn claims(e: &Evidence<'_>) -> Vec<Claim> {
    let mut claims = vec![uniform_slower(e), root_two(e)];
    claims.push(equal_memory(
        e,
        "kit",
        "At equal memory the HUG is two to three times faster than the recursive grid: kitchen",
    ));
    claims.push(equal_memory(e, "csb", "The same: building"));
    claims.push(equal_time(e, "kit", "At equal time the HUG needs half the memory: kitchen"));
    claims.push(equal_time(e, "csb", "The same: building"));
    claims.push(growth(
        e,
        "u.f3.sqrt2",
        "From the wide view to the bowl view time grows: HUG",
        "1.29",
        1.29,
    ));
    claims.push(growth(
        e,
        "r50",
        "From the wide view to the bowl view time grows: recursive grid",
        "1.37",
        1.37,
    ));
    claims
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

/// The HUG that the paper compares in section 7.5.
const HUG: &str = "u.f2.sqrt2";

fn contest<'a>(e: &Evidence<'a>, scene: &str) -> Option<(&'a Subject, &'a Built, f64)> {
    let subject = e.scene(scene)?;
    let hug = subject.find(HUG)?;
    Some((subject, hug, hug.time(0)?))
}

fn equal_memory(e: &Evidence<'_>, scene: &str, what: &'static str) -> Claim {
    let paper = if scene == "kit" { "2.3 (103 s against 45)" } else { "2 to 3" };
    let missing = || Claim::missing(what, paper, "recursive grids of many MAXP and u.f2.sqrt2");
    let Some((subject, hug, time)) = contest(e, scene) else { return missing() };
    // The finest that takes no more; if all take more, the one that takes least.
    let fits = |b: &&&Built| b.megabytes() <= hug.megabytes();
    let all = subject.all_recursive();
    let least = || all.iter().min_by(|a, b| a.megabytes().total_cmp(&b.megabytes()));
    let other = all.iter().find(fits).or_else(least);
    let Some((other, theirs)) = other.and_then(|b| Some((*b, b.time(0)?))) else {
        return missing();
    };
    let ratio = theirs / time;
    let tests = |b: &Built| b.calls(0).tests as f64;
    let voxels = |b: &Built| b.calls(0).voxels as f64;
    Claim {
        what,
        paper,
        ours: format!("{} times as fast as {}", number(ratio), other.name),
        verdict: Verdict::of(ratio >= 1.8, ratio >= 1.1),
        reason: format!(
            "view {}: {} MB against {}; the recursive grid makes {} times the tests and traverses \
             {} times the voxels; sum of %vol of the HUG {}",
            subject.frames[0].view,
            number(hug.megabytes()),
            number(other.megabytes()),
            number(tests(other) / tests(hug)),
            number(voxels(other) / voxels(hug)),
            number(100.0 * hug.stats.total.volume)
        ),
    }
}

/// Times within this factor are equal.
const SAME: f64 = 1.1;

fn equal_time(e: &Evidence<'_>, scene: &str, what: &'static str) -> Claim {
    let paper = if scene == "kit" { "3.99 against 7.87 MB" } else { "half" };
    let missing = || Claim::missing(what, paper, "recursive grids of many MAXP and u.f2.sqrt2");
    let Some((subject, hug, time)) = contest(e, scene) else { return missing() };
    // The smallest that is no slower, as far as a clock can tell.
    let fast = |b: &&&Built| b.time(0).is_some_and(|t| t <= SAME * time);
    let all = subject.all_recursive();
    let smallest =
        all.iter().filter(fast).min_by(|a, b| a.megabytes().total_cmp(&b.megabytes())).copied();
    let Some(other) = smallest else {
        let fastest = all.iter().filter_map(|b| b.time(0)).fold(f64::INFINITY, f64::min);
        return Claim {
            what,
            paper,
            ours: "no recursive grid is as fast".into(),
            verdict: Verdict::Holds,
            reason: format!(
                "the fastest of {} takes {} ms, the HUG {} ms in {} MB",
                all.len(),
                number(1e3 * fastest),
                number(1e3 * time),
                number(hug.megabytes())
            ),
        };
    };
    let ratio = hug.megabytes() / other.megabytes();
    Claim {
        what,
        paper,
        ours: format!(
            "{} against {} MB ({})",
            number(hug.megabytes()),
            number(other.megabytes()),
            other.name
        ),
        verdict: Verdict::of(ratio <= 0.6, ratio <= 0.9),
        reason: format!(
            "view {}: {} ms against {} ms of the smallest recursive grid that is no slower; \
             pointers {} against {}",
            subject.frames[0].view,
            number(1e3 * time),
            number(1e3 * other.time(0).unwrap_or_default()),
            hug.stats.total.pointers(),
            other.stats.total.pointers()
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
