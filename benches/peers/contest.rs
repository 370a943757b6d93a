//! One set of rays through all contenders.

use super::Query;
use super::builds::Builds;
use super::differences::Differences;
use super::peer::{self, Found};
use bytemuck::cast;
use hug::{Hit, Ray};
use hug_bench::clock;
use hug_bench::ray_sets::Set;
use hug_bench::rounds::{self, Contender};

pub struct Contest {
    pub set: Set,
    pub query: Query,
    pub rays: usize,
    /// By contender, hug's first, and round.
    pub seconds: Vec<Vec<f64>>,
    /// Of each tree from hug.
    pub differences: Vec<Differences>,
}

/// Each contender starts from its own library's record of a ray and leaves its answers.
pub fn run(
    built: &Builds,
    set: Set,
    query: Query,
    rays: &[Ray],
    rounds: usize,
) -> Result<Contest, String> {
    let theirs = peer::rays(rays);
    let (seconds, differences) = match query {
        Query::Closest => closest(built, rays, &theirs, rounds),
        Query::Occluded => occluded(built, rays, &theirs, rounds),
    }
    .map_err(|what| format!("{} rays, {}: {what}", set.name(), query.name()))?;
    Ok(Contest { set, query, rays: rays.len(), seconds, differences })
}

type Outcome = Result<(Vec<Vec<f64>>, Vec<Differences>), &'static str>;

/// No two structures of hug's may differ in a bit.
const NOT_EXACT: &str = "structures of hug disagree";

fn closest(built: &Builds, rays: &[Ray], theirs: &[obvhs::ray::Ray], rounds: usize) -> Outcome {
    let mut hits = vec![vec![Hit::miss(0.0); rays.len()]; built.hug.len()];
    let mut found = vec![vec![Found::MISS; rays.len()]; built.obvhs.len()];
    let ours = built.hug.iter().zip(&mut hits).map(|(hug, hits)| -> Contender<'_> {
        let view = hug.scene.view();
        Box::new(move |n| {
            for (ray, hit) in rays[..n].iter().zip(&mut *hits) {
                *hit = view.intersect(ray);
            }
        })
    });
    let others = built.obvhs.iter().zip(&mut found).map(|(peer, found)| -> Contender<'_> {
        Box::new(move |n| peer.tree.closest(&theirs[..n], found))
    });
    let mut all: Vec<Contender<'_>> = ours.chain(others).collect();
    let seconds = rounds::run(&mut all, rays.len(), rounds, clock::thread);
    drop(all);
    let bits = |hits: &[Hit]| -> Vec<[u32; 10]> { hits.iter().map(|&hit| cast(hit)).collect() };
    let first = bits(&hits[0]);
    if hits[1..].iter().any(|other| bits(other) != first) {
        return Err(NOT_EXACT);
    }
    Ok((seconds, found.iter().map(|f| Differences::of_hits(&hits[0], f)).collect()))
}

fn occluded(built: &Builds, rays: &[Ray], theirs: &[obvhs::ray::Ray], rounds: usize) -> Outcome {
    let mut own = vec![vec![false; rays.len()]; built.hug.len()];
    let mut answers = vec![vec![false; rays.len()]; built.obvhs.len()];
    let ours = built.hug.iter().zip(&mut own).map(|(hug, own)| -> Contender<'_> {
        let view = hug.scene.view();
        Box::new(move |n| {
            for (ray, answer) in rays[..n].iter().zip(&mut *own) {
                *answer = view.occluded(ray);
            }
        })
    });
    let others = built.obvhs.iter().zip(&mut answers).map(|(peer, answers)| -> Contender<'_> {
        Box::new(move |n| peer.tree.occluded(&theirs[..n], answers))
    });
    let mut all: Vec<Contender<'_>> = ours.chain(others).collect();
    let seconds = rounds::run(&mut all, rays.len(), rounds, clock::thread);
    drop(all);
    if own.iter().any(|other| other != &own[0]) {
        return Err(NOT_EXACT);
    }
    Ok((seconds, answers.iter().map(|a| Differences::of_answers(&own[0], a)).collect()))
}
