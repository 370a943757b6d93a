//! Office chairs.

use crate::scenes::shape::{Model, arc, at, sin_cos, stand};
use glam::DVec3;

/// A cushion: an ellipsoid on the way to a box.
fn cushion(m: &mut Model, centre: DVec3, half: DVec3) {
    let square = |c: f64| libm::copysign(libm::pow(libm::fabs(c), 0.35), c);
    m.patch(12, 4, |i, j| {
        let (sin, cos) = sin_cos((i % 12) as f64 / 12.0);
        let (radius, height) = match j {
            0 => (0.0, 1.0),
            4 => (0.0, -1.0),
            _ => sin_cos(j as f64 / 8.0),
        };
        let unit = at(square(radius) * square(cos), square(height), square(radius) * square(sin));
        centre + unit * half
    });
}

/// A swivel chair on five castors, looking towards positive z.
pub fn swivel(m: &mut Model) {
    for i in 0..5 {
        m.within(stand(DVec3::ZERO, f64::from(i) / 5.0), |m| {
            let arm = [at(0.02, 0.12, 0.0), at(0.15, 0.11, 0.0), at(0.3, 0.075, 0.0)];
            m.tube(&arm, |j| 0.025 - 0.005 * j as f64, 5);
            m.tube(&[at(0.29, 0.08, 0.0), at(0.29, 0.05, 0.0)], |_| 0.008, 5);
            m.ball(at(0.29, 0.027, 0.0), at(0.027, 0.027, 0.02), 4, 6);
        });
    }
    m.revolve(&[[0.03, 0.1], [0.03, 0.28], [0.018, 0.29], [0.018, 0.42], [0.06, 0.43]], 8);
    cushion(m, at(0.0, 0.47, 0.0), at(0.23, 0.04, 0.23));
    cushion(m, at(0.0, 0.82, -0.23), at(0.21, 0.23, 0.03));
    let spine = arc(at(0.0, 0.6, -0.1), at(0.0, -0.17, 0.0), at(0.0, 0.0, -0.16), [0.0, 0.25], 4);
    m.tube(&spine, |_| 0.02, 5);
    for side in [-1.0, 1.0] {
        let (centre, out) = (at(0.25 * side, 0.56, 0.0), at(0.0, 0.0, 0.13));
        let rest = arc(centre, out, at(0.0, 0.12, 0.0), [-0.25, 0.25], 6);
        m.tube(&rest, |_| 0.014, 5);
        m.ball(at(0.25 * side, 0.69, 0.0), at(0.03, 0.015, 0.13), 4, 8);
    }
}

/// A chair of bent tube with a seat and a back, looking towards positive z.
pub fn visitor(m: &mut Model) {
    for side in [-0.21, 0.21] {
        let mut path = vec![at(side, 0.85, -0.24), at(side, 0.45, -0.2)];
        path.extend(arc(
            at(side, 0.4, 0.15),
            at(0.0, 0.05, 0.0),
            at(0.0, 0.0, 0.05),
            [0.0, 0.25],
            2,
        ));
        path.push(at(side, 0.0, 0.22));
        m.tube(&path, |_| 0.012, 5);
        m.tube(&[at(side, 0.45, -0.18), at(side, 0.0, -0.25)], |_| 0.012, 5);
        for z in [-0.25, 0.22] {
            m.within(stand(at(side, 0.0, z), 0.0), |m| {
                m.revolve(&[[0.0, 0.0], [0.016, 0.001], [0.016, 0.02]], 6);
            });
        }
    }
    m.block(at(-0.21, 0.45, -0.2), at(0.21, 0.48, 0.2));
    m.patch(4, 1, |i, j| {
        let x = -0.21 + 0.105 * i as f64;
        let (_, bend) = sin_cos(x);
        at(x, 0.62 + 0.21 * j as f64, -0.2 - 0.06 * bend)
    });
}
