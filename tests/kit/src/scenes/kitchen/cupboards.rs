//! Two rows of cupboards along the back wall, with sink, tap and tiles between them.

use crate::random::Random;
use crate::scenes::shape::{Model, arc, at, point_along, stand};
use glam::DVec3;

const UNIT: f64 = 0.6;
const TOP: f64 = 0.9;
/// The middle of the scouring pad, on the worktop beside the sink.
const PAD: DVec3 = DVec3::new(3.49, 0.907, 0.439);
const STREAM: u64 = 25;

pub fn rows(m: &mut Model) {
    for i in 0..10 {
        // The stove takes the place of one unit, the refrigerator that of the last.
        match i {
            2 => continue,
            9 => m.within(stand(at(UNIT * 9.0, 0.0, 0.0), 0.0), refrigerator),
            _ => m.within(stand(at(UNIT * f64::from(i), 0.0, 0.0), 0.0), |m| {
                base_unit(m, i % 3 == 0)
            }),
        }
        if i < 4 || (6..9).contains(&i) {
            let doors = if i < 4 { 1 } else { 2 };
            m.within(stand(at(UNIT * f64::from(i), 1.45, 0.0), 0.0), |m| wall_unit(m, doors));
        }
    }
    for (from, to) in [(0.0, 1.2), (1.8, 2.6), (3.4, 5.4)] {
        m.block(at(from, TOP - 0.04, 0.0), at(to, TOP, 0.63));
    }
    m.within(stand(at(3.0, TOP, 0.32), 0.0), sink);
    m.within(stand(PAD, 0.0), scouring_pad);
    m.slab(at(3.56, TOP, 0.42), 0.045, 0.018, 0.027);
    tiles(m);
}

/// Doors under drawers, or three drawers.
fn base_unit(m: &mut Model, drawers: bool) {
    m.block(at(0.005, 0.1, 0.01), at(UNIT - 0.005, TOP - 0.04, 0.57));
    m.block(at(0.0, 0.0, 0.05), at(UNIT, 0.1, 0.5));
    let heights: &[[f64; 2]] = match drawers {
        true => &[[0.12, 0.36], [0.38, 0.62], [0.64, 0.84]],
        false => &[[0.12, 0.66], [0.68, 0.84]],
    };
    for &[lo, hi] in heights {
        front(m, at(0.015, lo, 0.57), at(UNIT - 0.015, hi, 0.59));
        let x = if hi - lo > 0.3 { UNIT - 0.06 } else { UNIT / 2.0 };
        knob(m, at(x, hi - 0.08, 0.59));
    }
}

/// One door, or two with their knobs in the middle.
fn wall_unit(m: &mut Model, doors: usize) {
    m.block(at(0.005, 0.0, 0.01), at(UNIT - 0.005, 0.75, 0.31));
    let width = UNIT / doors as f64;
    for door in 0..doors {
        let x = width * door as f64;
        front(m, at(x + 0.01, 0.01, 0.31), at(x + width - 0.01, 0.74, 0.33));
        let hinged_left = door == 0;
        let knob_x = if hinged_left { x + width - 0.035 } else { x + 0.035 };
        knob(m, at(knob_x, 0.08, 0.33));
    }
}

/// A door or drawer front: a sunk panel in a raised frame, flush with the carcass behind.
fn front(m: &mut Model, lo: DVec3, hi: DVec3) {
    let rail = 0.05;
    let profile = [(0.0, lo.z), (0.0, hi.z), (rail, hi.z), (rail, hi.z - 0.008)];
    m.patch(4, 3, |i, j| {
        let (inset, z) = profile[j];
        let x = [lo.x + inset, hi.x - inset][usize::from((1..3).contains(&(i % 4)))];
        let y = [lo.y + inset, hi.y - inset][usize::from(i % 4 >= 2)];
        at(x, y, z)
    });
    let corner = at(lo.x + rail, lo.y + rail, hi.z - 0.008);
    let (width, height) = (hi.x - lo.x - 2.0 * rail, hi.y - lo.y - 2.0 * rail);
    m.panel(corner, at(width, 0.0, 0.0), at(0.0, height, 0.0), 1, 1);
}

