//! The first pass: the soup's triangles, without those that cannot be hit.

use super::scratch::Scratch;
use crate::Error;
use crate::aabb::Aabb;
use crate::arena::layout::Triangle;
use crate::geometry::Geometry;
use crate::triangle::degenerate;

/// The triangles of a scene and their boxes, in the order of the soup.
pub struct Soup<'s> {
    pub triangles: &'s [Triangle],
    pub boxes: &'s [Aabb],
    pub bounds: Aabb,
    pub dropped_non_finite: u64,
    pub dropped_degenerate: u64,
}

impl<'s> Soup<'s> {
    /// Cost: linear, one exact test for each triangle without certain area.
    pub fn gather(
        soup: &[Geometry<'_>],
        capacity: usize,
        scratch: &mut Scratch<'s>,
    ) -> Result<Self, Error> {
        let triangles = scratch.take::<Triangle>(capacity)?;
        let boxes = scratch.take::<Aabb>(capacity)?;
        let mut bounds = Aabb::EMPTY;
        let (mut kept, mut dropped_non_finite, mut dropped_degenerate) = (0, 0, 0);
        for (geom, geometry) in (0..).zip(soup) {
            for prim in 0..geometry.triangle_count() {
                let corners = geometry.triangle(prim)?;
                if !corners.as_flattened().iter().all(|x| x.is_finite()) {
                    dropped_non_finite += 1;
                } else if degenerate(&corners) {
                    dropped_degenerate += 1;
                } else {
                    let mask = geometry.mask();
                    triangles[kept] = Triangle::new(&corners, geom, prim as u32, mask);
                    boxes[kept] = Aabb::of(&corners);
                    bounds.join(&boxes[kept]);
                    kept += 1;
                }
            }
        }
        Ok(Self {
            triangles: &triangles[..kept],
            boxes: &boxes[..kept],
            bounds,
            dropped_non_finite,
            dropped_degenerate,
        })
    }
}
