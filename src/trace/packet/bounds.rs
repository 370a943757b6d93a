//! Between which slopes the rays of a part lie, and how far they go.

use super::{Packet, Part, eight};
use crate::simd::Lanes;
use crate::trace::query::Query;

/// The rays of a part that do not end before some distance.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    /// The least and the greatest slope along x, and along y.
    pub slopes: [[f32; 2]; 2],
    /// A bit for each ray.
    pub rays: u64,
}

impl<Q: Query, L: Lanes> Packet<'_, '_, Q, L> {
    /// Those of rays that do not end before distance `from`.
    #[inline(always)]
    pub(super) fn bounds(&self, part: Part, from: f64) -> Bounds {
        let l = self.lanes;
        let from = (from * (1.0 - f64::from(f32::EPSILON))) as f32;
        let mut bounds = [[f32::INFINITY, f32::NEG_INFINITY]; 2];
        let mut rays = 0;
        if part.count < L::WIDE {
            for i in part.first..part.end() {
                if from <= self.ends[i] {
                    rays |= 1 << i;
                    for (k, bounds) in bounds.iter_mut().enumerate() {
                        extend(bounds, self.slopes[k][i]);
                    }
                }
            }
            return Bounds { slopes: bounds, rays };
        }
        for (slopes, bounds) in self.slopes.iter().zip(&mut bounds) {
            let (mut least, mut most) = (l.splat_wide(bounds[0]), l.splat_wide(bounds[1]));
            let from = l.splat_wide(from);
            let mut i = part.first;
            while i < part.end() {
                let ends = l.load_wide(eight(&self.ends, i));
                rays |= u64::from(l.at_most(from, ends)) << i;
                let s = l.load_wide(eight(slopes, i));
                least = l.min_wide(least, l.choose_wide(from, ends, s, least));
                most = l.max_wide(most, l.choose_wide(from, ends, s, most));
                i += L::WIDE;
            }
            let mut rows = [[0.0; 8]; 2];
            l.store_wide(least, &mut rows[0]);
            l.store_wide(most, &mut rows[1]);
            for (&low, &high) in rows[0].iter().zip(&rows[1]).take(L::WIDE) {
                bounds[0] = if low < bounds[0] { low } else { bounds[0] };
                bounds[1] = if high > bounds[1] { high } else { bounds[1] };
            }
        }
        Bounds { slopes: bounds, rays }
    }

    /// The distance at which the last ray of a part ends.
    #[inline(always)]
    pub(super) fn end(&self, part: Part) -> f64 {
        let l = self.lanes;
        let mut end = 0.0;
        if part.count < L::WIDE {
            for i in part.first..part.end() {
                end = if self.ends[i] > end { self.ends[i] } else { end };
            }
            return f64::from(end);
        }
        let mut most = l.splat_wide(end);
        let mut i = part.first;
        while i < part.end() {
            most = l.max_wide(most, l.load_wide(eight(&self.ends, i)));
            i += L::WIDE;
        }
        let mut row = [0.0; 8];
        l.store_wide(most, &mut row);
        for &x in &row[..L::WIDE] {
            end = if x > end { x } else { end };
        }
        f64::from(end)
    }
}

#[inline(always)]
fn extend([low, high]: &mut [f32; 2], x: f32) {
    *low = if x < *low { x } else { *low };
    *high = if x > *high { x } else { *high };
}
