//! Each stage of deciding a hit, on numbers made for it: `f64` estimates, narrow
//! integers, wide ones; quotients exactly between two floats and a hair beside;
//! range limits next to the rounded t. The arbiter of the kit says what is right.
#![allow(missing_docs)]

mod common;

use hug::{Counters, Geometry, Options, Ray, Scene};
use hug_kit::arbiter::{self, Triangle};
use hug_kit::random::Random;
use hug_kit::rays;

const INF: f32 = f32::INFINITY;

fn power(e: i32) -> f32 {
    assert!((-149..128).contains(&e));
    (f64::from(e)).exp2() as f32
}

/// One triangle, and what the arbiter says of it.
struct Target {
    scene: Scene,
    corners: Triangle,
}

impl Target {
    fn new(corners: Triangle) -> Self {
        let mesh = Geometry::from_mesh(&corners, &[[0, 1, 2]]);
        let scene = Scene::build(&[mesh], &Options::default()).expect("a valid soup");
        Self { scene, corners }
    }

    /// Compares one ray, by all queries; the t, u and v of the hit.
    fn shoot(&self, ray: &Ray) -> Option<[f32; 3]> {
        let exact = arbiter::hit(&bytemuck::cast::<Ray, rays::Ray>(*ray), &self.corners);
        let view = self.scene.view();
        let walked = view.intersect_counted(ray, &mut Counters::default());
        for found in [view.intersect_brute(ray), view.intersect(ray), walked] {
            let bits = found.is_hit().then(|| [found.t, found.u, found.v].map(f32::to_bits));
            let expected = exact.as_ref().map(|hit| [hit.t, hit.u, hit.v].map(f32::to_bits));
            let corners = &self.corners;
            assert_eq!(bits, expected, "{ray:?} at {corners:?}\n{found:?}, not {exact:?}");
        }
        assert_eq!(view.occluded(ray), exact.is_some(), "{ray:?} at {:?}", self.corners);
        exact.map(|hit| [hit.t, hit.u, hit.v])
    }

    /// Compares a ray, in any range and in those that end at its t.
    fn everywhere(&self, ray: &Ray) -> Option<[f32; 3]> {
        let all = ray.with_range(-INF, INF);
        let found = self.shoot(&all)?;
        let t = found[0];
        let (below, above) = (t.next_down(), t.next_up());
        let ranges = [(t, t), (-INF, below), (above, INF), (t, INF), (-INF, t), (below, above)];
        for (tmin, tmax) in ranges {
            if tmin <= tmax {
                self.shoot(&all.with_range(tmin, tmax));
            }
        }
        Some(found)
    }
}

/// A number of 25 bits, the last of them 1, exactly between two floats: as a
/// sum of two floats.
fn odd(random: &mut Random) -> (f32, f32) {
    let x = f64::from(random.bits() >> 7 | 1 << 24 | 1);
    let high = x as f32;
    (high, (x - f64::from(high)) as f32)
}

fn moved(x: f32, by: i32) -> f32 {
    [x.next_down(), x, x.next_up()][(by + 1) as usize]
}

/// Sideways by nothing, by what narrow integers hold, or by what only wide ones do.
const SLOPES: [i32; 5] = [-50, -61, -90, -120, -149];

/// Exponents of the unit of length.
const UNITS: [i32; 5] = [-100, -20, 0, 20, 90];

/// t exactly between two floats, and to either side of it by the last bit of a
/// coordinate.
#[test]
fn t_between_two_floats() {
    let mut random = Random::stream(8801);
    let (mut hits, mut to_even) = (0, 0);
    for i in 0..2000 {
        let unit = power(UNITS[i % 5]);
        let (high, low) = odd(&mut random);
        let nudge = i as i32 / 5 % 3 - 1;
        let (z, floor) = (high * unit, -moved(low, nudge) * unit);
        let leg = power(26) * unit;
        let target = Target::new([[0.0, 0.0, floor], [leg, 0.0, floor], [0.0, leg, floor]]);
        let length = [0, 3, -10, 25, -25][random.below(5)];
        let slope = power(SLOPES[random.below(5)]) * [0.0, 1.0, -1.0][random.below(3)];
        let ray = Ray::new([leg / 4.0, leg / 8.0, z], [slope, -slope, -power(length)]);
        let Some([t, ..]) = target.everywhere(&ray) else { continue };
        hits += 1;
        if nudge == 0 {
            let middle = (f64::from(high) + f64::from(low)) * f64::from(unit);
            assert_eq!(t, (middle / f64::from(power(length))) as f32, "{ray:?}");
            to_even += 1;
        }
    }
    assert!(hits > 1900 && to_even > 600, "{hits} hit, {to_even} exactly between");
}

