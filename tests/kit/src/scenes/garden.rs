//! A garden: leaves scattered all through the space.

use super::shape::{Model, at, point_along, stand};
use super::{NamedView, Scene};
use crate::View;
use crate::random::Random;
use glam::DVec3;

const STREAM: u64 = 24;
const SIDE: f64 = 28.0;

/// 28 m square.
pub fn garden() -> Scene {
    let mut model = Model::default();
    let mut random = Random::stream(STREAM);
    let m = &mut model;
    m.panel(DVec3::ZERO, at(0.0, 0.0, SIDE), at(SIDE, 0.0, 0.0), 3, 3);
    path(m, &mut random);
    fence(m);
    for (x, z) in [(4.5, 5.5), (19.5, 5.0), (24.0, 15.0), (5.0, 16.5), (18.5, 21.5)] {
        let place = at(x + random.range(-1.0, 1.0), 0.0, z + random.range(-1.0, 1.0));
        m.within(stand(place, random.unit()), |m| tree(m, &mut random));
    }
    for _ in 0..11 {
        let place = beside_path(&mut random, 3.0);
        m.within(stand(place, random.unit()), |m| bush(m, &mut random));
    }
    for _ in 0..60 {
        let place = beside_path(&mut random, 1.6);
        m.within(stand(place, random.unit()), |m| flower(m, &mut random));
    }
    for _ in 0..3400 {
        let foot = beside_path(&mut random, 1.0);
        blade(m, &mut random, foot);
    }
    let view = |name, eye, at, fov_deg| NamedView {
        name,
        view: View { eye, at, up: [0.0, 1.0, 0.0], fov_deg },
    };
    Scene {
        mesh: model.finish(),
        views: vec![
            view("path", [12.5, 1.7, 27.0], [14.0, 2.3, 8.0], 65.0),
            view("crown", [8.6, 2.2, 9.6], [4.4, 4.0, 5.4], 60.0),
        ],
    }
}

/// Where the winding path runs.
fn path_x(z: f64) -> f64 {
    14.0 + 2.0 * libm::sin(z * 0.25)
}

fn beside_path(random: &mut Random, gap: f64) -> DVec3 {
    loop {
        let place = at(random.range(0.5, SIDE - 0.5), 0.0, random.range(0.5, SIDE - 0.5));
        if libm::fabs(place.x - path_x(place.z)) > gap {
            return place;
        }
    }
}

/// Flagstones.
fn path(m: &mut Model, random: &mut Random) {
    for i in 0..34 {
        let z = 0.4 + 0.8 * f64::from(i);
        for side in [-0.42, 0.42] {
            let foot = at(path_x(z) + side, 0.0, z + random.range(-0.05, 0.05));
            m.within(stand(foot, random.range(-0.02, 0.02)), |m| {
                m.slab(DVec3::ZERO, 0.75, 0.07, 0.68)
            });
        }
    }
}

/// Posts, rails and boards on three sides.
fn fence(m: &mut Model) {
    for place in [
        stand(at(0.1, 0.0, 0.1), 0.0),
        stand(at(0.1, 0.0, SIDE - 0.1), 0.25),
        stand(at(SIDE - 0.1, 0.0, 0.1), 0.75),
    ] {
        m.within(place, |m| {
            for i in 0..11 {
                let x = 2.5 * f64::from(i);
                m.slab(at(x, 0.0, 0.0), 0.12, 1.4, 0.12);
                for y in [0.4, 1.1] {
                    m.block(at(x, y, -0.04), at(x + 2.3, y + 0.1, 0.04));
                }
            }
        });
    }
}

/// A trunk that forks again and again; leaves on the last twigs.
fn tree(m: &mut Model, random: &mut Random) {
    let height = random.range(2.0, 2.6);
    let lean = at(random.range(-0.1, 0.1), 1.0, random.range(-0.1, 0.1));
    let trunk = Limb { foot: DVec3::ZERO, way: lean.normalize() * height, radius: 0.08 * height };
    branch(m, random, &trunk, 4);
}

