//! Claims of sections 7.3 to 7.5: clusters as components of the box graph, counts of voxels from
//! overlap numbers, and the memory that components take.

use super::{Claim, Evidence, Verdict};
use crate::measure::Subject;
use crate::sheet::number;
use hug::build::{self, Survey};
use hug::{Clustering, Counters, Gridding, Options, Structure};

pub fn claims(e: &Evidence<'_>) -> Vec<Claim> {
    vec![denied(e), tighter(e), overlap(e), memory(e)]
}

const HUG: fn() -> Options = || Options { structure: Structure::Hug, ..Options::default() };

/// What the clusterings make of each scene that has anything to cluster, by name.
fn surveys<'a>(e: &'a Evidence<'_>) -> Vec<(&'a str, Survey)> {
    let of = |s: &'a Subject| {
        let survey = Survey::new(&s.loaded.soup(), &HUG()).ok()?;
        (survey.pairs > 0).then_some((s.short.as_str(), survey))
    };
    e.0.iter().filter_map(of).collect()
}

fn list(parts: impl Iterator<Item = String>) -> String {
    parts.collect::<Vec<_>>().join(", ")
}

fn denied(e: &Evidence<'_>) -> Claim {
    let what = "Of the boxes that intersect in the plane, three quarters do not along z";
    let paper = "3/4";
    let all = surveys(e);
    if all.is_empty() {
        return Claim::missing(what, paper, "a scene with triangles below 5 % of the longest");
    }
    let shares: Vec<f64> = all.iter().map(|(_, s)| 100.0 * s.denied()).collect();
    let mean = shares.iter().sum::<f64>() / shares.len() as f64;
    let pairs =
        |(name, s): &(&str, Survey)| format!("{name}: {} of {} are left", s.pairs, s.plane_pairs);
    Claim {
        what,
        paper,
        ours: list(
            all.iter().zip(&shares).map(|((name, _), x)| format!("{name} {} %", number(*x))),
        ),
        verdict: Verdict::of((mean - 75.0).abs() <= 10.0, (mean - 75.0).abs() <= 20.0),
        reason: format!("{} % on the average; {}", number(mean), list(all.iter().map(pairs))),
    }
}

fn tighter(e: &Evidence<'_>) -> Claim {
    let what = "Components are tighter clusters: the sum of %vol falls, to below 120 where \
                projections exceed it";
    let paper = "figures 27 to 29";
    let all = surveys(e);
    if all.is_empty() {
        return Claim::missing(what, paper, "a scene with triangles below 5 % of the longest");
    }
    let volumes = |s: &Survey| [s.projections.volume, s.components.volume].map(|v| 100.0 * v);
    let fall = all.iter().all(|(_, s)| volumes(s)[1] <= volumes(s)[0]);
    let below = all.iter().filter(|(_, s)| volumes(s)[1] <= 120.0).count();
    Claim {
        what,
        paper,
        ours: list(all.iter().map(|(name, s)| {
            let [before, after] = volumes(s);
            format!("{name} {} to {}", number(before), number(after))
        })),
        verdict: Verdict::of(fall && below == all.len(), fall),
        reason: list(all.iter().map(|(name, s)| {
            format!(
                "{name}: {} grids of {} triangles, then {} of {}",
                s.projections.grids,
                s.projections.objects,
                s.components.grids,
                s.components.objects
            )
        })),
    }
}

/// Voxels and tests of the first picture's primary rays, in a HUG of components.
fn steps(subject: &Subject, gridding: Gridding) -> Option<f64> {
    let options = Options { gridding, clustering: Clustering::Components, ..HUG() };
    let scene = subject.loaded.build(&options).ok()?;
    let mut sum = Counters::default();
    for ray in &subject.frames.first()?.primary {
        scene.view().intersect_counted(ray, &mut sum);
    }
    Some((sum.grids + sum.voxels + sum.tests) as f64)
}

fn overlap(e: &Evidence<'_>) -> Claim {
    let what = "No function of the overlap numbers gives counts of voxels that are satisfactorily \
                better";
    let paper = "none found";
    let ratio = |s: &Subject| {
        let plain = steps(s, Gridding::Proportional)?;
        let best = [Gridding::Overlap, Gridding::Mixed].map(|g| steps(s, g));
        Some((s.short.clone(), best.map(|b| b.map(|b| b / plain))))
    };
    let all: Vec<(String, [Option<f64>; 2])> = e.0.iter().filter_map(ratio).collect();
    let mean = |i: usize| {
        let known: Vec<f64> = all.iter().filter_map(|(_, r)| r[i]).collect();
        (known.iter().map(|r| r.ln()).sum::<f64>() / known.len().max(1) as f64).exp()
    };
    if all.is_empty() {
        return Claim::missing(what, paper, "a scene");
    }
    let best = mean(0).min(mean(1));
    Claim {
        what,
        paper,
        ours: format!(
            "{} (overlap) and {} (mixed) times the steps",
            number(mean(0)),
            number(mean(1))
        ),
        verdict: Verdict::of(best > 0.95, best > 0.8),
        reason: format!(
            "grids, voxels and tests of the first picture's primary rays in a HUG of components, \
             over those with counts by the sides of the box: {}",
            list(all.iter().map(|(name, r)| {
                let [a, b] = r.map(|r| number(r.unwrap_or(f64::NAN)));
                format!("{name} {a} and {b}")
            }))
        ),
    }
}

fn memory(e: &Evidence<'_>) -> Claim {
    let what = "The new clustering needs more memory to build than the initial one: as much as the \
                recursive grid";
    let paper = "\"memory fragmentation\"";
    let needs = |s: &Subject, options: Options| build::measure(&s.loaded.soup(), &options).ok();
    let of = |s: &Subject| {
        let old = needs(s, HUG())?;
        let new = needs(s, Options { clustering: Clustering::Components, ..HUG() })?;
        let recursive = needs(s, Options { structure: Structure::Recursive, ..HUG() })?;
        Some((s.short.clone(), [old, new, recursive].map(|sizes| sizes.scratch)))
    };
    let all: Vec<(String, [usize; 3])> = e.0.iter().filter_map(of).collect();
    if all.is_empty() {
        return Claim::missing(what, paper, "a scene");
    }
    let more = all.iter().any(|(_, [old, new, _])| new > old);
    let as_recursive = all.iter().all(|(_, [_, new, recursive])| new >= recursive);
    let megabytes = |bytes: usize| number(bytes as f64 / f64::from(1 << 20));
    Claim {
        what,
        paper,
        ours: list(all.iter().map(|(name, [old, new, _])| {
            format!("{name} {} MB, {} with projections", megabytes(*new), megabytes(*old))
        })),
        verdict: Verdict::of(more && as_recursive, more),
        reason: format!(
            "scratch memory that a build asks for, once and in one piece: no node is allocated, so \
             nothing is fragmented; the arena's size is a matter of the clusters found; a \
             recursive grid's build asks for {}",
            list(all.iter().map(|(name, [.., recursive])| {
                format!("{} MB ({name})", megabytes(*recursive))
            }))
        ),
    }
}