/// The same of u and v.
#[test]
fn weights_between_two_floats() {
    let mut random = Random::stream(8802);
    let (mut hits, mut to_even) = (0, 0);
    for i in 0..2000 {
        let unit = power(UNITS[i % 5]);
        let ((x, dx), (y, dy)) = (odd(&mut random), odd(&mut random));
        let (nudge_x, nudge_y) = (i as i32 / 5 % 3 - 1, i as i32 / 15 % 3 - 1);
        let leg = power(27) * unit;
        // The line reaches the plane at t = 2^-length, and is then at (x + dx, y + dy).
        let length = [0, 3, -10, 20, -20][random.below(5)];
        let target = Target::new([[0.0; 3], [leg, 0.0, 0.0], [0.0, leg, 0.0]]);
        let scale = unit * power(length);
        let (dx, dy) = (moved(dx, nudge_x), moved(dy, nudge_y));
        let dir = [dx * scale, dy * scale, -power(5) * scale];
        let Some([_, u, v]) =
            target.everywhere(&Ray::new([x * unit, y * unit, power(5) * unit], dir))
        else {
            continue;
        };
        hits += 1;
        for (found, x, dx, nudge) in [(u, x, dx, nudge_x), (v, y, dy, nudge_y)] {
            if nudge == 0 {
                let middle = f64::from(x) + f64::from(dx);
                assert_eq!(found, (middle / f64::from(1 << 27)) as f32);
                to_even += 1;
            }
        }
    }
    assert!(hits > 1900 && to_even > 1200, "{hits} hit, {to_even} exactly between");
}

/// u and v that are denormal, or half the least, or the middle of two such.
#[test]
fn denormal_weights() {
    let leg = power(75);
    let target = Target::new([[0.0; 3], [leg, 0.0, 0.0], [0.0, leg, 0.0]]);
    for i in 0..40_i32 {
        for nudge in [0.0, power(-149), -power(-149), power(-120)] {
            let x = i as f32 * power(-75) + nudge;
            let y = (40 - i) as f32 * power(-76);
            for dir in [[0.0, 0.0, -1.0], [power(-149), -power(-149), -power(20)]] {
                target.everywhere(&Ray::new([x, y, 1.0], dir));
                target.everywhere(&Ray::new([y, x, 3.0], dir));
            }
        }
    }
}

