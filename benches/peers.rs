//! hug beside obvhs, a BVH library in Rust: build time, memory, closest hits and occlusion on the
//! same triangles and rays, and how many rays end differently.

#[path = "peers/builds.rs"]
mod builds;
#[path = "peers/contest.rs"]
mod contest;
#[path = "peers/differences.rs"]
mod differences;
#[path = "peers/peer.rs"]
mod peer;
#[path = "peers/report.rs"]
mod report;

use clap::{Parser, ValueEnum};
use hug_bench::args::{self, Cargo};
use hug_bench::kind::Kind;
use hug_bench::load::{self, Loaded};
use hug_bench::machine;
use hug_bench::ray_sets::{RaySets, Set};
use peer::Builder;
use std::process::ExitCode;

/// hug beside obvhs on the same triangles and rays.
#[derive(Parser)]
struct Args {
    /// Built-in scenes or PLY files, also those in $HUG_SCENES; several with commas. "all": every
    /// built-in scene and every file in $HUG_SCENES
    #[arg(long, value_delimiter = ',', default_value = "kitchen")]
    scene: Vec<String>,
    /// A view of the scene, instead of its first
    #[arg(long)]
    view: Option<String>,
    /// Structures of hug, several with commas
    #[arg(long, value_enum, value_delimiter = ',', default_value = "auto")]
    structure: Vec<Kind>,
    /// Trees of obvhs, several with commas
    #[arg(long, value_enum, value_delimiter = ',', default_values = Builder::NAMES)]
    builder: Vec<Builder>,
    /// Ray sets, several with commas
    #[arg(long, value_enum, value_delimiter = ',', default_values = Set::ALL.map(Set::name))]
    rays: Vec<Set>,
    /// Closest hits, occlusion, or both with a comma
    #[arg(long, value_enum, value_delimiter = ',', default_values = ["closest", "occluded"])]
    query: Vec<Query>,
    /// Pixels along each side of a frame
    #[arg(long, default_value_t = 512, value_parser = clap::value_parser!(u32).range(1..=4096))]
    size: u32,
    /// How often each set is timed
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u64).range(1..))]
    rounds: u64,
    /// How often each build is timed
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u64).range(1..))]
    build_rounds: u64,
    #[command(flatten)]
    cargo: Cargo,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Query {
    Closest,
    Occluded,
}

impl Query {
    fn name(self) -> &'static str {
        match self {
            Self::Closest => "closest",
            Self::Occluded => "occluded",
        }
    }
}

fn scenes(args: &Args) -> Result<Vec<String>, String> {
    if args.scene != ["all"] {
        return Ok(args.scene.clone());
    }
    let built_in = hug_kit::scenes::NAMES.map(str::to_owned).into_iter();
    Ok(built_in.chain(load::files(u64::MAX)?).collect())
}

fn run(args: &Args) -> Result<(), String> {
    println!("{}\n", machine::line());
    for name in scenes(args)? {
        eprintln!("{name}");
        let scene = Loaded::new(&name)?;
        let camera = scene.view(args.view.as_deref())?;
        let built = builds::run(&scene, args)?;
        report::scene(&scene, args.build_rounds);
        report::builds(&built, scene.mesh.indices.len());
        let rays = RaySets::new(&built.hug[0].scene.view(), &scene.bounds, &camera, args.size);
        let mut contests = Vec::new();
        for &set in &args.rays {
            for &query in &args.query {
                let rounds = args.rounds as usize;
                contests.push(contest::run(&built, set, query, rays.get(set), rounds)?);
            }
        }
        report::speeds(&built, &contests, args.rounds);
        report::ratios(&built, &contests);
        report::differences(&built, &contests);
    }
    Ok(())
}

fn main() -> ExitCode {
    args::finish(run(&Args::parse()))
}
