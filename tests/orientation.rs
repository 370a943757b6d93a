//! Turned grids (section 7.2): they are there where boxes are the better for it, lie where
//! they say, and change no hit, wherever rays come from.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, assert_same, build, ray};
use hug::{
    Geometry, GridFrame, GridShape, Options, Orientation, Probe, Ray, Scene, Structure, View,
};
use hug_kit::Mesh;
use hug_kit::random::Random;

/// Long thin bricks that lie every way, each of many small triangles, and a floor.
fn bricks(scale: f32, shift: f32) -> Mesh {
    let mut random = Random::stream(71);
    let mut mesh = Mesh { vertices: Vec::new(), indices: Vec::new() };
    for i in 0..40 {
        let mut unit = || random.range(-1.0, 1.0);
        let (along, up) = ([unit(), unit(), unit()], [unit(), unit(), unit()]);
        let x = scaled(along, 1.0 / length(along));
        let y = cross(x, up);
        let y = scaled(y, 1.0 / length(y));
        let z = cross(x, y);
        let middle = [f64::from(i % 4) * 3.0, f64::from(i / 4 % 4) * 3.0, f64::from(i / 16) * 3.0];
        // A tube of four sides, cut into slices.
        let at = |slice: u32, side: u32| {
            let [a, b] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]][side as usize % 4];
            let s = f64::from(slice) / 8.0 - 1.0;
            [0, 1, 2].map(|k| {
                let place = middle[k] + x[k] * s + y[k] * a * 0.06 + z[k] * b * 0.06;
                place as f32 * scale + shift
            })
        };
        for slice in 0..16 {
            for side in 0..4 {
                let first = mesh.vertices.len() as u32;
                let corners =
                    [(slice, side), (slice + 1, side), (slice + 1, side + 1), (slice, side + 1)];
                mesh.vertices.extend(corners.map(|(i, j)| at(i, j)));
                mesh.indices.push([first, first + 1, first + 2]);
                mesh.indices.push([first, first + 2, first + 3]);
            }
        }
    }
    let first = mesh.vertices.len() as u32;
    let corner = |x: f32, y: f32| [x * scale + shift, y * scale + shift, -2.0 * scale + shift];
    mesh.vertices.extend([corner(-9.0, -9.0), corner(20.0, -9.0), corner(-9.0, 20.0)]);
    mesh.indices.push([first, first + 1, first + 2]);
    mesh
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: [f64; 3]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn scaled(a: [f64; 3], by: f64) -> [f64; 3] {
    a.map(|x| x * by)
}

fn options(orientation: Orientation, turn_below: f32) -> Options {
    Options { structure: Structure::Hug, orientation, turn_below, ..Options::default() }
}

fn shapes(view: &View<'_>) -> Vec<GridShape> {
    (0..view.grid_count()).filter_map(|i| view.grid_shape(i)).collect()
}

fn surface(shape: &GridShape) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|k| shape.upper[k] - shape.lower[k]);
    2.0 * (x * y + y * z + z * x)
}

fn turned(scene: &Scene) -> usize {
    shapes(&scene.view()).iter().filter(|shape| shape.frame.is_some()).count()
}

#[test]
fn tilted_clusters_are_turned() {
    let mesh = bricks(1.0, 0.0);
    let aligned = build(&mesh, &options(Orientation::Aligned, 0.8));
    assert_eq!(turned(&aligned), 0);
    let before = shapes(&aligned.view());
    assert!(before.len() > 30, "{}", before.len());
    for orientation in [Orientation::Vertices, Orientation::Hull, Orientation::Search] {
        let scene = build(&mesh, &options(orientation, 0.8));
        let after = shapes(&scene.view());
        // The same clusters, in the same order.
        assert_eq!(before.len(), after.len());
        assert!(turned(&scene) > before.len() / 2, "{orientation:?}: {}", turned(&scene));
        for (a, b) in before.iter().zip(&after) {
            let share = surface(b) / surface(a);
            assert!(b.frame.is_none() || share < 0.81, "{orientation:?}: {share}");
            assert!(b.frame.is_some() || a == b);
        }
    }
}

