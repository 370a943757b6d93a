//! Queries of one ray, and what they cost.

use super::build::hug_scene;
use super::types::{hug_counters, hug_hit, hug_ray};
use crate::arena::View;
use crate::trace::Counters;
use crate::{Hit, Ray};

/// The view of a scene handle.
///
/// # Safety
/// `scene` is a valid scene.
pub(super) unsafe fn view<'a>(scene: *const hug_scene) -> View<'a> {
    // SAFETY: by the caller.
    unsafe { View::from_ptr(scene.cast()) }
}

/// Reads a ray of any alignment.
///
/// # Safety
/// `ray` is readable.
pub(super) unsafe fn read(ray: *const hug_ray) -> Ray {
    // SAFETY: the two structs have the same layout; readable by the caller.
    unsafe { ray.cast::<Ray>().read_unaligned() }
}

/// Writes what was found to a record of any alignment: 1 for a hit, 0 for a miss.
///
/// # Safety
/// `hit` is writable.
pub(super) unsafe fn answer(hit: *mut hug_hit, found: Hit) -> i32 {
    // SAFETY: the two structs have the same layout; writable by the caller.
    unsafe { hit.cast::<Hit>().write_unaligned(found) };
    i32::from(found.is_hit())
}

/// Finds the closest hit. Returns 1 and writes the hit, or returns 0 and
/// writes the record of a miss. With scene, ray or hit NULL: 0 (a hit record,
/// if there is one, becomes a miss with t = infinity).
///
/// Allocates nothing, locks nothing; any number of threads at a time.
///
/// # Safety
/// Each pointer is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect(
    scene: *const hug_scene,
    ray: *const hug_ray,
    hit: *mut hug_hit,
) -> i32 {
    if scene.is_null() || ray.is_null() || hit.is_null() {
        if !hit.is_null() {
            // SAFETY: not NULL, writable by contract.
            unsafe { answer(hit, Hit::miss(f32::INFINITY)) };
        }
        return 0;
    }
    // SAFETY: not NULL, valid by contract.
    unsafe { answer(hit, view(scene).intersect(&read(ray))) }
}

/// Whether anything is hit: 1 or 0. With scene or ray NULL: 0.
///
/// # Safety
/// Each pointer is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded(scene: *const hug_scene, ray: *const hug_ray) -> i32 {
    if scene.is_null() || ray.is_null() {
        return 0;
    }
    // SAFETY: not NULL, valid by contract.
    i32::from(unsafe { view(scene).occluded(&read(ray)) })
}

/// hug_intersect that also adds what it did to *counters. The hit is the same.
/// With a NULL pointer: as hug_intersect, and nothing is counted.
///
/// # Safety
/// Each pointer is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_counted(
    scene: *const hug_scene,
    ray: *const hug_ray,
    hit: *mut hug_hit,
    counters: *mut hug_counters,
) -> i32 {
    if scene.is_null() || ray.is_null() || hit.is_null() || counters.is_null() {
        // SAFETY: the same contract.
        return unsafe { hug_intersect(scene, ray, hit) };
    }
    let mut seen = Counters::default();
    // SAFETY: not NULL, valid by contract.
    unsafe {
        let found = view(scene).intersect_counted(&read(ray), &mut seen);
        add(counters, &seen);
        answer(hit, found)
    }
}

/// hug_occluded that also adds what it did to *counters.
/// With a NULL pointer: as hug_occluded, and nothing is counted.
///
/// # Safety
/// Each pointer is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded_counted(
    scene: *const hug_scene,
    ray: *const hug_ray,
    counters: *mut hug_counters,
) -> i32 {
    if scene.is_null() || ray.is_null() || counters.is_null() {
        // SAFETY: the same contract.
        return unsafe { hug_occluded(scene, ray) };
    }
    let mut seen = Counters::default();
    // SAFETY: not NULL, valid by contract.
    unsafe {
        let hit = view(scene).occluded_counted(&read(ray), &mut seen);
        add(counters, &seen);
        i32::from(hit)
    }
}

/// Adds `seen` to the caller's counters, which stop at the largest value.
///
/// # Safety
/// `counters` is readable and writable.
pub(super) unsafe fn add(counters: *mut hug_counters, seen: &Counters) {
    // SAFETY: by the caller.
    unsafe {
        let mut c = counters.read_unaligned();
        c.grids = c.grids.saturating_add(seen.grids);
        c.voxels = c.voxels.saturating_add(seen.voxels);
        c.tests = c.tests.saturating_add(seen.tests);
        c.hits = c.hits.saturating_add(seen.hits);
        counters.write_unaligned(c);
    }
}
