//! The stove: oven door, dials, four burners with grates, a pot and a pan.

use super::cupboards::knob;
use crate::scenes::shape::{Model, arc, at, point_along, stand};
use glam::DVec3;

pub fn stove(m: &mut Model) {
    m.within(stand(at(1.2, 0.0, 0.0), 0.0), |m| {
        m.block(at(0.0, 0.02, 0.02), at(0.6, 0.9, 0.6));
        m.block(at(0.03, 0.12, 0.6), at(0.57, 0.7, 0.63));
        m.block(at(0.0, 0.9, 0.0), at(0.6, 1.0, 0.04));
        for x in [0.09, 0.51] {
            m.tube(&[at(x, 0.64, 0.63), at(x, 0.64, 0.645), at(x, 0.64, 0.66)], |_| 0.007, 6);
        }
        m.tube(&[at(0.08, 0.64, 0.665), at(0.52, 0.64, 0.665)], |_| 0.009, 8);
        for i in 0..5 {
            dial(m, at(0.1 + 0.1 * f64::from(i), 0.8, 0.6));
        }
        for (x, z) in [(0.16, 0.18), (0.44, 0.18), (0.16, 0.44), (0.44, 0.44)] {
            m.within(stand(at(x, 0.9, z), 0.0), burner);
        }
        m.within(stand(at(0.16, 0.925, 0.18), 0.1), pot);
        m.within(stand(at(0.44, 0.925, 0.44), -0.12), pan);
    });
}

fn dial(m: &mut Model, base: DVec3) {
    m.within(point_along(base, DVec3::Z), |m| {
        m.revolve(&[[0.026, 0.0], [0.024, 0.006], [0.012, 0.008]], 10);
    });
    knob(m, base);
}

fn burner(m: &mut Model) {
    let ring = arc(DVec3::ZERO, DVec3::X * 0.07, DVec3::Z * 0.07, [0.0, 1.0], 16);
    m.tube(&ring, |_| 0.006, 3);
    m.revolve(&[[0.034, 0.0], [0.036, 0.012], [0.018, 0.015], [0.0, 0.015]], 10);
}

fn pot(m: &mut Model) {
    let wall = [[0.09, 0.0], [0.09, 0.02], [0.09, 0.04], [0.09, 0.06], [0.09, 0.08], [0.09, 0.1]];
    m.revolve(&wall, 24);
    let lid = [
        [0.092, 0.102],
        [0.075, 0.11],
        [0.058, 0.115],
        [0.04, 0.119],
        [0.022, 0.122],
        [0.009, 0.124],
        [0.014, 0.136],
        [0.0, 0.144],
    ];
    m.revolve(&lid, 18);
    for side in [-1.0, 1.0] {
        let out = at(0.03 * side, 0.0, 0.0);
        let ear = arc(at(0.09 * side, 0.08, 0.0), out, DVec3::Z * 0.03, [-0.25, 0.25], 8);
        m.tube(&ear, |_| 0.005, 4);
    }
}

fn pan(m: &mut Model) {
    let profile = [
        [0.0, 0.0],
        [0.02, 0.0],
        [0.04, 0.0],
        [0.06, 0.001],
        [0.08, 0.003],
        [0.098, 0.015],
        [0.11, 0.034],
    ];
    m.revolve(&profile, 24);
    let path: Vec<DVec3> = (0..12)
        .map(|j| at(0.105 + 0.016 * f64::from(j), 0.032 + 0.003 * f64::from(j), 0.0))
        .collect();
    m.tube(&path, |j| if j == 11 { 0.0 } else { 0.008 }, 6);
}
