//! The statistics of a scene, recounted from the arena's bytes and from the mesh.
#![allow(missing_docs)]

mod common;

use common::{build, configurations, layout as bytes};
use hug::{Lengths, Level, Occupancy, Options, Stats, View, cumulated};
use hug_kit::{Mesh, soups};
use std::collections::BTreeSet;

/// One voxel, read from the bytes.
struct Voxel {
    level: usize,
    grid: usize,
    triangles: Vec<u32>,
    grids: u64,
    /// Of the voxels' and the references' sections: its own, and those of its list.
    words: u64,
}

fn voxels(arena: &[u8]) -> Vec<Voxel> {
    let mut all = Vec::new();
    for grid in 0..bytes::count(arena, bytes::GRIDS) {
        let at = bytes::record(arena, bytes::GRIDS, grid);
        let level = usize::from(arena[at + bytes::LEVEL]);
        let first = bytes::get32(arena, at + bytes::FIRST) as usize;
        let n = [0, 2, 4].map(|k| usize::from(bytes::get16(arena, at + bytes::N + k)));
        for number in first..first + n.iter().product::<usize>() {
            let mut words = 1;
            let refs = match bytes::voxel(arena, number) {
                (bytes::LIST, start) => {
                    let head = bytes::record(arena, bytes::REFS, start as usize);
                    let length = bytes::get32(arena, head + 4) as usize;
                    words += 2 + 2 * length as u64;
                    (0..length).map(|i| bytes::get32(arena, head + 8 + 4 * i)).collect()
                }
                (bytes::GRID, number) => vec![number | bytes::GRID_BIT],
                _ => Vec::new(),
            };
            let (grids, triangles): (Vec<u32>, Vec<u32>) =
                refs.into_iter().partition(|r| r & bytes::GRID_BIT != 0);
            all.push(Voxel { level, grid, triangles, grids: grids.len() as u64, words });
        }
    }
    all
}

fn soups_and_scenes(check: impl Fn(&str, &Mesh, &View<'_>)) {
    for (soup, mesh) in [("clustered", soups::clustered(700)), ("tangle", soups::tangle(1, 300))] {
        for (name, options) in configurations() {
            check(&format!("{soup}, {name}"), &mesh, &build(&mesh, &options).view());
        }
    }
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs()).max(1.0)
}

/// Mean and standard deviation of the population, from its members.
fn moments(members: &[f64]) -> (f64, f64) {
    if members.is_empty() {
        return (0.0, 0.0);
    }
    let n = members.len() as f64;
    let mean = members.iter().sum::<f64>() / n;
    let variance = members.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / n;
    (mean, variance.sqrt())
}

fn recount(what: &str, level: &Level, of: &[&Voxel]) {
    let objects: Vec<f64> = of.iter().map(|v| v.triangles.len() as f64).collect();
    let grids: Vec<f64> = of.iter().map(|v| v.grids as f64).collect();
    let filled = |all: &[f64]| all.iter().copied().filter(|&x| x > 0.0).collect::<Vec<_>>();
    let per = [
        (level.objects_per_voxel(), moments(&objects)),
        (level.objects_per_filled_voxel(), moments(&filled(&objects))),
        (level.grids_per_voxel(), moments(&grids)),
        (level.grids_per_filled_voxel(), moments(&filled(&grids))),
    ];
    for (number, (found, (mean, deviation))) in per.into_iter().enumerate() {
        assert!(close(found.mean, mean), "{what}: mean {number}: {found:?} {mean}");
        // From sums of squares: good to half the digits.
        let off = (found.deviation - deviation).abs();
        assert!(off < 1e-6 * mean.max(1.0), "{what}: deviation {number}: {found:?} {deviation}");
    }
    let numbers = of.iter().map(|v| v.grid).collect::<BTreeSet<_>>().len() as u64;
    assert_eq!(level.grids, numbers, "{what}");
    assert_eq!(level.voxels, of.len() as u64, "{what}");
    let words: u64 = of.iter().map(|v| v.words).sum();
    assert_eq!(level.bytes, 64 * numbers + 4 * words, "{what}");
    assert_eq!(level.object_voxels, filled(&objects).len() as u64, "{what}");
    assert_eq!(level.grid_voxels, filled(&grids).len() as u64, "{what}");
    assert_eq!(level.pointers() as f64, objects.iter().chain(&grids).sum::<f64>(), "{what}");
}