#[test]
fn frames_are_rotations() {
    let scene = build(&bricks(1.0, 0.0), &options(Orientation::Search, 1e6));
    for GridFrame { axes, .. } in shapes(&scene.view()).iter().filter_map(|shape| shape.frame) {
        for i in 0..3 {
            for j in 0..3 {
                let dot: f64 = (0..3).map(|k| axes[i][k] * axes[j][k]).sum();
                assert!((dot - f64::from(u8::from(i == j))).abs() < 1e-14, "{axes:?}");
            }
        }
    }
}

#[test]
fn a_share_that_none_reaches_turns_none() {
    let mesh = bricks(1.0, 0.0);
    let plain = build(&mesh, &options(Orientation::Aligned, 0.8));
    let never = build(&mesh, &options(Orientation::Search, 1e-6));
    assert!(plain.view().bytes() == never.view().bytes());
}

/// Where places cannot be told in turned coordinates, boxes stay as they are.
#[test]
fn far_from_the_origin_none_is_turned() {
    let far = build(&bricks(1e-3, 1e6), &options(Orientation::Search, 1e6));
    assert_eq!(turned(&far), 0);
    let near = build(&bricks(1e-3, 1.0), &options(Orientation::Search, 1e6));
    assert!(turned(&near) > 0);
}

#[test]
fn hits_are_those_of_brute_force() {
    for (scale, shift) in [(1.0, 0.0), (1e-3, 5.0), (1e12, -4e12), (1e-20, 0.0)] {
        let mesh = bricks(scale, shift);
        let mut rays: Vec<Ray> =
            adversarial_rays(&mesh, 3, 60).iter().map(|(_, r)| ray(r)).collect();
        // From farther and farther away, to the middle of each brick's first triangle.
        for (i, triangle) in mesh.indices.iter().step_by(128).enumerate() {
            let corners = triangle.map(|v| mesh.vertices[v as usize]);
            let to = [0, 1, 2].map(|k| (corners[0][k] + corners[1][k] + corners[2][k]) / 3.0);
            let way = [0.3, -1.0, 0.7 - i as f32 * 0.1];
            for far in [1e2, 1e6, 1e10, 1e14f32] {
                let org = [0, 1, 2].map(|k| to[k] + way[k] * scale * far);
                rays.push(Ray::new(org, [0, 1, 2].map(|k| to[k] - org[k])));
            }
        }
        for orientation in [Orientation::Vertices, Orientation::Hull, Orientation::Search] {
            let scene = build(&mesh, &options(orientation, 1e6));
            let view = scene.view();
            assert!(turned(&scene) > 30 || scale < 1e-2, "{scale}: {}", turned(&scene));
            let (mut hits, mut met) = (vec![hug::Hit::miss(0.0); rays.len()], 0);
            view.intersect_n(&rays, &mut hits);
            for (r, hit) in rays.iter().zip(&hits) {
                let expected = view.intersect_brute(r);
                met += u32::from(expected.is_hit());
                assert_same(&view.intersect(r), &expected, r, &"single");
                assert_same(hit, &expected, r, &"stream");
                assert_eq!(view.occluded(r), expected.is_hit());
            }
            assert!(met > 100, "{met}");
            for &[x, y, z] in mesh.vertices.iter().step_by(301) {
                let probe = Probe::new([x + scale, y - 0.5 * scale, z], f32::MAX);
                let (found, expected) =
                    (view.closest_point(&probe), view.closest_point_brute(&probe));
                assert_eq!(found, expected, "{probe:?}");
            }
        }
    }
}

#[test]
fn a_saved_one_opens_and_counts_the_same() {
    let mesh = bricks(1.0, 0.0);
    let scene = build(&mesh, &options(Orientation::Search, 0.8));
    let copy = common::aligned::Aligned::copy(scene.view().bytes());
    let view = View::open(&copy).expect("an arena that a build wrote");
    let (mut a, mut b) = (hug::Counters::default(), hug::Counters::default());
    for r in adversarial_rays(&mesh, 3, 30).iter().map(|(_, r)| ray(r)) {
        assert_eq!(
            view.intersect_counted(&r, &mut a).prim,
            scene.view().intersect_counted(&r, &mut b).prim
        );
    }
    assert_eq!(a, b);
    assert!(a.grids > 0);
    let geometry = [Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
    let sizes = hug::build::measure(&geometry, &options(Orientation::Search, 0.8)).expect("sizes");
    assert!(copy.len() <= sizes.arena);
}
