//! Time over memory: what a structure costs, at every setting of its parameter.

use super::{BARS, GRID, INK, SUM, failed, inline};
use plotters::prelude::*;

/// A point: memory, time, name.
pub type Point = (f64, f64, String);

const SIZE: (u32, u32) = (640, 400);
const FONT: (&str, u32) = ("sans-serif", 12);

/// The settings of one structure joined by a line, and others as dots.
pub fn svg(title: &str, line: &[Point], dots: &[Point]) -> Result<String, String> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        root.fill(&WHITE).map_err(failed)?;
        draw(&root, title, line, dots)?;
        root.present().map_err(failed)?;
    }
    Ok(inline(&text))
}

/// A range a little wider than the values.
fn range(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
    low / 1.3..high * 1.6
}

fn draw(
    root: &DrawingArea<SVGBackend<'_>, plotters::coord::Shift>,
    title: &str,
    line: &[Point],
    dots: &[Point],
) -> Result<(), String> {
    let all = || line.iter().chain(dots);
    let (x, y) = (range(all().map(|p| p.0)), range(all().map(|p| p.1)));
    let mut chart = ChartBuilder::on(root)
        .caption(title, ("sans-serif", 14).into_font().color(&INK))
        .margin(8)
        .x_label_area_size(40)
        .y_label_area_size(60)
        .build_cartesian_2d(x.log_scale(), y.log_scale())
        .map_err(failed)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .axis_style(INK)
        .label_style(FONT)
        .x_desc("memory, MB (logarithmic)")
        .y_desc("time of the picture, ms (logarithmic)")
        .x_label_formatter(&|x| super::super::sheet::number(*x))
        .y_label_formatter(&|y| super::super::sheet::number(*y))
        .draw()
        .map_err(failed)?;
    let joined = line.iter().map(|p| (p.0, p.1));
    chart.draw_series(LineSeries::new(joined, BARS.stroke_width(2))).map_err(failed)?;
    for (points, colour) in [(line, BARS), (dots, SUM)] {
        let marks = points.iter().map(|(x, y, name)| {
            EmptyElement::at((*x, *y))
                + Circle::new((0, 0), 4, colour.filled())
                + Text::new(name.clone(), (7, -6), FONT.into_font().color(&colour))
        });
        chart.draw_series(marks).map_err(failed)?;
    }
    Ok(())
}
