//! Which of several triangles is the one hit: ties, skipped ones, masks.
#![allow(missing_docs)]

mod common;

use common::everywhere::Everywhere;
use hug::{Geometry, Indices, NONE, Ray};
use hug_kit::soups;

const SQUARE: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];

fn square(indices: &[[u32; 3]]) -> Geometry<'_> {
    Geometry::from_mesh(&SQUARE, indices)
}

/// Down at a point of the square's lower right half.
const DOWN: Ray = Ray::new([0.75, 0.25, 1.0], [0.0, 0.0, -1.0]);

#[test]
fn ties_go_to_the_lowest_primitive() {
    // Coincident, wound either way and starting at any corner.
    let copies = [[0, 2, 3], [1, 2, 0], [0, 1, 2], [2, 1, 0], [0, 1, 2]];
    let soup = Everywhere::build(&[square(&copies)]);
    soup.hit(&DOWN, 1.0, 0, 1);
    // On the shared diagonal and at a shared vertex.
    soup.hit(&Ray { org: [0.5, 0.5, 1.0], ..DOWN }, 1.0, 0, 0);
    soup.hit(&Ray { org: [0.0, 0.0, 1.0], ..DOWN }, 1.0, 0, 0);
    soup.hit(&Ray { org: [1.0, 0.0, 1.0], ..DOWN }, 1.0, 0, 1);
}

#[test]
fn ties_go_to_the_lowest_geometry_first() {
    let (other, late, early) = ([[0, 2, 3]], [[0, 2, 3], [0, 2, 3], [0, 1, 2]], [[0, 1, 2]]);
    let soup = Everywhere::build(&[square(&other), square(&late), square(&early)]);
    soup.hit(&DOWN, 1.0, 1, 2);
    soup.hit(&Ray { org: [0.5, 0.5, 1.0], ..DOWN }, 1.0, 0, 0);
}

/// Eight layers one above the other, eight voxels apart or in one, whose
/// distances from a far origin round to the same t.
fn layers() -> Vec<[f32; 3]> {
    let layer = |z: i32| [[0.0, 0.0], [8.0, 0.0], [0.0, 8.0]].map(|[x, y]| [x, y, z as f32]);
    (0..8).flat_map(layer).collect()
}

const FAR: f32 = (1u32 << 30) as f32;

#[test]
fn a_tie_in_a_later_voxel_counts() {
    let vertices = layers();
    let mut order: Vec<usize> = (0..8).collect();
    for _ in 0..8 {
        order.rotate_left(3);
        let triangles: Vec<_> = order.iter().map(|layer| &vertices[3 * layer..][..3]).collect();
        let geometries: Vec<_> = triangles
            .iter()
            .map(|t| Geometry::new(t.as_flattened(), 3, Indices::None).expect("one triangle"))
            .collect();
        let several = Everywhere::build(&geometries);
        let corners: Vec<f32> = triangles.concat().into_flattened();
        let one = Geometry::new(&corners, 3, Indices::None).expect("eight triangles");
        let one = Everywhere::build(&[one]);
        // Down, up and backwards: the layers are met in either order.
        for (z, dir, t) in [(FAR, -1.0, FAR), (-FAR, 1.0, FAR), (FAR, 1.0, -FAR)] {
            let ray = Ray::new([1.0, 1.0, z], [0.0, 0.0, dir]);
            for ray in [ray.with_range(-2.0 * FAR, 2.0 * FAR), ray.with_range(t, t)] {
                several.hit(&ray, t, 0, 0);
                one.hit(&ray, t, 0, 0);
            }
        }
    }
}

#[test]
fn one_triangle_can_be_skipped() {
    let pair = [[0, 1, 2], [0, 1, 2]];
    let soup = Everywhere::build(&[square(&pair), square(&pair)]);
    let skip = |skip_geom, skip_prim| Ray { skip_geom, skip_prim, ..DOWN };
    // The coincident neighbour is then found: the same primitive of another
    // geometry is another triangle.
    soup.hit(&skip(0, 0), 1.0, 0, 1);
    soup.hit(&skip(0, 1), 1.0, 0, 0);
    soup.hit(&skip(1, 0), 1.0, 0, 0);
    // Half a name names nothing.
    soup.hit(&skip(0, NONE), 1.0, 0, 0);
    soup.hit(&skip(NONE, 0), 1.0, 0, 0);
    soup.hit(&skip(NONE, NONE), 1.0, 0, 0);
    soup.hit(&skip(7, 0), 1.0, 0, 0);
}

#[test]
fn the_only_triangle_skipped_is_a_miss() {
    let only = [[0, 1, 2]];
    let soup = Everywhere::build(&[square(&only)]);
    let skip = Ray { skip_geom: 0, skip_prim: 0, ..DOWN };
    soup.miss(&skip);
    soup.hit(&Ray { skip_prim: 1, ..skip }, 1.0, 0, 0);
}

/// Starting on a closed mesh and skipping the triangle under one's feet: from a
/// point inside it the ray finds the far side, without an epsilon.
#[test]
fn skipping_leaves_the_surface_one_starts_on() {
    let mesh = soups::bumpy_sphere(12, 1.0, [0.0; 3]).mesh;
    let soup = Everywhere::build(&[Geometry::from_mesh(&mesh.vertices, &mesh.indices)]);
    for (prim, [a, b, c]) in (0..).zip(mesh.triangles()) {
        let org = [0, 1, 2].map(|k| (a[k] + b[k] + c[k]) / 3.0);
        let inward = Ray { skip_geom: 0, skip_prim: prim, ..Ray::new(org, org.map(|x| -x)) };
        let hit = soup.shoot(&inward);
        assert!(hit.t > 1.5, "from triangle {prim}: {hit:?}");
    }
}

#[test]
fn masks_share_a_bit_or_do_not_meet() {
    let only = [[0, 1, 2]];
    let masks = [0b0110, 0b0100, 1 << 31, 0];
    let soup: Vec<_> = masks.iter().map(|&m| square(&only).with_mask(m)).collect();
    let soup = Everywhere::build(&soup);
    let with = |mask| Ray { mask, ..DOWN };
    soup.hit(&with(u32::MAX), 1.0, 0, 0);
    soup.hit(&with(0b0010), 1.0, 0, 0);
    soup.hit(&Ray { skip_geom: 0, skip_prim: 0, ..with(0b0100) }, 1.0, 1, 0);
    soup.hit(&with(1 << 31), 1.0, 2, 0);
    soup.hit(&with(1 << 31 | 1), 1.0, 2, 0);
    soup.miss(&with(0b1001));
    soup.miss(&with(0));
    // A geometry without a bit is met by nothing.
    soup.miss(&Ray { skip_geom: 0, skip_prim: 0, ..with(0b0010) });
}
