//! The tree of boxes: what it is made of, which bytes are none, and rays that it has to leave to
//! the grids. That hits are exact with it is what `matrix` and the others test: AUTO has one.
#![allow(missing_docs)]

mod common;

use common::aligned::Aligned;
use common::layout::*;
use common::{adversarial_rays, assert_same, build, is_damage, ray};
use hug::build::Control;
use hug::{Error, Options, Quality, Ray, Scene, Stats, Structure, View};
use hug_kit::{Mesh, soups};

fn options() -> Options {
    Options { structure: Structure::Recursive, tree: true, ..Options::default() }
}

/// A soup of boxes of all sizes, one of triangles that a plane cannot part, one in a row.
fn meshes() -> [(&'static str, Mesh); 4] {
    let one = soups::clustered(1).triangle(0);
    let mut stacked = Mesh::default();
    (0..300).for_each(|_| stacked.push(one));
    // Each ten times as far as the one before: splits that take one off, again and again.
    let mut far = Mesh::default();
    for i in 0..70 {
        let x = 1.8f32.powi(i);
        far.push([[x, 0.0, 0.0], [x, x, 0.0], [x, 0.0, x]]);
    }
    [
        ("clumps", soups::clustered(2000)),
        ("tangle", soups::tangle(1, 900)),
        ("stack", stacked),
        ("row", far),
    ]
}

/// The parts of all nodes, in order: number of the node, where the word is, what it says.
fn parts(bytes: &[u8]) -> Vec<(usize, usize, u32)> {
    let nodes = 0..count(bytes, NODES);
    nodes
        .flat_map(|number| {
            let at = record(bytes, NODES, number);
            PARTS.step_by(4).map(move |place| (number, at + place))
        })
        .map(|(number, at)| (number, at, get32(bytes, at)))
        .collect()
}

#[test]
fn nodes_and_triangles_are_named_once_and_in_order() {
    for (name, mesh) in meshes() {
        let scene = build(&mesh, &options());
        let bytes = scene.view().bytes();
        let (mut node, mut triangle) = (1, 0);
        for (_, _, word) in parts(bytes) {
            let (place, len) = (word >> 4, word & 15);
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
        assert_eq!(Stats::of(&scene.view()).node_bytes, node as u64 * NODE as u64, "{name}");
    }
}

#[test]
fn boxes_hold_their_triangles() {
    for (name, mesh) in meshes() {
        let scene = build(&mesh, &options());
        let bytes = scene.view().bytes();
        let unit = f64::from_bits(get64(bytes, UNIT));
        let lower = scene.view().bounds().0;
        for (number, at, word) in parts(bytes) {
            let part = (at - record(bytes, NODES, number) - PARTS.start) / 4;
            let bound = |row: usize| {
                let place = record(bytes, NODES, number) + 32 * row + 4 * part;
                f64::from(f32::from_bits(get32(bytes, place)))
            };
            let leaf = if word & 15 == IS_NODE { 0 } else { word & 15 };
            for triangle in (word >> 4)..(word >> 4) + leaf {
                let from = record(bytes, TRIANGLES, triangle as usize);
                for place in COORDINATES {
                    let axis = place / 16;
                    let x = f64::from(f32::from_bits(get32(bytes, from + place)));
                    let x = (x - f64::from(lower[axis])) * unit;
                    assert!(bound(2 * axis) <= x && x <= bound(2 * axis + 1), "{name}: {x}");
                }
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
    assert_eq!(nodes(&Options { compact: true, ..Options::default() }), 0);
    for structure in [Structure::Uniform, Structure::Recursive] {
        assert_eq!(nodes(&Options { structure, ..Options::default() }), 0);
        assert!(nodes(&Options { structure, ..options() }) > 0);
    }
    assert_eq!(nodes(&Options { structure: Structure::Hug, ..options() }), 0);
    // Fewer triangles than a leaf takes.
    for n in 0..8 {
        let scene = build(&soups::clustered(n), &options());
        assert_eq!(count(scene.view().bytes(), NODES), 0, "{n}");
    }
}

/// Rays from anywhere, of any length: those that the tree does not take get their hits too.
#[test]
fn rays_that_walk() {
    for (name, mesh) in meshes() {
        let scene = build(&mesh, &options());
        let view = scene.view();
        let (lower, upper) = view.bounds();
        let side = (0..3).map(|k| upper[k] - lower[k]).fold(0.0, f32::max);
        for (_, one) in adversarial_rays(&mesh, 5, 300) {
            let [org, dir] = [one.org, one.dir];
            for scale in [1e-30, 1e-12, 1e-6, 1.0, 1e6, 1e12, 1e30] {
                let scaled = Ray::new(org, dir.map(|d| d * scale));
                let expected = view.intersect_brute(&scaled);
                assert_same(&view.intersect(&scaled), &expected, &scaled, &name);
            }
            for far in [1e2, 1023.0, 1025.0, 1e6, 1e12] {
                let moved = [0, 1, 2].map(|k| org[k] - dir[k] * (far * side));
                let moved = Ray::new(moved, dir);
                let expected = view.intersect_brute(&moved);
                assert_same(&view.intersect(&moved), &expected, &moved, &name);
                assert_eq!(view.occluded(&moved), view.intersect(&moved).is_hit(), "{name}");
            }
        }
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
    for (_, mesh) in meshes() {
        let bytes = Aligned::copy(build(&mesh, &options()).view().bytes());
        assert_eq!(View::open(&bytes).err(), None);
        let (nodes, triangles) = (count(&bytes, NODES) as u32, count(&bytes, TRIANGLES) as u32);
        for (number, at, word) in parts(&bytes) {
            let (place, len) = (word >> 4, word & 15);
            for wrong in 0..=15 {
                refused(&bytes, at, place << 4 | wrong);
            }
            for wrong in [0, number as u32, place + 1, place.wrapping_sub(1), nodes, triangles] {
                if wrong != place {
                    refused(&bytes, at, wrong << 4 | len);
                }
            }
            refused(&bytes, at, u32::MAX);
        }
        for number in 0..nodes as usize {
            for place in UNUSED.step_by(4) {
                refused(&bytes, record(&bytes, NODES, number) + place, 1);
            }
        }
        for place in RESERVED.step_by(4) {
            refused(&bytes, place, 1);
        }
        // Bounds may be anything: every query still ends, and reads nothing else.
        for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0] {
            let mut forged = bytes.clone();
            for number in 0..nodes as usize {
                for place in (0..PARTS.start).step_by(4) {
                    let at = record(&forged, NODES, number) + place;
                    put32(&mut forged, at, wrong.to_bits());
                }
            }
            let view = View::open(&forged).expect("bounds are not checked");
            for (_, one) in adversarial_rays(&mesh, 6, 50) {
                let one = ray(&one);
                std::hint::black_box((view.intersect(&one), view.occluded(&one)));
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
        let mut forged = Aligned::filled(start + nodes * NODE, 0);
        forged[..start].copy_from_slice(&bytes[..start]);
        put64(&mut forged, NODES + 8, nodes as u64);
        put64(&mut forged, BYTES, (start + nodes * NODE) as u64);
        let last = get32(&bytes, start + PARTS.start);
        for number in 0..nodes {
            let word = if number + 1 < nodes { (number as u32 + 1) << 4 | IS_NODE } else { last };
            put32(&mut forged, start + number * NODE + PARTS.start, word);
        }
        View::open(&forged).err()
    };
    assert_eq!(chain(1), None);
    assert_eq!(chain(64), None);
    assert_eq!(chain(65), Some(Error::Corrupt));
}

#[test]
fn work_is_bounded_where_no_split_is_good() {
    // Triangles each twice as large as the one before, about one point: halves are as good as any.
    let mut nested = Mesh::default();
    for i in 0..120 {
        let size = 2f32.powi(i - 60);
        nested.push([[-size, 0.0, 0.0], [size, 0.0, 0.0], [0.0, size, size]]);
    }
    for (name, mesh) in meshes().into_iter().chain([("nested", nested)]) {
        let mut control = Control::default();
        let soup = [hug::Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
        let with = Scene::build_with(&soup, &options(), &mut control).expect("a scene");
        assert_eq!(View::open(with.view().bytes()).err(), None, "{name}");
        let with = control.work();
        let without = Options { tree: false, ..options() };
        Scene::build_with(&soup, &without, &mut control).expect("a scene");
        let n = mesh.indices.len() as u64;
        let most = n * (36 + u64::from(n.ilog2()));
        assert!(with <= control.work() + n + most, "{name}: {with}");
    }
}
