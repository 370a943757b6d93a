//! One hash for everything: structures, instruction sets, threads, single rays and
//! streams. `cargo test --test matrix` and `cargo test --release --test matrix` compare
//! it with the same constant, with assertions and without; `tests/digest.rs` does the
//! same for C, with std and without, and `.ci/targets` for other processors.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, build, ray};
use hug::build::{Control, Task, Threads};
use hug::{
    Clustering, Filter, Geometry, Gridding, Hierarchy, Hit, Isa, Options, Orientation, Ray, Scene,
    Structure, View, force_isa,
};
use hug_kit::{Mesh, scenes, soups};

/// Of the hits of all rays in all scenes below. It depends on nothing but triangles
/// and rays, so it changes only if these do.
const EXPECTED: u64 = 0xd9f1_e97a_a91c_b114;

fn scenes() -> Vec<(&'static str, Mesh, usize)> {
    vec![
        ("kitchen", scenes::kitchen().mesh, 1500),
        ("tangle", soups::tangle(1, 2000), 300),
        ("mixed scales", soups::mixed_scales(5, 2000), 300),
        ("slivers", soups::slivers(2, 1000), 200),
        ("stacked", soups::stacked(3, 500), 100),
        ("tiny", soups::rescaled(&soups::tangle(1, 1000), 1e-30), 200),
        ("huge", soups::rescaled(&soups::tangle(1, 1000), 1e30), 200),
    ]
}

fn structures() -> [(&'static str, Options); 9] {
    let base = Options::default();
    let of = |structure| Options { structure, ..base };
    let hug = of(Structure::Hug);
    let three = Options { filter: Filter::ThreeLevels, hierarchy: Hierarchy::Paper, ..hug };
    [
        ("auto", base),
        ("auto, compact", Options { compact: true, ..base }),
        ("uniform", of(Structure::Uniform)),
        ("recursive", of(Structure::Recursive)),
        ("HUG", hug),
        ("HUG of three levels", three),
        ("HUG of components", Options { clustering: Clustering::Components, ..hug }),
        ("HUG by overlap", Options { gridding: Gridding::Overlap, ..hug }),
        ("HUG, turned", Options { orientation: Orientation::Hull, turn_below: 1e6, ..hug }),
    ]
}

struct Team(usize);

impl Threads for Team {
    fn run(&self, tasks: &mut [Task<'_>]) {
        let share = tasks.len().div_ceil(self.0);
        std::thread::scope(|scope| {
            for tasks in tasks.chunks_mut(share) {
                scope.spawn(|| tasks.iter_mut().for_each(Task::run));
            }
        });
    }
}

fn mix(sum: u64, word: u32) -> u64 {
    (sum ^ u64::from(word)).wrapping_mul(0x0100_0000_01b3)
}

/// FNV-1a over words.
fn hash(sum: u64, hits: &[Hit], shadows: &[bool]) -> u64 {
    let words = |hit: &Hit| bytemuck::cast::<Hit, [u32; 10]>(*hit);
    let sum = hits.iter().flat_map(words).fold(sum, mix);
    shadows.iter().fold(sum, |sum, &s| mix(sum, u32::from(s)))
}

fn single(view: &View<'_>, rays: &[Ray], hits: &mut [Hit], shadows: &mut [bool]) {
    for ((ray, hit), shadow) in rays.iter().zip(hits).zip(shadows) {
        (*hit, *shadow) = (view.intersect(ray), view.occluded(ray));
    }
}

fn stream(view: &View<'_>, rays: &[Ray], hits: &mut [Hit], shadows: &mut [bool]) {
    view.intersect_n(rays, hits);
    view.occluded_n(rays, shadows);
}

type Trace = fn(&View<'_>, &[Ray], &mut [Hit], &mut [bool]);

/// All rays, on so many threads at a time.
fn trace(view: View<'_>, rays: &[Ray], threads: usize, how: Trace) -> (Vec<Hit>, Vec<bool>) {
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    let mut shadows = vec![false; rays.len()];
    let share = rays.len().div_ceil(threads);
    std::thread::scope(|scope| {
        let parts = rays.chunks(share).zip(hits.chunks_mut(share)).zip(shadows.chunks_mut(share));
        for ((rays, hits), shadows) in parts {
            scope.spawn(move || how(&view, rays, hits, shadows));
        }
    });
    (hits, shadows)
}

#[test]
fn one_hash() {
    const START: u64 = 0xcbf2_9ce4_8422_2325;
    let (mut sum, mut compared) = (START, 0);
    for (name, mesh, n) in scenes() {
        let rays: Vec<Ray> = adversarial_rays(&mesh, 17, n).iter().map(|(_, r)| ray(r)).collect();
        let soup = [Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
        let mut expected = None;
        for (kind, options) in structures() {
            let scene = build(&mesh, &options);
            let team = Team(16);
            let lent =
                Scene::build_with(&soup, &options, &mut Control::default().with_threads(&team));
            let same = lent.is_ok_and(|lent| lent.view().bytes() == scene.view().bytes());
            assert!(same, "{name} in {kind}: 16 threads built something else");
            for isa in Isa::ALL.into_iter().filter(|&isa| force_isa(isa)) {
                for threads in [1, 3, 16] {
                    for (how, f) in [("single", single as Trace), ("stream", stream)] {
                        let (hits, shadows) = trace(scene.view(), &rays, threads, f);
                        let found = hash(START, &hits, &shadows);
                        compared += rays.len();
                        let what = format!("{name} in {kind}, {isa:?}, {threads} threads, {how}");
                        assert_eq!(found, *expected.get_or_insert(found), "{what}");
                    }
                }
            }
        }
        sum = expected.unwrap_or(0).to_le_bytes().iter().fold(sum, |s, &b| mix(s, b.into()));
    }
    println!("{compared} rays, twice each: {sum:#018x}");
    assert_eq!(sum, EXPECTED, "{sum:#018x}");
}
