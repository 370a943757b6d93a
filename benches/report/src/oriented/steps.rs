//! What rays do in a structure, counted.

use hug::{GridShape, Profile, Ray, View};

/// Most rays of which boxes are counted: each is set against every cluster.
const RAYS: usize = 1 << 14;

/// Means a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// Boxes of clusters on the ray's way to its hit, each once. The box tests of a walk are
    /// other: it tests a box wherever a voxel refers to it, which may be before it or beside it.
    pub met: f64,
    /// Grids whose box was tested, the outermost included.
    pub grids: f64,
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
        let each = |calls: u64| calls as f64 / rays.len().max(1) as f64;
        Self {
            met: met(view, rays),
            grids: each(total.grids),
            voxels: each(total.voxels),
            tests: each(total.tests),
        }
    }
}

fn met(view: &View<'_>, rays: &[Ray]) -> f64 {
    let clusters: Vec<GridShape> =
        (1..view.grid_count()).filter_map(|number| view.grid_shape(number)).collect();
    let every = rays.len().div_ceil(RAYS).max(1);
    let (mut boxes, mut count) = (0, 0_usize);
    for ray in rays.iter().step_by(every) {
        let hit = view.intersect(ray);
        let end = f64::from(if hit.is_hit() { hit.t } else { ray.tmax });
        boxes += clusters.iter().filter(|shape| meets(shape, ray, end)).count();
        count += 1;
    }
    boxes as f64 / count.max(1) as f64
}

/// Whether a ray meets a grid's box before this end of it.
pub fn meets(shape: &GridShape, ray: &Ray, end: f64) -> bool {
    let (org, dir) = (ray.org.map(f64::from), ray.dir.map(f64::from));
    let (org, dir) = match &shape.frame {
        None => (org, dir),
        Some(frame) => {
            let from = [0, 1, 2].map(|k| org[k] - frame.origin[k]);
            (frame.axes.map(|axis| dot(axis, from)), frame.axes.map(|axis| dot(axis, dir)))
        }
    };
    let (mut enter, mut leave) = (f64::from(ray.tmin), end);
    for k in 0..3 {
        let [a, b] = [shape.lower[k], shape.upper[k]].map(|side| (side - org[k]) / dir[k]);
        // A ray in the plane of a side gives a NaN, which `min` and `max` pass over.
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    enter <= leave
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
