//! Pictures in few colours, as PNG inside the page.

pub mod heat;
pub mod slice;

use base64::Engine;
use maud::{Markup, html};
use plotters::style::RGBColor;
use plotters::style::colors::colormaps::{ColorMap, ViridisRGB};
use std::fs;
use std::path::Path;

/// Colours 0 to `RAMP` - 1 of every palette go from dark to light.
pub const RAMP: usize = 200;
/// Colours after the ramp.
pub const WHITE: u8 = 200;
pub const LINE: u8 = 201;
/// Outlines of grids, from the deepest level up; further levels use the last.
pub const LEVELS: [RGBColor; 6] = [
    RGBColor(214, 39, 40),
    RGBColor(255, 127, 14),
    RGBColor(227, 119, 194),
    RGBColor(23, 120, 207),
    RGBColor(90, 60, 150),
    RGBColor(60, 60, 60),
];

/// The colour of a level's outline.
pub fn level_colour(level: usize) -> u8 {
    LINE + 1 + level.min(LEVELS.len() - 1) as u8
}

/// A place on the ramp, 0 to 1.
pub fn ramp(share: f64) -> u8 {
    let last = (RAMP - 1) as f64;
    (share.clamp(0.0, 1.0) * last).round() as u8
}

fn colour(share: f64) -> RGBColor {
    ViridisRGB.get_color(share)
}

fn palette() -> Vec<u8> {
    let ramp = (0..RAMP).map(|i| colour(i as f64 / (RAMP - 1) as f64));
    let others = [RGBColor(255, 255, 255), RGBColor(190, 190, 190)];
    ramp.chain(others).chain(LEVELS).flat_map(|c| [c.0, c.1, c.2]).collect()
}

/// A PNG of `width` columns, by row: numbers of colours, or greys.
fn encode(width: u32, pixels: &[u8], colours: bool) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, pixels.len() as u32 / width);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_color(png::ColorType::Grayscale);
    if colours {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette());
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}

/// The pictures of a page, to be written beside it too.
#[derive(Default)]
pub struct Gallery(Vec<(String, Vec<u8>)>);

impl Gallery {
    /// An image element that holds its own bytes; `file` is the picture's name without ending.
    pub fn image(
        &mut self,
        file: &str,
        width: u32,
        pixels: &[u8],
        colours: bool,
        what: &str,
    ) -> Result<Markup, String> {
        let bytes = encode(width, pixels, colours).map_err(|error| format!("{what}: {error}"))?;
        let data = base64::engine::general_purpose::STANDARD.encode(&bytes);
        self.0.push((format!("{}.png", file.replace([':', '/', '\\'], "_")), bytes));
        Ok(html! { img src={ "data:image/png;base64," (data) } alt=(what); })
    }

    pub fn write(&self, folder: &Path) -> Result<(), String> {
        for (name, bytes) in &self.0 {
            let path = folder.join(name);
            fs::write(&path, bytes).map_err(|error| format!("{}: {error}", path.display()))?;
        }
        Ok(())
    }
}

/// A bar of the ramp's colours between two labels.
pub fn legend(low: &str, high: &str, what: &str) -> Markup {
    let stop = |i: usize| {
        let RGBColor(r, g, b) = colour(i as f64 / 10.0);
        format!("rgb({r},{g},{b})")
    };
    let stops: Vec<String> = (0..=10).map(stop).collect();
    html! {
        div.legend {
            (low)
            span.ramp style={ "background:linear-gradient(to right," (stops.join(",")) ")" } {}
            (high) " " (what)
        }
    }
}
