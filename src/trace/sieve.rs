//! A first look at a few triangles, in `f32`: out for certain, or worth deciding?
//!
//! Triangles are sheared so that the ray becomes a coordinate axis (Woop, Benthin &
//! Wald 2013); a triangle is out if the ray passes two of its edges on opposite sides
//! by more than the error bound, or if its corners' z all are those of parameters
//! out of range. A hit is never out: with e = 2^-24 and R the largest distance, along an
//! axis, from the origin to the scene's box, a sheared coordinate is off by at most
//! `6.1 e R` (difference 1, slope 1, product 1, third difference 1 twice, in units of
//! e R). Call d = 8 e R. An edge product of corners i and j is then off by at most
//! `2 d` times the sum of their `|x|` and `|y|`, and `4 d^2`, its own rounding
//! included; the bound used is `3 d` times the sum of `|x| + |y| + 2 d` over all three: call it
//! E. A fused multiply-add only leaves roundings out.
//!
//! A triangle is out, too, if the place on it that the ray meets is out of range. The edge
//! products are that place's weights, so its z is the sum of their products with the corners' z,
//! `height`, over their sum, `det`. With U the sum of the products' sizes, det is off by at most
//! `3 E + 3 e U`; with Z the largest |z| of the corners plus that of the range's end,
//! `height - end det` by `(3 E + 6 e U) Z`. Used are `4 E + 8 e U`, for both, and 2^-100 for what
//! underflows. An infinite end makes infinities and NaN, which are never out. Scenes so large
//! or small that `f32` products leave their range are not sieved.

use super::counters::Count;
use crate::arena::{Axis, Sections};
use crate::ray::Ray;
use crate::simd::Lanes;

use super::bounds::splat3;

/// Distances within which products of three sheared coordinates, and of two of
/// their error bounds, stay in the range of `f32`.
const RANGE: core::ops::Range<f32> = 1e-9..1e12;

/// 2^-100.
const TINY: f32 = 1.0 / (1u128 << 100) as f32;

/// A ray made ready for sieving triangles.
#[derive(Clone, Copy)]
pub struct Sieve<'a> {
    /// The triangles along the axes that are x, y, z of the sheared space.
    axes: [Axis<'a>; 3],
    /// The origin along these axes; the change of x and of y with z and three times the
    /// error of a coordinate; the range of z where t is in range.
    rows: [[f32; 4]; 3],
    /// Component z of the direction, and that of `tmin`.
    dir: f32,
    start: f32,
    /// Whether the error bound holds; if not, nothing is out.
    holds: bool,
}

/// Triangles to sieve in one go. As many everywhere where tests are counted: a walk may
/// end with any of them.
pub(super) const fn chunk<C: Count, L: Lanes>() -> usize {
    if C::COUNTS { 4 } else { L::WIDE }
}

/// For each set of axes along which a direction is longest, a bit each: one of
/// them third, the others before.
const ORDER: [[i32; 4]; 8] = {
    let (x, y, z) = ([1, 2, 0, 3], [2, 0, 1, 3], [0, 1, 2, 3]);
    [z, x, y, x, z, x, y, x]
};

/// The range of z, from that of `tmin` to that of `limit`. A corner's z is off by
/// one rounding, and so are these.
#[inline(always)]
fn range(start: f32, dir: f32, limit: f32) -> [f32; 2] {
    let end = limit * dir;
    let (lo, hi) = if dir > 0.0 { (start, end) } else { (end, start) };
    // A t next to zero may have been rounded by up to half the least denormal. Not
    // just that much: processors take long to compute denormals.
    let least = TINY + dir.abs() * TINY;
    let room = |x: f32| x.abs() * (4.0 * f32::EPSILON) + least;
    [lo - room(lo), hi + room(hi)]
}

