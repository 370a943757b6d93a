//! Rays through pixel centres, in the order a tiled renderer would shoot them.

use super::{FAR, Ray, narrow, wide};
use crate::View;

const TILE: u32 = 8;

/// Column and row (from the top) of each primary ray: 8 x 8 tiles, row by row, cut off at the
/// right and bottom when `size` is no multiple of 8.
pub fn primary_pixels(size: u32) -> impl Iterator<Item = [u32; 2]> {
    let tiles = move || (0..size).step_by(TILE as usize);
    tiles().flat_map(move |ty| {
        tiles().flat_map(move |tx| {
            (ty..(ty + TILE).min(size))
                .flat_map(move |y| (tx..(tx + TILE).min(size)).map(move |x| [x, y]))
        })
    })
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
