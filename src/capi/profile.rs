//! Queries that tell what they did on each level.
#![allow(non_camel_case_types)]

use super::build::hug_scene;
use super::query::{answer, hug_intersect, hug_occluded, read, view};
use super::stream::{self, hug_intersect_n, hug_occluded_n};
use super::types::{HUG_MAX_LEVELS, hug_hit, hug_ray};
use crate::{Calls, Profile};

/// Section 3's rendering statistics of one level of grids, or of all.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_calls {
    /// Grids whose box was tested (#bbi).
    pub grids: u64,
    /// Voxels traversed (#vt): the steps of the walk.
    pub voxels: u64,
    /// Ray-triangle tests (#pit), one per reference met.
    pub tests: u64,
    /// Tests that were hits within the ray's range (#pi).
    pub hits: u64,
    /// Tests that pass the paper's test_1: the ray is not parallel to the plane.
    /// %s1 is 100 passed_1 / tests.
    pub passed_1: u64,
    /// Of these, tests that pass test_2: the line meets the plane in the triangle's
    /// box, seen along the longest component of its normal. %s2 is
    /// 100 passed_2 / passed_1.
    pub passed_2: u64,
}

/// What queries did, counted level by level; the profiled queries add to it. Zero
/// it first.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_profile {
    /// All levels together.
    pub total: hug_calls,
    /// Level by level; 0 is the deepest.
    pub level: [hug_calls; HUG_MAX_LEVELS],
}

/// Adds `seen` to the caller's numbers, which stop at the largest value.
fn add(to: &mut hug_calls, seen: &Calls) {
    to.grids = to.grids.saturating_add(seen.grids);
    to.voxels = to.voxels.saturating_add(seen.voxels);
    to.tests = to.tests.saturating_add(seen.tests);
    to.hits = to.hits.saturating_add(seen.hits);
    to.passed_1 = to.passed_1.saturating_add(seen.passed_1);
    to.passed_2 = to.passed_2.saturating_add(seen.passed_2);
}

/// [`add`] for every level.
///
/// # Safety
/// `profile` is readable and writable.
unsafe fn add_levels(profile: *mut hug_profile, seen: &Profile) {
    // SAFETY: by the caller.
    unsafe {
        let mut sum = profile.read_unaligned();
        add(&mut sum.total, &seen.total());
        sum.level.iter_mut().zip(seen.levels()).for_each(|(to, from)| add(to, from));
        profile.write_unaligned(sum);
    }
}

/// hug_intersect that also adds what it did on each level to *profile. The hit is
/// the same. With a NULL pointer: as hug_intersect, and nothing is counted.
///
/// # Safety
/// Each pointer is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_profiled(
    scene: *const hug_scene,
    ray: *const hug_ray,
    hit: *mut hug_hit,
    profile: *mut hug_profile,
) -> i32 {
    if scene.is_null() || ray.is_null() || hit.is_null() || profile.is_null() {
        // SAFETY: the same contract.
        return unsafe { hug_intersect(scene, ray, hit) };
    }
    let mut seen = Profile::default();
    // SAFETY: not NULL, valid by contract.
    unsafe {
        let found = view(scene).intersect_profiled(&read(ray), &mut seen);
        add_levels(profile, &seen);
        answer(hit, found)
    }
}

/// hug_occluded that also adds what it did on each level to *profile.
/// With a NULL pointer: as hug_occluded, and nothing is counted.
///
/// # Safety
/// Each pointer is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded_profiled(
    scene: *const hug_scene,
    ray: *const hug_ray,
    profile: *mut hug_profile,
) -> i32 {
    if scene.is_null() || ray.is_null() || profile.is_null() {
        // SAFETY: the same contract.
        return unsafe { hug_occluded(scene, ray) };
    }
    let mut seen = Profile::default();
    // SAFETY: not NULL, valid by contract.
    unsafe {
        let hit = view(scene).occluded_profiled(&read(ray), &mut seen);
        add_levels(profile, &seen);
        i32::from(hit)
    }
}

/// hug_intersect_n that also adds what it did on each level to *profile: the sum of
/// what hug_intersect_profiled counts for each ray. With profile NULL: as
/// hug_intersect_n, and nothing is counted.
///
/// # Safety
/// As hug_intersect_n; profile is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_n_profiled(
    scene: *const hug_scene,
    rays: *const hug_ray,
    ray_stride: usize,
    hits: *mut hug_hit,
    hit_stride: usize,
    n: usize,
    profile: *mut hug_profile,
) {
    if profile.is_null() {
        // SAFETY: the same contract.
        return unsafe { hug_intersect_n(scene, rays, ray_stride, hits, hit_stride, n) };
    }
    let mut seen = Profile::default();
    // SAFETY: the same contract; profile is valid.
    unsafe {
        stream::intersect(scene, (rays, ray_stride), (hits, hit_stride), n, &mut seen);
        add_levels(profile, &seen);
    }
}

/// hug_occluded_n that also adds what it did on each level to *profile: the sum of
/// what hug_occluded_profiled counts for each ray. With profile NULL: as
/// hug_occluded_n, and nothing is counted.
///
/// # Safety
/// As hug_occluded_n; profile is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded_n_profiled(
    scene: *const hug_scene,
    rays: *const hug_ray,
    ray_stride: usize,
    occluded: *mut u8,
    n: usize,
    profile: *mut hug_profile,
) {
    if profile.is_null() {
        // SAFETY: the same contract.
        return unsafe { hug_occluded_n(scene, rays, ray_stride, occluded, n) };
    }
    let mut seen = Profile::default();
    // SAFETY: the same contract; profile is valid.
    unsafe {
        stream::occluded(scene, (rays, ray_stride), occluded, n, &mut seen);
        add_levels(profile, &seen);
    }
}
