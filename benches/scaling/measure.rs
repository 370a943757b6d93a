//! One scene in one structure.

use super::Args;
use bytemuck::cast;
use hug::{Counters, Hit, Ray, Scene, Stats};
use hug_bench::clock;
use hug_bench::figures::Spread;
use hug_bench::kind::Kind;
use hug_bench::load::Loaded;
use hug_bench::rounds::{self, Contender};
use hug_kit::rays;
use std::hint::black_box;

/// What a set of rays cost.
pub struct RayCost {
    pub nanoseconds: f64,
    /// A ray, of the counted walk.
    pub voxels: f64,
    pub grids: f64,
    pub tests: f64,
}

/// All figures of one scene in one structure.
pub struct Point {
    pub family: &'static str,
    pub kind: Kind,
    pub triangles: f64,
    pub build_seconds: f64,
    pub stats: Stats,
    pub random: RayCost,
    pub primary: RayCost,
}

/// Builds of fewer triangles than this are repeated until as many were built.
const WORTH_TIMING: usize = 200_000;

impl Point {
    pub fn measure(
        family: &'static str,
        kind: Kind,
        loaded: &Loaded,
        args: &Args,
    ) -> Result<Self, String> {
        let options = kind.options();
        let scene = loaded.build(&options)?;
        let triangles = loaded.mesh.indices.len();
        let repeats = WORTH_TIMING.div_ceil(triangles);
        let build = || {
            clock::seconds(clock::process, || {
                for _ in 0..repeats {
                    black_box(Scene::build(&loaded.soup(), &options).ok());
                }
            }) / repeats as f64
        };
        let builds = Spread::of((0..args.build_rounds).map(|_| build()));
        let random = rays::random(&loaded.bounds).take(args.rays as usize);
        let size = (args.rays as f64).sqrt().max(1.0) as u32;
        let camera = loaded.view(None)?;
        let primary = rays::primary(&camera, size);
        let sets = [random.map(cast).collect(), primary.map(cast).collect()];
        let [random, primary] = cost(&scene, &sets, args.rounds as usize);
        Ok(Self {
            family,
            kind,
            triangles: triangles as f64,
            build_seconds: builds.median,
            stats: Stats::of(&scene.view()),
            random,
            primary,
        })
    }
}

fn cost(scene: &Scene, sets: &[Vec<Ray>; 2], rounds: usize) -> [RayCost; 2] {
    let view = scene.view();
    sets.each_ref().map(|set| {
        let mut hits = vec![Hit::miss(0.0); set.len()];
        let all: Contender<'_> = Box::new(move |n| {
            for (ray, hit) in set[..n].iter().zip(&mut hits) {
                *hit = view.intersect(ray);
            }
            black_box(&mut hits);
        });
        let seconds = rounds::run(&mut [all], set.len(), rounds, clock::thread);
        let mut seen = Counters::default();
        for ray in set {
            view.intersect_counted(ray, &mut seen);
        }
        let per_ray = |count: u64| count as f64 / set.len() as f64;
        RayCost {
            nanoseconds: Spread::of(seconds[0].iter().copied()).median * 1e9 / set.len() as f64,
            voxels: per_ray(seen.voxels),
            grids: per_ray(seen.grids),
            tests: per_ray(seen.tests),
        }
    })
}
