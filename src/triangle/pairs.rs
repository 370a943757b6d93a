//! Four rays and a triangle each, in lanes: what [`super::estimate`] finds of one.
//!
//! Differences, products and sums are as many as there, and fused operations leave roundings out:
//! the bounds of errors are the same. Nothing of the normal is fused: it is the same, bit for bit.

use super::estimate::E;
use super::four::Four;
use crate::arena::layout::Triangle;
use crate::ray::Ray;
use crate::simd::Lanes;

/// What four rays and a triangle each have to do with each other.
pub struct FourPairs<L: Lanes> {
    pub found: Four<L>,
    /// The triangles' normals along the axes.
    pub normal: [L::F32; 3],
    /// Of the rays.
    pub tmin: L::F64,
}

/// Four rows, lane by lane.
#[inline(always)]
fn columns<L: Lanes>(l: L, [a, b, c, d]: [&[f32; 4]; 4]) -> [L::F32; 4] {
    l.transpose([l.load_f32(a), l.load_f32(b), l.load_f32(c), l.load_f32(d)])
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

impl<L: Lanes> FourPairs<L> {
    #[inline(always)]
    pub fn new(l: L, rays: [&Ray; 4], triangles: [&Triangle; 4]) -> Self {
        let [a, b, c, d] = rays.map(Ray::rows);
        let [x, y, z, tmin] = columns(l, [&a[0], &b[0], &c[0], &d[0]]);
        let org = [l.widen(x), l.widen(y), l.widen(z)];
        let [x, y, z, _] = columns(l, [&a[1], &b[1], &c[1], &d[1]]);
        let dir = [l.widen(x), l.widen(y), l.widen(z)];
        let [a, b, c, d] = triangles.map(Triangle::rows);
        let corners = each!(k => columns(l, [a[k], b[k], c[k], d[k]]));
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
        let errors = [u_error, v_error, det_error];
        Self {
            found: Four::of(l, [u, v, det, height], errors, height_error),
            normal: each!(k => l.narrow(normal[k])),
            tmin: l.widen(tmin),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{AnyKernel, Isa, dispatch};
    use crate::triangle::Line;

    struct Decided<'a>([&'a Ray; 4], [&'a Triangle; 4]);

    /// Of each pair whether it is outside or inside for certain, then t, u, v and the normal.
    impl AnyKernel for Decided<'_> {
        type Out = [[Option<[f32; 6]>; 2]; 4];
        const BEST: Isa = Isa::Avx512;
        #[inline(always)]
        fn run_on<L: Lanes>(self, l: L) -> Self::Out {
            let FourPairs { found, normal, .. } = FourPairs::new(l, self.0, self.1);
            let [t, u, v] = [l.array_f32(found.t), l.array_f32(found.u), l.array_f32(found.v)];
            let [x, y, z] = each!(k => l.array_f32(normal[k]));
            let mut all = [[None; 2]; 4];
            for i in 0..4 {
                if found.outside >> i & 1 != 0 {
                    all[i][0] = Some([0.0; 6]);
                }
                if found.inside & found.weighed & 1 << i != 0 {
                    all[i][1] = Some([t[i], u[i], v[i], x[i], y[i], z[i]]);
                }
            }
            all
        }
    }

    /// Four different pairs at once are what each of them is by itself, signs of zeros included.
    #[test]
    fn each_is_its_own() {
        let mut state = 1u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let small = (state >> 40) as f32 / (1 << 24) as f32 - 0.5;
            // Some share coordinates, and some are zeros of either sign.
            [small, small, (small * 4.0).round() / 4.0][(state >> 33) as usize % 3]
        };
        let mut three = || [random(), random(), random()];
        let (mut certain, mut outside) = (0, 0);
        for _ in 0..5000 {
            let rays: [Ray; 4] = core::array::from_fn(|_| Ray::new(three(), three()));
            let triangles: [Triangle; 4] = core::array::from_fn(|i| {
                Triangle::new(&[three(), three(), three()], 0, i as u32, 1)
            });
            let [a, b, c, d] = &rays;
            let [p, q, r, s] = &triangles;
            let decided = dispatch(Decided([a, b, c, d], [p, q, r, s]));
            for ((ray, triangle), [out, hit]) in rays.iter().zip(&triangles).zip(decided) {
                let whole = Ray { tmin: f32::NEG_INFINITY, ..*ray };
                let line = Line::new(&whole);
                let met = line.meet(&line.apex(triangle), triangle, f32::INFINITY);
                if out.is_some() {
                    assert!(met.is_none(), "{ray:?} {triangle:?}");
                    outside += 1;
                }
                if let Some(numbers) = hit {
                    let met = met.expect("a hit");
                    let (u, v) = line.weights(triangle);
                    let [x, y, z] = crate::triangle::normal(triangle);
                    let expected = [met.t, u, v, x, y, z].map(f32::to_bits);
                    assert_eq!(numbers.map(f32::to_bits), expected, "{ray:?} {triangle:?}");
                    certain += 1;
                }
            }
        }
        assert!(certain > 500 && outside > 5000, "{certain} {outside}");
    }
}
