//! Overlap numbers (Definition 4, section 7.3): how well an axis separates objects.
//!
//! The overlap number of segments on a line is the sum, over all their ends, of the
//! segments inside which an end lies. For n segments: O(n log n), by sorting lower and
//! upper ends in memory of two words a segment. Objects without extent along the axis are
//! points; a point lies in segments, and nothing lies in it.

use super::frame::{Grid, Rule};
use super::sort;
use crate::aabb::Aabb;
use crate::arena::layout::{GRID_BIT, Triangle};
use crate::math::{exp, ln, ordered};
use crate::options::Gridding;

/// What is put into a grid: triangles, and grids, whose numbers have the top bit set.
pub struct Objects<'a> {
    pub objects: &'a [u32],
    pub grids: &'a [Grid],
    pub triangle: &'a dyn Fn(u32) -> &'a Triangle,
}

impl Objects<'_> {
    /// The part of an object along an axis that lies in a grid.
    fn segment(&self, object: u32, axis: usize, grid: &Grid) -> [f32; 2] {
        let ends = if object & GRID_BIT == 0 {
            let b = Aabb::of(&(self.triangle)(object).corners());
            [b.lo[axis], b.hi[axis]]
        } else {
            let below = &self.grids[(object & !GRID_BIT) as usize];
            [below.lo[axis], below.lo[axis] + below.extent[axis]].map(|x| x as f32)
        };
        let [lo, hi] = [grid.lo[axis], grid.lo[axis] + grid.extent[axis]].map(|x| x as f32);
        ends.map(|x| x.max(lo).min(hi))
    }
}

impl Rule {
    /// The rule with the weights that its gridding gives to the axes: `(1 + c)^-power`,
    /// with `c` the mean number of objects that an end of an object lies in, so that
    /// `n_i = n^beta_i` with `beta_i` falling in the overlap number. `room` is for two
    /// words for each object.
    pub fn weighed(&self, grid: &Grid, objects: Objects<'_>, room: &mut [u32]) -> Self {
        if !self.gridding.overlaps() || self.counts != [0; 3] {
            return *self;
        }
        let longest = grid.extent[0].max(grid.extent[1]).max(grid.extent[2]);
        let mut weights = [1.0; 3];
        let room = &mut room[..2 * objects.objects.len()];
        for (axis, weight) in weights.iter_mut().enumerate() {
            let segments = objects.objects.iter().map(|&o| objects.segment(o, axis, grid));
            let power = f64::from(self.power);
            let overlap = -power * ln(1.0 + cover(segments, room));
            let side = (1.0 - power) * ln(grid.extent[axis] / longest);
            *weight = exp(if self.gridding == Gridding::Mixed { overlap + side } else { overlap });
        }
        Self { weights, ..*self }
    }
}

/// The mean number of segments that an end of a segment lies in; half the overlap number
/// for each segment. `room` is for two words for each.
pub fn cover(segments: impl Iterator<Item = [f32; 2]>, room: &mut [u32]) -> f64 {
    let half = room.len() / 2;
    let (lower, upper) = room.split_at_mut(half);
    // Points from the end of the lower half on.
    let (mut count, mut points) = (0, half);
    for [lo, hi] in segments {
        if lo < hi {
            (lower[count], upper[count]) = (ordered(lo), ordered(hi));
            count += 1;
        } else {
            points -= 1;
            lower[points] = ordered(lo);
        }
    }
    let all = count + half - points;
    let (rest, points) = lower.split_at_mut(points);
    let (lower, upper) = (&mut rest[..count], &mut upper[..count]);
    for ends in [&mut *lower, &mut *upper, &mut *points] {
        sort::by_key(ends, &u64::from);
    }
    let inside = |ends| held(ends, lower, upper);
    let overlap = inside(lower) + inside(upper) + 2 * inside(points);
    overlap as f64 / (2 * all.max(1)) as f64
}

/// In how many segments these points lie, in sum; all sorted.
fn held(points: &[u32], lower: &[u32], upper: &[u32]) -> u64 {
    let (mut begun, mut ended, mut sum) = (0, 0, 0);
    for &x in points {
        begun += lower[begun..].iter().take_while(|&&lo| lo < x).count();
        ended += upper[ended..].iter().take_while(|&&hi| hi <= x).count();
        sum += (begun - ended) as u64;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::cover;
    use std::vec;
    use std::vec::Vec;

    fn mean(segments: &[[f32; 2]]) -> f64 {
        cover(segments.iter().copied(), &mut vec![0; 2 * segments.len()])
    }

    #[test]
    fn figure_26() {
        // a1 b1 c1 b2 a2 c2 and the like: 0 + 1 + 2 + 2 + 1 + 0 = 6 over 6 ends.
        assert_eq!(mean(&[[0.0, 3.0], [1.0, 4.0], [2.0, 5.0]]), 1.0);
        assert_eq!(mean(&[[0.0, 5.0], [1.0, 4.0], [2.0, 3.0]]), 1.0);
    }

    #[test]
    fn points_and_neighbours() {
        assert_eq!(mean(&[]), 0.0);
        assert_eq!(mean(&[[-1.0, 0.0], [0.0, 1.0]]), 0.0);
        assert_eq!(mean(&[[0.0, 0.0], [0.0, 0.0]]), 0.0);
        // The point's two ends lie in the segment.
        assert_eq!(mean(&[[-1.0, 1.0], [-0.0, 0.0]]), 0.5);
    }

    #[test]
    fn by_definition() {
        let number = |i: u32| (i.wrapping_mul(2_654_435_761) >> 16 & 31) as f32 - 16.0;
        let segments: Vec<[f32; 2]> = (0..200)
            .map(|i| [number(i), number(i + 1000)])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        let inside = |x: f32| segments.iter().filter(|s| s[0] < x && x < s[1]).count();
        let sum: usize = segments.iter().flatten().map(|&x| inside(x)).sum();
        assert_eq!(mean(&segments), sum as f64 / 400.0);
    }
}
