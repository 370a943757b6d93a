//! The built-in scenes keep the tolerances that they were calibrated to: the paper's figure 4,
//! and for the kitchen figures 12, 14 and 17.

// What only the bench prints is read nowhere here.
#[allow(dead_code)]
#[path = "../benches/scenes/mod.rs"]
mod figures;

use figures::{Check, kitchen, length_checks, lengths, table_checks};
use hug_bench::paper;
use hug_kit::scenes;

fn assert_hold(checks: &[Check]) {
    let out: Vec<&Check> = checks.iter().filter(|check| !check.holds()).collect();
    assert!(out.is_empty(), "{out:#?}");
}

#[test]
fn lengths_are_distributed_as_in_figure_4() {
    for (name, paper) in paper::FIGURE_4 {
        let scene = scenes::generate(name).expect("a scene of this name");
        let ours = lengths(&scene.mesh).expect("the scene builds");
        assert_hold(&length_checks(name, &ours, &paper));
    }
}

#[test]
fn the_kitchen_fills_voxels_as_in_figures_12_14_and_17() {
    let figures = kitchen::figures(&scenes::kitchen().mesh).expect("the kitchen builds");
    let calibrated = figures.iter().filter(|figure| figure.calibrated);
    let checks: Vec<Check> = calibrated.flat_map(table_checks).collect();
    assert_eq!(checks.len(), 3 * (1 + 3 + 4));
    assert_hold(&checks);
}
