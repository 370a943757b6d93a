//! The nearest point of a scene.
#![allow(non_camel_case_types)]

use super::build::hug_scene;
use super::query::view;
use crate::{Nearest, Probe};

/// A ball to search for the nearest point of a scene. 32 bytes, aligned to 4.
///
/// NaN anywhere, a centre that is not finite or a negative radius find nothing. The
/// radius may be infinite.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_probe {
    /// Centre, in the units of the scene.
    pub org: [f32; 3],
    /// Largest distance, inclusive.
    pub radius: f32,
    /// A geometry is found only if its mask shares a bit with this one.
    pub mask: u32,
    /// Reserved, must be 0; changes nothing.
    pub flags: u32,
    /// Geometry of the one triangle to leave out, or HUG_NONE.
    pub skip_geom: u32,
    /// Primitive of the one triangle to leave out, or HUG_NONE.
    pub skip_prim: u32,
}

/// The nearest point. 40 bytes, aligned to 4.
///
/// Nothing has geom = prim = inst = HUG_NONE, distance = the probe's radius, and zeros
/// elsewhere. Of equal distances that of the lowest geom, then lowest prim, is returned.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_nearest {
    /// The exact distance of the triangle from the centre, rounded once to float.
    pub distance: f32,
    /// Weight of v1 at the nearest point, exact but for one rounding.
    pub u: f32,
    /// Weight of v2 at the nearest point, exact but for one rounding.
    pub v: f32,
    /// The triangle's nearest point, each coordinate exact but for one rounding.
    pub point: [f32; 3],
    /// Index of the geometry in the descriptor.
    pub geom: u32,
    /// Index of the triangle in its geometry.
    pub prim: u32,
    /// Reserved for instances; HUG_NONE.
    pub inst: u32,
    /// 0.
    pub reserved: u32,
}

const _: () = assert!(size_of::<hug_probe>() == size_of::<Probe>());
const _: () = assert!(size_of::<hug_nearest>() == size_of::<Nearest>());

/// Finds the point of the scene that is nearest to the probe's centre and no farther away
/// than its radius. Returns 1 and writes it, or returns 0 and writes the record of
/// nothing. Distances are those of real arithmetic, rounded once to float, and it is the
/// rounded ones that are compared; one that overflows is none. The answer is the same in
/// every structure and on every machine. With scene, probe or nearest NULL: 0 (a record, if there
/// is one, becomes nothing at distance infinity).
///
/// Allocates nothing, locks nothing; any number of threads at a time. One probe at a
/// time; there is no form for streams.
///
/// # Safety
/// Each pointer is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_closest_point(
    scene: *const hug_scene,
    probe: *const hug_probe,
    nearest: *mut hug_nearest,
) -> i32 {
    if nearest.is_null() {
        return 0;
    }
    let found = if scene.is_null() || probe.is_null() {
        Nearest::nothing(f32::INFINITY)
    } else {
        // SAFETY: not NULL, valid by contract; the records have the same layout.
        unsafe { view(scene).closest_point(&probe.cast::<Probe>().read_unaligned()) }
    };
    // SAFETY: not NULL, writable by contract.
    unsafe { nearest.cast::<Nearest>().write_unaligned(found) };
    i32::from(found.is_found())
}
