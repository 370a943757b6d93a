//! See `hug --help`.

use clap::Parser;
use hug_tool::args::{Args, Command};
use hug_tool::{build, compare, count, info, render, report};
use std::process::ExitCode;

fn main() -> ExitCode {
    let args = Args::parse();
    hug_bench::args::finish(match &args.command {
        Command::Build(args) => build::run(args),
        Command::Info(args) => info::run(args),
        Command::Render(args) => render::run(args),
        Command::Compare(args) => compare::run(args),
        Command::Count(args) => count::run(args),
        Command::Report(args) => report::run(args),
    })
}
