//! Rays at the seams of a closed mesh.

use super::Ray;
use crate::random::Random;
use crate::soups::ClosedMesh;

/// `n` rays that no gap lets out: from within a star-shaped closed mesh at its vertices (every
/// second ray) and at points of its edges. All of them hit.
pub fn watertight(target: &ClosedMesh, seed: u64, n: usize) -> Vec<Ray> {
    let mut random = Random::stream((0x200 << 32) ^ seed);
    let vertex = |v: u32| target.mesh.vertices[v as usize].map(f64::from);
    let centre = target.centre.map(f64::from);
    let pole = vertex(0);
    let radius = libm::fabs(pole[1] - centre[1]);
    (0..n)
        .map(|i| {
            let away = random.direction();
            let distance = 0.5 * radius * random.unit();
            let org = [0, 1, 2].map(|k| (centre[k] + away[k] * distance) as f32);
            let [a, b] = target.edges[random.below(target.edges.len())].map(vertex);
            let share = if i % 2 == 0 { 0.0 } else { random.unit() };
            let dir = [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * share - f64::from(org[k]));
            Ray::new(org, dir.map(|c| c as f32), 0.0, f32::INFINITY)
        })
        .collect()
}
