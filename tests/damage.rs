//! Every record of an arena, damaged one way at a time: each is found.
#![allow(missing_docs)]

mod common;

use common::aligned::Aligned;
use common::layout::*;
use common::{build, is_damage, structures};
use hug::{Error, Filter, Hierarchy, Options, Orientation, Structure, View};
use hug_kit::soups;

/// Arenas of every structure, among them some with many grids below grids.
fn samples() -> Vec<(String, Aligned)> {
    let deep = Options { maxp: 4, structure: Structure::Recursive, ..Options::default() };
    let hug = Options { structure: Structure::Hug, min_cluster: 1, ..Options::default() };
    let paper = Options { hierarchy: Hierarchy::Paper, filter: Filter::ThreeLevels, ..hug };
    let turned = Options { orientation: Orientation::Search, turn_below: 1e6, ..hug };
    let more = [("r4", deep), ("u.f2", hug), ("u.f3 paper", paper), ("u.f2 turned", turned)];
    let mut samples = Vec::new();
    for (kind, options) in structures().into_iter().chain(more) {
        for (name, mesh) in [("clumps", soups::clustered(900)), ("tangle", soups::tangle(1, 400))] {
            let scene = build(&mesh, &options);
            samples.push((format!("{name} in {kind}"), Aligned::copy(scene.view().bytes())));
        }
    }
    samples
}

/// Asserts that the bytes no longer open once `damage` was done to them.
#[track_caller]
fn corrupt(name: &str, bytes: &Aligned, damage: impl FnOnce(&mut [u8])) {
    let error = refusal(name, bytes, damage);
    assert!(is_damage(error), "{name}: {error:?}");
}

/// Asserts that they do not for this reason.
#[track_caller]
fn refused(name: &str, bytes: &Aligned, expected: Error, damage: impl FnOnce(&mut [u8])) {
    assert_eq!(refusal(name, bytes, damage), Some(expected), "{name}");
}

#[track_caller]
fn refusal(name: &str, bytes: &Aligned, damage: impl FnOnce(&mut [u8])) -> Option<Error> {
    let mut damaged = bytes.clone();
    damage(&mut damaged);
    assert!(damaged[..] != bytes[..], "{name}: nothing was damaged");
    View::open(&damaged).err()
}

/// The first, a middle and the last of `n`.
fn some(n: usize) -> impl Iterator<Item = usize> {
    [0, n / 2, n.saturating_sub(1)].into_iter().filter(move |&i| i < n)
}

#[test]
fn the_samples_have_all_kinds_of_records() {
    let samples = samples();
    let grids = samples.iter().map(|(_, bytes)| count(bytes, GRIDS)).max();
    assert!(grids > Some(5), "{grids:?} grids at the most");
    for (name, bytes) in &samples {
        assert_eq!(View::open(bytes).err(), None, "{name}");
        assert!(lists(bytes).iter().any(|list| list.refs.len() > 1), "{name}");
    }
    let to_grid = |bytes: &Aligned| {
        let refs = lists(bytes).into_iter().flat_map(|list| list.refs);
        refs.into_iter().any(|at| get32(bytes, at) & GRID_BIT != 0)
    };
    assert!(samples.iter().any(|(_, bytes)| to_grid(bytes)), "no list has a grid");
}

#[test]
fn occluders() {
    for (name, bytes) in samples() {
        let triangles = count(&bytes, TRIANGLES) as u32;
        for at in OCCLUDERS.step_by(4) {
            for wrong in [triangles, u32::MAX - 1] {
                refused(&name, &bytes, Error::Reference, |b| put32(b, at, wrong));
            }
        }
    }
}

#[test]
fn frames() {
    let mut turned = 0;
    for (name, bytes) in samples() {
        let grids = (0..count(&bytes, GRIDS))
            .filter(|&number| bytes[record(&bytes, GRIDS, number) + FLAGS] & TURNED != 0);
        for at in grids.map(|number| record(&bytes, FRAMES, number)) {
            turned += 1;
            for place in (at..at + FRAME).step_by(8) {
                for wrong in [f64::NAN, f64::INFINITY, 1e300] {
                    refused(&name, &bytes, Error::Corrupt, |b| put_f64(b, place, wrong));
                }
            }
            // A column of the rotation: longer, and out of its right angle.
            let x = f64::from_bits(get64(&bytes, at));
            for wrong in [x + 1e-6, 2.0] {
                refused(&name, &bytes, Error::Corrupt, |b| put_f64(b, at, wrong));
            }
        }
    }
    assert!(turned > 10, "{turned}");
}

