//! What rays do in a structure, counted.

use hug::{Profile, Ray, View};

/// Means a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// Grids entered, the outermost included.
    pub grids: f64,
    /// Of these, grids of clusters.
    pub clusters: f64,
    pub voxels: f64,
    pub tests: f64,
}

impl Steps {
    pub fn of(view: &View<'_>, rays: &[Ray]) -> Self {
        let mut profile = Profile::default();
        for ray in rays {
            view.intersect_profiled(ray, &mut profile);
        }
        let total = profile.total();
        let world = view.grid_shape(0).map_or(0, |grid| grid.level as usize);
        let outermost = profile.levels().get(world).map_or(0, |calls| calls.grids);
        let each = |calls: u64| calls as f64 / rays.len().max(1) as f64;
        Self {
            grids: each(total.grids),
            clusters: each(total.grids - outermost.min(total.grids)),
            voxels: each(total.voxels),
            tests: each(total.tests),
        }
    }
}
