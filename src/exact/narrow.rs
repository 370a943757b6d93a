//! Meetings of rays and triangles whose numbers span at most 62 bits.
//!
//! In units of the lowest bit coordinates and components are below 2^62,
//! differences below 2^63, two by two minors below 2^127, and sums of three
//! products of a minor with either below 2^192; what is compared to round a quotient
//! has 26 bits more. So `i64`, `i128` and 256 bits hold them.

use super::quad::Quad;
use super::span::Span;
use super::{Case, Meeting, Signed};

/// Widest spans of coordinates and of components.
pub const WIDTH: u32 = 62;

type Vector = [i64; 3];

#[inline(always)]
fn vector(span: Span, [x, y, z]: [f32; 3]) -> Vector {
    [span.integer(x), span.integer(y), span.integer(z)]
}

#[inline(always)]
fn sub(a: &Vector, b: &Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn cross(a: &Vector, b: &Vector) -> [i128; 3] {
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    let minor = |i: usize, j: usize| product(a[i], b[j]) - product(a[j], b[i]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

#[inline(always)]
fn dot(a: &[i128; 3], b: &Vector) -> Quad {
    Quad::product(a[0], b[0]).add(Quad::product(a[1], b[1])).add(Quad::product(a[2], b[2]))
}

/// The edges from the first corner, the origin seen from it, the direction, and
/// the cross product of the second and the first edge.
pub struct Edges {
    e1: Vector,
    e2: Vector,
    from: Vector,
    dir: Vector,
    normal: [i128; 3],
}

impl Meeting for Edges {
    type Int = Quad;

    #[inline(always)]
    fn new(case: &Case) -> Self {
        let point = |i: usize| vector(case.place, case.points[i]);
        let a = point(1);
        let (e1, e2, from) = (sub(&point(2), &a), sub(&point(3), &a), sub(&point(0), &a));
        let normal = cross(&e2, &e1);
        Self { e1, e2, from, dir: vector(case.heading, case.dir), normal }
    }

    #[inline(always)]
    fn det(&self) -> Quad {
        dot(&self.normal, &self.dir)
    }

    #[inline(always)]
    fn u(&self) -> Quad {
        dot(&cross(&self.e2, &self.from), &self.dir)
    }

    #[inline(always)]
    fn v(&self) -> Quad {
        dot(&cross(&self.from, &self.e1), &self.dir)
    }

    #[inline(always)]
    fn w(det: &Quad, u: &Quad, v: &Quad) -> Quad {
        det.add(u.neg()).add(v.neg())
    }

    #[inline(always)]
    fn height(&self) -> Quad {
        dot(&self.normal, &self.from).neg()
    }
}

/// Whether a triangle whose coordinates have this span has no area.
pub fn degenerate(corners: &[[f32; 3]; 3], place: Span) -> bool {
    let [a, b, c] = corners.map(|v| vector(place, v));
    cross(&sub(&b, &a), &sub(&c, &a)) == [0; 3]
}

impl Signed for Quad {
    type Magnitude = super::quad::Magnitude;

    fn signum(&self) -> i32 {
        Quad::signum(self)
    }

    fn magnitude(&self) -> Self::Magnitude {
        Quad::magnitude(self)
    }
}
