//! All structures of a scene, which take turns at building and at tracing.

use super::curves::Curve;
use super::entry::{Cost, Entry};
use super::walk::Walk;
use crate::measure::Frame;
use crate::progress::Progress;
use bytemuck::cast;
use hug::{Options, Profile, Ray, Scene, Stats, View};
use hug_bench::clock;
use hug_bench::figures::Spread;
use hug_bench::load::Loaded;
use hug_bench::rounds::{self, Contender};
use hug_kit::{Bounds, rays};
use std::hint::black_box;

/// The sets of rays, by name.
pub const SETS: [&str; 2] = ["primary", "random"];

/// Primary rays of all views, and as many random rays as one of them has.
pub fn rays(frames: &[Frame], bounds: &Bounds, size: u32) -> [Vec<Ray>; 2] {
    let primary = frames.iter().flat_map(|frame| frame.primary.iter().copied()).collect();
    let most = (size as usize * size as usize).min(rays::RANDOM_COUNT);
    [primary, rays::random(bounds).take(most).map(cast).collect()]
}

/// All structures of a scene with one kind of walk.
pub struct Contest {
    pub walk: Walk,
    pub entries: Vec<Entry>,
}

impl Contest {
    pub fn measure(
        loaded: &Loaded,
        short: &str,
        walk: Walk,
        curves: &[Curve],
        sets: &[Vec<Ray>; 2],
        rounds: usize,
        bar: &Progress,
    ) -> Result<Self, String> {
        let triangles = loaded.mesh.indices.len() as u64;
        let all = curves.iter().flat_map(|c| c.members.iter().map(move |m| (&c.name, m)));
        let asked: Vec<_> = all
            .filter_map(|(curve, (value, n))| Some((curve, value, n, walk.options(*n, triangles)?)))
            .collect();
        let options: Vec<Options> = asked.iter().map(|a| a.3).collect();
        bar.more(rounds * asked.len() + sets.len() + asked.len());
        let step = |what: &str| bar.at(&format!("{short}, {}: {what}", walk.text()));
        step("building");
        let built = build(loaded, &options, rounds, bar)?;
        let views: Vec<View<'_>> = built.iter().map(|(scene, _)| scene.view()).collect();
        let times: Vec<Vec<Spread>> = SETS
            .iter()
            .zip(sets)
            .map(|(name, rays)| {
                step(&format!("timing {name} rays"));
                let times = time(&views, rays, rounds);
                bar.done();
                times
            })
            .collect();
        let mut entries = Vec::new();
        for (i, (curve, value, notation, _)) in asked.into_iter().enumerate() {
            step(&format!("counting in {notation}"));
            let stats = Stats::of(&views[i]);
            entries.push(Entry {
                name: format!("{short}.{notation}"),
                curve: curve.clone(),
                value: value.clone(),
                notation: *notation,
                bytes: stats.bytes,
                triangle_bytes: stats.triangle_bytes,
                volume: stats.shares(&stats.total).volume,
                build: Spread::of(built[i].1.iter().copied()),
                costs: [0, 1].map(|set| count(&views[i], &sets[set], times[set][i])),
            });
            bar.done();
        }
        Ok(Self { walk, entries })
    }

    pub fn find(&self, notation: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.notation.to_string() == notation)
    }

    pub fn curve<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a Entry> {
        self.entries.iter().filter(move |entry| entry.curve == name)
    }

    /// The names of the curves, in the order of the entries.
    pub fn curves(&self) -> Vec<&str> {
        let mut names: Vec<&str> = self.entries.iter().map(|e| e.curve.as_str()).collect();
        names.dedup();
        names
    }
}

/// Each built once a round, and the CPU seconds of all its builds. Only builds are timed: what is
/// built is freed before its next turn.
fn build(
    loaded: &Loaded,
    options: &[Options],
    rounds: usize,
    bar: &Progress,
) -> Result<Vec<(Scene, Vec<f64>)>, String> {
    let mut slots: Vec<Option<Scene>> = options.iter().map(|_| None).collect();
    let mut seconds = vec![Vec::new(); options.len()];
    for round in 0..rounds {
        for i in 0..options.len() {
            let turn = (i + round) % options.len();
            slots[turn] = None;
            let mut scene = None;
            let build = || scene = Some(loaded.build(&options[turn]));
            seconds[turn].push(clock::seconds(clock::process, build));
            slots[turn] = scene.transpose()?;
            bar.done();
        }
    }
    Ok(slots.into_iter().flatten().zip(seconds).collect())
}

/// Nanoseconds a ray in each of some scenes.
fn time(views: &[View<'_>], rays: &[Ray], rounds: usize) -> Vec<Spread> {
    let trace = |view| -> Contender<'_> {
        Box::new(move |n| {
            for ray in &rays[..n] {
                black_box(View::intersect(view, ray));
            }
        })
    };
    let mut all: Vec<Contender<'_>> = views.iter().map(trace).collect();
    let seconds = rounds::run(&mut all, rays.len(), rounds, clock::thread);
    let each = 1e9 / rays.len().max(1) as f64;
    seconds.into_iter().map(|of| Spread::of(of).times(each)).collect()
}

fn count(view: &View<'_>, rays: &[Ray], time: Spread) -> Cost {
    let mut profile = Profile::default();
    for ray in rays {
        view.intersect_profiled(ray, &mut profile);
    }
    Cost { time, rays: rays.len() as u64, calls: profile.total() }
}
