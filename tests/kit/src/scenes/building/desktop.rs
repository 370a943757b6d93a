//! What lies on a desk, for somebody at negative z.

use crate::random::Random;
use crate::scenes::shape::{Model, arc, at, point_along, stand};

/// A screen with a deep back, a keyboard and a mouse.
pub fn computer(m: &mut Model, random: &mut Random) {
    m.revolve(&[[0.12, 0.0], [0.12, 0.015], [0.05, 0.03], [0.05, 0.06]], 16);
    let (lo, hi) = (at(-0.2, 0.06, -0.05), at(0.2, 0.4, 0.02));
    m.block(lo, hi);
    m.patch(6, 4, |i, j| {
        let (u, v) = (i as f64 / 3.0 - 1.0, j as f64 / 2.0 - 1.0);
        let bulge = 0.012 * (2.0 - u * u - v * v);
        at(0.17 * u, 0.24 + 0.13 * v, 0.015 + bulge)
    });
    m.patch(4, 2, |i, j| {
        let (x, y) = [(-0.18, 0.08), (0.18, 0.08), (0.18, 0.37), (-0.18, 0.37)][i % 4];
        let share = [1.0, 0.6, 0.0][j];
        at(x * share, 0.2 + (y - 0.2) * share, [-0.05, -0.3, -0.3][j])
    });
    for i in 0..2 {
        let base = at(0.12 + 0.02 * f64::from(i), 0.075, 0.02);
        m.within(point_along(base, at(0.0, 0.0, 1.0)), |m| {
            m.revolve(&[[0.004, 0.0], [0.004, 0.004], [0.0, 0.004]], 6);
        });
    }
    m.within(stand(at(0.0, 0.0, 0.3), random.range(-0.01, 0.01)), keyboard);
    m.within(stand(at(0.33, 0.0, 0.3), random.range(-0.05, 0.05)), |m| {
        m.ball(at(0.0, 0.012, 0.0), at(0.03, 0.02, 0.055), 6, 8);
    });
}

/// Six rows of keys.
fn keyboard(m: &mut Model) {
    m.block(at(-0.22, 0.0, -0.08), at(0.22, 0.015, 0.08));
    for row in 0..4 {
        let keys = if row == 3 { 6 } else { 13 };
        let pitch = 0.42 / f64::from(keys);
        for key in 0..keys {
            let x = -0.21 + pitch * (f64::from(key) + 0.5);
            let z = -0.054 + 0.035 * f64::from(row);
            super::phone::key(m, at(x, 0.015, z), pitch * 0.4, 0.014);
        }
    }
}

pub fn lamp(m: &mut Model) {
    m.revolve(&[[0.0, 0.025], [0.07, 0.02], [0.08, 0.008], [0.08, 0.0]], 10);
    m.tube(&[at(0.0, 0.02, 0.0), at(-0.06, 0.3, 0.0)], |_| 0.008, 6);
    m.tube(&[at(-0.06, 0.3, 0.0), at(0.12, 0.45, 0.0)], |_| 0.007, 6);
    m.ball(at(-0.06, 0.3, 0.0), at(0.015, 0.015, 0.015), 6, 8);
    m.within(point_along(at(0.17, 0.36, 0.0), at(-0.5, 1.0, 0.0)), |m| {
        m.revolve(&[[0.08, 0.0], [0.075, 0.04], [0.045, 0.09], [0.02, 0.11], [0.0, 0.112]], 10);
        m.ball(at(0.0, 0.04, 0.0), at(0.025, 0.035, 0.025), 6, 8);
    });
}

pub fn mug(m: &mut Model) {
    let profile =
        [[0.0, 0.004], [0.033, 0.006], [0.035, 0.09], [0.038, 0.09], [0.039, 0.0], [0.0, 0.0]];
    m.revolve(&profile, 10);
    let ear = arc(at(0.038, 0.045, 0.0), at(0.025, 0.0, 0.0), at(0.0, 0.03, 0.0), [-0.25, 0.25], 8);
    m.tube(&ear, |_| 0.005, 6);
}

/// A cup of pencils; the points of their leads are the smallest triangles of the building.
pub fn pencils(m: &mut Model, random: &mut Random) {
    m.revolve(&[[0.0, 0.003], [0.035, 0.003], [0.036, 0.1], [0.04, 0.1], [0.04, 0.0]], 16);
    for _ in 0..3 {
        let foot = at(random.range(-0.02, 0.02), 0.005, random.range(-0.02, 0.02));
        let lean = at(random.range(-0.15, 0.15), 1.0, random.range(-0.15, 0.15));
        m.within(point_along(foot, lean), |m| {
            let profile = [[0.0, 0.0], [0.0035, 0.0], [0.0035, 0.155], [0.0011, 0.17]];
            m.revolve(&profile, 6);
            m.revolve(&[[0.0011, 0.17], [0.0003, 0.1745], [0.0, 0.175]], 6);
        });
    }
}

/// A few sheets and an open book.
pub fn papers(m: &mut Model, random: &mut Random) {
    for i in 0..4 {
        let place =
            at(random.range(-0.06, 0.06), 0.001 + 0.001 * f64::from(i), random.range(-0.06, 0.06));
        m.within(stand(place, random.range(-0.05, 0.05)), |m| {
            m.panel(at(-0.105, 0.0, -0.148), at(0.21, 0.0, 0.0), at(0.0, 0.0, 0.297), 1, 1);
        });
    }
    m.patch(12, 1, |i, j| {
        let x = -0.18 + 0.03 * i as f64;
        let (sin, _) = crate::scenes::shape::sin_cos(libm::fabs(x) * 2.5);
        at(x, 0.008 + 0.018 * sin.max(0.0), 0.02 + 0.22 * j as f64)
    });
}
