//! A ray and a triangle in four lanes: what [`Estimate`](super::estimate) finds, in a third of
//! the operations.
//!
//! With `to` the way from the origin to the first corner, lanes are the vectors `e1`, `e2`, `to`
//! and `e1` again, axis by axis. Each times the next, `e2`, `to`, `e1` and `e2`, makes all cross
//! products at once, the first of which is the normal; their products with `dir`, three times, and
//! with `to` are `-det`, `-u`, `-v` and `-height`. Differences, products and sums are as many as
//! there, one after the other, but for fused sums, which leave roundings out: so are the bounds of
//! errors. Nothing of the normal is fused: it is the same, bit for bit.

use super::estimate::{E, Range, Sides};
use crate::arena::layout::Triangle;
use crate::ray::Ray;
use crate::simd::Lanes;

/// What a ray's line and a triangle have to do with each other.
pub struct Judged<L: Lanes> {
    /// `e1 x e2`, in the first lanes.
    products: [L::F64; 3],
    /// Minus det, u, v and height, and bounds of their errors.
    minus: L::F64,
    errors: L::F64,
    minus_det: f64,
    det_error: f64,
    pub sides: Sides,
}

/// Bounds of t, and the weights if their rounding is certain.
pub struct Place {
    pub t: Range,
    pub weights: Option<(f32, f32)>,
}

impl<L: Lanes> Judged<L> {
    #[inline(always)]
    pub fn new(l: L, ray: &Ray, triangle: &Triangle) -> Self {
        let rows = triangle.rows();
        let row = each!(k => l.load_f32(rows[k]));
        let ends = each!(k => l.widen(l.permute(row[k], &[1, 2, 0, 1])));
        let org = each!(k => l.splat_f32(ray.org[k]));
        let from = each!(k => l.widen(l.with_third(l.splat_f32(rows[k][0]), org[k])));
        let ways = each!(k => l.sub_f64(ends[k], from[k]));
        let next = each!(k => l.next_f64(ways[k]));
        let products = [
            l.sub_f64(l.mul_f64(ways[1], next[2]), l.mul_f64(ways[2], next[1])),
            l.sub_f64(l.mul_f64(ways[2], next[0]), l.mul_f64(ways[0], next[2])),
            l.sub_f64(l.mul_f64(ways[0], next[1]), l.mul_f64(ways[1], next[0])),
        ];
        let dir = each!(k => l.widen(l.splat_f32(ray.dir[k])));
        let with = each!(k => l.with_last(dir[k], ways[k]));
        let minus = l.mul_f64(products[2], with[2]);
        let minus = l.mul_add_f64(products[1], with[1], minus);
        let minus = l.mul_add_f64(products[0], with[0], minus);
        let size = l.max_f64(l.abs_f64(ways[0]), l.abs_f64(ways[1]));
        let size = l.max_f64(size, l.abs_f64(ways[2]));
        let scale = l.add_f64(l.add_f64(l.abs_f64(dir[0]), l.abs_f64(dir[1])), l.abs_f64(dir[2]));
        let scale = l.mul_f64(scale, l.splat_f64(20.0 * E));
        let scale = l.with_last(scale, l.mul_f64(size, l.splat_f64(64.0 * E)));
        let errors = l.mul_f64(l.mul_f64(size, l.next_f64(size)), scale);
        let [minus_det, minus_u, minus_v, _] = l.array_f64(minus);
        let [det_error, u_error, v_error, _] = l.array_f64(errors);
        // On which side of all edges does not matter, so neither do their signs.
        let sides = Sides::of([minus_u, minus_v, minus_det], u_error + v_error + det_error);
        Self { products, minus, errors, minus_det, det_error, sides }
    }

    /// Whether the line comes from the side to which `e1 x e2` points, if it is inside.
    #[inline(always)]
    pub fn is_front(&self) -> bool {
        self.minus_det < 0.0
    }

    /// Where the line meets the triangle, if it is inside: [`super::Estimate`] has the bound.
    #[inline(always)]
    pub fn place(&self, l: L) -> Place {
        let inverse = 1.0 / self.minus_det;
        let quotients = l.mul_f64(self.minus, l.splat_f64(inverse));
        let size = l.abs_f64(quotients);
        let errors = l.mul_add_f64(size, l.splat_f64(self.det_error), self.errors);
        let errors = l.mul_f64(errors, l.splat_f64(2.0 * inverse.abs()));
        let low = l.array_f32(l.narrow(l.sub_f64(quotients, errors)));
        let high = l.array_f32(l.narrow(l.add_f64(quotients, errors)));
        let known = self.minus_det.abs() > 2.5 * self.det_error;
        let weights = known & (low[1] == high[1]) & (low[2] == high[2]);
        Place {
            t: Range { low: low[3], high: high[3] },
            // Adding +0 turns -0 into +0 and changes nothing else.
            weights: weights.then_some((low[1] + 0.0, low[2] + 0.0)),
        }
    }

    /// [`super::normal`].
    #[inline(always)]
    pub fn normal(&self, l: L) -> [f32; 3] {
        each!(k => l.array_f64(self.products[k])[0] as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{AnyKernel, Isa, dispatch};

    struct Normal<'a>(&'a Triangle);

    impl AnyKernel for Normal<'_> {
        type Out = [f32; 3];
        const BEST: Isa = Isa::Avx512;
        #[inline(always)]
        fn run_on<L: Lanes>(self, l: L) -> [f32; 3] {
            let ray = Ray::new([0.3, -7.0, 1e3], [0.1, 0.2, -1.0]);
            Judged::new(l, &ray, self.0).normal(l)
        }
    }

    /// With the signs of zeros: of triangles in the planes of axes, of no area, and of others.
    #[test]
    fn normals_are_those_of_triangles() {
        let numbers = [0.0, -0.0, 1.0, -2.5, 0.1, 1e-30, 3e7];
        let corner = |i: usize| [numbers[i % 7], numbers[i / 7 % 7], numbers[i / 49]];
        for i in 0..343 {
            for j in 0..343 {
                let corners = [corner(i), corner(j), corner((i * 31 + j * 7) % 343)];
                let triangle = Triangle::new(&corners, 0, 0, 1);
                let expected = crate::triangle::normal(&triangle);
                let computed = dispatch(Normal(&triangle));
                let bits = |normal: [f32; 3]| normal.map(f32::to_bits);
                assert_eq!(bits(computed), bits(expected), "{corners:?}");
            }
        }
    }
}
