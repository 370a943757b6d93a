//! Streams: the hits of single rays, bit for bit, on every instruction set, for any
//! number of rays, and counts that are the sum of those of single rays.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, build, configurations, ray, soups};
use hug::{Counters, Hit, Isa, Profile, Ray, Scene, force_isa};

fn bits(hits: &[Hit]) -> &[[u32; 10]] {
    bytemuck::cast_slice(hits)
}

/// Streams of `rays` against single rays.
fn compare(what: &str, scene: &Scene, rays: &[Ray]) {
    let view = scene.view();
    let single: Vec<Hit> = rays.iter().map(|r| view.intersect(r)).collect();
    let shadows: Vec<bool> = rays.iter().map(|r| view.occluded(r)).collect();
    let mut hits = vec![Hit::miss(7.0); rays.len()];
    view.intersect_n(rays, &mut hits);
    if let Some(i) = bits(&hits).iter().zip(bits(&single)).position(|(a, b)| a != b) {
        panic!("{what}: ray {i}, {:?}: {:?} for {:?}", rays[i], hits[i], single[i]);
    }
    let mut occluded = vec![false; rays.len()];
    view.occluded_n(rays, &mut occluded);
    assert_eq!(occluded, shadows, "{what}");

    let (mut each, mut all) = (Counters::default(), Counters::default());
    for r in rays {
        view.intersect_counted(r, &mut each);
    }
    hits.fill(Hit::miss(7.0));
    view.intersect_n_counted(rays, &mut hits, &mut all);
    assert_eq!(bits(&hits), bits(&single), "{what}, counted");
    assert_eq!(all, each, "{what}");
    for r in rays {
        view.occluded_counted(r, &mut each);
    }
    view.occluded_n_counted(rays, &mut occluded, &mut all);
    assert_eq!((&occluded, all), (&shadows, each), "{what}, counted");

    let (mut each, mut all) = (Profile::default(), Profile::default());
    for r in rays {
        view.intersect_profiled(r, &mut each);
    }
    hits.fill(Hit::miss(7.0));
    view.intersect_n_profiled(rays, &mut hits, &mut all);
    assert_eq!(bits(&hits), bits(&single), "{what}, profiled");
    assert_eq!(all.levels(), each.levels(), "{what}");
    for r in rays {
        view.occluded_profiled(r, &mut each);
    }
    occluded.fill(false);
    view.occluded_n_profiled(rays, &mut occluded, &mut all);
    assert_eq!((occluded, all.levels()), (shadows, each.levels()), "{what}, profiled");
}

/// The one test that forces instruction sets, which are the whole process's.
#[test]
fn streams_are_single_rays() {
    let sets: Vec<Isa> = Isa::ALL.into_iter().filter(|&i| force_isa(i)).collect();
    for (name, mesh) in soups() {
        let mut rays: Vec<Ray> =
            adversarial_rays(&mesh, 31, 120).iter().map(|(_, r)| ray(r)).collect();
        // Rays that cannot hit anything, here and there.
        for (i, bad) in [f32::NAN, f32::INFINITY, 0.0].into_iter().enumerate() {
            rays.insert(i * i * 7 % rays.len(), Ray::new([0.0; 3], [bad, 0.0, 0.0]));
        }
        for (kind, options) in configurations() {
            let scene = build(&mesh, &options);
            for &set in &sets {
                assert!(force_isa(set), "{set:?}");
                compare(&format!("{name} in {kind}, {set:?}"), &scene, &rays);
            }
        }
    }
}

#[test]
fn any_number_of_rays() {
    let (_, mesh) = soups().pop().expect("there are soups");
    let scene = build(&mesh, &configurations()[0].1);
    let rays: Vec<Ray> = adversarial_rays(&mesh, 32, 40).iter().map(|(_, r)| ray(r)).collect();
    // From 256 on they may go together, 512 at a time and 4,096 parted in one go.
    let rays: Vec<Ray> = rays.iter().cycle().take(5000).copied().collect();
    for n in (0..70).chain([127, 128, 129, 255, 256, 257, 1023, 4095, 4097, rays.len()]) {
        compare(&format!("{n} rays"), &scene, &rays[..n.min(rays.len())]);
    }
    // Only as many as there is room for.
    let mut few = [Hit::miss(7.0); 9];
    scene.view().intersect_n(&rays, &mut few[..8]);
    assert_eq!(few[8], Hit::miss(7.0));
    let mut flags = [true; 12];
    scene.view().occluded_n(&rays[..11], &mut flags);
    assert!(flags[11]);
}
