//! Meetings of rays and triangles whose numbers may be any `f32`.

use super::int;
use super::round;
use super::span::Span;
use super::{Case, Meeting, Signed};

use core::cmp::Ordering;

/// Wide enough for all that hits need.
type Int = int::Int<14>;

/// A vector of integers times a power of two.
type Vector = [Int; 3];

fn cross(a: &Vector, b: &Vector) -> Vector {
    let minor = |i: usize, j: usize| a[i].mul(&b[j]).sub(&a[j].mul(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn dot(a: &Vector, b: &Vector) -> Int {
    a[0].mul(&b[0]).add(&a[1].mul(&b[1])).add(&a[2].mul(&b[2]))
}

fn sub(a: &Vector, b: &Vector) -> Vector {
    [a[0].sub(&b[0]), a[1].sub(&b[1]), a[2].sub(&b[2])]
}

fn vector(span: Span, v: [f32; 3]) -> Vector {
    v.map(|x| match span.split(x) {
        (0, _) => Int::ZERO,
        (m, place) => Int::shifted(m, place),
    })
}

/// As [`super::narrow::Edges`].
pub struct Edges {
    e1: Vector,
    e2: Vector,
    from: Vector,
    dir: Vector,
    normal: Vector,
}

impl Meeting for Edges {
    type Int = Int;

    fn new(case: &Case) -> Self {
        let [o, a, b, c] = case.points.map(|v| vector(case.place, v));
        let (e1, e2) = (sub(&b, &a), sub(&c, &a));
        let normal = cross(&e2, &e1);
        Self { e1, e2, from: sub(&o, &a), dir: vector(case.heading, case.dir), normal }
    }

    fn det(&self) -> Int {
        dot(&self.normal, &self.dir)
    }

    fn u(&self) -> Int {
        dot(&cross(&self.e2, &self.from), &self.dir)
    }

    fn v(&self) -> Int {
        dot(&cross(&self.from, &self.e1), &self.dir)
    }

    fn w(det: &Int, u: &Int, v: &Int) -> Int {
        det.sub(u).sub(v)
    }

    fn height(&self) -> Int {
        dot(&self.normal, &self.from).neg()
    }
}

/// Whether a triangle whose coordinates have this span has no area.
pub fn degenerate(corners: &[[f32; 3]; 3], place: Span) -> bool {
    let [a, b, c] = corners.map(|v| vector(place, v));
    cross(&sub(&b, &a), &sub(&c, &a)).iter().all(|n| n.signum() == 0)
}

impl<const LIMBS: usize> Signed for int::Int<LIMBS> {
    type Magnitude = Self;

    fn signum(&self) -> i32 {
        Self::signum(self)
    }

    fn magnitude(&self) -> Self {
        self.abs()
    }
}

impl<const LIMBS: usize> round::Magnitude for int::Int<LIMBS> {
    fn bits(&self) -> u32 {
        Self::bits(self)
    }

    fn leading(&self) -> u64 {
        Self::leading(self)
    }

    fn shl(&self, by: u32) -> Self {
        Self::shl(*self, by)
    }

    fn times(&self, by: u32) -> Self {
        Self::times(self, by)
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp_magnitude(other)
    }
}
