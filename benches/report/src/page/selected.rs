//! Section 7.5 on the page: all scenes together, and then each.

use super::shown;
use crate::plots::curve::{CurveChart, Line};
use crate::run::PLOTS;
use crate::selected::{Comparison, Contest, Ordinate, SETS};
use crate::sheet::{Sheet, count};
use crate::tables::{selected as tables, summary};
use maud::{Markup, PreEscaped, html};

/// Nothing if nothing was compared.
pub fn section(
    comparisons: &[Comparison],
    sheets: &mut Vec<Sheet>,
    plots: &mut Vec<(String, String)>,
) -> Result<Markup, String> {
    if comparisons.is_empty() {
        return Ok(html! {});
    }
    let summary = shown(vec![summary::sheet(comparisons)], sheets);
    let mut scenes = Vec::new();
    for comparison in comparisons {
        scenes.push(scene(comparison, sheets, plots)?);
    }
    Ok(html! {
        section #selected {
            h2 { "Selected results (section 7.5)" }
            p { "Time and memory of HUGs over the subdivision alpha of their world cluster, of \
                 recursive grids over MAXP, and of single structures. Structures with exit boxes \
                 are compared with each other, and those with steps of one voxel with each other. \
                 Voxels and tests are counts, which no clock disturbs; but a test is not a voxel, \
                 and tests come eight at a time." }
            @for table in &summary { (table) }
            @for scene in &scenes { (scene) }
        }
    })
}

fn scene(
    comparison: &Comparison,
    sheets: &mut Vec<Sheet>,
    plots: &mut Vec<(String, String)>,
) -> Result<Markup, String> {
    let mut parts = Vec::new();
    for contest in &comparison.contests {
        let mut charts = Vec::new();
        for ordinate in Ordinate::ALL {
            for set in 0..SETS.len() {
                charts.push(chart(comparison, contest, set, ordinate, plots)?);
            }
        }
        let tables = shown(tables::sheets(comparison, contest), sheets);
        parts.push(html! {
            h4 { (comparison.short) ", " (contest.walk.text()) }
            div.pictures { @for chart in &charts { (chart) } }
            details {
                summary { "Tables" }
                @for table in &tables { (table) }
            }
        });
    }
    Ok(html! {
        h3 { (comparison.name) }
        p.note { (count(comparison.triangles)) " triangles; views: " (comparison.views.join(", ")) }
        @for part in &parts { (part) }
    })
}

fn chart(
    comparison: &Comparison,
    contest: &Contest,
    set: usize,
    ordinate: Ordinate,
    plots: &mut Vec<(String, String)>,
) -> Result<Markup, String> {
    let line = |name: &str| {
        let points = contest.curve(name);
        let points = points.map(|e| (e.megabytes(), ordinate.of(e, set), e.value.clone()));
        Line { name: name.to_owned(), points: points.collect() }
    };
    let lines: Vec<Line> = contest.curves().into_iter().map(line).collect();
    let (rays, walk) = (SETS[set], contest.walk.text());
    let title = format!("{}, {rays} rays, {walk}", comparison.short);
    let svg = CurveChart { title: &title, cost: ordinate.text(), lines: &lines }.svg()?;
    let name = tables::file(comparison, contest, &format!("{rays}.{}", ordinate.file()));
    let link = format!("{PLOTS}/{name}.svg");
    let markup = html! {
        figure.plot { (PreEscaped(&svg)) figcaption { a href=(link) { "SVG" } } }
    };
    plots.push((name, svg));
    Ok(markup)
}
