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
//! `estimate` decides in `f64` where its error bounds allow, which is nearly always;
//! what they leave open `exact` decides. So the result does not depend on the order
//! of operations, on fused multiply-add, or on the instruction set.

mod estimate;
mod four;
mod judge;
mod pairs;

use crate::arena::layout::Triangle;
use crate::exact::{self, Case};
use crate::ray::{Ray, culls};
use crate::simd::Lanes;

pub use estimate::{Apex, normal};
use estimate::{E, Estimate, Range, Sides};
use judge::{Judged, Place};
pub use pairs::FourPairs;

type Vector = [f64; 3];

/// The corners of a triangle, however they are stored.
pub trait Corners {
    /// Their coordinates along an axis.
    fn along(&self, axis: usize) -> [f32; 3];

    #[inline(always)]
    fn all(&self) -> [[f32; 3]; 3] {
        let (x, y, z) = (self.along(0), self.along(1), self.along(2));
        [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]]
    }
}

impl Corners for [[f32; 3]; 3] {
    #[inline(always)]
    fn along(&self, axis: usize) -> [f32; 3] {
        [self[0][axis], self[1][axis], self[2][axis]]
    }
}

impl Corners for Triangle {
    #[inline(always)]
    fn along(&self, axis: usize) -> [f32; 3] {
        [self.x, self.y, self.z][axis]
    }
}

/// A hit: the rounded `t`, and the rounded weights `u` and `v` and the [`normal`] if they are as
/// easily known.
pub struct Met {
    pub t: f32,
    pub weights: Option<(f32, f32)>,
    pub normal: Option<[f32; 3]>,
}

/// A ray made ready for many triangles.
#[derive(Clone, Copy)]
pub struct Line {
    org: Vector,
    dir: Vector,
    limits: Limits,
}

/// What hits of a ray have to be, but for the largest t.
#[derive(Clone, Copy)]
struct Limits {
    /// Finite, or positive infinity.
    tmin: f32,
    /// The ray's.
    flags: u32,
}

impl Limits {
    #[inline(always)]
    fn of(ray: &Ray) -> Self {
        let tmin = if ray.tmin > f32::MIN { ray.tmin } else { f32::MIN };
        Self { tmin, flags: ray.flags }
    }

    /// Whether the ray's flags leave out triangles that it comes to from this side.
    #[inline(always)]
    fn culls(self, front: bool) -> bool {
        culls(self.flags, front)
    }

    #[inline(always)]
    fn in_range(self, t: f32, tmax: f32) -> Option<f32> {
        // Adding +0 turns -0 into +0 and changes nothing else.
        (t >= self.tmin && t <= finite(tmax)).then_some(t + 0.0)
    }

    /// t, between two numbers or `exact`, if it is in range.
    #[inline(always)]
    fn of_range(self, t: &Range, tmax: f32, exact: impl FnOnce() -> f32) -> Option<f32> {
        if t.low == t.high {
            self.in_range(t.low, tmax)
        } else if t.high < self.tmin || t.low > tmax {
            None
        } else {
            self.in_range(exact(), tmax)
        }
    }

    /// Whether [`Limits::of_range`] is something.
    #[inline(always)]
    fn hold(self, t: &Range, tmax: f32, exact: impl FnOnce() -> f32) -> bool {
        if t.low >= self.tmin && t.high <= finite(tmax) {
            true
        } else if t.high < self.tmin || t.low > tmax {
            false
        } else {
            self.in_range(exact(), tmax).is_some()
        }
    }
}

/// A `t` too large for `f32` is no hit: no ray could be ended there.
#[inline(always)]
fn finite(tmax: f32) -> f32 {
    if tmax < f32::MAX { tmax } else { f32::MAX }
}

/// `array::map`, but always inlined.
#[inline(always)]
fn three<T>(f: impl Fn(usize) -> T) -> [T; 3] {
    [f(0), f(1), f(2)]
}

#[inline(always)]
fn double(v: [f32; 3]) -> Vector {
    three(|k| f64::from(v[k]))
}

#[inline(always)]
fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

impl Line {
    #[inline(always)]
    pub fn new(ray: &Ray) -> Self {
        Self { org: double(ray.org), dir: double(ray.dir), limits: Limits::of(ray) }
    }

    /// A triangle as seen from the origin.
    #[inline(always)]
    pub fn apex(&self, triangle: &impl Corners) -> Apex {
        Apex::new(&self.org, triangle)
    }

