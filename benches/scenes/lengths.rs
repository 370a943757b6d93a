//! Figure 4: how long a scene's triangles are.

use hug_kit::Mesh;

/// One line of figure 4; a length is the diagonal of a triangle's box.
#[derive(Clone, Copy, Debug)]
pub struct Lengths {
    pub count: usize,
    /// The smallest length over the largest.
    pub min_max: f64,
    /// The smallest length over the diagonal of the scene's box.
    pub min_diag: f64,
    /// Percentage of lengths below a fifth of the largest (%.2).
    pub below: f64,
}

impl Lengths {
    pub fn of(mesh: &Mesh) -> Self {
        let lengths: Vec<f64> = mesh.triangles().map(length).collect();
        let min = lengths.iter().copied().fold(f64::INFINITY, f64::min);
        let max = lengths.iter().copied().fold(0.0, f64::max);
        let below = lengths.iter().filter(|&&d| d < 0.2 * max).count();
        Self {
            count: lengths.len(),
            min_max: min / max,
            min_diag: min / mesh.bounds().map_or(f64::NAN, |b| b.diagonal()),
            below: 100.0 * below as f64 / lengths.len() as f64,
        }
    }
}

fn length(corners: [[f32; 3]; 3]) -> f64 {
    let squares = [0, 1, 2].map(|k| {
        let of = corners.map(|p| f64::from(p[k]));
        let side =
            of.into_iter().fold(f64::MIN, f64::max) - of.into_iter().fold(f64::MAX, f64::min);
        side * side
    });
    squares.iter().sum::<f64>().sqrt()
}
