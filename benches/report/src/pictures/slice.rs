//! Slices: a plane through a structure, its voxels coloured by the triangles they refer to.

use super::{Gallery, LEVELS, LINE, WHITE, legend, level_colour, ramp};
use crate::measure::Subject;
use hug::{GridShape, View};
use hug_kit::Mesh;
use maud::{Markup, html};

/// Columns of the longer side.
const PIXELS: f64 = 420.0;
/// A voxel narrower than this many pixels is drawn without its border.
const BORDER: f64 = 5.0;
/// The fullest voxel that has a colour of its own.
const FULL: f64 = 100.0;

pub struct Slice {
    axis: usize,
    at: f64,
    width: u32,
    pixels: Vec<u8>,
}

/// Across x, y, z: the axes that go right and up in the picture.
const ACROSS: [[usize; 2]; 3] = [[2, 1], [0, 2], [0, 1]];

/// The canvas of a plane: where things of the scene are on it.
struct Canvas {
    axes: [usize; 2],
    lower: [f64; 2],
    per_unit: f64,
    size: [usize; 2],
    pixels: Vec<u8>,
}

impl Canvas {
    fn new(world: &GridShape, axis: usize) -> Self {
        let axes = ACROSS[axis];
        let sides = axes.map(|k| world.upper[k] - world.lower[k]);
        let per_unit = PIXELS / sides[0].max(sides[1]);
        let size = sides.map(|side| ((side * per_unit).round() as usize).max(1));
        let lower = axes.map(|k| world.lower[k]);
        Self { axes, lower, per_unit, size, pixels: vec![WHITE; size[0] * size[1]] }
    }

    /// The pixel, along one of the picture's two axes, at a coordinate.
    fn pixel(&self, side: usize, x: f64) -> usize {
        let at = ((x - self.lower[side]) * self.per_unit).round().max(0.0) as usize;
        at.min(self.size[side])
    }

    fn fill(&mut self, columns: [usize; 2], rows: [usize; 2], colour: u8) {
        for row in rows[0]..rows[1].min(self.size[1]) {
            // The picture's first row is its top.
            let start = (self.size[1] - 1 - row) * self.size[0];
            let end = columns[1].min(self.size[0]);
            if columns[0] < end {
                self.pixels[start + columns[0]..start + end].fill(colour);
            }
        }
    }

    /// One pixel wide, inside.
    fn outline(&mut self, columns: [usize; 2], rows: [usize; 2], colour: u8) {
        let [left, right] = columns;
        let [low, high] = rows;
        let (last_column, last_row) = (right.max(left + 1) - 1, high.max(low + 1) - 1);
        self.fill([left, right], [low, low + 1], colour);
        self.fill([left, right], [last_row, last_row + 1], colour);
        self.fill([left, left + 1], rows, colour);
        self.fill([last_column, last_column + 1], rows, colour);
    }

    /// Draws a grid over what is there, if the plane cuts it.
    fn grid(&mut self, view: &View<'_>, number: usize, shape: &GridShape, axis: usize, at: f64) {
        if at < shape.lower[axis] || at >= shape.upper[axis] {
            return;
        }
        let cell = |k: usize| (shape.upper[k] - shape.lower[k]) / f64::from(shape.counts[k]);
        let mut voxel = [0; 3];
        let layer = ((at - shape.lower[axis]) / cell(axis)) as u32;
        voxel[axis] = layer.min(shape.counts[axis] - 1);
        let [across, up] = self.axes;
        let plane = |canvas: &Self, side: usize, i: u32| {
            let k = canvas.axes[side];
            canvas.pixel(side, shape.lower[k] + cell(k) * f64::from(i))
        };
        let wide = self.axes.iter().all(|&k| cell(k) * self.per_unit >= BORDER);
        for j in 0..shape.counts[up] {
            let rows = [plane(self, 1, j), plane(self, 1, j + 1)];
            for i in 0..shape.counts[across] {
                let columns = [plane(self, 0, i), plane(self, 0, i + 1)];
                voxel[across] = i;
                voxel[up] = j;
                let (objects, _) = view.voxel_counts(number, voxel).unwrap_or_default();
                self.fill(columns, rows, colour(objects));
                if wide {
                    let edge = [columns[0], columns[0] + 1];
                    self.fill(edge, rows, LINE);
                    self.fill(columns, [rows[0], rows[0] + 1], LINE);
                }
            }
        }
        let ends = [0, 1].map(|side| {
            let k = self.axes[side];
            [plane(self, side, 0), plane(self, side, shape.counts[k])]
        });
        self.outline(ends[0], ends[1], level_colour(shape.level as usize));
    }
}

/// White for none; then by the logarithm of the number.
fn colour(objects: u64) -> u8 {
    if objects == 0 {
        return WHITE;
    }
    ramp((objects as f64).ln() / FULL.ln())
}

/// The middle triangle's centre along an axis: a plane there meets something.
fn middle(mesh: &Mesh, axis: usize) -> f64 {
    let centre = |t: [[f32; 3]; 3]| t.iter().map(|p| f64::from(p[axis])).sum::<f64>() / 3.0;
    let mut all: Vec<f64> = mesh.triangles().map(centre).filter(|x| x.is_finite()).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or_default()
}

fn slice(view: &View<'_>, axis: usize, at: f64) -> Option<Slice> {
    let world = view.grid_shape(0)?;
    let mut canvas = Canvas::new(&world, axis);
    // Grids come after those that refer to them, so deeper ones are on top.
    for number in 0..view.grid_count() {
        if let Some(shape) = view.grid_shape(number) {
            canvas.grid(view, number, &shape, axis, at);
        }
    }
    Some(Slice { axis, at, width: canvas.size[0] as u32, pixels: canvas.pixels })
}

/// A horizontal slice and an upright one.
pub fn both(view: &View<'_>, mesh: &Mesh) -> Vec<Slice> {
    [1, 2].into_iter().filter_map(|axis| slice(view, axis, middle(mesh, axis))).collect()
}

/// The slices through all structures of a scene.
pub fn all(subject: &Subject, gallery: &mut Gallery) -> Result<Markup, String> {
    let mut pairs = Vec::new();
    for built in &subject.built {
        let mut images = Vec::new();
        for slice in &built.slices {
            let axis = ["x", "y", "z"][slice.axis];
            let caption = format!("{}, {axis} = {:.2}", built.name, slice.at);
            let (file, alt) = (format!("{}.slice-{axis}", built.name), format!("slice {caption}"));
            let picture = gallery.image(&file, slice.width, &slice.pixels, true, &alt)?;
            images.push((picture, caption));
        }
        pairs.push(images);
    }
    let levels = subject.built.iter().map(|b| b.stats.levels().len()).max().unwrap_or(0);
    Ok(html! {
        h4 { "Slices: triangles a voxel refers to" }
        (legend("1", "100", "or more triangles (logarithmic); white: none"))
        div.legend { "outlines of grids:" @for level in 0..levels {
            @let c = LEVELS[level.min(LEVELS.len() - 1)];
            span.key style={ "border-color:rgb(" (c.0) "," (c.1) "," (c.2) ")" } { "level " (level) }
        } }
        div.pictures { @for images in pairs { div.pair { @for (image, caption) in images {
            figure { (image) figcaption { (caption) } }
        } } } }
    })
}