/// A t that is denormal, the middle of two such, or vanishes.
#[test]
fn denormal_t() {
    let target = Target::new([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    for i in -9..40_i32 {
        for length in [power(75), power(76), -power(77), power(80)] {
            for nudge in [0.0, power(-98), -power(-140)] {
                let z = i as f32 * power(-75) + nudge;
                for dir in [[0.0, 0.0, -length], [1.0, 0.1, -length]] {
                    assert!(target.everywhere(&Ray::new([0.3, 0.2, z], dir)).is_some());
                }
            }
        }
    }
}

/// Around the middle between the largest float and what would follow it.
#[test]
fn largest_t() {
    let mut hits = 0;
    for low in [0.0, power(-1), power(-2), power(-1).next_up(), power(-1).next_down()] {
        // 2^24 - 1 + low is the middle for low = 1/2.
        let target = Target::new([[0.0, 0.0, -low], [8.0, 0.0, -low], [0.0, 8.0, -low]]);
        let z = (1 << 24) as f32 - 1.0;
        for side in [0.0, power(-120), -power(-149)] {
            for sign in [1.0, -1.0] {
                let dir = [side, -side, -sign * power(-104)];
                hits += i32::from(target.everywhere(&Ray::new([1.0, 2.0, z], dir)).is_some());
            }
        }
    }
    assert!((12..30).contains(&hits), "{hits} hit: the middle itself is too large");
}

/// Through the corners and along edges, exactly and a hair beside, in spans of
/// exponents for each kind of integers.
#[test]
fn edges_in_every_span() {
    let mut random = Random::stream(8803);
    let (mut hits, mut misses) = (0, 0);
    for span in [4, 20, 36, 38, 39, 40, 44, 70, 120] {
        for _ in 0..150 {
            // Few bits, so that what is aimed at is met.
            let exponent = |random: &mut Random| -(random.below(span) as i32) / 2 + 20;
            let coarse = |random: &mut Random| {
                let size =
                    f64::from(1 + random.below(15) as i32) * f64::from(exponent(random)).exp2();
                (if random.chance(0.5) { -size } else { size }) as f32
            };
            let point = |random: &mut Random| [0; 3].map(|_| coarse(random));
            let corners = [point(&mut random), point(&mut random), point(&mut random)];
            let target = Target::new(corners);
            let org = point(&mut random);
            let share = [0.0, 0.25, 0.5, 1.0][random.below(4)];
            let (a, b) = (corners[random.below(3)], corners[random.below(3)]);
            let aim = |k: usize| (1.0 - share) * a[k] + share * b[k] - org[k];
            let mut dir = [aim(0), aim(1), aim(2)];
            let k = random.below(3);
            dir[k] = match random.below(6) {
                0 => dir[k].next_up(),
                1 => dir[k].next_down(),
                2 => dir[k] + power(-40),
                3 if dir[k] == 0.0 => power(-140),
                _ => dir[k],
            };
            let hit = target.everywhere(&Ray::new(org, dir)).is_some();
            hits += i32::from(hit);
            misses += i32::from(!hit);
        }
    }
    assert!(hits > 200 && misses > 200, "{hits} hits, {misses} misses");
}

/// Coordinates and components of any exponents: at a point inside, as nearly as
/// floats can say.
#[test]
fn any_exponents() {
    let mut random = Random::stream(8804);
    let mut hits = 0;
    for i in 0..6000 {
        let window = [2.0, 10.0, 37.0, 39.0, 60.0, 200.0][i % 6];
        let middle = [0.0, -60.0, 60.0][i / 6 % 3] * f64::from(u8::from(window < 100.0));
        let number = |random: &mut Random| {
            let e = middle + window * (random.unit() - 0.5);
            let size = e.exp2() * random.range(1.0, 2.0);
            (if random.chance(0.5) { -size } else { size }) as f32
        };
        let point = |random: &mut Random| [0; 3].map(|_| number(random));
        let corners = [point(&mut random), point(&mut random), point(&mut random)];
        let org = point(&mut random);
        let (u, v) = (random.range(0.0, 0.5), random.range(0.0, 0.5));
        let length = random.range(-20.0, 20.0).exp2();
        let dir = [0, 1, 2].map(|k| {
            let [a, b, c] = corners.map(|corner| f64::from(corner[k]));
            ((a + u * (b - a) + v * (c - a) - f64::from(org[k])) * length) as f32
        });
        hits += i32::from(Target::new(corners).everywhere(&Ray::new(org, dir)).is_some());
    }
    assert!(hits > 4000, "only {hits} hit");
}

/// Rays that start on a triangle's plane, or in it altogether.
#[test]
fn in_the_plane() {
    let mut random = Random::stream(8805);
    let mut hits = 0;
    for i in 0..600 {
        let coarse = |random: &mut Random| random.below(17) as f32 - 8.0;
        let point = |random: &mut Random| [0; 3].map(|_| coarse(random));
        let corners = [point(&mut random), point(&mut random), point(&mut random)];
        let [a, b, c] = corners;
        let (u, v) = (random.below(9) as f32 / 8.0, random.below(9) as f32 / 8.0);
        let within = |u: f32, v: f32| [0, 1, 2].map(|k| (1.0 - u - v) * a[k] + u * b[k] + v * c[k]);
        let org = within(u, v);
        let dir = if i % 3 == 0 {
            let other = within(v, -u);
            [0, 1, 2].map(|k| other[k] - org[k])
        } else {
            point(&mut random)
        };
        hits += i32::from(Target::new(corners).everywhere(&Ray::new(org, dir)).is_some());
    }
    assert!(hits > 150, "only {hits} hit");
}
