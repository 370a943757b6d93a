//! Shelves of books.

use crate::random::Random;
use crate::scenes::shape::{Model, at};

const BOARDS: u32 = 4;

/// A shelf 0.9 m wide against a wall at z = 0, open towards positive z.
pub fn shelf(m: &mut Model, random: &mut Random) {
    let height = 0.36 * f64::from(BOARDS);
    for x in [-0.45, 0.43] {
        m.block(at(x, 0.0, 0.0), at(x + 0.02, height + 0.02, 0.28));
    }
    m.panel(at(-0.45, 0.0, 0.005), at(0.9, 0.0, 0.0), at(0.0, height, 0.0), 1, 1);
    for board in 0..=BOARDS {
        let y = 0.36 * f64::from(board);
        m.block(at(-0.43, y, 0.0), at(0.43, y + 0.02, 0.28));
        if board < BOARDS {
            books(m, random, y + 0.02);
        }
    }
}

/// A row of books that fills most of a board; some have slid and lean.
fn books(m: &mut Model, random: &mut Random, y: f64) {
    let mut x = -0.425;
    let end = random.range(0.1, 0.4);
    while x < end {
        let thick = random.range(0.025, 0.07);
        let (tall, deep) = (random.range(0.2, 0.32), random.range(0.15, 0.24));
        let lean = if random.chance(0.06) { 0.12 } else { 0.0 };
        book(m, at(x, y, 0.03), [thick, tall, deep], lean * tall);
        x += thick + lean * tall + 0.001;
    }
}

/// A book: covers and spine, and the block of paper set back from them.
fn book(m: &mut Model, foot: glam::DVec3, [thick, tall, deep]: [f64; 3], lean: f64) {
    let corner = |x: f64, y: f64, z: f64| foot + at(x + lean * (1.0 - y / tall), y, z);
    let outline = [(0.0, 0.0), (0.0, deep), (thick, deep), (thick, 0.0)];
    m.patch(3, 1, |i, j| corner(outline[i].0, tall * j as f64, outline[i].1));
    let set_back = tall - 0.005;
    m.patch(1, 1, |i, j| corner(thick * i as f64, set_back, deep * j as f64));
    m.patch(1, 1, |i, j| corner(thick * i as f64, set_back * j as f64, 0.004));
}
