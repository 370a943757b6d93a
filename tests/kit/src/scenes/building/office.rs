//! What stands in one office.

use super::{chair, desk, desktop, shelf};
use crate::random::Random;
use crate::scenes::shape::{Model, at, point_along, stand};
use glam::DVec3;

/// An office 4.6 m wide about x = 0; the window is in z = 0, the door at z = 6.
pub fn office(m: &mut Model, random: &mut Random) {
    let mut somewhere = |x: f64, z: f64, turn: f64| {
        let shift = |r: &mut Random, by: f64| r.range(-by, by);
        let place = at(x + shift(random, 0.1), 0.0, z + shift(random, 0.1));
        stand(place, turn + shift(random, 0.02))
    };
    let (desk_place, seat) = (somewhere(-0.6, 1.5, 0.0), somewhere(-0.6, 0.8, 0.0));
    let visitor = somewhere(-0.7, 2.6, 0.5);
    let (bin, table) = (somewhere(0.7, 1.0, 0.0), somewhere(0.9, 3.9, 0.1));
    m.within(desk_place, |m| desk::desk(m, random));
    m.within(seat, chair::swivel);
    m.within(visitor, chair::visitor);
    m.within(bin, waste_bin);
    m.within(table, side_table);
    m.within(stand(at(-2.2, 0.0, 2.1), 0.25), |m| shelf::shelf(m, random));
    radiator(m);
    whiteboard(m);
    for x in [-1.1, 1.1] {
        m.within(stand(at(x, 3.22, 3.0), 0.0), ceiling_light);
    }
}

/// A meeting room: a long table with eight chairs.
pub fn meeting_room(m: &mut Model, random: &mut Random) {
    m.block(at(-0.6, 0.7, 1.4), at(0.6, 0.74, 4.6));
    for z in [1.9, 4.1] {
        m.within(stand(at(0.0, 0.0, z), 0.0), |m| {
            m.revolve(&[[0.05, 0.7], [0.05, 0.1], [0.3, 0.03], [0.31, 0.0]], 12);
        });
    }
    for i in 0..4 {
        let z = 1.8 + 0.8 * f64::from(i);
        for (x, turn) in [(-0.95, 0.25), (0.95, -0.25)] {
            let foot = at(x + random.range(-0.1, 0.1), 0.0, z);
            m.within(stand(foot, turn + random.range(-0.04, 0.04)), chair::visitor);
        }
    }
    for (x, z) in [(-0.2, 2.0), (0.25, 2.9), (-0.1, 3.9)] {
        m.within(stand(at(x, 0.74, z), random.unit()), desktop::mug);
    }
    radiator(m);
    whiteboard(m);
    for x in [-1.1, 1.1] {
        m.within(stand(at(x, 3.22, 3.0), 0.0), ceiling_light);
    }
}

fn waste_bin(m: &mut Model) {
    let profile = [[0.0, 0.005], [0.12, 0.005], [0.13, 0.15], [0.15, 0.32], [0.155, 0.325]];
    m.revolve(&profile, 16);
}

fn side_table(m: &mut Model) {
    m.within(stand(at(0.0, 0.7, 0.0), 0.0), |m| {
        m.revolve(&[[0.0, 0.03], [0.45, 0.03], [0.46, 0.015], [0.45, 0.0], [0.0, 0.0]], 16);
    });
    m.revolve(&[[0.03, 0.7], [0.03, 0.1], [0.05, 0.05], [0.25, 0.02], [0.26, 0.0]], 12);
    m.within(stand(at(-0.44, 0.0, -0.61), 0.1), chair::visitor);
}

fn radiator(m: &mut Model) {
    for i in 0..10 {
        let x = -0.5 + 0.1 * f64::from(i);
        m.block(at(x, 0.15, 0.28), at(x + 0.07, 0.75, 0.36));
    }
    for y in [0.2, 0.68] {
        m.tube(&[at(-0.72, y, 0.32), at(0.75, y, 0.32)], |_| 0.015, 6);
    }
    m.within(point_along(at(0.75, 0.68, 0.32), DVec3::X), |m| {
        m.revolve(&[[0.02, 0.0], [0.025, 0.02], [0.025, 0.06], [0.018, 0.07], [0.0, 0.072]], 10);
    });
}

fn whiteboard(m: &mut Model) {
    m.block(at(2.2, 0.9, 1.5), at(2.23, 2.1, 3.3));
    m.block(at(2.12, 0.86, 1.7), at(2.23, 0.89, 3.1));
    for i in 0..2 {
        let z = 1.9 + 0.25 * f64::from(i);
        m.tube(&[at(2.17, 0.9, z), at(2.17, 0.9, z + 0.1), at(2.17, 0.9, z + 0.13)], |_| 0.009, 8);
    }
}

/// A louvred fitting below the ceiling.
fn ceiling_light(m: &mut Model) {
    m.block(at(-0.3, 0.0, -0.6), at(0.3, 0.08, 0.6));
    for i in 0..8 {
        let z = -0.53 + 0.15 * f64::from(i);
        m.panel(at(-0.29, -0.05, z), at(0.58, 0.0, 0.0), at(0.0, 0.05, 0.01), 1, 1);
    }
    for x in [-0.15, 0.15] {
        m.tube(&[at(x, -0.02, -0.58), at(x, -0.02, 0.58)], |_| 0.013, 8);
    }
}
