//! What the size and the sign of a ray's numbers do to a hit: as real arithmetic
//! says, nothing else.
#![allow(missing_docs)]

mod common;

use common::everywhere::Everywhere;
use common::{adversarial_rays, assert_same, ray};
use hug::{Geometry, Hit, Ray};
use hug_kit::{Mesh, soups};

const INF: f32 = f32::INFINITY;

fn everywhere(mesh: &Mesh) -> Everywhere {
    Everywhere::build(&[Geometry::from_mesh(&mesh.vertices, &mesh.indices)])
}

/// A right triangle of this size in the plane z = 0, and a smaller copy of it
/// around which the clusters and voxels differ.
fn corner(size: f32) -> Everywhere {
    let mut mesh = Mesh::default();
    for part in [1.0, 0.125] {
        mesh.push([[0.0; 3], [size * part, 0.0, 0.0], [0.0, size * part, 0.0]]);
    }
    everywhere(&mesh)
}

#[test]
fn signed_zeros_are_one_zero() {
    let soup = everywhere(&soups::lattice(4, 400, 8));
    let mut hits = 0;
    for axis in 0..3 {
        for cell in 0..8 {
            let mut org = [0.0; 3];
            org[(axis + 1) % 3] = cell as f32;
            let mut dir = [0.0; 3];
            dir[axis] = 1.0;
            let plain = Ray::new(org, dir).with_range(0.0, 8.0);
            let expected = soup.shoot(&plain);
            hits += u32::from(expected.is_hit());
            // Every zero among origin, tmin and direction, in every mix.
            for signs in 1..128 {
                let mut words: [f32; 12] = bytemuck::cast(plain);
                for (i, word) in words[..7].iter_mut().enumerate() {
                    if *word == 0.0 && signs >> i & 1 == 1 {
                        *word = -0.0;
                    }
                }
                let signed: Ray = bytemuck::cast(words);
                assert_same(&soup.shoot(&signed), &expected, &signed, &"with -0.0");
            }
        }
    }
    assert!(hits > 6, "only {hits} rays hit");
}

#[test]
fn tmax_of_negative_zero_includes_zero() {
    let soup = corner(1.0);
    let ray = Ray::new([0.25, 0.25, 0.0], [0.0, 0.0, -1.0]);
    for (tmin, tmax) in [(0.0, -0.0), (-0.0, 0.0), (-0.0, -0.0), (-1.0, -0.0)] {
        soup.hit_at(&ray.with_range(tmin, tmax), 0.0);
    }
}

/// A direction 2^k times as long divides t by 2^k and changes nothing else.
#[test]
fn t_is_in_units_of_the_direction() {
    let mesh = soups::tangle(1, 400);
    let soup = everywhere(&mesh);
    let mut hits = 0;
    for (_, r) in adversarial_rays(&mesh, 5, 12) {
        let plain = Ray { tmin: 0.0, tmax: INF, ..ray(&r) };
        let found = soup.shoot(&plain);
        // Clear of every bound of f32, so that only exponents change.
        let moderate = |x: f32| x == 0.0 || (1e-10..1e10).contains(&x.abs());
        if !found.is_hit() || !plain.dir.into_iter().chain([found.t]).all(moderate) {
            continue;
        }
        hits += 1;
        for k in [-60, -1, 1, 60] {
            let factor = 2.0_f32.powi(k);
            let longer = Ray { dir: plain.dir.map(|d| d * factor), ..plain };
            let expected = Hit { t: found.t / factor, ..found };
            assert_same(&soup.shoot(&longer), &expected, &longer, &format!("times 2^{k}"));
        }
    }
    assert!(hits > 20, "only {hits} rays hit");
}

#[test]
fn denormal_directions_are_directions() {
    let soup = corner(1.0);
    // 2^-140 / 2^-149
    let ray = Ray::new([0.25, 0.25, 2.0_f32.powi(-140)], [0.0, 0.0, -f32::from_bits(1)]);
    soup.hit_at(&ray, 512.0);
    // Sideways by too little to matter, or just enough to leave the triangle.
    let ray = Ray::new([0.25, 0.25, 1.0], [f32::from_bits(1), -f32::from_bits(7), -1.0]);
    soup.hit(&ray, 1.0, 0, 0);
    let edge = Ray::new([0.0, 0.25, 1.0], [0.0, 0.0, -1.0]);
    soup.hit(&edge, 1.0, 0, 0);
    soup.miss(&Ray { dir: [-f32::from_bits(1), 0.0, -1.0], ..edge });
    soup.hit(&Ray { dir: [f32::from_bits(1), 0.0, -1.0], ..edge }, 1.0, 0, 0);
}

#[test]
fn denormal_coordinates_are_coordinates() {
    let unit = f32::from_bits(1);
    let soup = corner(unit * 64.0);
    let ray = Ray::new([unit * 16.0, unit * 16.0, unit * 8.0], [0.0, 0.0, -unit]);
    soup.hit(&ray, 8.0, 0, 0);
    soup.hit_at(&Ray { dir: [0.0, 0.0, -1.0], ..ray }, unit * 8.0);
    soup.miss(&Ray { org: [unit * 33.0, unit * 32.0, unit], ..ray });
    soup.hit(&Ray { org: [unit * 32.0, unit * 32.0, unit], ..ray }, 1.0, 0, 0);
}

#[test]
fn t_beyond_f32_misses() {
    let soup = corner(1.0);
    let far = Ray::new([0.25, 0.25, 1e30], [0.0, 0.0, -1e-10]);
    soup.miss(&far);
    soup.miss(&far.with_range(-INF, INF));
    soup.miss(&Ray { dir: [0.0, 0.0, 1e-10], ..far }.with_range(-INF, INF));
    soup.miss(&far.with_range(f32::MAX, INF));
    // The largest t there is: 2^127 (2 - 2^-23).
    let edge = Ray::new([0.25, 0.25, f32::MAX], [0.0, 0.0, -1.0]);
    soup.hit_at(&edge, f32::MAX);
    // Half as long a direction doubles t.
    soup.miss(&Ray { dir: [0.0, 0.0, -0.5], ..edge });
}

#[test]
fn t_below_f32_is_zero() {
    let soup = corner(1.0);
    let near = Ray::new([0.25, 0.25, 1e-30], [0.0, 0.0, -1e30]);
    soup.hit_at(&near, 0.0);
    soup.hit_at(&near.with_range(0.0, 0.0), 0.0);
    soup.miss(&near.with_range(f32::from_bits(1), INF));
    // From below the plane t is negative, but rounds to the same zero.
    soup.hit_at(&Ray { org: [0.25, 0.25, -1e-30], ..near }, 0.0);
}
