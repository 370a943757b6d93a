//! The first pass: the soup's triangles, without those that cannot be hit.

use super::scratch::Scratch;
use crate::Error;
use crate::aabb::Aabb;
use crate::arena::layout::Triangle;
use crate::geometry::Geometry;
use crate::triangle::degenerate;
use glam::Vec3A;

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
                // Zero times what is not finite is no number.
                if corners.as_flattened().iter().map(|x| x * 0.0).sum::<f32>() != 0.0 {
                    dropped_non_finite += 1;
                } else if !has_area(&corners) && degenerate(&corners) {
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

/// Whether a triangle with finite corners certainly has an area. Edges are off by
/// 2^-24 of themselves, so each part of their cross product by less than 2^-21 of
/// the product of the largest coordinates, if nothing overflows or underflows.
#[inline(always)]
fn has_area(corners: &[[f32; 3]; 3]) -> bool {
    let [a, b, c] = corners.map(Vec3A::from_array);
    let (e1, e2) = (b - a, c - a);
    let m = e1.abs().max_element() * e2.abs().max_element();
    m > 1e-30 && e1.cross(e2).abs().max_element() > m * (1.0 / (1 << 20) as f32)
}
