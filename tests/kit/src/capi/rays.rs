//! Ray sets for C.

use super::{Error, input, inputs, outputs, status, value};
use crate::rays::{self, Hit, Ray};
use crate::{Bounds, View};

const MAX_FRAME: u32 = 16384;

/// The number of rays in a frame.
fn frame(size: u32) -> Result<usize, Error> {
    match size {
        1..=MAX_FRAME => Ok(size as usize * size as usize),
        _ => Err(Error::Range),
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn kit_primary_count(size: u32) -> usize {
    frame(size).unwrap_or(0)
}

/// # Safety
/// `view` is NULL or valid for a read, `out` NULL or valid for writes of `capacity` rays,
/// `written` NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_rays_primary(
    view: *const View,
    size: u32,
    out: *mut Ray,
    capacity: usize,
    written: *mut usize,
) -> i32 {
    // SAFETY: all by the caller's promise.
    status(|| unsafe {
        let view = input(view)?;
        frame(size)?;
        outputs(out, capacity, written, rays::primary(view, size))
    })
}

/// # Safety
/// `xy` is NULL or valid for writes of `capacity` values, `written` NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_primary_pixels(
    size: u32,
    xy: *mut u32,
    capacity: usize,
    written: *mut usize,
) -> i32 {
    // SAFETY: all by the caller's promise.
    status(|| unsafe {
        frame(size)?;
        outputs(xy, capacity, written, rays::primary_pixels(size).flatten())
    })
}

/// # Safety
/// `hits` is NULL or valid for reads of `size` x `size` hits.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_shadow_count(size: u32, hits: *const Hit) -> usize {
    // SAFETY: the caller's promise.
    value(0, || unsafe {
        let hits = inputs(hits, frame(size).ok()?).ok()?;
        Some(rays::shadow_count(size, hits))
    })
}

/// # Safety
/// `bounds` is NULL or valid for a read, `rays` and `hits` are NULL or valid for reads of
/// `size` x `size` values, `out` is NULL or valid for writes of `capacity` rays and overlaps
/// neither, `written` is NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_rays_shadow(
    bounds: *const Bounds,
    size: u32,
    rays: *const Ray,
    hits: *const Hit,
    out: *mut Ray,
    capacity: usize,
    written: *mut usize,
) -> i32 {
    // SAFETY: all by the caller's promise.
    status(|| unsafe {
        let n = frame(size)?;
        let (bounds, rays, hits) = (input(bounds)?, inputs(rays, n)?, inputs(hits, n)?);
        let shadow = rays::shadow(bounds, size, rays, hits);
        outputs(out, capacity, written, shadow)
    })
}

/// # Safety
/// `hits` is NULL or valid for reads of `n` hits.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_bounce_count(hits: *const Hit, n: usize) -> usize {
    // SAFETY: the caller's promise.
    value(0, || unsafe { Some(rays::bounce_count(inputs(hits, n).ok()?)) })
}

/// # Safety
/// `bounds` is NULL or valid for a read, `rays` and `hits` are NULL or valid for reads of `n`
/// values, `out` is NULL or valid for writes of `capacity` rays and overlaps neither, `written`
/// is NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_rays_bounce(
    number: u32,
    bounds: *const Bounds,
    rays: *const Ray,
    hits: *const Hit,
    n: usize,
    out: *mut Ray,
    capacity: usize,
    written: *mut usize,
) -> i32 {
    // SAFETY: all by the caller's promise.
    status(|| unsafe {
        if !(1..=2).contains(&number) {
            return Err(Error::Range);
        }
        let (bounds, rays, hits) = (input(bounds)?, inputs(rays, n)?, inputs(hits, n)?);
        let bounce = rays::bounce(number, bounds, rays, hits);
        outputs(out, capacity, written, bounce)
    })
}

/// # Safety
/// `bounds` is NULL or valid for a read, `out` NULL or valid for writes of `n` rays.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_rays_random(bounds: *const Bounds, out: *mut Ray, n: usize) -> i32 {
    let mut written = 0;
    // SAFETY: all by the caller's promise.
    status(|| unsafe {
        let rays = rays::random(input(bounds)?).take(n);
        outputs(out, n, &mut written, rays)
    })
}
