//! Which voxels a triangle or a box meets: conservative, and tight.
//!
//! The separating-axis test for a triangle and a box (Akenine-Moeller 2001),
//! arranged as in Schwarz & Seidel (2010): one plane test and three edge tests
//! in each coordinate plane, set up once a triangle, in units of voxels.
//! Voxels are grown by [`PAD`] on each side, which covers the walk's error
//! (`trace::local`). Rounding here is covered by terms proportional to the
//! magnitudes involved, so a voxel is never left out, at any scale; one too
//! many is harmless.

use super::footprint::{Near, Shape};
use super::frame::Grid;
use super::stretch::{LONG, stretch};
use crate::aabb::Aabb;
use crate::arena::layout::Triangle;

/// Growth of a voxel on each side, in voxels.
pub const PAD: f64 = 1.0 / 1024.0;
/// Bounds the rounding of the tests below with room to spare (2^-53 each, at
/// most a dozen in a row).
const ROUNDING: f64 = 1.0 / (1u64 << 48) as f64;

/// The first and the last voxel along each axis.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Range {
    pub lo: [u32; 3],
    pub hi: [u32; 3],
    /// Axes, as bits, along which the box lies inside the grid.
    pub inside: u32,
}

impl Range {
    /// The voxels that meet the box `lo, hi`, or `None` if it lies outside.
    pub fn of(grid: &Grid, lo: [f64; 3], hi: [f64; 3]) -> Option<Self> {
        let mut range = Self { lo: [0; 3], hi: [0; 3], inside: 0 };
        for k in 0..3 {
            let cell = |x: f64| (x - grid.lo[k]) * grid.inv_cell[k];
            let (a, b) = (cell(lo[k]), cell(hi[k]));
            let (a, b) = (a - PAD - a.abs() * ROUNDING, b + PAD + b.abs() * ROUNDING);
            let end = f64::from(grid.n[k]);
            if b < 0.0 || a >= end {
                return None;
            }
            range.inside |= u32::from(a >= 0.0 && b < end) << k;
            range.lo[k] = a.max(0.0) as u32;
            range.hi[k] = (b as u32).min(grid.n[k] - 1);
        }
        Some(range)
    }

    pub fn of_box(grid: &Grid, b: &Aabb) -> Option<Self> {
        Self::of(grid, b.lo.map(f64::from), b.hi.map(f64::from))
    }

    /// Number of rows of voxels, along x.
    pub fn rows(&self) -> usize {
        let side = |k: usize| (self.hi[k] - self.lo[k]) as usize + 1;
        side(1) * side(2)
    }

    /// Number of voxels.
    pub fn voxels(&self) -> usize {
        self.rows() * ((self.hi[0] - self.lo[0]) as usize + 1)
    }

    /// Where the box lies in a single layer of voxels, the projection onto that tells all
    /// about a triangle; in a single row, it meets every voxel between its ends.
    #[inline(always)]
    pub fn shape(&self) -> Shape {
        let wide = (0..3).fold(0, |wide, k| wide | u32::from(self.lo[k] != self.hi[k]) << k);
        let thin = self.inside & !wide;
        if wide == 0 || wide.is_power_of_two() && thin | wide == 7 {
            Shape::All
        } else if wide != 7 && thin | wide == 7 {
            Shape::Layer(thin.trailing_zeros() as usize)
        } else {
            Shape::Block
        }
    }

    /// Calls `visit` with the number of each voxel, counted from the grid's first.
    #[inline(always)]
    pub fn each(&self, grid: &Grid, mut visit: impl FnMut(usize)) {
        for z in self.lo[2]..=self.hi[2] {
            for y in self.lo[1]..=self.hi[1] {
                let row = (z as usize * grid.n[1] as usize + y as usize) * grid.n[0] as usize;
                for x in self.lo[0]..=self.hi[0] {
                    visit(row + x as usize);
                }
            }
        }
    }
}

/// The edge tests in one coordinate plane: a voxel of lowest corner (i, j)
/// passes if `a i + b j <= c` for every edge.
struct Edges([[f64; 3]; 3]);

impl Edges {
    /// `q`: the triangle's corners in units of voxels; `i`, `j`: the plane's axes.
    #[inline(always)]
    fn new(q: &[[f64; 3]; 3], (i, j): (usize, usize), error: f64) -> Self {
        // Outward normals: twice the signed area says on which side the triangle lies.
        let area =
            (q[1][i] - q[0][i]) * (q[2][j] - q[0][j]) - (q[1][j] - q[0][j]) * (q[2][i] - q[0][i]);
        let flip = if area > 0.0 { 1.0 } else { -1.0 };
        Self(core::array::from_fn(|e| {
            let (a, b) = (e, (e + 1) % 3);
            let normal = [flip * (q[b][j] - q[a][j]), -flip * (q[b][i] - q[a][i])];
            let offset = normal[0] * q[a][i] + normal[1] * q[a][j];
            // The corner of the grown voxel that lies deepest inside.
            let reach = |n: f64| (-n).max(0.0) + n.abs() * PAD;
            [normal[0], normal[1], offset + reach(normal[0]) + reach(normal[1]) + error]
        }))
    }

