//! Queries with a budget: as many steps as are counted suffice, one fewer do not, and
//! no ray takes more than the scene says is the most.
#![allow(missing_docs)]

mod common;

use common::aligned::Aligned;
use common::layout::towers;
use common::{adversarial_rays, assert_same, build, configurations, ray, soups};
use hug::{Counters, Isa, Ray, Truncated, View, force_isa};
use hug_kit::soups as kit;

fn steps(c: &Counters) -> u64 {
    c.grids + c.voxels + c.tests
}

/// Steps that a ray takes, having made sure that the budget agrees.
#[track_caller]
fn count(view: &View<'_>, ray: &Ray, what: &str) -> u64 {
    let (mut closest, mut any) = (Counters::default(), Counters::default());
    let hit = view.intersect_counted(ray, &mut closest);
    let occluded = view.occluded_counted(ray, &mut any);
    let (closest, any) = (steps(&closest), steps(&any));
    let within = view.intersect_within(ray, closest).expect("enough steps");
    assert_same(&within, &hit, ray, &what);
    assert_eq!(view.occluded_within(ray, any), Ok(occluded), "{what}: {ray:?}");
    for fewer in [0, closest / 2, closest.saturating_sub(1)] {
        let short = view.intersect_within(ray, fewer).err();
        assert_eq!(short, (fewer < closest).then_some(Truncated), "{what}: {ray:?}");
    }
    if any > 0 {
        assert_eq!(view.occluded_within(ray, any - 1), Err(Truncated), "{what}: {ray:?}");
    }
    closest.max(any)
}

#[test]
fn as_many_as_are_counted() {
    for (name, mesh) in soups() {
        let rays: Vec<Ray> = adversarial_rays(&mesh, 11, 12).iter().map(|(_, r)| ray(r)).collect();
        for (kind, options) in configurations() {
            let what = format!("{name} in {kind}");
            let scene = build(&mesh, &options);
            let most = scene.view().most_steps();
            for r in &rays {
                let taken = count(&scene.view(), r, &what);
                assert!(taken <= most, "{what}: {taken} steps, {most} should suffice: {r:?}");
            }
        }
    }
}

/// A truncated ray is so everywhere.
#[test]
fn on_every_instruction_set() {
    let mesh = kit::clustered(900);
    let rays: Vec<Ray> = adversarial_rays(&mesh, 12, 12).iter().map(|(_, r)| ray(r)).collect();
    for (kind, options) in configurations() {
        let scene = build(&mesh, &options);
        let view = scene.view();
        let trace = |budget| -> Vec<_> {
            rays.iter().map(|r| view.intersect_within(r, budget).map(|hit| hit.prim)).collect()
        };
        for budget in [3, 10, 40] {
            let mut expected = None;
            for isa in Isa::ALL.into_iter().filter(|&isa| force_isa(isa)) {
                let found = trace(budget);
                let expected = expected.get_or_insert_with(|| found.clone());
                assert!(found == *expected, "{kind}: {budget} steps on {isa:?}");
            }
        }
    }
}

/// The bound of a uniform grid can be told by hand.
#[test]
fn one_voxel_and_an_empty_scene() {
    let nothing = build(&kit::empty(), &configurations()[0].1);
    assert_eq!(nothing.view().most_steps(), 0);
    assert!(nothing.view().intersect_within(&Ray::new([0.0; 3], [1.0; 3]), 0).is_ok());
    let options = hug::Options {
        structure: hug::Structure::Uniform,
        counts: [1; 3],
        ..configurations()[0].1
    };
    let one = build(&kit::single(), &options);
    // The grid, its voxel, the triangle.
    assert_eq!(one.view().most_steps(), 3);
}

/// Of arenas made to be hostile too: enter all grids of all levels below, each time.
#[test]
fn of_towers_too() {
    let rays = [Ray::new([0.0; 3], [1.0; 3]), Ray::new([-5.0; 3], [1.0; 3])];
    for (levels, width) in [(2, 1), (2, 64), (3, 3), (4, 2)] {
        let bytes: Aligned = towers(levels, width);
        let Ok(view) = View::open(&bytes) else { continue };
        for r in &rays {
            let taken = count(&view, r, &format!("{levels} levels of {width}"));
            assert!(taken <= view.most_steps());
        }
    }
}
