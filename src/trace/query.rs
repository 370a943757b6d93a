//! The kinds of query: what becomes of a triangle that is met.

use crate::arena::View;
use crate::arena::layout::Triangle;
use crate::ray::{Hit, NONE, Ray};
use crate::simd::fpenv;
use crate::triangle::{Line, normal};

use super::counters::{Count, Counters, Uncounted};
use super::walk::Walk;

/// What a walk looks for.
pub(crate) trait Query {
    /// The largest `t` of interest; the walk ends beyond it.
    fn limit(&self) -> f32;
    /// Takes a triangle met at `t <= limit`; `true` ends the walk.
    fn meet(&mut self, t: f32, triangle: &Triangle, number: u32) -> bool;
}

/// The hit of smallest `t`, ties by lowest geometry, then primitive.
pub(crate) struct Closest {
    limit: f32,
    geom: u32,
    prim: u32,
    number: u32,
}

impl Closest {
    pub fn new(tmax: f32) -> Self {
        Self {
            limit: tmax,
            geom: NONE,
            prim: NONE,
            number: NONE,
        }
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
    fn meet(&mut self, t: f32, triangle: &Triangle, number: u32) -> bool {
        if t < self.limit || (triangle.geom, triangle.prim) < (self.geom, self.prim) {
            *self = Self {
                limit: t,
                geom: triangle.geom,
                prim: triangle.prim,
                number,
            };
        }
        false
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
    fn meet(&mut self, _: f32, _: &Triangle, _: u32) -> bool {
        self.found = true;
        true
    }
}

/// Whether the ray can hit anything: everything that [`Ray`] lists as a miss
/// is not usable.
fn usable(ray: &Ray) -> bool {
    let finite = |v: &[f32; 3]| v.iter().all(|x| x.is_finite());
    // Bits, not values: a denormal is not zero, whatever the caller's mode.
    let moves = ray.dir.iter().any(|x| x.to_bits() << 1 != 0);
    // NaN fails the comparison.
    finite(&ray.org) && finite(&ray.dir) && moves && ray.tmin <= ray.tmax
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

    fn closest<C: Count>(&self, ray: &Ray, counters: &mut C) -> Hit {
        fpenv::with_default(|| {
            if !usable(ray) || self.header().grids.count == 0 {
                return Hit::miss(ray.tmax);
            }
            let line = Line::new(ray);
            let mut query = Closest::new(ray.tmax);
            Walk::new(self, ray, &line, &mut query, counters).run();
            match query.found() {
                Some((number, t)) => hit(&line, self.sections().triangle(number), t),
                None => Hit::miss(ray.tmax),
            }
        })
    }

    fn any<C: Count>(&self, ray: &Ray, counters: &mut C) -> bool {
        fpenv::with_default(|| {
            if !usable(ray) || self.header().grids.count == 0 {
                return false;
            }
            let line = Line::new(ray);
            let mut query = Any {
                tmax: ray.tmax,
                found: false,
            };
            Walk::new(self, ray, &line, &mut query, counters).run();
            query.found
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
                if visible(ray, triangle)
                    && let Some(t) = line.meet(&triangle.corners, query.limit())
                {
                    query.meet(t, triangle, number);
                }
            }
            match query.found() {
                Some((number, t)) => hit(&line, &self.triangles()[number as usize], t),
                None => Hit::miss(ray.tmax),
            }
        })
    }
}

/// Whether the ray may meet this triangle: masks share a bit and it is not the
/// one to skip.
#[inline(always)]
pub(crate) fn visible(ray: &Ray, triangle: &Triangle) -> bool {
    ray.mask & triangle.mask != 0
        && (triangle.geom != ray.skip_geom || triangle.prim != ray.skip_prim)
}

fn hit(line: &Line, triangle: &Triangle, t: f32) -> Hit {
    let (u, v) = line.weights(&triangle.corners);
    Hit {
        t,
        u,
        v,
        ng: normal(&triangle.corners),
        geom: triangle.geom,
        prim: triangle.prim,
        inst: NONE,
        reserved: 0,
    }
}
