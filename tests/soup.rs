//! The forms a soup can come in: strides, indices, several geometries, and what
//! is left out of it.
#![allow(missing_docs)]

mod common;

use common::everywhere::Everywhere;
use common::structures;
use hug::{Error, Geometry, Indices, Options, Ray, Scene, Stats};
use hug_kit::soups;

/// Positions at every `stride` floats; what lies between is not for the library,
/// and the list ends right after the last z.
fn spread(vertices: &[[f32; 3]], stride: usize) -> Vec<f32> {
    let mut coords = vec![f32::NAN; vertices.len() * stride - (stride - 3)];
    for (to, from) in coords.chunks_mut(stride).zip(vertices) {
        to[..3].copy_from_slice(from);
    }
    coords
}

fn bytes(soup: &[Geometry<'_>], options: &Options) -> Vec<u8> {
    let scene = Scene::build(soup, options).expect("the soup is valid");
    scene.view().bytes().to_vec()
}

#[test]
fn every_form_of_a_mesh_makes_the_same_bytes() {
    let mesh = soups::bumpy_sphere(12, 1.0, [0.0; 3]).mesh;
    let long = mesh.indices.as_flattened();
    let short: Vec<u16> = long.iter().map(|&i| i as u16).collect();
    let corners: Vec<[f32; 3]> = mesh.triangles().flatten().collect();
    for (name, options) in structures() {
        let expected = bytes(&[Geometry::from_mesh(&mesh.vertices, &mesh.indices)], &options);
        for stride in [3, 4, 5, 8, 100] {
            let (shared, plain) = (spread(&mesh.vertices, stride), spread(&corners, stride));
            let forms = [
                (&shared, Indices::U16(&short)),
                (&shared, Indices::U32(long)),
                (&plain, Indices::None),
            ];
            for (coords, indices) in forms {
                let form = Geometry::new(coords, stride, indices).expect("a valid geometry");
                let kind = &format!("{indices:?}")[..3];
                assert!(bytes(&[form], &options) == expected, "{name}, {stride} floats, {kind}");
            }
        }
    }
}

/// The last vertex is whole once its z is there; a vertex cut off before is none.
#[test]
fn the_last_vertex_ends_with_its_z() {
    let coords: Vec<f32> = (0..16).map(|i| (i * i % 7) as f32).collect();
    let vertices = |floats: usize, last: u32| {
        let indices = [0, 1, last];
        let one = Geometry::new(&coords[..floats], 4, Indices::U32(&indices))?;
        Scene::build(&[one], &Options::default()).map(|_| ())
    };
    assert_eq!(vertices(11, 2), Ok(()));
    assert_eq!(vertices(10, 2), Err(Error::IndexRange));
    assert_eq!(vertices(15, 3), Ok(()));
    assert_eq!(vertices(14, 3), Err(Error::IndexRange));
}

#[test]
fn malformed_geometries_are_refused() {
    let coords = [0.0; 12];
    let refuse = |stride, indices| Geometry::new(&coords, stride, indices).err();
    for stride in 0..3 {
        assert_eq!(refuse(stride, Indices::None), Some(Error::Alignment));
    }
    assert_eq!(refuse(3, Indices::None), Some(Error::InvalidValue), "four vertices");
    assert_eq!(refuse(3, Indices::U16(&[0; 4])), Some(Error::InvalidValue));
    assert_eq!(refuse(3, Indices::U32(&[0; 5])), Some(Error::InvalidValue));
    assert_eq!(refuse(3, Indices::U32(&[])), None);
}

#[test]
fn an_index_out_of_range_is_an_error() {
    let coords = [0.0; 12];
    for (name, options) in structures() {
        for place in 0..6 {
            for index in [4, u32::MAX] {
                let mut long = [0, 1, 2, 1, 2, 3];
                long[place] = index;
                let short = long.map(|i| i as u16);
                for indices in [Indices::U32(&long), Indices::U16(&short)] {
                    let soup = Geometry::new(&coords, 3, indices).expect("whole triangles");
                    let error = Scene::build(&[soup], &options).err();
                    assert_eq!(error, Some(Error::IndexRange), "{name}: {indices:?}");
                }
            }
        }
    }
}

/// Whatever the form of each, ids are places in the list given.
#[test]
fn geometries_keep_their_ids_and_masks() {
    let layer = |z: f32| spread(&[[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]], 5);
    let layers = [layer(0.0), layer(1.0), layer(2.0), layer(3.0)];
    let of = |i: usize, indices| Geometry::new(&layers[i], 5, indices).expect("one triangle");
    let nothing = Geometry::from_mesh(&[], &[]);
    let soup = Everywhere::build(&[
        of(2, Indices::U16(&[0, 1, 2])).with_mask(1),
        nothing,
        of(0, Indices::None).with_mask(2),
        // Twice, the first time without area.
        of(3, Indices::U32(&[1, 1, 2, 2, 1, 0])).with_mask(4),
        of(1, Indices::U32(&[1, 2, 0])).with_mask(8),
    ]);
    let down = Ray::new([0.25, 0.25, 4.0], [0.0, 0.0, -1.0]);
    soup.hit(&down, 1.0, 3, 1);
    for (mask, t, geom, prim) in [(1, 2.0, 0, 0), (2, 4.0, 2, 0), (4, 1.0, 3, 1), (8, 3.0, 4, 0)] {
        soup.hit(&Ray { mask, ..down }, t, geom, prim);
    }
    soup.hit(&Ray { mask: 1 | 8, ..down }, 2.0, 0, 0);
    soup.miss(&Ray { mask: 16, ..down });
}

#[test]
fn triangles_that_cannot_be_hit_are_dropped_and_counted() {
    let (nan, inf) = (f32::NAN, f32::INFINITY);
    let vertices = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [2.0, 0.0, 0.0],
        [nan, 0.0, 0.0],
        [0.0, inf, 0.0],
        [0.0, 0.0, -inf],
        // On the line through 0 and 1, and off it by one part in 2^24.
        [0.25, 0.0, 0.0],
        [0.25, f32::EPSILON / 2.0, 0.0],
        [3.0, 3.0, 3.0],
    ];
    let indices = [
        [0, 1, 2],
        [4, 1, 2],
        [0, 5, 2],
        [0, 1, 6],
        [4, 5, 6],
        [0, 0, 0],
        [1, 2, 1],
        [0, 1, 3],
        [0, 7, 1],
        [0, 8, 1],
    ];
    let soup = [Geometry::from_mesh(&vertices, &indices)];
    for (name, scene) in Everywhere::build(&soup).0 {
        let stats = Stats::of(&scene.view());
        let counted = (stats.triangles, stats.dropped_non_finite, stats.dropped_degenerate);
        assert_eq!(counted, (2, 4, 4), "{name}");
        // The box is that of what is left.
        assert_eq!(scene.view().bounds(), ([0.0; 3], [1.0, 1.0, 0.0]), "{name}");
    }
    let all = Everywhere::build(&soup);
    all.hit(&Ray::new([0.25, 0.25, 1.0], [0.0, 0.0, -1.0]), 1.0, 0, 0);
    // The sliver is as good a triangle as any.
    let only = Ray { skip_geom: 0, skip_prim: 0, ..Ray::new([0.25, 0.0, 1.0], [0.0, 0.0, -1.0]) };
    all.hit(&only, 1.0, 0, 9);
}

#[test]
fn no_triangles_are_a_valid_scene() {
    let (points, flat) = ([[1.0; 3], [2.0; 3], [3.0; 3]], [[0, 1, 2], [0, 0, 1]]);
    let soups: [&[Geometry<'_>]; 4] = [
        &[],
        &[Geometry::from_mesh(&[], &[])],
        &[Geometry::from_mesh(&points, &[])],
        &[Geometry::from_mesh(&points, &flat)],
    ];
    for (soup, dropped) in soups.into_iter().zip([0, 0, 0, 2]) {
        let nothing = Everywhere::build(soup);
        nothing.miss(&Ray::new([0.0; 3], [1.0; 3]));
        for (name, scene) in &nothing.0 {
            let stats = Stats::of(&scene.view());
            assert_eq!((stats.triangles, stats.dropped_degenerate), (0, dropped), "{name}");
            assert_eq!(stats.levels().len(), 0, "{name}");
            let nowhere = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
            assert_eq!(scene.view().bounds(), nowhere, "{name}");
        }
    }
}
