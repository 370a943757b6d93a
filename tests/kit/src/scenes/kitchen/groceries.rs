//! Food, and the shelves with jars, books and a clock on the front wall.

use super::crockery::knife;
use crate::random::Random;
use crate::scenes::shape::{Model, at, point_along, sin_cos, stand};
use glam::DVec3;

const STREAM: u64 = 21;

/// Apples and oranges in the bowl.
pub fn fruit(m: &mut Model) {
    for (x, y, z, radius) in
        [(0.045, 0.055, 0.0, 0.036), (-0.04, 0.058, 0.005, 0.04), (0.0, 0.105, 0.0, 0.037)]
    {
        m.ball(at(x, y, z), at(radius, radius * 0.93, radius), 7, 10);
        m.tube(&[at(x, y + radius * 0.9, z), at(x + 0.006, y + radius + 0.014, z)], |_| 0.0015, 4);
    }
}

/// A board with a loaf, slices and a knife.
pub fn breadboard(m: &mut Model) {
    m.block(at(-0.17, 0.0, -0.1), at(0.17, 0.018, 0.1));
    m.within(stand(at(-0.05, 0.018, 0.0), 0.0), |m| {
        m.patch(10, 9, |i, j| {
            let (sin, cos) = sin_cos(i as f64 / 20.0);
            let swell = [0.3, 0.75, 0.95, 1.0, 1.0, 1.0, 1.0, 1.0, 0.97, 0.97][j];
            at(-0.1 + 0.018 * j as f64, 0.075 * swell * sin, 0.05 * swell * cos)
        });
    });
    for i in 0..2 {
        let x = 0.09 + 0.022 * f64::from(i);
        m.within(point_along(at(x, 0.05, 0.0), at(1.0, 0.25, 0.0)), |m| {
            m.revolve(
                &[
                    [0.0, 0.0],
                    [0.02, 0.0],
                    [0.038, 0.0],
                    [0.038, 0.009],
                    [0.02, 0.009],
                    [0.0, 0.009],
                ],
                12,
            );
        });
    }
    m.within(stand(at(0.0, 0.018, -0.085), 0.25), knife);
}

/// Two boards on the front wall with jars, bottles and books, and a clock above.
pub fn shelves(m: &mut Model) {
    let mut random = Random::stream(STREAM);
    // Seen from the wall: x runs to the left, z into the room.
    m.within(stand(at(4.6, 0.0, 4.5), 0.5), |m| {
        for y in [1.3, 1.7] {
            m.block(at(-0.8, y - 0.025, 0.0), at(0.8, y, 0.22));
            for x in [-0.6, 0.6] {
                m.block(at(x - 0.01, y - 0.18, 0.0), at(x + 0.01, y - 0.025, 0.18));
            }
        }
        for i in 0..7 {
            let place = stand(at(-0.66 + 0.22 * f64::from(i), 1.3, 0.11), random.unit());
            m.within(place, |m| if i % 3 == 1 { bottle(m) } else { jar(m) });
        }
        let mut x = -0.7;
        while x < 0.55 {
            let thick = random.range(0.025, 0.06);
            let tall = random.range(0.18, 0.27);
            m.block(at(x, 1.7, 0.01), at(x + thick, 1.7 + tall, random.range(0.15, 0.2)));
            x += thick + 0.002;
        }
        m.within(point_along(at(1.6, 1.9, 0.0), DVec3::Z), clock);
    });
}

fn jar(m: &mut Model) {
    m.revolve(&[[0.044, 0.0], [0.044, 0.11]], 9);
    let lid = [[0.044, 0.11], [0.044, 0.124], [0.03, 0.13], [0.015, 0.131], [0.0, 0.131]];
    m.revolve(&lid, 14);
}

fn bottle(m: &mut Model) {
    m.revolve(&[[0.035, 0.0], [0.035, 0.14]], 8);
    let neck = [
        [0.035, 0.14],
        [0.028, 0.155],
        [0.018, 0.168],
        [0.013, 0.182],
        [0.013, 0.198],
        [0.013, 0.214],
        [0.016, 0.22],
        [0.016, 0.232],
        [0.0, 0.233],
    ];
    m.revolve(&neck, 10);
}

/// A clock facing along its y axis.
fn clock(m: &mut Model) {
    m.revolve(&[[0.15, 0.0], [0.16, 0.01], [0.16, 0.03], [0.15, 0.035], [0.145, 0.025]], 24);
    m.revolve(&[[0.145, 0.02], [0.0, 0.02]], 24);
    for hour in 0..12 {
        m.within(stand(DVec3::ZERO, f64::from(hour) / 12.0), |m| {
            m.panel(at(0.115, 0.021, -0.004), DVec3::X * 0.02, DVec3::Z * 0.008, 1, 1);
        });
    }
    for (turn, length) in [(0.1, 0.08), (0.37, 0.11)] {
        m.within(stand(DVec3::ZERO, turn), |m| {
            m.block(at(-0.01, 0.024, -0.003), at(length, 0.026, 0.003));
        });
    }
}
