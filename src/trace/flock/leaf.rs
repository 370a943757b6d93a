//! The rays of a list and the triangles of a leaf: which may hit which, in `f32`.
//!
//! Lanes are rays. What is computed is what `triangle::estimate` computes in `f64`, and so are the
//! bounds of its errors, with e = 2^-24: no sums are of more terms, and of dir . (to x e2) it makes no
//! difference which two of the three vectors are multiplied first. 2^-100 is added for what
//! underflows: a scene with a tree is no larger than 2^28, a ray there no farther from it than 2^38
//! and its direction no longer than 2^20, so a product of two that underflows is off by 2^-150 and
//! comes to less than 2^-108 with the third, and nothing overflows.
//!
//! A ray is out if it passes two edges on opposite sides for certain, or if, for certain of which
//! sign the determinant is, the height is out of range: it is the product of t with the determinant.
//! A t in range may have been rounded to an end by e of itself, or by half the least denormal. For the
//! first, and the roundings of products with the ends, 8 e of these are left; for the second 2^-100
//! is added to the size of the one end, of which 8 e are 2^-121, and the other has been moved by
//! more (`descent`). An end that is infinite leaves no ray out.

use super::super::packet::largest;
use super::super::query::Query;
use super::super::sieve::{E, TINY};
use super::boxes::eight;
use super::{Flocking, RAYS};
use crate::arena::node::{LEAF, LEAF_SHIFT, NODE};
use crate::simd::Lanes;

/// Triangles of a leaf, a column each: first corner, edges from there, normal, and the bounds of
/// errors but for what depends on the ray: of all weights together, what is multiplied with the
/// distance and what is not, which is the determinant's; and of the height.
#[repr(align(64))]
pub struct Leaf([[f32; LEAF as usize]; 15]);

impl Leaf {
    pub const NONE: Self = Self([[0.0; LEAF as usize]; 15]);
}

/// Rays of a list.
struct Rays<L: Lanes> {
    org: [L::Wide; 3],
    dir: [L::Wide; 3],
    /// The sum of the direction's sizes.
    size: L::Wide,
    /// The range of t, and the sizes of its ends, or a little more.
    ends: [L::Wide; 2],
    sizes: [L::Wide; 2],
}