impl<'a> Sieve<'a> {
    /// `org` and `dir` are the ray's, `lo` and `hi` the corners of the scene's box;
    /// fourth lanes mean nothing.
    #[inline(always)]
    pub fn new<L: Lanes>(
        l: L,
        sections: &Sections<'a>,
        ray: &Ray,
        [org, dir]: [L::F32; 2],
        [lo, hi]: [L::F32; 2],
    ) -> Self {
        let size = l.abs_f32(dir);
        let order = &ORDER[l.equals(size, l.highest(size)) as usize];
        let far = l.first(l.highest(l.max_f32(l.sub_f32(hi, org), l.sub_f32(org, lo))));
        let (org, dir) = (l.permute(org, order), l.permute(dir, order));
        let slope = l.div_f32(dir, l.permute(dir, &[2; 4]));
        // The difference may have rounded down: 8.01 makes up for it.
        let error = far * (8.01 / (1 << 24) as f32);
        let dir = l.first(l.permute(dir, &[2; 4]));
        let start = ray.tmin * dir;
        let axis = |k: usize| sections.axis(order[k] as usize);
        let holds = (RANGE.start < far) & (far < RANGE.end);
        let mut rows =
            [l.array_f32(org), l.array_f32(slope), [f32::NEG_INFINITY, f32::INFINITY, 0.0, 0.0]];
        rows[1][2] = if holds { 3.0 * error } else { f32::INFINITY };
        let mut sieve = Self { axes: [axis(0), axis(1), axis(2)], rows, dir, start, holds };
        sieve.limit(ray.tmax);
        sieve
    }

    /// Sets the largest t of interest.
    #[inline(always)]
    pub fn limit(&mut self, limit: f32) {
        if self.holds {
            [self.rows[2][0], self.rows[2][1]] = range(self.start, self.dir, limit);
        }
    }

    /// One bit for each of at most [`Lanes::WIDE`] triangles, from references, that
    /// the ray may meet in range.
    #[inline(always)]
    pub fn pass<L: Lanes>(&self, l: L, refs: &[u32]) -> u32 {
        let all = (1u32 << refs.len()) - 1;
        // One alone is decided nearly as soon as it is sieved.
        if !self.holds | (refs.len() == 1) {
            return all;
        }
        let rows = l.thrice(refs);
        let [x, y, z] = &self.axes;
        let triangles = [
            l.columns(|i| x.row(rows[i])),
            l.columns(|i| y.row(rows[i])),
            l.columns(|i| z.row(rows[i])),
        ];
        let [org, slope, range] = &self.rows;
        let rays = [splat3(l, org), splat3(l, slope), splat3(l, range)];
        all & !misses(l, rays, triangles)
    }

    /// One bit for each of [`Lanes::WIDE`] triangles, from number `first` on, that the ray may
    /// meet in range.
    #[inline(always)]
    pub fn pass_run<L: Lanes>(&self, l: L, first: u32) -> u32 {
        let all = u32::MAX >> (32 - L::WIDE);
        if !self.holds {
            return all;
        }
        let [x, y, z] = &self.axes;
        let triangles = [
            l.columns(|i| x.row(3 * (first + i as u32))),
            l.columns(|i| y.row(3 * (first + i as u32))),
            l.columns(|i| z.row(3 * (first + i as u32))),
        ];
        let [org, slope, range] = &self.rows;
        let rays = [splat3(l, org), splat3(l, slope), splat3(l, range)];
        all & !misses(l, rays, triangles)
    }

    /// One bit for each of [`Lanes::WIDE`] triangles, from references, that a ray of its own
    /// may meet in range.
    #[inline(always)]
    pub fn pass_each<'s, L: Lanes>(l: L, sieve: impl Fn(usize) -> &'s Self, refs: &[u32; 8]) -> u32
    where
        'a: 's,
    {
        let rows = l.thrice(refs);
        let triangles = [
            l.columns(|i| sieve(i).axes[0].row(rows[i])),
            l.columns(|i| sieve(i).axes[1].row(rows[i])),
            l.columns(|i| sieve(i).axes[2].row(rows[i])),
        ];
        let rays = [
            l.columns(|i| &sieve(i).rows[0]),
            l.columns(|i| &sieve(i).rows[1]),
            l.columns(|i| &sieve(i).rows[2]),
        ];
        misses(l, rays, triangles) ^ (u32::MAX >> (32 - L::WIDE))
    }
}

