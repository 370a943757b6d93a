//! A ray's way through the tree of boxes: parts of nodes that it meets, nearest first, down to
//! leaves of up to eight triangles, which are sieved at once.
//!
//! Boxes only say where not to look; `triangle` decides what is hit, as in a walk. Nodes are in
//! coordinates times `unit`, from the lowest corner of the scene on, so that these are less
//! than 2, or than 2 1/32 where they are rounded up to a step of 2^-6 at most (`build::tree`), and the
//! ray's parameter, tau, is t times `unit`.
//!
//! No part of a hit is missed. With e = 2^-24 and o the origin's coordinate along an axis, the
//! parameter of a plane p <= 2 1/32 is computed as p pace - o pace, with errors of at most e of
//! pace's own, of o's rounding, of the product o pace, of the sum, each times (|o| + 2 1/32)
//! |pace|, and of the addend's: 6.1 e (|o| + 2) |pace| in all. 16 e are subtracted where the ray enters
//! and added where it leaves. A component of the direction below 2^-115 is taken for that, 2^-95
//! of the longest or less, which moves the ray by less than 2^-83 where the origin is no farther
//! than [`FAR`], as it is here: rays from farther away walk, and so do those whose directions
//! are not between 1 / [`FASTEST`] and [`FASTEST`] long. A t rounds by e of it or half the
//! least denormal, which `unit` makes 2^-50 at most ([`TREE_UNITS`]); 4 e and 2^-40 are allowed.

mod slabs;

use core::marker::PhantomData;

pub(super) use slabs::{Boxes, Line, Slabs, Start};

use super::query::{Query, allowance, decide};
use super::sieve::{FARTHEST, Sieve};
use crate::arena::node::{LEAF, LEAF_SHIFT, MAX_DEPTH, NODE, PARTS, TREE_UNITS};
use crate::arena::{Sections, View};
use crate::ray::Ray;
use crate::simd::{Lanes, Room, Stack};

/// Farthest origin along an axis, in units of about the scene's longest side.
const FAR: f32 = 1024.0;
/// Longest component of a direction; its reciprocal is the shortest that the longest can be.
const FASTEST: f32 = (1 << 20) as f32;
/// Parts that wait: seven of each node on the way, and one.
const WAITING: usize = (PARTS - 1) * MAX_DEPTH + 1;

// What a ray meets here is near enough to be sieved.
const _: () = assert!((FAR + 2.0) as f64 / *TREE_UNITS.start() < FARTHEST as f64);

/// A query on its way through a tree of nodes of one kind.
pub(super) struct Descent<'a, Q, N, L: Lanes> {
    lanes: L,
    sections: Sections<'a>,
    ray: &'a Ray,
    /// Made where the first triangles are met: many rays meet none.
    sieve: Option<Sieve<'a>>,
    unit: f32,
    /// No tau above it is of interest.
    to: f32,
    query: PhantomData<(Q, N)>,
}

/// By how much a parameter that rounds to a t may be off what is computed of that, `tau`.
#[inline(always)]
fn rounding<L: Lanes>(l: L, tau: f32) -> f32 {
    allowance(l, tau, 2.0 * f32::EPSILON, 1.0 / (1u64 << 40) as f32)
}

/// A tau that no parameter that rounds to `limit` or less is above. Where the product is infinite on
/// the wrong side it is NaN: nothing in a tree is that far, and it does not matter what is met.
#[inline(always)]
pub(super) fn beyond<L: Lanes>(l: L, limit: f32, unit: f32) -> f32 {
    let tau = limit * unit;
    tau + rounding(l, tau)
}

/// A tau that no parameter that rounds to `limit` or more is below, likewise.
#[inline(always)]
fn before<L: Lanes>(l: L, limit: f32, unit: f32) -> f32 {
    let tau = limit * unit;
    tau - rounding(l, tau)
}

/// How a ray begins in a scene with a tree; `None` for one that is to walk, or that cannot hit
/// anything.
#[inline(always)]
pub(super) fn start<L: Lanes>(l: L, view: &View, ray: &Ray) -> Option<Start<L>> {
    let [org, dir, _] = ray.rows();
    let (org, dir) = (l.load_f32(org), l.load_f32(dir));
    let header = view.header();
    let way = l.sub_f32(l.load_f32(header.corners()[0]), org);
    let way = l.mul_f32(way, l.splat_f32(header.unit as f32));
    let speed = l.abs_f32(dir);
    // One branch; NaN fails the comparisons.
    let suits = l.all_below(way, FAR)
        & l.all_below(dir, FASTEST)
        & (l.first(l.highest(speed)) > 1.0 / FASTEST)
        & (ray.tmin <= ray.tmax);
    suits.then_some(Start { way, dir, speed })
}

/// Whether one of these triangles is all that a query for any hit wants.
#[inline(always)]
pub(super) fn hidden<Q: Query, L: Lanes>(
    l: L,
    sections: &Sections<'_>,
    sieve: &Sieve<'_>,
    ray: &Ray,
    occluders: &[u32],
    query: &mut Q,
) -> bool {
    for few in occluders.chunks(L::WIDE) {
        let (mut left, sieved) = sieve.few(l, few);
        let triangle = |i: usize| sections.triangle(few[i]);
        if sieve.hits(l, ray, &sieved, left, triangle) {
            return query.take_any();
        }
        while left != 0 {
            let number = few[left.trailing_zeros() as usize];
            if decide(l, query, ray, sections.triangle(number), number) == Some(true) {
                return true;
            }
            left &= left - 1;
        }
    }
    false
}

