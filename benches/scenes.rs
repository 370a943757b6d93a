//! Prints the built-in scenes' figures beside those the paper prints for its own: figure 4, and
//! for the kitchen figures 12, 14 and 17. Fails if one that the scenes are calibrated on is out
//! of its tolerance.

#[path = "scenes/mod.rs"]
mod figures;
#[path = "scenes/print.rs"]
mod print;

use figures::{kitchen, length_checks, table_checks};
use hug_bench::paper;
use hug_kit::scenes;
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut checks = Vec::new();
    print::lengths_head();
    for (name, paper) in paper::FIGURE_4 {
        let scene = scenes::generate(name).expect("a scene of this name");
        let ours = figures::lengths(&scene.mesh).expect("the scene builds");
        print::lengths(name, &ours, &paper);
        checks.extend(length_checks(name, &ours, &paper));
    }
    let figures = kitchen::figures(&scenes::kitchen().mesh).expect("the kitchen builds");
    print::readings();
    for figure in &figures {
        print::figure(figure);
        if figure.calibrated {
            checks.extend(table_checks(figure));
        }
    }
    print::checks(&checks);
    if checks.iter().all(figures::Check::holds) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
