//! The overlap test of `overlap` in `f32`, the three edges at once: for triangles
//! whose corners lie within a few hundred voxels of where they are looked for.
//!
//! Corners are rounded relative to the lowest voxel in question, which moves them
//! by at most 2^-24 of their distance, 2^-16 of a voxel: the growth of the
//! voxels covers that besides the walk's error. What the tests themselves round
//! is bounded by terms that grow with the magnitudes involved, 2^-18 and 2^-16 of
//! them where 2^-20 and 2^-18 would do.

use glam::{Vec3A, Vec4};

use super::frame::Grid;
use super::overlap::{PAD, Range};

/// Growth of a voxel on each side, in voxels.
const GROWN: f32 = PAD as f32 * 1.125;

/// A triangle's corners in units of voxels, from the lowest voxel of a range.
pub struct Small {
    /// Each axis' coordinates of corners 0, 1, 2, 0 and of 1, 2, 0, 1.
    corners: [[Vec4; 2]; 3],
    far: f32,
    longest: f32,
}

/// The edge tests in one coordinate plane: a voxel of lowest corner (i, j)
/// passes if `a i + b j <= c` for every edge.
#[derive(Clone, Copy)]
struct Edges {
    a: Vec4,
    b: Vec4,
    c: Vec4,
}

impl Edges {
    #[inline(always)]
    fn pass(&self, i: f32, j: f32) -> bool {
        (self.a * i + self.b * j).cmple(self.c).all()
    }
}

impl Small {
    /// `None` if `f32` is too coarse.
    #[inline(always)]
    pub fn new(q: &[[f64; 3]; 3], range: &Range) -> Option<Self> {
        let low = range.lo.map(f64::from);
        let p = q.map(|q| {
            Vec3A::new((q[0] - low[0]) as f32, (q[1] - low[1]) as f32, (q[2] - low[2]) as f32)
        });
        let last = core::array::from_fn(|k| (range.hi[k] - range.lo[k]) as f32 + 1.0);
        let far = p[0].abs().max(p[1].abs()).max(p[2].abs()).max(Vec3A::from_array(last));
        let longest = (p[1] - p[0]).abs().max((p[2] - p[0]).abs()).max(Vec3A::ONE);
        let (far, longest) = (far.max_element(), longest.max_element());
        if far > 256.0 || far * longest > 16384.0 {
            return None;
        }
        let corners = [0, 1, 2].map(|k| {
            let [x, y, z] = p.map(|p| p[k]);
            [Vec4::new(x, y, z, x), Vec4::new(y, z, x, y)]
        });
        Some(Self { corners, far, longest })
    }

    #[inline(always)]
    fn edges(&self, (i, j): (usize, usize)) -> Edges {
        let ([qi, ri], [qj, rj]) = (self.corners[i], self.corners[j]);
        let (di, dj) = (ri - qi, rj - qj);
        // Outward normals: twice the signed area says on which side the triangle lies.
        let area = di.x * dj.y - dj.x * di.y;
        let flip = if area > 0.0 { 1.0 } else { -1.0 };
        let (a, b) = (dj * flip, di * -flip);
        // The corner of the grown voxel that lies deepest inside.
        let grown = (a.abs() + b.abs()) * GROWN - a.min(Vec4::ZERO) - b.min(Vec4::ZERO);
        let error = self.far * self.longest * (1.0 / (1 << 18) as f32);
        Edges { a, b, c: a * qi + b * qj + grown + Vec4::splat(error) }
    }

    /// Visits what the triangle meets of a single layer of voxels across axis `k`.
    #[inline(always)]
    pub fn layer(&self, k: usize, range: &Range, grid: &Grid, mut visit: impl FnMut(usize)) {
        let (i, j) = [(1, 2), (0, 2), (0, 1)][k];
        let edges = self.edges((i, j));
        let strides = [1, grid.n[0] as usize, grid.n[0] as usize * grid.n[1] as usize];
        let first: usize = (0..3).map(|k| range.lo[k] as usize * strides[k]).sum();
        for b in 0..=range.hi[j] - range.lo[j] {
            for a in 0..=range.hi[i] - range.lo[i] {
                if edges.pass(a as f32, b as f32) {
                    visit(first + a as usize * strides[i] + b as usize * strides[j]);
                }
            }
        }
    }

    /// Visits what the triangle meets of a range.
    #[inline(always)]
    pub fn block(&self, range: &Range, grid: &Grid, mut visit: impl FnMut(usize)) {
        let [yz, zx, xy] = [(1, 2), (2, 0), (0, 1)].map(|plane| self.edges(plane));
        let corner = |e: usize| Vec3A::from_array(self.corners.map(|q| q[0][e]));
        let q = corner(0);
        let normal = (corner(1) - q).cross(corner(2) - q);
        let offset = normal.dot(q - 0.5);
        let half = normal.abs().dot(Vec3A::splat(0.5 + GROWN))
            + self.far * self.longest * self.longest * (1.0 / (1 << 16) as f32);
        let sides: [u32; 3] = core::array::from_fn(|k| range.hi[k] - range.lo[k]);
        let steep = sides[0] > 3 && normal.x != 0.0;
        for z in 0..=sides[2] {
            for y in 0..=sides[1] {
                let (fy, fz) = (y as f32, z as f32);
                if !yz.pass(fy, fz) {
                    continue;
                }
                let row =
                    (range.lo[2] + z) as usize * grid.n[1] as usize + (range.lo[1] + y) as usize;
                let row = row * grid.n[0] as usize + range.lo[0] as usize;
                let plane = normal.y * fy + normal.z * fz - offset;
                let (mut first, mut last) = (0, sides[0]);
                if steep {
                    // Where the row is near the plane, give or take a voxel: rows are
                    // long where triangles are large.
                    let (a, b) = ((-half - plane) / normal.x, (half - plane) / normal.x);
                    first = first.max((a.min(b) - 1.0).max(0.0) as u32);
                    last = last.min((a.max(b) + 1.0).max(0.0) as u32);
                }
                for x in first..=last {
                    let fx = x as f32;
                    let distance = normal.x * fx + plane;
                    if distance.abs() <= half && zx.pass(fz, fx) && xy.pass(fx, fy) {
                        visit(row + x as usize);
                    }
                }
            }
        }
    }
}
