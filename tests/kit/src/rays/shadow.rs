//! Occlusion rays from visible surfaces to four lights.

use super::{Hit, Ray, Start, narrow, primary_pixels};
use crate::Bounds;
use glam::DVec3;

/// Where the lights hang, in fractions of the scene's box.
const LIGHTS: [[f64; 3]; 4] =
    [[0.1, 0.9, 0.1], [0.9, 0.9, 0.15], [0.15, 0.9, 0.9], [0.85, 0.6, 0.85]];

/// The share of the way to a light that counts: stops short of a surface the light may touch.
const REACH: f64 = 1.0 - 1e-4;

fn chosen(size: u32) -> impl Iterator<Item = bool> {
    primary_pixels(size).map(|[x, y]| x % 2 == 0 && y % 2 == 0)
}

/// How many rays [`shadow`] makes.
pub fn shadow_count(size: u32, hits: &[Hit]) -> usize {
    let starts = chosen(size).zip(hits).filter(|(c, h)| *c && h.is_hit());
    LIGHTS.len() * starts.count()
}

/// Four rays from the hit of the top left pixel of each 2 x 2 block. `rays` and `hits` are the
/// primary ones of a frame of this size, in their order.
pub fn shadow(bounds: &Bounds, size: u32, rays: &[Ray], hits: &[Hit]) -> impl Iterator<Item = Ray> {
    let diagonal = bounds.diagonal();
    let lights = LIGHTS.map(|l| DVec3::from_array(bounds.at(l)));
    chosen(size)
        .zip(rays.iter().zip(hits))
        .filter(|(chosen, (_, hit))| *chosen && hit.is_hit())
        .flat_map(move |(_, (ray, hit))| {
            let start = Start::new(ray, hit, diagonal);
            lights.map(|light| {
                let way = light - start.org;
                let distance = way.length();
                let tmax = (distance * REACH) as f32;
                Ray::new(narrow(start.org), narrow(way / distance), 0.0, tmax)
            })
        })
}
