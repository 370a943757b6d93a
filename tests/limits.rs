//! What a build may cost: memory as `measure` says, from the number of triangles alone,
//! and work in proportion to it, whatever the triangles are.
#![allow(missing_docs)]

mod common;

use common::{section_7, structures};
use hug::build::{Control, measure};
use hug::{Error, Filter, Geometry, Hierarchy, Options, Quality, Scene, Structure};
use hug_kit::Mesh;
use hug_kit::random::Random;

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
                // Across a flat scene, in whose rows of voxels they meet one or two.
                "flat slivers" => {
                    let [x, y] = [a[0], a[1]].map(|x| 0.1 * x - 1.0);
                    [[x, y, 0.0], [-x, -y, 0.0], [1e-4 - x, -y, 0.0]]
                }
                _ => [a, [a[0] + 1e-3, a[1], a[2]], [a[0], a[1] + 1e-3, a[2]]],
            });
        }
        mesh
    };
    let kinds =
        ["huge", "stacked", "one point", "slivers", "flat slivers", "weave", "sheets", "scattered"];
    kinds.map(|k| (k, make(k))).into()
}

/// Units of work of a build, and its arena's size.
fn watch(mesh: &Mesh, options: &Options) -> (u64, usize) {
    let mut control = Control::default();
    let soup = [Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
    let scene = Scene::build_with(&soup, options, &mut control).expect("a valid soup");
    (control.work(), scene.view().bytes().len())
}

/// What docs/promises.md says that a build of `n` triangles can take, pass by pass, for
/// options without explicit counts.
fn bound(n: usize, options: &Options) -> f64 {
    let (n, m) = (n as f64, f64::from(options.max_refs));
    let hug = options.structure == Structure::Hug;
    let recursive = options.structure == Structure::Recursive;
    let links = if hug { 4.0 * n / f64::from(options.min_cluster) + 1.0 } else { 0.0 };
    // Voxels of a grid over k objects; coarser ones, that it was cut into before, count.
    let cube = |alpha: f32| 4.0 * f64::from(alpha).powi(3);
    let outer = cube(options.world_alpha.unwrap_or(match options.structure {
        Structure::Hug => std::f32::consts::SQRT_2,
        _ => options.alpha,
    }));
    let inner = cube(if options.fill_up { options.alpha.max(1.0) } else { options.alpha });
    let fill = |k: f64, voxels: f64| 12.0 * ((1.0 + 5.0 * m) * k + 3.0 * voxels);
    let gather = 2.0 * n;
    let mut sum = gather + fill(n + links, outer * (n + links) + 1.0);
    let (mut voxels, mut refs) = (outer * (n + links) + 1.0, m * (n + links));
    if hug {
        let levels = 16.0;
        // A cluster's corners are looked at once more where it may be turned.
        let cluster = (195.0 + 2.0 + levels) * n;
        let index = levels * fill(links, 4.0 * links + levels);
        // Once more, nested, if the paper's hierarchy has too many paths.
        let rounds = if options.hierarchy == Hierarchy::Paper { 2.0 } else { 1.0 };
        sum += cluster + rounds * (index + (1024.0 + levels) * links);
        sum += fill(n + links, inner * (n + links) + links);
        voxels += inner * (n + links) + links;
    }
    if recursive {
        refs *= 2.0;
        sum += fill(refs, inner * refs + refs) + refs;
        voxels += 2.0 * inner * n + refs;
    }
    if options.tree {
        sum += if options.quality == Quality::High {
            n * (187.0 + n.log2()) + 400.0
        } else {
            22.0 * n
        };
    }
    // Voxels and lists written, and voxels read again.
    sum + 4.0 * voxels + 2.0 * refs
}

/// Within the bound that follows from the code; and, by experience, at most 32 units for
/// each reference that is allowed, `max_refs` a triangle, whatever the soup.
#[test]
fn work_is_in_proportion_to_triangles() {
    for n in [2000, 20_000] {
        for (name, mesh) in adversarial(n) {
            let filled = [(0.1, 1), (0.4, 512)].map(|(alpha, maxp)| {
                let structure = Structure::Recursive;
                let fill_up = true;
                ("filled", Options { structure, alpha, maxp, fill_up, ..Options::default() })
            });
            let tree = Options { structure: Structure::Uniform, tree: true, ..Options::default() };
            let careful = Options { quality: Quality::High, ..tree };
            let others = filled.into_iter().chain([("tree", tree), ("careful tree", careful)]);
            for (kind, options) in structures().into_iter().chain(section_7()).chain(others) {
                let (work, bytes) = watch(&mesh, &options);
                let sizes = measure_count(n, &options);
                let most = bound(n, &options);
                let what = format!("{n} {name} in {kind}: {work} units, {bytes} bytes");
                println!("{what} of {most:.0} and {}", sizes.0);
                assert!(bytes <= sizes.0, "{what}");
                assert!(work as f64 <= most, "{what}");
                assert!(work <= 8192 + 32 * u64::from(options.max_refs) * n as u64, "{what}");
            }
        }
    }
}

/// Clusters of two levels in one small place of a large scene, where each of one could
/// be the parent of each of the other: the search for parents gives up in time, and what
/// is built is right.
#[test]
fn crowds_of_clusters_take_no_square() {
    let mut most = 0.0f64;
    for n in [500, 2000, 8000] {
        let mesh = crowd(n);
        for hierarchy in [Hierarchy::Nested, Hierarchy::Paper] {
            let mut at = [0.0; 15];
            at[..2].copy_from_slice(&[0.3, 10.0]);
            let filter = Filter::Thresholds { count: 2, at };
            let structure = Structure::Hug;
            let base = Options { structure, filter, hierarchy, ..Options::default() };
            let options = Options { min_cluster: 1, connectivity: 0.01, ..base };
            let (work, _) = watch(&mesh, &options);
            let each = work as f64 / mesh.indices.len() as f64;
            println!("{n} pairs in {hierarchy:?}: {each:.0} units a triangle");
            assert!(work as f64 <= bound(mesh.indices.len(), &options));
            most = most.max(each);
            let scene = common::build(&mesh, &options);
            for r in common::adversarial_rays(&mesh, 3, 4).iter().map(|(_, r)| common::ray(r)) {
                let brute = scene.view().intersect_brute(&r);
                common::assert_same(&scene.view().intersect(&r), &brute, &r, &"a crowd");
            }
        }
    }
    // 8000 children with 8000 candidates each would be some 4000.
    assert!(most > 100.0 && most < 2500.0, "{most}");
}

/// `n` triangles of length 1 side by side, as many of length 0.1 between them, and one
/// far away that makes the scene a million times as large.
fn crowd(n: usize) -> Mesh {
    let mut mesh = Mesh::default();
    let side = (n as f64).sqrt().ceil() as usize;
    for i in 0..n {
        let [x, y] = [i % side, i / side].map(|k| 1.25 * k as f32);
        mesh.push([[x, y, 0.0], [x + 0.7, y, 0.0], [x, y + 0.7, 0.0]]);
        mesh.push([[x + 0.8, y, 0.0], [x + 0.88, y, 0.0], [x + 0.8, y + 0.08, 0.0]]);
    }
    mesh.push([[1e8, 1e8, 1e8], [1e8 + 1e6, 1e8, 1e8], [1e8, 1e8 + 1e6, 1e8 + 1e6]]);
    mesh
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
        // Beyond this many AUTO's outermost grid grows no more.
        let most = 250_000;
        let (arena, scratch) = measure_count(most, &options);
        println!("{kind}: at most {} + {} bytes a triangle", arena / most, scratch / most);
        for n in [1, 1000, 10_000, 100_000, 1_000_000] {
            let (a, s) = measure_count(n, &options);
            let part = |whole: usize| (whole as u128 * n as u128 / most as u128) as usize;
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
