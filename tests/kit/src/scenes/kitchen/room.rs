//! Floor, walls, ceiling, door, windows and the lamp.

use crate::scenes::shape::{Model, at, point_along, stand};
use glam::{DAffine3, DVec3};

const WIDTH: f64 = 6.0;
const HEIGHT: f64 = 2.7;
const DEPTH: f64 = 4.5;

pub fn room(m: &mut Model) {
    let (x, y, z) = (at(WIDTH, 0.0, 0.0), at(0.0, HEIGHT, 0.0), at(0.0, 0.0, DEPTH));
    m.panel(DVec3::ZERO, z, x, 11, 15);
    m.panel(y, x, z, 2, 1);
    // The back wall has a window over the sink, the right wall one beside the table.
    wall_with_hole(m, DVec3::ZERO, x, [2.4, 3.6], [1.15, 2.15]);
    window(m, stand(at(3.0, 1.15, 0.0), 0.0), 1.2, 1.0);
    wall_with_hole(m, at(WIDTH, 0.0, 0.0), z, [2.0, 3.6], [1.0, 2.2]);
    window(m, stand(at(WIDTH, 1.0, 2.8), -0.25), 1.6, 1.2);
    wall_with_hole(m, z, -z, [0.9, 1.8], [0.0, 2.05]);
    door(m);
    m.panel(z + x, -x, y, 4, 2);
    skirting(m);
    fittings(m);
    lamp(m);
}

/// A wall of the room's height from `corner` along `along`, around a rectangular hole.
fn wall_with_hole(m: &mut Model, corner: DVec3, along: DVec3, hole: [f64; 2], rise: [f64; 2]) {
    let length = along.length();
    let unit = along / length;
    let piece = |m: &mut Model, [a, b]: [f64; 2], [lo, hi]: [f64; 2]| {
        if b > a && hi > lo {
            let start = corner + unit * a + at(0.0, lo, 0.0);
            m.panel(start, unit * (b - a), at(0.0, hi - lo, 0.0), 1, 1);
        }
    };
    piece(m, [0.0, hole[0]], [0.0, HEIGHT]);
    piece(m, [hole[1], length], [0.0, HEIGHT]);
    piece(m, hole, [0.0, rise[0]]);
    piece(m, hole, [rise[1], HEIGHT]);
}

/// A window with a sill, a frame, glazing bars and a handle; the wall's plane is z = 0, the room
/// on the side of positive z.
fn window(m: &mut Model, place: DAffine3, width: f64, height: f64) {
    m.within(place, |m| {
        let half = width / 2.0;
        m.panel(at(-half, 0.0, 0.0), at(width, 0.0, 0.0), at(0.0, height, 0.0), 2, 1);
        m.block(at(-half - 0.06, -0.03, 0.0), at(half + 0.06, 0.0, 0.16));
        for x in [-half, -0.03, half - 0.06] {
            m.block(at(x, 0.0, 0.002), at(x + 0.06, height, 0.05));
        }
        for y in [0.0, height - 0.06] {
            m.block(at(-half, y, 0.003), at(half, y + 0.06, 0.048));
        }
        for y in [height / 3.0, height * 2.0 / 3.0] {
            m.block(at(-half, y - 0.012, 0.004), at(half, y + 0.012, 0.03));
        }
        for x in [-half / 2.0, half / 2.0] {
            m.block(at(x - 0.012, 0.0, 0.004), at(x + 0.012, height, 0.028));
        }
        m.within(stand(at(0.0, height * 0.45, 0.05), 0.0), handle);
    });
}

/// A lever handle that sticks out towards positive z.
fn handle(m: &mut Model) {
    let neck = [at(0.0, 0.0, 0.0), at(0.0, 0.0, 0.03), at(0.0, 0.0, 0.045)];
    m.tube(&neck, |j| 0.008 + 0.004 * (j % 2) as f64, 8);
    let lever = [
        at(0.0, 0.01, 0.045),
        at(0.0, -0.01, 0.05),
        at(0.0, -0.05, 0.05),
        at(0.0, -0.09, 0.045),
        at(0.0, -0.1, 0.045),
    ];
    m.tube(&lever, |j| [0.0, 0.009, 0.007, 0.008, 0.0][j], 8);
}

