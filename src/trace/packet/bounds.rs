//! Between which slopes the rays of a part lie, and how far they go.

use super::{Packet, Part, eight};
use crate::simd::Lanes;
use crate::trace::query::Query;

impl<Q: Query, L: Lanes> Packet<'_, '_, Q, L> {
    /// The least and the greatest slope along x, and along y, of the rays of a part that do
    /// not end before a distance.
    #[inline(always)]
    pub(super) fn bounds(&self, part: Part, from: f64) -> [[f32; 2]; 2] {
        let l = self.lanes;
        let from = (from * (1.0 - f64::from(f32::EPSILON))) as f32;
        let mut bounds = [[f32::INFINITY, f32::NEG_INFINITY]; 2];
        if part.count < L::WIDE {
            for i in part.first..part.end() {
                if from <= self.ends[i] {
                    for (k, bounds) in bounds.iter_mut().enumerate() {
                        extend(bounds, self.slopes[k][i]);
                    }
                }
            }
            return bounds;
        }
        for (slopes, bounds) in self.slopes.iter().zip(&mut bounds) {
            let (mut least, mut most) = (l.splat_wide(bounds[0]), l.splat_wide(bounds[1]));
            let from = l.splat_wide(from);
            let mut i = part.first;
            while i < part.end() {
                let ends = l.load_wide(eight(&self.ends, i));
                let s = l.load_wide(eight(slopes, i));
                least = l.min_wide(least, l.choose_wide(from, ends, s, least));
                most = l.max_wide(most, l.choose_wide(from, ends, s, most));
                i += L::WIDE;
            }
            let mut rows = [[0.0; 8]; 2];
            l.store_wide(least, &mut rows[0]);
            l.store_wide(most, &mut rows[1]);
            for i in 0..L::WIDE {
                bounds[0] = if rows[0][i] < bounds[0] { rows[0][i] } else { bounds[0] };
                bounds[1] = if rows[1][i] > bounds[1] { rows[1][i] } else { bounds[1] };
            }
        }
        bounds
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
