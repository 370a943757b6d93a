//! The exact test of a triangle each of four rays.

use super::super::query::{Query, decide, visible};
use super::{Rounds, SLOTS};
use crate::ray::culls;
use crate::simd::Lanes;
use crate::triangle::{FourPairs, Met};

impl<Q: Query, L: Lanes> Rounds<'_, '_, '_, Q, L> {
    /// Decides the triangles that are due in the first `count` of these slots; the others are one
    /// of these.
    #[inline(always)]
    pub(super) fn decide_four(&mut self, slots: [usize; 4], count: usize) {
        let l = self.l;
        let pairs = {
            let flight = |i: usize| &self.flights[slots[i] % SLOTS];
            let triangle = |i: usize| self.sections.triangle(flight(i).number);
            let rays = [&flight(0).ray, &flight(1).ray, &flight(2).ray, &flight(3).ray];
            FourPairs::new(l, rays, [triangle(0), triangle(1), triangle(2), triangle(3)])
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
        for (i, &slot) in slots.iter().enumerate().take(count) {
            let bit = 1 << i;
            if hits & bit != 0 {
                let flight = &mut self.flights[slot % SLOTS];
                let triangle = self.sections.triangle(flight.number);
                let [t, u, v, x] = rows[i];
                let culled = culls(flight.ray.flags, found.front & bit != 0);
                if t <= flight.query.limit() && visible(&flight.ray, triangle) && !culled {
                    let weights = (found.weighed & bit != 0).then_some((u, v));
                    let met = Met { t, weights, normal: Some([x, ys[i], zs[i]]) };
                    flight.query.take_met(met, triangle, flight.number);
                    flight.shorten(l, self.unit);
                }
            } else if known & bit == 0 {
                self.decide_one(slot);
            }
        }
    }

    /// Decides the others of a leaf.
    #[inline(always)]
    pub(super) fn decide_rest(&mut self, slot: usize) {
        while self.flights[slot % SLOTS].other(self.l, &self.kept[slot % SLOTS]) {
            self.decide_one(slot);
        }
    }

    /// Decides the triangle that is due in this slot.
    #[inline(always)]
    fn decide_one(&mut self, slot: usize) {
        let flight = &mut self.flights[slot % SLOTS];
        let triangle = self.sections.triangle(flight.number);
        let met = decide(self.l, &mut flight.query, &flight.ray, triangle, flight.number);
        if met.is_some() {
            flight.shorten(self.l, self.unit);
        }
    }
}
