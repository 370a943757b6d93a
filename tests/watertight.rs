//! No ray slips through an edge or a vertex of a closed mesh, at any scale.
#![allow(missing_docs)]

mod common;

use common::{build, ray, section_7, structures};
use hug::Ray;
use hug_kit::rays;
use hug_kit::soups::{ClosedMesh, bumpy_sphere};

/// Rings of the sphere: 19,880 triangles.
const RINGS: u32 = 71;

/// Shoots and counts what gets out, by either query, in each structure.
fn assert_tight(target: &ClosedMesh, rays: &[Ray], what: &str) {
    for (name, options) in structures().into_iter().chain(section_7().into_iter().skip(2)) {
        let scene = build(&target.mesh, &options);
        let view = scene.view();
        let missed = rays.iter().filter(|r| !view.intersect(r).is_hit()).count();
        let seen = rays.iter().filter(|r| !view.occluded(r)).count();
        let n = rays.len();
        assert_eq!((missed, seen), (0, 0), "{what}, {name}: of {n} rays, intersect and occluded");
    }
}

fn from_within(scale: f64, centre: [f64; 3], n: usize) {
    let target = bumpy_sphere(RINGS, scale, centre);
    let rays: Vec<Ray> = rays::watertight(&target, 1, n).iter().map(ray).collect();
    assert_tight(&target, &rays, &format!("radius {scale:e} about {centre:?}"));
}

#[test]
fn scale_1() {
    from_within(1.0, [0.0; 3], 400_000);
}

#[test]
fn scale_a_thousandth() {
    from_within(1e-3, [0.0; 3], 400_000);
}

#[test]
fn scale_a_million() {
    from_within(1e6, [0.0; 3], 400_000);
}

#[test]
fn smallest_and_largest_scales() {
    from_within(1e-30, [0.0; 3], 50_000);
    from_within(1e30, [0.0; 3], 50_000);
}

/// Far from the origin vertices sit on a coarse lattice of floats: the mesh is
/// rough, but closed.
#[test]
fn off_centre() {
    from_within(1.0, [1e3, -2e3, 500.0], 100_000);
    from_within(1e6, [-4e8, 1e8, 3e8], 50_000);
    from_within(1e-3, [1.0, 0.5, -2.0], 50_000);
}

/// The sphere with its vertices on a lattice of 2^-12 of its radius, so that a
/// ray can be aimed at a vertex without rounding.
fn snapped(scale: f64) -> ClosedMesh {
    let mut target = bumpy_sphere(24, scale, [0.0; 3]);
    let step = lattice(scale);
    for c in target.mesh.vertices.as_flattened_mut() {
        *c = ((f64::from(*c) / step).round() * step) as f32;
    }
    target
}

/// The power of two next to 2^-12 of `scale`.
fn lattice(scale: f64) -> f64 {
    (scale.log2().floor() - 12.0).exp2()
}

/// From outside, exactly through each vertex and on into the body. The ray
/// reaches the vertex at t = 2, so that a hit beyond it is a leak.
#[test]
fn exactly_through_each_vertex_from_outside() {
    for scale in [1e-30, 1e-3, 1.0, 1e6, 1e30] {
        let target = snapped(scale);
        let step = lattice(scale);
        let mut rays = Vec::new();
        for vertex in &target.mesh.vertices {
            // About the inward direction, at several lengths, on a lattice
            // so coarse that no sum rounds.
            for (length, turn) in [(1.0, 0.0), (0.5, 0.1), (0.25, -0.2), (3.0, 0.3)] {
                let v = vertex.map(f64::from);
                let inward = [-v[0] - turn * v[1], -v[1] + turn * v[2], -v[2] + turn * v[0]];
                let dir = inward.map(|c| (c * length / step).round() * step);
                let org = [0, 1, 2].map(|k| v[k] - 2.0 * dir[k]);
                let exact = |c: &f64| f64::from(*c as f32) == *c;
                assert!(dir.iter().chain(&org).all(exact), "{v:?} and {dir:?} round");
                rays.push(Ray::new(org.map(|c| c as f32), dir.map(|c| c as f32)));
            }
        }
        assert_tight(&target, &rays, &format!("radius {scale:e} from outside"));
        for (name, options) in structures().into_iter().chain(section_7().into_iter().skip(2)) {
            let scene = build(&target.mesh, &options);
            for ray in &rays {
                let hit = scene.view().intersect(ray);
                assert!(hit.t <= 2.0, "{name}, radius {scale:e}: {ray:?} leaks to {hit:?}");
                let ended = ray.with_range(0.0, 2.0);
                assert!(scene.view().occluded(&ended), "{name}, radius {scale:e}: {ended:?}");
            }
        }
    }
}