    /// The hit, if there is one with `tmin <= t <= tmax`; `apex` is the triangle's from this
    /// line's origin.
    #[inline(always)]
    pub fn meet(&self, apex: &Apex, triangle: &impl Corners, tmax: f32) -> Option<Met> {
        let (near, limits) = (Estimate::new(apex, &self.dir), self.limits);
        match near.sides() {
            Sides::Outside => None,
            Sides::Inside if limits.flags != 0 && limits.culls(near.is_front()) => None,
            Sides::Inside => {
                let t = near.t();
                let weights = if t.low == t.high { near.rounded_weights() } else { None };
                let t = limits.of_range(&t, tmax, || self.t_inside(triangle.all()))?;
                Some(Met { t, weights, normal: Some(apex.normal()) })
            }
            Sides::Unsure => {
                let t = self.meet_exactly(triangle.all(), tmax)?;
                Some(Met { t, weights: None, normal: None })
            }
        }
    }

    /// Whether there is a hit with `tmin <= t <= tmax`.
    #[inline(always)]
    pub fn pierces(&self, apex: &Apex, triangle: &impl Corners, tmax: f32) -> bool {
        let (near, limits) = (Estimate::new(apex, &self.dir), self.limits);
        match near.sides() {
            Sides::Outside => false,
            Sides::Inside if limits.flags != 0 && limits.culls(near.is_front()) => false,
            Sides::Inside => limits.hold(&near.t(), tmax, || self.t_inside(triangle.all())),
            Sides::Unsure => self.meet_exactly(triangle.all(), tmax).is_some(),
        }
    }

    /// The weights `u` of `v1` and `v` of `v2` where the line meets a triangle
    /// that it is known to pierce.
    #[inline(always)]
    pub fn weights(&self, triangle: &impl Corners) -> (f32, f32) {
        let near = Estimate::new(&self.apex(triangle), &self.dir);
        near.rounded_weights().unwrap_or_else(|| self.weights_exactly(triangle.all()))
    }

    /// As all that is rarely needed, of copies: what others point to would be kept in memory.
    fn case(self, corners: [[f32; 3]; 3]) -> Case {
        // They were widened without loss.
        Case::new(self.org.map(|x| x as f32), self.dir.map(|x| x as f32), corners)
    }

    #[cold]
    #[inline(never)]
    fn t_inside(self, corners: [[f32; 3]; 3]) -> f32 {
        self.case(corners).t_inside()
    }

    #[cold]
    #[inline(never)]
    fn meet_exactly(self, corners: [[f32; 3]; 3], tmax: f32) -> Option<f32> {
        let (case, limits) = (self.case(corners), self.limits);
        let t = case.t().and_then(|t| limits.in_range(t, tmax));
        t.filter(|_| limits.flags == 0 || !limits.culls(case.is_front()))
    }

    #[cold]
    #[inline(never)]
    fn weights_exactly(self, corners: [[f32; 3]; 3]) -> (f32, f32) {
        self.case(corners).weights()
    }
}

/// [`Line::meet`] of a ray, in lanes, which takes half the time.
#[inline(always)]
pub fn meet<L: Lanes>(l: L, ray: &Ray, triangle: &Triangle, tmax: f32) -> Option<Met> {
    let (limits, judged) = (Limits::of(ray), Judged::new(l, ray, triangle));
    match judged.sides {
        Sides::Outside => None,
        Sides::Inside if limits.flags != 0 && limits.culls(judged.is_front()) => None,
        Sides::Inside => {
            let Place { t, weights } = judged.place(l);
            let t = limits.of_range(&t, tmax, || t_inside(ray, triangle))?;
            Some(Met { t, weights, normal: Some(judged.normal(l)) })
        }
        Sides::Unsure => {
            let t = meet_exactly(ray, triangle, tmax)?;
            Some(Met { t, weights: None, normal: None })
        }
    }
}

/// [`Line::pierces`] of a ray, in lanes, likewise.
#[inline(always)]
pub fn pierces<L: Lanes>(l: L, ray: &Ray, triangle: &Triangle, tmax: f32) -> bool {
    let (limits, judged) = (Limits::of(ray), Judged::new(l, ray, triangle));
    match judged.sides {
        Sides::Outside => false,
        Sides::Inside if limits.flags != 0 && limits.culls(judged.is_front()) => false,
        Sides::Inside => limits.hold(&judged.place(l).t, tmax, || t_inside(ray, triangle)),
        Sides::Unsure => meet_exactly(ray, triangle, tmax).is_some(),
    }
}

#[cold]
#[inline(never)]
fn t_inside(ray: &Ray, triangle: &Triangle) -> f32 {
    Line::new(ray).t_inside(triangle.all())
}

#[cold]
#[inline(never)]
fn meet_exactly(ray: &Ray, triangle: &Triangle, tmax: f32) -> Option<f32> {
    Line::new(ray).meet_exactly(triangle.all(), tmax)
}

/// Whether the triangle has no area, exactly.
#[inline]
pub fn degenerate(corners: &[[f32; 3]; 3]) -> bool {
    let [a, b, c] = *corners;
    let (a, b, c) = (double(a), double(b), double(c));
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