#[test]
fn levels_are_what_the_bytes_hold() {
    soups_and_scenes(|what, mesh, view| {
        let (all, stats) = (voxels(view.bytes()), Stats::of(view));
        let whole = stats.triangles + stats.dropped_degenerate;
        assert_eq!(whole, mesh.indices.len() as u64, "{what}");
        assert_eq!(stats.total.bytes, stats.grid_bytes + stats.voxel_bytes + stats.ref_bytes);
        let volumes: Vec<(u32, f64)> = (0..view.grid_count())
            .filter_map(|number| view.grid_shape(number))
            .map(|g| (g.level, (0..3).map(|k| g.upper[k] - g.lower[k]).product()))
            .collect();
        let largest = volumes.iter().map(|v| v.1).fold(0.0, f64::max);
        for (number, level) in stats.levels().iter().enumerate() {
            let of: Vec<&Voxel> = all.iter().filter(|v| v.level == number).collect();
            recount(&format!("{what}, level {number}"), level, &of);
            let distinct: BTreeSet<u32> = of.iter().flat_map(|v| v.triangles.clone()).collect();
            assert_eq!(level.objects, distinct.len() as u64, "{what}, level {number}");
            let volume: f64 = volumes.iter().filter(|v| v.0 as usize == number).map(|v| v.1).sum();
            // A grid's cells are rounded to `f32` in their reciprocals.
            let off = (level.volume - volume / largest).abs();
            assert!(off <= 1e-6 * level.volume, "{what}, level {number}: %vol off by {off}");
        }
    });
}

#[test]
fn shares_sum_to_the_whole() {
    soups_and_scenes(|what, _, view| {
        let stats = Stats::of(view);
        let shares: Vec<_> = stats.levels().iter().map(|l| stats.shares(l)).collect();
        let total = stats.shares(&stats.total);
        let sum = |of: fn(&hug::Shares) -> f64| shares.iter().map(of).sum::<f64>();
        for part in [sum(|s| s.objects_of_levels), sum(|s| s.grids), sum(|s| s.voxels)] {
            assert!(close(part, 100.0), "{what}: {part}");
        }
        assert!(close(sum(|s| s.pointers), 100.0) && close(sum(|s| s.bytes), 100.0), "{what}");
        assert!(close(sum(|s| s.volume), total.volume) && total.volume > 99.999, "{what}");
        assert!(close(sum(|s| s.objects), total.objects) && total.objects > 99.999, "{what}");
        for (share, level) in shares.iter().zip(stats.levels()).filter(|(_, l)| l.voxels > 0) {
            let printed = share.objects_of_levels / share.grids;
            assert!(close(share.objects_per_grid_printed(), printed), "{what}");
            let ratio = level.objects as f64 / level.voxels as f64;
            assert!(close(level.distinct_per_voxel(), ratio), "{what}");
            let empty = 100.0 * (level.voxels - level.object_voxels) as f64 / level.voxels as f64;
            assert!(close(share.object_voxels, 100.0 - empty), "{what}");
        }
    });
}

#[test]
fn histograms_are_what_the_bytes_hold() {
    soups_and_scenes(|what, _, view| {
        let all = voxels(view.bytes());
        let levels = Stats::of(view).levels().len();
        for level in (0..levels).map(Some).chain([None]) {
            let of = || all.iter().filter(|v| level.is_none_or(|l| l == v.level));
            let counts = Occupancy::histogram(view, level);
            let mut expected = vec![0u64; counts.len()];
            of().for_each(|v| expected[v.triangles.len()] += 1);
            assert_eq!(counts, expected, "{what}, {level:?}");
            // A filter may leave a level without objects.
            let some = of().count() > 0;
            assert!(some == (counts.last() > Some(&0)), "{what}, {level:?}");
            // A slice that is too short: what is beyond gathers in its last element.
            let mut few = [7; 3];
            let seen = Occupancy::count(view, level, &mut few);
            let more = expected.iter().skip(2).sum();
            let at = |i: usize| expected.get(i).copied().unwrap_or(0);
            assert_eq!(few, [at(0), at(1), more], "{what}, {level:?}");
            assert_eq!(seen.voxels, of().count() as u64, "{what}, {level:?}");
            assert_eq!(seen.most as usize + 1, counts.len(), "{what}, {level:?}");
            let mut percent = vec![0.0; counts.len()];
            cumulated(&counts, seen.voxels, &mut percent);
            let end = if some { 100.0 } else { 0.0 };
            assert!(percent.is_sorted() && percent.last() == Some(&end), "{what}, {level:?}");
        }
        let mut none = [7; 3];
        let seen = Occupancy::count(view, Some(levels), &mut none);
        assert_eq!((seen, none), (Occupancy::default(), [0; 3]), "{what}");
    });
}

