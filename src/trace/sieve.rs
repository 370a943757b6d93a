//! A first look at a triangle, in `f32`: out for certain, or worth deciding?
//!
//! The triangle is sheared so that the ray becomes a coordinate axis (Woop,
//! Benthin & Wald 2013), the three corners side by side in one register; it is
//! out if the ray passes two of its edges on opposite sides by more than the
//! error bound. A hit is never out: with e = 2^-24 and R the largest distance,
//! along an axis, from the origin to the scene's box, a sheared coordinate is
//! off by at most `6.1 e R` (difference 1, slope 1, product 1, third difference 1 twice,
//! in units of e R). Call d = 8 e R. An edge product of corners i and j is then
//! off by at most `2 d (|x_i| + |y_i| + |x_j| + |y_j|) + 4 d^2`, its own rounding
//! included; the bound used is `3 d` times the sum of `|x| + |y| + 2 d` over both.
//! Scenes so large or small that `f32` products leave their range are not sieved.

use crate::arena::layout::Triangle;
use crate::ray::Ray;
use crate::simd::Lanes;

/// Distances within which products of two sheared coordinates, and of two of
/// their error bounds, stay in the range of `f32`.
const RANGE: core::ops::Range<f64> = 1e-14..1e14;

/// A ray made ready for sieving triangles.
#[derive(Clone, Copy)]
pub struct Sieve<L: Lanes> {
    lanes: L,
    /// The axes in the order x, y, z of the sheared space.
    axes: [usize; 3],
    org: [L::F32; 3],
    shear: [L::F32; 2],
    error: L::F32,
    error_twice: L::F32,
    /// Whether the error bound holds.
    pub holds: bool,
}

impl<L: Lanes> Sieve<L> {
    #[inline(always)]
    pub fn new(lanes: L, ray: &Ray, (lo, hi): ([f32; 3], [f32; 3])) -> Self {
        let d = ray.dir.map(f32::abs);
        let z = if d[0] > d[1] && d[0] > d[2] {
            0
        } else if d[1] > d[2] {
            1
        } else {
            2
        };
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let mut far = 0.0f64;
        for k in 0..3 {
            let o = f64::from(ray.org[k]);
            far = far.max(f64::from(hi[k]) - o).max(o - f64::from(lo[k]));
        }
        let error = (far * (8.0 / f64::from(1 << 24))) as f32;
        let slope = |k: usize| (f64::from(ray.dir[k]) / f64::from(ray.dir[z])) as f32;
        Self {
            lanes,
            axes: [x, y, z],
            org: [x, y, z].map(|k| lanes.splat_f32(ray.org[k])),
            shear: [x, y].map(|k| lanes.splat_f32(slope(k))),
            error: lanes.splat_f32(3.0 * error),
            error_twice: lanes.splat_f32(2.0 * error),
            holds: RANGE.contains(&far),
        }
    }

    /// Whether the ray's line certainly misses the triangle.
    #[inline(always)]
    pub fn out(&self, triangle: &Triangle) -> bool {
        let l = self.lanes;
        let rows: &[[f32; 4]; 3] = bytemuck::cast_ref(triangle);
        let [x, y, z] = self.axes;
        let local = |k: usize, i: usize| l.sub_f32(l.load(&rows[k]), self.org[i]);
        let (x, y, z) = (local(x, 0), local(y, 1), local(z, 2));
        let x = l.sub_f32(x, l.mul_f32(self.shear[0], z));
        let y = l.sub_f32(y, l.mul_f32(self.shear[1], z));
        let side = l.sub_f32(l.mul_f32(x, l.rotate(y)), l.mul_f32(y, l.rotate(x)));
        let size = l.add_f32(l.add_f32(l.abs_f32(x), l.abs_f32(y)), self.error_twice);
        l.both_sides(side, l.mul_f32(self.error, l.add_f32(size, l.rotate(size))))
    }
}
