//! The first pass: the soup's triangles, without those that cannot be hit.

use core::ops::Range;

use super::control::{Control, TASKS, parts};
use super::scratch::{Scratch, cut};
use crate::Error;
use crate::aabb::Aabb;
use crate::arena::layout::Triangle;
use crate::geometry::Geometry;
use crate::simd::fetch;
use crate::triangle::degenerate;
use glam::Vec3A;

/// The triangles of a scene, in the order of the soup.
pub struct Soup<'s> {
    pub triangles: &'s [Triangle],
    /// Their boxes, if the structure needs them.
    pub boxes: &'s [Aabb],
    pub bounds: Aabb,
    pub dropped_non_finite: u64,
    pub dropped_degenerate: u64,
}

/// Triangles of a part, at most.
const PART: usize = 4096;
/// By how many triangles memory is asked for ahead.
pub const SOON: usize = 16;

/// Some triangles of a geometry, and where they go.
struct Part<'a> {
    geom: u32,
    geometry: &'a Geometry<'a>,
    prims: Range<usize>,
    triangles: &'a mut [Triangle],
    boxes: &'a mut [Aabb],
    found: Result<Found, Error>,
}

/// What a part holds.
#[derive(Clone, Copy)]
struct Found {
    kept: usize,
    bounds: Aabb,
    dropped_non_finite: u64,
    dropped_degenerate: u64,
}

const NOTHING: Found =
    Found { kept: 0, bounds: Aabb::EMPTY, dropped_non_finite: 0, dropped_degenerate: 0 };

impl<'s> Soup<'s> {
    /// Cost: linear, one exact test for each triangle without certain area.
    pub fn gather(
        soup: &[Geometry<'_>],
        (capacity, boxes): (usize, usize),
        scratch: &mut Scratch<'s>,
        control: &mut Control<'_>,
    ) -> Result<Self, Error> {
        let triangles = scratch.take::<Triangle>(capacity)?;
        let boxes = scratch.take::<Aabb>(boxes)?;
        let mut all = NOTHING;
        let mut looked_at = 0;
        let mut ranges = (0..).zip(soup).flat_map(|(geom, geometry)| {
            let count = geometry.triangle_count();
            let starts = (0..count).step_by(PART);
            starts.map(move |start| (geom, geometry, start..count.min(start + PART)))
        });
        loop {
            let kept = all.kept.min(boxes.len());
            let free = (&mut triangles[all.kept..], &mut boxes[kept..]);
            let (found, seen) = batch(&mut ranges, free, control)?;
            if seen == 0 {
                break;
            }
            // Closes the gaps that dropped triangles leave.
            let mut start = all.kept;
            for (len, part) in found.into_iter().flatten() {
                if start != all.kept {
                    triangles.copy_within(start..start + part.kept, all.kept);
                    if !boxes.is_empty() {
                        boxes.copy_within(start..start + part.kept, all.kept);
                    }
                }
                start += len;
                all.kept += part.kept;
                all.bounds.join(&part.bounds);
                all.dropped_non_finite += part.dropped_non_finite;
                all.dropped_degenerate += part.dropped_degenerate;
            }
            looked_at += seen;
            control.count(seen);
            control.at(looked_at, capacity)?;
        }
        Ok(Self {
            triangles: &triangles[..all.kept],
            boxes: &boxes[..all.kept.min(boxes.len())],
            bounds: all.bounds,
            dropped_non_finite: all.dropped_non_finite,
            dropped_degenerate: all.dropped_degenerate,
        })
    }

    /// Writes some of the triangles, in this order.
    pub fn copy(
        &self,
        order: &[u32],
        to: &mut [Triangle],
        control: &mut Control<'_>,
    ) -> Result<(), Error> {
        let mut done = 0;
        for (to, batch) in to.chunks_mut(PART * TASKS).zip(order.chunks(PART * TASKS)) {
            let mut some = to.chunks_mut(PART).zip(batch.chunks(PART));
            let mut tasks = parts(|| some.next());
            control.each(&mut tasks, |(to, order)| {
                for (i, (to, &from)) in to.iter_mut().zip(*order).enumerate() {
                    if let Some(&soon) = order.get(i + SOON) {
                        fetch(&raw const self.triangles[soon as usize]);
                    }
                    *to = self.triangles[from as usize];
                }
            })?;
            done += batch.len();
            control.count(batch.len());
            control.at(done, order.len())?;
        }
        Ok(())
    }

    /// Moves the triangles into this order, so that what is near in space is near in memory,
    /// too; they then are in the order of their numbers.
    pub fn reorder(
        &mut self,
        order: &mut [u32],
        scratch: &mut Scratch<'s>,
        control: &mut Control<'_>,
    ) -> Result<(), Error> {
        let to = scratch.take(order.len())?;
        self.copy(order, to, control)?;
        self.triangles = to;
        (0..).zip(order).for_each(|(i, to)| *to = i);
        Ok(())
    }
}

/// The size of each part of a batch and what it holds, and their triangles' number.
type Batch = ([Option<(usize, Found)>; TASKS], usize);

/// Looks at the next triangles, as many as there are tasks for; each part keeps its
/// own at the start of its range of `triangles` and `boxes`.
fn batch<'a>(
    ranges: &mut impl Iterator<Item = (u32, &'a Geometry<'a>, Range<usize>)>,
    (mut triangles, mut boxes): (&mut [Triangle], &mut [Aabb]),
    control: &Control<'_>,
) -> Result<Batch, Error> {
    let mut parts = parts(|| {
        let (geom, geometry, prims) = ranges.next()?;
        let count = if boxes.is_empty() { 0 } else { prims.len() };
        let (triangles, boxes) = (cut(&mut triangles, prims.len()), cut(&mut boxes, count));
        Some(Part { geom, geometry, prims, triangles, boxes, found: Ok(NOTHING) })
    });
    control.each(&mut parts, |part| part.found = part.look())?;
    let (mut found, mut seen) = ([None; TASKS], 0);
    for (found, part) in found.iter_mut().zip(parts.iter().flatten()) {
        *found = Some((part.prims.len(), part.found?));
        seen += part.prims.len();
    }
    Ok((found, seen))
}

