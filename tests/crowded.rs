//! Soups that no cutting separates: builds end, and keep to the references that
//! they were allowed.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, assert_same, build, configurations, ray, structures};
use hug::{Clustering, Filter, Hierarchy, Options, Ray, Scene, Stats, Structure};
use hug_kit::Mesh;
use hug_kit::random::Random;

/// References are at most `max_refs` for each object of a grid, be it a triangle
/// or a grid; the recursive grid may spend the same again on grids below.
fn assert_bounded(scene: &Scene, options: &Options, what: &str) {
    let stats = Stats::of(&scene.view());
    let refs = stats.total.object_refs + stats.total.grid_refs;
    let rounds = if stats.structure == Structure::Recursive { 2 } else { 1 };
    let allowed = rounds * u64::from(options.max_refs) * (stats.triangles + stats.total.grids);
    assert!(refs <= allowed, "{what}: {refs} references, allowed {allowed}");
    assert!(stats.total.object_refs >= stats.triangles, "{what}: {stats:?}");
}

/// Few rays, as each meets nearly everything; the arbiter stays out of it.
fn assert_right(scene: &Scene, rays: &[Ray], what: &str) {
    for r in rays {
        let expected = scene.view().intersect_brute(r);
        assert_same(&scene.view().intersect(r), &expected, r, &what);
        assert_eq!(scene.view().occluded(r), expected.is_hit(), "{what}: {r:?}");
    }
}

fn check(mesh: &Mesh, kind: &str, options: &[(&str, Options)]) {
    let few = Mesh { vertices: mesh.vertices.clone(), indices: mesh.indices[..4].to_vec() };
    let rays: Vec<Ray> = adversarial_rays(&few, 1, 1).iter().map(|(_, r)| ray(r)).collect();
    for (name, options) in options {
        let scene = build(mesh, options);
        let what = format!("{} times {kind} in {name}", mesh.indices.len());
        assert_bounded(&scene, options, &what);
        assert_right(&scene, &rays, &what);
    }
}

/// So many triangles, drawn one by one.
fn drawn(seed: u64, n: usize, mut draw: impl FnMut(&mut Random) -> [[f32; 3]; 3]) -> Mesh {
    let mut mesh = Mesh::default();
    let mut random = Random::stream(seed);
    for _ in 0..n {
        mesh.push(draw(&mut random));
    }
    mesh
}

/// Few triangles in every configuration, many in the three structures.
fn check_both(make: impl Fn(usize) -> Mesh, kind: &str, many: usize) {
    let free = |(name, options): (&'static str, Options)| {
        // Where counts are given, the caller has to allow for what they cost.
        let max_refs = options.max_refs.min(32);
        (name, Options { counts: [0; 3], max_refs, ..options })
    };
    let every: Vec<_> = configurations().into_iter().map(free).collect();
    check(&make(2000), kind, &every);
    check(&make(many), kind, &structures());
}

#[test]
fn copies_of_one_triangle() {
    let copies = |n| {
        let vertices = vec![[0.1, 0.2, 0.3], [1.0, 0.4, -0.2], [-0.3, 0.9, 0.5]];
        let indices = (0..n).map(|i| if i % 2 == 0 { [0, 1, 2] } else { [2, 1, 0] }).collect();
        Mesh { vertices, indices }
    };
    check_both(copies, "one triangle", 100_000);
}

/// Stacked with no distance between that a float can halve.
#[test]
fn a_stack_of_neighbouring_floats() {
    let stack = |n| {
        let mut mesh = Mesh::default();
        let mut z = 1.0_f32;
        for _ in 0..n {
            mesh.push([[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]]);
            z = z.next_up();
        }
        mesh
    };
    check_both(stack, "the next float", 100_000);
}

/// All through one point: no voxel there holds fewer than all, at any depth.
#[test]
fn a_fan_about_one_vertex() {
    let fan = |n| {
        let mut mesh = Mesh { vertices: vec![[0.0; 3]], indices: Vec::new() };
        let mut random = Random::stream(77);
        for i in 0..n as u32 {
            let tips = [random.direction(), random.direction()];
            mesh.vertices.extend(tips.map(|v| v.map(|c| c as f32)));
            mesh.indices.push([0, 2 * i + 1, 2 * i + 2]);
        }
        mesh
    };
    check_both(fan, "a blade of a fan", 20_000);
}

#[test]
fn huge_triangles_across_each_other() {
    let far = |random: &mut Random| random.direction().map(|c| (c * 1e6) as f32);
    let huge = |n| drawn(78, n, |random| [(); 3].map(|()| far(random)));
    check_both(huge, "a huge triangle", 20_000);
}

/// Each from one side of the scene to the other, and a hair wide.
#[test]
fn slivers_through_all_of_space() {
    let slivers = |n| {
        drawn(79, n, |random| {
            let [a, b] = [(); 2].map(|()| random.direction().map(|c| c as f32));
            [a, b, [b[0], b[1], b[2] + 1e-6]]
        })
    };
    check_both(slivers, "a sliver", 20_000);
}

/// Within a few units in the last place of one point, from which one triangle is far.
#[test]
fn nearly_one_point() {
    let point = |n| {
        let mut mesh = Mesh::default();
        let mut random = Random::stream(80);
        mesh.push([[-9.0, 0.0, 0.0], [-9.0, 1.0, 0.0], [-9.0, 0.0, 1.0]]);
        while mesh.indices.len() < n {
            let ulps = |random: &mut Random| (0..random.below(9)).fold(1.0f32, |x, _| x.next_up());
            let corners = [(); 3].map(|()| [(); 3].map(|()| ulps(&mut random)));
            mesh.push(corners);
        }
        mesh
    };
    check_both(point, "a speck", 100_000);
}

/// Sticks along x and along y in turn, level by level, each a cluster that crosses all of
/// every other level below: paths from the world would be thousands for each grid.
#[test]
fn clusters_across_each_other_on_every_level() {
    let mut mesh = Mesh::default();
    let mut at = [0.0; 15];
    for (level, at) in at.iter_mut().enumerate() {
        let length = 4.0 + level as f32 / 2.0;
        *at = length + 0.25;
        for stick in 0..4 {
            let aside = stick as f32 / 4.0 - 0.4;
            let corner = |along: f32, across: f32, z: f32| {
                let along = along * length / 2.0;
                if level % 2 == 0 { [along, across, z] } else { [across, along, z] }
            };
            mesh.push([
                corner(-1.0, aside, 0.0),
                corner(1.0, aside + 0.01, 0.0),
                corner(1.0, aside, 0.01),
            ]);
        }
    }
    let options = Options {
        structure: Structure::Hug,
        filter: Filter::Thresholds { count: 15, at },
        clustering: Clustering::Components,
        hierarchy: Hierarchy::Paper,
        min_cluster: 1,
        ..Options::default()
    };
    check(&mesh, "sticks", &[("the paper's hierarchy", options)]);
}
