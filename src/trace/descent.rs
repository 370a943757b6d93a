//! A ray's way through the tree of boxes: parts of nodes that it meets, nearest first, down to
//! leaves of up to eight triangles, which are sieved at once.
//!
//! Boxes only say where not to look; `triangle` decides what is hit, as in a walk. Nodes are in
//! coordinates times `unit`, from the lowest corner of the scene on, so that these are less
//! than 2, and the ray's parameter, tau, is t times `unit`.
//!
//! No part of a hit is missed. With e = 2^-24 and o the origin's coordinate along an axis, the
//! parameter of a plane p <= 2 is computed as p pace - o pace, with errors of at most e of
//! pace's own, of o's rounding, of the product o pace, of the sum, each times (|o| + 2) |pace|,
//! and of the addend's: 6 e (|o| + 2) |pace| in all. 16 e are subtracted where the ray enters
//! and added where it leaves. A component of the direction below 2^-115 is taken for that, 2^-95
//! of the longest or less, which moves the ray by less than 2^-83 where the origin is no farther
//! than [`FAR`], as it is here: rays from farther away walk, and so do those whose directions
//! are not between 1 / [`FASTEST`] and [`FASTEST`] long.

use super::local::above;
use super::query::{Query, beyond, decide};
use super::sieve::Sieve;
use crate::arena::layout::{LEAF, MAX_DEPTH, NODE, Node, PART_SHIFT, PARTS};
use crate::arena::{Row, Sections, View};
use crate::ray::Ray;
use crate::simd::{Lanes, Room, Stack};

/// Farthest origin along an axis, in units of about the scene's longest side.
const FAR: f32 = 1024.0;
/// 16 e.
const MARGIN: f32 = 1.0 / (1 << 20) as f32;
/// Longest component of a direction; its reciprocal is the shortest that the longest can be.
const FASTEST: f32 = (1 << 20) as f32;
/// 2^-115.
const LEAST_SPEED: f32 = f32::from_bits((127 - 115) << 23);
/// Flipped, it lets what is entered before the ray begins come first: where its origin is.
const SIGN: u32 = 1 << 31;
/// Parts that wait: seven of each node on the way, and one.
const WAITING: usize = (PARTS - 1) * MAX_DEPTH + 1;

/// A query on its way through the tree.
pub(super) struct Descent<'a, Q, L: Lanes> {
    lanes: L,
    view: &'a View<'a>,
    ray: &'a Ray,
    sieve: Sieve<'a>,
    /// Eight triangles from here on are the last of the scene.
    last: u32,
    per_t: f64,
    /// No tau above it is of interest.
    to: f32,
    pub query: Q,
}

/// A ray as boxes want it, a number for each axis in all lanes.
#[derive(Clone, Copy)]
pub(super) struct Slabs<L: Lanes> {
    pace: [L::Wide; 3],
    /// Where the ray is at plane 0, as it enters and as it leaves.
    enter: [L::Wide; 3],
    leave: [L::Wide; 3],
    from: L::Wide,
    /// Which bounds of a node it comes to first, and last.
    near: [Row; 3],
    far: [Row; 3],
}

