//! What the integration tests share: soups, configurations, bit comparison.
#![allow(dead_code, missing_docs)]

pub mod aligned;
#[cfg(feature = "capi")]
pub mod compare;
pub mod everywhere;
pub mod layout;
pub mod native;

use hug::{
    Clustering, Delta, Error, Filter, Geometry, Gridding, Hierarchy, Hit, Options, Orientation,
    Quality, Ray, Scene, Structure,
};
use hug_kit::random::Random;
use hug_kit::{Bounds, Mesh, rays, soups};

/// Every soup that the exactness tests run on, small enough for brute force.
pub fn soups() -> Vec<(&'static str, Mesh)> {
    let tangle = soups::tangle(1, 600);
    vec![
        ("empty", soups::empty()),
        ("single", soups::single()),
        ("slivers", soups::slivers(2, 500)),
        ("stacked", soups::stacked(3, 300)),
        ("lattice", soups::lattice(4, 600, 8)),
        ("mixed scales", soups::mixed_scales(5, 500)),
        ("tiny", soups::rescaled(&tangle, 1e-30)),
        ("huge", soups::rescaled(&tangle, 1e30)),
        ("tangle", tangle),
        ("sphere", soups::bumpy_sphere(12, 1.0, [0.3, -0.2, 0.1]).mesh),
        ("surface", soups::surface(800)),
        ("clustered", soups::clustered(900)),
        ("all scales", all_scales(300)),
    ]
}

/// Sizes from 1e-30 to 1e30 in one scene, all about the origin.
fn all_scales(n: usize) -> Mesh {
    let mut random = Random::stream(82);
    let mut mesh = Mesh::default();
    for _ in 0..n {
        let size = 2f64.powi(random.below(200) as i32 - 100);
        mesh.push([(); 3].map(|()| random.direction().map(|c| (c * size) as f32)));
    }
    mesh
}

/// Every structure, with the parameters that change what a walk meets.
pub fn configurations() -> Vec<(&'static str, Options)> {
    let base = Options { min_cluster: 2, ..Options::default() };
    let of = |structure| Options { structure, ..base };
    let hug = of(Structure::Hug);
    let three = Options { filter: Filter::ThreeLevels, ..hug };
    let components = Options { clustering: Clustering::Components, ..hug };
    let overlap = |options| Options { gridding: Gridding::Overlap, ..options };
    let mixed = Gridding::Mixed;
    let mut at = [0.0; 15];
    at[..3].copy_from_slice(&[0.02, 0.1, 0.4]);
    vec![
        ("auto", Options::default()),
        ("g", of(Structure::Uniform)),
        ("g homogeneous", Options { gridding: Gridding::Homogeneous, ..of(Structure::Uniform) }),
        ("g 8", Options { counts: [8; 3], max_refs: 4096, ..of(Structure::Uniform) }),
        ("g tree", Options { tree: true, ..of(Structure::Uniform) }),
        (
            "r4 tree",
            Options { maxp: 4, tree: true, quality: Quality::High, ..of(Structure::Recursive) },
        ),
        ("g fine", Options { alpha: 3.0, max_refs: 256, ..of(Structure::Uniform) }),
        ("r4", Options { maxp: 4, ..of(Structure::Recursive) }),
        ("r4 filled", Options { maxp: 4, alpha: 0.5, fill_up: true, ..of(Structure::Recursive) }),
        ("r48", Options { maxp: 48, world_alpha: Some(1.0), ..of(Structure::Recursive) }),
        ("r1 deep", Options { maxp: 1, max_depth: 16, max_refs: 512, ..of(Structure::Recursive) }),
        ("r50", of(Structure::Recursive)),
        ("u.f2", hug),
        ("u.f3", three),
        ("u.f2 turned", Options { orientation: Orientation::Search, turn_below: 1e6, ..hug }),
        ("u.f3 turned", Options { orientation: Orientation::Vertices, turn_below: 1e6, ..three }),
        ("u.f2 hull", Options { orientation: Orientation::Hull, min_cluster: 1, ..hug }),
        ("u.f3 paper", Options { hierarchy: Hierarchy::Paper, min_cluster: 1, ..three }),
        ("u.f3 mean", Options { delta: Delta::Mean, connectivity: 0.3, ..three }),
        ("u.f4", Options { filter: Filter::Thresholds { count: 3, at }, min_cluster: 1, ..hug }),
        ("u.f2 components", components),
        (
            "u.f3 components",
            Options { clustering: Clustering::Components, min_cluster: 1, ..three },
        ),
        (
            "u.f3 components, paper",
            Options { hierarchy: Hierarchy::Paper, filter: Filter::ThreeLevels, ..components },
        ),
        ("u.f2 overlap", overlap(components)),
        ("u.f3 mixed", Options { gridding: mixed, overlap_power: 2.0, ..three }),
        ("g overlap", overlap(of(Structure::Uniform))),
        (
            "r4 overlap",
            Options { maxp: 4, overlap_power: 1.0, ..overlap(of(Structure::Recursive)) },
        ),
        ("r4 mixed", Options { maxp: 4, gridding: mixed, ..of(Structure::Recursive) }),
    ]
}

