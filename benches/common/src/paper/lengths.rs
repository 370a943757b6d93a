//! Figure 4: how long a scene's triangles are.

/// One line of figure 4; a length is the diagonal of a triangle's box.
#[derive(Clone, Copy, Debug)]
pub struct Lengths {
    pub count: u64,
    /// The smallest length over the largest.
    pub min_max: f64,
    /// The smallest length over the diagonal of the scene's box.
    pub min_diag: f64,
    /// Percentage of lengths below a fifth of the largest (%.2).
    pub below: f64,
}

impl Lengths {
    pub fn of(lengths: &hug::Lengths) -> Self {
        Self {
            count: lengths.count,
            min_max: lengths.min_over_max(),
            min_diag: lengths.min_over_diagonal(),
            below: lengths.percent_below_fifth(),
        }
    }
}

/// Figure 4. "CSB 3rd floor" is the building here, its walls alone `building_walls`.
pub const FIGURE_4: [(&str, Lengths); 5] = [
    ("kitchen", Lengths { count: 20947, min_max: 9.0e-4, min_diag: 6.5e-4, below: 99.29 }),
    ("building_walls", Lengths { count: 32811, min_max: 5.7e-4, min_diag: 3.6e-4, below: 99.49 }),
    ("building", Lengths { count: 117_605, min_max: 1.0e-5, min_diag: 8.1e-6, below: 99.99 }),
    ("city", Lengths { count: 52136, min_max: 2.9e-3, min_diag: 1.0e-3, below: 99.85 }),
    ("garden", Lengths { count: 45293, min_max: 4.3e-3, min_diag: 1.1e-3, below: 99.72 }),
];
