//! The ray sets of the comparisons: generated once per scene and view from a fixed seed, the same
//! bytes for every library. There is no tracer here: sets that start on surfaces take the hits
//! that the caller's tracer found.

mod adversarial;
mod bounce;
mod primary;
mod shadow;
mod uniform;
mod watertight;

pub use adversarial::{Aim, adversarial};
pub use bounce::{bounce, bounce_count};
pub use primary::{primary, primary_pixels};
pub use shadow::{shadow, shadow_count};
pub use uniform::random;
pub use watertight::watertight;

use bytemuck::{Pod, Zeroable};
use glam::DVec3;

/// The frame size of the comparisons.
pub const FRAME: u32 = 1024;
/// The number of rays in the random set of the comparisons.
pub const RANDOM_COUNT: usize = 1 << 20;
/// No triangle: the ids of a miss, and of a ray that skips nothing.
pub const NONE: u32 = u32::MAX;
/// The far end of every ray that is not a shadow ray.
pub const FAR: f32 = 1e30;

/// The layout of `hug_ray`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Ray {
    pub org: [f32; 3],
    pub tmin: f32,
    pub dir: [f32; 3],
    pub tmax: f32,
    pub mask: u32,
    pub flags: u32,
    pub skip_geom: u32,
    pub skip_prim: u32,
}

impl Ray {
    /// A ray that sees every geometry and skips nothing.
    pub fn new(org: [f32; 3], dir: [f32; 3], tmin: f32, tmax: f32) -> Self {
        Self { org, tmin, dir, tmax, mask: u32::MAX, flags: 0, skip_geom: NONE, skip_prim: NONE }
    }
}

/// The layout of `hug_hit`. The ray sets read `t`, `ng` and, for hit or miss, `geom`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Hit {
    pub t: f32,
    pub u: f32,
    pub v: f32,
    pub ng: [f32; 3],
    pub geom: u32,
    pub prim: u32,
    pub inst: u32,
    pub reserved: u32,
}

impl Hit {
    /// Whether the ray hit anything.
    pub fn is_hit(&self) -> bool {
        self.geom != NONE
    }
}

/// A point to start a secondary ray from, and the unit normal on the side the ray came from.
struct Start {
    org: DVec3,
    normal: DVec3,
}

impl Start {
    /// The hit point, moved off the surface by 1e-5 of the scene's diagonal.
    fn new(ray: &Ray, hit: &Hit, diagonal: f64) -> Self {
        let dir = wide(ray.dir);
        let ng = wide(hit.ng).normalize();
        let normal = if ng.dot(dir) > 0.0 { -ng } else { ng };
        let point = wide(ray.org) + dir * f64::from(hit.t);
        Self { org: point + normal * (1e-5 * diagonal), normal }
    }
}

fn wide(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

fn narrow(v: DVec3) -> [f32; 3] {
    v.to_array().map(|c| c as f32)
}