impl Part<'_> {
    fn look(&mut self) -> Result<Found, Error> {
        let mut found = NOTHING;
        let mask = self.geometry.mask();
        let [mut lowest, mut highest] = [NOTHING.bounds.lo, NOTHING.bounds.hi].map(Vec3A::from);
        for prim in self.prims.clone() {
            let corners = self.geometry.triangle(prim)?;
            let [a, b, c] = corners.map(Vec3A::from_array);
            // Zero times what is not finite is no number.
            if !(a * 0.0 + b * 0.0 + c * 0.0).cmpeq(Vec3A::ZERO).all() {
                found.dropped_non_finite += 1;
            } else if !has_area(a, b, c) && degenerate(&corners) {
                found.dropped_degenerate += 1;
            } else {
                self.triangles[found.kept] = Triangle::new(&corners, self.geom, prim as u32, mask);
                if let Some(slot) = self.boxes.get_mut(found.kept) {
                    *slot = Aabb::of(&corners);
                }
                // Zeros are positive, as in `Aabb::of`.
                lowest = lowest.min(a.min(b).min(c) + Vec3A::ZERO);
                highest = highest.max(a.max(b).max(c) + Vec3A::ZERO);
                found.kept += 1;
            }
        }
        found.bounds = Aabb { lo: lowest.to_array(), hi: highest.to_array() };
        Ok(found)
    }
}

/// Whether a triangle with finite corners certainly has an area. Edges are off by
/// 2^-24 of themselves, so each part of their cross product by less than 2^-21 of
/// the product of the largest coordinates, if nothing overflows or underflows.
#[inline(always)]
fn has_area(a: Vec3A, b: Vec3A, c: Vec3A) -> bool {
    let (e1, e2) = (b - a, c - a);
    let m = e1.abs().max_element() * e2.abs().max_element();
    m > 1e-30 && e1.cross(e2).abs().max_element() > m * (1.0 / (1 << 20) as f32)
}
