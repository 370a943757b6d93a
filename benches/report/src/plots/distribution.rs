//! A histogram and its cumulated distribution on one chart, as in the paper: the left scale is
//! that of the histogram, the right one that of the distribution.

use super::{BARS, GRID, INK, SUM, Sheet, failed, round_up, svg};
use plotters::prelude::*;

/// A chart to be drawn.
pub struct Distribution<'a> {
    pub title: &'a str,
    /// What the classes are of.
    pub x: &'a str,
    /// Percentage in each class.
    pub percent: &'a [f64],
    /// Percentage up to and with each class.
    pub cumulated: &'a [f64],
    /// Where the classes begin, and how wide one is.
    pub start: f64,
    pub width: f64,
}

const SIZE: (u32, u32) = (430, 280);
const FONT: (&str, u32) = ("sans-serif", 12);

impl Distribution<'_> {
    pub fn svg(&self) -> Result<String, String> {
        svg(SIZE, |root| self.draw(root))
    }

    fn draw(&self, root: &Sheet<'_>) -> Result<(), String> {
        let classes = self.percent.len().min(self.cumulated.len());
        let end = self.start + self.width * classes as f64;
        let top = self.percent.iter().copied().fold(0.0, f64::max);
        let top = round_up(top.max(0.01));
        let mut chart = ChartBuilder::on(root)
            .caption(self.title, ("sans-serif", 14).into_font().color(&INK))
            .margin(6)
            .x_label_area_size(36)
            .y_label_area_size(48)
            .right_y_label_area_size(48)
            .build_cartesian_2d(self.start..end, 0.0..top)
            .map_err(failed)?
            .set_secondary_coord(self.start..end, 0.0..100.0);
        let digits = if top < 1.0 { 2 } else { usize::from(top < 10.0) };
        let places = if end - self.start < 1.0 { 2 } else { usize::from(self.width < 1.0) };
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID)
            .axis_style(INK)
            .label_style(FONT)
            .x_labels(9)
            .y_labels(6)
            .x_desc(self.x)
            .y_desc("% in a class (bars)")
            .x_label_formatter(&|x| format!("{x:.places$}"))
            .y_label_formatter(&|y| format!("{y:.digits$}"))
            .draw()
            .map_err(failed)?;
        chart
            .configure_secondary_axes()
            .axis_style(INK)
            .label_style(FONT.into_font().color(&SUM))
            .y_labels(6)
            .y_desc("% cumulated (line)")
            .y_label_formatter(&|y| format!("{y:.0}"))
            .draw()
            .map_err(failed)?;
        let left = |i: usize| self.start + self.width * i as f64;
        let bars = self.percent.iter().take(classes).enumerate().filter(|bar| *bar.1 > 0.0);
        chart
            .draw_series(
                bars.map(|(i, &p)| {
                    Rectangle::new([(left(i), 0.0), (left(i + 1), p)], BARS.filled())
                }),
            )
            .map_err(failed)?;
        // A step at every class: the distribution is of whole classes.
        let steps = self.cumulated.iter().take(classes).enumerate();
        let line = steps.flat_map(|(i, &p)| [(left(i), p), (left(i + 1), p)]);
        chart.draw_secondary_series(LineSeries::new(line, SUM.stroke_width(2))).map_err(failed)?;
        Ok(())
    }
}
