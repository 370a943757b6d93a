//! All hits of a ray, in order, as many as there is room for.
//!
//! Hits are ordered by the rounded t, then geometry, then primitive, as everywhere: no
//! two are equal. So one that is met again, in another voxel, is found among those that
//! are there by its place, and what comes after a given hit is well defined, whatever
//! was found in which call.

use core::cell::Cell;

use super::alone::{meet, record};
use super::counters::Uncounted;
use super::query::{Query, usable};
use super::walk::Walk;
use crate::arena::layout::Triangle;
use crate::arena::{Sections, View};
use crate::ray::{Hit, Ray};
use crate::simd::{AnyKernel, Isa, Lanes, dispatch, fpenv};
use crate::triangle::{Apex, Line, Met};

/// What [`View::intersect_all`] found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Found {
    /// How many hits were written.
    pub count: usize,
    /// Whether there are others, behind them.
    pub more: bool,
}

/// A hit's place among those of its ray.
fn place(hit: &Hit) -> (f32, u32, u32) {
    (hit.t, hit.geom, hit.prim)
}

/// The first hits after a place.
#[derive(Clone, Copy)]
struct Collect<'b> {
    tmax: f32,
    after: (f32, u32, u32),
    /// Room, and how much of it is taken, in order.
    hits: &'b [Cell<Hit>],
    found: Found,
    /// Whether to find out if there are more.
    asks: bool,
}

impl Collect<'_> {
    /// Whether the triangle is hit at `t <= limit`. Not inlined: one copy serves all
    /// instruction sets.
    #[inline(never)]
    fn take(&mut self, line: &Line, triangle: &Triangle) -> bool {
        let Some(met) = meet(line, triangle, self.limit()) else {
            return false;
        };
        let here = (met.t, triangle.geom, triangle.prim);
        let hits = self.hits;
        let taken = &hits[..self.found.count];
        let at = taken.partition_point(|hit| place(&hit.get()) < here);
        let known = taken.get(at).is_some_and(|hit| place(&hit.get()) == here);
        if here > self.after && !known {
            if taken.len() < hits.len() {
                self.found.count += 1;
            } else {
                self.found.more = true;
            }
            let mut next = record(line, triangle, met);
            // What there is no room for falls off the end.
            for hit in &hits[at..self.found.count] {
                next = hit.replace(next);
            }
        }
        true
    }
}

impl Query for Collect<'_> {
    type Out = Found;

    fn miss(_: &Ray) -> Found {
        Found::default()
    }

    /// One that has no room.
    fn new(ray: &Ray) -> Self {
        let after = (f32::NEG_INFINITY, 0, 0);
        Self { tmax: ray.tmax, after, hits: &[], found: Found::default(), asks: true }
    }

    /// Until the room is full, and it is known that there are more, every hit counts.
    #[inline(always)]
    fn limit(&self) -> f32 {
        match self.hits.last() {
            Some(last)
                if self.found.count == self.hits.len() && (self.found.more || !self.asks) =>
            {
                last.get().t
            }
            _ => self.tmax,
        }
    }

    #[inline(always)]
    fn meet_from(&mut self, line: &Line, _: &Apex, triangle: &Triangle, _: u32) -> Option<bool> {
        self.take(line, triangle).then_some(false)
    }

    #[inline(always)]
    fn meet_in<L: Lanes>(&mut self, _: L, ray: &Ray, triangle: &Triangle, _: u32) -> Option<bool> {
        self.take(&Line::new(ray), triangle).then_some(false)
    }

    /// No packet collects.
    fn take_met(&mut self, _: Met, _: &Triangle, _: u32) -> bool {
        false
    }

    fn found(&self, _: &Sections<'_>, _: &Ray) -> Found {
        self.found
    }
}

/// A query in a scene that is not empty.
struct All<'a, 'b> {
    view: &'a View<'a>,
    ray: &'a Ray,
    query: Collect<'b>,
}

impl AnyKernel for All<'_, '_> {
    type Out = Found;
    const BEST: Isa = Isa::Avx2;
    #[inline(always)]
    fn run_on<L: Lanes>(self, lanes: L) -> Found {
        if !usable(lanes, self.ray) {
            return Collect::miss(self.ray);
        }
        let mut uncounted = Uncounted;
        let mut walk = Walk::new(lanes, self.view, self.ray, self.query, &mut uncounted);
        walk.run(&[]);
        walk.query.found
    }
}

