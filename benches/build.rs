//! How long builds take: every structure on the built-in scenes, and on the smaller files of the
//! folder that `HUG_SCENES` names. `HUG_BENCH_SCENES` names other scenes, with commas.

use criterion::{BenchmarkId, SamplingMode, Throughput};
use hug_bench::kind::Kind;
use hug_bench::load::{self, Loaded};
use hug_bench::{args, cpu_time, named};
use std::process::ExitCode;
use std::time::Duration;

/// About 100,000 triangles: larger files are built when they are asked for.
const SMALL_FILE: u64 = 2 << 20;

fn scenes() -> Result<Vec<String>, String> {
    named::scenes(|| {
        let built_in = hug_kit::scenes::NAMES.map(str::to_owned).into_iter();
        Ok(built_in.chain(load::files(SMALL_FILE)?).collect())
    })
}

fn run() -> Result<(), String> {
    let (warm_up, measurement) = (Duration::from_millis(300), Duration::from_millis(2000));
    let mut criterion = cpu_time::criterion(10, warm_up, measurement);
    for name in scenes()? {
        let scene = Loaded::new(&name)?;
        let mut group = criterion.benchmark_group(format!("build/{}", scene.name));
        group.sampling_mode(SamplingMode::Flat);
        group.throughput(Throughput::Elements(scene.mesh.indices.len() as u64));
        for kind in Kind::ALL {
            let build = || scene.build(&kind.options()).unwrap_or_else(|error| panic!("{error}"));
            let id = BenchmarkId::from_parameter(kind.name());
            group.bench_function(id, |bencher| bencher.iter_with_large_drop(build));
        }
        group.finish();
    }
    criterion.final_summary();
    Ok(())
}

fn main() -> ExitCode {
    args::finish(run())
}
