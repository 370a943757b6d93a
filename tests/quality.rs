//! AUTO's quality and compactness change how fine the structure is and nothing
//! that a ray can tell; the other structures keep to their own parameters.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, assert_same, build, ray, structures};
use hug::{Options, Quality, Stats, Structure};
use hug_kit::mesh::Mesh;
use hug_kit::{scenes, soups};

const QUALITIES: [Quality; 3] = [Quality::Fast, Quality::Default, Quality::High];

fn all() -> impl Iterator<Item = Options> {
    QUALITIES.into_iter().flat_map(|quality| {
        [false, true].map(|compact| Options { quality, compact, ..Options::default() })
    })
}

#[test]
fn finer_structures_are_larger() {
    let mesh = scenes::kitchen().mesh;
    let size = |options| build(&mesh, &options).view().bytes().len();
    let sizes = QUALITIES.map(|quality| size(Options { quality, ..Options::default() }));
    assert!(sizes.is_sorted() && sizes[0] < sizes[2], "{sizes:?}");
    let compact =
        QUALITIES.map(|quality| size(Options { quality, compact: true, ..Options::default() }));
    assert!(compact.iter().zip(sizes).all(|(&compact, size)| compact < size), "{compact:?}");
    // Less than without a tree.
    assert!(compact[1] < sizes[0], "{compact:?} {sizes:?}");
}

#[test]
fn a_ray_cannot_tell() {
    let mesh = soups::clustered(900);
    let expected = build(&mesh, &Options::default());
    for options in all() {
        let scene = build(&mesh, &options);
        for (_, r) in adversarial_rays(&mesh, 1, 50) {
            let r = ray(&r);
            let hits = [&scene, &expected].map(|s| s.view().intersect(&r));
            assert_same(&hits[0], &hits[1], &r, &format!("{options:?}"));
        }
    }
}

/// Quality is then about the tree alone: none, one, and one built with more care.
#[test]
fn compact_grids_are_the_same_whatever_the_quality() {
    let mesh = soups::clustered(900);
    let [fast, default, high] = QUALITIES.map(|quality| {
        let scene = build(&mesh, &Options { quality, compact: true, ..Options::default() });
        Stats::of(&scene.view())
    });
    let grids =
        |stats: &Stats| (stats.grid_bytes, stats.voxel_bytes, stats.ref_bytes, stats.total.voxels);
    assert_eq!(grids(&default), grids(&fast));
    assert_eq!(grids(&default), grids(&high));
    assert_eq!(fast.node_bytes, 0);
    assert!(default.node_bytes > 0 && high.node_bytes > 0);
    assert!(default.node_bytes < 12 * 900 && high.node_bytes < 12 * 900);
}

#[test]
fn other_structures_keep_their_parameters() {
    let mesh = soups::tangle(1, 600);
    for (name, normal) in structures() {
        for explicit in [normal, Options { alpha: 1.7, maxp: 9, ..normal }] {
            let expected = build(&mesh, &explicit);
            for Options { quality, compact, .. } in all() {
                let scene = build(&mesh, &Options { quality, compact, ..explicit });
                assert!(scene.view().bytes() == expected.view().bytes(), "{name}");
            }
        }
    }
}

/// Voxels of the grids below the outermost.
fn below(mesh: &Mesh, options: &Options) -> u64 {
    let stats = Stats::of(&build(mesh, options).view());
    stats.total.voxels - stats.counts.iter().map(|&n| u64::from(n)).product::<u64>()
}

/// Most triangles lie about, some in a clump: of two hundred, or as many as all others together.
#[test]
fn what_little_is_crowded_is_cut_finely() {
    for (clump, finer) in [(200, true), (10_000, false)] {
        let mut mesh = soups::uniform(10_000);
        let small = soups::rescaled(&soups::uniform(clump), 0.02);
        small.triangles().for_each(|t| mesh.push(t));
        let normal = Options {
            structure: Structure::Recursive,
            alpha: 0.5,
            world_alpha: Some(1.0),
            maxp: 40,
            ..Options::default()
        };
        let [plain, filled] =
            [false, true].map(|fill_up| below(&mesh, &Options { fill_up, ..normal }));
        assert!(plain > 0, "{clump} triangles are no crowd");
        assert_eq!(filled > 2 * plain, finer, "{clump} triangles: {plain} voxels, {filled}");
        // A voxel for each reference at most, but for the rounding of counts.
        assert!(filled <= 4 * clump as u64, "{clump} triangles: {filled} voxels");
    }
}
