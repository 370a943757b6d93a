//! Queries that tell what they did on each level: the same hits, and numbers that add up.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, assert_same, build, configurations, ray};
use hug::{Calls, Counters, Hit, Options, Profile, Ray, Stats, Structure};
use hug_kit::{scenes, soups};

fn counters(calls: &Calls) -> Counters {
    let Calls { grids, voxels, tests, hits, .. } = *calls;
    Counters { grids, voxels, tests, hits }
}

#[test]
fn the_same_hits_and_the_same_sums() {
    for mesh in [soups::clustered(900), soups::tangle(1, 300), soups::lattice(4, 300, 8)] {
        let rays = adversarial_rays(&mesh, 3, 40);
        for (name, options) in configurations() {
            let scene = build(&mesh, &options);
            let view = scene.view();
            let (mut profile, mut counted) = (Profile::default(), Counters::default());
            for (_, r) in &rays {
                let r = ray(r);
                let plain = view.intersect(&r);
                assert_same(&view.intersect_profiled(&r, &mut profile), &plain, &r, &name);
                view.intersect_counted(&r, &mut counted);
                assert_eq!(view.occluded_profiled(&r, &mut profile), plain.is_hit(), "{name}");
                view.occluded_counted(&r, &mut counted);
            }
            assert_eq!(counters(&profile.total()), counted, "{name}");
            let levels = Stats::of(&view).levels().len();
            assert!(profile.levels()[levels..].iter().all(|l| *l == Calls::default()), "{name}");
            for level in profile.levels() {
                assert!(level.passed_1 <= level.tests && level.passed_2 <= level.passed_1);
                assert!(level.hits <= level.tests, "{name}: {level:?}");
            }
            let mut twice = profile;
            twice.add(&profile);
            assert_eq!(twice.total().tests, 2 * counted.tests, "{name}");
        }
    }
}

/// A ray along x through one row of a grid of plain steps, and what it must count there.
#[test]
fn levels_are_where_things_happen() {
    let mesh = scenes::kitchen().mesh;
    let rays = adversarial_rays(&mesh, 7, 200);
    for structure in [Structure::Uniform, Structure::Recursive, Structure::Hug] {
        let options = Options { structure, exit_boxes: false, ..Options::default() };
        let scene = build(&mesh, &options);
        let (view, mut profile) = (scene.view(), Profile::default());
        let mut entered = 0;
        for (_, r) in &rays {
            let before = profile;
            view.intersect_profiled(&ray(r), &mut profile);
            entered += u64::from(profile != before);
        }
        let stats = Stats::of(&view);
        let top = stats.levels().len() - 1;
        // The outermost grid is the only one of its level, and each ray comes to it once.
        assert_eq!(profile.levels()[top].grids, entered, "{structure:?}");
        for (level, calls) in stats.levels().iter().zip(profile.levels()) {
            let some = calls.tests + calls.voxels + calls.grids > 0;
            assert!(level.grids > 0 || !some, "{structure:?}");
            assert!(level.object_refs > 0 || calls.tests == 0, "{structure:?}");
        }
        let deep = profile.levels()[..top].iter().map(|l| l.voxels).sum::<u64>();
        assert_eq!(deep > 0, structure != Structure::Uniform, "{structure:?}");
    }
}

/// The early tests of the paper's routine, in scenes of one triangle.
#[test]
fn early_tests_on_one_triangle() {
    let mut mesh = hug_kit::Mesh::default();
    mesh.push([[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]]);
    let options = Options { structure: Structure::Uniform, counts: [1; 3], ..Options::default() };
    let scene = build(&mesh, &options);
    let calls = |org, dir| {
        let mut profile = Profile::default();
        let hit: Hit = scene.view().intersect_profiled(&Ray::new(org, dir), &mut profile);
        let total = profile.total();
        (hit.is_hit(), [total.tests, total.passed_1, total.passed_2, total.hits])
    };
    assert_eq!(calls([1.0, 1.0, 1.0], [0.0, 0.0, -1.0]), (true, [1, 1, 1, 1]));
    // In the box but beyond the hypotenuse.
    assert_eq!(calls([3.0, 3.0, 1.0], [0.0, 0.0, -1.0]), (false, [1, 1, 1, 0]));
    // In the plane.
    assert_eq!(calls([-1.0, 1.0, 0.0], [1.0, 0.0, 0.0]), (false, [1, 0, 0, 0]));
    // Past the scene: nothing is tested.
    assert_eq!(calls([9.0, 9.0, 1.0], [0.0, 0.0, -1.0]), (false, [0; 4]));
}

#[test]
fn percentages() {
    let calls = Calls { tests: 200, hits: 10, passed_1: 160, passed_2: 40, ..Calls::default() };
    let all = [calls.percent_passed_1(), calls.percent_passed_2(), calls.percent_hits()];
    assert_eq!(all, [80.0, 25.0, 5.0]);
    let none = Calls::default();
    let all = [none.percent_passed_1(), none.percent_passed_2(), none.percent_hits()];
    assert_eq!(all, [0.0; 3]);
}
