//! What AUTO's parameters trade: builds, memory and rays of recursive grids of many settings on
//! many scenes; which setting would be chosen; and what would be if a scene had not been there
//! to choose by.

#[path = "tuning/choice.rs"]
mod choice;
#[path = "tuning/measure.rs"]
mod measure;
#[path = "tuning/report.rs"]
mod report;
#[path = "tuning/setting.rs"]
mod setting;

use choice::Rule;
use clap::Parser;
use hug_bench::args::{self, Cargo};
use hug_bench::load::{self, Loaded};
use hug_bench::machine;
use setting::Setting;
use std::process::ExitCode;

/// Settings of AUTO's recursive grid on many scenes, and the choice with each scene left out.
#[derive(Parser)]
struct Args {
    /// Built-in scenes or PLY files, also those in $HUG_SCENES; several with commas. "files": every
    /// file in $HUG_SCENES
    #[arg(long, value_delimiter = ',', default_value = "files")]
    scene: Vec<String>,
    /// Alphas of the outermost grid, several with commas
    #[arg(long, value_delimiter = ',', default_values_t = [0.5, 0.63, 0.8, 1.26])]
    world_alpha: Vec<f32>,
    /// Alphas of the grids below, several with commas
    #[arg(long, value_delimiter = ',', default_values_t = [0.4, 0.6, 0.7, 1.0])]
    alpha: Vec<f32>,
    /// References up to which a voxel is not split, several with commas
    #[arg(long, value_delimiter = ',', default_values_t = [64, 128, 192, 256, 512])]
    maxp: Vec<u32>,
    /// Share of the best setting's speed that the one that builds soonest has to keep, in each set
    /// of rays
    #[arg(long, default_value_t = 0.9)]
    keep: f64,
    /// Pixels along each side of a frame
    #[arg(long, default_value_t = 96, value_parser = clap::value_parser!(u32).range(8..=4096))]
    size: u32,
    /// How often each set of rays is timed
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u64).range(1..))]
    rounds: u64,
    /// How often each build is timed
    #[arg(long, default_value_t = 2, value_parser = clap::value_parser!(u64).range(1..))]
    build_rounds: u64,
    #[command(flatten)]
    cargo: Cargo,
}

fn scenes(args: &Args) -> Result<Vec<String>, String> {
    if args.scene == ["files"] { load::files(u64::MAX) } else { Ok(args.scene.clone()) }
}

fn settings(args: &Args) -> Vec<Setting> {
    let mut all = Vec::new();
    for &world_alpha in &args.world_alpha {
        for &alpha in &args.alpha {
            all.extend(args.maxp.iter().map(|&maxp| Setting { world_alpha, alpha, maxp }));
        }
    }
    all
}

fn run(args: &Args) -> Result<(), String> {
    println!("{}\n", machine::line());
    let settings = settings(args);
    let mut scenes = Vec::new();
    for name in self::scenes(args)? {
        eprintln!("{name}");
        let scene = Loaded::new(&name)?;
        scenes.push(measure::scene(&scene, &settings, args)?);
    }
    if scenes.len() < 2 {
        return Err("two scenes are needed at least; is HUG_SCENES set?".to_owned());
    }
    report::settings(&settings, &scenes);
    for rule in [Rule::BestQueries, Rule::SoonestBuild { keep: args.keep }] {
        report::left_out(rule, &settings, &scenes);
    }
    Ok(())
}

fn main() -> ExitCode {
    args::finish(run(&Args::parse()))
}
