//! Exact arithmetic, for the few decisions that `f64` leaves open.
//!
//! The deciding quantities are polynomials of degree three in `f32` inputs, so
//! integers settle their signs, and tell which side of the middle between two
//! neighbouring `f32` their quotients lie. Only a ray within a part in 10^10 or
//! so of a triangle's edge, or a quotient next to a rounding boundary, comes here.
//! Where the numbers are of similar size, as scenes mostly have them, `narrow`
//! needs a few machine multiplications; anything else goes to `wide`. No
//! allocation.

mod int;
mod narrow;
mod quad;
mod round;
mod span;
pub mod spot;
mod wide;

use round::{Magnitude, nearest};
use span::Span;

/// A ray and a triangle whose meeting `f64` could not decide.
pub struct Case {
    /// The ray's origin and the triangle's corners.
    points: [[f32; 3]; 4],
    dir: [f32; 3],
    place: Span,
    heading: Span,
}

/// A ray's line and the plane and edge planes of a triangle, in exact integers.
trait Meeting {
    type Int: Signed;
    fn new(case: &Case) -> Self;
    /// The sum of the corners' weights: weights are over it.
    fn det(&self) -> Self::Int;
    /// The weight of the second corner.
    fn u(&self) -> Self::Int;
    /// The weight of the third corner.
    fn v(&self) -> Self::Int;
    /// The weight of the first corner, given the two others.
    fn w(det: &Self::Int, u: &Self::Int, v: &Self::Int) -> Self::Int;
    /// `t` is this over `det`, times a power of two: that of [`Case::scale`].
    fn height(&self) -> Self::Int;
}

/// An integer with a sign.
trait Signed {
    type Magnitude: Magnitude;
    /// -1, 0 or 1.
    fn signum(&self) -> i32;
    fn magnitude(&self) -> Self::Magnitude;
}

impl Case {
    pub fn new(org: [f32; 3], dir: [f32; 3], [a, b, c]: [[f32; 3]; 3]) -> Self {
        let points = [org, a, b, c];
        let (place, heading) = (Span::of(points.as_flattened()), Span::of(&dir));
        Self { points, dir, place, heading }
    }

    fn narrow(&self) -> bool {
        self.place.width <= narrow::WIDTH && self.heading.width <= narrow::WIDTH
    }

    /// The exponent of the unit of `t`.
    fn scale(&self) -> i32 {
        self.place.exponent() - self.heading.exponent()
    }

    /// The rounded `t`, if the ray's line pierces the closed triangle.
    pub fn t(&self) -> Option<f32> {
        if self.narrow() { self.t_in::<narrow::Edges>() } else { self.t_in::<wide::Edges>() }
    }

    /// The rounded `t` on a triangle that is pierced for certain.
    pub fn t_inside(&self) -> f32 {
        if self.narrow() {
            self.t_inside_in::<narrow::Edges>()
        } else {
            self.t_inside_in::<wide::Edges>()
        }
    }

    /// Whether the ray comes from the side to which the triangle's normal points.
    pub fn is_front(&self) -> bool {
        wide::Edges::new(self).det().signum() > 0
    }

    /// The rounded weights of the second and the third corner.
    pub fn weights(&self) -> (f32, f32) {
        if self.narrow() {
            self.weights_in::<narrow::Edges>()
        } else {
            self.weights_in::<wide::Edges>()
        }
    }

    fn t_in<M: Meeting>(&self) -> Option<f32> {
        let edges = M::new(self);
        let (det, u, v) = (edges.det(), edges.u(), edges.v());
        let sign = det.signum();
        let agrees = |weight: &M::Int| weight.signum() * sign >= 0;
        let pierced = sign != 0 && agrees(&u) && agrees(&v) && agrees(&M::w(&det, &u, &v));
        pierced.then(|| quotient(&edges.height(), &det, self.scale()))
    }

    fn t_inside_in<M: Meeting>(&self) -> f32 {
        let edges = M::new(self);
        quotient(&edges.height(), &edges.det(), self.scale())
    }

    fn weights_in<M: Meeting>(&self) -> (f32, f32) {
        let edges = M::new(self);
        let det = edges.det();
        (quotient(&edges.u(), &det, 0), quotient(&edges.v(), &det, 0))
    }
}

