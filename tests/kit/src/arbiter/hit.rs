//! One ray, one triangle.

use super::Triangle;
use super::dyadic::{common_exponent, cross, dot, scaled, sub};
use super::round::round_to_f32;
use crate::rays::Ray;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

/// A hit without error, and what a perfect library would report of it.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactHit {
    pub exact_t: BigRational,
    pub exact_u: BigRational,
    pub exact_v: BigRational,
    pub t: f32,
    pub u: f32,
    pub v: f32,
    /// Whether the ray comes from the side of the normal (v1 - v0) x (v2 - v0).
    pub front: bool,
}

/// Whether the query itself can hit anything: everything finite but tmin and tmax, the direction
/// not zero, the interval not empty.
pub fn is_query(ray: &Ray) -> bool {
    ray.org.iter().chain(&ray.dir).all(|c| c.is_finite())
        && ray.dir.iter().any(|&c| c != 0.0)
        && ray.tmin <= ray.tmax
}

/// The hit of `ray` on `tri`, if there is one. The ray's mask and what it skips play no part.
pub fn hit(ray: &Ray, tri: &Triangle) -> Option<ExactHit> {
    if !is_query(ray) || !tri.iter().flatten().all(|c| c.is_finite()) {
        return None;
    }
    // Positions in units of 2^unit, the direction in units of 2^pace.
    let unit = common_exponent(tri.iter().flatten().chain(&ray.org));
    let pace = common_exponent(&ray.dir);
    let dir = scaled(ray.dir, pace);
    let v0 = scaled(tri[0], unit);
    let edge1 = sub(&scaled(tri[1], unit), &v0);
    let edge2 = sub(&scaled(tri[2], unit), &v0);
    let from_v0 = sub(&scaled(ray.org, unit), &v0);

    // Cramer's rule on u edge1 + v edge2 - t dir = from_v0.
    let across = cross(&dir, &edge2);
    let mut det = dot(&edge1, &across);
    let mut u = dot(&from_v0, &across);
    let along = cross(&from_v0, &edge1);
    let mut v = dot(&dir, &along);
    let mut t = dot(&edge2, &along);
    // edge1 . (dir x edge2) is -dir . (edge1 x edge2).
    let front = det.is_positive();
    if det.is_negative() {
        (det, u, v, t) = (-det, -u, -v, -t);
    }
    if !det.is_positive() || u.is_negative() || v.is_negative() || &u + &v > det {
        return None;
    }

    let exact_t = match unit - pace {
        up @ 0.. => BigRational::new_raw(t << up, det.clone()),
        down => BigRational::new_raw(t, &det << -down),
    };
    let rounded = round_to_f32(&exact_t);
    if !rounded.is_finite() || rounded < ray.tmin || rounded > ray.tmax {
        return None;
    }
    let share = |n: BigInt| BigRational::new_raw(n, det.clone());
    let (exact_u, exact_v) = (share(u), share(v));
    Some(ExactHit {
        t: rounded,
        u: round_to_f32(&exact_u),
        v: round_to_f32(&exact_v),
        exact_t,
        exact_u,
        exact_v,
        front,
    })
}
