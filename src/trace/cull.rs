//! Culling by the side of a triangle that a ray comes from.

use crate::arena::layout::Triangle;
use crate::ray::Ray;
use crate::triangle::Line;

/// Whether the ray's flags leave out the side of `triangle` that it comes from. Apart,
/// so that rays without flags pay for nothing but looking at them.
#[cold]
#[inline(never)]
pub(super) fn culled(ray: &Ray, triangle: &Triangle) -> bool {
    let side =
        if Line::new(ray).comes_from_front(triangle) { Ray::CULL_FRONT } else { Ray::CULL_BACK };
    ray.flags & side != 0
}
