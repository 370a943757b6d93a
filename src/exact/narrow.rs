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

/// The edges from the first corner, the origin seen from it, and the direction.
struct Edges {
    e1: Vector,
    e2: Vector,
    from: Vector,
    dir: Vector,
    scale: i32,
}

impl Edges {
    #[inline(always)]
    fn new(case: &Case) -> Self {
        let place = |v: [f32; 3]| v.map(|x| case.place.integer(x));
        let [a, b, c] = case.corners.map(place);
        Self {
            e1: sub(&b, &a),
            e2: sub(&c, &a),
            from: sub(&place(case.org), &a),
            dir: case.dir.map(|x| case.heading.integer(x)),
            scale: case.place.exponent() - case.heading.exponent(),
        }
    }

    /// Minus the numerator and the denominator of `t`.
    #[inline(always)]
    fn height(&self) -> (Quad, Quad) {
        let normal = cross(&self.e2, &self.e1);
        (dot(&normal, &self.from).neg(), dot(&normal, &self.dir))
    }
}

/// The numerator and the denominator of `t`, and the exponent of its unit.
pub fn height(case: &Case) -> (Quad, Quad, i32) {
    let edges = Edges::new(case);
    let (height, det) = edges.height();
    (height, det, edges.scale)
}

pub fn meeting(case: &Case) -> Meeting<Quad> {
    let edges = Edges::new(case);
    let (height, det) = edges.height();
    let u = dot(&cross(&edges.e2, &edges.from), &edges.dir);
    let v = dot(&cross(&edges.from, &edges.e1), &edges.dir);
    let weights = [det.add(u.neg()).add(v.neg()), u, v];
    Meeting { weights, det, height, scale: edges.scale }
}

/// Whether a triangle whose coordinates have this span has no area.
pub fn degenerate(corners: &[[f32; 3]; 3], place: Span) -> bool {
    let [a, b, c] = corners.map(|v| v.map(|x| place.integer(x)));
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
