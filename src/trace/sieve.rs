//! A first look at a few triangles, in `f32`: out for certain, or worth deciding?
//!
//! Triangles are sheared so that the ray becomes a coordinate axis (Woop, Benthin &
//! Wald 2013); a triangle is out if the ray passes two of its edges on opposite sides
//! by more than the error bound, or if the place where the ray meets it is out of range. A hit
//! is never out.
//!
//! Edges: with e = 2^-24, the slope and the difference z are off by e of their own, the
//! difference x by e (|x| + |z|), as slopes are 1 at most, and the product and the sum round
//! once more: a sheared coordinate is off by `e (2 |x| + 4 |z|)`. With S the sum of all
//! corners' |x| + |y|, Z the largest |z| and F = S + 2 Z, that is less than d = 2.25 e F. An edge
//! product is then off by at most d times the sum of its corners' |x| + |y|, 2 d^2, and `e S^2 / 2`
//! for its own roundings, so by less than `1.3 d S + 2 d^2`; the bound used is
//! `3 e F (S + 5 e F)`, call it E, which is `1.33 d S + 2.96 d^2`. A fused multiply-add only leaves
//! roundings out.
//!
//! Range: edge products are weights of the place that the ray meets, so its z is `height`, the
//! sum of their products with the corners' z, over their sum, `det`. Each corner is in two
//! products: they are off by `2.25 E` together. With U the sum of their sizes, det is off by at
//! most `2.25 E + 3 e U`, and `height - end det` by `(2.25 E + 5 e U) (Z + |end|)`. Where the edges
//! leave a doubt, U is at most `|det| + 4 E`; used are B = `2.5 E + 5.5 e |det|` for det and 2 Z B for
//! the other, as if |end| were no more than Z. Where it is more, either the whole triangle is out
//! of range, or `height - end det` is at most `Z (U - |det|)` and its roundings, less than the bound.
//! Signs are turned so that det is positive and z grows with t: it is the depth.
//!
//! 2^-100 is added to E and to the other bound for what underflows: of scenes less than some
//! 1e-10 long little is out. An infinite end makes infinities and NaN, which are never out. Of
//! scenes so large that products leave the range of `f32` nothing is out either, but what is by z.
//!
//! A hit is certain if the ray passes all edges on one side by more than E, and the place is in
//! range by more than these bounds doubled, which leaves room for the roundings of the comparisons:
//! `height + 2 Z B < end det - 2 B |end|`, and the other end likewise. Ends are then moved inward by
//! four times as much as they had been moved outward.
//!
//! Where lanes are arrays, only the corners' own z are held against the range: they are off by a
//! rounding each, for which its ends have room.

mod sieved;

use super::counters::Count;
use crate::arena::layout::Triangle;
use crate::arena::{Axis, Order, Sections};
use crate::ray::Ray;
use crate::simd::Lanes;

use super::bounds::splat3;
use super::query::{allowance, visible};
pub(super) use sieved::Sieved;

/// Distances below which products of three sheared coordinates stay in the range of `f32`.
pub(super) const FARTHEST: f32 = 1e12;

/// 2^-100.
pub(super) const TINY: f32 = 1.0 / (1u128 << 100) as f32;

/// e of the bounds.
pub(super) const E: f32 = f32::EPSILON / 2.0;

/// A ray made ready for sieving triangles.
#[derive(Clone, Copy)]
pub struct Sieve<'a> {
    /// The triangles along the axes that are x, y, z of the sheared space.
    axes: [Axis<'a>; 3],
    /// The origin along these axes; the change of x and of y with z, and what is added to E;
    /// the range of the depth, which is z in the ray's direction, where t is in range, and the sign
    /// of the depth of what has negative z.
    rows: [[f32; 4]; 3],
    /// The depth for each t, and what is added to the ends of its range.
    pace: f32,
    slack: f32,
}

/// Triangles to sieve in one go. As many everywhere where tests are counted: a walk may
/// end with any of them.
pub(super) const fn chunk<C: Count, L: Lanes>() -> usize {
    if C::COUNTS { 4 } else { L::WIDE }
}

/// For each set of axes along which a direction is longest, a bit each: one of
/// them third, the others before.
static ORDER: [Order; 8] = {
    let [x, y, z] = Order::THIRD;
    [z, x, y, x, z, x, y, x]
};

/// Whether what the ray has to do with is near enough: no farther from the origin, along an
/// axis, than [`FARTHEST`]. `lo` and `hi` are the corners of the scene's box; fourth lanes mean
/// nothing.
#[inline(always)]
pub(super) fn holds<L: Lanes>(l: L, org: L::F32, [lo, hi]: [L::F32; 2]) -> bool {
    l.first(l.highest(l.max_f32(l.sub_f32(hi, org), l.sub_f32(org, lo)))) < FARTHEST
}