/// The options of section 7 that change how long a build takes, and how much memory.
pub fn section_7() -> [(&'static str, Options); 4] {
    let hug = Options {
        structure: Structure::Hug,
        clustering: Clustering::Components,
        ..Options::default()
    };
    let overlap = Options { gridding: Gridding::Overlap, ..hug };
    [
        ("HUG of components", hug),
        ("the same, few in the world", Options { filter: Filter::TwoLevels(1.0), ..hug }),
        (
            "the same, overlap",
            Options { min_cluster: 1, filter: Filter::TwoLevels(1.0), ..overlap },
        ),
        ("recursive, overlap", Options { structure: Structure::Recursive, ..overlap }),
    ]
}

/// The three structures as anybody would build them.
pub fn structures() -> [(&'static str, Options); 3] {
    [("uniform", Structure::Uniform), ("recursive", Structure::Recursive), ("HUG", Structure::Hug)]
        .map(|(name, structure)| (name, Options { structure, ..Options::default() }))
}

pub fn build(mesh: &Mesh, options: &Options) -> Scene {
    let geometry = Geometry::from_mesh(&mesh.vertices, &mesh.indices);
    Scene::build(&[geometry], options).expect("the soup is valid")
}

pub fn ray(r: &rays::Ray) -> Ray {
    bytemuck::cast(*r)
}

/// All kinds of adversarial rays at a mesh, `n` of each kind.
pub fn adversarial_rays(mesh: &Mesh, seed: u64, n: usize) -> Vec<(rays::Aim, rays::Ray)> {
    let unit = Bounds { lo: [0.0; 3], hi: [1.0; 3] };
    let bounds = mesh.bounds().unwrap_or(unit);
    let shoot = |aim| {
        let rays = rays::adversarial(aim, mesh, &bounds, [8; 3], seed, n);
        rays.into_iter().map(move |r| (aim, r))
    };
    rays::Aim::ALL.into_iter().flat_map(shoot).collect()
}

/// Asserts that two hits are the same to the last bit.
#[track_caller]
pub fn assert_same(found: &Hit, expected: &Hit, ray: &Ray, what: &dyn core::fmt::Display) {
    let bits = |h: &Hit| bytemuck::cast::<Hit, [u32; 10]>(*h);
    assert!(
        bits(found) == bits(expected),
        "{what}\nray      {ray:?}\nfound    {found:?}\nexpected {expected:?}"
    );
}

/// Whether this is how an arena is refused whose header is one, but not all the rest.
pub fn is_damage(error: Option<Error>) -> bool {
    use Error::{Corrupt, Cycle, Reference, Sections};
    matches!(error, Some(Corrupt | Cycle | Reference | Sections))
}
