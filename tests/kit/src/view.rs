//! Pinhole cameras.

use crate::Bounds;

/// A square pinhole camera. `fov_deg` is the vertical field of view, equal to the horizontal one;
/// `up` need not be orthogonal to the viewing direction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    pub eye: [f32; 3],
    pub at: [f32; 3],
    pub up: [f32; 3],
    pub fov_deg: f32,
}

impl View {
    /// A view for scenes that name none: inside the box, along its longest horizontal axis
    /// (y is up), from near one end at a little more than half the height.
    pub fn derived(bounds: &Bounds) -> Self {
        let extent = |k: usize| f64::from(bounds.hi[k]) - f64::from(bounds.lo[k]);
        let along = if extent(0) >= extent(2) { 0 } else { 2 };
        let mut eye = [0.5, 0.6, 0.5];
        let mut at = [0.5, 0.5, 0.5];
        eye[along] = 0.05;
        at[along] = 0.95;
        Self {
            eye: bounds.at(eye).map(|c| c as f32),
            at: bounds.at(at).map(|c| c as f32),
            up: [0.0, 1.0, 0.0],
            fov_deg: 60.0,
        }
    }
}
