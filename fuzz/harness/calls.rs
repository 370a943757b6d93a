//! Every C function that takes a scene, with rays of any bits at any address, NULL among
//! them.

use super::input::Input;
use hug::capi::types::*;
use hug::capi::*;
use std::ffi::c_void;
use std::ptr::{null, null_mut};

/// A pointer that is mostly good: else NULL, or off its alignment, also that of 16-bit
/// indices, which would otherwise be read beyond their end.
pub fn pointer<T>(input: &mut Input<'_>, good: *const T) -> *const T {
    match input.below(32) {
        30 => null(),
        31 => good.wrapping_byte_add(1 | input.below(3)),
        _ => good,
    }
}

/// The functions, one after the other.
pub fn query(scene: *const hug_scene, input: &mut Input<'_>) {
    let mut bytes = [0u8; 24 * 48 + 3];
    for byte in &mut bytes {
        *byte = input.byte();
    }
    let shift = input.below(4);
    let rays: *const hug_ray = bytes[shift..].as_ptr().cast();
    let mut hits = [0u8; 24 * 48 + 3];
    let out: *mut hug_hit = hits[shift..].as_mut_ptr().cast();
    let mut shadows = [2u8; 24];
    let scene = if input.rarely(16) { null() } else { scene };
    let (ray_stride, hit_stride) = (input.one_of(&[0, 48]), input.one_of(&[0, 40, 48]));
    let (mut lower, mut upper) = ([0f32; 3], [0f32; 3]);
    // SAFETY: all of it is readable and writable, or NULL.
    unsafe {
        let mut counters: hug_counters = std::mem::zeroed();
        hug_intersect_counted(scene, rays, out, &mut counters);
        hug_intersect_n(scene, rays, ray_stride, out, hit_stride, 24);
        hug_occluded_n(scene, rays, ray_stride, shadows.as_mut_ptr(), 24);
        for i in 0..3 {
            let ray = pointer(input, rays.byte_add(48 * i));
            let hit = pointer(input, out.cast_const());
            let found = hug_intersect(scene, ray, hit.cast_mut());
            let any = hug_occluded(scene, ray);
            let within = hug_occluded_within(scene, ray, input.long());
            assert!(within == any || within == HUG_TRUNCATED);
            assert_eq!(found, if hit.is_null() { 0 } else { any });
        }
        more_queries(scene, rays, out, input);
        let mut stats: hug_scene_stats = std::mem::zeroed();
        stats.struct_size = if input.rarely(4) { input.below(512) } else { size_of_val(&stats) };
        assert_ne!(hug_stats(scene, &mut stats), HUG_ERROR_INTERNAL);
        let mut counts = [0u64; 8];
        let mut histogram: hug_voxel_histogram = std::mem::zeroed();
        histogram.struct_size = size_of_val(&histogram);
        (histogram.level, histogram.capacity) = (input.below(18) as u32, 8);
        histogram.counts = counts.as_mut_ptr();
        assert_ne!(hug_histogram(scene, &mut histogram), HUG_ERROR_INTERNAL);
        hug_bounds(scene, lower.as_mut_ptr(), upper.as_mut_ptr());
        let mut len = 0;
        let data = hug_data(scene, &mut len);
        assert_eq!(data.is_null(), scene.is_null());
        let mut again = null();
        if !data.is_null() {
            assert_eq!(hug_open(data, len, 0, &mut again), HUG_OK);
        }
    }
}

/// Accepts every other hit, and sees that it is given some.
unsafe extern "C" fn accept(
    user: *mut c_void,
    _: usize,
    ray: *const hug_ray,
    hit: *const hug_hit,
) -> i32 {
    assert!(!ray.is_null() && !hit.is_null());
    // SAFETY: `user` is a counter, used by one thread.
    let calls = unsafe { &mut *user.cast::<u32>() };
    *calls += 1;
    (*calls % 2) as i32
}

