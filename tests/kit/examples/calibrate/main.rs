//! Prints the generated scenes' figures beside those the paper prints for its own.

mod clusters;
mod filter;
mod grids;
mod overlap;

use clusters::clusters;
use filter::{LEVELS, Levels};
use grids::{Grid, recursive};
use hug_kit::{Mesh, scenes};
use std::time::Instant;

/// Figure 4: scene, polygons, min/max, min/diag, share below 0.2 of the largest, in percent.
const FIGURE_4: [(&str, usize, f64, f64, f64); 5] = [
    ("kitchen", 20947, 9.0e-4, 6.5e-4, 99.29),
    ("building_walls", 32811, 5.7e-4, 3.6e-4, 99.49),
    ("building", 117605, 1.0e-5, 8.1e-6, 99.99),
    ("city", 52136, 2.9e-3, 1.0e-3, 99.85),
    ("garden", 45293, 4.3e-3, 1.1e-3, 99.72),
];

fn main() {
    println!("figure 4, each scene as generated, then as in the paper");
    println!("scene            triangles   min/max  min/diag      %.2  generated in");
    for (name, count, min_max, min_diag, below) in FIGURE_4 {
        let start = Instant::now();
        let Some(scene) = scenes::generate(name) else {
            continue;
        };
        let took = start.elapsed().as_secs_f64() * 1e3;
        let lengths = lengths(&scene.mesh);
        let min = lengths.iter().copied().fold(f64::INFINITY, f64::min);
        let max = lengths.iter().copied().fold(0.0, f64::max);
        let small = lengths.iter().filter(|&&d| d < 0.2 * max).count();
        let share = percent(small, lengths.len());
        let diagonal = scene.mesh.bounds().map_or(f64::NAN, |b| b.diagonal());
        println!(
            "{name:<15} {:>10} {:>9.1e} {:>9.1e} {share:>8.2} {took:>8.1} ms",
            lengths.len(),
            min / max,
            min / diagonal
        );
        println!("{:<15} {count:>10} {min_max:>9.1e} {min_diag:>9.1e} {below:>8.2}", "");
    }
    if let Some(scene) = scenes::generate("kitchen") {
        figure_12(&scene.mesh);
        figure_14(&scene.mesh);
        figure_17(&scene.mesh);
    }
}

/// Each triangle's length: the diagonal of its box.
fn lengths(mesh: &Mesh) -> Vec<f64> {
    overlap::boxes(mesh).iter().map(|b| b.diagonal()).collect()
}

fn percent(part: usize, whole: usize) -> f64 {
    100.0 * part as f64 / whole as f64
}

fn figure_12(mesh: &Mesh) {
    let all: Vec<u32> = (0..mesh.indices.len() as u32).collect();
    let grid = Grid::new(mesh, &all, &overlap::bounds(mesh), [28; 3]);
    let few = grid.voxels.iter().filter(|v| v.len() < 20).count();
    println!("\nfigure 12, kit.g28        ours    paper");
    let line = |what: &str, ours: f64, paper: f64| println!("{what:<22} {ours:>8.3} {paper:>8}");
    line("% non-empty voxels", percent(grid.occupied(), grid.voxels.len()), 28.4);
    line("references", grid.references() as f64, 58387.0);
    let (mean, sigma) = grid.spread(false);
    line("references/voxel", mean, 2.66);
    line("  sigma", sigma, 23.0);
    let (mean, sigma) = grid.spread(true);
    line("  non-empty", mean, 9.37);
    line("  non-empty, sigma", sigma, 42.8);
    line("% voxels below 20", percent(few, grid.voxels.len()), 98.0);
}

fn figure_14(mesh: &Mesh) {
    let lengths = lengths(mesh);
    let levels = Levels::otsu(&lengths);
    println!("\nfigure 14, kit.u.f3: levels from {:.4?} m", levels.bounds());
    println!("level   %obj (paper)   clusters (paper)   %grids (paper)   refs/voxel (paper)");
    let parts: Vec<Vec<Vec<u32>>> = (0..LEVELS)
        .map(|level| {
            let members = levels.members(&lengths, level);
            if level + 1 == LEVELS {
                vec![members]
            } else {
                clusters(&overlap::boxes(mesh), members, levels.midpoint(level))
            }
        })
        .collect();
    let grids: usize = parts.iter().map(Vec::len).sum();
    for (level, paper) in [(82.6, 245, 70.0, 3.32), (5.84, 104, 29.7, 6.01), (11.5, 1, 0.286, 2.49)]
        .into_iter()
        .enumerate()
    {
        let clusters = &parts[level];
        let objects: usize = clusters.iter().map(Vec::len).sum();
        let (mut references, mut voxels) = (0, 0);
        for cluster in clusters {
            let alpha = if level + 1 == LEVELS { f64::sqrt(2.0) } else { 1.0 };
            let count = (alpha * (cluster.len() as f64).cbrt()).ceil() as usize;
            let bounds = match level + 1 == LEVELS {
                true => overlap::bounds(mesh),
                false => overlap::bounds_of(mesh, cluster),
            };
            let grid = Grid::new(mesh, cluster, &bounds, [count; 3]);
            references += grid.references();
            voxels += grid.voxels.len();
        }
        println!(
            "{level:<5} {:>6.2} ({:>5})   {:>8} ({:>5})   {:>6.2} ({:>5})   {:>8.2} ({:>5})",
            percent(objects, lengths.len()),
            paper.0,
            clusters.len(),
            paper.1,
            percent(clusters.len(), grids),
            paper.2,
            references as f64 / voxels as f64,
            paper.3
        );
    }
    println!("grids {grids} (paper 350)");
}

fn figure_17(mesh: &Mesh) {
    let all: Vec<u32> = (0..mesh.indices.len() as u32).collect();
    let depths = recursive(mesh, &all, &overlap::bounds(mesh), 50);
    println!("\nfigure 17, kit.r50 (paper: 246 grids, 61030 voxels, 196232 references, 4 levels)");
    println!("depth    grids   voxels     refs  %non-empty");
    let mut sum = [0; 3];
    for (depth, d) in depths.iter().enumerate() {
        println!(
            "{depth:<5} {:>8} {:>8} {:>8} {:>8.1}",
            d.grids,
            d.voxels,
            d.references,
            percent(d.occupied, d.voxels)
        );
        sum = [sum[0] + d.grids, sum[1] + d.voxels, sum[2] + d.references];
    }
    println!("sum   {:>8} {:>8} {:>8}", sum[0], sum[1], sum[2]);
}