impl View<'_> {
    /// The hits of `ray`, smallest t first, ties by lowest geometry, then primitive, each
    /// triangle once: as many as there is room for in `hits`, the first of them, and
    /// whether there are others. With `after`, one of the ray's hits, those that follow it
    /// in this order, so that nothing is lost or told twice if one call goes on where
    /// another ended. A miss, or a hit whose t is NaN, is followed by nothing. Without
    /// any room only whether there are hits is told.
    ///
    /// Each hit is what [`View::intersect`] writes. It takes about as long as walking to
    /// the last hit that is kept, or to the ray's end if there is room for all; hits that
    /// come out of order are moved in memory, so the time for very many in one place grows
    /// with their square. There is no form for streams: answers of unknown length would
    /// need memory for the worst case of every ray in flight.
    ///
    /// ```
    /// # let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// # let mesh = hug::Geometry::from_mesh(&vertices, &[[0, 1, 2], [1, 2, 3]]);
    /// # let scene = hug::Scene::build(&[mesh], &hug::Options::default())?;
    /// let ray = hug::Ray::new([0.25, 0.25, 2.0], [0.0, 0.0, -1.0]);
    /// let mut hits = [hug::Hit::miss(0.0); 4];
    /// let found = scene.view().intersect_all(&ray, None, &mut hits);
    /// assert_eq!((found.count, found.more), (2, false));
    /// assert_eq!((hits[0].t, hits[1].t), (1.5, 2.0));
    /// # Ok::<(), hug::Error>(())
    /// ```
    pub fn intersect_all(&self, ray: &Ray, after: Option<&Hit>, hits: &mut [Hit]) -> Found {
        if hits.is_empty() {
            let more = self.collect(ray, after, &mut [Hit::miss(0.0)], false).count > 0;
            return Found { count: 0, more };
        }
        self.collect(ray, after, hits, true)
    }

    /// [`View::intersect_all`] for some room; unless it `asks`, whether there are more is
    /// not found out.
    pub(super) fn collect(
        &self,
        ray: &Ray,
        after: Option<&Hit>,
        hits: &mut [Hit],
        asks: bool,
    ) -> Found {
        let mut rest = *ray;
        let mut query = Collect::new(ray);
        if let Some(hit) = after {
            query.after = place(hit);
            // Not so if one of them is NaN.
            if hit.t > rest.tmin {
                rest.tmin = hit.t;
            }
        }
        query.hits = Cell::from_mut(hits).as_slice_of_cells();
        query.asks = asks;
        fpenv::with_default(|| {
            if self.header().grids.count == 0 {
                return Found::default();
            }
            dispatch(All { view: self, ray: &rest, query })
        })
    }

    /// The hits of `ray` in the order of [`View::intersect_all`], found a few at a time.
    ///
    /// ```
    /// # let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// # let mesh = hug::Geometry::from_mesh(&vertices, &[[0, 1, 2], [2, 1, 0]]);
    /// # let scene = hug::Scene::build(&[mesh], &hug::Options::default())?;
    /// let ray = hug::Ray::new([0.25, 0.25, 2.0], [0.0, 0.0, -1.0]);
    /// let prims: Vec<u32> = scene.view().hits(&ray).map(|hit| hit.prim).collect();
    /// assert_eq!(prims, [0, 1]);
    /// # Ok::<(), hug::Error>(())
    /// ```
    #[must_use]
    pub fn hits(&self, ray: &Ray) -> Hits<'_> {
        Hits::new(*self, *ray, None)
    }
}

/// Hits fetched at a time, at most.
const FEW: usize = 8;

/// The hits of a ray, in order: [`View::hits`].
#[derive(Clone)]
pub struct Hits<'a> {
    view: View<'a>,
    ray: Ray,
    last: Option<Hit>,
    few: [Hit; FEW],
    at: usize,
    count: usize,
    /// How many to fetch next; 0 once there are none.
    want: usize,
}

impl<'a> Hits<'a> {
    /// Those after `last`.
    pub(super) fn new(view: View<'a>, ray: Ray, last: Option<Hit>) -> Self {
        Self { view, ray, last, few: [Hit::miss(0.0); FEW], at: 0, count: 0, want: 1 }
    }
}

impl Iterator for Hits<'_> {
    type Item = Hit;

    fn next(&mut self) -> Option<Hit> {
        if self.at == self.count && self.want > 0 {
            let room = &mut self.few[..self.want];
            self.count = self.view.collect(&self.ray, self.last.as_ref(), room, false).count;
            self.at = 0;
            // Who wants many is likely to want all.
            self.want = if self.count < self.want { 0 } else { (2 * self.want).min(FEW) };
        }
        let hit = *self.few[..self.count].get(self.at)?;
        self.at += 1;
        self.last = Some(hit);
        Some(hit)
    }
}

impl core::iter::FusedIterator for Hits<'_> {}
