//! Figures 20, 22 and 23: what a picture costs, level by level.

use super::{OURS, PAPER, numbers};
use crate::measure::{Built, Subject};
use crate::sheet::{Cell, Sheet};
use hug::Calls;
use hug_bench::notation::Configuration;
use hug_bench::paper::rendering::{FIGURES_20_TO_23, Rendering};

fn percent(part: u64, whole: u64) -> f64 {
    100.0 * part as f64 / whole.max(1) as f64
}

/// %pit, %pi, %(pi / pit), %bbi, %vt of a level.
pub fn shares(level: &Calls, total: &Calls) -> [f64; 5] {
    [
        percent(level.tests, total.tests),
        percent(level.hits, total.hits),
        level.percent_hits(),
        percent(level.grids, total.grids),
        percent(level.voxels, total.voxels),
    ]
}

/// Whether the paper prints this structure from this view of the scene.
fn printed(subject: &Subject, built: &Built, frame: usize) -> Option<&'static Rendering> {
    let view = &subject.frames[frame].view;
    FIGURES_20_TO_23.iter().find(|figure| {
        let known: Result<Configuration, String> = figure.name.parse();
        known.is_ok_and(|known| {
            let same = known.scene == subject.loaded.name && known.structure == built.notation;
            same && known.view().map_or(frame == 0, |name| name == view)
        })
    })
}

/// The table of a structure from one view.
pub fn sheet(subject: &Subject, built: &Built, frame: usize) -> Sheet {
    let view = &subject.frames[frame].view;
    let paper = printed(subject, built, frame);
    let figure = paper.map_or(String::new(), |p| format!("Figure {}, ", p.figure));
    let title = format!("{figure}{}: rendering, view {view}", built.name);
    let name = format!("{}.{view}.rendering", built.name).replace([':', '/', '\\'], "_");
    let head = ["level", "", "%pit", "%pi", "%(pi / pit)", "%bbi", "%vt", "%s1", "%s2", "t (ms)"];
    let mut sheet = Sheet::new(name, title, &head);
    let rendered = &built.rendered[frame];
    let (total, levels) = (rendered.profile.total(), built.stats.levels().len());
    let printed = paper.map_or(0, |p| p.levels.len());
    let most = levels.max(printed);
    for level in 0..most {
        // Outermost beside outermost.
        if let Some(ours) = (level + levels).checked_sub(most) {
            let calls = &rendered.profile.levels()[ours];
            let passed = [calls.percent_passed_1(), calls.percent_passed_2()];
            let cells = shares(calls, &total).into_iter().chain(passed);
            let head = [Cell::from(level.to_string()), OURS.into()];
            sheet.row(head.into_iter().chain(numbers(cells)));
        }
        if let Some((p, theirs)) = paper.zip((level + printed).checked_sub(most)) {
            let head = [Cell::from(level.to_string()), PAPER.into()];
            sheet.row(head.into_iter().chain(numbers(p.levels[theirs])));
        }
    }
    let ratio = |a: f64, b: f64| Cell::Number(100.0 * a / b.max(1.0));
    let Calls { tests, hits, grids, voxels, .. } = total;
    sheet.row([
        "sum".into(),
        OURS.into(),
        tests.into(),
        hits.into(),
        total.percent_hits().into(),
        grids.into(),
        voxels.into(),
        total.percent_passed_1().into(),
        total.percent_passed_2().into(),
        (1e3 * rendered.seconds.median).into(),
    ]);
    if let Some(p) = paper {
        let [pit, pi, bbi, vt] = p.sums.map(|n| Cell::Count(n as u64));
        let hits = ratio(p.sums[1], p.sums[0]);
        let time = Cell::Number(1e3 * p.seconds);
        sheet.row([
            "sum".into(),
            PAPER.into(),
            pit,
            pi,
            hits,
            bbi,
            vt,
            Cell::None,
            Cell::None,
            time,
        ]);
    }
    sheet
}
