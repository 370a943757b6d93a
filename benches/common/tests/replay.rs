//! Calls that are made again are those of the walk: as many, and with the same outcome.
#![allow(missing_docs)]

use hug::replay::{Function, Tape};
use hug::{Counters, Isa, Options, Ray, Scene, Structure, force_isa};
use hug_bench::costs::{Rays, Tests, measure};
use hug_kit::{Mesh, View, rays, scenes, soups};

fn build(mesh: &Mesh, options: &Options) -> Scene {
    let soup = [hug::Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
    Scene::build(&soup, options).expect("it builds")
}

fn picture(mesh: &Mesh, size: u32) -> Vec<Ray> {
    let view = View::derived(&mesh.bounds().expect("it has vertices"));
    rays::primary(&view, size).map(bytemuck::cast).collect()
}

fn structures() -> impl Iterator<Item = Options> {
    let all = [Structure::Uniform, Structure::Recursive, Structure::Hug];
    all.into_iter().flat_map(|structure| {
        [false, true].map(|exit_boxes| Options { structure, exit_boxes, ..Options::default() })
    })
}

/// Where lists are short, counted walks take the same steps as others.
#[test]
fn as_many_calls_as_are_counted() {
    let sets: Vec<Isa> = Isa::ALL.into_iter().filter(|&set| force_isa(set)).collect();
    for mesh in [soups::clustered(600), soups::tangle(3, 200)] {
        let picture = picture(&mesh, 24);
        for options in structures() {
            let scene = build(&mesh, &options);
            let view = scene.view();
            for &set in &sets {
                assert!(force_isa(set), "{set:?}");
                let mut tape = Tape::record(view, &picture, &[]);
                let mut counted = Counters::default();
                for ray in &picture {
                    view.intersect_counted(ray, &mut counted);
                }
                let what = format!("{options:?}, {set:?}");
                assert_eq!(tape.calls(Function::Ray), picture.len() as u64, "{what}");
                assert_eq!(tape.run(Function::Ray), picture.len() as u64, "{what}");
                // A grid that its box rules out is counted but not entered.
                let grids = tape.calls(Function::Grid);
                assert!(grids <= counted.grids && 2 * grids >= counted.grids, "{what}: {grids}");
                assert!(tape.calls(Function::Voxel) <= counted.voxels, "{what}");
                let entered = tape.run(Function::Grid);
                assert!(entered <= grids && entered > 0, "{what}");
                if options.structure == Structure::Uniform {
                    assert_eq!(tape.calls(Function::Voxel), counted.voxels, "{what}");
                    assert_eq!(tape.calls(Function::Test), counted.tests, "{what}");
                }
                // The voxels come again to every list, and the lists to every decision.
                let lists = tape.run(Function::Voxel);
                let mut tests = 0;
                tape.each_test(|_, _, _| tests += 1);
                assert_eq!(tests, tape.calls(Function::Test), "{what}");
                let decided = tape.run(Function::Test);
                assert!(decided <= lists && decided > 0, "{what}: {decided}, {lists}");
                assert_eq!(decided, tape.run(Function::Test), "{what}: it starts afresh");
            }
        }
    }
}

/// The largest t of interest falls as it does in the query.
#[test]
fn limits_are_the_querys() {
    let mesh = scenes::kitchen().mesh;
    let picture = picture(&mesh, 16);
    for options in structures() {
        let scene = build(&mesh, &options);
        let mut tape = Tape::record(scene.view(), &picture, &picture);
        tape.each_test(|ray, _, limit| {
            let hit = scene.view().intersect(ray);
            assert!(limit >= hit.t && limit <= ray.tmax, "{options:?}: {limit} {hit:?}");
        });
    }
}

#[test]
fn costs_of_nothing_and_of_something() {
    let empty = build(&soups::empty(), &Options::default());
    let one = build(&soups::clustered(50), &Options::default());
    let picture = picture(&soups::clustered(50), 16);
    let rays = Rays::of(&picture, &picture);
    let costs = measure(&[empty.view(), one.view()], &rays, 2);
    assert_eq!((costs[0].calls, costs[0].tests), ([0; 4], Tests::default()));
    assert!(costs[1].calls.iter().all(|&n| n > 0), "{:?}", costs[1].calls);
    let tests = costs[1].tests;
    assert_eq!(tests.all, costs[1].calls(Function::Test));
    assert!(tests.steep.iter().is_sorted_by(|a, b| a >= b) && tests.in_reach <= tests.in_range);
    assert!(tests.steep[0] <= tests.not_parallel && tests.not_parallel <= tests.all);
    let predicted = costs[1].predicted(&costs[1], &Function::ALL);
    assert!(predicted.is_finite() && predicted > 0.0);
}
