//! Four rays and a triangle each, in lanes: what [`super::estimate`] finds of one.
//!
//! Differences, products and sums are as many as there, and fused operations leave roundings out:
//! the bounds of errors are the same. Nothing of the normal is fused: it is the same, bit for bit.

use super::estimate::E;
use super::four::{Four, Quotient};
use crate::arena::layout::Triangle;
use crate::ray::Ray;
use crate::simd::Lanes;

/// What four rays and a triangle each have to do with each other.
pub struct Pairs<L: Lanes> {
    pub found: Four<L>,
    /// The triangles' normals along the axes.
    pub normal: [L::F32; 3],
    /// Of the rays.
    pub tmin: L::F64,
}

/// `a x b`, nothing of it fused.
#[inline(always)]
fn cross<L: Lanes>(l: L, a: [L::F64; 3], b: [L::F64; 3]) -> [L::F64; 3] {
    [
        l.sub_f64(l.mul_f64(a[1], b[2]), l.mul_f64(a[2], b[1])),
        l.sub_f64(l.mul_f64(a[2], b[0]), l.mul_f64(a[0], b[2])),
        l.sub_f64(l.mul_f64(a[0], b[1]), l.mul_f64(a[1], b[0])),
    ]
}

#[inline(always)]
fn dot<L: Lanes>(l: L, a: [L::F64; 3], b: [L::F64; 3]) -> L::F64 {
    l.mul_add_f64(a[0], b[0], l.mul_add_f64(a[1], b[1], l.mul_f64(a[2], b[2])))
}

#[inline(always)]
fn sizes<L: Lanes>(l: L, a: [L::F64; 3]) -> [L::F64; 3] {
    [l.abs_f64(a[0]), l.abs_f64(a[1]), l.abs_f64(a[2])]
}

/// The largest size of a component.
#[inline(always)]
fn largest<L: Lanes>(l: L, a: [L::F64; 3]) -> L::F64 {
    let [x, y, z] = sizes(l, a);
    l.max_f64(l.max_f64(x, y), z)
}

impl<L: Lanes> Pairs<L> {
    #[inline(always)]
    pub fn new(l: L, rays: [&Ray; 4], triangles: [&Triangle; 4]) -> Self {
        let row = |k: usize, i: usize| &rays[i].rows()[k];
        let [x, y, z, tmin] = l.transpose([
            l.load_f32(row(0, 0)),
            l.load_f32(row(0, 1)),
            l.load_f32(row(0, 2)),
            l.load_f32(row(0, 3)),
        ]);
        let org = [l.widen(x), l.widen(y), l.widen(z)];
        let [x, y, z, _] = l.transpose([
            l.load_f32(row(1, 0)),
            l.load_f32(row(1, 1)),
            l.load_f32(row(1, 2)),
            l.load_f32(row(1, 3)),
        ]);
        let dir = [l.widen(x), l.widen(y), l.widen(z)];
        let row = |k: usize, i: usize| triangles[i].rows()[k];
        let corners = each!(k => l.transpose([
            l.load_f32(row(k, 0)),
            l.load_f32(row(k, 1)),
            l.load_f32(row(k, 2)),
            l.load_f32(row(k, 3)),
        ]));
        let first = each!(k => l.widen(corners[k][0]));
        let to = each!(k => l.sub_f64(first[k], org[k]));
        let e1 = each!(k => l.sub_f64(l.widen(corners[k][1]), first[k]));
        let e2 = each!(k => l.sub_f64(l.widen(corners[k][2]), first[k]));
        let normal = cross(l, e1, e2);
        let zero = l.splat_f64(0.0);
        let u = dot(l, dir, cross(l, to, e2));
        let v = l.sub_f64(zero, dot(l, dir, cross(l, to, e1)));
        let det = l.sub_f64(zero, dot(l, dir, normal));
        let height = l.sub_f64(zero, dot(l, to, normal));
        let [x, y, z] = sizes(l, dir);
        let size = l.mul_f64(l.add_f64(l.add_f64(x, y), z), l.splat_f64(20.0 * E));
        let [m0, m1, m2] = [largest(l, to), largest(l, e1), largest(l, e2)];
        let area = l.mul_f64(m1, m2);
        let det_error = l.mul_f64(area, size);
        let near = l.mul_f64(m0, size);
        let (u_error, v_error) = (l.mul_f64(near, m2), l.mul_f64(near, m1));
        let height_error = l.mul_f64(l.mul_f64(m0, area), l.splat_f64(64.0 * E));
        let error = l.add_f64(l.add_f64(u_error, v_error), det_error);
        let w = l.sub_f64(l.sub_f64(det, u), v);
        let lowest = l.min_f64(l.min_f64(u, v), w);
        let highest = l.max_f64(l.max_f64(u, v), w);
        let inside = l.above_f64(l.max_f64(lowest, l.sub_f64(zero, highest)), error);
        let outside = l.above_f64(l.min_f64(l.sub_f64(zero, lowest), highest), error);
        let inverse = l.div_f64(l.splat_f64(1.0), det);
        let twice = l.abs_f64(l.add_f64(inverse, inverse));
        let quotient = Quotient { inverse, twice, det_error };
        let (t, t_known) = quotient.of(l, height, height_error);
        let (u, u_known) = quotient.of(l, u, u_error);
        let (v, v_known) = quotient.of(l, v, v_error);
        let known = l.above_f64(l.abs_f64(det), l.mul_f64(det_error, l.splat_f64(2.5)));
        let front = l.above_f64(det, zero);
        let (inside, weighed) = (inside & t_known, u_known & v_known & known);
        Self {
            found: Four { outside, inside, weighed, front, t, u, v },
            normal: each!(k => l.narrow(normal[k])),
            tmin: l.widen(tmin),
        }
    }
}
