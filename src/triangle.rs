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
//! `48 e m0 m1 m2`; used are 16 and 64. Magnitudes lie within 2^-450 and 2^400, so
//! `f64` neither overflows nor loses bits to underflow. What the bounds leave open
//! `exact` decides, so the result does not depend on the order of operations, on
//! fused multiply-add, or on the instruction set.

use crate::exact::Case;
use crate::ray::Ray;

use glam::DVec3;

const E: f64 = 1.0 / (1u64 << 53) as f64;

/// A ray made ready for many triangles.
#[derive(Clone, Copy)]
pub struct Line {
    org: [f32; 3],
    dir: [f32; 3],
    o: DVec3,
    d: DVec3,
    /// Sum of the direction's magnitudes.
    s: f64,
    tmin: f32,
}

/// A number and a bound of its error.
#[derive(Clone, Copy)]
struct About {
    value: f64,
    error: f64,
}

/// Where a line meets a triangle: `u`, `v` and `t` are these over `det`.
struct Estimate {
    u: About,
    v: About,
    height: About,
    det: About,
}

enum Sides {
    Outside,
    Inside,
    Unsure,
}

fn double(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

impl Line {
    pub fn new(ray: &Ray) -> Self {
        let d = double(ray.dir);
        Self {
            org: ray.org,
            dir: ray.dir,
            o: double(ray.org),
            d,
            s: d.abs().element_sum(),
            tmin: ray.tmin,
        }
    }

    #[inline(always)]
    fn estimate(&self, triangle: &[[f32; 3]; 3]) -> Estimate {
        let [a, b, c] = triangle.map(double);
        let (e1, e2, from) = (b - a, c - a, self.o - a);
        let (p, q) = (self.d.cross(e2), from.cross(e1));
        let (m0, m1, m2) =
            (from.abs().max_element(), e1.abs().max_element(), e2.abs().max_element());
        let bound = 16.0 * E * self.s;
        Estimate {
            u: About { value: from.dot(p), error: bound * m0 * m2 },
            v: About { value: self.d.dot(q), error: bound * m0 * m1 },
            height: About { value: e2.dot(q), error: 64.0 * E * m0 * m1 * m2 },
            det: About { value: e1.dot(p), error: bound * m1 * m2 },
        }
    }

    /// The rounded `t` of the hit, if there is one with `tmin <= t <= tmax`.
    #[inline(always)]
    pub fn meet(&self, triangle: &[[f32; 3]; 3], tmax: f32) -> Option<f32> {
        let near = self.estimate(triangle);
        match near.sides() {
            Sides::Outside => None,
            Sides::Inside => {
                let (low, high) = near.quotient(near.height);
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
        Case::new(&self.org, &self.dir, triangle).t().and_then(|t| self.in_range(t, tmax))
    }

    /// A `t` too large for `f32` is no hit: no ray could be ended there.
    fn in_range(&self, t: f32, tmax: f32) -> Option<f32> {
        (t >= self.tmin && t <= tmax && t.abs() < f32::INFINITY).then_some(t)
    }

    /// The weights `u` of `v1` and `v` of `v2` where the line meets a triangle
    /// that it is known to pierce.
    pub fn weights(&self, triangle: &[[f32; 3]; 3]) -> (f32, f32) {
        let near = self.estimate(triangle);
        let ((u, u_high), (v, v_high)) = (near.quotient(near.u), near.quotient(near.v));
        if u.to_bits() == u_high.to_bits() && v.to_bits() == v_high.to_bits() {
            return (u, v);
        }
        Case::new(&self.org, &self.dir, triangle).weights()
    }
}

impl Estimate {
    #[inline(always)]
    fn sides(&self) -> Sides {
        // The sign of det, for certain or not, is the one the weights must have.
        let sign = 1.0f64.copysign(self.det.value);
        let (u, v, det) = (sign * self.u.value, sign * self.v.value, self.det.value.abs());
        let w = det - u - v;
        // The two differences round by less than half of what det may be off,
        // or of what u and v may: their sum bounds w's error, doubled for safety.
        let w_error = 2.0 * (self.u.error + self.v.error + self.det.error)
            + 4.0 * E * (det + u.abs() + v.abs());
        if det <= self.det.error {
            Sides::Unsure
        } else if u < -self.u.error || v < -self.v.error || w < -w_error {
            Sides::Outside
        } else if u > self.u.error && v > self.v.error && w > w_error {
            Sides::Inside
        } else {
            Sides::Unsure
        }
    }

    /// `f32` bounds of `num / det`, equal when the rounding is certain.
    #[inline(always)]
    fn quotient(&self, num: About) -> (f32, f32) {
        let q = num.value / self.det.value;
        let room = self.det.value.abs() - self.det.error;
        if room <= 0.0 {
            return (f32::NEG_INFINITY, f32::INFINITY);
        }
        let error =
            (num.error + q.abs() * self.det.error) / room * (1.0 + 1e-6) + q.abs() * (4.0 * E);
        // Adding +0 turns -0 into +0 and changes nothing else.
        ((q - error) as f32 + 0.0, (q + error) as f32 + 0.0)
    }
}

/// `(v1 - v0) x (v2 - v0)` in `f64`, then rounded.
pub fn normal(triangle: &[[f32; 3]; 3]) -> [f32; 3] {
    let [a, b, c] = triangle.map(double);
    (b - a).cross(c - a).to_array().map(|n| n as f32)
}

/// Whether the triangle has no area, exactly.
pub fn degenerate(triangle: &[[f32; 3]; 3]) -> bool {
    let [a, b, c] = triangle.map(double);
    let (e1, e2) = (b - a, c - a);
    let m = e1.abs().max_element() * e2.abs().max_element();
    let certain = e1.cross(e2).abs().max_element() > 16.0 * E * m;
    !certain && crate::exact::degenerate(triangle)
}
