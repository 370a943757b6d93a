//! Rays that know nothing of the scene but its box.

use super::{FAR, Ray};
use crate::Bounds;
use crate::random::Random;

const STREAM: u64 = 3;

/// Endless rays, origins uniform in the box, directions uniform on the sphere; the comparisons
/// take the first [`super::RANDOM_COUNT`].
pub fn random(bounds: &Bounds) -> impl Iterator<Item = Ray> {
    let bounds = *bounds;
    let mut random = Random::stream(STREAM);
    core::iter::repeat_with(move || {
        let fraction = [random.unit(), random.unit(), random.unit()];
        let org = bounds.at(fraction).map(|c| c as f32);
        let dir = random.direction().map(|c| c as f32);
        Ray::new(org, dir, 0.0, FAR)
    })
}
