//! The nearest point: every structure against brute force, bit for bit, and brute force
//! against exact arithmetic that shares nothing with the library.
#![allow(missing_docs)]

mod common;

use common::{build, configurations, soups};
use hug::{Geometry, NONE, Nearest, Options, Probe, Scene};
use hug_kit::{Mesh, arbiter, random::Random};

fn bits(near: &Nearest) -> [u32; 10] {
    bytemuck::cast(*near)
}

/// Around, in and on a mesh: anywhere, near corners, edges and centres of triangles, at
/// corners, far away; with all kinds of radius.
fn probes(mesh: &Mesh, seed: u64, n: usize) -> Vec<Probe> {
    let mut random = Random::stream(seed);
    let unit = hug_kit::Bounds { lo: [0.0; 3], hi: [1.0; 3] };
    let bounds = mesh.bounds().unwrap_or(unit);
    let side = (0..3).map(|k| bounds.hi[k] - bounds.lo[k]).fold(0.0, f32::max);
    let triangles: Vec<_> = mesh.triangles().collect();
    let mut probes = Vec::new();
    for i in 0..n {
        let mut any = |size: f32| [0; 3].map(|_: i32| size * (random.unit() as f32 - 0.5));
        let inside = |share: [f32; 3]| {
            [0, 1, 2].map(|k| bounds.lo[k] + (share[k] + 0.5) * (bounds.hi[k] - bounds.lo[k]))
        };
        let mut org = inside(any(if i % 3 == 0 { 3.0 } else { 1.0 }));
        if !triangles.is_empty() && i % 2 == 0 {
            let [a, b, c] = triangles[(i * 7919) % triangles.len()];
            org = match i % 5 {
                0 => a,
                1 => [0, 1, 2].map(|k| 0.5 * (a[k] + b[k])),
                2 => [0, 1, 2].map(|k| (a[k] + b[k] + c[k]) / 3.0),
                // Beyond a corner, in the plane or along an edge.
                3 => [0, 1, 2].map(|k| a[k] + (a[k] - b[k])),
                _ => [0, 1, 2].map(|k| a[k] + (b[k] - c[k])),
            };
            let off = any(0.01 * side);
            if i % 4 == 0 {
                org = [0, 1, 2].map(|k| org[k] + off[k]);
            }
        }
        let radius = match i % 6 {
            0 => f32::INFINITY,
            1 => side,
            2 => 0.1 * side,
            3 => 0.01 * side,
            4 => 1e30 * side,
            _ => 0.0,
        };
        probes.push(Probe::new(org, radius));
        if i % 11 == 0 {
            let far = org.map(|x| if i % 2 == 0 { x * 1e6 } else { x + 1e3 * side });
            probes.push(Probe::new(far, f32::INFINITY));
        }
    }
    probes.retain(|probe| probe.org.iter().all(|x| x.is_finite()));
    probes
}

