//! The tree of boxes: what it is made of, which bytes are none, and rays that it has to leave to
//! the grids. That hits are exact with it is what `matrix` and the others test: AUTO has one.
#![allow(missing_docs)]

mod any;
mod bytes;
#[path = "../common/mod.rs"]
mod common;
mod end;
mod work;

use bytes::{bounds, each_bound, kind, named, part_at, parts, steps, word_of};
use common::aligned::Aligned;
use common::layout::*;
use common::{adversarial_rays, assert_same, build, is_damage, ray};
use hug::build::Control;
use hug::{Counters, Error, Hit, Options, Quality, Ray, Scene, Stats, Structure, View};
use hug_kit::{Mesh, soups};

fn options() -> Options {
    Options { structure: Structure::Recursive, tree: true, ..Options::default() }
}

/// Trees of one build and of the other.
fn trees() -> [Options; 2] {
    [options(), Options { quality: Quality::High, ..options() }]
}

/// Clumps, triangles through one another, some in one place, and some each farther than the one
/// before.
fn meshes() -> [(&'static str, Mesh); 4] {
    let one = soups::clustered(1).triangle(0);
    let mut stacked = Mesh::default();
    (0..300).for_each(|_| stacked.push(one));
    // Splits take few off, again and again.
    let mut far = Mesh::default();
    for i in 0..70 {
        let x = 1.15f32.powi(i);
        far.push([[x, 0.0, 0.0], [x, x, 0.0], [x, 0.0, x]]);
    }
    [
        ("clumps", soups::clustered(2000)),
        ("tangle", soups::tangle(1, 900)),
        ("stack", stacked),
        ("row", far),
    ]
}

/// One in less memory.
fn compact() -> Options {
    Options { compact: true, ..options() }
}

/// All of them in each of these trees.
fn built() -> impl Iterator<Item = (&'static str, Mesh, Options)> {
    let trees = || trees().into_iter().chain([compact()]);
    meshes().into_iter().flat_map(move |(name, mesh)| trees().map(move |o| (name, mesh.clone(), o)))
}

#[test]
fn nodes_and_triangles_are_named_once_and_in_order() {
    for (name, mesh, options) in built() {
        let scene = build(&mesh, &options);
        let bytes = scene.view().bytes();
        let (mut node, mut triangle) = (1, 0);
        // Of a node by their places.
        let mut parts = parts(bytes);
        parts.sort_unstable_by_key(|&(number, _, word)| (number, word));
        for (_, _, word) in parts {
            let (place, len) = named(word);
            if len == IS_NODE {
                assert_eq!(place, node, "{name}");
                node += 1;
            } else if len > 0 {
                assert!(len <= 8, "{name}: a leaf of {len}");
                assert_eq!(place, triangle, "{name}");
                triangle += len;
            }
        }
        assert_eq!(node as usize, count(bytes, NODES), "{name}");
        assert_eq!(triangle as usize, count(bytes, TRIANGLES), "{name}");
        assert_eq!(
            Stats::of(&scene.view()).node_bytes,
            u64::from(node) * kind(bytes).size as u64,
            "{name}"
        );
    }
}

/// Where any hit will do, it is most likely to be in the largest part.
#[test]
fn the_largest_part_is_first() {
    for (name, mesh, options) in built().filter(|(.., options)| !options.compact) {
        let scene = build(&mesh, &options);
        let bytes = scene.view().bytes();
        let mut last = (0, f64::INFINITY);
        for (number, part, word) in parts(bytes) {
            let b = bounds(bytes, number, part).map(f64::from);
            let [x, y, z] = [b[1] - b[0], b[3] - b[2], b[5] - b[4]];
            let surface = if word == 0 { -1.0 } else { x * y + y * z + z * x };
            assert!(number != last.0 || surface <= last.1, "{name}: node {number}, part {part}");
            last = (number, surface);
        }
    }
}

/// The box around the triangles of a part, in the tree's coordinates.
fn around(bytes: &[u8], word: u32) -> [f64; 6] {
    let unit = f64::from_bits(get64(bytes, UNIT));
    let lower = [0, 1, 2].map(|axis| f64::from(f32::from_bits(get32(bytes, LOWER + 4 * axis))));
    let (place, len) = named(word);
    let place = place as usize;
    let mut all = [f64::INFINITY, f64::NEG_INFINITY].repeat(3);
    let mut add = |axis: usize, [lo, hi]: [f64; 2]| {
        all[2 * axis] = all[2 * axis].min(lo);
        all[2 * axis + 1] = all[2 * axis + 1].max(hi);
    };
    if len == IS_NODE {
        for part in 0..8 {
            let below = around(bytes, get32(bytes, part_at(bytes, place, part)));
            (0..3).for_each(|axis| add(axis, [below[2 * axis], below[2 * axis + 1]]));
        }
        return all.try_into().expect("six");
    }
    for triangle in place..place + len as usize {
        let from = record(bytes, TRIANGLES, triangle);
        for corner in COORDINATES {
            let axis = corner / 16;
            let x = f64::from(f32::from_bits(get32(bytes, from + corner)));
            let x = (x - lower[axis]) * unit;
            add(axis, [x, x]);
        }
    }
    all.try_into().expect("six")
}

#[test]
fn boxes_hold_what_is_in_them() {
    for (name, mesh, options) in built() {
        let scene = build(&mesh, &options);
        let bytes = scene.view().bytes();
        for (number, part, word) in parts(bytes) {
            let [held, within] = [bounds(bytes, number, part).map(f64::from), around(bytes, word)];
            for (row, (held, within)) in held.into_iter().zip(within).enumerate() {
                let held = if row % 2 == 0 { held <= within } else { held >= within };
                assert!(held, "{name}: node {number}, part {part}");
            }
            let inverted = (0..3).all(|k| held[2 * k] > held[2 * k + 1]);
            assert_eq!(inverted, word == 0, "{name}: node {number}, part {part}");
        }
    }
}

/// Boxes of a compact tree are those of the other, rounded outward by a step or what an `f32` adds to
/// that; and a step is as short as a byte allows, or a fraction of what a descent allows for.
#[test]
fn boxes_in_less_are_nearly_those_in_full() {
    for (name, mesh) in meshes() {
        let scenes = [options(), compact()].map(|options| build(&mesh, &options));
        let [full, less] = scenes.each_ref().map(|scene| scene.view().bytes());
        assert_eq!(parts(full), parts(less), "{name}");
        assert!(full.len() > less.len(), "{name}");
        let mut ends = vec![[f32::INFINITY, f32::NEG_INFINITY].repeat(3); count(full, NODES)];
        for (number, part, _) in parts(full).into_iter().filter(|&(.., word)| word != 0) {
            let [small, large] = [full, less].map(|bytes| bounds(bytes, number, part));
            for row in 0..6 {
                let [_, step] = steps(less, number, row / 2);
                let end = &mut ends[number][row];
                let outward = if row % 2 == 0 {
                    *end = end.min(small[row]);
                    small[row] - large[row]
                } else {
                    *end = end.max(small[row]);
                    large[row] - small[row]
                };
                assert!((0.0..2.0 * step).contains(&outward), "{name}: {outward} of {step}");
            }
        }
        for (number, ends) in ends.iter().enumerate() {
            for axis in 0..3 {
                let [_, step] = steps(less, number, axis);
                let side = f64::from(ends[2 * axis + 1]) - f64::from(ends[2 * axis]);
                let least = 1.0 / f64::from(1 << 24);
                assert!(f64::from(step) < (side / 127.0).max(1.5 * least), "{name}: {side}");
            }
        }
    }
}

#[test]
fn what_has_a_tree() {
    let mesh = soups::clustered(500);
    let nodes = |options: &Options| count(build(&mesh, options).view().bytes(), NODES);
    assert!(nodes(&Options::default()) > 0);
    assert!(nodes(&Options { quality: Quality::High, ..Options::default() }) > 0);
    assert_eq!(nodes(&Options { quality: Quality::Fast, ..Options::default() }), 0);
    assert!(nodes(&Options { compact: true, ..Options::default() }) > 0);
    for structure in [Structure::Uniform, Structure::Recursive] {
        assert_eq!(nodes(&Options { structure, ..Options::default() }), 0);
        assert!(nodes(&Options { structure, ..options() }) > 0);
    }
    assert_eq!(nodes(&Options { structure: Structure::Hug, ..options() }), 0);
    // Of no nodes there is one kind.
    let fast = Options { quality: Quality::Fast, compact: true, ..Options::default() };
    let without = Aligned::copy(build(&mesh, &fast).view().bytes());
    assert_eq!((count(&without, NODES), View::open(&without).err()), (0, None));
    refused(&without, QUANTIZED, 1);
    // Fewer triangles than a leaf takes.
    for n in 0..8 {
        let scene = build(&soups::clustered(n), &options());
        assert_eq!(count(scene.view().bytes(), NODES), 0, "{n}");
    }
}

/// Rays from anywhere, of any length: those that the tree does not take get their hits too.
#[test]
fn rays_that_walk() {
    for (name, mesh, options) in built() {
        let scene = build(&mesh, &options);
        let view = scene.view();
        let lower = view.bounds().0;
        let side = 1.0 / f64::from_bits(get64(view.bytes(), UNIT));
        for (_, one) in adversarial_rays(&mesh, 5, 100) {
            let one = ray(&one);
            let check = |ray: &Ray| {
                let expected = view.intersect_brute(ray);
                assert_same(&view.intersect(ray), &expected, ray, &name);
                assert_eq!(view.occluded(ray), expected.is_hit(), "{name}: {ray:?}");
            };
            for scale in [1e-30, 1e-12, 0.5 / 1048576.0, 1e-6, 1.0, 1e6, 2e6, 1e12, 1e30] {
                check(&Ray::new(one.org, one.dir.map(|d| d * scale)));
            }
            // Towards where the ray begins, along an axis or nearly, from this and that side of
            // 1024 units before the lowest corner, where the tree ends.
            for axis in 0..3 {
                for far in [1000.0, 1023.0, 1023.999, 1024.001, 1025.0, 1e6] {
                    let (mut org, mut dir) = (one.org, [1e-4; 3]);
                    org[axis] = (f64::from(lower[axis]) - far * side) as f32;
                    dir[axis] = 1.0;
                    check(&Ray::new(org, dir));
                }
            }
        }
    }
}

/// Boxes that nothing meets hide all from rays on their own and from streams, so that is where these
/// look; what is counted looks in the grids.
#[test]
fn who_takes_the_tree() {
    let mesh = soups::clustered(500);
    let mut forged = Aligned::copy(build(&mesh, &options()).view().bytes());
    each_bound(&mut forged, |bound, end| {
        let never = [f32::INFINITY, f32::NEG_INFINITY][end];
        bound.copy_from_slice(&never.to_le_bytes());
    });
    let view = View::open(&forged).expect("bounds are not checked");
    let (mut hits, mut rays) = ([0; 4], Vec::new());
    for (_, one) in adversarial_rays(&mesh, 7, 50) {
        let one = ray(&one);
        rays.push(one);
        let mut counters = Counters::default();
        let counted = view.intersect_counted(&one, &mut counters);
        hits[0] += usize::from(counted.is_hit());
        hits[1] += usize::from(view.intersect(&one).is_hit());
    }
    let mut occluded = vec![false; rays.len()];
    view.occluded_n(&rays, &mut occluded);
    hits[2] = occluded.iter().filter(|&&hit| hit).count();
    let mut closest = vec![Hit::miss(7.0); rays.len()];
    view.intersect_n(&rays, &mut closest);
    hits[3] = closest.iter().filter(|hit| hit.is_hit()).count();
    assert!(hits[0] > 100, "{hits:?}");
    // The portable code of these processors has no descent.
    let descends = hug::isa() != hug::Isa::Portable;
    for some in &hits[1..] {
        assert!(if descends { 2 * some < hits[0] } else { hits[0] == *some }, "{hits:?}");
    }
}

/// Asserts that the bytes no longer open once a word was replaced.
#[track_caller]
fn refused(bytes: &Aligned, at: usize, wrong: u32) {
    let mut damaged = bytes.clone();
    put32(&mut damaged, at, wrong);
    if damaged[..] != bytes[..] {
        let error = View::open(&damaged).err();
        assert!(is_damage(error), "{wrong:x} at {at}: {error:?}");
    }
}

#[test]
fn damaged_parts_are_found() {
    for ((_, mesh), options) in meshes().into_iter().zip([options(), compact()].repeat(2)) {
        let bytes = Aligned::copy(build(&mesh, &options).view().bytes());
        assert_eq!(View::open(&bytes).err(), None);
        let (nodes, triangles) = (count(&bytes, NODES) as u32, count(&bytes, TRIANGLES) as u32);
        for (number, i, word) in parts(&bytes) {
            let at = part_at(&bytes, number, i);
            let (place, len) = named(word);
            for wrong in 0..=15 {
                refused(&bytes, at, word & !15 | wrong);
                refused(&bytes, at, word_of(place, wrong));
            }
            refused(&bytes, at, word ^ 16);
            for wrong in [0, number as u32, place + 1, place.wrapping_sub(1), nodes, triangles] {
                if wrong != place {
                    refused(&bytes, at, word_of(wrong, len));
                }
            }
            refused(&bytes, at, u32::MAX);
        }
        for number in 0..nodes as usize {
            for place in kind(&bytes).unused {
                let mut damaged = bytes.clone();
                damaged[record(&bytes, NODES, number) + place] = 1;
                assert_eq!(View::open(&damaged).err(), Some(Error::Corrupt));
            }
        }
        for place in RESERVED.step_by(4) {
            refused(&bytes, place, 1);
        }
        // The other kind of nodes, and one that there is not.
        for wrong in (0..3).chain([u32::MAX]) {
            refused(&bytes, QUANTIZED, wrong);
            refused(&bytes, QUANTIZED + 4, wrong);
        }
        bounds_may_be_anything(&mesh, &bytes);
    }
}

/// Every query still ends, and reads nothing else.
fn bounds_may_be_anything(mesh: &Mesh, bytes: &Aligned) {
    let look = |forged: &Aligned| {
        let view = View::open(forged).expect("bounds are not checked");
        for (_, one) in adversarial_rays(mesh, 6, 10) {
            let one = ray(&one);
            std::hint::black_box((view.intersect(&one), view.occluded(&one)));
        }
        let rays: Vec<Ray> =
            adversarial_rays(mesh, 6, 10).iter().map(|(_, one)| ray(one)).collect();
        let mut hits = vec![Hit::miss(7.0); rays.len()];
        view.intersect_n(&rays, &mut hits);
        std::hint::black_box(hits);
    };
    let mut forged = bytes.clone();
    let wrong = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, f32::MAX];
    if kind(bytes).bound == 4 {
        for wrong in wrong {
            each_bound(&mut forged, |bound, _| bound.copy_from_slice(&wrong.to_le_bytes()));
            look(&forged);
        }
        return;
    }
    for ends in [[0, 0], [0, 255], [255, 0], [1, 255], [255, 255]] {
        each_bound(&mut forged, |bound, end| bound[0] = ends[end]);
        for exponent in [0, 1, 127, 254, 255] {
            for origin in wrong.into_iter().chain([f32::MIN]) {
                for number in 0..count(bytes, NODES) {
                    let at = record(bytes, NODES, number);
                    (0..3).for_each(|axis| put_f32(&mut forged, at + ORIGIN + 4 * axis, origin));
                    forged[at + EXPONENTS..][..3].fill(exponent);
                }
                look(&forged);
            }
        }
    }
}

/// A chain of nodes, each under the one before: only so many may follow one another.
#[test]
fn depth_is_bounded() {
    let chain = |nodes: usize| {
        let bytes = build(&soups::clustered(8), &options()).view().bytes().to_vec();
        let start = get64(&bytes, NODES) as usize;
        // Eight triangles can be read from the last one on.
        let size = (start + nodes * NODE).max(record(&bytes, TRIANGLES, 15).next_multiple_of(64));
        let mut forged = Aligned::filled(size, 0);
        forged[..start].copy_from_slice(&bytes[..start]);
        put64(&mut forged, NODES + 8, nodes as u64);
        put64(&mut forged, BYTES, size as u64);
        // A leaf of all triangles.
        let last = 8;
        for number in 0..nodes {
            let word = if number + 1 < nodes { word_of(number as u32 + 1, IS_NODE) } else { last };
            put32(&mut forged, start + number * NODE + PARTS.start, word);
        }
        View::open(&forged).err()
    };
    assert_eq!(chain(1), None);
    assert_eq!(chain(64), None);
    assert_eq!(chain(65), Some(Error::Corrupt));
}
