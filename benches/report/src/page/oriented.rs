//! Section 7.2 on the page: figure 25.

use super::charts::percentages;
use super::shown;
use crate::oriented::boxes::{START, WIDTH, histogram};
use crate::oriented::{Clustered, Measure, Oriented, Turned};
use crate::plots::distribution::Distribution;
use crate::run::PLOTS;
use crate::sheet::Sheet;
use crate::tables::oriented as tables;
use maud::{Markup, PreEscaped, html};

/// Nothing if no boxes were compared.
pub fn section(
    scenes: &[Oriented],
    sheets: &mut Vec<Sheet>,
    plots: &mut Vec<(String, String)>,
) -> Result<Markup, String> {
    if scenes.is_empty() {
        return Ok(html! {});
    }
    let mut parts = Vec::new();
    for each in scenes {
        parts.push(scene(each, sheets, plots)?);
    }
    Ok(html! {
        section #oriented {
            h2 { "Clusters' orientation (section 7.2)" }
            p { "Boxes of clusters along the principal components of all vertices, along those of \
                 the convex hull's surface, and as a search for little surface leaves them, over \
                 the aligned boxes of the same clusters." }
            @for part in &parts { (part) }
        }
    })
}

fn scene(
    scene: &Oriented,
    sheets: &mut Vec<Sheet>,
    plots: &mut Vec<(String, String)>,
) -> Result<Markup, String> {
    let [boxes, rays, histograms] = tables::sheets(scene);
    let tables = shown(vec![boxes, rays], sheets);
    // Long, and drawn: a file alone.
    sheets.push(histograms);
    let mut rows = Vec::new();
    for clustered in &scene.clusterings {
        let mut charts = Vec::new();
        // A line of the page each.
        for (measure, of) in tables::MEASURES {
            for turned in &clustered.turned {
                charts.push(chart(scene, clustered, turned, measure, of, plots)?);
            }
        }
        rows.push(html! {
            h4 { (scene.short) "." (clustered.notation) ", " (clustered.clusters) " clusters" }
            div.pictures { @for chart in &charts { (chart) } }
        });
    }
    Ok(html! {
        h3 { (scene.name) }
        @for row in &rows { (row) }
        @for table in &tables { (table) }
    })
}

fn chart(
    scene: &Oriented,
    clustered: &Clustered,
    turned: &Turned,
    measure: &str,
    of: Measure,
    plots: &mut Vec<(String, String)>,
) -> Result<Markup, String> {
    let ratios = turned.all(of);
    let (percent, cumulated) = percentages(&histogram(&ratios), ratios.len() as u64);
    let title = format!("{}, {}: {measure}", scene.short, turned.along);
    let x = format!("{measure} of the turned box over the aligned one");
    let (percent, cumulated) = (&percent[..], &cumulated[..]);
    let svg = Distribution { title: &title, x: &x, percent, cumulated, start: START, width: WIDTH }
        .svg()?;
    let what = format!("figure_25.{}.{}.{measure}", clustered.notation, turned.along);
    let name = tables::file(scene, &what);
    let link = format!("{PLOTS}/{name}.svg");
    let markup = html! {
        figure.plot { (PreEscaped(&svg)) figcaption { a href=(link) { "SVG" } } }
    };
    plots.push((name, svg));
    Ok(markup)
}
