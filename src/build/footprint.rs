//! The overlap test of `overlap` in `f32`, in vectors: for triangles whose corners lie
//! within a few hundred voxels of a grid's lowest one.
//!
//! In units of voxels a corner is `(p - origin) * inv - shift`, with `origin` the grid's
//! corner rounded to `f32` and `shift`, at most 1, what that left out. With coordinates up
//! to 512 the difference, the factor and the product are off by 2^-24 of at most 513 each,
//! the subtraction of `shift` and the move to the lowest voxel in question by 2^-24 of 512
//! each: in sum by less than 2^-12.6 of a voxel, and voxels are grown by 2^-12 more than
//! the walk's error asks for. What the tests themselves round is bounded by terms that
//! grow with the magnitudes involved, 2^-18 and 2^-16 of them where 2^-20 and 2^-18 would
//! do.

use glam::{Vec3A, Vec4, Vec4Swizzles};

use super::frame::Grid;
use super::overlap::{PAD, Range};
use super::stretch::{LONG, stretch};
use crate::arena::layout::Triangle;

/// Growth of a voxel on each side, in voxels.
const GROWN: f32 = PAD as f32 * 1.25;
/// The largest coordinate, in voxels.
const FAR: f32 = 512.0;
/// Voxels along each side of a block that is tested in rows of bits.
const SIDE: usize = 16;
const RAMP: Vec4 = Vec4::new(0.0, 1.0, 2.0, 3.0);

/// A grid, as this test wants it.
pub struct Near {
    origin: Vec3A,
    inv: Vec3A,
    shift: Vec3A,
    n: Vec3A,
}

impl Near {
    /// `None` if `f32` cannot tell the grid's voxels apart.
    pub fn new(grid: &Grid) -> Option<Self> {
        let origin = grid.lo.map(|x| x as f32);
        let shift = [0, 1, 2].map(|k| (grid.lo[k] - f64::from(origin[k])) * grid.inv_cell[k]);
        let fine = grid.inv_cell.iter().all(|inv| (1e-30..1e30).contains(inv))
            && shift.iter().all(|shift| shift.abs() <= 1.0);
        fine.then(|| Self {
            origin: Vec3A::from_array(origin),
            inv: Vec3A::from_array(grid.inv_cell.map(|x| x as f32)),
            shift: Vec3A::from_array(shift.map(|x| x as f32)),
            n: Vec3A::from_array(grid.n.map(|n| n as f32)),
        })
    }

    /// Calls `visit` with each voxel that `triangle` meets; returns how many rows of
    /// voxels it looked at, or `None` if `f32` is too coarse.
    #[inline(always)]
    pub fn voxels(
        &self,
        triangle: &Triangle,
        grid: &Grid,
        visit: impl FnMut(usize),
    ) -> Option<usize> {
        let corner = |i: usize| {
            let p = Vec3A::new(triangle.x[i], triangle.y[i], triangle.z[i]);
            (p - self.origin) * self.inv - self.shift
        };
        let q = [corner(0), corner(1), corner(2)];
        let (lowest, highest) = (q[0].min(q[1]).min(q[2]), q[0].max(q[1]).max(q[2]));
        // What overflowed is infinite and no NaN.
        let near = lowest.cmpge(Vec3A::splat(-FAR)) & highest.cmple(Vec3A::splat(FAR));
        if !near.all() {
            return None;
        }
        let (a, b) = (lowest - GROWN, highest + GROWN);
        if (b.cmplt(Vec3A::ZERO) | a.cmpge(self.n)).any() {
            return Some(1);
        }
        let inside = (a.cmpge(Vec3A::ZERO) & b.cmplt(self.n)).bitmask();
        let lo = floor(a.max(Vec3A::ZERO));
        let hi = floor(b.min(self.n - 0.5));
        let range = Range { lo, hi, inside };
        let thin = match range.shape() {
            Shape::All => {
                range.each(grid, visit);
                return Some(range.rows());
            }
            Shape::Layer(k) => Some(k),
            Shape::Block => None,
        };
        let low = Vec3A::from_array(lo.map(|x| x as f32));
        let small = Small::new(q.map(|q| q - low), &range)?;
        match thin {
            Some(k) => small.layer(k, &range, grid, visit),
            None => small.block(&range, grid, visit),
        }
        Some(range.rows())
    }
}

/// The integers not above these numbers, which are in `0..=FAR`; of an integer perhaps
/// the one before it, which `GROWN` allows for.
#[inline(always)]
fn floor(x: Vec3A) -> [u32; 3] {
    // Numbers from 2^23 on have no fraction.
    const WHOLE: f32 = 1.5 * (1 << 23) as f32;
    (x - 0.5 + WHOLE).to_array().map(|x| x.to_bits() & 0xf_ffff)
}

/// How a range of voxels can be gone through.
pub enum Shape {
    /// All of them meet the triangle.
    All,
    /// A single layer across an axis, in which the triangle lies.
    Layer(usize),
    Block,
}

/// A triangle's corners in units of voxels, from the lowest voxel of a range.
struct Small {
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

    /// [`Edges::pass`] in two parts: the edges that let through all from some place on
    /// along the first axis, and the others.
    #[inline(always)]
    fn parts(&self, i: f32, j: f32) -> [bool; 2] {
        let pass = (self.a * i + self.b * j).cmple(self.c);
        let falls = self.a.cmplt(Vec4::ZERO);
        [(pass | !falls).all(), (pass | falls).all()]
    }

