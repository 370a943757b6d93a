//! The triangles that hide most from most: what queries for any hit look at first.
//!
//! Any hit will do for them, so they need not go front to back. Where a few large
//! triangles, as of walls and floors, stand between most points, eight of them sieved at
//! once end most queries before the walk begins. Which those are is estimated: from the
//! centroids of triangles all over the scene, segments go to points all over its box, and
//! of the largest triangles those are taken, one by one, that are in the way of most
//! segments not yet stopped. If together they stop too few, there are none. Cost: a look
//! at each triangle, and `CANDIDATES` times `SEGMENTS` tests at most.

use super::control::{Control, TASKS, parts};
use crate::Error;
use crate::aabb::Aabb;
use crate::arena::layout::{OCCLUDERS, Triangle};
use crate::ray::NONE;
use glam::DVec3;

/// The largest triangles, of which occluders are taken.
const CANDIDATES: usize = 32;
/// Most segments: a bit each.
const SEGMENTS: usize = 256;
/// Triangles for each segment, at least, and triangles in all below which walks are short.
const STRIDE: usize = 16;
const FEW: usize = 128;
/// One in so many segments has to be stopped, or a look is not worth its time.
const WORTH: u32 = 4;

/// Triangles of a task.
const SHARE: usize = 4096;

/// A triangle: its area, while others are looked for the square of twice that, and its number.
type Large = (f64, u32);
const NONE_LARGE: [Large; CANDIDATES] = [(-1.0, NONE); CANDIDATES];

/// A set of segments.
#[derive(Clone, Copy)]
struct Set([u64; SEGMENTS / 64]);

impl Set {
    const EMPTY: Self = Self([0; SEGMENTS / 64]);

    fn insert(&mut self, i: usize) {
        self.0[i / 64] |= 1 << (i % 64);
    }

    fn join(&mut self, other: &Self) {
        self.0.iter_mut().zip(other.0).for_each(|(a, b)| *a |= b);
    }

    fn len(&self) -> u32 {
        self.0.iter().map(|word| word.count_ones()).sum()
    }

    /// How many of `other` are not in it.
    fn lacks(&self, other: &Self) -> u32 {
        self.0.iter().zip(other.0).map(|(a, b)| (b & !a).count_ones()).sum()
    }
}

/// The occluders of an arena's triangles: their numbers, then `NONE`.
pub fn choose(
    triangles: &[Triangle],
    bounds: &Aabb,
    control: &Control<'_>,
) -> Result<[u32; OCCLUDERS], Error> {
    if triangles.len() < FEW {
        return Ok([NONE; OCCLUDERS]);
    }
    Ok(of_largest(triangles, bounds, &largest(triangles, control)?))
}

fn of_largest(
    triangles: &[Triangle],
    bounds: &Aabb,
    candidates: &[Large; CANDIDATES],
) -> [u32; OCCLUDERS] {
    let mut chosen = [NONE; OCCLUDERS];
    let [x, y, z] = (DVec3::from(bounds.hi.map(f64::from)) - lower(bounds)).to_array();
    // A line that meets a convex body meets a part of its surface of half the area, on
    // average, in proportion to that.
    let surface = 2.0 * (x * y + y * z + z * x);
    if candidates.iter().map(|c| c.0).sum::<f64>() * 8.0 < surface {
        return chosen;
    }
    let segments = (triangles.len() / STRIDE).min(SEGMENTS);
    let mut stops = [Set::EMPTY; CANDIDATES];
    for i in 0..segments {
        let from = centroid(&triangles[i * triangles.len() / segments]);
        let way = target(i, bounds) - from;
        for (stops, &(_, number)) in stops.iter_mut().zip(candidates) {
            if in_the_way(&triangles[number as usize], from, way) {
                stops.insert(i);
            }
        }
    }
    let mut stopped = Set::EMPTY;
    for place in &mut chosen {
        let gain = |i: &usize| (stopped.lacks(&stops[*i]), CANDIDATES - i);
        let best = (0..CANDIDATES).max_by_key(gain).unwrap_or(0);
        if stopped.lacks(&stops[best]) == 0 {
            break;
        }
        stopped.join(&stops[best]);
        *place = candidates[best].1;
    }
    if stopped.len() * WORTH < segments as u32 {
        return [NONE; OCCLUDERS];
    }
    chosen
}

