//! The tables.

use super::choice::{Rule, means};
use super::measure::{Figures, Measured, SETS};
use super::setting::Setting;
use hug_bench::ray_sets::Set;
use hug_bench::table::Table;

/// What reading a table takes.
const UNITS: &str = "Settings: alpha of the outermost grid, of the grids below, references up to which a voxel is not split. Speeds are ratios, above 1 is quicker";

/// How much quicker `a` is than `b`, from logarithms of times.
fn speed(a: f64, b: f64) -> String {
    format!("{:.2}", (b - a).exp())
}

/// Over the sets of rays.
fn mean(figures: &[f64; SETS]) -> f64 {
    figures.iter().sum::<f64>() / SETS as f64
}

/// Every setting beside AUTO's own or, if that is not among them, the first.
pub fn settings(settings: &[Setting], scenes: &[Measured]) {
    let own = settings.iter().position(|&s| s == Setting::AUTO).unwrap_or(0);
    println!("{UNITS} than {}. Geometric means of {} scenes.\n", settings[own], scenes.len());
    let means = means(&scenes.iter().collect::<Vec<_>>());
    let mut head = vec!["setting", "B/tri", "build"];
    head.extend(Set::ALL.map(Set::name));
    let mut table = Table::new(head.into_iter().chain(["streams", "all queries"]));
    for (setting, figures) in settings.iter().zip(&means) {
        let than = &means[own];
        let mut row = vec![setting.to_string(), format!("{:.1}", figures.bytes.exp())];
        row.push(speed(figures.build, than.build));
        row.extend(figures.single.iter().zip(&than.single).map(|(&a, &b)| speed(a, b)));
        row.push(speed(mean(&figures.stream), mean(&than.stream)));
        row.push(speed(figures.queries(), than.queries()));
        table.row(row);
    }
    table.print();
}

/// The choice with all scenes, and with each of them left out, on the one left out.
pub fn left_out(rule: Rule, settings: &[Setting], scenes: &[Measured]) {
    let all = rule.choose(&scenes.iter().collect::<Vec<_>>());
    println!(
        "{}: with all scenes {}. With a scene left out, and on that scene beside the choice with all:\n",
        rule.name(),
        settings[all]
    );
    let mut table = Table::new(["left out", "choice", "build", "single rays", "streams"]);
    for scene in scenes {
        let others: Vec<&Measured> =
            scenes.iter().filter(|other| !std::ptr::eq(*other, scene)).collect();
        let choice = rule.choose(&others);
        let (here, there) = (&scene.figures[choice], &scene.figures[all]);
        let mut row = vec![scene.name.clone(), settings[choice].to_string()];
        let of: [fn(&Figures) -> f64; 3] = [|f| f.build, |f| mean(&f.single), |f| mean(&f.stream)];
        row.extend(of.map(|of| speed(of(here), of(there))));
        table.row(row);
    }
    table.print();
}
