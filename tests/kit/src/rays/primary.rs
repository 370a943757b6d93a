//! Rays through pixel centres, in the order a tiled renderer would shoot them.

use super::{FAR, Ray, narrow, wide};
use crate::View;

const TILE: u64 = 8;

/// Column and row (from the top) of each primary ray: 8 x 8 tiles, row by row, cut off at the
/// right and bottom when `size` is no multiple of 8.
///
/// Counted through whole tiles, not nested: memory checkers take the code that nested iterators
/// are optimised to for reads of uninitialised memory.
pub fn primary_pixels(size: u32) -> impl Iterator<Item = [u32; 2]> {
    let size = u64::from(size);
    let tiles = size.div_ceil(TILE);
    let pixel = move |i: u64| {
        let (tile, inner) = (i / (TILE * TILE), i % (TILE * TILE));
        [tile % tiles * TILE + inner % TILE, tile / tiles * TILE + inner / TILE]
    };
    (0..tiles * tiles * TILE * TILE)
        .map(pixel)
        .filter(move |&[x, y]| x < size && y < size)
        .map(|at| at.map(|c| c as u32))
}

/// One ray through the centre of each of `size` x `size` pixels, directions normalised.
pub fn primary(view: &View, size: u32) -> impl Iterator<Item = Ray> {
    let eye = wide(view.eye);
    let forward = (wide(view.at) - eye).normalize();
    let right = forward.cross(wide(view.up)).normalize();
    let up = right.cross(forward);
    let half = libm::tan(f64::from(view.fov_deg) * (core::f64::consts::PI / 180.0) / 2.0);
    let step = 2.0 / f64::from(size);
    let org = view.eye;
    primary_pixels(size).map(move |[x, y]| {
        let sx = ((f64::from(x) + 0.5) * step - 1.0) * half;
        let sy = (1.0 - (f64::from(y) + 0.5) * step) * half;
        let dir = (forward + right * sx + up * sy).normalize();
        Ray::new(org, narrow(dir), 0.0, FAR)
    })
}