    #[inline(always)]
    fn pass(&self, i: u32, j: u32) -> bool {
        let (i, j) = (f64::from(i), f64::from(j));
        self.0.iter().all(|[a, b, c]| a * i + b * j <= *c)
    }

    /// [`Edges::pass`] in two parts: the edges that let through all from some place on
    /// along axis `along` of the plane, and the others.
    #[inline(always)]
    fn parts(&self, i: u32, j: u32, along: usize) -> [bool; 2] {
        let (i, j) = (f64::from(i), f64::from(j));
        let mut parts = [true; 2];
        for [a, b, c] in &self.0 {
            let falls = [a, b][along] < &0.0;
            parts[usize::from(!falls)] &= a * i + b * j <= *c;
        }
        parts
    }
}

/// Whether `rise * x + from` is within `half` of 0, in two parts as [`Edges::parts`].
#[inline(always)]
fn near(rise: f64, x: u32, from: f64, half: f64) -> [bool; 2] {
    let distance = rise * f64::from(x) + from;
    let (above, below) = (distance >= -half, distance <= half);
    if rise < 0.0 { [below, above] } else { [above, below] }
}

/// Writes the numbers of the voxels that `triangle` meets to `list`, ascending, as many as
/// there is room for. Returns how many there are, and how many rows of voxels it looked at.
#[inline(never)]
pub fn voxels(
    triangle: &Triangle,
    grid: &Grid,
    near: Option<&Near>,
    list: &mut [u32],
) -> [usize; 2] {
    let mut count = 0;
    let mut visit = |voxel: usize| {
        if let Some(entry) = list.get_mut(count) {
            *entry = voxel as u32;
        }
        count += 1;
    };
    let rows = near.and_then(|near| near.voxels(triangle, grid, &mut visit));
    let rows = rows.unwrap_or_else(|| far_voxels(triangle, grid, &mut visit));
    [count, rows]
}

/// [`voxels`] in `f64`.
#[cold]
fn far_voxels(triangle: &Triangle, grid: &Grid, visit: &mut impl FnMut(usize)) -> usize {
    let corners = triangle.corners();
    let Some(range) = Range::of_box(grid, &Aabb::of(&corners)) else { return 1 };
    if matches!(range.shape(), Shape::All) {
        range.each(grid, visit);
        return range.rows();
    }
    let q = corners
        .map(|p| core::array::from_fn(|k| (f64::from(p[k]) - grid.lo[k]) * grid.inv_cell[k]));
    let far = q.as_flattened().iter().fold(2048.0f64, |m, x| m.max(x.abs()));
    let (e0, e1) = (edge(&q[0], &q[1]), edge(&q[0], &q[2]));
    let longest = e0.iter().chain(&e1).fold(1.0f64, |m, x| m.max(x.abs()));
    let error = ROUNDING * far * longest * 4.0;
    let edges = [(1, 2), (2, 0), (0, 1)].map(|plane| Edges::new(&q, plane, error));
    let normal = [
        e0[1] * e1[2] - e0[2] * e1[1],
        e0[2] * e1[0] - e0[0] * e1[2],
        e0[0] * e1[1] - e0[1] * e1[0],
    ];
    let offset: f64 = (0..3).map(|k| normal[k] * (q[0][k] - 0.5)).sum();
    let half: f64 =
        normal.iter().map(|n| n.abs() * (0.5 + PAD)).sum::<f64>() + error * longest * 4.0;
    let steep = range.hi[0] - range.lo[0] > 3 && normal[0] != 0.0;
    for z in range.lo[2]..=range.hi[2] {
        for y in range.lo[1]..=range.hi[1] {
            if !edges[0].pass(y, z) {
                continue;
            }
            let row = (z as usize * grid.n[1] as usize + y as usize) * grid.n[0] as usize;
            let plane = normal[1] * f64::from(y) + normal[2] * f64::from(z) - offset;
            let (mut first, mut last) = (range.lo[0], range.hi[0]);
            if steep {
                // Where the row is near the plane, give or take a voxel: rows are
                // long where triangles are large.
                let (a, b) = ((-half - plane) / normal[0], (half - plane) / normal[0]);
                first = first.max((a.min(b) - 1.0).max(0.0) as u32);
                last = last.min((a.max(b) + 1.0).max(0.0) as u32);
            }
            if first <= last && last - first > LONG {
                let [first, end] = stretch(first, last, |x| {
                    let near = near(normal[0], x, plane, half);
                    let (a, b) = (edges[1].parts(z, x, 1), edges[2].parts(x, y, 0));
                    [0, 1].map(|side| near[side] && a[side] && b[side])
                });
                (first..end).for_each(|x| visit(row + x as usize));
                continue;
            }
            for x in first..=last {
                let distance = normal[0] * f64::from(x) + plane;
                if distance.abs() <= half && edges[1].pass(z, x) && edges[2].pass(x, y) {
                    visit(row + x as usize);
                }
            }
        }
    }
    range.rows()
}

fn edge(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [b[0] - a[0], b[1] - a[1], b[2] - a[2]]
}
