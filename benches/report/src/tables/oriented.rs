//! Figure 25 as tables, and what rays gain.

use crate::oriented::boxes::{CLASSES, START, WIDTH, beside_one, histogram, median};
use crate::oriented::{Clustered, Measure, Oriented, Steps, Turned};
use crate::selected::SETS;
use crate::sheet::{Cell, Sheet};

/// The measures of a box, and how to read them off.
pub const MEASURES: [(&str, Measure); 2] =
    [("surface", |ratios| ratios.surface), ("volume", |ratios| ratios.volume)];

/// Of the tables on the page; the first of them is short, the last what the plots are drawn from.
pub fn sheets(scene: &Oriented) -> [Sheet; 3] {
    [boxes(scene), rays(scene), histograms(scene)]
}

pub fn file(scene: &Oriented, what: &str) -> String {
    format!("{}.{what}", scene.short).replace([':', '/', '\\'], "_")
}

fn boxes(scene: &Oriented) -> Sheet {
    let head =
        ["clusters", "along", "of", "ratios", "median", "% smaller", "% same", "% larger", "% > 3"];
    let title = format!("Figure 25, {}: turned boxes over aligned ones", scene.name);
    let mut sheet = Sheet::new(file(scene, "figure_25"), title, &head).noted(
        "All clusters without grids below them, turned for better or worse. Same: to 0.1 %. \
         Clusters that lie in a plane along the axes have no volume either way, and no ratio.",
    );
    for clustered in &scene.clusterings {
        for turned in &clustered.turned {
            for (measure, of) in MEASURES {
                let ratios = turned.all(of);
                let head = [clustered.notation, turned.along, measure].map(Cell::from);
                let shares = beside_one(&ratios).map(Cell::from);
                let inside: u64 = histogram(&ratios).iter().sum();
                let outside = ratios.len() as u64 - inside;
                let above = 100.0 * outside as f64 / ratios.len().max(1) as f64;
                let count = Cell::from(ratios.len() as u64);
                let middle = [count, median(ratios).into()];
                sheet.row(head.into_iter().chain(middle).chain(shares).chain([above.into()]));
            }
        }
    }
    sheet
}

fn rays(scene: &Oriented) -> Sheet {
    let head = [
        "clusters",
        "along",
        "grids",
        "% turned",
        "rays",
        "boxes met",
        "box tests",
        "voxels",
        "tests",
    ];
    let title = format!("{}: rays, where clusters are turned if it pays", scene.name);
    let mut sheet = Sheet::new(file(scene, "turned_rays"), title, &head).noted(
        "A cluster is turned if its box then has less than 0.8 of the aligned one's surface, as \
         by default. Counted, a ray, with steps of one voxel. Boxes met: those of clusters on the \
         way to the hit, each once, of up to 16,384 rays. Box tests are the walk's: the grid above refers to a cluster \
         wherever its aligned box is.",
    );
    for clustered in &scene.clusterings {
        let aligned = ("aligned", 0, &clustered.aligned);
        let turned = clustered.turned.iter().map(|t: &Turned| (t.along, t.kept, &t.steps));
        for (along, kept, steps) in std::iter::once(aligned).chain(turned) {
            for (name, steps) in SETS.iter().zip(steps) {
                sheet.row(row(clustered, along, kept, name, steps));
            }
        }
    }
    sheet
}

fn row(clustered: &Clustered, along: &str, kept: usize, rays: &str, steps: &Steps) -> Vec<Cell> {
    let share = 100.0 * kept as f64 / clustered.clusters.max(1) as f64;
    let count = Cell::from(clustered.clusters as u64);
    let mut cells = vec![clustered.notation.into(), along.into(), count, share.into(), rays.into()];
    let Steps { met, grids, voxels, tests } = *steps;
    cells.extend([met, grids, voxels, tests].map(Cell::from));
    cells
}

fn histograms(scene: &Oriented) -> Sheet {
    let all = scene.clusterings.iter().flat_map(|c| c.turned.iter().map(move |t| (c, t)));
    let (mut names, mut counts) = (Vec::new(), Vec::new());
    for (clustered, turned) in all {
        for (measure, of) in MEASURES {
            names.push(format!("{} {} {measure}", clustered.notation, turned.along));
            counts.push(histogram(&turned.all(of)));
        }
    }
    let head: Vec<&str> =
        ["from", "to"].into_iter().chain(names.iter().map(String::as_str)).collect();
    let title = format!("{}: clusters by the ratio of their boxes", scene.name);
    let mut sheet = Sheet::new(file(scene, "figure_25.histogram"), title, &head);
    for class in 0..CLASSES {
        let ends = [class, class + 1].map(|i| Cell::from(START + WIDTH * i as f64));
        sheet.row(ends.into_iter().chain(counts.iter().map(|of| Cell::from(of[class]))));
    }
    sheet
}
