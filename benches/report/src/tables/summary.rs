//! Section 7.5 over all scenes: each curve at its best.

use crate::selected::curves::RECURSIVE;
use crate::selected::equal::Reading;
use crate::selected::{Comparison, Contest, Entry, Judged, Ordinate, SETS};
use crate::sheet::{Cell, Sheet};

/// Each curve's best, and how much of it was within range.
pub fn sheet(comparisons: &[Comparison]) -> Sheet {
    let head = [
        "scene",
        "walk",
        "curve",
        "rays",
        "by",
        "at equal memory",
        "fastest or cheapest",
        "times as fast or cheap",
        "at equal cost",
        "smallest",
        "share of memory",
        "with triangles",
    ];
    let title = "Section 7.5: each curve beside the recursive grid, at its best";
    let mut sheet = Sheet::new("selected_summary", title, &head).noted(
        "At equal memory, at equal cost: how many structures of the curve have a recursive grid \
         of their memory, or of their cost, to be compared with, and where the others are. The \
         best of those compared follows: the most times as fast (or, by work, as cheap), the \
         smallest share of memory.",
    );
    for comparison in comparisons {
        for contest in &comparison.contests {
            for curve in contest.curves().into_iter().filter(|&curve| curve != RECURSIVE) {
                for (set, rays) in SETS.iter().enumerate() {
                    for ordinate in Ordinate::ALL {
                        let head = [&comparison.short, contest.walk.text(), curve, rays];
                        let head = head.map(Cell::from).into_iter();
                        let head = head.chain([Cell::from(ordinate.file())]);
                        sheet.row(head.chain(best(contest, curve, set, ordinate)));
                    }
                }
            }
        }
    }
    sheet
}

fn best(contest: &Contest, curve: &str, set: usize, ordinate: Ordinate) -> Vec<Cell> {
    let all: Vec<(&Entry, Judged)> = contest
        .curve(curve)
        .filter_map(|entry| Some((entry, Judged::new(contest, entry, set, ordinate)?)))
        .collect();
    let of = |given: fn(&Judged) -> Reading, [below, above]: [&str; 2]| {
        let readings = || all.iter().map(|(_, judged)| given(judged));
        let compared = readings().filter(|r| r.at().is_some()).count();
        let under = readings().filter(|r| matches!(r, Reading::Below(_))).count();
        let over = all.len() - compared - under;
        let outside = [(under, below), (over, above)].into_iter().filter(|o| o.0 > 0);
        let outside = outside.map(|(n, what)| format!("; {n} {what}")).collect::<String>();
        Cell::from(format!("{compared}{outside}"))
    };
    let name = |entry: &Entry| Cell::from(entry.notation.to_string());
    let faster = all.iter().filter_map(|(e, j)| Some((e, j.faster()?)));
    let smaller = all.iter().filter_map(|(e, j)| Some((e, j.smaller()?, j)));
    let fastest = faster.max_by(|a, b| a.1.total_cmp(&b.1));
    let smallest = smaller.min_by(|a, b| a.1.total_cmp(&b.1));
    vec![
        of(|j| j.equal_memory, ["smaller than any", "larger than any"]),
        fastest.map(|f| name(f.0)).into(),
        fastest.map(|f| f.1).into(),
        of(|j| j.equal_cost, ["cheaper than any", "dearer than the smallest"]),
        smallest.map(|s| name(s.0)).into(),
        smallest.map(|s| s.1).into(),
        smallest.and_then(|s| s.2.smaller_with_triangles()).into(),
    ]
}