/// A door of six panels in the left wall, with its frame.
fn door(m: &mut Model) {
    m.within(stand(at(0.0, 0.0, DEPTH - 1.35), 0.25), |m| {
        let (half, height) = (0.45, 2.05);
        m.panel(at(-half, 0.0, -0.02), at(0.9, 0.0, 0.0), at(0.0, height, 0.0), 1, 1);
        for x in [-half, half - 0.05] {
            m.block(at(x, 0.0, 0.0), at(x + 0.05, height, 0.04));
        }
        m.block(at(-half, height, 0.0), at(half, height + 0.06, 0.04));
        for y in [0.15, 0.8, 1.4] {
            for x in [-0.34, 0.04] {
                m.block(at(x, y, -0.02), at(x + 0.3, y + 0.5, -0.005));
                m.block(at(x + 0.05, y + 0.05, -0.006), at(x + 0.25, y + 0.45, 0.004));
            }
        }
        m.within(stand(at(0.36, 1.0, -0.01), 0.0), handle);
    });
}

fn skirting(m: &mut Model) {
    for i in 0..6 {
        let x = f64::from(i);
        m.block(at(x, 0.0, DEPTH - 0.02), at(x + 0.99, 0.09, DEPTH - 0.002));
    }
    for z in [0.7, 1.4, 2.0, 2.6, 3.2, 3.8] {
        m.block(at(WIDTH - 0.02, 0.0, z), at(WIDTH - 0.002, 0.09, z + 0.55));
    }
}

/// Sockets and switches on three walls, spotlights in the ceiling.
fn fittings(m: &mut Model) {
    let right = |y: f64, z: f64| stand(at(WIDTH, y, z), -0.25);
    let left = |y: f64, z: f64| stand(at(0.0, y, z), 0.25);
    let front = |y: f64, x: f64| stand(at(x, y, DEPTH), 0.5);
    for place in [
        right(0.3, 1.3),
        right(0.3, 4.1),
        right(1.2, 1.6),
        left(0.3, 1.2),
        left(0.3, 2.2),
        left(1.2, 2.4),
        front(0.3, 0.8),
        front(0.3, 2.0),
        front(1.2, 2.6),
        front(0.3, 5.2),
    ] {
        m.within(place, socket);
    }
    for (x, z) in [(1.0, 1.1), (3.0, 1.1), (5.0, 1.1), (1.0, 3.6), (5.2, 3.6)] {
        m.within(stand(at(x, HEIGHT, z), 0.0), |m| {
            m.revolve(&[[0.05, 0.0], [0.048, -0.008], [0.036, -0.01]], 16);
        });
    }
}

/// A plate with two holes, on the wall z = 0.
fn socket(m: &mut Model) {
    m.block(at(-0.07, -0.07, 0.0), at(0.07, 0.07, 0.008));
    for x in [-0.009, 0.009] {
        m.within(point_along(at(x, 0.0, 0.008), DVec3::Z), |m| {
            m.revolve(&[[0.004, 0.0], [0.004, 0.003], [0.0, 0.003]], 5);
        });
    }
}

/// A lamp over the table: rose, cord, shade and bulb.
fn lamp(m: &mut Model) {
    m.within(stand(at(3.3, 1.75, 2.85), 0.0), |m| {
        m.revolve(&[[0.046, 0.95], [0.05, 0.935], [0.018, 0.92], [0.0, 0.918]], 16);
        m.tube(&[at(0.0, 0.92, 0.0), at(0.0, 0.3, 0.0)], |_| 0.004, 5);
        m.revolve(&[[0.03, 0.3], [0.14, 0.19], [0.22, 0.05], [0.24, 0.0]], 12);
        m.revolve(&[[0.022, 0.3], [0.022, 0.285], [0.022, 0.27], [0.022, 0.255]], 10);
        m.ball(at(0.0, 0.1, 0.0), at(0.035, 0.05, 0.035), 7, 10);
    });
}
