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
//! `f64` decides nearly always. Error bounds, with `e = 2^-53`, `m` the largest
//! coordinate seen from the origin, `s` the sum of |dir|: a difference of two
//! `f32` carries a relative error e, a product of two such 3e, a minor 4e of
//! its two products (at most `2 m^2`), its product with `dir` and the two sums 3e
//! more: `14 e m^2 s` for a determinant, `48 e m^3` for the height. Used are 16
//! and 64. Magnitudes lie within 2^-450 and 2^400, so `f64` neither overflows
//! nor loses bits to underflow. What the bounds leave open `exact` decides, so
//! the result does not depend on the order of operations, on fused
//! multiply-add, or on the instruction set.

use crate::exact::Meeting;
use crate::ray::Ray;

const E: f64 = 1.0 / (1u64 << 53) as f64;

/// A ray made ready for many triangles.
#[derive(Clone, Copy)]
pub struct Line {
    org: [f32; 3],
    dir: [f32; 3],
    o: [f64; 3],
    d: [f64; 3],
    /// Sum of the direction's magnitudes.
    s: f64,
    tmin: f32,
}

/// Where a line meets a triangle, in `f64` with error bounds.
struct Estimate {
    weight: [f64; 3],
    det: f64,
    height: f64,
    /// Error bound of each weight.
    weight_error: f64,
    /// Error bound of the height.
    height_error: f64,
}

enum Sides {
    Outside,
    Inside,
    Unsure,
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Line {
    pub fn new(ray: &Ray) -> Self {
        let d = ray.dir.map(f64::from);
        Self {
            org: ray.org,
            dir: ray.dir,
            o: ray.org.map(f64::from),
            d,
            s: d[0].abs() + d[1].abs() + d[2].abs(),
            tmin: ray.tmin,
        }
    }

    #[inline(always)]
    fn estimate(&self, triangle: &[[f32; 3]; 3]) -> Estimate {
        let from = |v: &[f32; 3]| {
            [
                f64::from(v[0]) - self.o[0],
                f64::from(v[1]) - self.o[1],
                f64::from(v[2]) - self.o[2],
            ]
        };
        let (a, b, c) = (from(&triangle[0]), from(&triangle[1]), from(&triangle[2]));
        let largest = |v: &[f64; 3]| v[0].abs().max(v[1].abs()).max(v[2].abs());
        let m = largest(&a).max(largest(&b)).max(largest(&c));
        let bc = cross(&b, &c);
        let weight = [
            dot(&self.d, &bc),
            dot(&self.d, &cross(&c, &a)),
            dot(&self.d, &cross(&a, &b)),
        ];
        Estimate {
            weight,
            det: weight[0] + weight[1] + weight[2],
            height: dot(&a, &bc),
            weight_error: 16.0 * E * m * m * self.s,
            height_error: 64.0 * E * m * m * m,
        }
    }

    /// The rounded `t` of the hit, if there is one with `tmin <= t <= tmax`.
    #[inline(always)]
    pub fn meet(&self, triangle: &[[f32; 3]; 3], tmax: f32) -> Option<f32> {
        let near = self.estimate(triangle);
        match near.sides() {
            Sides::Outside => None,
            Sides::Inside => {
                let (low, high) = near.t();
                if high < self.tmin || low > tmax {
                    None
                } else if low.to_bits() == high.to_bits() {
                    self.in_range(low, tmax)
                } else {
                    self.meet_exactly(triangle, tmax)
                }
            }
            Sides::Unsure => self.meet_exactly(triangle, tmax),
        }
    }

    #[cold]
    #[inline(never)]
    fn meet_exactly(&self, triangle: &[[f32; 3]; 3], tmax: f32) -> Option<f32> {
        let meeting = Meeting::new(&self.org, &self.dir, triangle);
        if meeting.pierces() {
            self.in_range(meeting.t(), tmax)
        } else {
            None
        }
    }

    /// A `t` too large for `f32` is no hit: no ray could be ended there.
    fn in_range(&self, t: f32, tmax: f32) -> Option<f32> {
        (t >= self.tmin && t <= tmax && t.abs() < f32::INFINITY).then_some(t)
    }

    /// The weights `u` of `v1` and `v` of `v2` where the line meets a triangle
    /// that it is known to pierce.
    pub fn weights(&self, triangle: &[[f32; 3]; 3]) -> (f32, f32) {
        let near = self.estimate(triangle);
        let ((u, u_high), (v, v_high)) = (near.weight(1), near.weight(2));
        if u.to_bits() == u_high.to_bits() && v.to_bits() == v_high.to_bits() {
            return (u, v);
        }
        let meeting = Meeting::new(&self.org, &self.dir, triangle);
        (meeting.weight(1), meeting.weight(2))
    }
}

impl Estimate {
    #[inline(always)]
    fn sides(&self) -> Sides {
        let [a, b, c] = self.weight;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let e = self.weight_error;
        if low < -e && high > e {
            Sides::Outside
        } else if low > e || high < -e {
            Sides::Inside
        } else {
            Sides::Unsure
        }
    }

    /// `f32` bounds of `num / det`, equal when the rounding is certain.
    #[inline(always)]
    fn quotient(&self, num: f64, num_error: f64) -> (f32, f32) {
        // Three determinants and two sums: below 4 of their bounds.
        let det_error = 4.0 * self.weight_error;
        let q = num / self.det;
        let room = self.det.abs() - det_error;
        if room <= 0.0 {
            return (f32::NEG_INFINITY, f32::INFINITY);
        }
        let error = (num_error + q.abs() * det_error) / room * (1.0 + 1e-6) + q.abs() * (4.0 * E);
        // Adding +0 turns -0 into +0 and changes nothing else.
        ((q - error) as f32 + 0.0, (q + error) as f32 + 0.0)
    }

    #[inline(always)]
    fn t(&self) -> (f32, f32) {
        self.quotient(self.height, self.height_error)
    }

    #[inline(always)]
    fn weight(&self, k: usize) -> (f32, f32) {
        self.quotient(self.weight[k], self.weight_error)
    }
}

/// `(v1 - v0) x (v2 - v0)` in `f64`, then rounded.
pub fn normal(triangle: &[[f32; 3]; 3]) -> [f32; 3] {
    let [a, b, c] = triangle.map(|v| v.map(f64::from));
    let e1 = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    let e2 = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    cross(&e1, &e2).map(|n| n as f32)
}

/// Whether the triangle has no area, exactly.
pub fn degenerate(triangle: &[[f32; 3]; 3]) -> bool {
    let [a, b, c] = triangle.map(|v| v.map(f64::from));
    let e1 = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    let e2 = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    let m = e1.iter().chain(&e2).fold(0.0f64, |m, x| m.max(x.abs()));
    let certain = cross(&e1, &e2).iter().any(|n| n.abs() > 16.0 * E * m * m);
    !certain && crate::exact::degenerate(triangle)
}