impl<'a> Sieve<'a> {
    /// `org` and `dir` are the ray's; fourth lanes mean nothing. What does not [`hold`](holds) is
    /// out by z at most.
    #[inline(always)]
    pub fn new<L: Lanes>(
        l: L,
        sections: &Sections<'a>,
        ray: &Ray,
        [org, dir]: [L::F32; 2],
        holds: bool,
    ) -> Self {
        let size = l.abs_f32(dir);
        let order = &ORDER[l.equals(size, l.highest(size)) as usize];
        let (org, dir) = (l.permute(org, &order.lanes), l.permute(dir, &order.lanes));
        let longest = l.permute(dir, &[2; 4]);
        let slope = l.div_f32(dir, longest);
        let mut rows = [l.array_f32(org), l.array_f32(slope), [0.0; 4]];
        rows[1][2] = if holds { TINY } else { f32::INFINITY };
        let pace = l.first(longest).abs();
        // A t next to zero may have been rounded by up to half the least denormal. Not
        // just that much: processors take long to compute denormals.
        let slack = TINY + pace * TINY;
        let axes = sections.axes(order);
        rows[2][2] = -l.first(longest);
        let mut sieve = Self { axes, rows, pace, slack };
        let first = ray.tmin * pace;
        sieve.rows[2][0] = first - sieve.room(l, first);
        sieve.limit(l, ray.tmax);
        sieve
    }

    /// What is added to the depth at t, as a corner's z is off by one rounding, and so is this.
    #[inline(always)]
    fn room<L: Lanes>(&self, l: L, depth: f32) -> f32 {
        allowance(l, depth, 4.0 * f32::EPSILON, self.slack)
    }

    /// Sets the largest t of interest.
    #[inline(always)]
    pub fn limit<L: Lanes>(&mut self, l: L, limit: f32) {
        let last = limit * self.pace;
        self.rows[2][1] = last + self.room(l, last);
    }

    /// One bit for each of at most [`Lanes::WIDE`] triangles, from references, that
    /// the ray may meet in range.
    #[inline(always)]
    pub fn pass<L: Lanes>(&self, l: L, refs: &[u32]) -> u32 {
        // One alone is decided nearly as soon as it is sieved.
        if refs.len() == 1 { 1 } else { self.few(l, refs).0 }
    }

    /// [`Sieve::pass`], and all that was found.
    #[inline(always)]
    pub fn few<L: Lanes>(&self, l: L, refs: &[u32]) -> (u32, Sieved<L>) {
        let all = (1u32 << refs.len()) - 1;
        let rows = l.thrice(refs);
        let [x, y, z] = &self.axes;
        let triangles = [
            l.columns(|i| x.row(rows[i])),
            l.columns(|i| y.row(rows[i])),
            l.columns(|i| z.row(rows[i])),
        ];
        let [org, slope, range] = &self.rows;
        let rays = [splat3(l, org), splat3(l, slope), splat3(l, range)];
        let sieved = Sieved::new(l, rays, triangles);
        (all & !sieved.out, sieved)
    }

    /// [`Lanes::WIDE`] triangles, from number `first` on.
    #[inline(always)]
    pub fn run<L: Lanes>(&self, l: L, first: u32) -> Sieved<L> {
        let [x, y, z] = &self.axes;
        let triangles = [
            l.columns(|i| x.row(3 * (first + i as u32))),
            l.columns(|i| y.row(3 * (first + i as u32))),
            l.columns(|i| z.row(3 * (first + i as u32))),
        ];
        let [org, slope, range] = &self.rows;
        let rays = [splat3(l, org), splat3(l, slope), splat3(l, range)];
        Sieved::new(l, rays, triangles)
    }

    /// That of some of these triangles, a bit each, which the ray seems to meet first: exact tests
    /// of the others may then be spared.
    #[inline(always)]
    pub fn first<L: Lanes>(&self, l: L, sieved: &Sieved<L>, among: u32) -> u32 {
        let mut first = among.trailing_zeros();
        let mut others = among & among.wrapping_sub(1);
        if let (Some(place), true) = (&sieved.place, others != 0) {
            let mut depths = [0.0; 8];
            l.store_wide(l.div_wide(place.height, place.det), &mut depths);
            while others != 0 {
                let other = others.trailing_zeros();
                others &= others - 1;
                if depths[other as usize % 8] < depths[first as usize % 8] {
                    first = other;
                }
            }
        }
        first
    }

    /// One bit for each of these triangles that the ray may meet in range as it is by now, if it
    /// was so before.
    #[inline(always)]
    pub fn again<L: Lanes>(&self, l: L, sieved: &Sieved<L>) -> u32 {
        let [lo, hi, ..] = self.rows[2];
        match &sieved.place {
            Some(place) => !place.out(l, [l.splat_wide(lo), l.splat_wide(hi)]),
            None => u32::MAX,
        }
    }

