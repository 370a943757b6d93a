//! The bottom of figure 10.

use super::{OURS, PAPER};
use crate::measure::Subject;
use crate::sheet::{Cell, Sheet};
use hug_bench::paper::rendering::FIGURE_10_BOTTOM;

/// The bottom of figure 10, of every view: calls, memory, time.
pub fn bottom(subject: &Subject) -> Vec<Sheet> {
    (0..subject.frames.len()).map(|frame| sheet(subject, frame)).collect()
}

fn sheet(subject: &Subject, frame: usize) -> Sheet {
    let view = &subject.frames[frame].view;
    let head = [
        "DS",
        "",
        "#pit",
        "#bbi",
        "#vt",
        "MB",
        "MB with triangles",
        "t (ms)",
        "least",
        "most",
        "built in (ms)",
    ];
    let name = format!("{}.{view}.figure_10_bottom", subject.short).replace([':', '/'], "_");
    let title = format!("Figure 10, bottom: {}, view {view}", subject.short);
    let mut sheet = Sheet::new(name, title, &head).noted(
        "#pit: ray-triangle tests; #bbi: grids entered or tested; #vt: voxels traversed; t: CPU \
         time by the queries that count nothing, median, least and most of rounds in which all \
         structures take turns. MB is without the triangles themselves. The \
         paper's times are of a machine of 1997.",
    );
    for built in &subject.built {
        let rendered = &built.rendered[frame];
        let c = rendered.profile.total();
        let cells = [Cell::from(built.name.clone()), OURS.into()];
        let calls = [c.tests, c.grids, c.voxels].map(Cell::Count);
        let whole = built.stats.bytes as f64 / f64::from(1 << 20);
        let t = rendered.seconds.times(1e3);
        let costs = [built.megabytes(), whole, t.median, t.least, t.most, 1e3 * built.seconds];
        sheet.row(cells.into_iter().chain(calls).chain(costs.map(Cell::Number)));
        let paper = FIGURE_10_BOTTOM.iter().find(|p| frame == 0 && p.name == built.name);
        if let Some(p) = paper {
            let cells = [Cell::from(""), PAPER.into()].into_iter();
            let calls = cells.chain(p.calls.map(|n| Cell::Count(n as u64)));
            sheet.row(calls.chain([p.megabytes.into(), Cell::None, (1e3 * p.seconds).into()]));
        }
    }
    sheet
}
