//! The kinds of query: what becomes of a triangle that is met.

use crate::arena::View;
use crate::arena::layout::Triangle;
use crate::ray::{Hit, NONE, Ray};
use crate::simd::fpenv;
use crate::triangle::{Line, normal};

use crate::simd::{AnyKernel, Lanes, dispatch};

use super::counters::{Count, Counters, Uncounted};
use super::profile::Profile;
use super::walk::Walk;

/// What a walk looks for.
pub(crate) trait Query {
    /// The largest `t` of interest.
    fn limit(&self) -> f32;
    /// The walk ends at parameters greater than this: no less than the next
    /// `f32` after the limit, so that every t above it rounds to more.
    fn beyond(&self) -> f64;
    /// Takes a triangle if the line meets it at `t <= limit`; then `true` ends the
    /// walk.
    fn meet(&mut self, line: &Line, triangle: &Triangle, number: u32) -> Option<bool>;
}

/// A number above which every parameter rounds to more than `limit`, which is
/// not minus infinity.
#[inline(always)]
pub(super) fn beyond(limit: f32) -> f64 {
    let x = f64::from(limit);
    x + (x.abs() * f64::from(f32::EPSILON) + f64::from(f32::MIN_POSITIVE))
}

/// The hit of smallest `t`, ties by lowest geometry, then primitive.
pub(crate) struct Closest {
    limit: f32,
    beyond: f64,
    geom: u32,
    prim: u32,
    number: u32,
}

impl Closest {
    pub fn new(tmax: f32) -> Self {
        Self { limit: tmax, beyond: beyond(tmax), geom: NONE, prim: NONE, number: NONE }
    }

    /// The number of the triangle found and its `t`, or `None`.
    pub fn found(&self) -> Option<(u32, f32)> {
        (self.number != NONE).then_some((self.number, self.limit))
    }
}

impl Query for Closest {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.limit
    }

    #[inline(always)]
    fn beyond(&self) -> f64 {
        self.beyond
    }

    #[inline(always)]
    fn meet(&mut self, line: &Line, triangle: &Triangle, number: u32) -> Option<bool> {
        let t = line.meet(triangle, self.limit)?;
        if t < self.limit || (triangle.geom, triangle.prim) < (self.geom, self.prim) {
            let Triangle { geom, prim, .. } = *triangle;
            *self = Self { limit: t, beyond: beyond(t), geom, prim, number };
        }
        Some(false)
    }
}

/// Any hit at all.
pub(crate) struct Any {
    tmax: f32,
    found: bool,
}

impl Query for Any {
    #[inline(always)]
    fn limit(&self) -> f32 {
        self.tmax
    }

    #[inline(always)]
    fn beyond(&self) -> f64 {
        beyond(self.tmax)
    }

    #[inline(always)]
    fn meet(&mut self, line: &Line, triangle: &Triangle, _: u32) -> Option<bool> {
        self.found = line.pierces(triangle, self.tmax);
        self.found.then_some(true)
    }
}

/// Whether the ray can hit anything: everything that [`Ray`] lists as a miss
/// is not usable.
fn usable(ray: &Ray) -> bool {
    let finite = |v: &[f32; 3]| v.iter().all(|x| x.abs() < f32::INFINITY);
    let moves = ray.dir.iter().any(|x| *x != 0.0);
    // NaN fails the comparisons. No t is infinite.
    let range = ray.tmin <= ray.tmax && ray.tmin < f32::INFINITY && ray.tmax > f32::NEG_INFINITY;
    // One branch, not one for each number.
    finite(&ray.org) & finite(&ray.dir) & moves & range
}

