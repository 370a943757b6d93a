//! The defined edges of a ray, one by one, in every structure and by every kind
//! of query: what misses, what is inclusive, what makes no difference.
#![allow(missing_docs)]

mod common;

use common::everywhere::Everywhere;
use hug::{Geometry, Ray};
use hug_kit::random::Random;
use hug_kit::{Mesh, soups};

const INF: f32 = f32::INFINITY;
const SMALLEST: f32 = f32::from_bits(1);

/// A floor at z = 0 and a ceiling at z = 2, of 128 triangles each: integer
/// corners, enough of them for several voxels and clusters.
fn room() -> Everywhere {
    let mut mesh = Mesh::default();
    for z in [0.0, 2.0] {
        for cell in 0..64 {
            let (x, y) = ((cell % 8 - 4) as f32, (cell / 8 - 4) as f32);
            mesh.push([[x, y, z], [x + 1.0, y, z], [x, y + 1.0, z]]);
            mesh.push([[x + 1.0, y + 1.0, z], [x, y + 1.0, z], [x + 1.0, y, z]]);
        }
    }
    Everywhere::build(&[Geometry::from_mesh(&mesh.vertices, &mesh.indices)])
}

/// From above the ceiling straight down, inside one triangle of each: it meets
/// the ceiling at t = 1 and the floor at t = 3.
fn down() -> Ray {
    Ray::new([0.25, 0.5, 3.0], [0.0, 0.0, -1.0])
}

/// All rays with one float replaced: origin, tmin, direction or tmax.
fn with_each_float(value: f32, fields: &[usize]) -> Vec<Ray> {
    let replaced = |&i: &usize| {
        let mut words: [f32; 12] = bytemuck::cast(down());
        words[i] = value;
        bytemuck::cast(words)
    };
    fields.iter().map(replaced).collect()
}

/// Places of the fields of a ray, in floats.
const ORG: [usize; 3] = [0, 1, 2];
const TMIN: usize = 3;
const DIR: [usize; 3] = [4, 5, 6];
const TMAX: usize = 7;

#[test]
fn nan_anywhere_misses() {
    let room = room();
    let fields: Vec<usize> = ORG.into_iter().chain([TMIN]).chain(DIR).chain([TMAX]).collect();
    for nan in [f32::NAN, -f32::NAN, f32::from_bits(0x7f80_0001), f32::from_bits(0xffff_ffff)] {
        for ray in with_each_float(nan, &fields) {
            let hit = room.shoot(&ray);
            assert!(!hit.is_hit(), "{ray:?} hit {hit:?}");
            assert_eq!(hit.t.is_nan(), ray.tmax.is_nan(), "{ray:?}: t is the ray's tmax");
        }
    }
}

#[test]
fn infinite_origin_or_direction_misses() {
    let room = room();
    for infinity in [INF, -INF] {
        for field in ORG.into_iter().chain(DIR) {
            room.miss(&with_each_float(infinity, &[field])[0]);
        }
    }
}

#[test]
fn zero_direction_misses() {
    let room = room();
    for signs in 0..8 {
        let dir = [0, 1, 2].map(|k| if signs >> k & 1 == 0 { 0.0 } else { -0.0 });
        room.miss(&Ray { dir, ..down() });
        // Also from a point of the surface, where t would be undefined.
        room.miss(&Ray { dir, ..Ray::new([0.25, 0.5, 2.0], dir) });
    }
}

#[test]
fn empty_range_misses() {
    let room = room();
    for (tmin, tmax) in [(3.0, 1.0), (1.0_f32.next_up(), 1.0), (INF, -INF), (0.0, -SMALLEST)] {
        room.miss(&down().with_range(tmin, tmax));
    }
}

#[test]
fn range_of_one_value_is_inclusive() {
    let room = room();
    for t in [1.0_f32, 3.0] {
        room.hit_at(&down().with_range(t, t), t);
        room.miss(&down().with_range(t.next_down(), t.next_down()));
        room.miss(&down().with_range(t.next_up(), t.next_up()));
    }
}

