//! Every structure against brute force, bit for bit, and brute force against
//! exact arithmetic that shares nothing with the library.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, assert_same, build, configurations, ray, soups};
use hug::Options;
use hug_kit::arbiter;

#[test]
fn structures_agree_with_brute_force() {
    for (soup, mesh) in soups() {
        let rays = adversarial_rays(&mesh, 7, 150);
        let brute = build(&mesh, &Options::default());
        let expected: Vec<_> =
            rays.iter().map(|(_, r)| brute.view().intersect_brute(&ray(r))).collect();
        for (name, options) in configurations() {
            let scene = build(&mesh, &options);
            for ((aim, r), expected) in rays.iter().zip(&expected) {
                let r = ray(r);
                let what = format!("{soup} in {name}, {aim:?}");
                assert_same(&scene.view().intersect(&r), expected, &r, &what);
                assert_eq!(scene.view().occluded(&r), expected.is_hit(), "{what}: {r:?}");
            }
        }
    }
}

#[test]
fn brute_force_agrees_with_exact_arithmetic() {
    for (soup, mesh) in soups() {
        let scene = build(&mesh, &Options::default());
        let mut hits = 0;
        for (aim, kit_ray) in adversarial_rays(&mesh, 11, 60) {
            let triangles = (0..).zip(mesh.triangles()).map(|(prim, tri)| (0, prim, tri));
            let exact = arbiter::closest(&kit_ray, triangles);
            let r = ray(&kit_ray);
            let found = scene.view().intersect_brute(&r);
            let what = format!("{soup}, {aim:?}: {r:?}\nexact {exact:?}\nfound {found:?}");
            assert_eq!(found.is_hit(), exact.is_some(), "{what}");
            if let Some(exact) = exact {
                hits += 1;
                assert_eq!((found.geom, found.prim), (exact.geom, exact.prim), "{what}");
                let bits = [found.t, found.u, found.v].map(f32::to_bits);
                assert_eq!(
                    bits,
                    [exact.hit.t, exact.hit.u, exact.hit.v].map(f32::to_bits),
                    "{what}"
                );
            }
        }
        assert!(hits > 0 || mesh.indices.is_empty(), "{soup}: no ray hit anything");
    }
}
