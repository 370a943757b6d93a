//! A cheap proof that most triangles are missed.

use super::Triangle;
use crate::rays::Ray;
use glam::DVec3;

/// Seven roundings at most lie between the inputs and a term of the signed volume (two differences,
/// two products, a subtraction, two sums), each off by 2^-53 of what it rounds; 2^-49 leaves room.
/// Products of three floats neither overflow nor vanish in doubles.
const ERROR: f64 = 1.0 / (1u64 << 49) as f64;

/// True only if the line through `ray`, whose values are finite, certainly misses `tri`: two of
/// its edges lie on different sides of the line beyond any doubt.
pub fn certainly_misses(ray: &Ray, tri: &Triangle) -> bool {
    let (org, dir) = (wide(&ray.org), wide(&ray.dir));
    let (a, b, c) = (wide(&tri[0]) - org, wide(&tri[1]) - org, wide(&tri[2]) - org);
    let (ab, bc, ca) = (side(dir, a, b), side(dir, b, c), side(dir, c, a));
    ab * bc < 0.0 || bc * ca < 0.0 || ca * ab < 0.0
}

fn wide(v: &[f32; 3]) -> DVec3 {
    DVec3::new(v[0].into(), v[1].into(), v[2].into())
}

/// The sign of dir . (a x b), or 0 in doubt (which includes NaN from corners that are not finite).
fn side(dir: DVec3, a: DVec3, b: DVec3) -> f64 {
    let volume = dir.dot(a.cross(b));
    // The same sum with every term counted positive.
    let (a, b) = (a.abs(), b.abs());
    let size = dir.x.abs() * (a.y * b.z + a.z * b.y)
        + dir.y.abs() * (a.z * b.x + a.x * b.z)
        + dir.z.abs() * (a.x * b.y + a.y * b.x);
    if volume.abs() > ERROR * size { volume.signum() } else { 0.0 }
}
