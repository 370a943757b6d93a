//! How many rays a second queries take: closest hit and occlusion, one ray a call or all in one,
//! on every ray set, in every structure, on every instruction set of this processor.
//! `HUG_BENCH_SCENES` names other scenes than the kitchen, with commas.

#[path = "calls/abi.rs"]
mod abi;

use abi::Handle;
use criterion::{BenchmarkGroup, SamplingMode, Throughput};
use hug::{Hit, Ray, Scene};
use hug_bench::cpu_time::{self, CpuTime};
use hug_bench::kind::Kind;
use hug_bench::load::Loaded;
use hug_bench::ray_sets::{RaySets, Set};
use hug_bench::{args, instructions, named};
use std::hint::black_box;
use std::process::ExitCode;
use std::time::Duration;

/// Times the four forms of query on one set of rays.
fn forms(group: &mut BenchmarkGroup<'_, CpuTime>, scene: &Scene, rays: &[Ray], with: &str) {
    let (view, handle) = (scene.view(), Handle::new(scene));
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    let mut answers = vec![0u8; rays.len()];
    group.bench_function(format!("closest/{with}"), |bencher| {
        bencher.iter(|| {
            for (ray, hit) in rays.iter().zip(&mut hits) {
                *hit = view.intersect(ray);
            }
            black_box(&mut hits);
        });
    });
    group.bench_function(format!("closest_n/{with}"), |bencher| {
        bencher.iter(|| handle.intersect_n(rays, black_box(&mut hits)));
    });
    group.bench_function(format!("occluded/{with}"), |bencher| {
        bencher.iter(|| {
            for (ray, answer) in rays.iter().zip(&mut answers) {
                *answer = u8::from(view.occluded(ray));
            }
            black_box(&mut answers);
        });
    });
    group.bench_function(format!("occluded_n/{with}"), |bencher| {
        bencher.iter(|| handle.occluded_n(rays, black_box(&mut answers)));
    });
}

fn run() -> Result<(), String> {
    let (warm_up, measurement) = (Duration::from_millis(50), Duration::from_millis(300));
    let mut criterion = cpu_time::criterion(10, warm_up, measurement);
    let size = named::size(128)?;
    for name in named::scenes(|| Ok(vec!["kitchen".to_owned()]))? {
        let loaded = Loaded::new(&name)?;
        let build = |kind: Kind| Ok((kind, loaded.build(&kind.options())?));
        let built: Vec<(Kind, Scene)> =
            Kind::ALL.into_iter().map(build).collect::<Result<_, String>>()?;
        let sets = RaySets::new(&built[0].1.view(), &loaded.bounds, &loaded.view(None)?, size);
        for set in Set::ALL {
            let rays = sets.get(set);
            let mut group = criterion.benchmark_group(format!("{}/{}", loaded.name, set.name()));
            group.sampling_mode(SamplingMode::Flat);
            group.throughput(Throughput::Elements(rays.len() as u64));
            for isa in instructions::available() {
                instructions::force(isa);
                for (kind, scene) in &built {
                    let with = format!("{}/{}", kind.name(), instructions::name(isa));
                    forms(&mut group, scene, rays, &with);
                }
            }
            group.finish();
        }
    }
    criterion.final_summary();
    Ok(())
}

fn main() -> ExitCode {
    args::finish(run())
}
