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
        .build_cartesian_2d(x.log_scale(), 0.0..y.end)
        .map_err(failed)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .axis_style(INK)
        .label_style(FONT)
        .x_labels(12)
        .x_desc("memory, MB (logarithmic)")
        .y_desc("time of the picture, ms")
        .x_label_formatter(&|x| super::super::sheet::number(*x))
        .y_label_formatter(&|y| super::super::sheet::number(*y))
        .draw()
        .map_err(failed)?;
    let joined = line.iter().map(|p| (p.0, p.1));
    chart.draw_series(LineSeries::new(joined, BARS.stroke_width(2))).map_err(failed)?;
    let mut taken = Vec::new();
    for (points, colour) in [(line, BARS), (dots, SUM)] {
        for (x, y, name) in points {
            let offset = place(&mut taken, chart.backend_coord(&(*x, *y)), name);
            let mark = EmptyElement::at((*x, *y))
                + Circle::new((0, 0), 4, colour.filled())
                + Text::new(name.clone(), offset, FONT.into_font().color(&colour));
            chart.draw_series(std::iter::once(mark)).map_err(failed)?;
        }
    }
    Ok(())
}

/// Where a name can be read beside its point: the first place where no other name is yet.
fn place(taken: &mut Vec<[i32; 4]>, at: (i32, i32), name: &str) -> (i32, i32) {
    let (wide, high) = (7 * name.chars().count() as i32, 13);
    let right = [-6, -20, 8, -34, 22, -48, 36].map(|down| (7, down));
    let left = right.map(|(_, down)| (-7 - wide, down));
    let area = |(x, y): (i32, i32)| [at.0 + x, at.1 + y, at.0 + x + wide, at.1 + y + high];
    let apart =
        |a: &[i32; 4], b: &[i32; 4]| a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
    let free = |offset: &(i32, i32)| taken.iter().all(|t| apart(t, &area(*offset)));
    let found = right.into_iter().chain(left).find(free).unwrap_or(right[0]);
    taken.push(area(found));
    found
}