#[test]
fn exact_bounds_are_inclusive() {
    let room = room();
    room.hit_at(&down().with_range(1.0, INF), 1.0);
    room.hit_at(&down().with_range(1.0_f32.next_up(), INF), 3.0);
    room.hit_at(&down().with_range(1.0_f32.next_up(), 3.0), 3.0);
    room.miss(&down().with_range(1.0_f32.next_up(), 3.0_f32.next_down()));
    room.hit_at(&down().with_range(0.0, 1.0), 1.0);
    room.miss(&down().with_range(0.0, 1.0_f32.next_down()));
}

/// Where t is no float, the rounded t is what the range is compared with.
#[test]
fn rounded_bounds_are_inclusive() {
    let room = room();
    for i in 1..200 {
        let x = i as f32 / 100.0 - 1.0;
        let ray = Ray::new([0.25, 0.5, 3.0], [x / 3.0, 0.1, -0.7]);
        let t = room.shoot(&ray).t;
        room.hit_at(&ray.with_range(t, t), t);
        room.miss(&ray.with_range(0.0, t.next_down()));
        assert!(room.shoot(&ray.with_range(t.next_up(), INF)).t > t, "{ray:?}");
    }
}

/// So far that on the way from the origin to the scene no f64 tells one of its voxels from
/// the next, and with a direction whose one small component leads aside by a few of them.
/// The scene is a cube, which such rays cross along a diagonal of two axes.
#[test]
fn from_very_far_into_nested_grids() {
    let mesh = soups::tangle(1, 600);
    let scenes = Everywhere::build(&[Geometry::from_mesh(&mesh.vertices, &mesh.indices)]);
    let mut random = Random::stream(29);
    let mut hits = 0;
    for i in 0..120 {
        let far = 2f32.powi(20 + random.below(90) as i32);
        let corner = mesh.vertices[random.below(mesh.vertices.len())];
        let aside = (random.below(64) as f32 - 32.0) / 8.0;
        let (mut org, mut dir) = ([-far; 3], [far; 3]);
        (org[i % 3], dir[i % 3]) = (corner[i % 3] + aside, -aside);
        hits += usize::from(scenes.shoot(&Ray::new(org, dir)).is_hit());
    }
    assert!(hits > 30, "{hits} hits");
}

#[test]
fn infinite_range() {
    let room = room();
    room.hit_at(&down().with_range(-INF, INF), 1.0);
    room.hit_at(&down().with_range(0.0, INF), 1.0);
    room.hit_at(&down().with_range(-INF, 1.0), 1.0);
    room.miss(&down().with_range(-INF, 0.5));
    room.miss(&down().with_range(4.0, INF));
    room.miss(&down().with_range(INF, INF));
    room.miss(&down().with_range(-INF, -INF));
}

#[test]
fn negative_tmin_looks_behind() {
    let room = room();
    let up = Ray { dir: [0.0, 0.0, 1.0], ..down() };
    room.miss(&up);
    room.hit_at(&up.with_range(-3.0, INF), -3.0);
    room.hit_at(&up.with_range(-(3.0_f32.next_up()), -1.0), -3.0);
    room.hit_at(&up.with_range(-2.0, -0.5), -1.0);
    room.miss(&up.with_range(-0.5, INF));
}

#[test]
fn starting_on_the_surface_is_a_hit_at_zero() {
    let room = room();
    for (z, further) in [(2.0, Some(2.0)), (0.0, None)] {
        for dir in [[0.0, 0.0, -1.0], [0.3, 0.1, -1.0], [0.0, 0.0, 1.0]] {
            let on = Ray::new([0.25, 0.5, z], dir);
            room.hit_at(&on, 0.0);
            room.hit_at(&on.with_range(0.0, 0.0), 0.0);
            let past = on.with_range(SMALLEST, INF);
            let inside = further.is_some() && dir[2] < 0.0 || z == 0.0 && dir[2] > 0.0;
            if inside { room.hit_at(&past, 2.0) } else { room.miss(&past) }
        }
    }
}

/// A ray in the plane of a triangle has no one t: it misses.
#[test]
fn coplanar_rays_miss() {
    let room = room();
    for dir in [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-0.3, 0.7, -0.0]] {
        for org in [[0.25, 0.5, 0.0], [0.0, 0.0, 0.0], [-9.0, -9.0, 0.0], [0.5, 9.0, 2.0]] {
            room.miss(&Ray::new(org, dir));
            room.miss(&Ray::new(org, dir).with_range(-INF, INF));
        }
    }
}
