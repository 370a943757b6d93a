//! The functions of the C interface as a C program calls them: through pointers that the compiler
//! cannot see through, so that nothing is inlined across the boundary.
//!
//! # Safety
//! The handle lives no longer than the scene whose arena it names; every call passes pointers to
//! as many records as it says.
// Each program calls a part of them.
#![allow(dead_code)]

use hug::capi::types::{HUG_OK, HUG_OPEN_TRUSTED, hug_hit, hug_ray};
use hug::capi::{
    hug_intersect, hug_intersect_n, hug_occluded, hug_occluded_n, hug_open, hug_scene,
};
use hug::{Hit, Ray, Scene};
use std::hint::black_box;
use std::marker::PhantomData;

type Intersect = unsafe extern "C" fn(*const hug_scene, *const hug_ray, *mut hug_hit) -> i32;
type Occluded = unsafe extern "C" fn(*const hug_scene, *const hug_ray) -> i32;
type IntersectN =
    unsafe extern "C" fn(*const hug_scene, *const hug_ray, usize, *mut hug_hit, usize, usize);
type OccludedN = unsafe extern "C" fn(*const hug_scene, *const hug_ray, usize, *mut u8, usize);

/// A scene as C sees it.
#[derive(Clone, Copy)]
pub struct Handle<'a> {
    scene: *const hug_scene,
    intersect: Intersect,
    occluded: Occluded,
    intersect_n: IntersectN,
    occluded_n: OccludedN,
    marker: PhantomData<&'a Scene>,
}

impl<'a> Handle<'a> {
    pub fn new(scene: &'a Scene) -> Self {
        let bytes = scene.view().bytes();
        let mut out = std::ptr::null();
        // SAFETY: the arena is one that the build wrote, and outlives the handle.
        let status =
            unsafe { hug_open(bytes.as_ptr().cast(), bytes.len(), HUG_OPEN_TRUSTED, &raw mut out) };
        assert_eq!(status, HUG_OK, "a built arena opens");
        Self {
            scene: out,
            intersect: black_box(hug_intersect),
            occluded: black_box(hug_occluded),
            intersect_n: black_box(hug_intersect_n),
            occluded_n: black_box(hug_occluded_n),
            marker: PhantomData,
        }
    }

    #[inline]
    pub fn intersect(&self, ray: &Ray, hit: &mut Hit) -> bool {
        // SAFETY: one ray, one hit, of the layouts of the C records.
        unsafe {
            (self.intersect)(self.scene, (&raw const *ray).cast(), (&raw mut *hit).cast()) != 0
        }
    }

    #[inline]
    pub fn occluded(&self, ray: &Ray) -> bool {
        // SAFETY: one ray of the layout of the C record.
        unsafe { (self.occluded)(self.scene, (&raw const *ray).cast()) != 0 }
    }

    /// One hit a ray.
    pub fn intersect_n(&self, rays: &[Ray], hits: &mut [Hit]) {
        assert_eq!(rays.len(), hits.len());
        let (from, to) = (rays.as_ptr().cast(), hits.as_mut_ptr().cast());
        // SAFETY: as many hits as rays, packed.
        unsafe { (self.intersect_n)(self.scene, from, 0, to, 0, rays.len()) }
    }

    /// One answer a ray.
    pub fn occluded_n(&self, rays: &[Ray], answers: &mut [u8]) {
        assert_eq!(rays.len(), answers.len());
        let from = rays.as_ptr().cast();
        // SAFETY: as many answers as rays, packed.
        unsafe { (self.occluded_n)(self.scene, from, 0, answers.as_mut_ptr(), rays.len()) }
    }
}