impl<'a, Q: Query, L: Lanes> Descent<'a, Q, L> {
    /// That of a ray in a scene with a tree; `None` for one that is to walk, or that cannot hit
    /// anything.
    #[inline(always)]
    pub fn new(l: L, view: &'a View<'a>, ray: &'a Ray, query: Q) -> Option<(Self, Slabs<L>)> {
        let [org, dir, _] = ray.rows();
        let (org, dir) = (l.load3(org), l.load3(dir));
        let header = view.header();
        let [lowest, highest] = header.corners();
        let (lowest, highest) = (l.load3(lowest), l.load3(highest));
        let place = l.mul_f64(l.sub_f64(l.widen(org), l.widen(lowest)), l.splat_f64(header.unit));
        let place = l.narrow(place);
        let speed = l.abs_f32(dir);
        // One branch; NaN fails the comparisons. No t is infinite.
        let suits = l.all_below(place, FAR)
            & l.all_below(dir, FASTEST)
            & (l.first(l.highest(speed)) > 1.0 / FASTEST)
            & (ray.tmin <= ray.tmax)
            & (ray.tmin < f32::INFINITY)
            & (ray.tmax > f32::NEG_INFINITY);
        if !suits {
            return None;
        }
        let pace = l.div_f32(l.splat_f32(1.0), l.max_f32(speed, l.splat_f32(LEAST_SPEED)));
        let room = l.add_f32(l.abs_f32(place), l.splat_f32(2.0));
        let room = l.mul_f32(l.mul_f32(room, pace), l.splat_f32(MARGIN));
        let pace = l.sign_f32(pace, dir);
        let at = l.minus_f32(l.mul_f32(place, pace));
        let enter = l.array_f32(l.sub_f32(at, room));
        let leave = l.array_f32(l.add_f32(at, room));
        let pace = l.array_f32(pace);
        let signs = l.signs(dir);
        let per_t = header.unit;
        let from = -above(beyond(-ray.tmin) * per_t);
        let slabs = Slabs {
            pace: each!(k => l.splat_wide(pace[k])),
            enter: each!(k => l.splat_wide(enter[k])),
            leave: each!(k => l.splat_wide(leave[k])),
            from: l.splat_wide(from),
            near: each!(k => Row::new(k, signs >> k & 1 != 0)),
            far: each!(k => Row::new(k, signs >> k & 1 == 0)),
        };
        let descent = Self {
            lanes: l,
            view,
            ray,
            sieve: Sieve::new(l, &view.sections(), ray, [org, dir], [lowest, highest]),
            last: header.triangles.count as u32 - LEAF,
            per_t,
            to: above(beyond(ray.tmax) * per_t),
            query,
        };
        Some((descent, slabs))
    }

    /// Goes down from the root; for any hit, `occluders` are met first.
    #[inline(always)]
    pub fn run(&mut self, slabs: &Slabs<L>, occluders: &[u32]) {
        if Q::ANY {
            for few in occluders.chunks(L::WIDE) {
                let mut left = self.sieve.pass(self.lanes, few);
                while left != 0 {
                    if self.decide(few[left.trailing_zeros() as usize]) {
                        return;
                    }
                    left &= left - 1;
                }
            }
        }
        let mut room = Room::<WAITING>::new();
        let mut waiting = Stack::new(&mut room);
        let sections = self.view.sections();
        let mut part = NODE;
        loop {
            while part & NODE == NODE {
                let number = part >> PART_SHIFT;
                let (met, entries) = slabs.meet(self.lanes, &sections, number, self.to);
                let node = sections.node(number);
                let Some(next) = self.choose(&sections, node, met, entries, &mut waiting) else {
                    return;
                };
                part = next;
            }
            if self.leaf(part >> PART_SHIFT, part & NODE) {
                return;
            }
            let Some(next) = self.next(&mut waiting) else { return };
            part = next;
        }
    }

    /// The nearest of the parts that were met, after which the others wait; without any, the
    /// next that waits.
    #[inline(always)]
    fn choose(
        &self,
        sections: &Sections<'_>,
        node: &Node,
        mut met: u32,
        entries: [L::Wide; 2],
        waiting: &mut Stack<'_, WAITING>,
    ) -> Option<u32> {
        if met == 0 {
            return self.next(waiting);
        }
        let first = met.trailing_zeros() as usize;
        met &= met - 1;
        if met == 0 {
            return Some(node.parts[first]);
        }
        if Q::ANY {
            // Any hit will do: what is nearer need not be met first.
            while met != 0 {
                let i = met.trailing_zeros() as usize;
                met &= met - 1;
                waiting.push(self.entry(sections, node, &[f32::NEG_INFINITY; PARTS], i));
            }
            return Some(node.parts[first]);
        }
        let entries = &self.array(entries);
        let mut nearest = self.entry(sections, node, entries, first);
        let second = met.trailing_zeros() as usize;
        met &= met - 1;
        let base = waiting.len();
        let other = self.entry(sections, node, entries, second);
        waiting.push(nearest.max(other));
        nearest = nearest.min(other);
        while met != 0 {
            let i = met.trailing_zeros() as usize;
            met &= met - 1;
            let other = self.entry(sections, node, entries, i);
            waiting.insert(base, nearest.max(other));
            nearest = nearest.min(other);
        }
        Some(nearest as u32)
    }

