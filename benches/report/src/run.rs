//! The whole of it: measure, judge, write.

use crate::args::Args;
use crate::measure::Subject;
use crate::page::Report;
use crate::progress::Progress;
use std::fs;
use std::path::PathBuf;

/// The folders of the CSV files and of the pictures, beside the page.
pub const TABLES: &str = "tables";
const PICTURES: &str = "pictures";

/// Measures and writes; the path of the page.
pub fn run(args: &Args, command: &str) -> Result<PathBuf, String> {
    let failed = |error: std::io::Error| format!("{}: {error}", args.out.display());
    // Before anything that takes time.
    fs::create_dir_all(&args.out).map_err(failed)?;
    let bar = Progress::new(args.quiet);
    let mut subjects = Vec::new();
    for job in args.jobs() {
        bar.at(&job.scene);
        subjects.push(Subject::measure(&job, args.size, args.rounds, &bar)?);
    }
    bar.finish();
    let report = Report::new(&subjects, command)?;
    let tables = args.out.join(TABLES);
    fs::create_dir_all(&tables).map_err(failed)?;
    for sheet in &report.sheets {
        sheet.write(&tables)?;
    }
    let pictures = args.out.join(PICTURES);
    fs::create_dir_all(&pictures).map_err(failed)?;
    report.gallery.write(&pictures)?;
    let page = args.out.join("report.html");
    fs::write(&page, report.page).map_err(failed)?;
    Ok(page)
}
