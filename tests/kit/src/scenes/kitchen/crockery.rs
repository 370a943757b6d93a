//! What stands on the table: the bowl, the teapot, the stack of plates, cups and cutlery.
//!
//! All of it is cut into pieces of a centimetre or two.

use super::groceries::{breadboard, fruit};
use crate::scenes::shape::{Model, arc, at, sin_cos, stand};
use glam::DVec3;

/// The laid table, its top at `height`.
pub fn laid(m: &mut Model, height: f64) {
    let on_table = |x: f64, z: f64, turn: f64| stand(at(x, height, z), turn);
    m.within(on_table(-0.193, -0.03, 0.0), |m| {
        bowl(m);
        fruit(m);
    });
    m.within(on_table(0.236, -0.03, 0.2), teapot);
    m.within(on_table(0.664, 0.123, 0.0), |m| {
        for i in 0..6 {
            let place = stand(at(0.0, 0.008 * f64::from(i), 0.0), 0.013 * f64::from(i));
            m.within(place, |m| plate(m, 0.8));
        }
    });
    m.within(on_table(-0.53, 0.12, 0.04), breadboard);
    for (x, z, turn) in [(-0.55, -0.3, 0.0), (0.45, 0.33, 0.5)] {
        m.within(on_table(x, z, turn), setting);
    }
}

/// A plate, knife, fork, spoon and cup for somebody at negative z.
fn setting(m: &mut Model) {
    plate(m, 1.0);
    m.within(stand(at(-0.16, 0.0, -0.1), 0.0), fork);
    m.within(stand(at(0.15, 0.0, -0.1), 0.0), knife);
    m.within(stand(at(0.19, 0.0, -0.1), 0.0), spoon);
    m.within(stand(at(0.2, 0.0, 0.12), 0.1), cup);
}

/// A plate, `size` times 18 cm across.
fn plate(m: &mut Model, size: f64) {
    let profile = [
        [0.0, 0.004],
        [0.018, 0.004],
        [0.036, 0.004],
        [0.055, 0.005],
        [0.074, 0.008],
        [0.09, 0.016],
    ];
    m.revolve(&profile.map(|p| p.map(|c| c * size)), 24);
}

fn bowl(m: &mut Model) {
    let profile = [
        [0.0, 0.012],
        [0.025, 0.012],
        [0.05, 0.016],
        [0.075, 0.026],
        [0.092, 0.043],
        [0.105, 0.06],
        [0.112, 0.078],
        [0.117, 0.083],
        [0.118, 0.079],
        [0.11, 0.058],
        [0.097, 0.04],
        [0.078, 0.02],
        [0.05, 0.008],
        [0.046, 0.0],
    ];
    m.revolve(&profile, 32);
}

fn teapot(m: &mut Model) {
    let body = [
        [0.05, 0.0],
        [0.06, 0.007],
        [0.072, 0.022],
        [0.081, 0.039],
        [0.083, 0.057],
        [0.08, 0.075],
        [0.072, 0.092],
        [0.06, 0.106],
        [0.052, 0.117],
    ];
    m.revolve(&body, 26);
    let lid = [
        [0.051, 0.117],
        [0.036, 0.127],
        [0.019, 0.132],
        [0.008, 0.138],
        [0.013, 0.147],
        [0.0, 0.155],
    ];
    m.revolve(&lid, 18);
    let spout = arc(at(0.075, 0.11, 0.0), at(0.0, -0.075, 0.0), at(0.07, 0.0, 0.0), [0.0, 0.25], 7);
    m.tube(&spout, |j| 0.022 - 0.002 * j as f64, 9);
    let handle =
        arc(at(-0.073, 0.065, 0.0), at(-0.05, 0.0, 0.0), at(0.0, 0.04, 0.0), [-0.25, 0.25], 11);
    m.tube(&handle, |_| 0.007, 6);
}

/// A cup on a saucer.
fn cup(m: &mut Model) {
    m.revolve(&[[0.02, 0.002], [0.034, 0.003], [0.048, 0.007], [0.06, 0.012]], 18);
    m.within(stand(at(0.0, 0.004, 0.0), 0.0), |m| {
        let profile = [
            [0.0, 0.003],
            [0.02, 0.003],
            [0.03, 0.015],
            [0.034, 0.03],
            [0.036, 0.044],
            [0.038, 0.058],
        ];
        m.revolve(&profile, 14);
        let ear =
            arc(at(0.034, 0.032, 0.0), at(0.02, 0.0, 0.0), at(0.0, 0.016, 0.0), [-0.25, 0.25], 5);
        m.tube(&ear, |_| 0.004, 4);
    });
}

/// Cutlery lies along z with its handle towards negative z.
fn handle(m: &mut Model) {
    let path: Vec<DVec3> = (0..7).map(|j| at(0.0, 0.004, 0.016 * f64::from(j))).collect();
    m.tube(&path, |j| [0.004, 0.006, 0.006, 0.006, 0.005, 0.004, 0.003][j], 4);
}

fn fork(m: &mut Model) {
    handle(m);
    m.panel(at(-0.011, 0.004, 0.096), at(0.022, 0.0, 0.0), at(0.0, 0.0, 0.036), 2, 3);
    for i in 0..4 {
        let x = -0.011 + 0.0063 * f64::from(i);
        m.panel(at(x, 0.004, 0.132), at(0.003, 0.0, 0.0), at(0.0, 0.002, 0.048), 1, 4);
    }
}

pub fn knife(m: &mut Model) {
    handle(m);
    m.patch(8, 1, |i, j| {
        let z = 0.096 + 0.014 * i as f64;
        let width = [0.017, 0.018, 0.018, 0.018, 0.018, 0.018, 0.017, 0.012, 0.0][i];
        at(width * j as f64 - 0.005, 0.003 + 0.002 * j as f64, z)
    });
}

fn spoon(m: &mut Model) {
    handle(m);
    m.within(stand(at(0.0, 0.008, 0.122), 0.0), |m| {
        m.patch(10, 2, |i, j| {
            let (sin, cos) = sin_cos((i % 10) as f64 / 10.0);
            let share = j as f64 / 2.0;
            at(0.018 * share * cos, 0.006 * (share * share - 1.0), 0.027 * share * sin)
        });
    });
}
