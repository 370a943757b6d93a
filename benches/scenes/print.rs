//! The tables on the terminal, ours above the paper's.

use super::figures::Check;
use super::figures::Tolerance::{Factor, Points};
use super::figures::kitchen::Figure;
use hug_bench::paper::{Lengths, Row, Sums};

pub fn lengths_head() {
    println!("figure 4");
    println!(
        "{:<15} {:<5} {:>9} {:>9} {:>9} {:>7}",
        "", "", "triangles", "min/max", "min/diag", "%.2"
    );
}

pub fn lengths(name: &str, ours: &Lengths, paper: &Lengths) {
    for (name, whose, l) in [(name, "ours", ours), ("", "paper", paper)] {
        println!(
            "{name:<15} {whose:<5} {:>9} {:>9.1e} {:>9.1e} {:>7.2}",
            l.count, l.min_max, l.min_diag, l.below
        );
    }
}

/// Three significant digits or so, as in the paper.
fn number(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        a if a < 0.01 => format!("{x:.2e}"),
        a if a < 10.0 => format!("{x:.3}"),
        a if a < 100.0 => format!("{x:.2}"),
        _ => format!("{x:.1}"),
    }
}

fn line(level: &str, whose: &str, cells: &[String]) {
    print!("{level:<5} {whose:<5}");
    for cell in cells {
        print!(" {cell:>9}");
    }
    println!();
}

fn head(names: &[&str]) {
    println!();
    line("level", "", &names.iter().map(|n| (*n).to_owned()).collect::<Vec<_>>());
}

/// Some columns of every level, the outermost beside the outermost.
fn columns(figure: &Figure, of: impl Fn(&Row) -> Vec<f64>) {
    let (ours, paper) = (&figure.ours, &figure.paper);
    let levels = ours.rows.len().max(paper.rows.len());
    for level in 0..levels {
        let cells = |row: &Row| of(row).into_iter().map(number).collect::<Vec<_>>();
        let mut name = level.to_string();
        for (whose, table) in [("ours", ours), ("paper", paper)] {
            if let Some(row) = table.below_top(levels - 1 - level) {
                line(&name, whose, &cells(row));
                name.clear();
            }
        }
    }
}

fn sums(whose: &str, s: &Sums) {
    let counts = [s.objects, s.grids, s.voxels, s.pointers].map(|n| n.to_string());
    let name = if whose == "ours" { "sum" } else { "" };
    line(name, whose, &[&counts[..], &[format!("{:.2} MB", s.megabytes)]].concat());
}

/// Which of the readings in `paper::table` the tables and the checks take.
pub fn readings() {
    println!("\nThe tables and the tolerances read as figures 14 and 17 print: %obj sums to 100,");
    println!(
        "mu_og is %obj / %grids, mu_ov counts references. Figure 12 prints objects, 0.952 and"
    );
    println!("3.35: its references a voxel follow from its sums.");
}

pub fn figure(figure: &Figure) {
    println!("\n{}", figure.title);
    head(&["%obj", "%grids", "%voxels", "%ptrs", "%vol"]);
    columns(figure, |r| vec![r.objects, r.grids, r.voxels, r.pointers, r.volume]);
    sums("ours", &figure.ours.sums);
    sums("paper", &figure.paper.sums);
    head(&["mu_og", "%o", "mu_ov", "sigma_ov", "mu'_ov", "sigma'_ov"]);
    columns(figure, |r| [&[r.per_grid, r.filled][..], &r.per_voxel, &r.per_filled].concat());
    head(&["%g", "mu_gv", "sigma_gv", "mu'_gv", "sigma'_gv"]);
    columns(figure, |r| r.grid_pointers.to_vec());
    println!("\nour other readings: %obj of the scene's; mu_og, mu_ov, mu'_ov in objects");
    head(&["%obj", "mu_og", "mu_ov", "mu'_ov"]);
    for (level, other) in figure.other.iter().enumerate() {
        let cells = [other.objects, other.per_grid, other.per_voxel[0], other.per_voxel[1]];
        line(&level.to_string(), "ours", &cells.map(number));
    }
}

pub fn checks(checks: &[Check]) {
    println!("\n{:<58} {:>9} {:>9}  tolerance", "calibrated", "ours", "paper");
    for check in checks {
        let tolerance = match check.tolerance {
            Factor(f) => format!("x {f:.2}"),
            Points(p) => format!("+- {p:.2}"),
        };
        let mark = if check.holds() { "" } else { "  OUT" };
        let (ours, paper) = (number(check.ours), number(check.paper));
        println!("{:<58} {ours:>9} {paper:>9}  {tolerance}{mark}", check.what);
    }
}
