//! One scene in all settings, which take turns.

use super::Args;
use super::setting::Setting;
use hug::{Hit, Options, Ray, Scene};
use hug_bench::clock;
use hug_bench::figures::Spread;
use hug_bench::load::Loaded;
use hug_bench::ray_sets::{RaySets, Set};
use hug_bench::rounds::{self, Contender};
use std::hint::black_box;

/// What a setting comes to on a scene, as natural logarithms, so that they can be averaged.
#[derive(Clone, Copy, Default)]
pub struct Figures {
    /// Of seconds.
    pub build: f64,
    /// Of bytes a triangle.
    pub bytes: f64,
    /// Of seconds, by set of rays; 0 where that is empty.
    pub single: [f64; SETS],
    pub stream: [f64; SETS],
}

/// Sets of rays.
pub const SETS: usize = Set::ALL.len();

impl Figures {
    /// Of all queries: what a single ray takes counts twice.
    pub fn queries(&self) -> f64 {
        let sum = |of: &[f64; SETS]| of.iter().sum::<f64>();
        (2.0 * sum(&self.single) + sum(&self.stream)) / (3 * SETS) as f64
    }
}

/// A scene's figures, by setting.
pub struct Measured {
    pub name: String,
    pub figures: Vec<Figures>,
}

pub fn scene(loaded: &Loaded, settings: &[Setting], args: &Args) -> Result<Measured, String> {
    let soup = loaded.soup();
    let triangles = loaded.mesh.indices.len();
    let options: Vec<Options> = settings.iter().map(|s| s.options(triangles)).collect();
    let auto = loaded.build(&Options::default())?;
    if loaded.build(&Setting::AUTO.options(triangles))?.view().bytes() != auto.view().bytes() {
        return Err(format!("{}: {} is not what AUTO builds", loaded.name, Setting::AUTO));
    }
    let mut built = vec![None; settings.len()];
    let mut builds: Vec<Contender<'_>> = Vec::new();
    for (options, built) in options.iter().zip(&mut built) {
        builds.push(Box::new(|_| *built = Scene::build(&soup, options).ok()));
    }
    let builds_took = rounds::run_warm(&mut builds, 1, args.build_rounds as usize, clock::process);
    drop(builds);
    let built: Vec<Scene> = built.into_iter().flatten().collect();
    if built.len() < settings.len() {
        return Err(format!("{}: not every setting can be built", loaded.name));
    }
    let rays = RaySets::new(&auto.view(), &loaded.bounds, &loaded.view(None)?, args.size);
    let mut figures: Vec<Figures> = (builds_took.into_iter().zip(&built))
        .map(|(seconds, scene)| Figures {
            build: Spread::of(seconds).median.ln(),
            bytes: (scene.view().bytes().len() as f64 / triangles as f64).ln(),
            ..Figures::default()
        })
        .collect();
    for (k, set) in Set::ALL.into_iter().enumerate() {
        let rays = rays.get(set);
        if rays.is_empty() {
            continue;
        }
        for stream in [false, true] {
            let took = queries(&built, set, rays, stream, args.rounds as usize);
            for (figures, took) in figures.iter_mut().zip(took) {
                let to = if stream { &mut figures.stream } else { &mut figures.single };
                to[k] = took.ln();
            }
        }
    }
    Ok(Measured { name: loaded.name.clone(), figures })
}

/// Median seconds of each setting; shadow rays ask for any hit.
fn queries(built: &[Scene], set: Set, rays: &[Ray], stream: bool, rounds: usize) -> Vec<f64> {
    let mut all: Vec<Contender<'_>> = Vec::new();
    for scene in built {
        let view = scene.view();
        let mut hits = vec![Hit::miss(0.0); rays.len()];
        let mut any = vec![false; rays.len()];
        all.push(Box::new(move |n| {
            let rays = &rays[..n];
            match (set == Set::Shadow, stream) {
                (false, false) => {
                    rays.iter().zip(&mut hits).for_each(|(r, h)| *h = view.intersect(r))
                }
                (true, false) => rays.iter().zip(&mut any).for_each(|(r, h)| *h = view.occluded(r)),
                (false, true) => view.intersect_n(rays, &mut hits),
                (true, true) => view.occluded_n(rays, &mut any),
            }
            black_box((&mut hits, &mut any));
        }));
    }
    let mut seconds = vec![Vec::new(); all.len()];
    for _ in 0..rounds {
        for (contender, seconds) in all.iter_mut().zip(&mut seconds) {
            // Whoever was here before has left nothing of this one in the caches.
            contender(rays.len());
            seconds.push(clock::seconds(clock::thread, || contender(rays.len())));
        }
    }
    seconds.into_iter().map(|rounds| Spread::of(rounds).median).collect()
}
