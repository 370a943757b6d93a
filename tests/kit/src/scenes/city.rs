//! A city: two and a half dimensions, towers in the middle and houses about them.

use super::shape::{Model, at, stand};
use super::{NamedView, Scene};
use crate::View;
use crate::random::Random;
use glam::DVec3;

const STREAM: u64 = 23;
const BLOCKS: usize = 6;
const BLOCK: f64 = 74.0;
const STREET: f64 = 12.0;
const PITCH: f64 = BLOCK + STREET;
const SIDE: f64 = PITCH * BLOCKS as f64 + STREET;

/// 528 m square.
pub fn city() -> Scene {
    let mut model = Model::default();
    let mut random = Random::stream(STREAM);
    model.panel(DVec3::ZERO, at(0.0, 0.0, SIDE), at(SIDE, 0.0, 0.0), 3, 3);
    for column in 0..BLOCKS {
        for row in 0..BLOCKS {
            let corner = at(STREET + PITCH * column as f64, 0.0, STREET + PITCH * row as f64);
            let middle = BLOCKS / 2;
            let away = column.abs_diff(middle).max(row.abs_diff(middle));
            model.within(stand(corner, 0.0), |m| block(m, &mut random, away));
        }
    }
    let view = |name, eye, at, fov_deg| NamedView {
        name,
        view: View { eye, at, up: [0.0, 1.0, 0.0], fov_deg },
    };
    Scene {
        mesh: model.finish(),
        views: vec![
            view("street", [178.0, 4.0, 12.0], [178.5, 12.0, 300.0], 65.0),
            view("roofs", [30.0, 38.0, 20.0], [260.0, 5.0, 250.0], 60.0),
        ],
    }
}

/// One block on its pavement: towers, a park, or houses, by its distance from the middle.
fn block(m: &mut Model, random: &mut Random, away: usize) {
    m.block(DVec3::ZERO, at(BLOCK, 0.2, BLOCK));
    m.within(stand(at(0.0, 0.2, 0.0), 0.0), |m| {
        if away <= 1 && random.chance(0.75) {
            towers(m, random);
        } else if random.chance(0.12) {
            park(m, random, 38);
        } else {
            houses(m, random);
        }
    });
}

/// Four towers of several storeys.
fn towers(m: &mut Model, random: &mut Random) {
    for (x, z) in [(4.0, 4.0), (40.0, 4.0), (4.0, 40.0), (40.0, 40.0)] {
        let (width, depth) = (random.range(18.0, 30.0), random.range(18.0, 30.0));
        let storeys = 4 + random.below(9);
        m.within(stand(at(x, 0.0, z), 0.0), |m| tower(m, random, width, depth, storeys));
    }
}

fn tower(m: &mut Model, random: &mut Random, width: f64, depth: f64, storeys: usize) {
    let height = 3.5 * storeys as f64 + 1.5;
    m.block(DVec3::ZERO, at(width, height, depth));
    for (corner, along, out) in [
        (at(0.0, 0.0, 0.0), at(width, 0.0, 0.0), at(0.0, 0.0, -0.05)),
        (at(0.0, 0.0, depth), at(width, 0.0, 0.0), at(0.0, 0.0, 0.05)),
        (at(0.0, 0.0, 0.0), at(0.0, 0.0, depth), at(-0.05, 0.0, 0.0)),
        (at(width, 0.0, 0.0), at(0.0, 0.0, depth), at(0.05, 0.0, 0.0)),
    ] {
        let bays = 6;
        for storey in 0..storeys {
            for bay in 0..bays {
                let share = (bay as f64 + 0.2) / bays as f64;
                let foot = corner + out + along * share + at(0.0, 3.5 * storey as f64 + 1.4, 0.0);
                m.panel(foot, along * (0.6 / bays as f64), at(0.0, 1.7, 0.0), 1, 1);
            }
        }
    }
    for _ in 0..3 {
        let place = at(random.range(2.0, width - 4.0), height, random.range(2.0, depth - 4.0));
        m.slab(place, random.range(1.2, 3.0), random.range(0.9, 2.2), random.range(1.2, 3.0));
    }
}

