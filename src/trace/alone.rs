//! A triangle on its own.

use super::query::{Closest, Query, usable, visible};
use crate::arena::layout::Triangle;
use crate::ray::{Hit, Ray};
use crate::simd::{Portable, fpenv};
use crate::triangle::{self, Line, Met};

/// [`Line::meet`]. Not inlined, here and below: one copy serves all that need not be the
/// fastest.
#[inline(never)]
pub(super) fn meet(line: &Line, triangle: &Triangle, limit: f32) -> Option<Met> {
    line.meet(&line.apex(triangle), triangle, limit)
}

/// The record of a hit.
#[inline(never)]
pub(super) fn record(line: &Line, triangle: &Triangle, Met { t, weights, normal }: Met) -> Hit {
    let (u, v) = weights.unwrap_or_else(|| line.weights(triangle));
    let ng = normal.unwrap_or_else(|| triangle::normal(triangle));
    Hit { t, u, v, ng, geom: triangle.geom, prim: triangle.prim, ..Hit::miss(t) }
}

/// The hit of `ray` on a triangle, or the record of a miss: what [`crate::View::intersect`]
/// finds in a scene of this triangle alone, which is primitive 0 of geometry 0 there and
/// has all bits of the mask. A triangle without area, or with a corner that is not
/// finite, is never hit.
///
/// ```
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let ray = hug::Ray::new([0.25, 0.5, 2.0], [0.0, 0.0, -1.0]);
/// let hit = hug::intersect_triangle(&ray, &corners);
/// assert_eq!((hit.t, hit.u, hit.v), (2.0, 0.25, 0.5));
/// ```
#[must_use]
pub fn intersect_triangle(ray: &Ray, corners: &[[f32; 3]; 3]) -> Hit {
    fpenv::with_default(|| {
        let finite = corners.as_flattened().iter().all(|x| x.is_finite());
        let triangle = Triangle::new(corners, 0, 0, u32::MAX);
        if !finite || !usable(Portable, ray) || !visible(ray, &triangle) {
            return Closest::miss(ray);
        }
        let line = Line::new(ray);
        let met = meet(&line, &triangle, ray.tmax);
        met.map_or_else(|| Closest::miss(ray), |met| record(&line, &triangle, met))
    })
}
