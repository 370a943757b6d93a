//! The parameters in question.

use hug::{Options, Structure};
use std::fmt;

/// AUTO's structure with parameters of its own.
#[derive(Clone, Copy, PartialEq)]
pub struct Setting {
    pub world_alpha: f32,
    pub alpha: f32,
    pub maxp: u32,
}

/// AUTO's limits for the outermost grid: its voxels, or a share of the triangles' number, or
/// what the product of both may be.
const WORLD_VOXELS: f64 = (1u32 << 17) as f64;
const WORLD_SHARE: f64 = 1.0 / 8.0;
const WORLD_TIMES: f64 = (1u64 << 35) as f64;

impl Setting {
    /// What AUTO takes at its default quality; that this makes the same bytes says whether
    /// what stands here is still what AUTO does.
    pub const AUTO: Self = Self { world_alpha: 0.63, alpha: 0.4, maxp: 512 };

    /// For a scene of so many triangles.
    pub fn options(&self, triangles: usize) -> Options {
        let n = triangles as f64;
        let most = (WORLD_TIMES / n).max(WORLD_VOXELS).max(WORLD_SHARE * n);
        let most = (most / n).cbrt() as f32;
        Options {
            structure: Structure::Recursive,
            world_alpha: Some(self.world_alpha.min(most)),
            alpha: self.alpha,
            maxp: self.maxp,
            fill_up: true,
            tree: true,
            ..Options::default()
        }
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.world_alpha, self.alpha, self.maxp)
    }
}