impl<Q: Query, L: Lanes> Flocking<'_, '_, '_, Q, L> {
    /// Meets the triangles of a leaf.
    #[inline(always)]
    pub(super) fn leaf(&mut self, part: u32, count: usize) {
        let (first, triangles) = (part >> LEAF_SHIFT, part & NODE);
        self.look_up(first);
        self.lists.fill_up(count, L::WIDE);
        let mut at = 0;
        while at < count {
            let rays = self.rays(at);
            let there = u32::MAX >> (32 - (count - at).min(L::WIDE));
            let mut passed = [0; LEAF as usize];
            for (i, passed) in passed.iter_mut().enumerate().take(triangles as usize) {
                *passed = !self.out(&rays, i) & there;
            }
            for (i, mut passed) in (0..triangles).zip(passed) {
                while passed != 0 {
                    let ray = self.lists.rays[(at + passed.trailing_zeros() as usize) % RAYS];
                    passed &= passed - 1;
                    self.decide_later([ray, first + i]);
                }
            }
            at += L::WIDE;
        }
    }

    /// Looks up triangles, from number `first` on, of which there may be fewer.
    #[inline(always)]
    fn look_up(&mut self, first: u32) {
        let l = self.l;
        let axes = each!(k => self.sections.axis(k));
        let at = each!(k => l.columns(|i| axes[k].row(3 * (first + i as u32))));
        let e1 = each!(k => l.sub_wide(at[k][1], at[k][0]));
        let e2 = each!(k => l.sub_wide(at[k][2], at[k][0]));
        let normal = cross(l, e1, e2);
        let (m1, m2) = (largest(l, e1), largest(l, e2));
        let area = l.mul_wide(m1, m2);
        let Leaf(rows) = &mut *self.leaf;
        l.store_wide(at[0][0], &mut rows[0]);
        l.store_wide(at[1][0], &mut rows[1]);
        l.store_wide(at[2][0], &mut rows[2]);
        l.store_wide(e1[0], &mut rows[3]);
        l.store_wide(e1[1], &mut rows[4]);
        l.store_wide(e1[2], &mut rows[5]);
        l.store_wide(e2[0], &mut rows[6]);
        l.store_wide(e2[1], &mut rows[7]);
        l.store_wide(e2[2], &mut rows[8]);
        l.store_wide(normal[0], &mut rows[9]);
        l.store_wide(normal[1], &mut rows[10]);
        l.store_wide(normal[2], &mut rows[11]);
        let twenty = l.splat_wide(20.0 * E);
        l.store_wide(l.mul_wide(l.add_wide(m1, m2), twenty), &mut rows[12]);
        l.store_wide(l.mul_wide(area, twenty), &mut rows[13]);
        l.store_wide(l.mul_wide(area, l.splat_wide(64.0 * E)), &mut rows[14]);
    }

    /// Rays of the list that was taken, from number `at` on.
    #[inline(always)]
    fn rays(&self, at: usize) -> Rays<L> {
        let l = self.l;
        let ids: &[u32; 8] = eight(&self.lists.rays, at);
        let rows = |i: usize| self.members[ids[i] as usize].ray.rows();
        let [x, y, z, lo] = l.four_columns(|i| &rows(i)[0]);
        let dir = l.columns(|i| &rows(i)[1]);
        let sizes = each!(k => l.abs_wide(dir[k]));
        let to = l.load_wide(eight(&self.lists.ends, at));
        let hi = l.mul_wide(to, l.splat_wide(self.inverse));
        Rays {
            org: [x, y, z],
            dir,
            size: l.add_wide(l.add_wide(sizes[0], sizes[1]), sizes[2]),
            ends: [lo, hi],
            sizes: [l.add_wide(l.abs_wide(lo), l.splat_wide(TINY)), l.abs_wide(hi)],
        }
    }

    /// One bit for each of these rays that misses triangle `i`.
    #[inline(always)]
    fn out(&self, rays: &Rays<L>, i: usize) -> u32 {
        let (l, Leaf(rows)) = (self.l, &*self.leaf);
        let Rays { org, dir, size, ends: [lo, hi], sizes: [lo_size, hi_size] } = rays;
        let zero = l.splat_wide(0.0);
        let to = each!(k => l.sub_wide(splat(l, rows, k, i), org[k]));
        let m0 = largest(l, to);
        let side = cross(l, *dir, to);
        let u = dot(l, side, each!(k => splat(l, rows, 6 + k, i)));
        let v = l.sub_wide(zero, dot(l, side, each!(k => splat(l, rows, 3 + k, i))));
        let normal = each!(k => splat(l, rows, 9 + k, i));
        let det = l.sub_wide(zero, dot(l, *dir, normal));
        let height = l.sub_wide(zero, dot(l, to, normal));
        let w = l.sub_wide(l.sub_wide(det, u), v);
        let tiny = l.splat_wide(TINY);
        let error = l.mul_add_wide(
            *size,
            l.mul_add_wide(m0, splat(l, rows, 12, i), splat(l, rows, 13, i)),
            tiny,
        );
        let lowest = l.min_wide(l.min_wide(u, v), w);
        let highest = l.max_wide(l.max_wide(u, v), w);
        let beside = l.min_wide(l.sub_wide(zero, lowest), highest);
        let height = l.turn_wide(height, det);
        let det = l.abs_wide(det);
        let det_error = l.mul_add_wide(*size, splat(l, rows, 13, i), tiny);
        let height_error = l.mul_add_wide(m0, splat(l, rows, 14, i), tiny);
        let off = l.mul_add_wide(det, l.splat_wide(8.0 * E), det_error);
        let least = l.product_less(*lo, det, l.mul_wide(*lo_size, off));
        let most = l.mul_add_wide(*hi, det, l.mul_wide(*hi_size, off));
        let beyond = l.max_wide(l.sub_wide(least, height), l.sub_wide(height, most));
        l.misses([beside, error], [beyond, height_error], [det, det_error])
    }
}

/// Number `k` of triangle `i`, in all lanes.
#[inline(always)]
fn splat<L: Lanes>(l: L, rows: &[[f32; LEAF as usize]; 15], k: usize, i: usize) -> L::Wide {
    l.splat_wide(rows[k][i])
}

#[inline(always)]
fn cross<L: Lanes>(l: L, a: [L::Wide; 3], b: [L::Wide; 3]) -> [L::Wide; 3] {
    [
        l.cross_wide(a[1], b[2], a[2], b[1]),
        l.cross_wide(a[2], b[0], a[0], b[2]),
        l.cross_wide(a[0], b[1], a[1], b[0]),
    ]
}

#[inline(always)]
fn dot<L: Lanes>(l: L, a: [L::Wide; 3], b: [L::Wide; 3]) -> L::Wide {
    l.mul_add_wide(a[0], b[0], l.mul_add_wide(a[1], b[1], l.mul_wide(a[2], b[2])))
}
