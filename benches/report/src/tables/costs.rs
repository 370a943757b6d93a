//! The top of figure 10: what a call costs, and what comes of adding costs up.

use super::{OURS, PAPER, numbers};
use crate::measure::{Built, Frame, Subject};
use crate::sheet::{Cell, Sheet};
use hug_bench::costs::{Costs, Function, SINES, Tests};
use hug_bench::figures::Spread;
use hug_bench::notation::Configuration;
use hug_bench::paper::rendering::{Costs as PaperCosts, FIGURE_10_TOP};

/// The functions of the paper's figure 10, in its order.
pub const PAPERS: [Function; 3] = [Function::Test, Function::Grid, Function::Voxel];

/// All tables of a scene.
pub fn sheets(subject: &Subject) -> Vec<Sheet> {
    let views = || subject.frames.iter().zip(&subject.costs).enumerate();
    let mut sheets: Vec<Sheet> =
        views().map(|(i, (frame, costs))| top(subject, i, frame, costs)).collect();
    sheets.extend(views().map(|(_, (frame, costs))| sums(subject, frame, costs)));
    sheets.extend(views().map(|(_, (frame, costs))| matrix(subject, frame, costs)));
    sheets.push(readings(subject));
    sheets
}

fn file(subject: &Subject, frame: &Frame, what: &str) -> String {
    format!("{}.{}.{what}", subject.short, frame.view).replace([':', '/', '\\'], "_")
}

/// What the paper prints of a structure from a view of the scene.
fn printed(subject: &Subject, built: &Built, frame: &Frame) -> Option<&'static PaperCosts> {
    FIGURE_10_TOP.iter().find(|costs| {
        let known: Result<Configuration, String> = costs.name.parse();
        known.is_ok_and(|known| {
            let same = known.scene == subject.loaded.name && known.structure == built.notation;
            same && known.view() == Some(&frame.view)
        })
    })
}

fn spread(each: Spread) -> [Cell; 2] {
    [each.median.into(), format!("{:.1} - {:.1}", each.least, each.most).into()]
}

/// Largest over smallest; 1 of a function that nobody calls.
pub fn factor<'a>(costs: impl IntoIterator<Item = &'a Costs>, function: Function) -> f64 {
    let called = costs.into_iter().filter(|c| c.calls(function) > 0);
    let all: Vec<f64> = called.map(|c| c.each(function).median).collect();
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    all.iter().copied().fold(least, f64::max) / least.min(f64::MAX)
}

fn top(subject: &Subject, number: usize, frame: &Frame, costs: &[Costs]) -> Sheet {
    let view = &frame.view;
    let title = format!("Figure 10, top: {}, view {view}, nanoseconds a call", subject.short);
    let head = [
        "DS",
        "",
        "t_pi",
        "least - most",
        "t_rg + t_bi",
        "least - most",
        "t_nc",
        "least - most",
        "%s1",
        "%s2",
        "%s2 of all tests",
        "a ray's start and end",
        "least - most",
    ];
    let mut sheet = Sheet::new(file(subject, frame, "figure_10_top"), title, &head).noted(
        "Each function is replayed over the calls that the traversal makes: medians of rounds in \
         which all functions of all structures take turns. t_pi is that of a list, divided by its \
         triangles. %s1, %s2: successes of test_1 (the ray is not parallel to the plane) and of \
         test_2 (where it meets the plane is in the triangle's two-dimensional box), the latter of \
         the tests that come to it. Last line: the largest over the smallest.",
    );
    for (built, costs) in subject.built.iter().zip(costs) {
        let cells = [Cell::from(built.name.clone()), OURS.into()].into_iter();
        let cells = cells.chain(PAPERS.iter().flat_map(|&f| spread(costs.each(f))));
        let total = built.calls(number);
        let of_all = 100.0 * total.passed_2 as f64 / total.tests.max(1) as f64;
        let successes = [total.percent_passed_1(), total.percent_passed_2(), of_all];
        sheet.row(cells.chain(numbers(successes)).chain(spread(costs.each(Function::Ray))));
        if let Some(p) = printed(subject, built, frame) {
            let cells = [Cell::from(p.name), PAPER.into()].into_iter();
            let times = [p.t_pi, p.t_rg_bi, p.t_nc];
            let times = times.into_iter().flat_map(|t| [Cell::Number(1e9 * t), Cell::None]);
            sheet.row(cells.chain(times).chain(numbers(p.successes)));
        }
    }
    let factors = PAPERS.iter().flat_map(|&f| [Cell::Number(factor(costs, f)), Cell::None]);
    sheet.row([Cell::from("largest / smallest"), OURS.into()].into_iter().chain(factors));
    sheet
}

