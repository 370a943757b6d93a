//! What a sieve finds out about several triangles: the arithmetic that [`super`] has the bounds of.

use super::{E, TINY};
use crate::simd::Lanes;

/// Coordinates of several triangles: axis by axis those of the corners.
pub type Triangles<L> = [[<L as Lanes>::Wide; 3]; 3];

/// What a sieve finds.
#[derive(Clone, Copy)]
pub struct Sieved<L: Lanes> {
    /// One bit for each triangle that its ray misses.
    pub out: u32,
    /// By how much rays pass all edges on one side at least, and the bound of the error.
    pub edges: [L::Wide; 2],
    /// Where lanes are registers.
    pub place: Option<Place<L>>,
}

/// Where rays meet triangles that they do not pass: the depth times the determinant's size, that,
/// and bounds of their errors.
#[derive(Clone, Copy)]
pub struct Place<L: Lanes> {
    pub height: L::Wide,
    pub det: L::Wide,
    height_error: L::Wide,
    det_error: L::Wide,
}

impl<L: Lanes> Sieved<L> {
    /// That of triangles which all rays miss.
    #[inline(always)]
    pub fn none(l: L) -> Self {
        let zero = l.splat_wide(0.0);
        let place = Place { height: zero, det: zero, height_error: zero, det_error: zero };
        Self { out: u32::MAX, edges: [zero; 2], place: Some(place) }
    }

    /// `rays` are in the order of [`super::Sieve`]'s rows.
    #[inline(always)]
    pub fn new(l: L, rays: Triangles<L>, [xs, ys, zs]: Triangles<L>) -> Self {
        let [org, [sx, sy, tiny], [lo, hi, sign]] = rays;
        let slope = [sx, sy];
        let a = shear(l, org, slope, [xs[0], ys[0], zs[0]]);
        let b = shear(l, org, slope, [xs[1], ys[1], zs[1]]);
        let c = shear(l, org, slope, [xs[2], ys[2], zs[2]]);
        let ab = l.cross_wide(a.x, b.y, a.y, b.x);
        let bc = l.cross_wide(b.x, c.y, b.y, c.x);
        let ca = l.cross_wide(c.x, a.y, c.y, a.x);
        let size = l.add_wide(l.add_wide(a.size, b.size), c.size);
        let depth = l.max_wide(l.max_wide(l.abs_wide(a.z), l.abs_wide(b.z)), l.abs_wide(c.z));
        let twice = l.add_wide(depth, depth);
        let far = l.add_wide(size, twice);
        let error = l.mul_wide(far, l.splat_wide(3.0 * E));
        let error = l.mul_add_wide(error, l.mul_add_wide(far, l.splat_wide(5.0 * E), size), tiny);
        let most = l.max_wide(l.max_wide(ab, bc), ca);
        let least = l.min_wide(l.min_wide(ab, bc), ca);
        let zero = l.splat_wide(0.0);
        let beside = [l.min_wide(most, l.sub_wide(zero, least)), error];
        let edges = [l.max_wide(least, l.sub_wide(zero, most)), error];
        if !L::REGISTERS {
            let [a, b, c] = [a.z, b.z, c.z];
            let [a, b, c] = [l.turn_wide(a, sign), l.turn_wide(b, sign), l.turn_wide(c, sign)];
            let near = l.min_wide(l.min_wide(a, b), c);
            let far = l.max_wide(l.max_wide(a, b), c);
            let apart = l.max_wide(l.sub_wide(near, hi), l.sub_wide(lo, far));
            let out = l.misses(beside, [apart, zero], [l.splat_wide(1.0), zero]);
            return Self { out, edges, place: None };
        }
        let det = l.add_wide(l.add_wide(ab, bc), ca);
        let height = l.mul_add_wide(bc, a.z, l.mul_add_wide(ca, b.z, l.mul_wide(ab, c.z)));
        let height = l.turn_wide(l.turn_wide(height, det), sign);
        let det = l.abs_wide(det);
        // In this order the error, which is known last, is waited for once.
        let of_det = l.mul_wide(det, l.splat_wide(5.5 * E));
        let det_error = l.mul_add_wide(error, l.splat_wide(2.5), of_det);
        let height_error = l.mul_add_wide(twice, det_error, l.splat_wide(TINY));
        let place = Place { height, det, height_error, det_error };
        Self { out: place.out_or(l, beside, [lo, hi]), edges, place: Some(place) }
    }
}

impl<L: Lanes> Place<L> {
    /// One bit for each that is out of range, or in which `a > b`.
    #[inline(always)]
    fn out_or(&self, l: L, ab: [L::Wide; 2], [lo, hi]: [L::Wide; 2]) -> u32 {
        let before = l.product_less(lo, self.det, self.height);
        let behind = l.less_product(self.height, hi, self.det);
        let beyond = [l.max_wide(before, behind), self.height_error];
        l.misses(ab, beyond, [self.det, self.det_error])
    }

    /// One bit for each in which `a > b` and that is in range for certain.
    #[inline(always)]
    pub fn certain(&self, l: L, ab: [L::Wide; 2], [lo, hi]: [f32; 2]) -> u32 {
        let twice = l.add_wide(self.det_error, self.det_error);
        let least =
            l.mul_add_wide(self.det, l.splat_wide(lo), l.mul_wide(twice, l.splat_wide(lo.abs())));
        let most =
            l.less_product(l.mul_wide(self.det, l.splat_wide(hi)), twice, l.splat_wide(hi.abs()));
        let [near, far] = [
            l.sub_wide(self.height, self.height_error),
            l.add_wide(self.height, self.height_error),
        ];
        let room = l.min_wide(l.sub_wide(near, least), l.sub_wide(most, far));
        let zero = l.splat_wide(0.0);
        let size = l.sub_wide(self.det, twice);
        l.misses([zero, zero], ab, [l.min_wide(room, size), zero])
    }

    /// One bit for each that is out of range.
    #[inline(always)]
    pub fn out(&self, l: L, range: [L::Wide; 2]) -> u32 {
        self.out_or(l, [self.det, self.det], range)
    }
}

/// Corners of triangles, sheared, all coordinates negated.
#[inline(always)]
fn shear<L: Lanes>(
    l: L,
    org: [L::Wide; 3],
    slope: [L::Wide; 2],
    [x, y, z]: [L::Wide; 3],
) -> Corner<L> {
    let z = l.sub_wide(org[2], z);
    let x = l.less_product(l.sub_wide(org[0], x), slope[0], z);
    let y = l.less_product(l.sub_wide(org[1], y), slope[1], z);
    Corner { x, y, z, size: l.add_wide(l.abs_wide(x), l.abs_wide(y)) }
}

/// A corner of several triangles; `size` is |x| + |y|.
struct Corner<L: Lanes> {
    x: L::Wide,
    y: L::Wide,
    z: L::Wide,
    size: L::Wide,
}
