//! Exact tests, of a triangle each of four rays.

use super::super::query::{Query, decide, visible};
use super::{Flocking, RAYS};
use crate::ray::culls;
use crate::simd::{Kernel, Lanes};
use crate::triangle::{FourPairs, Met};

/// A ray and a triangle, by their numbers.
pub type Pair = [u32; 2];

/// What leaves of lists have for the next four.
#[derive(Default)]
pub struct Due {
    pairs: [Pair; 4],
    count: usize,
}

/// [`Flocking::decide_four`], compiled for the instruction set.
struct Decide<'s, 'a, 'p, 'f, Q: Query, L: Lanes> {
    flocking: &'s mut Flocking<'a, 'p, 'f, Q, L>,
    due: [Pair; 4],
    count: usize,
}

impl<Q: Query, L: Lanes> Kernel<L> for Decide<'_, '_, '_, '_, Q, L> {
    type Out = ();
    #[inline(always)]
    fn run(self, _: L) {
        self.flocking.decide_now(self.due, self.count);
    }
}

impl<Q: Query, L: Lanes> Flocking<'_, '_, '_, Q, L> {
    /// Decides a pair, as soon as there are four.
    #[inline(always)]
    pub(super) fn decide_later(&mut self, pair: Pair) {
        self.due.pairs[self.due.count % 4] = pair;
        self.due.count += 1;
        if self.due.count == 4 {
            self.decide_due();
        }
    }

    /// Decides those that are left.
    #[inline(always)]
    pub(super) fn decide_due(&mut self) {
        let Due { pairs, count } = core::mem::take(&mut self.due);
        if count > 0 {
            self.decide_four(pairs, count);
        }
    }

    /// Decides the first `count` of these pairs, at least one.
    #[inline(always)]
    pub(super) fn decide_four(&mut self, due: [Pair; 4], count: usize) {
        self.l.run_in_function(Decide { flocking: self, due, count });
    }

    #[inline(always)]
    fn decide_now(&mut self, mut due: [Pair; 4], count: usize) {
        let l = self.l;
        for i in count..4 {
            due[i] = due[0];
        }
        let pairs = {
            let ray = |i: usize| &self.members[due[i][0] as usize].ray;
            let triangle = |i: usize| self.sections.triangle(due[i][1]);
            let triangles = [triangle(0), triangle(1), triangle(2), triangle(3)];
            FourPairs::new(l, [ray(0), ray(1), ray(2), ray(3)], triangles)
        };
        let FourPairs { found, normal, tmin } = pairs;
        let t = l.widen(found.t);
        let early = l.above_f64(tmin, t);
        // A range may begin at minus infinity.
        let finite = l.above_f64(l.splat_f64(f64::INFINITY), l.abs_f64(t));
        let hits = found.inside & finite & !early;
        let known = found.inside | found.outside;
        let rows = l.transpose([found.t, found.u, found.v, normal[0]]);
        let rows = [
            l.array_f32(rows[0]),
            l.array_f32(rows[1]),
            l.array_f32(rows[2]),
            l.array_f32(rows[3]),
        ];
        let [ys, zs] = [l.array_f32(normal[1]), l.array_f32(normal[2])];
        for (i, &[ray, number]) in due.iter().enumerate().take(count) {
            let (ray, bit) = (ray as usize % RAYS, 1 << i);
            if hits & bit != 0 {
                let member = &mut self.members[ray];
                let triangle = self.sections.triangle(number);
                let [t, u, v, x] = rows[i];
                let culled = culls(member.ray.flags, found.front & bit != 0);
                if t <= member.query.limit() && visible(&member.ray, triangle) && !culled {
                    let weights = (found.weighed & bit != 0).then_some((u, v));
                    let met = Met { t, weights, normal: Some([x, ys[i], zs[i]]) };
                    let enough = member.query.take_met(met, triangle, number);
                    self.taken(ray, enough);
                }
            } else if known & bit == 0 {
                self.decide_one(ray, number);
            }
        }
    }

    /// Decides one pair.
    #[inline(always)]
    pub(super) fn decide_one(&mut self, ray: usize, number: u32) {
        let ray = ray % RAYS;
        let member = &mut self.members[ray];
        // A query for any hit forgets what it has found if it meets more.
        if Q::ANY && self.lists.tos[ray] == f32::NEG_INFINITY {
            return;
        }
        let triangle = self.sections.triangle(number);
        if let Some(enough) = decide(self.l, &mut member.query, &member.ray, triangle, number) {
            self.taken(ray, enough);
        }
    }

    /// What follows from a hit.
    #[inline(always)]
    fn taken(&mut self, ray: usize, enough: bool) {
        self.lists.tos[ray] =
            if enough { f32::NEG_INFINITY } else { self.members[ray].shorten(self.l, self.unit) };
    }
}
