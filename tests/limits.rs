//! What a build may cost: memory as `measure` says, from the number of triangles alone,
//! and work in proportion to it, whatever the triangles are.
#![allow(missing_docs)]

mod common;

use common::{section_7, structures};
use hug::build::{Control, measure};
use hug::{Error, Geometry, Options, Scene};
use hug_kit::Mesh;
use hug_kit::random::Random;
use std::ops::ControlFlow;

/// Triangles or voxels between two reports of a build.
const STRIDE: usize = 4096;

/// Soups that no cutting separates, and one that any does.
fn adversarial(n: usize) -> Vec<(&'static str, Mesh)> {
    let mut random = Random::stream(81);
    let mut make = |kind: &str| {
        let mut mesh = Mesh::default();
        let mut z = 1.0f32;
        for _ in 0..n {
            z = z.next_up();
            let [a, b, c] = [(); 3].map(|()| random.direction().map(|x| x as f32));
            mesh.push(match kind {
                "huge" => [a, b, c].map(|v| v.map(|x| x * 1e6)),
                "stacked" => [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]],
                "one point" => [a, b, c].map(|v| v.map(|x| 1.0 + x * 2e-7)),
                "slivers" => [a, b, [b[0], b[1], b[2] + 1e-6]],
                // Rods along the three axes that cross in every projection and do not touch.
                "weave" => {
                    let k = random.below(3);
                    let mut rod = [a.map(|x| (x * 4e3).floor()); 3];
                    // Of different lengths, so that a filter of share 1 takes all but one.
                    let length = 1e4 + 100.0 * b[0];
                    rod[1][k] += length;
                    rod[2][k] += length;
                    rod[2][(k + 1) % 3] += 0.25;
                    for corner in &mut rod {
                        corner[k] -= 5e3;
                        corner[(k + 2) % 3] += k as f32 / 3.0;
                    }
                    rod
                }
                // Sheets, one upon the other, in no order.
                "sheets" => {
                    let z = random.below(n) as f32;
                    [[a[0], a[1], z], [a[0] + 4.0, a[1], z], [a[0], a[1] + 4.0, z + 0.5]]
                }
                _ => [a, [a[0] + 1e-3, a[1], a[2]], [a[0], a[1] + 1e-3, a[2]]],
            });
        }
        mesh
    };
    ["huge", "stacked", "one point", "slivers", "weave", "sheets", "scattered"]
        .map(|k| (k, make(k)))
        .into()
}

/// Units of work that a build reports, and its arena's size.
fn watch(mesh: &Mesh, options: &Options) -> (usize, usize) {
    let mut reports = 0;
    let mut progress = |_| {
        reports += 1;
        ControlFlow::Continue(())
    };
    let mut control = Control::default().with_progress(&mut progress);
    let soup = [Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
    let scene = Scene::build_with(&soup, options, &mut control).expect("a valid soup");
    (reports * STRIDE, scene.view().bytes().len())
}

/// At most 32 units for each reference that is allowed, `max_refs` a triangle, and some
/// for the passes themselves, whatever the soup.
#[test]
fn work_is_in_proportion_to_triangles() {
    for n in [2000, 20_000] {
        for (name, mesh) in adversarial(n) {
            for (kind, options) in structures().into_iter().chain(section_7()) {
                let (work, bytes) = watch(&mesh, &options);
                let sizes = measure_count(n, &options);
                let what = format!("{n} {name} in {kind}: {work} units, {bytes} bytes");
                println!("{what} of {}", sizes.0);
                assert!(bytes <= sizes.0, "{what}");
                assert!(work <= 64 * STRIDE + 32 * options.max_refs as usize * n, "{what}");
            }
        }
    }
}

/// Arena and scratch memory for so many triangles.
fn measure_count(n: usize, options: &Options) -> (usize, usize) {
    let indices = vec![[0; 3]; n];
    let sizes = measure(&[Geometry::from_mesh(&[[0.0; 3]], &indices)], options).expect("it fits");
    (sizes.arena, sizes.scratch)
}

/// ARCHITECTURE.md and docs/promises.md name these numbers.
#[test]
fn memory_is_linear_in_triangles() {
    let mut all = [&structures()[..], &section_7()].concat();
    all.push(("auto", Options::default()));
    for (kind, options) in all {
        let (arena, scratch) = measure_count(1_000_000, &options);
        println!(
            "{kind}: at most {} + {} bytes a triangle",
            arena / 1_000_000,
            scratch / 1_000_000
        );
        for n in [1, 1000, 10_000, 100_000] {
            let (a, s) = measure_count(n, &options);
            let part = |whole: usize| (whole as u128 * n as u128 / 1_000_000) as usize;
            assert!(a <= part(arena) + 8192, "{kind}: {n}: {a}");
            assert!(s <= part(scratch) + 8192, "{kind}: {n}: {s}");
        }
    }
}

/// Nothing overflows on the way to saying no.
#[test]
fn too_many_triangles_are_refused() {
    let indices = vec![[0u32; 3]; 1 << 20];
    let one = Geometry::from_mesh(&[[0.0; 3]], &indices);
    let many = vec![one; 1 << 10];
    for (kind, options) in structures() {
        assert_eq!(measure(&many, &options).err(), Some(Error::Limit), "{kind}");
        let error = Scene::build(&many, &options).err();
        assert_eq!(error, Some(Error::Limit), "{kind}");
        let most = measure(&many[1..], &options);
        assert!(most.is_ok(), "{kind}: {most:?}");
    }
}