/// The model sum(calls x cost) against the clock.
fn sums(subject: &Subject, frame: &Frame, costs: &[Costs]) -> Sheet {
    let title = format!(
        "{}, view {}: sum(calls x cost) against measured time, nanoseconds a ray",
        subject.short, frame.view
    );
    let head = [
        "DS",
        "tests a ray",
        "grids a ray",
        "voxels a ray",
        "t_pi x tests",
        "(t_rg + t_bi) x grids",
        "t_nc x voxels",
        "sum",
        "start and end",
        "with these",
        "measured",
        "least - most",
        "predicted / measured",
    ];
    let mut sheet = Sheet::new(file(subject, frame, "call_sums"), title, &head).noted(
        "Calls are those that the normal queries make on the rays of the record; counted queries \
         test every triangle of a list (#pit), these look at the boxes of long lists first.",
    );
    for (built, costs) in subject.built.iter().zip(costs) {
        let rays = costs.rays as f64;
        let calls = PAPERS.map(|f| costs.calls(f) as f64 / rays);
        let parts = PAPERS.map(|f| costs.predicted(costs, &[f]));
        let (three, four) =
            (costs.predicted(costs, &PAPERS), costs.predicted(costs, &Function::ALL));
        let cells = [Cell::from(built.name.clone())].into_iter().chain(numbers(calls));
        let sums = [three, four - three, four].map(Cell::Number);
        let end = spread(costs.measured);
        let ratio = four / costs.measured.median;
        sheet.row(cells.chain(numbers(parts)).chain(sums).chain(end).chain([ratio.into()]));
    }
    sheet
}

/// What the model says of one configuration with the costs of another.
fn matrix(subject: &Subject, frame: &Frame, costs: &[Costs]) -> Sheet {
    let title = format!(
        "{}, view {}: predicted over measured time, a configuration's calls at another's costs",
        subject.short, frame.view
    );
    let names = subject.built.iter().map(|b| format!("costs of {}", b.notation));
    let head: Vec<String> = std::iter::once("calls of".to_owned()).chain(names).collect();
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let mut sheet = Sheet::new(file(subject, frame, "cost_matrix"), title, &head).noted(
        "On the diagonal each is predicted from its own costs; elsewhere a model that takes costs \
         for constants would be off by so much. Start and end of a ray included.",
    );
    for (built, own) in subject.built.iter().zip(costs) {
        let ratio = |other: &Costs| own.predicted(other, &Function::ALL) / own.measured.median;
        let name = Cell::from(built.name.clone());
        sheet.row([name].into_iter().chain(numbers(costs.iter().map(ratio))));
    }
    sheet
}

/// What test_1 lets through, read in several ways.
fn readings(subject: &Subject) -> Sheet {
    let file = format!("{}.test_1", subject.short).replace([':', '/', '\\'], "_");
    let title = format!("{}: %s1 by several readings of test_1", subject.short);
    let sines = SINES.map(|sine| format!("sine >= {sine}"));
    let mut head = vec!["DS", "view", "paper", "not parallel"];
    head.extend(sines.iter().map(String::as_str));
    head.extend(["in range", "before the closest hit", "facing"]);
    let mut sheet = Sheet::new(file, title, &head).noted(
        "Of the tests of the record. Not parallel: to the last bit, as the definition has it and \
         %s1 counts; hardly a ray fails. Sine: of the angle between ray and plane. In range: the \
         plane is met at a parameter of the ray, so neither behind its origin nor behind the light; \
         before the closest hit: nor beyond what the ray is known to hit. Facing: from the side of \
         the normal. Figures of the size of the paper's come out if points that cannot be the \
         answer fail too, or at a sine of 0.1, which no routine would call coplanar.",
    );
    for (frame, costs) in subject.frames.iter().zip(&subject.costs) {
        for (built, costs) in subject.built.iter().zip(costs) {
            let Tests { all, not_parallel, steep, in_range, in_reach, facing } = costs.tests;
            let percent = |n: u64| 100.0 * n as f64 / all.max(1) as f64;
            let head = [Cell::from(built.name.clone()), frame.view.clone().into()];
            let paper = printed(subject, built, frame).map(|p| p.successes[0]);
            let [a, b, c] = steep;
            let ours = [not_parallel, a, b, c, in_range, in_reach, facing].map(percent);
            sheet.row(head.into_iter().chain([Cell::from(paper)]).chain(numbers(ours)));
        }
    }
    sheet
}
