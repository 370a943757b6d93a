//! One point, many triangles: which is nearest, and where?

use super::Triangle;
use super::dyadic::{Vector, common_exponent, cross, dot, scaled, sub};
use super::round::{root_to_f32, round_to_f32};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// The nearest point of a triangle, and what a perfect library would report of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearest {
    pub geom: u32,
    pub prim: u32,
    pub distance: f32,
    pub u: f32,
    pub v: f32,
    pub point: [f32; 3],
}

/// A point of a triangle: a + u (b - a) + v (c - a), and how far away.
struct Candidate {
    square: BigRational,
    u: BigRational,
    v: BigRational,
}

fn ratio(numer: BigInt, denom: BigInt) -> BigRational {
    BigRational::new(numer, denom)
}

/// How far along `edge`, from 0 to 1, the point is nearest that is at `p` seen from the edge's
/// start.
fn along(edge: &Vector, p: &Vector) -> BigRational {
    let (zero, one) = (BigRational::zero(), BigRational::one());
    ratio(dot(edge, p), dot(edge, edge)).clamp(zero, one)
}

/// The nearest point of a triangle with an area: of those nearest on the three edges and, if it
/// lies inside, the foot of the perpendicular.
fn on_triangle(p: &Vector, [a, b, c]: &[Vector; 3]) -> Candidate {
    let (ab, ac, ap) = (sub(b, a), sub(c, a), sub(p, a));
    let candidate = |u: BigRational, v: BigRational| {
        let square = (0..3)
            .map(|k| {
                let whole = |n: &BigInt| BigRational::from_integer(n.clone());
                let off = whole(&ap[k]) - &u * whole(&ab[k]) - &v * whole(&ac[k]);
                &off * &off
            })
            .sum();
        Candidate { square, u, v }
    };
    let (zero, one) = (BigRational::zero(), BigRational::one());
    let mut all =
        vec![candidate(along(&ab, &ap), zero.clone()), candidate(zero.clone(), along(&ac, &ap))];
    let third = along(&sub(c, b), &sub(p, b));
    all.push(candidate(&one - &third, third));
    let n = cross(&ab, &ac);
    let area = dot(&n, &n);
    let (u, v) = (dot(&n, &cross(&ap, &ac)), dot(&n, &cross(&ab, &ap)));
    if !u.is_negative() && !v.is_negative() && &u + &v <= area {
        all.push(candidate(ratio(u, area.clone()), ratio(v, area)));
    }
    all.into_iter().min_by(|a, b| a.square.cmp(&b.square)).expect("three at least")
}

/// True only if the box of a triangle, and so the triangle, is farther away than `limit`, by a
/// part in a million at least, which doubles can tell.
fn certainly_beyond(p: [f32; 3], corners: &Triangle, limit: f32) -> bool {
    let off = |k: usize| {
        let along = corners.map(|corner| f64::from(corner[k]));
        let (lo, hi) = (along[0].min(along[1]).min(along[2]), along[0].max(along[1]).max(along[2]));
        (lo - f64::from(p[k])).max(f64::from(p[k]) - hi).max(0.0)
    };
    off(0).max(off(1)).max(off(2)) > 1.000_001 * f64::from(limit)
}

/// The nearest triangle with an area among `(geom, prim, corners)`: smallest rounded distance, at
/// most `radius`, ties by lowest geometry, then lowest primitive. All coordinates are finite.
pub fn nearest(
    p: [f32; 3],
    radius: f32,
    triangles: impl IntoIterator<Item = (u32, u32, Triangle)>,
) -> Option<Nearest> {
    let mut best: Option<Nearest> = None;
    for (geom, prim, corners) in triangles {
        if certainly_beyond(p, &corners, best.as_ref().map_or(radius, |best| best.distance)) {
            continue;
        }
        let unit = common_exponent(corners.iter().flatten().chain(&p));
        let at = corners.map(|corner| scaled(corner, unit));
        if cross(&sub(&at[1], &at[0]), &sub(&at[2], &at[0])).iter().all(Zero::is_zero) {
            continue;
        }
        let found = on_triangle(&scaled(p, unit), &at);
        let power = |e: i32| {
            let two = BigInt::one() << e.unsigned_abs();
            if e < 0 { ratio(BigInt::one(), two) } else { BigRational::from_integer(two) }
        };
        let distance = root_to_f32(&(found.square * power(2 * unit)));
        let first = best
            .as_ref()
            .is_none_or(|best| (distance, geom, prim) < (best.distance, best.geom, best.prim));
        if !first || distance > radius || distance.is_infinite() {
            continue;
        }
        let whole = |n: &BigInt| BigRational::from_integer(n.clone());
        let point = [0, 1, 2].map(|k| {
            let (a, b, c) = (whole(&at[0][k]), whole(&at[1][k]), whole(&at[2][k]));
            let x = &a + &found.u * (b - &a) + &found.v * (c - &a);
            round_to_f32(&(x * power(unit)))
        });
        let (u, v) = (round_to_f32(&found.u), round_to_f32(&found.v));
        best = Some(Nearest { geom, prim, distance, u, v, point });
    }
    best
}
