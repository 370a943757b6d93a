//! `hug build`.

use crate::args::Build;
use crate::{file, input};
use hug::Stats;

pub fn run(args: &Build) -> Result<(), String> {
    let loaded = input::load(&args.scene, args.quiet)?;
    let options = args.how.options();
    let (scene, seconds) = input::build(&loaded, &options, args.how.threads, args.quiet)?;
    if let Some(out) = &args.out {
        file::write(&scene.view(), out)?;
    }
    let stats = Stats::of(&scene.view());
    println!(
        "{}: {} triangles in {:.1} ms of CPU time, {:.2} million a second",
        loaded.name,
        stats.triangles,
        1e3 * seconds,
        1e-6 * stats.triangles as f64 / seconds
    );
    let dropped = stats.dropped_degenerate + stats.dropped_non_finite;
    if dropped > 0 {
        println!(
            "left out: {} without area, {} with a coordinate that is not finite",
            stats.dropped_degenerate, stats.dropped_non_finite
        );
    }
    println!(
        "{:?}, {} bytes, {:.1} a triangle",
        stats.structure,
        stats.bytes,
        stats.bytes as f64 / stats.triangles.max(1) as f64
    );
    if let Some(out) = &args.out {
        println!("saved to {}", out.display());
    }
    Ok(())
}
