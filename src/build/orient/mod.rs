//! Which way a cluster's box lies (section 7.2).
//!
//! A ray meets a convex box in proportion to its surface, so a box of less surface around
//! the same triangles is entered less often. The problem of the least box is hard; here
//! are the paper's answers, principal components of the vertices and of the hull's
//! surface, and a direct search that begins with these. A cluster keeps its aligned
//! box unless the turned one has less than a given share of its surface, which stands
//! for what it costs to turn a ray.

mod clusters;
mod hull;
mod pca;

pub use clusters::clusters;

use crate::options::Orientation;
use glam::{DMat3, DVec3};
use hull::Extremes;
use pca::{Moments, plane, right_handed};

/// Cosines and sines of the angles that the search tries: 24, 12, 6, 3 and 1.5 degrees.
const ANGLES: [[f64; 2]; 5] = [
    [0.913_545_457_642_600_9, 0.406_736_643_075_800_2],
    [0.978_147_600_733_805_6, 0.207_911_690_817_759_3],
    [0.994_521_895_368_273_3, 0.104_528_463_267_653_5],
    [0.998_629_534_754_573_9, 0.052_335_956_242_943_8],
    [0.999_657_324_975_557_3, 0.026_176_948_307_873_1],
];
/// Most improvements with each angle.
const ROUNDS: usize = 12;

/// The lower and upper ends of points along axes.
pub fn ends(axes: &[DVec3; 3], points: impl Iterator<Item = DVec3>) -> [DVec3; 2] {
    let [x, y, z] = *axes;
    points.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[lo, hi], p| {
        let at = DVec3::new(x.dot(p), y.dot(p), z.dot(p));
        [lo.min(at), hi.max(at)]
    })
}

/// Half the surface of a box.
pub fn surface([lo, hi]: [DVec3; 2]) -> f64 {
    let side = hi - lo;
    side.x * side.y + side.y * side.z + side.z * side.x
}

/// The axes of a cluster's box, unit vectors. `points`: the corners of its triangles
/// relative to some place among them.
pub fn axes(orientation: Orientation, points: impl Iterator<Item = DVec3> + Clone) -> [DVec3; 3] {
    let vertices = || {
        let mut moments = Moments::NONE;
        points.clone().for_each(|p| moments.point(p));
        moments.axes()
    };
    match orientation {
        Orientation::Aligned => [DVec3::X, DVec3::Y, DVec3::Z],
        Orientation::Vertices => vertices(),
        Orientation::Hull => {
            let surface = Extremes::new(points.clone()).surface();
            surface.map_or_else(vertices, |moments| moments.axes())
        }
        Orientation::Search => {
            let extremes = Extremes::new(points.clone());
            let hull = extremes.surface().map(|moments| moments.axes());
            let starts = [Some([DVec3::X, DVec3::Y, DVec3::Z]), Some(vertices()), hull];
            let found = starts.into_iter().flatten().map(|start| search(extremes.points(), start));
            let best = found.min_by(|a, b| a.1.total_cmp(&b.1));
            best.map_or([DVec3::X, DVec3::Y, DVec3::Z], |(axes, _)| axes)
        }
    }
}

/// Turns axes about each of themselves, by smaller and smaller angles, while that makes the
/// box of these points smaller; returns its surface too.
fn search(points: &[DVec3], start: [DVec3; 3]) -> ([DVec3; 3], f64) {
    let of = |axes: &[DVec3; 3]| surface(ends(axes, points.iter().copied()));
    let (mut axes, mut least) = (start, of(&start));
    for [c, s] in ANGLES {
        for _ in 0..ROUNDS {
            let turned = [(0, 1), (0, 2), (1, 2)].into_iter().flat_map(|(p, q)| {
                [s, -s].map(|s| {
                    let [x, y, z] = axes;
                    let turned = DMat3::from_cols(x, y, z) * plane(p, q, c, s);
                    right_handed(turned.x_axis, turned.y_axis)
                })
            });
            let best = turned.map(|axes| (of(&axes), axes)).min_by(|a, b| a.0.total_cmp(&b.0));
            match best {
                Some((surface, better)) if surface < least => (axes, least) = (better, surface),
                _ => break,
            }
        }
    }
    (axes, least)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of a brick, and a clump of points in one of them that pulls at means.
    fn brick() -> (impl Iterator<Item = DVec3> + Clone, f64) {
        let [x, y, z] = right_handed(DVec3::new(3.0, 1.0, 2.0), DVec3::new(-1.0, 2.0, 0.5));
        let corner = move |i: i32| {
            x * (8.0 * f64::from(i & 1)) + y * (4.0 * f64::from(i >> 1 & 1)) + z * f64::from(i >> 2)
        };
        let clump = (0..400).map(move |i| corner(6) * (1.0 - f64::from(i) / 4000.0));
        ((0..8).map(corner).chain(clump), 8.0 * 4.0 + 4.0 + 8.0)
    }

    #[test]
    fn finds_a_brick() {
        let (points, least) = brick();
        let of = |orientation| surface(ends(&axes(orientation, points.clone()), points.clone()));
        assert!(of(Orientation::Aligned) > 1.5 * least);
        assert!(of(Orientation::Hull) < 1.02 * least, "{}", of(Orientation::Hull));
        assert!(of(Orientation::Search) < 1.02 * least, "{}", of(Orientation::Search));
        // Points inside mislead the vertices' components, as the paper says.
        assert!(of(Orientation::Vertices) > 1.02 * least);
    }
}
