//! Claims of sections 7.1 and 7.2: which way clusters' boxes lie.

use super::{Claim, Verdict};
use crate::oriented::boxes::{beside_one, median};
use crate::oriented::{Clustered, Oriented, Steps};
use crate::selected::SETS;
use crate::sheet::number;

pub fn claims(all: &[Oriented]) -> Vec<Claim> {
    vec![vertices(all), hull(all), rays(all)]
}

/// Every clustering of the kitchen.
fn kitchen(all: &[Oriented]) -> impl Iterator<Item = &Clustered> {
    all.iter().filter(|scene| scene.short == "kit").flat_map(|scene| &scene.clusterings)
}

fn list(parts: impl IntoIterator<Item = String>) -> String {
    parts.into_iter().collect::<Vec<_>>().join("; ")
}

fn vertices(all: &[Oriented]) -> Claim {
    let what = "A box along the principal components of the vertices is often worse than the \
                aligned one: kitchen";
    let paper = "\"pretty frequent\"";
    let found: Vec<(&str, Vec<f64>, Vec<f64>)> = kitchen(all)
        .filter_map(|c| Some((c.notation, c.along("vertices")?)))
        .map(|(name, turned)| (name, turned.all(|r| r.surface), turned.all(|r| r.volume)))
        .filter(|(_, surface, _)| !surface.is_empty())
        .collect();
    let Some((_, papers, _)) = found.first() else {
        return Claim::missing(what, paper, "clusters of the kitchen");
    };
    // The paper's clusters decide.
    let [.., worse] = beside_one(papers);
    Claim {
        what,
        paper,
        ours: list(found.iter().map(|(name, surface, _)| {
            let [.., worse] = beside_one(surface);
            format!("{name}: {} % of clusters have more surface", number(worse))
        })),
        verdict: Verdict::of(worse >= 25.0, worse >= 10.0),
        reason: list(found.iter().map(|(name, surface, volume)| {
            let [less, ..] = beside_one(surface);
            let [.., larger] = beside_one(volume);
            format!(
                "{name}: {} clusters, median of the surface's ratio {}, {} % have less, {} % have \
                 more volume",
                surface.len(),
                median(surface.clone()).map_or("none".into(), number),
                number(less),
                number(larger)
            )
        })),
    }
}

/// Surfaces along the hull's components over those along the vertices', of clusters that have
/// both.
fn hull_over_vertices(clustered: &Clustered) -> Vec<f64> {
    let (Some(hull), Some(vertices)) = (clustered.along("hull"), clustered.along("vertices"))
    else {
        return Vec::new();
    };
    let both = hull.boxes.iter().zip(&vertices.boxes);
    let ratio = both.filter_map(|(h, v)| Some((*h)?.surface? / (*v)?.surface?));
    ratio.filter(|r| r.is_finite() && *r > 0.0).collect()
}

fn hull(all: &[Oriented]) -> Claim {
    let what = "Components of the convex hull avoid what points inside do to those of all \
                vertices (GLM96): kitchen";
    let paper = "\"works fine\" for collisions";
    let found: Vec<(&Clustered, Vec<f64>)> = kitchen(all)
        .map(|c| (c, hull_over_vertices(c)))
        .filter(|(_, ratios)| !ratios.is_empty())
        .collect();
    let mean = |ratios: &[f64]| {
        (ratios.iter().map(|r| r.ln()).sum::<f64>() / ratios.len().max(1) as f64).exp()
    };
    let Some((_, papers)) = found.first() else {
        return Claim::missing(what, paper, "clusters of the kitchen");
    };
    let ratio = mean(papers);
    Claim {
        what,
        paper,
        ours: list(found.iter().map(|(c, ratios)| {
            format!("{}: {} times the surface on the average", c.notation, number(mean(ratios)))
        })),
        verdict: Verdict::of(ratio <= 0.97, ratio <= 0.995),
        reason: list(found.iter().map(|(c, ratios)| {
            let [less, _, more] = beside_one(ratios);
            let worse = ["vertices", "hull", "search"].map(|along| {
                let surfaces = c.along(along).map(|t| t.all(|r| r.surface)).unwrap_or_default();
                format!("{along} {} %", number(beside_one(&surfaces)[2]))
            });
            format!(
                "{}: less for {} % of clusters, more for {} %; with more surface than the aligned \
                 box: {}",
                c.notation,
                number(less),
                number(more),
                worse.join(", ")
            )
        })),
    }
}

fn rays(all: &[Oriented]) -> Claim {
    let what = "Boxes of less surface reduce ray-box tests, but not ray-polygon tests";
    let paper = "\"one can only expect\" it";
    let mut found = Vec::new();
    for scene in all {
        for clustered in &scene.clusterings {
            let Some(turned) = clustered.along("search") else { continue };
            for (set, rays) in SETS.iter().enumerate() {
                let (plain, after) = (clustered.aligned[set], turned.steps[set]);
                if [plain, after].iter().all(|s| s.met > 0.0 && s.tests > 0.0) {
                    found.push((
                        format!("{}.{}, {rays}", scene.short, clustered.notation),
                        plain,
                        after,
                    ));
                }
            }
        }
    }
    let gain = |(_, a, b): &(String, Steps, Steps)| b.met / a.met;
    let Some(most) = found.iter().min_by(|a, b| gain(a).total_cmp(&gain(b))) else {
        return Claim::missing(what, paper, "a scene with clusters that rays enter");
    };
    let mean = |of: fn(&Steps) -> f64| {
        let sum: f64 = found.iter().map(|(_, a, b)| (of(b) / of(a)).ln()).sum();
        (sum / found.len() as f64).exp()
    };
    let [met, grids, voxels, tests] =
        [mean(|s| s.met), mean(|s| s.grids), mean(|s| s.voxels), mean(|s| s.tests)];
    Claim {
        what,
        paper,
        ours: format!(
            "{} times the box tests, {} times those of polygons",
            number(grids),
            number(tests)
        ),
        verdict: Verdict::of(grids <= 0.97 && tests >= 0.97, met <= 0.97),
        reason: format!(
            "search, a box turned if it has less than 0.8 of the surface, over aligned; geometric \
             means. The grid above refers to a turned box wherever the aligned one is, so it is \
             tested as often; clusters' boxes met on the way to the hit: {} times, voxels: {}. \
             Most for {} ({} boxes met a ray, then {})",
            number(met),
            number(voxels),
            most.0,
            number(most.1.met),
            number(most.2.met)
        ),
    }
}
