//! A ray's way through the tree of boxes: parts of nodes that it meets, nearest first, down to
//! leaves of up to four triangles.
//!
//! Boxes only say where not to look; `triangle` decides what is hit, as in a walk. Nodes are in
//! coordinates times `unit`, from the lowest corner of the scene on, so that these are at most
//! about 1, and the ray's parameter is tau as in a walk (`course`).
//!
//! No part of a hit is missed. With e = 2^-24 and o the origin's coordinate along an axis, the
//! parameter of a plane p <= 2 is computed as p pace - o pace, with errors of at most e of
//! pace's own, of o's rounding, of the product o pace, of the sum, each times (|o| + 2) |pace|,
//! and of the addend's: 6 e (|o| + 2) |pace| in all. 16 e are subtracted where the ray enters
//! and added where it leaves. A component of the direction below 2^-95 is taken for that, which
//! moves the ray by less than 2^-85 where the origin is no farther than [`FAR`], as it is here:
//! rays from farther away walk.

use super::course::{Course, LEAST_SPEED};
use super::local::above;
use super::query::{Query, beyond, visible};
use crate::arena::layout::{MAX_DEPTH, NODE, Node, PART_SHIFT, PARTS};
use crate::arena::{Sections, View};
use crate::ray::Ray;
use crate::simd::{Lanes, Stack};
use crate::triangle::{Four, Line};

/// Farthest origin along an axis, in units of about the scene's longest side.
const FAR: f64 = 1024.0;
/// 16 e.
const MARGIN: f32 = 1.0 / (1 << 20) as f32;
/// Parts that wait: seven of each node on the way, and one.
const WAITING: usize = (PARTS - 1) * MAX_DEPTH + 1;

/// A query on its way through the tree.
pub(super) struct Descent<'a, Q, L: Lanes> {
    lanes: L,
    sections: Sections<'a>,
    ray: &'a Ray,
    line: Line,
    slabs: Slabs<L>,
    per_t: f64,
    /// What t are of interest, at most, and the end of that in tau.
    reach: [f64; 2],
    to: f32,
    pub query: Q,
}

/// A ray as boxes want it, a number for each axis in all lanes.
#[derive(Clone, Copy)]
struct Slabs<L: Lanes> {
    pace: [L::Wide; 3],
    /// Where the ray is at plane 0, as it enters and as it leaves.
    enter: [L::Wide; 3],
    leave: [L::Wide; 3],
    from: L::Wide,
    /// Which bounds of a node it comes to first, and last.
    near: [usize; 3],
    far: [usize; 3],
}

impl<'a, Q: Query, L: Lanes> Descent<'a, Q, L> {
    /// That of a ray that is known to be usable, in a scene with a tree; `None` for one from far
    /// away.
    #[inline(always)]
    pub fn new(l: L, view: &View<'a>, ray: &'a Ray, query: Q) -> Option<Self> {
        let [org, dir, _] = ray.rows();
        let (org, dir) = (l.load3(org), l.load3(dir));
        let header = view.header();
        let course = Course::new(l, org, dir, header.unit);
        let lowest = l.load3(header.corners()[0]);
        let place = l.sub_f64(l.widen(org), l.widen(lowest));
        let place = l.mul_f64(place, l.splat_f64(header.unit));
        if l.any_beyond(place, FAR) {
            return None;
        }
        let speed = l.max_f64(l.abs_f64(course.dir), l.load_f64(&LEAST_SPEED));
        let speed = l.narrow(l.sign_f64(speed, course.dir));
        let pace = l.div_f32(l.splat_f32(1.0), speed);
        let place = l.narrow(place);
        let room = l.add_f32(l.abs_f32(place), l.splat_f32(2.0));
        let room = l.mul_f32(l.mul_f32(room, l.abs_f32(pace)), l.splat_f32(MARGIN));
        let at = l.minus_f32(l.mul_f32(place, pace));
        let enter = l.array_f32(l.sub_f32(at, room));
        let leave = l.array_f32(l.add_f32(at, room));
        let pace = l.array_f32(pace);
        let down = l.array(course.down);
        let first = each!(k => 2 * k + usize::from(down[k] != 0));
        let reach = [-beyond(-ray.tmin), beyond(ray.tmax)];
        let from = -above(-reach[0] * course.per_t);
        let slabs = Slabs {
            pace: each!(k => l.splat_wide(pace[k])),
            enter: each!(k => l.splat_wide(enter[k])),
            leave: each!(k => l.splat_wide(leave[k])),
            from: l.splat_wide(from),
            near: first,
            far: each!(k => first[k] ^ 1),
        };
        Some(Self {
            lanes: l,
            sections: view.sections(),
            ray,
            line: Line::new(ray),
            slabs,
            per_t: course.per_t,
            reach,
            to: above(reach[1] * course.per_t),
            query,
        })
    }