    /// Which of the voxels (0, j) to (count - 1, j) pass, for each j, as bits; those
    /// beyond mean nothing.
    #[inline(always)]
    fn rows(&self, count: [usize; 2]) -> [u32; SIDE] {
        let mut rows = [0; SIDE];
        let mut i = 0;
        while i < count[0] {
            let ramp = RAMP + i as f32;
            let [a0, a1, a2] = [ramp * self.a.xxxx(), ramp * self.a.yyyy(), ramp * self.a.zzzz()];
            for (j, row) in rows[..count[1]].iter_mut().enumerate() {
                let left = self.c - self.b * j as f32;
                let pass = a0.cmple(left.xxxx()) & a1.cmple(left.yyyy()) & a2.cmple(left.zzzz());
                *row |= pass.bitmask() << i;
            }
            i += 4;
        }
        rows
    }
}

impl Small {
    /// `None` if `f32` is too coarse.
    #[inline(always)]
    fn new(p: [Vec3A; 3], range: &Range) -> Option<Self> {
        let last = [0, 1, 2].map(|k| (range.hi[k] - range.lo[k]) as f32 + 1.0);
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
    fn layer(&self, k: usize, range: &Range, grid: &Grid, mut visit: impl FnMut(usize)) {
        let (i, j) = [(1, 2), (0, 2), (0, 1)][k];
        let edges = self.edges((i, j));
        let strides = [1, grid.n[0] as usize, grid.n[0] as usize * grid.n[1] as usize];
        let first: usize = (0..3).map(|k| range.lo[k] as usize * strides[k]).sum();
        let last = range.hi[i] - range.lo[i];
        for b in 0..=range.hi[j] - range.lo[j] {
            if last > LONG {
                let [from, end] = stretch(0, last, |a| edges.parts(a as f32, b as f32));
                let row = first + b as usize * strides[j];
                (from..end).for_each(|a| visit(row + a as usize * strides[i]));
                continue;
            }
            for a in 0..=last {
                if edges.pass(a as f32, b as f32) {
                    visit(first + a as usize * strides[i] + b as usize * strides[j]);
                }
            }
        }
    }

    /// Visits what the triangle meets of a range.
    #[inline(always)]
    fn block(&self, range: &Range, grid: &Grid, mut visit: impl FnMut(usize)) {
        let [yz, xz, xy] = [(1, 2), (0, 2), (0, 1)].map(|plane| self.edges(plane));
        let corner = |e: usize| Vec3A::from_array(self.corners.map(|q| q[0][e]));
        let q = corner(0);
        let normal = (corner(1) - q).cross(corner(2) - q);
        let offset = normal.dot(q - 0.5);
        let half = normal.abs().dot(Vec3A::splat(0.5 + GROWN))
            + self.far * self.longest * self.longest * (1.0 / (1 << 16) as f32);
        let sides: [u32; 3] = [0, 1, 2].map(|k| range.hi[k] - range.lo[k]);
        let number = |y: u32, z: u32| {
            let row = (range.lo[2] + z) as usize * grid.n[1] as usize + (range.lo[1] + y) as usize;
            row * grid.n[0] as usize + range.lo[0] as usize
        };
        if sides.iter().all(|&side| (side as usize) < SIDE) {
            let [nx, ny, nz] = sides.map(|side| side as usize + 1);
            let (yz, xz, xy) = (yz.rows([ny, nz]), xz.rows([nx, nz]), xy.rows([nx, ny]));
            let (half, steps) = (Vec4::splat(half), RAMP * normal.x);
            let [columns, rows] = [nx, ny].map(|n| u32::MAX >> (32 - n));
            for (z, (&ys, &across)) in yz[..nz].iter().zip(&xz).enumerate() {
                let across = across & columns;
                let mut ys = if across == 0 { 0 } else { ys & rows };
                while ys != 0 {
                    let y = ys.trailing_zeros();
                    ys &= ys - 1;
                    let candidates = across & xy[y as usize % SIDE];
                    let plane = normal.y * y as f32 + normal.z * z as f32 - offset;
                    let (mut near, mut x) = (0, 0);
                    while x < nx {
                        let distance = steps + (normal.x * x as f32 + plane);
                        near |= distance.abs().cmple(half).bitmask() << x;
                        x += 4;
                    }
                    let mut met = candidates & near;
                    let first = number(y, z as u32);
                    while met != 0 {
                        visit(first + met.trailing_zeros() as usize);
                        met &= met - 1;
                    }
                }
            }
            return;
        }
        let steep = sides[0] > 3 && normal.x != 0.0;
        for z in 0..=sides[2] {
            for y in 0..=sides[1] {
                let (fy, fz) = (y as f32, z as f32);
                if !yz.pass(fy, fz) {
                    continue;
                }
                let row = number(y, z);
                let plane = normal.y * fy + normal.z * fz - offset;
                let (mut first, mut last) = (0, sides[0]);
                if steep {
                    // Where the row is near the plane, give or take a voxel: rows are
                    // long where triangles are large.
                    let (a, b) = ((-half - plane) / normal.x, (half - plane) / normal.x);
                    first = first.max((a.min(b) - 1.0).max(0.0) as u32);
                    last = last.min((a.max(b) + 1.0).max(0.0) as u32);
                }
                if first <= last && last - first > LONG {
                    let [first, end] = stretch(first, last, |x| {
                        let x = x as f32;
                        let distance = normal.x * x + plane;
                        let (above, below) = (distance >= -half, distance <= half);
                        let near = if normal.x < 0.0 { [below, above] } else { [above, below] };
                        let (a, b) = (xz.parts(x, fz), xy.parts(x, fy));
                        [0, 1].map(|side| near[side] && a[side] && b[side])
                    });
                    (first..end).for_each(|x| visit(row + x as usize));
                    continue;
                }
                for x in first..=last {
                    let fx = x as f32;
                    let distance = normal.x * fx + plane;
                    if distance.abs() <= half && xz.pass(fx, fz) && xy.pass(fx, fy) {
                        visit(row + x as usize);
                    }
                }
            }
        }
    }
}
