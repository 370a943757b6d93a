//! Which geometry and triangle a build does not take.

use super::desc::Parsed;
use super::guard::guard;
use super::types::{HUG_NONE, hug_build_desc, hug_status};
use crate::Error;

/// Says what hug_build does not take, for a message after it has failed: *geom
/// becomes the first geometry at fault and *prim its first triangle, or HUG_NONE if
/// it is the geometry as a whole. Returns the status that hug_build has for it.
///
/// Another status with both HUG_NONE is about the descriptor itself. HUG_OK: every
/// geometry can be built. Cost: linear in the triangles, with no allocation.
///
/// # Safety
/// desc and what it points to must be readable, geom and prim writable or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_find_fault(
    desc: *const hug_build_desc,
    geom: *mut u32,
    prim: *mut u32,
) -> hug_status {
    guard(|| {
        if geom.is_null() || prim.is_null() {
            return Err(Error::Null);
        }
        let name = |geometry: u32, triangle: u32| {
            // SAFETY: not NULL, writable by contract.
            unsafe {
                geom.write(geometry);
                prim.write(triangle);
            }
        };
        name(HUG_NONE, HUG_NONE);
        // SAFETY: readable by contract.
        let Some((geometry, triangle, error)) = (unsafe { Parsed::fault(desc) })? else {
            return Ok(());
        };
        name(geometry as u32, triangle.map_or(HUG_NONE, |number| number as u32));
        Err(error)
    })
}
