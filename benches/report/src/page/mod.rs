//! The page: everything in one file.

mod charts;
mod oriented;
mod selected;

use crate::claims::{self, Claim};
use crate::measure::{Built, Subject};
use crate::oriented::Oriented;
use crate::pictures::{Gallery, heat, slice};
use crate::selected::Comparison;
use crate::sheet::Sheet;
use crate::tables::{costs, lengths, occupancy, performance, rendering};
use hug_bench::machine;
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("../style.css");

/// The page, and the tables and pictures on it.
pub struct Report {
    pub page: String,
    pub sheets: Vec<Sheet>,
    pub gallery: Gallery,
    /// The plots of section 7, by name.
    pub plots: Vec<(String, String)>,
}

impl Report {
    /// Of scenes whose instruments were read, of those whose clusters were turned, and of those
    /// whose structures were compared.
    pub fn new(
        subjects: &[Subject],
        oriented: &[Oriented],
        comparisons: &[Comparison],
        command: &str,
    ) -> Result<Self, String> {
        let judged: Vec<Claim> = claims::all(subjects, oriented, comparisons);
        let mut sheets = vec![claims::sheet(&judged)];
        let claims = sheets[0].page();
        let lengths = (!subjects.is_empty()).then(|| lengths::sheet(subjects));
        let scenes = shown(lengths.into_iter().collect(), &mut sheets);
        let (mut sections, mut gallery) = (Vec::new(), Gallery::default());
        for subject in subjects {
            sections.push(section(subject, &mut sheets, &mut gallery)?);
        }
        let mut plots = Vec::new();
        let boxes = oriented::section(oriented, &mut sheets, &mut plots)?;
        let selected = selected::section(comparisons, &mut sheets, &mut plots)?;
        let title = "hug: the paper's instruments";
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    title { (title) }
                    style { (PreEscaped(STYLE)) }
                }
                body {
                    h1 { (title) }
                    p { "The tables, plots and claims of F. Cazals and C. Puech, "
                        em { "Bucket-like Space Partitioning Data Structures with Applications to Ray-Tracing" }
                        " (1997), repeated. " (machine::line()) ". " code { (command) } }
                    (reading())
                    nav { a href="#claims" { "claims" } @for s in subjects {
                        " " a href={ "#" (s.short) } { (s.loaded.name) }
                    } @if !oriented.is_empty() { " " a href="#oriented" { "clusters' orientation" } }
                    @if !comparisons.is_empty() { " " a href="#selected" { "selected results" } } }
                    @for table in &scenes { section { h2 { "Scenes" } (table) } }
                    section #claims { h2 { "Claims" } (claims) }
                    @for section in &sections { (section) }
                    (boxes)
                    (selected)
                }
            }
        };
        Ok(Self { page: page.into_string(), sheets, gallery, plots })
    }
}

/// What the names and the readings are.
fn reading() -> Markup {
    html! {
        details {
            summary { "How to read it" }
            ul {
                li { "Configurations are named as in the paper: " code { "kit.g28" } " is the kitchen in a uniform grid of 28 x 28 x 28 voxels, "
                    code { "kit.r50" } " in a recursive grid with MAXP = 50, " code { "kit.u.f3.sqrt2" }
                    " in a HUG of three levels with the sqrt(2) criterion. They have the same count along every axis, steps of one voxel and the paper's hierarchy with clusters of any size. "
                    code { "auto" } " is not the paper's: it is what the library builds unless it is told otherwise, with proportional counts and exit boxes." }
                li { "Levels are numbered as in the paper: 0 is the deepest." }
                li { "The tables take the reading in which figures 14 and 17 are printed: %obj is of the sum of all levels' objects, mu_og is %obj / %grids, mu_ov counts references. The other readings have a table of their own." }
                li { "A picture is one primary ray a pixel, and one shadow ray a pixel on average." }
                li { "Charts have two scales: bars are read on the left, the cumulated line on the right." }
            }
        }
    }
}

fn section(
    subject: &Subject,
    sheets: &mut Vec<Sheet>,
    gallery: &mut Gallery,
) -> Result<Markup, String> {
    let mut performance = performance::bottom(subject);
    performance.extend(costs::sheets(subject));
    let performance = shown(performance, sheets);
    let mut structures = Vec::new();
    for built in &subject.built {
        let mut tables = occupancy::sheets(built);
        tables.extend((0..subject.frames.len()).map(|f| rendering::sheet(subject, built, f)));
        let tables = shown(tables, sheets);
        structures.push(structure(built, &tables)?);
        // Long, and drawn: a file alone.
        sheets.push(occupancy::histogram(built));
    }
    sheets.push(lengths::histogram(subject));
    Ok(html! {
        section id=(subject.short) {
            h2 { (subject.loaded.name) }
            div.pictures { figure.plot { (PreEscaped(charts::lengths(subject)?)) } }
            (heat::views(subject, gallery)?)
            h3 { "Performance" }
            @for table in &performance { (table) }
            h3 { "Structures" }
            @for part in &structures { (part) }
            h3 { "Pictures" }
            (slice::all(subject, gallery)?)
            (heat::all(subject, gallery)?)
        }
    })
}

/// Tables for the page; they also become files.
fn shown(tables: Vec<Sheet>, sheets: &mut Vec<Sheet>) -> Vec<Markup> {
    let pages = tables.iter().map(Sheet::page).collect();
    sheets.extend(tables);
    pages
}

fn structure(built: &Built, tables: &[Markup]) -> Result<Markup, String> {
    let mut charts = Vec::new();
    for (level, counts) in built.histograms.iter().enumerate() {
        if counts.iter().any(|&n| n > 0) {
            charts.extend(charts::occupancy(built, level, counts)?);
        }
    }
    Ok(html! {
        details {
            summary { (built.name) }
            @for table in tables { (table) }
            div.pictures { @for chart in &charts { figure.plot { (PreEscaped(chart)) } } }
        }
    })
}
