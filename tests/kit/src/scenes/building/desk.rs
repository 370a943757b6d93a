//! A desk.

use super::{desktop, phone};
use crate::random::Random;
use crate::scenes::shape::{Model, at, stand};

const HEIGHT: f64 = 0.73;

/// A desk 1.6 m wide for somebody at negative z, and what lies on it.
pub fn desk(m: &mut Model, random: &mut Random) {
    m.block(at(-0.8, HEIGHT - 0.03, -0.4), at(0.8, HEIGHT, 0.4));
    m.block(at(-0.78, 0.0, -0.38), at(-0.75, HEIGHT - 0.03, 0.38));
    m.block(at(-0.75, 0.25, 0.34), at(0.35, HEIGHT - 0.03, 0.36));
    drawers(m);
    m.within(stand(at(0.0, HEIGHT, 0.0), 0.0), |m| {
        m.within(stand(at(0.25, 0.0, 0.12), 0.45), |m| desktop::computer(m, random));
        m.within(stand(at(-0.55, 0.0, 0.0), 0.04), phone::phone);
        m.within(stand(at(-0.6, 0.0, 0.28), 0.1), desktop::lamp);
        m.within(stand(at(0.68, 0.0, 0.05), random.unit()), desktop::mug);
        m.within(stand(at(-0.28, 0.0, 0.28), random.unit()), |m| desktop::pencils(m, random));
        m.within(stand(at(-0.2, 0.0, -0.15), 0.0), |m| desktop::papers(m, random));
    });
}

fn drawers(m: &mut Model) {
    m.block(at(0.36, 0.0, -0.36), at(0.78, HEIGHT - 0.03, 0.38));
    for (lo, hi) in [(0.04, 0.32), (0.33, 0.5), (0.51, 0.68)] {
        m.block(at(0.37, lo, -0.38), at(0.77, hi, -0.36));
        let y = hi - 0.06;
        let grip =
            [at(0.51, y, -0.38), at(0.515, y, -0.405), at(0.625, y, -0.405), at(0.63, y, -0.38)];
        m.tube(&grip, |_| 0.005, 6);
    }
}
