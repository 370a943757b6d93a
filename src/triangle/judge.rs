//! A line and a triangle in four lanes: what [`Estimate`](super::estimate) finds, in a third of
//! the operations.
//!
//! With `to` the way from the origin to the first corner, lanes are the vectors `to`, `e1`, `e2`
//! and `e1` again, axis by axis. Each times the next, `e1`, `e2`, `to` and `e2`, makes all cross
//! products at once; their products with `dir`, three times, and with `to` are `-v`, `-det`,
//! `-u` and `-height`. Differences, products and sums are as many as there, one after the other,
//! but for fused ones, which leave roundings out: so are the bounds of errors.

use super::estimate::{E, Range, Sides};
use super::{Line, sum};
use crate::arena::layout::Triangle;
use crate::simd::Lanes;

/// What a line and a triangle have to do with each other.
pub struct Judged<L: Lanes> {
    /// Of v, det, u and height: minus these, and bounds of their errors.
    minus: L::F64,
    errors: L::F64,
    det: f64,
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
    pub fn new(l: L, line: &Line, triangle: &Triangle) -> Self {
        let rows = triangle.rows();
        let row = each!(k => l.load_f32(rows[k]));
        let corners = each!(k => l.widen(l.permute(row[k], &[0, 1, 2, 1])));
        let first = each!(k => l.widen(l.permute(row[k], &[0; 4])));
        let from = each!(k => l.with_first(first[k], l.splat_f64(line.org[k])));
        let ways = each!(k => l.sub_f64(corners[k], from[k]));
        let next = each!(k => l.next_f64(ways[k]));
        let products = [
            l.cross_f64(ways[1], next[2], ways[2], next[1]),
            l.cross_f64(ways[2], next[0], ways[0], next[2]),
            l.cross_f64(ways[0], next[1], ways[1], next[0]),
        ];
        let with = each!(k => l.with_last(l.splat_f64(line.dir[k]), ways[k]));
        let minus = l.mul_f64(products[2], with[2]);
        let minus = l.mul_add_f64(products[1], with[1], minus);
        let minus = l.mul_add_f64(products[0], with[0], minus);
        let size = l.max_f64(l.abs_f64(ways[0]), l.abs_f64(ways[1]));
        let size = l.max_f64(size, l.abs_f64(ways[2]));
        let scale = l.splat_f64(20.0 * E * sum(&line.dir));
        let scale = l.with_last(scale, l.mul_f64(size, l.splat_f64(64.0 * E)));
        let errors = l.mul_f64(l.mul_f64(size, l.next_f64(size)), scale);
        let [v, det, u, _] = l.array_f64(minus);
        let [v_error, det_error, u_error, _] = l.array_f64(errors);
        let sides = Sides::of([-u, -v, -det], u_error + v_error + det_error);
        Self { minus, errors, det: -det, det_error, sides }
    }

    /// Whether the line comes from the side to which `e1 x e2` points, if it is inside.
    #[inline(always)]
    pub fn is_front(&self) -> bool {
        self.det > 0.0
    }

    /// Where the line meets the triangle, if it is inside: [`super::Estimate`] has the bound.
    #[inline(always)]
    pub fn place(&self, l: L) -> Place {
        let inverse = 1.0 / self.det;
        let quotients = l.mul_f64(self.minus, l.splat_f64(-inverse));
        let size = l.abs_f64(quotients);
        let errors = l.mul_add_f64(size, l.splat_f64(self.det_error), self.errors);
        let errors = l.mul_f64(errors, l.splat_f64(2.0 * inverse.abs()));
        let low = l.array_f32(l.narrow(l.sub_f64(quotients, errors)));
        let high = l.array_f32(l.narrow(l.add_f64(quotients, errors)));
        let known = self.det.abs() > 2.5 * self.det_error;
        let weights = known & (low[0] == high[0]) & (low[2] == high[2]);
        Place {
            t: Range { low: low[3], high: high[3] },
            // Adding +0 turns -0 into +0 and changes nothing else.
            weights: weights.then_some((low[2] + 0.0, low[0] + 0.0)),
        }
    }
}
