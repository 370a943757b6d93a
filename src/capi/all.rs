//! All hits of a ray, and the triangle test on its own.

use super::build::hug_scene;
use super::guard::guard;
use super::query::{answer, read, view};
use super::types::{hug_hit, hug_ray, hug_status};
use crate::{Error, Hit};

/// Finds the hits of a ray, smallest t first, ties by lowest geom, then lowest prim, each
/// triangle once: as many as there is room for, the first of them. *count becomes how many
/// were written, *more, unless more is NULL, 1 if there are others behind them, else 0.
///
/// after is NULL, or one of the ray's hits: then those that follow it are found, so that
/// nothing is lost or told twice if a call goes on after the last hit of another. It may
/// be one of hits, which is written. A miss, or a hit whose t is NaN, is followed by
/// nothing. With capacity 0 hits may be NULL, and only *more is of use.
///
/// Each hit is what hug_intersect writes. It takes about as long as walking to the last
/// hit that is kept, or to the ray's end if there is room for all. There is no form for
/// streams: answers of unknown length would need memory for the worst case.
///
/// HUG_ERROR_NULL: scene, ray, count, or hits with a capacity is NULL;
/// HUG_ERROR_ALIGNMENT: hits is not aligned to 4; HUG_ERROR_OVERFLOW: a capacity beyond
/// the address space. Nothing is done then, but *count and *more become 0.
///
/// # Safety
/// Each pointer is valid or NULL, hits for capacity elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_all(
    scene: *const hug_scene,
    ray: *const hug_ray,
    after: *const hug_hit,
    hits: *mut hug_hit,
    capacity: usize,
    count: *mut usize,
    more: *mut i32,
) -> hug_status {
    let tell = |found: usize, others: bool| {
        // SAFETY: valid or NULL by contract.
        unsafe {
            if !count.is_null() {
                count.write_unaligned(found);
            }
            if !more.is_null() {
                more.write_unaligned(i32::from(others));
            }
        }
    };
    tell(0, false);
    guard(|| {
        if scene.is_null() || ray.is_null() || count.is_null() {
            return Err(Error::Null);
        }
        // Read before there is a reference to the room, which it may be in.
        // SAFETY: valid or NULL by contract.
        let after = (!after.is_null()).then(|| unsafe { after.cast::<Hit>().read_unaligned() });
        // SAFETY: valid by contract.
        let room = unsafe { room(hits, capacity) }?;
        // SAFETY: not NULL, valid by contract.
        let found = unsafe { view(scene).intersect_all(&read(ray), after.as_ref(), room) };
        tell(found.count, found.more);
        Ok(())
    })
}

/// The caller's memory for hits.
///
/// # Safety
/// `hits` is writable for `capacity` elements, or NULL.
unsafe fn room<'a>(hits: *mut hug_hit, capacity: usize) -> Result<&'a mut [Hit], Error> {
    if capacity == 0 {
        return Ok(&mut []);
    }
    if hits.is_null() {
        return Err(Error::Null);
    }
    if !hits.is_aligned() {
        return Err(Error::Alignment);
    }
    let bytes = capacity.checked_mul(size_of::<Hit>()).ok_or(Error::Overflow)?;
    isize::try_from(bytes).map_err(|_| Error::Overflow)?;
    // SAFETY: by the caller; any bytes are a hit.
    Ok(unsafe { core::slice::from_raw_parts_mut(hits.cast(), capacity) })
}

/// Finds the hit of a ray on one triangle, corners v0, v1, v2 in x, y, z each, without a
/// scene: exactly what hug_intersect finds in a scene of this triangle alone, which is
/// primitive 0 of geometry 0 there and has all bits of the mask. Returns 1 and writes the
/// hit, or returns 0 and writes the record of a miss. A triangle without area, or with a
/// corner that is not finite, is never hit. With ray, corners or hit NULL: 0 (a hit
/// record, if there is one, becomes a miss with t = infinity).
///
/// # Safety
/// Each pointer is valid or NULL, corners for 9 floats of any alignment.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_triangle(
    ray: *const hug_ray,
    corners: *const f32,
    hit: *mut hug_hit,
) -> i32 {
    if hit.is_null() {
        return 0;
    }
    let found = if ray.is_null() || corners.is_null() {
        Hit::miss(f32::INFINITY)
    } else {
        // SAFETY: not NULL, valid by contract.
        unsafe {
            let corners = corners.cast::<[[f32; 3]; 3]>().read_unaligned();
            crate::intersect_triangle(&read(ray), &corners)
        }
    };
    // SAFETY: not NULL, writable by contract.
    unsafe { answer(hit, found) }
}
