//! Diffuse bounces.

use super::{FAR, Hit, Ray, Start, narrow};
use crate::Bounds;
use crate::random::Random;
use core::f64::consts::TAU;
use glam::DVec3;

/// How many rays [`bounce`] makes.
pub fn bounce_count(hits: &[Hit]) -> usize {
    hits.iter().filter(|h| h.is_hit()).count()
}

/// One cosine-weighted ray from each hit. `number` is 1 after the primary rays, 2 after bounce 1.
///
/// Every ray draws its numbers whether it hit or not, so that two tracers that disagree on one
/// ray still agree on the directions of all others.
pub fn bounce(
    number: u32,
    bounds: &Bounds,
    rays: &[Ray],
    hits: &[Hit],
) -> impl Iterator<Item = Ray> {
    let diagonal = bounds.diagonal();
    let mut random = Random::stream(u64::from(number));
    rays.iter().zip(hits).filter_map(move |(ray, hit)| {
        let (square, turn) = (random.unit(), random.unit());
        hit.is_hit().then(|| {
            let start = Start::new(ray, hit, diagonal);
            let dir = cosine_weighted(start.normal, square, turn);
            Ray::new(narrow(start.org), narrow(dir), 0.0, FAR)
        })
    })
}

/// Malley's method: a uniform point of the disc, lifted to the hemisphere about `normal`.
fn cosine_weighted(normal: DVec3, square: f64, turn: f64) -> DVec3 {
    let side = if normal.x.abs() < 0.6 { DVec3::X } else { DVec3::Y };
    let tangent = normal.cross(side).normalize();
    let bitangent = normal.cross(tangent);
    let (radius, height) = (libm::sqrt(square), libm::sqrt(1.0 - square));
    let phi = TAU * turn;
    let dir = tangent * (radius * libm::cos(phi))
        + bitangent * (radius * libm::sin(phi))
        + normal * height;
    dir.normalize()
}
