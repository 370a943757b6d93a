//! Call costs in context (section 4 of the paper): the calls that a picture's rays make in each
//! configuration, made again function by function. `HUG_BENCH_CONFIGS` names other configurations
//! than the default ones, with commas and in the paper's notation.

use criterion::{SamplingMode, Throughput};
use hug_bench::costs::{Function, Rays};
use hug_bench::load::Loaded;
use hug_bench::notation::Configuration;
use hug_bench::ray_sets::{RaySets, Set};
use hug_bench::{args, cpu_time, named};
use std::process::ExitCode;
use std::time::Duration;

/// The functions by the paper's names for their costs.
const FUNCTIONS: [(Function, &str); 4] = [
    (Function::Test, "t_pi"),
    (Function::Grid, "t_rg+t_bi"),
    (Function::Voxel, "t_nc"),
    (Function::Ray, "start and end"),
];

fn run() -> Result<(), String> {
    let (warm_up, measurement) = (Duration::from_millis(100), Duration::from_millis(1000));
    let mut criterion = cpu_time::criterion(20, warm_up, measurement);
    let size = named::size(250)?;
    for name in named::configurations()? {
        let config: Configuration = name.parse()?;
        let loaded = Loaded::new(&config.scene)?;
        let view = loaded.view(config.view())?;
        let options = config.structure.options_for(loaded.mesh.indices.len() as u64);
        let scene = loaded.build(&options)?;
        let sets = RaySets::new(&scene.view(), &loaded.bounds, &view, size);
        let rays = Rays::of(sets.get(Set::Primary), sets.get(Set::Shadow));
        let mut tape = rays.record(scene.view());
        let mut group = criterion.benchmark_group(format!("costs/{config}"));
        group.sampling_mode(SamplingMode::Flat);
        for (function, name) in FUNCTIONS {
            group.throughput(Throughput::Elements(tape.calls(function)));
            group.bench_function(name, |bencher| bencher.iter(|| tape.run(function)));
        }
        group.throughput(Throughput::Elements(rays.count() as u64));
        group.bench_function("the whole", |bencher| bencher.iter(|| rays.trace(&scene.view())));
        group.finish();
    }
    criterion.final_summary();
    Ok(())
}

fn main() -> ExitCode {
    args::finish(run())
}
