//! The table: a board, an apron, four turned legs.

use crate::scenes::shape::{Model, at, stand};

/// The height of its top.
pub const HEIGHT: f64 = 0.775;

pub fn table(m: &mut Model) {
    m.blocks(at(-0.95, HEIGHT - 0.04, -0.48), at(0.95, HEIGHT, 0.48), [2, 1, 1]);
    for z in [-0.4, 0.38] {
        m.block(at(-0.82, HEIGHT - 0.14, z), at(0.82, HEIGHT - 0.04, z + 0.02));
    }
    for x in [-0.84, 0.82] {
        m.block(at(x, HEIGHT - 0.14, -0.38), at(x + 0.02, HEIGHT - 0.04, 0.38));
    }
    for (x, z) in [(-0.83, -0.38), (0.83, -0.38), (-0.83, 0.38), (0.83, 0.38)] {
        m.within(stand(at(x, 0.0, z), 0.0), leg);
    }
}

/// A square head, a turned shaft, a ball foot.
fn leg(m: &mut Model) {
    m.slab(at(0.0, 0.58, 0.0), 0.08, 0.13, 0.08);
    m.revolve(&[[0.03, 0.58], [0.038, 0.35], [0.024, 0.14]], 10);
    let turned = [0.024, 0.034, 0.036, 0.028, 0.026, 0.036, 0.042, 0.042, 0.034, 0.02, 0.0];
    let foot: Vec<[f64; 2]> = (0..11).map(|j| [turned[j], 0.14 - 0.014 * j as f64]).collect();
    m.revolve(&foot, 10);
}
