//! Figure 4.

use super::{OURS, PAPER};
use crate::measure::{CLASSES, SHARE, Subject};
use crate::sheet::{Cell, Sheet};
use hug_bench::paper::{FIGURE_4, Lengths};

pub fn sheet(subjects: &[Subject]) -> Sheet {
    let head = ["scene", "", "#polys", "min/max", "min/diag", "%.2"];
    let mut sheet = Sheet::new("figure_4", "Figure 4: scenes", &head).noted(
        "A length is the diagonal of a triangle's box; %.2: triangles shorter than a fifth of the \
         largest.",
    );
    let mut line = |name: &str, whose: &str, l: &Lengths| {
        let cells = [Cell::from(name), whose.into(), l.count.into()];
        sheet.row(cells.into_iter().chain([l.min_max, l.min_diag, l.below].map(Cell::Number)));
    };
    for subject in subjects {
        line(&subject.loaded.name, OURS, &Lengths::of(&subject.lengths));
        if let Some(paper) = FIGURE_4.iter().find(|f| f.0 == subject.loaded.name) {
            line("", PAPER, &paper.1);
        }
    }
    sheet
}

/// What the chart of lengths is drawn from.
pub fn histogram(subject: &Subject) -> Sheet {
    let name = format!("{}.lengths", subject.short).replace([':', '/', '\\'], "_");
    let title = format!("{}: triangles by length over the largest", subject.loaded.name);
    let mut sheet = Sheet::new(name, title, &["from", "to", "triangles"]);
    let width = SHARE / CLASSES as f64;
    for (class, &count) in subject.length_counts.iter().enumerate() {
        let from = width * class as f64;
        sheet.row([from.into(), (from + width).into(), count.into()]);
    }
    sheet
}