struct Limb {
    foot: DVec3,
    way: DVec3,
    radius: f64,
}

fn branch(m: &mut Model, random: &mut Random, limb: &Limb, forks: usize) {
    let top = limb.foot + limb.way;
    let sides = 3 + forks;
    m.tube(&[limb.foot, top], |j| limb.radius * [1.0, 0.7][j], sides);
    if forks <= 1 {
        let leaves = if forks == 0 { 30 } else { 20 };
        for _ in 0..leaves {
            let near = limb.foot + limb.way * random.range(0.2, 1.1);
            let stalk = near + DVec3::from_array(random.direction()) * random.range(0.0, 0.32);
            leaf(m, random, stalk, limb.way, 0.2);
        }
    }
    if forks == 0 {
        return;
    }
    let length = limb.way.length();
    for _ in 0..3 {
        let aside = DVec3::from_array(random.direction());
        let way =
            (limb.way / length + aside * 0.75).normalize() * (length * random.range(0.65, 0.8));
        // No limb grows into the ground.
        let way = at(way.x, way.y.max(0.15 * length), way.z);
        let start = limb.foot + limb.way * random.range(0.85, 1.0);
        let child = Limb { foot: start, way, radius: limb.radius * 0.6 };
        branch(m, random, &child, forks - 1);
    }
}

/// A leaf on a stalk's end: two triangles folded along the midrib.
fn leaf(m: &mut Model, random: &mut Random, stalk: DVec3, along: DVec3, size: f64) {
    let aside = DVec3::from_array(random.direction());
    let way = (along.normalize() * 0.5 + aside).normalize();
    let length = size * random.range(0.8, 1.2);
    let width = length * random.range(0.28, 0.4);
    m.within(point_along(stalk, way), |m| {
        let (foot, tip) = (at(0.0, 0.02, 0.0), at(0.0, length, 0.0));
        for side in [-1.0, 1.0] {
            m.triangle([foot, tip, at(side * width, length * 0.45, width * 0.3)]);
        }
    });
}

/// Stems from one root, leaves all over.
fn bush(m: &mut Model, random: &mut Random) {
    let size = random.range(0.5, 1.1);
    for _ in 0..12 {
        let mut way = DVec3::from_array(random.direction());
        way.y = libm::fabs(way.y) + 0.4;
        let way = way.normalize() * size;
        m.tube(&[DVec3::ZERO, way], |j| [0.015, 0.006][j], 3);
        for _ in 0..14 {
            let share = random.range(0.3, 1.05);
            leaf(m, random, way * share, way, 0.12);
        }
    }
}

/// A stem, two leaves and a ring of petals.
fn flower(m: &mut Model, random: &mut Random) {
    let top = at(random.range(-0.1, 0.1), random.range(0.35, 0.8), random.range(-0.1, 0.1));
    m.tube(&[DVec3::ZERO, top], |_| 0.012, 3);
    for share in [0.3, 0.5] {
        leaf(m, random, top * share, DVec3::Y, 0.18);
    }
    m.within(point_along(top, at(random.range(-0.5, 0.5), 1.0, random.range(-0.5, 0.5))), |m| {
        for i in 0..8 {
            m.within(stand(DVec3::ZERO, f64::from(i) / 8.0), |m| {
                let tip = at(0.13, 0.03, 0.0);
                m.triangle([DVec3::ZERO, at(0.08, 0.03, 0.035), tip]);
                m.triangle([DVec3::ZERO, tip, at(0.08, 0.03, -0.035)]);
            });
        }
    });
}

/// A blade of grass.
fn blade(m: &mut Model, random: &mut Random, foot: DVec3) {
    let bend = at(random.range(-0.1, 0.1), random.range(0.08, 0.3), random.range(-0.1, 0.1));
    let side = at(random.range(-0.02, 0.02), 0.0, random.range(-0.02, 0.02));
    m.triangle([foot - side, foot + side, foot + bend]);
}