#[test]
fn structures_agree_with_brute_force() {
    for (soup, mesh) in soups() {
        let probes = probes(&mesh, 3, 150);
        let scene = build(&mesh, &Options::default());
        let expected: Vec<_> =
            probes.iter().map(|probe| scene.view().closest_point_brute(probe)).collect();
        for (name, options) in configurations() {
            for exit_boxes in [true, false] {
                let scene = build(&mesh, &Options { exit_boxes, ..options });
                for (probe, expected) in probes.iter().zip(&expected) {
                    let found = scene.view().closest_point(probe);
                    assert!(
                        bits(&found) == bits(expected),
                        "{soup} in {name}: {probe:?}\n{found:?}\n{expected:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn brute_force_agrees_with_exact_arithmetic() {
    for (soup, mesh) in soups() {
        let scene = build(&mesh, &Options::default());
        let mut found_some = 0;
        for probe in probes(&mesh, 5, 40) {
            let triangles = (0..).zip(mesh.triangles()).map(|(prim, corners)| (0, prim, corners));
            let exact = arbiter::nearest(probe.org, probe.radius, triangles);
            let found = scene.view().closest_point_brute(&probe);
            let expected = exact.map_or(Nearest::nothing(probe.radius), |e| {
                found_some += 1;
                let arbiter::Nearest { geom, prim, distance, u, v, point } = e;
                Nearest { distance, u, v, point, geom, prim, ..Nearest::nothing(0.0) }
            });
            assert!(
                bits(&found) == bits(&expected),
                "{soup}: {probe:?}\nfound {found:?}\nexact {expected:?}"
            );
        }
        assert!(found_some > 0 || mesh.indices.is_empty(), "{soup}: nothing was near");
    }
}

const SQUARE: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];

fn two() -> Scene {
    let halves = [[0, 1, 2], [0, 2, 3]];
    let soup = [
        Geometry::from_mesh(&SQUARE, &halves[..1]).with_mask(1),
        Geometry::from_mesh(&SQUARE, &halves).with_mask(2),
    ];
    Scene::build(&soup, &Options::default()).expect("the soup is valid")
}

#[track_caller]
fn finds(probe: &Probe, distance: f32, geom: u32, prim: u32) {
    let scene = two();
    let found = scene.view().closest_point(probe);
    assert_eq!((found.distance, found.geom, found.prim), (distance, geom, prim), "{probe:?}");
    assert_eq!(bits(&found), bits(&scene.view().closest_point_brute(probe)), "{probe:?}");
}

#[test]
fn ties_masks_and_skipped_triangles() {
    let probe = Probe::new([0.5, 0.5, 2.0], 3.0);
    finds(&probe, 2.0, 0, 0);
    finds(&Probe { mask: 2, ..probe }, 2.0, 1, 0);
    finds(&Probe { skip_geom: 0, skip_prim: 0, ..probe }, 2.0, 1, 0);
    finds(&Probe { mask: 2, skip_geom: 1, skip_prim: 0, ..probe }, 2.0, 1, 1);
    finds(&Probe { skip_geom: 0, ..probe }, 2.0, 0, 0);
    finds(&Probe { mask: 4, ..probe }, 3.0, NONE, NONE);
    // Bits that are reserved change nothing.
    finds(&Probe { flags: u32::MAX, ..probe }, 2.0, 0, 0);
    // The radius belongs to the ball.
    finds(&Probe { radius: 2.0, ..probe }, 2.0, 0, 0);
    let less = f32::from_bits(2.0f32.to_bits() - 1);
    finds(&Probe { radius: less, ..probe }, less, NONE, NONE);
}

#[test]
fn bad_probes_find_nothing() {
    let (scene, good) = (two(), Probe::new([0.5, 0.5, 0.0], 1.0));
    assert!(scene.view().closest_point(&good).is_found());
    let mut bad = vec![
        Probe { radius: -1.0, ..good },
        Probe { radius: f32::NEG_INFINITY, ..good },
        Probe { radius: f32::NAN, ..good },
    ];
    for (k, x) in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY].into_iter().enumerate() {
        let mut org = good.org;
        org[k] = x;
        bad.push(Probe { org, ..good });
    }
    for probe in &bad {
        let nothing = bits(&Nearest::nothing(probe.radius));
        assert_eq!(bits(&scene.view().closest_point(probe)), nothing, "{probe:?}");
        assert_eq!(bits(&scene.view().closest_point_brute(probe)), nothing, "{probe:?}");
    }
    let touching = scene.view().closest_point(&Probe { radius: -0.0, ..good });
    assert_eq!((touching.distance, touching.prim), (0.0, 0));
    // Farther than a float can say.
    let (far, near) = ([f32::MAX; 3], [f32::MAX, 0.0, 0.0]);
    assert!(!scene.view().closest_point(&Probe::new(far, f32::INFINITY)).is_found());
    assert_eq!(scene.view().closest_point(&Probe::new(near, f32::MAX)).distance, f32::MAX);
    let empty = Scene::build(&[], &Options::default()).expect("an empty scene");
    assert!(!empty.view().closest_point(&Probe::new([0.0; 3], f32::INFINITY)).is_found());
}

/// Deep hierarchies, and the long integers, in the stack that the documentation names.
#[test]
fn little_stack_suffices() {
    for (soup, mesh) in soups() {
        for (name, options) in configurations() {
            let (scene, probes) = (build(&mesh, &options), probes(&mesh, 9, 20));
            let search =
                move || probes.iter().filter(|p| scene.view().closest_point(p).is_found()).count();
            let small = std::thread::Builder::new().stack_size(96 << 10).spawn(search);
            let found = small.expect("a thread").join().expect("no panic");
            assert!(found > 0 || mesh.indices.is_empty(), "{soup} in {name}");
        }
    }
}
