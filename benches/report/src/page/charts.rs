//! Histograms with their cumulated distributions.

use crate::measure::{Built, CLASSES, SHARE, Subject};
use crate::plots::distribution::Distribution;
use hug::cumulated;

/// The share of each class of a whole, and of all up to it, in percent.
pub fn percentages(counts: &[u64], whole: u64) -> (Vec<f64>, Vec<f64>) {
    let percent = counts.iter().map(|&n| 100.0 * n as f64 / whole.max(1) as f64).collect();
    let mut sums = vec![0.0; counts.len()];
    cumulated(counts, whole, &mut sums);
    (percent, sums)
}

/// Voxels by their triangles; where few are far fuller than the rest, also the left part alone.
pub fn occupancy(built: &Built, level: usize, counts: &[u64]) -> Result<Vec<String>, String> {
    let whole = counts.iter().sum();
    let chart = |title: &str, counts: &[u64], width: usize| {
        let grouped: Vec<u64> = counts.chunks(width).map(|some| some.iter().sum()).collect();
        let (percent, cumulated) = percentages(&grouped, whole);
        let x = match width {
            1 => "triangles a voxel refers to".to_owned(),
            _ => format!("triangles a voxel refers to, in classes of {width}"),
        };
        // A bar stands over its number.
        let (percent, cumulated) = (&percent[..], &cumulated[..]);
        Distribution { title, x: &x, percent, cumulated, start: -0.5, width: width as f64 }.svg()
    };
    let title = format!("{}, level {level}", built.name);
    let mut charts = vec![chart(&title, counts, counts.len().div_ceil(BARS))?];
    if counts.len() > 2 * ZOOM {
        charts.push(chart(&format!("{title}: the left part"), &counts[..ZOOM], 1)?);
    }
    Ok(charts)
}

/// Most bars of a chart: more could not be seen.
const BARS: usize = 120;

/// Classes of the left part.
const ZOOM: usize = 41;

/// Triangles by their lengths.
pub fn lengths(subject: &Subject) -> Result<String, String> {
    let (percent, sums) = percentages(&subject.length_counts, subject.lengths.count);
    Distribution {
        title: &format!("{}: lengths of the triangles", subject.loaded.name),
        x: "length over the largest",
        percent: &percent,
        cumulated: &sums,
        start: 0.0,
        width: SHARE / CLASSES as f64,
    }
    .svg()
}
