//! Queries and what they cost.

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
            unsafe { hit.cast::<Hit>().write_unaligned(Hit::miss(f32::INFINITY)) };
        }
        return 0;
    }
    // SAFETY: not NULL, valid by contract.
    let found = unsafe { view(scene).intersect(&read(ray)) };
    // SAFETY: not NULL, writable by contract.
    unsafe { hit.cast::<Hit>().write_unaligned(found) };
    i32::from(found.is_hit())
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

/// Finds the closest hits of n rays. Ray i is at rays + i * ray_stride bytes,
/// hit i at hits + i * hit_stride; a stride of 0 means packed. Rays and hits
/// may be fields of one array's elements, but must not overlap otherwise.
/// Results are those of hug_intersect, bit for bit, in the order of the rays.
/// With a NULL pointer nothing is done.
///
/// # Safety
/// The rays must be readable and the hits writable, at their strides.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_n(
    scene: *const hug_scene,
    rays: *const hug_ray,
    ray_stride: usize,
    hits: *mut hug_hit,
    hit_stride: usize,
    n: usize,
) {
    if scene.is_null() || rays.is_null() || hits.is_null() {
        return;
    }
    let ray_stride = if ray_stride == 0 { size_of::<hug_ray>() } else { ray_stride };
    let hit_stride = if hit_stride == 0 { size_of::<hug_hit>() } else { hit_stride };
    // SAFETY: valid by contract, for every i below n.
    unsafe {
        let view = view(scene);
        for i in 0..n {
            let ray = read(rays.byte_add(i * ray_stride));
            let hit = hits.byte_add(i * hit_stride).cast::<Hit>();
            hit.write_unaligned(view.intersect(&ray));
        }
    }
}

/// Whether anything is hit, for n rays: occluded[i] becomes 1 or 0. Ray i is
/// at rays + i * ray_stride bytes; a stride of 0 means packed. With a NULL
/// pointer nothing is done.
///
/// # Safety
/// The rays must be readable at their stride, n bytes at occluded writable.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded_n(
    scene: *const hug_scene,
    rays: *const hug_ray,
    ray_stride: usize,
    occluded: *mut u8,
    n: usize,
) {
    if scene.is_null() || rays.is_null() || occluded.is_null() {
        return;
    }
    let ray_stride = if ray_stride == 0 { size_of::<hug_ray>() } else { ray_stride };
    // SAFETY: valid by contract, for every i below n.
    unsafe {
        let view = view(scene);
        for i in 0..n {
            let ray = read(rays.byte_add(i * ray_stride));
            occluded.add(i).write(u8::from(view.occluded(&ray)));
        }
    }
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
        hit.cast::<Hit>().write_unaligned(found);
        i32::from(found.is_hit())
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
unsafe fn add(counters: *mut hug_counters, seen: &Counters) {
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
