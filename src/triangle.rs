//! The hit, defined: does this ray pierce this triangle, and where?
//!
//! A hit is what real arithmetic says it is. The line `org + t dir` pierces the
//! closed triangle `a, b, c` (seen from `org`) if the three determinants
//! `dir . (b x c)`, `dir . (c x a)`, `dir . (a x b)` have no two opposite signs
//! and their sum is not zero; `t`, `u` and `v` are the real quotients, rounded
//! once to `f32`; range and order are decided on the rounded `t`. Watertight
//! meshes follow: a line through a closed mesh pierces one of its closed
//! triangles, at any scale, as in Woop, Benthin & Wald (2013) but with no
//! perturbation of the vertices.
//!
//! `f64` decides nearly always, on the edges `e1 = b - a`, `e2 = c - a` (Moeller &
//! Trumbore 1997), whose smallness keeps the errors small. With e = 2^-53, a
//! difference of two `f32` carries a relative error e; a product of three factors,
//! two of them differences, 4e; the sum of six such products 3e more of its
//! magnitudes. With s the sum of |dir| and m1, m2, m0 the largest coordinates of e1,
//! e2 and `org - a`, the six products of a determinant sum up to at most `2 s m m`
//! of the two m involved, of the height to `6 m0 m1 m2`: errors `14 e s m m` and
//! `48 e m0 m1 m2`. The third weight, `det - u - v`, rounds twice more, by less than
//! `4 e s m m` for each of the three; used are 20 for all of them and 64 for the
//! height. Magnitudes lie within 2^-450 and 2^400, so `f64` neither overflows nor
//! loses bits to underflow. What the bounds leave open `exact` decides, so the
//! result does not depend on the order of operations, on fused multiply-add, or on
//! the instruction set.

use crate::arena::layout::Triangle;
use crate::exact::{self, Case};
use crate::ray::Ray;

const E: f64 = 1.0 / (1u64 << 53) as f64;

type Vector = [f64; 3];

/// The corners of a triangle, however they are stored.
pub trait Corners {
    fn corner(&self, i: usize) -> [f32; 3];

    fn all(&self) -> [[f32; 3]; 3] {
        [0, 1, 2].map(|i| self.corner(i))
    }
}

impl Corners for [[f32; 3]; 3] {
    #[inline(always)]
    fn corner(&self, i: usize) -> [f32; 3] {
        self[i]
    }
}

impl Corners for Triangle {
    #[inline(always)]
    fn corner(&self, i: usize) -> [f32; 3] {
        [self.x[i], self.y[i], self.z[i]]
    }
}

/// A ray made ready for many triangles.
#[derive(Clone, Copy)]
pub struct Line {
    org: Vector,
    dir: Vector,
    tmin: f32,
}

/// Where a line meets a triangle: `u`, `v` and `t` are these over `det`.
struct Estimate {
    u: f64,
    v: f64,
    height: f64,
    det: f64,
    /// Bounds of their errors.
    u_error: f64,
    v_error: f64,
    height_error: f64,
    det_error: f64,
}

enum Sides {
    Outside,
    Inside,
    Unsure,
}

/// Bounds of a quotient, as `f32`; equal if the rounding is certain.
struct Range {
    low: f32,
    high: f32,
}

#[inline(always)]
fn double(v: [f32; 3]) -> Vector {
    v.map(f64::from)
}

