//! How build time, memory, work and time a ray grow with the number of triangles, on triangles
//! that lie on a surface, everywhere, and in clumps; and the powers that fit.

#[path = "scaling/measure.rs"]
mod measure;
#[path = "scaling/report.rs"]
mod report;

use clap::{Parser, ValueEnum};
use hug_bench::args::{self, Cargo};
use hug_bench::kind::Kind;
use hug_bench::load::Loaded;
use hug_bench::machine;
use measure::Point;
use std::process::ExitCode;

/// How build time, memory and time a ray grow with the number of triangles.
#[derive(Parser)]
struct Args {
    /// How the triangles lie, several with commas
    #[arg(long, value_enum, value_delimiter = ',', default_values = ["surface", "uniform", "clustered"])]
    family: Vec<Family>,
    /// Structures, several with commas
    #[arg(long, value_enum, value_delimiter = ',', default_value = "auto")]
    structure: Vec<Kind>,
    /// The smallest number of triangles; the others are ten times the one before
    #[arg(long, default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..))]
    smallest: u64,
    /// The largest number of triangles; 10000000 wants some 10 GB of memory
    #[arg(long, default_value_t = 1_000_000, value_parser = clap::value_parser!(u64).range(1..))]
    largest: u64,
    /// Random rays; the primary ones fill a square frame of about as many pixels
    #[arg(long, default_value_t = 1 << 16, value_parser = clap::value_parser!(u64).range(1..=1 << 20))]
    rays: u64,
    /// How often the rays are timed
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u64).range(1..))]
    rounds: u64,
    /// How often a build is timed; a small one more often
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u64).range(1..))]
    build_rounds: u64,
    #[command(flatten)]
    cargo: Cargo,
}

#[derive(Clone, Copy, ValueEnum)]
enum Family {
    Surface,
    Uniform,
    Clustered,
}

impl Family {
    fn name(self) -> &'static str {
        match self {
            Self::Surface => "surface",
            Self::Uniform => "uniform",
            Self::Clustered => "clustered",
        }
    }
}

/// Growth from one decade to the next.
const STEP: u64 = 10;

fn run(args: &Args) -> Result<(), String> {
    println!("{}\n", machine::line());
    println!(
        "Build: CPU time, median of {} or more. Rays: {} random, and a frame of about as many, closest hits, median of {} rounds.\n",
        args.build_rounds, args.rays, args.rounds
    );
    let mut points = Vec::new();
    for family in &args.family {
        let sizes = std::iter::successors(Some(args.smallest), |n| n.checked_mul(STEP));
        for size in sizes.take_while(|&n| n <= args.largest) {
            let scene = Loaded::new(&format!("{}:{size}", family.name()))?;
            for &kind in &args.structure {
                eprintln!("{}, {}", scene.name, kind.name());
                points.push(Point::measure(family.name(), kind, &scene, args)?);
            }
        }
    }
    report::growth(&points);
    report::memory(&points);
    report::exponents(&points);
    Ok(())
}

fn main() -> ExitCode {
    args::finish(run(&Args::parse()))
}
