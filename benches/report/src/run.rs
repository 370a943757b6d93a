//! The whole of it: measure, judge, write.

use crate::args::{Args, Part};
use crate::measure::Subject;
use crate::oriented::Oriented;
use crate::page::Report;
use crate::progress::Progress;
use crate::selected::{Comparison, curves};
use std::fs;
use std::path::PathBuf;

/// The folders of the CSV files and of the pictures, beside the page.
pub const TABLES: &str = "tables";
const PICTURES: &str = "pictures";
/// The folder of the plots of section 7.
pub const PLOTS: &str = "plots";

/// Measures and writes; the path of the page.
pub fn run(args: &Args, command: &str) -> Result<PathBuf, String> {
    args.check()?;
    let curves = curves::all(&args.curve)?;
    let failed = |error: std::io::Error| format!("{}: {error}", args.out.display());
    // Before anything that takes time.
    fs::create_dir_all(&args.out).map_err(failed)?;
    let bar = Progress::new(args.quiet);
    let (mut subjects, mut oriented, mut comparisons) = (Vec::new(), Vec::new(), Vec::new());
    for job in args.jobs() {
        bar.at(&job.scene);
        if args.wants(Part::Instruments) {
            subjects.push(Subject::measure(&job, args.size, args.rounds, &bar)?);
        }
        if args.wants(Part::Boxes) {
            oriented.push(Oriented::measure(&job.scene, args.size, &bar)?);
        }
        if args.wants(Part::Selected) {
            let scene = &job.scene;
            comparisons.push(Comparison::measure(scene, &curves, args.size, args.rounds, &bar)?);
        }
    }
    bar.finish();
    let report = Report::new(&subjects, &oriented, &comparisons, command)?;
    let tables = args.out.join(TABLES);
    fs::create_dir_all(&tables).map_err(failed)?;
    for sheet in &report.sheets {
        sheet.write(&tables)?;
    }
    if !subjects.is_empty() {
        let pictures = args.out.join(PICTURES);
        fs::create_dir_all(&pictures).map_err(failed)?;
        report.gallery.write(&pictures)?;
    }
    if !report.plots.is_empty() {
        let plots = args.out.join(PLOTS);
        fs::create_dir_all(&plots).map_err(failed)?;
        for (name, svg) in &report.plots {
            fs::write(plots.join(format!("{name}.svg")), svg).map_err(failed)?;
        }
    }
    let page = args.out.join("report.html");
    fs::write(&page, report.page).map_err(failed)?;
    Ok(page)
}
