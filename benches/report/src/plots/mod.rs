//! Plots as vector graphics.

pub mod curve;
pub mod distribution;

use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, IntoDrawingArea, SVGBackend, WHITE};
use plotters::style::RGBColor;

pub const INK: RGBColor = RGBColor(40, 40, 40);
pub const GRID: RGBColor = RGBColor(225, 225, 225);
pub const BARS: RGBColor = RGBColor(86, 140, 190);
pub const SUM: RGBColor = RGBColor(192, 57, 43);

/// Why plotters cannot draw: it has no error of its own to show a reader.
pub fn failed(error: impl std::fmt::Display) -> String {
    format!("a plot: {error}")
}

/// An empty sheet, of a plot's size in pixels.
pub type Sheet<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A plot as the page embeds it.
pub fn svg(
    size: (u32, u32),
    draw: impl FnOnce(&Sheet<'_>) -> Result<(), String>,
) -> Result<String, String> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
        root.fill(&WHITE).map_err(failed)?;
        draw(&root)?;
        root.present().map_err(failed)?;
    }
    Ok(inline(&text))
}

/// What the page embeds: the drawing without the declaration of a file of its own.
fn inline(svg: &str) -> String {
    svg.find("<svg").map_or(svg, |at| &svg[at..]).to_owned()
}

/// A round number of at least `x`, which is positive: 1, 2 or 5 times a power of ten.
pub fn round_up(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * power);
    steps.into_iter().find(|&step| step >= x * 0.999_999).unwrap_or(x)
}
