//! One ray, many triangles.

use super::filter::certainly_misses;
use super::hit::is_query;
use super::{ExactHit, Triangle, hit};
use crate::rays::Ray;
use core::cmp::Ordering;

/// A hit and whose it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Closest {
    pub geom: u32,
    pub prim: u32,
    pub hit: ExactHit,
}

impl Closest {
    /// Whether this hit comes before `other`: by rounded t, then geometry, then primitive.
    pub fn before(&self, other: &Self) -> bool {
        (self.hit.t, self.geom, self.prim) < (other.hit.t, other.geom, other.prim)
    }
}

/// The hit on one triangle of a scene, unless the ray skips that triangle.
pub fn hit_named(ray: &Ray, geom: u32, prim: u32, tri: &Triangle) -> Option<Closest> {
    if (ray.skip_geom, ray.skip_prim) == (geom, prim) {
        return None;
    }
    hit(ray, tri).map(|hit| Closest { geom, prim, hit })
}

/// Every hit, in the order of the triangles.
fn hits<'a>(
    ray: &'a Ray,
    triangles: impl IntoIterator<Item = (u32, u32, Triangle), IntoIter: 'a>,
) -> impl Iterator<Item = Closest> + 'a {
    let query = is_query(ray);
    triangles.into_iter().take_while(move |_| query).filter_map(move |(geom, prim, tri)| {
        let candidate = !certainly_misses(ray, &tri);
        candidate.then(|| hit_named(ray, geom, prim, &tri)).flatten()
    })
}

/// The closest hit among `(geom, prim, corners)`: smallest rounded t, ties by lowest geometry,
/// then lowest primitive. The caller leaves out what the ray's mask hides.
pub fn closest(
    ray: &Ray,
    triangles: impl IntoIterator<Item = (u32, u32, Triangle)>,
) -> Option<Closest> {
    hits(ray, triangles).reduce(|best, next| if next.before(&best) { next } else { best })
}

/// Every hit, in the order of [`closest`].
pub fn all(ray: &Ray, triangles: impl IntoIterator<Item = (u32, u32, Triangle)>) -> Vec<Closest> {
    let mut all: Vec<_> = hits(ray, triangles).collect();
    all.sort_by(|a, b| if a.before(b) { Ordering::Less } else { Ordering::Greater });
    all
}

/// Whether there is any hit.
pub fn occluded(ray: &Ray, triangles: impl IntoIterator<Item = (u32, u32, Triangle)>) -> bool {
    hits(ray, triangles).next().is_some()
}
