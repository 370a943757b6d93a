//! Hits do not depend on the instruction set, nor do the bytes of a build, nor, as
//! `Counters` and `Profile` promise, what a walk counts.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, build, configurations, ray, soups};
use hug::{Counters, Hit, Isa, Profile, Ray, Scene, force_isa, isa};

fn trace(scene: &Scene, rays: &[Ray]) -> Vec<([u32; 10], bool, Counters, Profile)> {
    let view = scene.view();
    let one = |r| {
        let mut counters = Counters::default();
        let hit = view.intersect_counted(r, &mut counters);
        let hit: [u32; 10] = bytemuck::cast(hit);
        let plain: [u32; 10] = bytemuck::cast::<Hit, _>(view.intersect(r));
        assert_eq!(plain, hit, "counted on {:?}: {r:?}", isa());
        let mut profile = Profile::default();
        let profiled: [u32; 10] = bytemuck::cast(view.intersect_profiled(r, &mut profile));
        assert_eq!(profiled, hit, "profiled on {:?}: {r:?}", isa());
        (hit, view.occluded(r), counters, profile)
    };
    rays.iter().map(one).collect()
}

/// The one test of this program: the choice is the whole process's.
#[test]
fn every_instruction_set_gives_the_same() {
    let best = isa();
    assert!(force_isa(Isa::Portable), "portable code runs everywhere");
    let sets: Vec<Isa> = Isa::ALL.into_iter().filter(|&i| force_isa(i)).collect();
    assert!(sets.contains(&best), "{best:?} was chosen, of {sets:?}");
    let mut counted_otherwise = Vec::new();
    for (name, mesh) in soups() {
        let rays: Vec<Ray> = adversarial_rays(&mesh, 9, 100).iter().map(|(_, r)| ray(r)).collect();
        for (kind, options) in configurations() {
            force_isa(Isa::Portable);
            let scene = build(&mesh, &options);
            let expected = trace(&scene, &rays);
            for &set in &sets {
                assert!(force_isa(set) && isa() == set, "{set:?}");
                let built = build(&mesh, &options);
                assert!(built.view().bytes() == scene.view().bytes(), "{name}, {kind}, {set:?}");
                for ((found, expected), r) in trace(&scene, &rays).iter().zip(&expected).zip(&rays)
                {
                    let what = format!("{name} in {kind}, {set:?}: {r:?}");
                    assert_eq!((found.0, found.1), (expected.0, expected.1), "{what}");
                    if (found.2, found.3) != (expected.2, expected.3) {
                        counted_otherwise.push((what, found.2, expected.2));
                    }
                }
            }
        }
    }
    let first = counted_otherwise.first();
    assert!(first.is_none(), "{} walks count otherwise: {first:#?}", counted_otherwise.len());
}
