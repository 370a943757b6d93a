//! Options out of their ranges are refused, by both doors; the ends of the
//! ranges are not.
#![allow(missing_docs)]

mod common;

use common::structures;
use hug::{Clustering, Error, Filter, Geometry, Gridding, MAX_LEVELS, Options, Scene, build};
use hug_kit::{Mesh, soups};

fn statuses(mesh: &Mesh, options: &Options) -> [Option<Error>; 2] {
    let soup = [Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
    let plan = || -> Result<(), Error> {
        let mut scratch = vec![0; build::measure(&soup, options)?.scratch];
        build::plan(&soup, options, &mut scratch).map(|_| ())
    };
    [Scene::build(&soup, options).err(), plan().err()]
}

fn thresholds(at: &[f32]) -> Filter {
    let mut all = [f32::NAN; MAX_LEVELS - 1];
    all[..at.len()].copy_from_slice(at);
    Filter::Thresholds { count: at.len(), at: all }
}

#[test]
fn values_out_of_range_are_refused() {
    let mesh = soups::tangle(1, 50);
    let normal = Options::default();
    let mut wrong = vec![
        Options { counts: [1, 1, 0], ..normal },
        Options { counts: [0, 0, 1], ..normal },
        Options { counts: [2049, 1, 1], ..normal },
        Options { counts: [u32::MAX; 3], ..normal },
        Options { maxp: 0, ..normal },
        Options { max_depth: 0, ..normal },
        Options { max_depth: MAX_LEVELS as u32 + 1, ..normal },
        Options { min_cluster: 0, ..normal },
        Options { turn_below: 0.0, ..normal },
        Options { turn_below: f32::NAN, ..normal },
        Options { turn_below: f32::INFINITY, ..normal },
        Options { max_refs: 0, ..normal },
        Options { max_refs: 4097, ..normal },
        Options { filter: Filter::Thresholds { count: 16, at: [1.0; 15] }, ..normal },
        Options { filter: Filter::Thresholds { count: usize::MAX, at: [1.0; 15] }, ..normal },
    ];
    let nan = f32::NAN;
    for alpha in [0.0, -1.0, 0.099, 16.1, f32::INFINITY, nan] {
        wrong.push(Options { alpha, ..normal });
        wrong.push(Options { world_alpha: Some(alpha), ..normal });
    }
    for connectivity in [0.0, -0.0, -1.0, 1.1e6, f32::INFINITY, nan] {
        wrong.push(Options { connectivity, ..normal });
    }
    for overlap_power in [0.0, -1.0, 4.1, f32::INFINITY, nan] {
        wrong.push(Options { overlap_power, ..normal });
    }
    for share in [0.0, -0.5, 1.1, f32::INFINITY, nan] {
        wrong.push(Options { filter: Filter::TwoLevels(share), ..normal });
    }
    for at in [&[0.0][..], &[-1.0], &[nan], &[f32::INFINITY], &[1.0, 1.0], &[2.0, 1.0], &[1.0, nan]]
    {
        wrong.push(Options { filter: thresholds(at), ..normal });
    }
    for options in &wrong {
        let refused = [Some(Error::InvalidValue); 2];
        assert_eq!(statuses(&mesh, options), refused, "{options:?}");
        // Also where there is nothing to build, and whatever the structure.
        assert_eq!(statuses(&Mesh::default(), options), refused, "{options:?}");
        for (_, Options { structure, .. }) in structures() {
            let options = Options { structure, ..*options };
            assert_eq!(statuses(&mesh, &options), refused, "{options:?}");
        }
    }
}

#[test]
fn ends_of_the_ranges_are_accepted() {
    let mesh = soups::tangle(1, 50);
    let room = Options { max_refs: 4096, ..Options::default() };
    let all =
        thresholds(&std::array::from_fn::<f32, { MAX_LEVELS - 1 }, _>(|i| 0.01 * (i + 1) as f32));
    let ends = [
        Options { counts: [1; 3], ..room },
        Options { counts: [2048, 1, 1], ..room },
        Options { alpha: 0.1, world_alpha: Some(16.0), ..room },
        Options { alpha: 16.0, world_alpha: Some(0.1), ..room },
        Options { maxp: 1, max_depth: MAX_LEVELS as u32, ..room },
        Options { maxp: u32::MAX, max_depth: 1, ..room },
        Options { connectivity: f32::from_bits(1), min_cluster: u32::MAX, ..room },
        Options { connectivity: 1e6, min_cluster: 1, ..room },
        Options { filter: Filter::TwoLevels(1.0), ..room },
        Options { filter: Filter::TwoLevels(f32::from_bits(1)), ..room },
        Options { filter: all, ..room },
        Options { filter: thresholds(&[]), ..room },
        Options { filter: thresholds(&[f32::from_bits(1), f32::MAX]), ..room },
        Options { max_refs: 1, ..room },
        Options { max_refs: 1, gridding: Gridding::Overlap, ..room },
        Options { overlap_power: 4.0, gridding: Gridding::Overlap, ..room },
        Options { overlap_power: f32::from_bits(1), gridding: Gridding::Mixed, ..room },
        Options { min_cluster: u32::MAX, clustering: Clustering::Components, ..room },
    ];
    for options in &ends {
        for (_, Options { structure, .. }) in structures() {
            let options = Options { structure, ..*options };
            assert_eq!(statuses(&mesh, &options), [None; 2], "{options:?}");
        }
    }
}

/// Counts that were asked for are not quietly made coarser.
#[test]
fn counts_that_need_too_many_references_are_refused() {
    let mut mesh = Mesh::default();
    mesh.push([[0.0; 3], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]]);
    for (name, structure) in structures().map(|(name, o)| (name, o.structure)) {
        let asked = Options { structure, counts: [64; 3], max_refs: 1, ..Options::default() };
        assert_eq!(statuses(&mesh, &asked), [Some(Error::Limit); 2], "{name}");
        let coarse = Options { counts: [1; 3], ..asked };
        assert_eq!(statuses(&mesh, &coarse), [None; 2], "{name}");
        let free = Options { counts: [0; 3], alpha: 16.0, world_alpha: None, ..asked };
        assert_eq!(statuses(&mesh, &free), [None; 2], "{name}");
    }
}
