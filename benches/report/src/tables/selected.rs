//! Section 7.5: time and memory of all structures, and the recursive grid at equal memory and at
//! equal cost.

use crate::selected::curves::RECURSIVE;
use crate::selected::{Comparison, Contest, Entry, Judged, Ordinate, SETS};
use crate::sheet::{Cell, Sheet};

/// The tables of a scene with one kind of walk.
pub fn sheets(comparison: &Comparison, contest: &Contest) -> Vec<Sheet> {
    let mut sheets = vec![measured(comparison, contest)];
    sheets.extend(Ordinate::ALL.map(|ordinate| equal(comparison, contest, ordinate)));
    sheets
}

/// A name for a file of a scene with one kind of walk.
pub fn file(comparison: &Comparison, contest: &Contest, what: &str) -> String {
    let name = format!("{}.selected.{}.{what}", comparison.short, contest.walk.file());
    name.replace([':', '/', '\\'], "_")
}

fn title(comparison: &Comparison, contest: &Contest, what: &str) -> String {
    format!("Section 7.5, {}, {}: {what}", comparison.short, contest.walk.text())
}

fn measured(comparison: &Comparison, contest: &Contest) -> Sheet {
    let head = [
        "DS",
        "curve",
        "bytes",
        "MB",
        "%vol",
        "build ms",
        "build least",
        "build most",
        "rays",
        "ns",
        "ns least",
        "ns most",
        "voxels",
        "tests",
        "both",
        "grids",
    ];
    let title = title(comparison, contest, "time and memory");
    let mut sheet = Sheet::new(file(comparison, contest, "measured"), title, &head).noted(
        "bytes: the arena; MB is without the triangles, which are the same in all. ns: CPU time of \
         a closest hit; it and build ms are medians, least and most of rounds in which all take \
         turns. voxels, tests, both together, grids: counted, a ray. primary: of all views.",
    );
    for entry in &contest.entries {
        let head = [
            Cell::from(entry.name.clone()),
            entry.curve.clone().into(),
            entry.bytes.into(),
            entry.megabytes().into(),
            entry.volume.into(),
        ];
        let build = entry.build.times(1e3);
        let head = head.into_iter().chain([build.median, build.least, build.most].map(Cell::from));
        let head: Vec<Cell> = head.collect();
        for (name, cost) in SETS.iter().zip(&entry.costs) {
            let (t, calls) = (cost.time, &cost.calls);
            let times = [t.median, t.least, t.most];
            let counts = [cost.each(calls.voxels), cost.each(calls.tests), cost.work()];
            let numbers = times.into_iter().chain(counts).chain([cost.each(calls.grids)]);
            let rays = std::iter::once(Cell::from(*name)).chain(numbers.map(Cell::Number));
            sheet.row(head.iter().cloned().chain(rays));
        }
    }
    sheet
}

/// Everything that is not a recursive grid, with what to read it against.
fn others(contest: &Contest) -> impl Iterator<Item = &Entry> {
    contest.entries.iter().filter(|entry| entry.curve != RECURSIVE)
}

fn equal(comparison: &Comparison, contest: &Contest, ordinate: Ordinate) -> Sheet {
    let cost = ordinate.text();
    let better = match ordinate {
        Ordinate::Time => "times as fast",
        Ordinate::Work => "times as cheap",
    };
    let head = [
        "DS",
        "rays",
        "MB",
        cost,
        "recursive in this memory",
        better,
        "MB of recursive at this cost",
        "share of its memory",
        "with triangles",
        "out of range",
    ];
    let what = format!("at equal memory and at equal {}", ordinate.file());
    let name = file(comparison, contest, &format!("equal_{}", ordinate.file()));
    let mut sheet = Sheet::new(name, title(comparison, contest, &what), &head).noted(
        "The recursive grid is read off between those built, on logarithmic scales, never beyond \
         them. At this cost: the least memory with which it costs no more. Times as fast, as cheap: \
         of the recursive grid in this memory. Share: below 1 the structure is smaller.",
    );
    for entry in others(contest) {
        for (set, name) in SETS.iter().enumerate() {
            let Some(judged) = Judged::new(contest, entry, set, ordinate) else { continue };
            sheet.row([
                entry.name.clone().into(),
                (*name).into(),
                judged.megabytes.into(),
                judged.cost.into(),
                judged.equal_memory.at().into(),
                judged.faster().into(),
                judged.equal_cost.at().into(),
                judged.smaller().into(),
                judged.smaller_with_triangles().into(),
                [judged.beyond_memory(), judged.beyond_cost()]
                    .into_iter()
                    .flatten()
                    .collect::<Vec<_>>()
                    .join("; ")
                    .into(),
            ]);
        }
    }
    sheet
}