impl View<'_> {
    /// The closest hit of `ray`, or the record of a miss.
    #[must_use]
    #[inline]
    pub fn intersect(&self, ray: &Ray) -> Hit {
        self.closest(ray, &mut Uncounted)
    }

    /// [`View::intersect`], adding what it did to `counters`.
    pub fn intersect_counted(&self, ray: &Ray, counters: &mut Counters) -> Hit {
        self.closest(ray, counters)
    }

    /// Whether `ray` hits anything.
    #[must_use]
    #[inline]
    pub fn occluded(&self, ray: &Ray) -> bool {
        self.any(ray, &mut Uncounted)
    }

    /// [`View::occluded`], adding what it did to `counters`.
    pub fn occluded_counted(&self, ray: &Ray, counters: &mut Counters) -> bool {
        self.any(ray, counters)
    }

    /// [`View::intersect`], adding what it did on each level to `profile`.
    pub fn intersect_profiled(&self, ray: &Ray, profile: &mut Profile) -> Hit {
        self.closest(ray, profile)
    }

    /// [`View::occluded`], adding what it did on each level to `profile`.
    pub fn occluded_profiled(&self, ray: &Ray, profile: &mut Profile) -> bool {
        self.any(ray, profile)
    }

    #[inline]
    fn closest<C: Count>(&self, ray: &Ray, counters: &mut C) -> Hit {
        fpenv::with_default(|| {
            if !usable(ray) || self.header().grids.count == 0 {
                return Hit::miss(ray.tmax);
            }
            dispatch(ClosestKernel { view: self, ray, counters })
        })
    }

    #[inline]
    fn any<C: Count>(&self, ray: &Ray, counters: &mut C) -> bool {
        fpenv::with_default(|| {
            usable(ray)
                && self.header().grids.count > 0
                && dispatch(AnyHitKernel { view: self, ray, counters })
        })
    }

    /// [`View::intersect`] by testing every triangle: the oracle that the
    /// structures are compared with. Cost: linear in the triangles.
    #[must_use]
    pub fn intersect_brute(&self, ray: &Ray) -> Hit {
        fpenv::with_default(|| {
            if !usable(ray) {
                return Hit::miss(ray.tmax);
            }
            let line = Line::new(ray);
            let mut query = Closest::new(ray.tmax);
            for (number, triangle) in (0..).zip(self.triangles()) {
                if visible(ray, triangle) {
                    query.meet(&line, triangle, number);
                }
            }
            match query.found() {
                Some((number, t)) => hit(&line, &self.triangles()[number as usize], t),
                None => Hit::miss(ray.tmax),
            }
        })
    }
}

struct ClosestKernel<'a, C> {
    view: &'a View<'a>,
    ray: &'a Ray,
    counters: &'a mut C,
}

impl<C: Count> AnyKernel for ClosestKernel<'_, C> {
    type Out = Hit;
    #[inline(always)]
    fn run_on<L: Lanes>(self, lanes: L) -> Hit {
        let query = Closest::new(self.ray.tmax);
        let mut walk = Walk::new(lanes, self.view, self.ray, query, self.counters);
        walk.run();
        match walk.query.found() {
            Some((number, t)) => {
                hit(&Line::new(self.ray), self.view.sections().triangle(number), t)
            }
            None => Hit::miss(self.ray.tmax),
        }
    }
}

struct AnyHitKernel<'a, C> {
    view: &'a View<'a>,
    ray: &'a Ray,
    counters: &'a mut C,
}

impl<C: Count> AnyKernel for AnyHitKernel<'_, C> {
    type Out = bool;
    #[inline(always)]
    fn run_on<L: Lanes>(self, lanes: L) -> bool {
        let query = Any { tmax: self.ray.tmax, found: false };
        let mut walk = Walk::new(lanes, self.view, self.ray, query, self.counters);
        walk.run();
        walk.query.found
    }
}

/// Whether the ray may meet this triangle: masks share a bit and it is not the
/// one to skip.
#[inline(always)]
pub(crate) fn visible(ray: &Ray, triangle: &Triangle) -> bool {
    ray.mask & triangle.mask != 0
        && (triangle.geom != ray.skip_geom || triangle.prim != ray.skip_prim)
}

#[inline(always)]
fn hit(line: &Line, triangle: &Triangle, t: f32) -> Hit {
    let (u, v) = line.weights(triangle);
    Hit {
        t,
        u,
        v,
        ng: normal(triangle),
        geom: triangle.geom,
        prim: triangle.prim,
        inst: NONE,
        reserved: 0,
    }
}
