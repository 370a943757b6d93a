//! Figures 12, 14 and 17: resources and occupancy by level.

use super::{OURS, PAPER, numbers};
use crate::measure::Built;
use crate::sheet::{Cell, Sheet};
use hug_bench::paper::{self, Other, Row, Table};

/// What the paper prints of this configuration.
fn printed(name: &str) -> Option<(&'static str, Table)> {
    match name {
        "kit.g28" => Some(("Figure 12", paper::figure_12())),
        "kit.u.f3.sqrt2" => Some(("Figure 14", paper::figure_14())),
        "kit.r50" => Some(("Figure 17", paper::figure_17())),
        _ => None,
    }
}

/// The cells of every level, the paper's beside ours, outermost beside outermost.
fn levels(built: &Built, paper: Option<&Table>, sheet: &mut Sheet, of: impl Fn(&Row) -> Vec<f64>) {
    let ours = Table::of(&built.stats);
    let most = ours.rows.len().max(paper.map_or(0, |table| table.rows.len()));
    for level in 0..most {
        for (whose, table) in [(OURS, Some(&ours)), (PAPER, paper)] {
            if let Some(row) = table.and_then(|t| t.below_top(most - 1 - level)) {
                let head = [Cell::from(level.to_string()), whose.into()];
                sheet.row(head.into_iter().chain(numbers(of(row))));
            }
        }
    }
}

fn title(built: &Built, what: &str) -> String {
    let figure = printed(&built.name).map_or(String::new(), |p| format!("{}, ", p.0));
    format!("{figure}{}: {what}", built.name)
}

/// The four tables of a configuration.
pub fn sheets(built: &Built) -> Vec<Sheet> {
    vec![resources(built), objects(built), grids(built), readings(built)]
}

/// What the charts are drawn from: voxels of each level by their triangles.
pub fn histogram(built: &Built) -> Sheet {
    let levels = built.histograms.len();
    let names: Vec<String> = (0..levels).map(|level| format!("level {level}")).collect();
    let head: Vec<&str> =
        std::iter::once("triangles").chain(names.iter().map(String::as_str)).collect();
    let title = title(built, "voxels by their triangles");
    let mut sheet = Sheet::new(file(built, "histogram"), title, &head);
    let longest = built.histograms.iter().map(Vec::len).max().unwrap_or(0);
    for i in 0..longest {
        let counts = built.histograms.iter().map(|h| h.get(i).copied().unwrap_or(0));
        let counts: Vec<u64> = counts.collect();
        if counts.iter().any(|&n| n > 0) {
            sheet.row([i as u64].into_iter().chain(counts).map(Cell::Count));
        }
    }
    sheet
}

fn file(built: &Built, what: &str) -> String {
    format!("{}.{what}", built.name).replace([':', '/', '\\'], "_")
}

fn resources(built: &Built) -> Sheet {
    let paper = printed(&built.name).map(|p| p.1);
    let head = ["level", "", "%obj", "%grids", "%voxels", "%ptrs", "%vol", "MB"];
    let mut sheet = Sheet::new(file(built, "resources"), title(built, "resources"), &head);
    levels(built, paper.as_ref(), &mut sheet, |r| {
        vec![r.objects, r.grids, r.voxels, r.pointers, r.volume]
    });
    let shares = built.stats.shares(&built.stats.total);
    sheet.row([
        "%".into(),
        OURS.into(),
        100.0.into(),
        100.0.into(),
        100.0.into(),
        100.0.into(),
        shares.volume.into(),
    ]);
    let ours = Table::of(&built.stats).sums;
    for (whose, sums) in [(OURS, Some(ours)), (PAPER, paper.map(|p| p.sums))] {
        let Some(sums) = sums else { continue };
        let counts = [sums.objects, sums.grids, sums.voxels, sums.pointers].map(Cell::Count);
        let cells = [Cell::from("sum"), whose.into()].into_iter().chain(counts);
        sheet.row(cells.chain([Cell::None, sums.megabytes.into()]));
    }
    sheet
}

fn objects(built: &Built) -> Sheet {
    let paper = printed(&built.name).map(|p| p.1);
    let head = ["level", "", "mu_og", "%o", "mu_ov", "sigma_ov", "mu'_ov", "sigma'_ov"];
    let title = title(built, "triangles a voxel");
    let mut sheet = Sheet::new(file(built, "objects"), title, &head);
    if built.name == "kit.g28" {
        sheet.note = "Figure 12 prints mu_ov and mu'_ov in objects, 0.952 and 3.35; the paper's \
                      line has the references of its sums instead, so that all tables read alike."
            .into();
    }
    levels(built, paper.as_ref(), &mut sheet, |r| {
        [&[r.per_grid, r.filled][..], &r.per_voxel, &r.per_filled].concat()
    });
    sheet
}

fn grids(built: &Built) -> Sheet {
    let paper = printed(&built.name).map(|p| p.1);
    let head = ["level", "", "%g", "mu_gv", "sigma_gv", "mu'_gv", "sigma'_gv"];
    let mut sheet = Sheet::new(file(built, "grids"), title(built, "grids a voxel"), &head);
    levels(built, paper.as_ref(), &mut sheet, |r| r.grid_pointers.to_vec());
    sheet
}

/// The readings that the tables above do not take.
fn readings(built: &Built) -> Sheet {
    let head = [
        "level",
        "%obj of the scene",
        "objects a grid",
        "distinct a voxel",
        "distinct a filled voxel",
    ];
    let title = title(built, "the other readings");
    let mut sheet = Sheet::new(file(built, "readings"), title, &head).noted(
        "%obj and mu_og as section 3 defines them; mu_ov and mu'_ov as figure 12 prints them, in \
         distinct triangles.",
    );
    let stats = &built.stats;
    let named = stats.levels().iter().enumerate().map(|(n, level)| (n.to_string(), level));
    for (name, level) in named.chain([("sum".to_owned(), &stats.total)]) {
        let other = Other::new(stats, level);
        let [voxel, filled] = other.per_voxel;
        let head = [Cell::from(name)].into_iter();
        sheet.row(head.chain(numbers([other.objects, other.per_grid, voxel, filled])));
    }
    sheet
}
