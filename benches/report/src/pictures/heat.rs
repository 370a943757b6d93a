//! Heat maps: what each pixel's primary ray cost, on one scale for all structures.

use super::{Gallery, legend, ramp};
use crate::measure::Subject;
use maud::{Markup, html};

/// The value that nearly all pixels are below, at least 1: the end of the scale.
fn end(maps: &[&[u64]]) -> u64 {
    let mut all: Vec<u64> = maps.iter().flat_map(|map| map.iter().copied()).collect();
    all.sort_unstable();
    all.get(all.len().saturating_sub(1) * 99 / 100).copied().unwrap_or(1).max(1)
}

/// One map a structure, of frame number `frame`.
fn maps(
    subject: &Subject,
    frame: usize,
    voxels: bool,
    gallery: &mut Gallery,
) -> Result<Markup, String> {
    let of = |i: usize| {
        let rendered = &subject.built[i].rendered[frame];
        &(if voxels { &rendered.voxels } else { &rendered.tests })[..]
    };
    let all: Vec<&[u64]> = (0..subject.built.len()).map(of).collect();
    let (end, size) = (end(&all), subject.frames[frame].size);
    let what = if voxels { "voxels traversed" } else { "ray-triangle tests" };
    let scale = |n: u64| ramp((n as f64 / end as f64).sqrt());
    let mut images = Vec::new();
    for (built, map) in subject.built.iter().zip(all) {
        let pixels: Vec<u8> = map.iter().map(|&n| scale(n)).collect();
        let mean = map.iter().sum::<u64>() as f64 / map.len().max(1) as f64;
        let caption = format!("{}, mean {mean:.1}", built.name);
        let alt = format!("{what} per pixel, {}", built.name);
        let short = if voxels { "voxels" } else { "tests" };
        let file = format!("{}.{}.{short}", built.name, subject.frames[frame].view);
        images.push((gallery.image(&file, size, &pixels, true, &alt)?, caption));
    }
    Ok(html! {
        h4 { "Heat maps: " (what) " a primary ray, view " (subject.frames[frame].view) }
        (legend("0", &end.to_string(), "or more; the scale is a square root"))
        div.pictures { @for (image, caption) in images {
            figure { (image) figcaption { (caption) } }
        } }
    })
}

/// The heat maps of all views.
pub fn all(subject: &Subject, gallery: &mut Gallery) -> Result<Markup, String> {
    let mut parts = Vec::new();
    for frame in 0..subject.frames.len() {
        parts.push(maps(subject, frame, false, gallery)?);
        parts.push(maps(subject, frame, true, gallery)?);
    }
    Ok(html! { @for part in parts { (part) } })
}

/// The views themselves.
pub fn views(subject: &Subject, gallery: &mut Gallery) -> Result<Markup, String> {
    let mut images = Vec::new();
    for frame in &subject.frames {
        let alt = format!("{}, view {}", subject.loaded.name, frame.view);
        let file = format!("{}.{}", subject.short, frame.view);
        images.push((gallery.image(&file, frame.size, &frame.shades, false, &alt)?, &frame.view));
    }
    Ok(html! { div.pictures { @for (image, view) in images {
        figure { (image) figcaption { "view " (view) } }
    } } })
}
