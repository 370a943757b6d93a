//! Queries that ask the caller about each hit.
#![allow(non_camel_case_types)]

use core::ffi::c_void;

use super::build::hug_scene;
use super::query::{answer, hug_intersect, hug_occluded, read, view};
use super::stream::{Strided, hug_intersect_n, hug_occluded_n};
use super::types::{hug_hit, hug_ray};
use crate::trace::Flags;
use crate::{Hit, Ray};

/// Says whether a hit counts: nonzero accepts it, 0 lets the ray pass through. index is
/// the ray's place in the stream, or 0; ray and hit are copies that live until it returns.
/// It may query any scene; it must not write to the rays or answers of the stream it is
/// called for, and must return (no longjmp, no exception).
pub type hug_filter_fn = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        index: usize,
        ray: *const hug_ray,
        hit: *const hug_hit,
    ) -> i32,
>;

/// A filter that is there.
struct Filter {
    call: unsafe extern "C" fn(*mut c_void, usize, *const hug_ray, *const hug_hit) -> i32,
    user: *mut c_void,
}

impl Filter {
    fn accepts(&self, index: usize, ray: &Ray, hit: &Hit) -> bool {
        let (ray, hit) = ((&raw const *ray).cast(), (&raw const *hit).cast());
        // SAFETY: the caller's function, called as documented.
        unsafe { (self.call)(self.user, index, ray, hit) != 0 }
    }
}

/// hug_intersect that asks filter about hits: finds the closest one that it accepts. A
/// triangle is offered once at most, in no order to rely on, with the hit that
/// hug_intersect would write; filter is called on this thread, with user. A rejected hit
/// takes about as long as another ray that starts there. With filter NULL every hit is
/// accepted. With scene, ray or hit NULL: as hug_intersect, and nobody is asked.
///
/// # Safety
/// Each pointer is valid or NULL; filter is a hug_filter_fn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_filtered(
    scene: *const hug_scene,
    ray: *const hug_ray,
    hit: *mut hug_hit,
    filter: hug_filter_fn,
    user: *mut c_void,
) -> i32 {
    let Some(call) = filter.filter(|_| !(scene.is_null() || ray.is_null() || hit.is_null())) else {
        // SAFETY: the same contract.
        return unsafe { hug_intersect(scene, ray, hit) };
    };
    let filter = Filter { call, user };
    // SAFETY: not NULL, valid by contract.
    unsafe {
        let ray = read(ray);
        let found = view(scene).intersect_filtered(&ray, |hit| filter.accepts(0, &ray, hit));
        answer(hit, found)
    }
}

/// Whether anything is hit that filter accepts: 1 or 0. Hits are offered as by
/// hug_intersect_filtered. With filter NULL: hug_occluded. With scene or ray NULL: 0, and
/// nobody is asked.
///
/// # Safety
/// Each pointer is valid or NULL; filter is a hug_filter_fn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded_filtered(
    scene: *const hug_scene,
    ray: *const hug_ray,
    filter: hug_filter_fn,
    user: *mut c_void,
) -> i32 {
    let Some(call) = filter.filter(|_| !(scene.is_null() || ray.is_null())) else {
        // SAFETY: the same contract.
        return unsafe { hug_occluded(scene, ray) };
    };
    let filter = Filter { call, user };
    // SAFETY: not NULL, valid by contract.
    let ray = unsafe { read(ray) };
    // SAFETY: not NULL, valid by contract.
    let view = unsafe { view(scene) };
    i32::from(view.occluded_filtered(&ray, |hit| filter.accepts(0, &ray, hit)))
}

/// hug_intersect_n that asks filter about hits: answers are those of
/// hug_intersect_filtered, in the order of the rays; the rays may be asked about in any
/// order. With filter NULL: hug_intersect_n. With another pointer NULL, but user, nothing
/// is done.
///
/// # Safety
/// As hug_intersect_n; filter is a hug_filter_fn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_n_filtered(
    scene: *const hug_scene,
    rays: *const hug_ray,
    ray_stride: usize,
    hits: *mut hug_hit,
    hit_stride: usize,
    n: usize,
    filter: hug_filter_fn,
    user: *mut c_void,
) {
    let Some(call) = filter else {
        // SAFETY: the same contract.
        return unsafe { hug_intersect_n(scene, rays, ray_stride, hits, hit_stride, n) };
    };
    if !(scene.is_null() || rays.is_null() || hits.is_null()) {
        let mut port = Strided::<Hit>::new(rays, ray_stride, hits.cast(), hit_stride);
        // SAFETY: not NULL, valid by contract.
        let view = unsafe { view(scene) };
        let filter = Filter { call, user };
        let accept = &mut |i, ray: &Ray, hit: &Hit| filter.accepts(i, ray, hit);
        view.filtered(&mut port, n, accept);
    }
}

/// hug_occluded_n that asks filter about hits: answers are those of
/// hug_occluded_filtered, in the order of the rays; the rays may be asked about in any
/// order. With filter NULL: hug_occluded_n. With another pointer NULL, but user, nothing
/// is done.
///
/// # Safety
/// As hug_occluded_n; filter is a hug_filter_fn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded_n_filtered(
    scene: *const hug_scene,
    rays: *const hug_ray,
    ray_stride: usize,
    occluded: *mut u8,
    n: usize,
    filter: hug_filter_fn,
    user: *mut c_void,
) {
    let Some(call) = filter else {
        // SAFETY: the same contract.
        return unsafe { hug_occluded_n(scene, rays, ray_stride, occluded, n) };
    };
    if !(scene.is_null() || rays.is_null() || occluded.is_null()) {
        let mut port = Strided::<u8>::new(rays, ray_stride, occluded, 0);
        // SAFETY: not NULL, valid by contract.
        let view = unsafe { view(scene) };
        let filter = Filter { call, user };
        let accept = &mut |i, ray: &Ray, hit: &Hit| filter.accepts(i, ray, hit);
        view.filtered(&mut Flags(&mut port), n, accept);
    }
}