    #[inline(always)]
    fn array(&self, entries: [L::Wide; 2]) -> [f32; PARTS] {
        let mut array = [0.0; PARTS];
        self.lanes.store_from(entries[0], &mut array, 0);
        if L::WIDE < PARTS {
            self.lanes.store_from(entries[1], &mut array, L::WIDE);
        }
        array
    }

    /// A part that is to wait: where the ray enters it, for the order, and its word.
    #[inline(always)]
    fn entry(&self, sections: &Sections<'_>, node: &Node, entries: &[f32; PARTS], i: usize) -> u64 {
        let part = node.parts[i];
        let place = part >> PART_SHIFT;
        if part & NODE == NODE {
            sections.fetch_node(self.lanes, place);
        } else {
            sections.fetch_leaf(self.lanes, place);
        }
        u64::from(entries[i].to_bits() ^ SIGN) << 32 | u64::from(part)
    }

    /// The next part that waits and is not behind what was found.
    #[inline(always)]
    fn next(&self, waiting: &mut Stack<'_, WAITING>) -> Option<u32> {
        loop {
            let entry = waiting.pop()?;
            if f32::from_bits((entry >> 32) as u32 ^ SIGN) <= self.to {
                return Some(entry as u32);
            }
        }
    }

    /// Meets the triangles of a leaf; `true` if the query wants no more.
    #[inline(always)]
    fn leaf(&mut self, first: u32, count: u32) -> bool {
        // Eight from here on exist, and the leaf's are among them.
        let start = first.min(self.last);
        let mut left = self.sieve.pass_run(self.lanes, start);
        if L::WIDE < LEAF as usize {
            left |= self.sieve.pass_run(self.lanes, start + L::WIDE as u32) << L::WIDE;
        }
        left &= !(u32::MAX << count) << (first - start);
        while left != 0 {
            if self.decide(start + left.trailing_zeros()) {
                return true;
            }
            left &= left - 1;
        }
        false
    }

    /// The exact test of what the sieve let through.
    #[inline(always)]
    fn decide(&mut self, number: u32) -> bool {
        let triangle = self.view.sections().triangle(number);
        let Some(enough) = decide(self.lanes, &mut self.query, self.ray, triangle, number) else {
            return false;
        };
        let limit = self.query.limit();
        self.sieve.limit(limit);
        self.to = above(beyond(limit) * self.per_t);
        enough
    }
}

impl<L: Lanes> Slabs<L> {
    /// A bit for each part of a node that the ray meets up to `to`, and where it enters these:
    /// in one wide row, or two.
    #[inline(always)]
    fn meet(&self, l: L, sections: &Sections<'_>, node: u32, to: f32) -> (u32, [L::Wide; 2]) {
        let (met, enter) = self.some(l, sections, node, to, 0);
        if L::WIDE == PARTS {
            return (met, [enter, enter]);
        }
        let (others, after) = self.some(l, sections, node, to, L::WIDE);
        (met | others << L::WIDE, [enter, after])
    }

    /// [`Slabs::meet`] of the parts from `at` on.
    #[inline(always)]
    fn some(&self, l: L, sections: &Sections<'_>, node: u32, to: f32, at: usize) -> (u32, L::Wide) {
        let near = each!(k => l.load_from(sections.bounds(node, self.near[k]), at));
        let far = each!(k => l.load_from(sections.bounds(node, self.far[k]), at));
        let enter = each!(k => l.mul_add_wide(near[k], self.pace[k], self.enter[k]));
        let leave = each!(k => l.mul_add_wide(far[k], self.pace[k], self.leave[k]));
        let first = l.max_wide(l.max_wide(enter[0], enter[1]), l.max_wide(enter[2], self.from));
        let last = l.min_wide(leave[0], leave[1]);
        let last = l.min_wide(last, l.min_wide(leave[2], l.splat_wide(to)));
        (l.at_most(first, last), first)
    }
}
