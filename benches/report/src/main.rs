//! Repeats the paper's tables, plots and claims: see `--help`.

use clap::Parser;
use hug_report::args::Args;
use hug_report::run::run;
use std::process::ExitCode;

fn main() -> ExitCode {
    let args = Args::parse();
    let given: Vec<String> = std::env::args().skip(1).collect();
    let command = format!("hug-report {}", given.join(" "));
    hug_bench::args::finish(run(&args, &command).map(|page| println!("{}", page.display())))
}
