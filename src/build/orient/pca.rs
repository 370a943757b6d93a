//! Principal components: the axes along which a cluster extends most and least.

use glam::{DMat3, DVec3};

/// Sums of what a covariance matrix is computed from.
#[derive(Clone, Copy, Default)]
pub struct Moments {
    weight: f64,
    first: DVec3,
    second: DMat3,
}

fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

impl Moments {
    pub const NONE: Self = Self { weight: 0.0, first: DVec3::ZERO, second: DMat3::ZERO };

    /// Adds a point.
    pub fn point(&mut self, p: DVec3) {
        self.weight += 1.0;
        self.first += p;
        self.second += outer(p, p);
    }

    /// Adds all points of a triangle, by area: the integrals of Gottschalk et al. (1996).
    pub fn triangle(&mut self, [p, q, r]: [DVec3; 3]) {
        let cross = (q - p).cross(r - p);
        let area = 0.5 * crate::math::sqrt(cross.length_squared());
        let sum = p + q + r;
        self.weight += area;
        self.first += sum * (area / 3.0);
        let squares = outer(sum, sum) + outer(p, p) + outer(q, q) + outer(r, r);
        self.second += squares * (area / 12.0);
    }

    /// The eigenvectors of the covariance matrix: unit vectors, a right-handed system.
    pub fn axes(&self) -> [DVec3; 3] {
        if self.weight <= 0.0 {
            return [DVec3::X, DVec3::Y, DVec3::Z];
        }
        let mean = self.first / self.weight;
        eigenvectors(self.second * (1.0 / self.weight) - outer(mean, mean))
    }
}

/// The eigenvectors of a symmetric matrix by Jacobi's rotations.
fn eigenvectors(mut a: DMat3) -> [DVec3; 3] {
    let mut axes = DMat3::IDENTITY;
    for _ in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let off = a.col(p)[q];
            let (first, last) = (a.col(p)[p], a.col(q)[q]);
            if off.abs() <= 1e-16 * (first.abs() + last.abs()) {
                continue;
            }
            let theta = (last - first) / (2.0 * off);
            let t = 1.0 / (theta.abs() + crate::math::sqrt(theta * theta + 1.0));
            let t = if theta < 0.0 { -t } else { t };
            let c = 1.0 / crate::math::sqrt(t * t + 1.0);
            let turn = plane(p, q, c, t * c);
            a = turn.transpose() * a * turn;
            axes *= turn;
        }
    }
    right_handed(axes.x_axis, axes.y_axis)
}

/// The rotation by an angle of this cosine and sine in the plane of axes p and q.
pub fn plane(p: usize, q: usize, c: f64, s: f64) -> DMat3 {
    let mut turn = DMat3::IDENTITY;
    turn.col_mut(p)[p] = c;
    turn.col_mut(q)[q] = c;
    turn.col_mut(q)[p] = s;
    turn.col_mut(p)[q] = -s;
    turn
}

/// The unit vectors that two nearly orthogonal ones make, exactly so but for rounding.
pub fn right_handed(x: DVec3, y: DVec3) -> [DVec3; 3] {
    let unit = |v: DVec3| v / crate::math::sqrt(v.length_squared());
    let x = unit(x);
    let z = unit(x.cross(y));
    [x, unit(z.cross(x)), z]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_axes_of_a_tilted_brick() {
        let [x, y, z] = right_handed(DVec3::new(1.0, 2.0, 0.5), DVec3::new(-1.0, 1.0, 0.3));
        let mut points = Moments::NONE;
        for i in 0..27 {
            let [a, b, c] = [i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1].map(f64::from);
            points.point(x * (9.0 * a) + y * (3.0 * b) + z * c + DVec3::splat(5.0));
        }
        let found = points.axes();
        for axis in [x, y, z] {
            assert!(found.iter().any(|f| f.dot(axis).abs() > 1.0 - 1e-9), "{found:?}");
        }
        assert!((found[0].cross(found[1]) - found[2]).length() < 1e-9);
    }

    #[test]
    fn triangles_count_by_area() {
        // Two halves of a square weigh what the square does, however it is cut.
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 1.0]];
        let at = |i: usize| DVec3::new(square[i][0], square[i][1], 0.0);
        let (mut a, mut b) = (Moments::NONE, Moments::NONE);
        a.triangle([at(0), at(1), at(2)]);
        a.triangle([at(0), at(2), at(3)]);
        b.triangle([at(0), at(1), at(3)]);
        b.triangle([at(1), at(2), at(3)]);
        assert!((a.first - b.first).length() < 1e-12);
        assert!((0..3).all(|k| (a.second.col(k) - b.second.col(k)).length() < 1e-12));
        // The second moment of a side of 4 about its middle: 4 * 4 / 12.
        let mean = a.first / a.weight;
        assert!((a.second.col(0)[0] / a.weight - mean.x * mean.x - 16.0 / 12.0).abs() < 1e-12);
    }
}
