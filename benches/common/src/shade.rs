//! Grey values of pictures.

use hug::{Hit, Ray};

/// How squarely a ray meets the surface that it hits: the cosine of the angle between ray and
/// normal, whichever side. In `f64`, where no normal is too long.
pub fn squareness(ray: &Ray, hit: &Hit) -> f64 {
    let dot = |a: [f32; 3], b: [f32; 3]| (0..3).map(|k| f64::from(a[k]) * f64::from(b[k])).sum();
    let (across, n, d): (f64, f64, f64) =
        (dot(ray.dir, hit.ng), dot(hit.ng, hit.ng), dot(ray.dir, ray.dir));
    across.abs() / (n * d).sqrt().max(f64::MIN_POSITIVE)
}