/// `num / den * 2^scale` to the nearest `f32`, ties to even; zero is +0.
fn quotient<N: Signed>(num: &N, den: &N, scale: i32) -> f32 {
    if num.signum() == 0 {
        return 0.0;
    }
    let size = nearest(num.magnitude(), den.magnitude(), scale);
    (if num.signum() == den.signum() { size } else { -size }) + 0.0
}

/// Whether the triangle has no area.
pub fn degenerate(corners: &[[f32; 3]; 3]) -> bool {
    let place = Span::of(corners.as_flattened());
    if place.width <= narrow::WIDTH {
        narrow::degenerate(corners, place)
    } else {
        wide::degenerate(corners, place)
    }
}

#[cfg(test)]
mod tests {
    use super::{Case, narrow, wide};

    struct Random(u64);

    impl Random {
        fn below(&mut self, n: u64) -> u64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(97);
            (self.0 >> 33) % n
        }

        /// Of any sign, with full or few bits, in a window of exponents.
        fn float(&mut self, window: u64) -> f32 {
            let fraction = self.below(1 << 23) & [u64::MAX, 7 << 20, 0][self.below(3) as usize];
            let field = 100 + self.below(window);
            let bits = (self.below(2) << 31 | field << 23 | fraction) as u32;
            if self.below(8) == 0 { 0.0 } else { f32::from_bits(bits) }
        }
    }

    /// Up to the widest spans that count as narrow: 38 and 24 bits.
    #[test]
    fn narrow_and_wide_agree() {
        let mut random = Random(1);
        let mut pierced = 0;
        for i in 0..40_000 {
            let (place, heading) = (1 + i % 39, 1 + i / 39 % 39);
            let mut vector = |window| [0; 3].map(|_| random.float(window));
            let (org, mut dir) = (vector(place), vector(heading));
            let corners = [0; 3].map(|_| vector(place));
            if i % 2 == 0 {
                // At a corner, or next to it, if the numbers are alike.
                dir = [0, 1, 2].map(|k| corners[0][k] - org[k]);
            }
            let case = Case::new(org, dir, corners);
            if dir == [0.0; 3] || !case.narrow() {
                continue;
            }
            let bits = |t: Option<f32>| t.map(f32::to_bits);
            let t = case.t_in::<narrow::Edges>();
            assert_eq!(bits(t), bits(case.t_in::<wide::Edges>()), "{org:?} {dir:?} {corners:?}");
            if t.is_some() {
                pierced += 1;
                let inside = (case.t_inside_in::<narrow::Edges>(), case.t_inside());
                assert_eq!((bits(t), bits(t)), (bits(Some(inside.0)), bits(Some(inside.1))));
                let (u, v) = case.weights_in::<narrow::Edges>();
                let expected = case.weights_in::<wide::Edges>();
                assert_eq!(
                    (u.to_bits(), v.to_bits()),
                    (expected.0.to_bits(), expected.1.to_bits())
                );
            }
        }
        assert!(pierced > 4000, "only {pierced} pierced");
    }

    /// The bounds of `narrow`, reached.
    #[test]
    fn widest_narrow_numbers() {
        let most = f32::from_bits(0x7f7f_ffff);
        let (large, small) = (most, f32::from_bits((254 - 38) << 23 | 1));
        let signed = |bits: u32, i: u32, x: f32| if bits >> i & 1 == 1 { -x } else { x };
        for bits in 0..1 << 12 {
            let point = |i: u32| [0, 1, 2].map(|k| signed(bits, 3 * i + k, large));
            let [a, b, mut c] = [point(0), point(1), point(2)];
            c[(bits % 3) as usize] = small;
            let case = Case::new(point(3), [large, -small, large], [a, b, c]);
            assert_eq!((case.place.width, case.heading.width), (62, 62));
            let same = |a: f32, b: f32| assert_eq!(a.to_bits(), b.to_bits(), "case {bits}");
            let t = (case.t_in::<narrow::Edges>(), case.t_in::<wide::Edges>());
            assert_eq!(t.0.map(f32::to_bits), t.1.map(f32::to_bits), "case {bits}");
            if t.0.is_some() {
                let (narrow, wide) =
                    (case.weights_in::<narrow::Edges>(), case.weights_in::<wide::Edges>());
                same(narrow.0, wide.0);
                same(narrow.1, wide.1);
            }
        }
    }
}