#[test]
fn grids() {
    for (name, bytes) in samples() {
        let levels = get32(&bytes, LEVELS);
        for number in some(count(&bytes, GRIDS)) {
            let at = record(&bytes, GRIDS, number);
            let word = |place: usize, wrong: u32| {
                if get32(&bytes, at + place) != wrong {
                    corrupt(&name, &bytes, |b| put32(b, at + place, wrong));
                }
            };
            for k in 0..3 {
                let place = at + N + 2 * k;
                let n = get16(&bytes, place);
                for wrong in [0, n - 1, n + 1, 2049, u16::MAX] {
                    corrupt(&name, &bytes, |b| put16(b, place, wrong));
                }
            }
            let (first, walks) = (get32(&bytes, at + FIRST), get32(&bytes, at + WALKS));
            for wrong in [first.wrapping_sub(1), first + 1, u32::MAX] {
                word(FIRST, wrong);
            }
            for wrong in [0, walks - 1, walks + 1, u32::MAX] {
                word(WALKS, wrong);
            }
            for wrong in [levels as u8, u8::MAX] {
                corrupt(&name, &bytes, |b| b[at + LEVEL] = wrong);
            }
            let turned = if count(&bytes, FRAMES) == 0 || number == 0 { TURNED } else { 4 };
            for wrong in [turned, 4, u8::MAX] {
                refused(&name, &bytes, Error::Corrupt, |b| b[at + FLAGS] = wrong);
            }
            let (nan, inf) = (f64::NAN, f64::INFINITY);
            for place in [CELL, INV_CELL] {
                for wrong in [nan, inf, -inf, 0.0, -1.0, 1e-38, 1e38] {
                    refused(&name, &bytes, Error::Corrupt, |b| {
                        put_f32(b, at + place + 4, wrong as f32);
                    });
                }
            }
            for wrong in [nan, inf, -inf, 1e300] {
                refused(&name, &bytes, Error::Corrupt, |b| put_f64(b, at + LO + 8, wrong));
            }
        }
    }
}

#[test]
fn voxels() {
    for (name, bytes) in samples() {
        let total = count(&bytes, REFS) as u32;
        let lists = lists(&bytes);
        for list in some(lists.len()).map(|i| &lists[i]) {
            let start = get32(&bytes, list.voxel) & (u32::MAX >> 2);
            // Earlier, later, at the end, past it.
            for wrong in [start.wrapping_sub(1) & (u32::MAX >> 2), start + 1, total, u32::MAX >> 2]
            {
                refused(&name, &bytes, Error::Reference, |b| {
                    put32(b, list.voxel, LIST << 30 | wrong);
                });
            }
            // Of no kind there is, or a grid that there is not.
            refused(&name, &bytes, Error::Corrupt, |b| put32(b, list.voxel, 3 << 30 | start));
            refused(&name, &bytes, Error::Reference, |b| {
                put32(b, list.voxel, GRID << 30 | u32::MAX >> 2);
            });
            let len = list.refs.len() as u32;
            for wrong in [0, len - 1, len + 1, total, u32::MAX] {
                if wrong != len {
                    corrupt(&name, &bytes, |b| put32(b, list.len, wrong));
                }
            }
            // Exit boxes that leave the grid, on each side.
            for side in 0..6 {
                refused(&name, &bytes, Error::Corrupt, |b| put32(b, list.exit, 31 << (5 * side)));
            }
            refused(&name, &bytes, Error::Corrupt, |b| put32(b, list.exit, 1 << 30));
        }
        let empty = (0..count(&bytes, VOXELS)).find(|&i| voxel(&bytes, i).0 == EMPTY);
        if let Some(at) = empty.map(|i| record(&bytes, VOXELS, i)) {
            for side in 0..6 {
                refused(&name, &bytes, Error::Corrupt, |b| put32(b, at, 31 << (5 * side)));
            }
        }
    }
}

#[test]
fn references() {
    for (name, bytes) in samples() {
        let (grids, triangles) = (count(&bytes, GRIDS) as u32, count(&bytes, TRIANGLES) as u32);
        let lists = lists(&bytes);
        for list in some(lists.len()).map(|i| &lists[i]) {
            let last = list.refs[list.refs.len() - 1];
            for wrong in [triangles, GRID_BIT - 1, GRID_BIT | grids, u32::MAX] {
                refused(&name, &bytes, Error::Reference, |b| put32(b, last, wrong));
            }
            // In circles: the grid itself, the outermost, and all in between.
            let others = &list.refs[..list.refs.len() - 1];
            let sorted = others.iter().all(|&at| get32(&bytes, at) & GRID_BIT == 0);
            let expected = if sorted { Error::Cycle } else { Error::Reference };
            for circle in [list.grid, 0, list.grid / 2] {
                refused(&name, &bytes, expected, |b| put32(b, last, GRID_BIT | circle as u32));
            }
        }
        for list in lists.iter().filter(|list| list.refs.len() > 1).take(20) {
            let (a, b) = (get32(&bytes, list.refs[0]), get32(&bytes, list.refs[1]));
            refused(&name, &bytes, Error::Reference, |d| put32(d, list.refs[1], a));
            refused(&name, &bytes, Error::Reference, |d| {
                put32(d, list.refs[0], b);
                put32(d, list.refs[1], a);
            });
        }
    }
}

/// A grid may only point to lower ones: equal levels would let a walk go deeper
/// than there are levels.
#[test]
fn levels() {
    let mut pairs = 0;
    for (name, bytes) in samples() {
        for number in 1..count(&bytes, GRIDS) {
            let (outer, inner) = (record(&bytes, GRIDS, 0), record(&bytes, GRIDS, number));
            pairs += 1;
            let same = bytes[outer + LEVEL];
            refused(&name, &bytes, Error::Cycle, |b| b[inner + LEVEL] = same);
        }
    }
    assert!(pairs > 20, "{pairs} grids below others");
}

#[test]
fn triangles() {
    for (name, bytes) in samples() {
        for number in some(count(&bytes, TRIANGLES)) {
            let at = record(&bytes, TRIANGLES, number);
            for place in COORDINATES {
                for wrong in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                    refused(&name, &bytes, Error::Corrupt, |b| {
                        put32(b, at + place, wrong.to_bits());
                    });
                }
            }
        }
    }
}
