//! Probes and what they find: the frozen, 4-byte aligned records shared by Rust and C.

use bytemuck::{Pod, Zeroable};

use crate::ray::NONE;

/// A ball to search for the nearest point of the scene. 32 bytes, aligned to 4.
///
/// A probe with a NaN anywhere, a centre that is not finite or a negative radius finds
/// nothing. The radius may be infinite.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Probe {
    /// Centre, in the units of the scene.
    pub org: [f32; 3],
    /// Largest distance, inclusive.
    pub radius: f32,
    /// A geometry is found only if this and its own mask share a bit.
    pub mask: u32,
    /// Reserved, must be 0; changes nothing.
    pub flags: u32,
    /// Geometry id of the one triangle to leave out, or [`NONE`].
    pub skip_geom: u32,
    /// Primitive id of the one triangle to leave out, or [`NONE`].
    pub skip_prim: u32,
}

impl Probe {
    /// A probe that finds anything up to `radius` away.
    #[must_use]
    pub const fn new(org: [f32; 3], radius: f32) -> Self {
        Self { org, radius, mask: u32::MAX, flags: 0, skip_geom: NONE, skip_prim: NONE }
    }
}

/// The nearest point that a probe found. 40 bytes, aligned to 4.
///
/// Nothing has `geom == prim == inst == NONE`, `distance` equal to the probe's radius,
/// and zeros elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Nearest {
    /// The exact distance of the triangle from the centre, rounded once to `f32`.
    pub distance: f32,
    /// Barycentric weight of `v1` at the nearest point, exact but for one rounding.
    pub u: f32,
    /// Barycentric weight of `v2`, likewise.
    pub v: f32,
    /// The point of the triangle that is nearest, each coordinate exact but for one
    /// rounding.
    pub point: [f32; 3],
    /// Index of the geometry in the build's list.
    pub geom: u32,
    /// Index of the triangle in its geometry.
    pub prim: u32,
    /// Reserved for instances; always [`NONE`].
    pub inst: u32,
    /// Always 0.
    pub reserved: u32,
}

impl Nearest {
    /// The record of nothing within `radius`.
    #[must_use]
    pub const fn nothing(radius: f32) -> Self {
        Self {
            distance: radius,
            u: 0.0,
            v: 0.0,
            point: [0.0; 3],
            geom: NONE,
            prim: NONE,
            inst: NONE,
            reserved: 0,
        }
    }

    /// Whether there is a point.
    #[must_use]
    pub const fn is_found(&self) -> bool {
        self.geom != NONE
    }
}

const _: () = assert!(size_of::<Probe>() == 32 && align_of::<Probe>() == 4);
const _: () = assert!(size_of::<Nearest>() == 40 && align_of::<Nearest>() == 4);