/// The largest triangles, largest first, ties by number.
fn largest(triangles: &[Triangle], control: &Control<'_>) -> Result<[Large; CANDIDATES], Error> {
    let share = SHARE.max(triangles.len().div_ceil(TASKS));
    let mut some = triangles.chunks(share).zip((0..).step_by(share));
    let mut tasks = parts(|| some.next().map(|(some, first)| (some, first, NONE_LARGE)));
    control.each(&mut tasks, |(some, first, best)| {
        for (number, triangle) in (*first..).zip(*some) {
            let [a, b, c] = corners(triangle);
            keep(best, ((b - a).cross(c - a).length_squared(), number));
        }
    })?;
    let mut best = NONE_LARGE;
    for (.., some) in tasks.iter().flatten() {
        some.iter().for_each(|&large| keep(&mut best, large));
    }
    Ok(best.map(|(twice, number)| (0.5 * crate::math::sqrt(twice), number)))
}

/// Puts a triangle among the largest of those that came before it, if it is.
fn keep(best: &mut [Large; CANDIDATES], large: Large) {
    if large.0 > best[CANDIDATES - 1].0 {
        let at = best.partition_point(|&(other, _)| other >= large.0);
        best[at..].rotate_right(1);
        best[at] = large;
    }
}

fn corners(triangle: &Triangle) -> [DVec3; 3] {
    triangle.corners().map(|corner| DVec3::from(corner.map(f64::from)))
}

fn centroid(triangle: &Triangle) -> DVec3 {
    let [a, b, c] = corners(triangle);
    (a + b + c) / 3.0
}

fn lower(bounds: &Aabb) -> DVec3 {
    bounds.lo.map(f64::from).into()
}

/// Point `i` of a sequence that fills the box evenly: multiples, modulo 1, of powers of
/// the number x for which x^4 = x + 1 (Roberts 2018).
fn target(i: usize, bounds: &Aabb) -> DVec3 {
    const STEP: DVec3 =
        DVec3::new(0.819_172_513_396_164_5, 0.671_043_606_703_789_2, 0.549_700_477_901_970_2);
    let at = DVec3::splat(0.5) + STEP * i as f64;
    let at = DVec3::from(at.to_array().map(|x| x - x as u32 as f64));
    lower(bounds) + at * (DVec3::from(bounds.hi.map(f64::from)) - lower(bounds))
}

/// Whether a triangle is between a point, not next to it, and the end of a way from there.
fn in_the_way(triangle: &Triangle, from: DVec3, way: DVec3) -> bool {
    let [a, b, c] = corners(triangle);
    let (e1, e2, to) = (b - a, c - a, from - a);
    let (p, q) = (way.cross(e2), to.cross(e1));
    let det = e1.dot(p);
    let [u, v, t] = [to.dot(p), way.dot(q), e2.dot(q)].map(|x| x / det);
    // No NaN passes.
    u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-4 && t < 1.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    /// Small triangles on a lattice, and a wall of two across the middle if asked for.
    fn room(wall: bool) -> (Vec<Triangle>, Aabb) {
        let mut all = Vec::new();
        let mut add = |corners: [[f32; 3]; 3]| {
            all.push(Triangle::new(&corners, 0, all.len() as u32, u32::MAX));
        };
        for i in 0..1000 {
            let [x, y, z] = [i % 10, i / 10 % 10, i / 100].map(|k| k as f32);
            add([[x, y, z], [x + 0.1, y, z], [x, y + 0.1, z + 0.1]]);
        }
        if wall {
            let corner = |y: f32, z: f32| [4.5, y * 9.1, z * 9.1];
            add([corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0)]);
            add([corner(1.0, 1.0), corner(1.0, 0.0), corner(0.0, 1.0)]);
        }
        (all, Aabb { lo: [0.0; 3], hi: [9.1; 3] })
    }

    fn chosen(triangles: &[Triangle], bounds: &Aabb) -> [u32; OCCLUDERS] {
        choose(triangles, bounds, &Control::default()).expect("not cancelled")
    }

    #[test]
    fn a_wall_occludes() {
        let (triangles, bounds) = room(true);
        let mut chosen = chosen(&triangles, &bounds);
        chosen[..2].sort_unstable();
        assert_eq!(chosen[..2], [1000, 1001]);
        assert!(chosen[2..].iter().all(|&n| n == NONE || n < 1000), "{chosen:?}");
    }

    #[test]
    fn crumbs_do_not() {
        let (triangles, bounds) = room(false);
        assert_eq!(chosen(&triangles, &bounds), [NONE; OCCLUDERS]);
    }
}