/// Coordinates of several triangles: axis by axis those of the corners.
type Triangles<L> = [[<L as Lanes>::Wide; 3]; 3];

/// One bit for each triangle that its ray misses; `rays` are in the order of
/// [`Sieve::rows`].
#[inline(always)]
fn misses<L: Lanes>(l: L, rays: Triangles<L>, [xs, ys, zs]: Triangles<L>) -> u32 {
    let [org, [sx, sy, error], [lo, hi, _]] = rays;
    let slope = [sx, sy];
    let a = shear(l, org, slope, [xs[0], ys[0], zs[0]]);
    let b = shear(l, org, slope, [xs[1], ys[1], zs[1]]);
    let c = shear(l, org, slope, [xs[2], ys[2], zs[2]]);
    let ab = l.cross_wide(a.x, b.y, a.y, b.x);
    let bc = l.cross_wide(b.x, c.y, b.y, c.x);
    let ca = l.cross_wide(c.x, a.y, c.y, a.x);
    let size = l.add_wide(l.add_wide(a.size, b.size), c.size);
    let error = l.mul_wide(error, l.add_wide(size, l.add_wide(error, error)));
    let most = l.max_wide(l.max_wide(ab, bc), ca);
    let least = l.min_wide(l.min_wide(ab, bc), ca);
    let zero = l.splat_wide(0.0);
    let minus_least = l.sub_wide(zero, least);
    let beside = l.misses([most, error], minus_least, [zero, zero], [zero, zero]);
    let near = l.min_wide(l.min_wide(a.z, b.z), c.z);
    let far = l.max_wide(l.max_wide(a.z, b.z), c.z);
    if !L::REGISTERS {
        return beside | l.misses([zero, zero], zero, [far, lo], [near, hi]);
    }
    // The hit's z times the determinant, and the determinant, of which each product is a weight.
    let det = l.add_wide(l.add_wide(ab, bc), ca);
    let height = l.mul_add_wide(bc, a.z, l.mul_add_wide(ca, b.z, l.mul_wide(ab, c.z)));
    let sizes = l.add_wide(l.add_wide(l.abs_wide(ab), l.abs_wide(bc)), l.abs_wide(ca));
    let error = l.add_wide(error, error);
    let error = l.mul_add_wide(sizes, l.splat_wide(4.0 * f32::EPSILON), l.add_wide(error, error));
    let depth = l.max_wide(l.abs_wide(near), l.abs_wide(far));
    let size = l.abs_wide(det);
    let height = l.choose_wide(zero, det, height, l.sub_wide(zero, height));
    let tiny = l.splat_wide(TINY);
    let before = l.mul_add_wide(l.add_wide(depth, l.abs_wide(lo)), error, tiny);
    let behind = l.mul_add_wide(l.add_wide(depth, l.abs_wide(hi)), error, tiny);
    let before = l.sub_wide(l.sub_wide(l.mul_wide(lo, size), height), before);
    let behind = l.sub_wide(l.sub_wide(height, l.mul_wide(hi, size)), behind);
    let certain = l.sub_wide(size, error);
    let out = l.max_wide(before, behind);
    beside | l.misses([out, zero], certain, [far, lo], [near, hi])
}

/// Corners of triangles, sheared.
#[inline(always)]
fn shear<L: Lanes>(
    l: L,
    org: [L::Wide; 3],
    slope: [L::Wide; 2],
    [x, y, z]: [L::Wide; 3],
) -> Corner<L> {
    let z = l.sub_wide(z, org[2]);
    let x = l.less_product(l.sub_wide(x, org[0]), slope[0], z);
    let y = l.less_product(l.sub_wide(y, org[1]), slope[1], z);
    Corner { x, y, z, size: l.add_wide(l.abs_wide(x), l.abs_wide(y)) }
}

/// A corner of several triangles; `size` is |x| + |y|.
struct Corner<L: Lanes> {
    x: L::Wide,
    y: L::Wide,
    z: L::Wide,
    size: L::Wide,
}
