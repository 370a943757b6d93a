//! Cost over memory: what a structure costs, at every setting of its parameter.

use super::{GRID, INK, Sheet, failed, svg};
use plotters::prelude::*;
use std::ops::Range;

/// The settings of one structure, joined in their order.
pub struct Line {
    pub name: String,
    /// Memory, cost, and what stands beside the point.
    pub points: Vec<(f64, f64, String)>,
}

/// A chart to be drawn.
pub struct CurveChart<'a> {
    pub title: &'a str,
    /// What the cost is.
    pub cost: &'a str,
    pub lines: &'a [Line],
}

/// Told apart also without colour: the marks differ too.
const COLOURS: [RGBColor; 8] = [
    RGBColor(60, 60, 60),
    RGBColor(192, 57, 43),
    RGBColor(52, 110, 170),
    RGBColor(39, 140, 80),
    RGBColor(150, 80, 170),
    RGBColor(210, 130, 20),
    RGBColor(20, 150, 160),
    RGBColor(190, 70, 130),
];

/// Of the marks of the same lines: those of the second look round.
const CORNERS: [i32; 8] = [4, 16, 3, 6, 4, 16, 3, 6];

const SIZE: (u32, u32) = (640, 440);
const FONT: (&str, u32) = ("sans-serif", 12);
const SMALL: (&str, u32) = ("sans-serif", 11);

impl CurveChart<'_> {
    pub fn svg(&self) -> Result<String, String> {
        svg(SIZE, |root| self.draw(root))
    }

    /// The corner with the fewest points, for the legend.
    fn free_corner(&self, x: &Range<f64>, y: &Range<f64>) -> SeriesLabelPosition {
        let share = |v: f64, r: &Range<f64>| (v / r.start).ln() / (r.end / r.start).ln();
        let near = |right: bool, upper: bool| {
            let all = self.lines.iter().flat_map(|line| &line.points);
            let inside = |p: &&(f64, f64, String)| {
                let (a, b) = (share(p.0, x), share(p.1, y));
                (if right { a > 0.7 } else { a < 0.3 }) && (if upper { b > 0.65 } else { b < 0.35 })
            };
            all.filter(inside).count()
        };
        let corners = [
            (near(true, true), SeriesLabelPosition::UpperRight),
            (near(true, false), SeriesLabelPosition::LowerRight),
            (near(false, true), SeriesLabelPosition::UpperLeft),
            (near(false, false), SeriesLabelPosition::LowerLeft),
        ];
        let free = corners.into_iter().min_by_key(|corner| corner.0);
        free.map_or(SeriesLabelPosition::UpperRight, |corner| corner.1)
    }

    fn draw(&self, root: &Sheet<'_>) -> Result<(), String> {
        let all = || self.lines.iter().flat_map(|line| &line.points);
        let (x, y) = (range(all().map(|p| p.0)), range(all().map(|p| p.1)));
        let mut chart = ChartBuilder::on(root)
            .caption(self.title, ("sans-serif", 14).into_font().color(&INK))
            .margin(8)
            .x_label_area_size(40)
            .y_label_area_size(60)
            .build_cartesian_2d(
                x.clone().log_scale().with_key_points(ticks(&x)),
                y.clone().log_scale().with_key_points(ticks(&y)),
            )
            .map_err(failed)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID)
            .axis_style(INK)
            .label_style(FONT)
            .x_desc("memory without triangles, MB (logarithmic)")
            .y_desc(format!("{} (logarithmic)", self.cost))
            .x_label_formatter(&tick)
            .y_label_formatter(&tick)
            .draw()
            .map_err(failed)?;
        // No name upon a point.
        let mut taken: Vec<[i32; 4]> = all()
            .map(|p| chart.backend_coord(&(p.0, p.1)))
            .map(|(x, y)| [x - 5, y - 5, x + 5, y + 5])
            .collect();
        for (i, line) in self.lines.iter().enumerate() {
            let colour = COLOURS[i % COLOURS.len()];
            let joined = line.points.iter().map(|p| (p.0, p.1));
            chart
                .draw_series(LineSeries::new(joined, colour.stroke_width(2)))
                .map_err(failed)?
                .label(&line.name)
                .legend(move |(x, y)| EmptyElement::at((x + 10, y)) + mark(i, colour));
            let same = |a: &(f64, f64, String), b: &(f64, f64, String)| {
                chart.backend_coord(&(a.0, a.1)) == chart.backend_coord(&(b.0, b.1))
            };
            let mut marks = Vec::new();
            for points in line.points.chunk_by(same) {
                let at = (points[0].0, points[0].1);
                let names: Vec<&str> = points.iter().map(|p| p.2.as_str()).collect();
                let name = names.join(", ");
                let offset = place(&mut taken, chart.backend_coord(&at), &name);
                marks.push(
                    EmptyElement::at(at)
                        + mark(i, colour)
                        + Text::new(name, offset, SMALL.into_font().color(&colour)),
                );
            }
            chart.draw_series(marks).map_err(failed)?;
        }
        chart
            .configure_series_labels()
            .position(self.free_corner(&x, &y))
            .background_style(WHITE.mix(0.8))
            .border_style(GRID)
            .label_font(FONT)
            .draw()
            .map_err(failed)
    }
}

/// Round numbers in a range, more of them in a short one.
fn ticks(range: &Range<f64>) -> Vec<f64> {
    let steps: &[f64] = match range.end / range.start {
        a if a < 20.0 => &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0],
        a if a < 2000.0 => &[1.0, 2.0, 5.0],
        _ => &[1.0],
    };
    let powers = range.start.log10().floor() as i32..=range.end.log10().ceil() as i32;
    let all = powers.flat_map(|power| steps.iter().map(move |step| step * 10f64.powi(power)));
    all.filter(|tick| range.contains(tick)).collect()
}

/// A round number, without what its product leaves in the last digits.
fn tick(x: &f64) -> String {
    ((x * 1e6).round() / 1e6).to_string()
}

/// A polygon, of as many corners as tell a line from the others.
fn mark(line: usize, colour: RGBColor) -> Polygon<(i32, i32)> {
    let corners = CORNERS[line % CORNERS.len()];
    let at = |k: i32| {
        // The first corner is on top.
        let angle = std::f64::consts::TAU * (f64::from(k) / f64::from(corners) - 0.25);
        ((5.0 * angle.cos()).round() as i32, (5.0 * angle.sin()).round() as i32)
    };
    Polygon::new((0..corners).map(at).collect::<Vec<_>>(), colour.filled())
}

/// A range a little wider than the values.
fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
    low / 1.25..high * 1.25
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