#[inline(always)]
fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// One instruction, unlike `f64::max`, which minds NaN.
#[inline(always)]
fn max(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[inline(always)]
fn min(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn largest(a: Vector) -> f64 {
    max(max(a[0].abs(), a[1].abs()), a[2].abs())
}

impl Line {
    #[inline(always)]
    pub fn new(ray: &Ray) -> Self {
        Self { org: double(ray.org), dir: double(ray.dir), tmin: ray.tmin }
    }

    #[inline(always)]
    fn estimate(&self, triangle: &impl Corners) -> Estimate {
        let [a, b, c] = [0, 1, 2].map(|i| double(triangle.corner(i)));
        let (e1, e2, from) = (sub(b, a), sub(c, a), sub(self.org, a));
        let (p, q) = (cross(self.dir, e2), cross(from, e1));
        let (m0, m1, m2) = (largest(from), largest(e1), largest(e2));
        let bound = (20.0 * E) * (self.dir[0].abs() + self.dir[1].abs() + self.dir[2].abs());
        Estimate {
            u: dot(from, p),
            v: dot(self.dir, q),
            height: dot(e2, q),
            det: dot(e1, p),
            u_error: bound * (m0 * m2),
            v_error: bound * (m0 * m1),
            height_error: (64.0 * E) * m0 * (m1 * m2),
            det_error: bound * (m1 * m2),
        }
    }

    /// The rounded `t` of the hit, if there is one with `tmin <= t <= tmax`.
    #[inline(always)]
    pub fn meet(&self, triangle: &impl Corners, tmax: f32) -> Option<f32> {
        let near = self.estimate(triangle);
        match near.sides() {
            Sides::Outside => None,
            Sides::Inside => {
                let t = near.quotient(near.height, near.height_error);
                if t.low == t.high {
                    self.in_range(t.low, tmax)
                } else if t.high < self.tmin || t.low > tmax {
                    None
                } else {
                    self.in_range(self.t_inside(&triangle.all()), tmax)
                }
            }
            Sides::Unsure => self.meet_exactly(&triangle.all(), tmax),
        }
    }

    /// Whether there is a hit with `tmin <= t <= tmax`.
    #[inline(always)]
    pub fn pierces(&self, triangle: &impl Corners, tmax: f32) -> bool {
        let near = self.estimate(triangle);
        match near.sides() {
            Sides::Outside => false,
            Sides::Inside => {
                let t = near.quotient(near.height, near.height_error);
                if t.low >= self.tmin && t.high <= tmax && t.high < f32::INFINITY {
                    t.low > f32::NEG_INFINITY
                } else if t.high < self.tmin || t.low > tmax {
                    false
                } else {
                    self.in_range(self.t_inside(&triangle.all()), tmax).is_some()
                }
            }
            Sides::Unsure => self.meet_exactly(&triangle.all(), tmax).is_some(),
        }
    }

    /// The weights `u` of `v1` and `v` of `v2` where the line meets a triangle
    /// that it is known to pierce.
    #[inline]
    pub fn weights(&self, triangle: &impl Corners) -> (f32, f32) {
        let near = self.estimate(triangle);
        if near.det.abs() > 3.0 * near.det_error {
            let (u, v) = (near.quotient(near.u, near.u_error), near.quotient(near.v, near.v_error));
            if u.low == u.high && v.low == v.high {
                return (u.low + 0.0, v.low + 0.0);
            }
        }
        self.weights_exactly(&triangle.all())
    }

    /// A `t` too large for `f32` is no hit: no ray could be ended there.
    #[inline(always)]
    fn in_range(&self, t: f32, tmax: f32) -> Option<f32> {
        // Adding +0 turns -0 into +0 and changes nothing else.
        (t >= self.tmin && t <= tmax && t.abs() < f32::INFINITY).then_some(t + 0.0)
    }

    fn case(&self, corners: &[[f32; 3]; 3]) -> Case {
        // They were widened without loss.
        Case::new(self.org.map(|x| x as f32), self.dir.map(|x| x as f32), *corners)
    }

    #[cold]
    #[inline(never)]
    fn t_inside(&self, corners: &[[f32; 3]; 3]) -> f32 {
        self.case(corners).t_inside()
    }

    #[cold]
    #[inline(never)]
    fn meet_exactly(&self, corners: &[[f32; 3]; 3], tmax: f32) -> Option<f32> {
        self.case(corners).t().and_then(|t| self.in_range(t, tmax))
    }

    #[cold]
    #[inline(never)]
    fn weights_exactly(&self, corners: &[[f32; 3]; 3]) -> (f32, f32) {
        self.case(corners).weights()
    }
}

impl Estimate {
    #[inline(always)]
    fn sides(&self) -> Sides {
        let (u, v, w) = (self.u, self.v, self.det - self.u - self.v);
        let error = self.u_error + self.v_error + self.det_error;
        let (lowest, highest) = (min(min(u, v), w), max(max(u, v), w));
        if max(lowest, -highest) > error {
            Sides::Inside
        } else if min(-lowest, highest) > error {
            Sides::Outside
        } else {
            Sides::Unsure
        }
    }

    /// `num / det`, where |det| is more than thrice its error: seen from the sum of
    /// three weights of one sign above it, or asked for.
    ///
    /// With r the factor from `det` to its least true value, at most 3/2, the
    /// quotient is off by `r (error + |q| det_error) / |det|` and three roundings, two
    /// more follow; each is less than `4 e s m1 m2 |q| / |det|`, so the unused part of
    /// doubling the bound covers them: 2 * 20 > 3/2 * 14 + 4 * 4.
    #[inline(always)]
    fn quotient(&self, num: f64, error: f64) -> Range {
        let inverse = 1.0 / self.det;
        let q = num * inverse;
        let error = (error + q.abs() * self.det_error) * (2.0 * inverse.abs());
        Range { low: (q - error) as f32, high: (q + error) as f32 }
    }
}

/// `(v1 - v0) x (v2 - v0)` in `f64`, then rounded.
pub fn normal(triangle: &impl Corners) -> [f32; 3] {
    let [a, b, c] = triangle.all().map(double);
    cross(sub(b, a), sub(c, a)).map(|n| n as f32)
}

/// Whether the triangle has no area, exactly.
#[inline]
pub fn degenerate(corners: &[[f32; 3]; 3]) -> bool {
    let [a, b, c] = corners.map(double);
    let (e1, e2) = (sub(b, a), sub(c, a));
    // Equal products of differences are computed equal but for three roundings
    // each: a difference of more than 6 e and a little of either is none of theirs.
    let differ = |i: usize, j: usize| {
        let (one, other) = (e1[i] * e2[j], e1[j] * e2[i]);
        (one - other).abs() > (8.0 * E) * one.abs()
    };
    let certain = differ(0, 1) || differ(1, 2) || differ(2, 0);
    !certain && exact::degenerate(corners)
}