fn park(m: &mut Model, random: &mut Random, trees: usize) {
    for _ in 0..trees {
        let place = at(random.range(3.0, BLOCK - 3.0), 0.0, random.range(3.0, BLOCK - 3.0));
        m.within(stand(place, random.unit()), |m| tree(m, random));
    }
}

fn tree(m: &mut Model, random: &mut Random) {
    let (height, radius) = (random.range(4.0, 9.0), random.range(1.5, 2.6));
    m.tube(&[DVec3::ZERO, at(0.0, height * 0.4, 0.0)], |_| 0.25, 4);
    let crown = at(radius, height * 0.4, radius);
    m.ball(at(0.0, height * 0.65, 0.0), crown, 4, 5);
}

/// Houses with gardens along the four sides.
fn houses(m: &mut Model, random: &mut Random) {
    for side in 0..4 {
        let place = match side {
            0 => stand(DVec3::ZERO, 0.0),
            1 => stand(at(0.0, 0.0, BLOCK), 0.25),
            2 => stand(at(BLOCK, 0.0, BLOCK), 0.5),
            _ => stand(at(BLOCK, 0.0, 0.0), 0.75),
        };
        m.within(place, |m| {
            let mut x = 3.0;
            while x < BLOCK - 22.0 {
                let width = random.range(8.5, 13.0);
                let foot = at(x, 0.0, random.range(3.0, 7.0));
                m.within(stand(foot, 0.0), |m| house(m, random, width));
                let behind = at(x + width / 2.0, 0.0, 20.0 + random.range(0.0, 6.0));
                if random.chance(0.4) {
                    m.within(stand(behind, random.unit()), |m| tree(m, random));
                }
                x += width + random.range(1.5, 5.0);
            }
        });
    }
}

/// A house with a gabled roof, its front in z = 0.
fn house(m: &mut Model, random: &mut Random, width: f64) {
    let depth = random.range(7.5, 10.0);
    let storeys = 1 + random.below(3);
    let (eaves, rise) = (2.9 * storeys as f64 + 0.4, random.range(2.0, 3.8));
    let ridge = eaves + rise;
    m.block(DVec3::ZERO, at(width, eaves, depth));
    for x in [0.0, width] {
        m.triangle([at(x, eaves, 0.0), at(x, eaves, depth), at(x, ridge, depth / 2.0)]);
    }
    // The roof hangs over by as much as it falls in half a metre.
    let drop = rise / (depth / 2.0);
    for (z, out) in [(0.0, -0.5), (depth, 0.5)] {
        let foot = at(-0.4, eaves - 0.5 * drop, z + out);
        let top = at(-0.4, ridge, depth / 2.0);
        m.panel(foot, at(width + 0.8, 0.0, 0.0), top - foot, 1, 2);
    }
    for storey in 0..storeys {
        let y = 2.9 * storey as f64 + 1.0;
        let bays = (width / 3.0) as usize;
        for bay in 0..bays {
            let x = (bay as f64 + 0.5) * width / bays as f64 - 0.6;
            let is_door = storey == 0 && bay == 1;
            for z in [-0.04, depth + 0.04] {
                let (foot, height) = if is_door { (0.0, 2.2) } else { (y, 1.4) };
                m.panel(at(x, foot, z), at(1.2, 0.0, 0.0), at(0.0, height, 0.0), 1, 1);
            }
        }
        for x in [-0.04, width + 0.04] {
            let foot = at(x, y, depth / 2.0 - 0.6);
            m.panel(foot, at(0.0, 0.0, 1.2), at(0.0, 1.4, 0.0), 1, 1);
        }
    }
    m.slab(at(width * 0.3, ridge - 1.2, depth / 2.0), 0.6, 2.2, 0.6);
    if random.chance(0.3) {
        dormer(m, at(width * 0.65, eaves + 0.4, 0.8), depth / 2.0);
    }
}

/// A window in the roof.
fn dormer(m: &mut Model, foot: DVec3, back: f64) {
    let (lo, hi) = (foot - at(0.8, 0.0, 0.0), foot + at(0.8, 1.4, 0.0));
    m.block(lo, at(hi.x, hi.y, back));
    m.panel(foot + at(-0.6, 0.2, -0.03), at(1.2, 0.0, 0.0), at(0.0, 1.0, 0.0), 1, 1);
}
