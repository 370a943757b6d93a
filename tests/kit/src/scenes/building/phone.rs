//! A desk telephone with keys, a receiver and its coiled cord.

use crate::scenes::shape::{Model, at, sin_cos};
use glam::DVec3;

/// A key: four sloping sides and a top.
pub fn key(m: &mut Model, foot: DVec3, half_width: f64, half_depth: f64) {
    let corner = |i: usize, share: f64, y: f64| {
        let (x, z) = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)][i % 4];
        foot + at(x * half_width * share, y, z * half_depth * share)
    };
    m.patch(4, 1, |i, j| corner(i, [1.0, 0.75][j], [0.0, 0.008][j]));
    m.patch(1, 1, |i, j| corner([[0, 3], [1, 2]][j][i], 0.75, 0.008));
}

/// A telephone for somebody at negative z.
pub fn phone(m: &mut Model) {
    m.patch(4, 2, |i, j| {
        let (x, z) = [(-0.09, -0.1), (-0.09, 0.1), (0.09, 0.1), (0.09, -0.1)][i % 4];
        let share = [1.0, 0.95, 0.0][j];
        at(x * share, if j == 0 { 0.0 } else { 0.05 + 0.2 * z * share }, z * share)
    });
    for i in 0..12 {
        let (column, row) = (i % 3, i / 3);
        let (x, z) = (0.015 + 0.022 * f64::from(column), -0.06 + 0.022 * f64::from(row));
        key(m, at(x, 0.05 + 0.2 * z, z), 0.008, 0.007);
    }
    for i in 0..2 {
        let x = 0.02 + 0.03 * f64::from(i);
        m.ball(at(x, 0.067, 0.07), at(0.002, 0.002, 0.002), 4, 6);
    }
    receiver(m);
    cord(m);
}

fn receiver(m: &mut Model) {
    for z in [-0.075, 0.075] {
        m.ball(at(-0.055, 0.072, z), at(0.024, 0.018, 0.024), 5, 8);
    }
    let path: Vec<DVec3> = (0..=8)
        .map(|j| {
            let (sin, _) = sin_cos(f64::from(j) / 16.0);
            at(-0.055, 0.078 + 0.018 * sin, -0.07 + 0.0175 * f64::from(j))
        })
        .collect();
    m.tube(&path, |_| 0.013, 6);
}

/// A helix from the receiver to the back of the telephone.
fn cord(m: &mut Model) {
    let turns = 7;
    let path: Vec<DVec3> = (0..=turns * 5)
        .map(|i| {
            let (sin, cos) = sin_cos(f64::from(i) / 5.0);
            let way = f64::from(i) / f64::from(turns * 5);
            let sag = 4.0 * way * (1.0 - way);
            at(-0.1 - 0.05 * sag + 0.008 * cos, 0.012 + 0.008 * sin, -0.09 + 0.18 * way)
        })
        .collect();
    m.tube(&path, |_| 0.002, 3);
}