/// A turned knob on a front, sticking out towards positive z.
pub fn knob(m: &mut Model, base: DVec3) {
    m.within(point_along(base, DVec3::Z), |m| {
        let profile = [
            [0.007, 0.0],
            [0.007, 0.01],
            [0.014, 0.017],
            [0.016, 0.022],
            [0.012, 0.027],
            [0.0, 0.029],
        ];
        m.revolve(&profile, 6);
    });
}

fn refrigerator(m: &mut Model) {
    m.block(at(0.01, 0.05, 0.02), at(0.59, 1.85, 0.6));
    m.block(at(0.015, 0.06, 0.6), at(0.585, 1.25, 0.64));
    m.block(at(0.015, 1.27, 0.6), at(0.585, 1.84, 0.64));
    for (lo, hi) in [(0.75, 1.15), (1.35, 1.65)] {
        for y in [lo + 0.01, hi - 0.01] {
            m.tube(&[at(0.07, y, 0.64), at(0.07, y, 0.655), at(0.07, y, 0.67)], |_| 0.007, 6);
        }
        m.tube(&[at(0.07, lo, 0.675), at(0.07, hi, 0.675)], |_| 0.01, 8);
    }
}

/// Two basins and a tap, about the middle of the worktop.
fn sink(m: &mut Model) {
    for x in [-0.2, 0.2] {
        m.within(stand(at(x, 0.0, 0.02), 0.0), |m| {
            m.revolve(&[[0.0, -0.16], [0.12, -0.15], [0.16, 0.0], [0.18, 0.004]], 14);
            m.revolve(&[[0.0, -0.157], [0.012, -0.156], [0.022, -0.154], [0.025, -0.148]], 10);
        });
    }
    for (z, depth) in [(0.2, 0.1), (-0.3, 0.14)] {
        m.panel(at(-0.4, 0.002, z), at(0.8, 0.0, 0.0), at(0.0, 0.0, depth), 2, 1);
    }
    m.within(stand(at(0.0, 0.0, -0.24), 0.0), |m| {
        let column = [
            [0.03, 0.0],
            [0.028, 0.014],
            [0.018, 0.025],
            [0.014, 0.04],
            [0.014, 0.06],
            [0.014, 0.08],
            [0.014, 0.1],
            [0.014, 0.12],
        ];
        m.revolve(&column, 6);
        let bow = arc(at(0.0, 0.2, 0.09), at(0.0, 0.0, -0.09), at(0.0, 0.09, 0.0), [0.0, 0.5], 12);
        m.tube(&bow, |j| if j == 12 { 0.016 } else { 0.012 }, 5);
        for x in [-0.09, 0.09] {
            m.within(stand(at(x, 0.0, 0.0), 0.0), |m| {
                m.revolve(
                    &[
                        [0.014, 0.0],
                        [0.01, 0.013],
                        [0.012, 0.026],
                        [0.024, 0.034],
                        [0.022, 0.046],
                        [0.0, 0.05],
                    ],
                    10,
                );
            });
        }
    });
}

/// A ball of steel shavings, all of them past its middle.
fn scouring_pad(m: &mut Model) {
    let mut random = Random::stream(STREAM);
    let mut offset = |size: f64| {
        let [x, y, z] = [0; 3].map(|_| random.range(-size, size));
        at(x, 0.45 * y, z)
    };
    for _ in 0..53 {
        let (middle, along, across) = (offset(0.002), offset(0.012), offset(0.0015));
        m.triangle([middle - along - across, middle - along + across, middle + along]);
    }
}

/// Tiles on the wall between worktop and wall cupboards.
fn tiles(m: &mut Model) {
    for row in 0..2 {
        for column in 0..18 {
            let (x, y) = (0.3 * f64::from(column), TOP + 0.01 + 0.27 * f64::from(row));
            let behind_window = x + 0.3 > 2.3 && x < 3.7 && row > 0;
            if !behind_window {
                let corner = at(x + 0.002, y, 0.006);
                m.panel(corner, at(0.296, 0.0, 0.0), at(0.0, 0.266, 0.0), 1, 1);
            }
        }
    }
}