/// The diagonal of a triangle's box.
fn length(corners: [[f32; 3]; 3]) -> f64 {
    let squares = [0, 1, 2].map(|k| {
        let of = corners.map(|p| f64::from(p[k]));
        (of[0].max(of[1]).max(of[2]) - of[0].min(of[1]).min(of[2])).powi(2)
    });
    squares.iter().sum::<f64>().sqrt()
}

#[test]
fn lengths_are_those_of_the_mesh() {
    let mesh = soups::clustered(900);
    let scene = build(&mesh, &Options::default());
    let found = Lengths::of(&scene.view());
    let lengths: Vec<f64> = mesh.triangles().map(length).collect();
    let max = lengths.iter().copied().fold(0.0, f64::max);
    let min = lengths.iter().copied().fold(f64::INFINITY, f64::min);
    assert_eq!(found.count, lengths.len() as u64);
    assert!(close(found.max / max, 1.0) && close(found.min / min, 1.0), "{found:?}");
    assert!(close(found.min_over_max(), min / max));
    let diagonal = mesh.bounds().expect("it has vertices").diagonal();
    assert!(close(found.diagonal / diagonal, 1.0));
    let below = lengths.iter().filter(|&&d| d < 0.2 * max).count();
    assert_eq!(found.below_fifth, below as u64);
    assert!(close(found.percent_below_fifth(), 100.0 * below as f64 / lengths.len() as f64));
    for (share, classes) in [(1.0, 10), (0.2, 40), (0.5, 1)] {
        let mut counts = vec![7; classes];
        found.histogram(&scene.view(), share, &mut counts);
        let within = lengths.iter().filter(|&&d| d <= share * max).count() as u64;
        assert_eq!(counts.iter().sum::<u64>(), within);
        let half = lengths.iter().filter(|&&d| d < 0.5 * share * max).count() as u64;
        if classes > 1 {
            assert_eq!(counts[..classes / 2].iter().sum::<u64>(), half, "{share} {classes}");
        }
    }
}

#[test]
fn nothing_has_no_statistics() {
    let scene = build(&soups::empty(), &Options::default());
    let view = scene.view();
    let lengths = Lengths::of(&view);
    assert_eq!(lengths, Lengths::default());
    let none = [lengths.min_over_max(), lengths.min_over_diagonal(), lengths.percent_below_fifth()];
    assert_eq!(none, [0.0; 3]);
    for share in [0.2, 0.0, -1.0, f64::NAN, f64::INFINITY] {
        let mut counts = [7; 4];
        lengths.histogram(&view, share, &mut counts);
        assert_eq!(counts, [0; 4]);
    }
    assert_eq!(Occupancy::histogram(&view, None), [0]);
    let stats = Stats::of(&view);
    assert!(stats.levels().is_empty() && stats.shares(&stats.total).objects == 0.0);
    assert_eq!(
        (view.grid_count(), view.grid_shape(0), view.voxel_counts(0, [0; 3])),
        (0, None, None)
    );
}

#[test]
fn grids_and_voxels_one_by_one() {
    soups_and_scenes(|what, mesh, view| {
        let mut all = voxels(view.bytes()).into_iter();
        let bounds = mesh.bounds().expect("it has vertices");
        for number in 0..view.grid_count() {
            let shape = view.grid_shape(number).expect("a grid of this number");
            let [nx, ny, nz] = shape.counts;
            let inside =
                (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])));
            for at in inside {
                let voxel = all.next().expect("as many voxels");
                let expected = (voxel.triangles.len() as u64, voxel.grids);
                assert_eq!(view.voxel_counts(number, at), Some(expected), "{what}, {number}");
                assert_eq!((voxel.grid, voxel.level), (number, shape.level as usize), "{what}");
            }
            assert_eq!(view.voxel_counts(number, [nx, 0, 0]), None, "{what}");
            assert!((0..3).all(|k| shape.lower[k] < shape.upper[k]), "{what}: {shape:?}");
        }
        let world = view.grid_shape(0).expect("the outermost grid");
        for k in 0..3 {
            assert!(world.lower[k] <= f64::from(bounds.lo[k]), "{what}");
            assert!(world.upper[k] >= f64::from(bounds.hi[k]), "{what}");
        }
        assert_eq!(view.grid_shape(view.grid_count()), None);
    });
}