impl<'a, Q: Query, N: Boxes, L: Lanes> Descent<'a, Q, N, L> {
    /// That of a ray in a scene with a tree, if it is not to walk: [`start`].
    #[inline(always)]
    pub fn new(l: L, view: &View<'a>, ray: &'a Ray) -> Option<(Self, Start<L>)> {
        let start = start(l, view, ray)?;
        let unit = view.header().unit as f32;
        let descent = Self {
            lanes: l,
            sections: view.sections(),
            ray,
            sieve: None,
            unit,
            to: beyond(l, ray.tmax, unit),
            query: PhantomData,
        };
        Some((descent, start))
    }

    /// Goes down from the root; for any hit, `occluders` are met before. The query is not part of
    /// this record, as exact tests write to it: what is pointed to is in memory, and the rest is
    /// not to be.
    #[inline(always)]
    pub fn run(&mut self, start: &Start<L>, occluders: &[u32], query: &mut Q) {
        if Q::ANY && !occluders.is_empty() {
            let (l, sections, ray) = (self.lanes, self.sections, self.ray);
            if hidden(l, &sections, self.sieve(), ray, occluders, query) {
                return;
            }
        }
        let line = Line::<N>::new(self.lanes, &self.sections, start, self.ray, self.unit);
        let slabs = Slabs::new(self.lanes, &line);
        let mut room = Room::<WAITING>::new();
        let mut waiting = Stack::new(&mut room);
        let mut part = NODE;
        loop {
            while part & NODE == NODE {
                let (met, entries) = slabs.meet(self.lanes, &self.sections, part, self.to);
                let parts = self.sections.node::<N>(part).parts();
                let Some(next) = self.choose(parts, met, entries, &mut waiting) else {
                    return;
                };
                part = next;
            }
            if self.leaf(part >> LEAF_SHIFT, part & NODE, query) {
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
        parts: &[u32; PARTS],
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
            return Some(parts[first]);
        }
        if Q::ANY {
            // Any hit will do: what is nearer need not be met first.
            while met != 0 {
                let i = met.trailing_zeros() as usize;
                met &= met - 1;
                waiting.push(self.entry(parts, &[f32::NEG_INFINITY; PARTS], i));
            }
            return Some(parts[first]);
        }
        let entries = &self.array(entries);
        let mut nearest = self.entry(parts, entries, first);
        let second = met.trailing_zeros() as usize;
        met &= met - 1;
        let base = waiting.len();
        let other = self.entry(parts, entries, second);
        waiting.push(nearest.max(other));
        nearest = nearest.min(other);
        while met != 0 {
            let i = met.trailing_zeros() as usize;
            met &= met - 1;
            let other = self.entry(parts, entries, i);
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

    /// A part that is to wait: where the ray enters it, for the order, and its word. What is entered
    /// at a negative tau comes first, in whatever order.
    #[inline(always)]
    fn entry(&self, parts: &[u32; PARTS], entries: &[f32; PARTS], i: usize) -> i64 {
        let part = parts[i];
        self.sections.fetch_part::<N, L>(self.lanes, part);
        i64::from(entries[i].to_bits()) << 32 | i64::from(part)
    }

    /// The next part that waits and is not behind what was found.
    #[inline(always)]
    fn next(&self, waiting: &mut Stack<'_, WAITING>) -> Option<u32> {
        loop {
            let entry = waiting.pop()?;
            if f32::from_bits((entry >> 32) as u32) <= self.to {
                return Some(entry as u32);
            }
        }
    }

    /// Meets the triangles of a leaf; `true` if the query wants no more.
    #[inline(always)]
    fn leaf(&mut self, first: u32, count: u32, query: &mut Q) -> bool {
        let l = self.lanes;
        let (mut start, mut of_leaf) = (first, !(u32::MAX << count));
        while of_leaf != 0 {
            let sieved = self.sieve().run(l, start);
            let mut left = of_leaf & (u32::MAX >> (32 - L::WIDE)) & !sieved.out;
            if Q::ANY {
                let (sections, ray) = (self.sections, self.ray);
                let triangle = |i: usize| sections.triangle(start + i as u32);
                if self.sieve().hits(l, ray, &sieved, left, triangle) {
                    return query.take_any();
                }
            }
            // Mostly one, for which no order has to be made ready.
            if !Q::ANY && left.is_power_of_two() {
                if self.decide(start + left.trailing_zeros(), query) {
                    return true;
                }
                left = 0;
            }
            while left != 0 {
                let i = if Q::ANY {
                    left.trailing_zeros()
                } else {
                    self.sieve().first(l, &sieved, left)
                };
                if self.decide(start + i, query) {
                    return true;
                }
                left ^= 1 << i;
                if left != 0 && !Q::ANY {
                    left &= self.sieve().again(l, &sieved);
                }
            }
            if L::WIDE == LEAF as usize {
                break;
            }
            of_leaf >>= L::WIDE;
            start += L::WIDE as u32;
        }
        false
    }

    /// The ray's sieve.
    #[inline(always)]
    fn sieve(&mut self) -> &Sieve<'a> {
        match &mut self.sieve {
            Some(sieve) => sieve,
            none => {
                let (l, ray) = (self.lanes, self.ray);
                let [org, dir, _] = ray.rows();
                let rows = [l.load_f32(org), l.load_f32(dir)];
                none.insert(Sieve::new(l, &self.sections, ray, rows, true))
            }
        }
    }

    /// The exact test of what the sieve let through.
    #[inline(always)]
    fn decide(&mut self, number: u32, query: &mut Q) -> bool {
        let triangle = self.sections.triangle(number);
        let Some(enough) = decide(self.lanes, query, self.ray, triangle, number) else {
            return false;
        };
        let limit = query.limit();
        if let Some(sieve) = &mut self.sieve {
            sieve.limit(self.lanes, limit);
        }
        self.to = beyond(self.lanes, limit, self.unit);
        enough
    }
}
