//! A chair with turned legs: long members between clusters of tiny triangles.

use crate::scenes::shape::{Model, at, point_along};
use glam::DVec3;

const SEAT: f64 = 0.45;
const HALF: f64 = 0.19;

/// A chair that looks towards positive z (its back is at negative z), on the floor at the origin.
pub fn chair(m: &mut Model) {
    m.block(at(-0.21, SEAT, -0.21), at(0.21, SEAT + 0.03, 0.22));
    for (x, z) in [(-HALF, HALF), (HALF, HALF), (-HALF, -HALF), (HALF, -HALF)] {
        leg(m, at(x * 1.08, 0.0, z * 1.08), at(x, SEAT, z));
    }
    for (a, b) in [
        (at(-HALF, 0.2, HALF), at(HALF, 0.2, HALF)),
        (at(-HALF, 0.16, -HALF), at(-HALF, 0.16, HALF)),
        (at(HALF, 0.16, -HALF), at(HALF, 0.16, HALF)),
        (at(-HALF, 0.24, -HALF), at(HALF, 0.24, -HALF)),
    ] {
        m.tube(&[a, b], |_| 0.011, 5);
    }
    for x in [-HALF, HALF] {
        let (foot, top) = (at(x, SEAT + 0.03, -HALF), at(x * 1.05, SEAT + 0.52, -HALF - 0.1));
        post(m, foot, top);
    }
    for (y, back) in [(0.66, 0.045), (0.76, 0.065), (0.86, 0.085)] {
        let z = -HALF - back;
        slat(m, at(-HALF, y, z), at(HALF, y + 0.05, z - 0.01));
    }
}

/// A board between the posts, bent backwards; its ends are inside them.
fn slat(m: &mut Model, lo: DVec3, hi: DVec3) {
    let profile = [(lo.y, 0.007), (lo.y, -0.007), (hi.y, -0.007), (hi.y, 0.007), (lo.y, 0.007)];
    m.patch(1, 4, |i, j| {
        let (y, depth) = profile[j];
        let share = (y - lo.y) / (hi.y - lo.y);
        at([lo.x, hi.x][i], y, lo.z + (hi.z - lo.z) * share + depth)
    });
}

/// A leg from `foot` to `top`: a cap under it, two plain lengths, a turned bulge between them.
fn leg(m: &mut Model, foot: DVec3, top: DVec3) {
    let length = (top - foot).length();
    m.within(point_along(foot, top - foot), |m| {
        cap(m);
        m.revolve(&[[0.015, 0.02], [0.018, 0.2]], 6);
        let turned = [0.018, 0.027, 0.027, 0.018];
        let bulge: Vec<[f64; 2]> = (0..4).map(|j| [turned[j], 0.2 + 0.016 * j as f64]).collect();
        m.revolve(&bulge, 8);
        m.revolve(&[[0.018, 0.248], [0.018, length]], 6);
    });
}

/// The cap of a leg: 88 triangles in two centimetres, about as in the paper's figure 11.
fn cap(m: &mut Model) {
    let profile = [
        [0.0, 0.0],
        [0.012, 0.001],
        [0.019, 0.004],
        [0.021, 0.008],
        [0.019, 0.013],
        [0.016, 0.017],
        [0.015, 0.02],
    ];
    m.revolve(&profile, 8);
}

/// A post of the back with a turned finial on top.
fn post(m: &mut Model, foot: DVec3, top: DVec3) {
    let length = (top - foot).length();
    m.within(point_along(foot, top - foot), |m| {
        m.revolve(&[[0.018, 0.0], [0.014, length]], 5);
        let finial = [0.014, 0.02, 0.012, 0.018, 0.018, 0.0];
        let profile: Vec<[f64; 2]> =
            (0..6).map(|j| [finial[j], length + 0.011 * j as f64]).collect();
        m.revolve(&profile, 8);
    });
}
