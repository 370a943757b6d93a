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
mod wide;

use round::{Magnitude, nearest};
use span::Span;

/// A ray and a triangle whose meeting `f64` could not decide.
pub struct Case {
    org: [f32; 3],
    dir: [f32; 3],
    corners: [[f32; 3]; 3],
    place: Span,
    heading: Span,
}

/// A ray's meeting with the plane and the three edge planes of a triangle.
struct Meeting<N> {
    /// The weights of the corners times their sum.
    weights: [N; 3],
    /// Their sum.
    det: N,
    /// `t` is this over `det`, times `2^scale`.
    height: N,
    scale: i32,
}

/// An integer that can be one of a [`Meeting`].
trait Signed {
    type Magnitude: Magnitude;
    /// -1, 0 or 1.
    fn signum(&self) -> i32;
    fn magnitude(&self) -> Self::Magnitude;
}

impl Case {
    pub fn new(org: [f32; 3], dir: [f32; 3], corners: [[f32; 3]; 3]) -> Self {
        let place = Span::of(org.iter().chain(corners.as_flattened()));
        Self { org, dir, corners, place, heading: Span::of(dir.iter()) }
    }

    fn narrow(&self) -> bool {
        self.place.width <= narrow::WIDTH && self.heading.width <= narrow::WIDTH
    }

    /// The rounded `t`, if the ray's line pierces the closed triangle.
    pub fn t(&self) -> Option<f32> {
        if self.narrow() { narrow::meeting(self).t() } else { wide::meeting(self).t() }
    }

    /// The rounded `t` on a triangle that is pierced for certain.
    pub fn t_inside(&self) -> f32 {
        if self.narrow() {
            let (height, det, scale) = narrow::height(self);
            quotient(&height, &det, scale)
        } else {
            let Meeting { height, det, scale, .. } = wide::meeting(self);
            quotient(&height, &det, scale)
        }
    }

    /// The rounded weights of the second and the third corner.
    pub fn weights(&self) -> (f32, f32) {
        if self.narrow() {
            narrow::meeting(self).rounded_weights()
        } else {
            wide::meeting(self).rounded_weights()
        }
    }
}

impl<N: Signed> Meeting<N> {
    fn t(&self) -> Option<f32> {
        let sign = self.det.signum();
        let pierced = sign != 0 && self.weights.iter().all(|w| w.signum() * sign >= 0);
        pierced.then(|| quotient(&self.height, &self.det, self.scale))
    }

    fn rounded_weights(&self) -> (f32, f32) {
        (quotient(&self.weights[1], &self.det, 0), quotient(&self.weights[2], &self.det, 0))
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
    let place = Span::of(corners.as_flattened().iter());
    if place.width <= narrow::WIDTH {
        narrow::degenerate(corners, place)
    } else {
        wide::degenerate(corners, place)
    }
}