/// All hits, filters, arrays, the nearest point and the distributions.
///
/// # Safety
/// The scene is one or NULL; 24 rays and hits are there, of any alignment.
unsafe fn more_queries(
    scene: *const hug_scene,
    rays: *const hug_ray,
    out: *mut hug_hit,
    input: &mut Input<'_>,
) {
    // SAFETY: by the caller, or NULL; arrays have the length that is told.
    unsafe {
        let (mut count, mut more, mut calls) = (0usize, 0, 0u32);
        let user = (&raw mut calls).cast();
        let room = input.below(24);
        let (ray, after) = (pointer(input, rays), input.rarely(2).then_some(out.add(23)));
        let status = hug_intersect_all(
            scene,
            ray,
            after.map_or(null(), |hit| hit.cast_const()),
            pointer(input, out.cast_const()).cast_mut(),
            if input.rarely(16) { usize::MAX - room } else { room },
            &mut count,
            &mut more,
        );
        assert_ne!(status, HUG_ERROR_INTERNAL);
        assert!(count <= room && (status == HUG_OK || count == 0));
        let some = if input.rarely(4) { None } else { Some(accept as _) };
        hug_intersect_filtered(scene, pointer(input, rays), out, some, user);
        hug_occluded_filtered(scene, pointer(input, rays), some, user);
        hug_intersect_n_filtered(scene, rays, 0, out, 0, 24, some, user);
        let mut shadows = [0u8; 24];
        hug_occluded_n_filtered(scene, rays, 0, shadows.as_mut_ptr(), 24, some, user);
        hug_intersect_triangle(pointer(input, rays), rays.cast(), out);
        let mut near: hug_nearest = std::mem::zeroed();
        let found = hug_closest_point(scene, pointer(input, rays.cast()), &mut near);
        assert_eq!(found != 0, near.geom != u32::MAX);
        let mut steps = [0u64; 2];
        hug_most_steps(scene, pointer(input, steps.as_mut_ptr().cast_const()).cast_mut());
        hug_intersect_within(scene, pointer(input, rays), out, input.long());
        let mut profile: hug_profile = std::mem::zeroed();
        let seen = pointer(input, &raw const profile).cast_mut();
        if seen.is_null() || seen == &raw mut profile {
            hug_intersect_profiled(scene, rays, out, seen);
            hug_occluded_n_profiled(scene, rays, 0, shadows.as_mut_ptr(), 24, seen);
        }
        arrays(scene, rays.cast(), input);
    }
}

/// A column of numbers for each component, some of them missing or at odd addresses.
///
/// # Safety
/// The scene is one or NULL; 24 rays' worth of numbers are there, of any alignment.
unsafe fn arrays(scene: *const hug_scene, numbers: *const f32, input: &mut Input<'_>) {
    let mut floats = [0f32; 7 * 8];
    let mut ids = [0u32; 2 * 8];
    let mut counts = [0u64; 8];
    let mut shares = [0f64; 8];
    // SAFETY: each array has eight elements or more; zeros are a value of every field.
    unsafe {
        let mut rays: hug_ray_soa = std::mem::zeroed();
        rays.struct_size = size_of_val(&rays) - if input.rarely(8) { input.below(64) } else { 0 };
        for k in 0..3 {
            rays.org[k] = pointer(input, numbers.add(8 * k));
            rays.dir[k] = pointer(input, numbers.add(8 * (3 + k)));
        }
        if input.rarely(2) {
            (rays.tmin, rays.tmax) = (numbers.add(48), pointer(input, numbers.add(56)));
            rays.mask = numbers.add(64).cast();
            (rays.skip_geom, rays.skip_prim) = (rays.mask, pointer(input, rays.mask));
        }
        let mut hits: hug_hit_soa = std::mem::zeroed();
        hits.struct_size = size_of_val(&hits) - if input.rarely(8) { input.below(64) } else { 0 };
        let column = |k: usize, floats: &mut [f32]| floats[8 * k..].as_mut_ptr();
        (hits.t, hits.u) = (column(0, &mut floats), null_mut());
        hits.ng = [1, 2, 3].map(|k| column(k, &mut floats));
        (hits.geom, hits.prim) = (ids.as_mut_ptr(), ids[8..].as_mut_ptr());
        let (r, h) = (pointer(input, &raw const rays), pointer(input, &raw const hits));
        assert_ne!(hug_intersect_soa(scene, r, h, 8), HUG_ERROR_INTERNAL);
        let mut shadows = [0u8; 8];
        let status = hug_occluded_soa(scene, r, shadows.as_mut_ptr(), 8);
        assert_ne!(status, HUG_ERROR_INTERNAL);
        let mut lengths: hug_scene_lengths = std::mem::zeroed();
        lengths.struct_size = size_of_val(&lengths);
        (lengths.capacity, lengths.share) = (input.below(9), f64::from(input.float()));
        lengths.counts = pointer(input, counts.as_mut_ptr().cast_const()).cast_mut();
        lengths.cumulated = pointer(input, shares.as_mut_ptr().cast_const()).cast_mut();
        assert_ne!(hug_lengths(scene, &mut lengths), HUG_ERROR_INTERNAL);
    }
}