    /// Goes down from the root; for any hit, `occluders` are met first.
    #[inline(always)]
    pub fn run(&mut self, occluders: &[u32]) {
        if Q::ANY {
            for few in occluders.chunks(4) {
                let last = few.len() - 1;
                let numbers = [few[0], few[last.min(1)], few[last.min(2)], few[last.min(3)]];
                if self.meet(numbers, few.len() as u32) {
                    return;
                }
            }
        }
        let mut waiting = Stack::<WAITING>::new();
        let mut part = NODE;
        loop {
            while part & NODE == NODE {
                let node = self.sections.node(part >> PART_SHIFT);
                let (met, entries) = self.slabs.meet(self.lanes, node, self.to);
                match self.choose(node, met, &entries, &mut waiting) {
                    Some(next) => part = next,
                    None => return,
                }
            }
            let (first, count) = (part >> PART_SHIFT, part & NODE);
            let last = count.saturating_sub(1);
            let numbers = [first, first + last.min(1), first + last.min(2), first + last.min(3)];
            if count > 0 && self.meet(numbers, count) {
                return;
            }
            match self.next(&mut waiting) {
                Some(next) => part = next,
                None => return,
            }
        }
    }

    /// The nearest of the parts that were met, after which the others wait; without any, the
    /// next that waits.
    #[inline(always)]
    fn choose(
        &self,
        node: &Node,
        mut met: u32,
        entries: &[f32; PARTS],
        waiting: &mut Stack<WAITING>,
    ) -> Option<u32> {
        if met == 0 {
            return self.next(waiting);
        }
        let first = met.trailing_zeros() as usize;
        met &= met - 1;
        if met == 0 {
            return Some(node.parts[first]);
        }
        let mut nearest = self.entry(node, entries, first);
        let second = met.trailing_zeros() as usize;
        met &= met - 1;
        let base = waiting.len();
        let other = self.entry(node, entries, second);
        waiting.push(nearest.max(other));
        nearest = nearest.min(other);
        while met != 0 {
            let i = met.trailing_zeros() as usize;
            met &= met - 1;
            let other = self.entry(node, entries, i);
            waiting.insert(base, nearest.max(other));
            nearest = nearest.min(other);
        }
        Some(nearest as u32)
    }

    /// A part that is to wait: where the ray enters it, for the order, and its word.
    #[inline(always)]
    fn entry(&self, node: &Node, entries: &[f32; PARTS], i: usize) -> u64 {
        let part = node.parts[i];
        let place = part >> PART_SHIFT;
        if part & NODE == NODE {
            self.sections.fetch_node(self.lanes, place);
        } else {
            self.sections.fetch_leaf(self.lanes, place);
        }
        u64::from(entries[i].to_bits()) << 32 | u64::from(part)
    }

    /// The next part that waits and is not behind what was found.
    #[inline(always)]
    fn next(&self, waiting: &mut Stack<WAITING>) -> Option<u32> {
        loop {
            let entry = waiting.pop()?;
            if f32::from_bits((entry >> 32) as u32) <= self.to {
                return Some(entry as u32);
            }
        }
    }

    /// Meets up to four triangles, the last of which fills the numbers up; `true` if the query
    /// wants no more.
    #[inline(always)]
    fn meet(&mut self, numbers: [u32; 4], count: u32) -> bool {
        let l = self.lanes;
        let axes = each!(k => self.sections.axis(k));
        let rows = each!(k => [
            axes[k].row(3 * numbers[0]),
            axes[k].row(3 * numbers[1]),
            axes[k].row(3 * numbers[2]),
            axes[k].row(3 * numbers[3]),
        ]);
        let (four, near) = Four::new(l, self.line.ends(), rows, self.reach);
        let mut left = near & (15 >> (4 - count));
        if left == 0 {
            return false;
        }
        let arrays = four.arrays(l);
        while left != 0 {
            let i = left.trailing_zeros() as usize % 4;
            left &= left - 1;
            let triangle = self.sections.triangle(numbers[i]);
            if !visible(self.ray, triangle) {
                continue;
            }
            let near = arrays.estimate(i);
            if let Some(enough) = self.query.meet_near(&self.line, &near, triangle, numbers[i]) {
                self.reach[1] = beyond(self.query.limit());
                self.to = above(self.reach[1] * self.per_t);
                if enough {
                    return true;
                }
            }
        }
        false
    }
}

impl<L: Lanes> Slabs<L> {
    /// A bit for each part of a node that the ray meets up to `to`, and where it enters each.
    #[inline(always)]
    fn meet(&self, l: L, node: &Node, to: f32) -> (u32, [f32; PARTS]) {
        let (mut met, mut entries, mut at) = (0, [0.0; PARTS], 0);
        while at < PARTS {
            let [mut enter, mut leave] = [self.from, l.splat_wide(to)];
            let mut k = 0;
            while k < 3 {
                let (near, far) = (&node.bounds[self.near[k] % 6], &node.bounds[self.far[k] % 6]);
                let (near, far) = (l.load_from(near, at), l.load_from(far, at));
                enter = l.max_wide(enter, l.mul_add_wide(near, self.pace[k], self.enter[k]));
                leave = l.min_wide(leave, l.mul_add_wide(far, self.pace[k], self.leave[k]));
                k += 1;
            }
            met |= l.at_most(enter, leave) << at;
            l.store_from(enter, &mut entries, at);
            at += L::WIDE;
        }
        (met, entries)
    }
}
