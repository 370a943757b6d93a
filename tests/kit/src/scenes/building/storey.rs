//! Walls, doors, windows, slabs and stairs of one storey.

use crate::scenes::shape::{Model, at, stand};
use glam::DAffine3;

pub const HEIGHT: f64 = 3.6;
pub const DEPTH: f64 = 14.0;
pub const ROOM_WIDTH: f64 = 4.6;
/// Rooms on each side of the corridor.
pub const ROOMS: usize = 13;

const LENGTH: f64 = ROOM_WIDTH * ROOMS as f64;
/// The corridor lies between these two.
const CORRIDOR: [f64; 2] = [6.0, 8.0];
const SLAB: f64 = 0.3;
const CLEAR: f64 = HEIGHT - SLAB;

/// A hole in a wall: from, to, bottom, top.
type Hole = [f64; 4];

const DOOR: Hole = [3.0, 3.95, 0.0, 2.1];
const WINDOW: Hole = [0.9, 3.7, 0.9, 2.6];

/// One storey standing on its slab; the slab is in two pieces, the first `split` long.
pub fn storey(m: &mut Model, split: f64) {
    slabs(m, split);
    for room in 0..ROOMS {
        let x = ROOM_WIDTH * room as f64;
        m.within(stand(at(x, 0.0, 0.0), 0.0), room_walls);
        m.within(stand(at(x + ROOM_WIDTH, 0.0, DEPTH), 0.5), room_walls);
    }
    for z in [0.0, CORRIDOR[1]] {
        m.block(at(LENGTH - 0.06, 0.0, z), at(LENGTH + 0.06, CLEAR, z + CORRIDOR[0]));
    }
    for x in [0.0, LENGTH] {
        let (lo, hi) = (at(x - 0.1, 0.0, CORRIDOR[0]), at(x + 0.1, CLEAR, CORRIDOR[1]));
        m.block(lo, hi);
    }
}

/// The slab below a storey.
pub fn slabs(m: &mut Model, split: f64) {
    m.block(at(0.0, -SLAB, 0.0), at(split, 0.0, DEPTH));
    m.block(at(split, -SLAB, 0.0), at(LENGTH, 0.0, DEPTH));
}

/// The walls of a room whose window is in z = 0 and whose left wall is x = 0.
fn room_walls(m: &mut Model) {
    m.block(at(-0.06, 0.0, 0.12), at(0.06, CLEAR, CORRIDOR[0] - 0.06));
    wall(m, 0.0, 0.24, WINDOW);
    window(m, WINDOW);
    wall(m, CORRIDOR[0] - 0.06, 0.12, DOOR);
    m.within(stand(at(0.0, 0.0, CORRIDOR[0] - 0.07), 0.0), |m| door(m, DOOR));
}

/// A wall one room long at depth `z`, in blocks around its hole.
fn wall(m: &mut Model, z: f64, thickness: f64, [from, to, bottom, top]: Hole) {
    let mut piece = |x: [f64; 2], y: [f64; 2]| {
        if y[1] > y[0] {
            m.block(at(x[0], y[0], z), at(x[1], y[1], z + thickness));
        }
    };
    piece([0.0, from], [0.0, CLEAR]);
    piece([to, ROOM_WIDTH], [0.0, CLEAR]);
    piece([from, to], [0.0, bottom]);
    piece([from, to], [top, CLEAR]);
}

/// Frame, mullion and sill.
fn window(m: &mut Model, [from, to, bottom, top]: Hole) {
    for x in [from, to - 0.06] {
        m.block(at(x, bottom, 0.08), at(x + 0.06, top, 0.15));
    }
    for y in [bottom, top - 0.06] {
        m.block(at(from + 0.06, y, 0.08), at(to - 0.06, y + 0.06, 0.15));
    }
    let middle = (from + to) / 2.0;
    m.block(at(middle - 0.01, bottom + 0.06, 0.1), at(middle + 0.01, top - 0.06, 0.115));
    m.block(at(from - 0.1, bottom - 0.04, 0.24), at(to + 0.1, bottom, 0.4));
}

/// The frame about a door that stands open.
fn door(m: &mut Model, [from, to, _, top]: Hole) {
    for x in [from - 0.06, to] {
        m.block(at(x, 0.0, 0.0), at(x + 0.06, top, 0.14));
    }
    m.block(at(from - 0.06, top, 0.0), at(to + 0.06, top + 0.06, 0.14));
}

/// A flight of stairs at the end of the corridor.
pub fn stairs(m: &mut Model) {
    let steps = 13;
    let place: DAffine3 = stand(at(LENGTH - 5.0, 0.0, CORRIDOR[0] + 0.1), 0.0);
    m.within(place, |m| {
        for i in 0..steps {
            let (x, y) = (0.3 * f64::from(i), HEIGHT * f64::from(i) / f64::from(steps));
            m.block(at(x, y, 0.0), at(x + 0.32, y + 0.2, 0.9));
        }
    });
}
