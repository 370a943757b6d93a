//! Queries of many rays, records with strides.

use super::build::hug_scene;
use super::query::{add, read, view};
use super::types::{hug_counters, hug_hit, hug_ray};
use crate::trace::{Count, Counters, Port, Uncounted};
use crate::{Hit, Ray};

/// Rays and answers at strides in bytes.
pub(super) struct Strided<A> {
    rays: *const hug_ray,
    ray_stride: usize,
    answers: *mut A,
    answer_stride: usize,
}

impl<A> Strided<A> {
    /// Strides of 0 mean packed.
    pub(super) fn new(
        rays: *const hug_ray,
        ray_stride: usize,
        answers: *mut A,
        stride: usize,
    ) -> Self {
        let ray_stride = if ray_stride == 0 { size_of::<hug_ray>() } else { ray_stride };
        let answer_stride = if stride == 0 { size_of::<A>() } else { stride };
        Self { rays, ray_stride, answers, answer_stride }
    }

    /// Reads ray `i`.
    fn read(&self, i: usize) -> Ray {
        // SAFETY: the functions below have rays readable at their strides.
        unsafe { read(self.rays.byte_add(i * self.ray_stride)) }
    }

    /// Writes answer `i`.
    fn write(&self, i: usize, answer: A) {
        // SAFETY: the functions below have answers writable at their strides.
        unsafe { self.answers.byte_add(i * self.answer_stride).write_unaligned(answer) };
    }
}

impl Port<Hit> for Strided<Hit> {
    fn ray(&mut self, i: usize, to: &mut Ray) {
        *to = self.read(i);
    }

    fn put(&mut self, i: usize, answer: Hit) {
        self.write(i, answer);
    }
}

impl Port<bool> for Strided<u8> {
    fn ray(&mut self, i: usize, to: &mut Ray) {
        *to = self.read(i);
    }

    fn put(&mut self, i: usize, answer: bool) {
        self.write(i, u8::from(answer));
    }
}

/// [`hug_intersect_n`], told to `counters`.
///
/// # Safety
/// As [`hug_intersect_n`].
pub(super) unsafe fn intersect(
    scene: *const hug_scene,
    (rays, ray_stride): (*const hug_ray, usize),
    (hits, hit_stride): (*mut hug_hit, usize),
    n: usize,
    counters: &mut impl Count,
) {
    if scene.is_null() || rays.is_null() || hits.is_null() {
        return;
    }
    let mut port = Strided::<Hit>::new(rays, ray_stride, hits.cast(), hit_stride);
    // SAFETY: valid by contract, for every i below n.
    unsafe { view(scene) }.intersect_port(&mut port, n, counters);
}

/// [`hug_occluded_n`], told to `counters`.
///
/// # Safety
/// As [`hug_occluded_n`].
pub(super) unsafe fn occluded(
    scene: *const hug_scene,
    (rays, ray_stride): (*const hug_ray, usize),
    occluded: *mut u8,
    n: usize,
    counters: &mut impl Count,
) {
    if scene.is_null() || rays.is_null() || occluded.is_null() {
        return;
    }
    let mut port = Strided::new(rays, ray_stride, occluded, 0);
    // SAFETY: valid by contract, for every i below n.
    unsafe { view(scene) }.occluded_port(&mut port, n, counters);
}

/// Finds the closest hits of n rays. Ray i is at rays + i * ray_stride bytes,
/// hit i at hits + i * hit_stride; a stride of 0 means packed. Rays and hits
/// may be fields of one array's elements, but must not overlap otherwise.
/// Results are those of hug_intersect, bit for bit, in the order of the rays.
/// With a NULL pointer nothing is done.
///
/// Where 64 rays in a row come from one point and go much the same way, as tiles of 8 by 8
/// pixels of a camera do, they go together, and take a third of the time of calls of their
/// own, or less. 256 or more others in a scene with a tree of boxes (HUG_BUILD_TREE) go down
/// that together and take 0.7 to 1 of that time; in one without, up to 32 are under way at a
/// time, and some dozens or more take about half of it. It takes up to 48 kB of stack, of 256
/// rays or more 256 kB.
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
    // SAFETY: the same contract.
    unsafe { intersect(scene, (rays, ray_stride), (hits, hit_stride), n, &mut Uncounted) };
}

/// Whether anything is hit, for n rays: occluded[i] becomes 1 or 0. Ray i is
/// at rays + i * ray_stride bytes; a stride of 0 means packed. With a NULL
/// pointer nothing is done. Otherwise as hug_intersect_n.
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
    // SAFETY: the same contract.
    unsafe { self::occluded(scene, (rays, ray_stride), occluded, n, &mut Uncounted) };
}

/// hug_intersect_n that also adds what it did to *counters: the sum of what
/// hug_intersect_counted counts for each ray. With counters NULL: as
/// hug_intersect_n, and nothing is counted.
///
/// # Safety
/// As hug_intersect_n; counters is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_n_counted(
    scene: *const hug_scene,
    rays: *const hug_ray,
    ray_stride: usize,
    hits: *mut hug_hit,
    hit_stride: usize,
    n: usize,
    counters: *mut hug_counters,
) {
    if counters.is_null() {
        // SAFETY: the same contract.
        return unsafe { hug_intersect_n(scene, rays, ray_stride, hits, hit_stride, n) };
    }
    let mut seen = Counters::default();
    // SAFETY: the same contract; counters is valid.
    unsafe {
        intersect(scene, (rays, ray_stride), (hits, hit_stride), n, &mut seen);
        add(counters, &seen);
    }
}

/// hug_occluded_n that also adds what it did to *counters: the sum of what
/// hug_occluded_counted counts for each ray. With counters NULL: as hug_occluded_n,
/// and nothing is counted.
///
/// # Safety
/// As hug_occluded_n; counters is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded_n_counted(
    scene: *const hug_scene,
    rays: *const hug_ray,
    ray_stride: usize,
    occluded: *mut u8,
    n: usize,
    counters: *mut hug_counters,
) {
    if counters.is_null() {
        // SAFETY: the same contract.
        return unsafe { hug_occluded_n(scene, rays, ray_stride, occluded, n) };
    }
    let mut seen = Counters::default();
    // SAFETY: the same contract; counters is valid.
    unsafe {
        self::occluded(scene, (rays, ray_stride), occluded, n, &mut seen);
        add(counters, &seen);
    }
}