    /// Whether the ray certainly hits one of these triangles: of those that `passed` has a bit for. It
    /// is the ray that this sieve is of, and [`Sieve::limit`] has not been called since.
    #[inline(always)]
    pub fn hits<L: Lanes>(
        &self,
        l: L,
        ray: &Ray,
        sieved: &Sieved<L>,
        passed: u32,
        triangle: impl Fn(usize) -> &'a Triangle,
    ) -> bool {
        let Some(place) = &sieved.place else { return false };
        let [lo, hi, ..] = self.rows[2];
        // An end that is infinite on the wrong side is NaN.
        let known = lo <= hi;
        if passed == 0 || ray.flags != 0 || !known {
            return false;
        }
        // All that a sieve that holds meets is nearer than ten times `FARTHEST`, so a range that
        // ends behind that may as well end there, and products stay below infinity. Nor may it
        // end behind the largest t there is.
        let most = (self.pace * f32::MAX).min(10.0 * FARTHEST);
        let inside = |end: f32| {
            let end = if end < most { end } else { most };
            end - (end.abs() * (16.0 * f32::EPSILON) + 4.0 * self.slack)
        };
        let mut left = passed & place.certain(l, sieved.edges, [-inside(-lo), inside(hi)]);
        while left != 0 {
            if visible(ray, triangle(left.trailing_zeros() as usize)) {
                return true;
            }
            left &= left - 1;
        }
        false
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
        Sieved::new(l, rays, triangles).out ^ (u32::MAX >> (32 - L::WIDE))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arena::View;
    use crate::simd::{AnyKernel, Isa, dispatch};
    use crate::{Geometry, Options, Scene};
    use std::vec::Vec;

    /// Whether a ray certainly hits one of the first four triangles; `None` where none can tell.
    struct Certain<'a>(&'a View<'a>, &'a Ray);

    impl AnyKernel for Certain<'_> {
        type Out = Option<bool>;
        const BEST: Isa = Isa::Avx512;
        #[inline(always)]
        fn run_on<L: Lanes>(self, l: L) -> Option<bool> {
            let Self(view, ray) = self;
            let ([org, dir, _], sections) = (ray.rows(), view.sections());
            let sieve = Sieve::new(l, &sections, ray, [l.load3(org), l.load3(dir)], true);
            let (passed, sieved) = sieve.few(l, &[0, 1, 2, 3]);
            let triangle = |i: usize| sections.triangle(i as u32);
            L::REGISTERS.then(|| sieve.hits(l, ray, &sieved, passed, triangle))
        }
    }

    /// What is well inside is certain, and nothing else is: not at an edge, at the ends of the
    /// range, beside, or of triangles that the ray does not see.
    #[test]
    fn what_is_certain() {
        let vertices: Vec<[f32; 3]> = (0..4)
            .map(|i| i as f32)
            .flat_map(|x| [[x, 0.0, 3.0], [x + 0.5, 0.0, 3.0], [x, 0.5, 3.0]])
            .collect();
        let indices = [[0, 1, 2], [3, 4, 5], [6, 7, 8], [9, 10, 11]];
        let mesh = [Geometry::from_mesh(&vertices, &indices)];
        let scene = Scene::build(&mesh, &Options::default());
        let scene = scene.expect("the soup is valid");
        let view = scene.view();
        let ray = |x: f32, y: f32| Ray::new([x, y, 0.0], [0.0, 0.0, 1.0]);
        let certain = |ray: &Ray| dispatch(Certain(&view, ray)).unwrap_or(view.occluded(ray));
        for i in 0..4 {
            let x = i as f32;
            let inside = ray(x + 0.1, 0.1);
            assert!(certain(&inside));
            assert!(certain(&inside.with_range(2.999, 3.001)));
            assert!(certain(&Ray { tmin: f32::NEG_INFINITY, tmax: f32::MAX, ..inside }));
            assert!(!certain(&inside.with_range(0.0, 2.999)));
            assert!(!certain(&inside.with_range(3.001, f32::INFINITY)));
            assert!(!certain(&Ray { mask: 0, ..inside }));
            assert!(!certain(&ray(x + 0.4, 0.4)));
            // These do hit, but that is for the exact test to say.
            for open in [
                ray(x + 0.2, 0.0),
                inside.with_range(0.0, 3.0),
                inside.with_range(3.0, 4.0),
                Ray { flags: Ray::CULL_BACK | Ray::CULL_FRONT, ..inside },
            ] {
                assert!(dispatch(Certain(&view, &open)) != Some(true), "{open:?}");
            }
        }
    }
}
