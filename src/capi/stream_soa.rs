//! Queries of many rays, an array for each component.

use core::mem::offset_of;

use super::build::hug_scene;
use super::guard::guard;
use super::query::view;
use super::sized;
use super::types::{hug_hit_soa, hug_ray_soa, hug_status};
use crate::trace::{Port, Uncounted};
use crate::{Error, Hit, NONE, Ray};

/// Element `i` of an array of any alignment, or `default` where there is none.
///
/// # Safety
/// `array` is NULL or has a readable element `i`.
unsafe fn at<T: Copy>(array: *const T, i: usize, default: T) -> T {
    // SAFETY: by the caller.
    if array.is_null() { default } else { unsafe { array.add(i).read_unaligned() } }
}

/// Writes element `i`, if there is an array.
///
/// # Safety
/// `array` is NULL or has a writable element `i`.
unsafe fn put<T>(array: *mut T, i: usize, value: T) {
    if !array.is_null() {
        // SAFETY: by the caller.
        unsafe { array.add(i).write_unaligned(value) };
    }
}

/// Rays in arrays that the functions below have readable, and where answers go.
struct Arrays<A> {
    rays: hug_ray_soa,
    answers: A,
}

impl<A> Arrays<A> {
    /// Reads the arrays' places; the six of origin and direction must be there.
    ///
    /// # Safety
    /// As [`sized::read`].
    unsafe fn new(rays: *const hug_ray_soa, answers: A) -> Result<Self, Error> {
        // SAFETY: by the caller; zeros are a value of every field.
        let rays = unsafe { sized::read(rays, offset_of!(hug_ray_soa, flags)) }?;
        let all = rays.org.iter().chain(&rays.dir).all(|p| !p.is_null());
        if all { Ok(Self { rays, answers }) } else { Err(Error::Null) }
    }

    fn read(&self, i: usize) -> Ray {
        let r = &self.rays;
        // SAFETY: arrays that are there are readable for every ray.
        unsafe {
            Ray {
                org: [at(r.org[0], i, 0.0), at(r.org[1], i, 0.0), at(r.org[2], i, 0.0)],
                tmin: at(r.tmin, i, 0.0),
                dir: [at(r.dir[0], i, 0.0), at(r.dir[1], i, 0.0), at(r.dir[2], i, 0.0)],
                tmax: at(r.tmax, i, f32::INFINITY),
                mask: at(r.mask, i, u32::MAX),
                flags: at(r.flags, i, 0),
                skip_geom: at(r.skip_geom, i, NONE),
                skip_prim: at(r.skip_prim, i, NONE),
            }
        }
    }
}

impl Port<Hit> for Arrays<hug_hit_soa> {
    fn ray(&mut self, i: usize, to: &mut Ray) {
        *to = self.read(i);
    }

    fn put(&mut self, i: usize, hit: Hit) {
        let to = &self.answers;
        // SAFETY: arrays that are there are writable for every ray.
        unsafe {
            put(to.t, i, hit.t);
            put(to.u, i, hit.u);
            put(to.v, i, hit.v);
            for (array, x) in to.ng.iter().zip(hit.ng) {
                put(*array, i, x);
            }
            put(to.geom, i, hit.geom);
            put(to.prim, i, hit.prim);
            put(to.inst, i, hit.inst);
        }
    }
}

impl Port<bool> for Arrays<*mut u8> {
    fn ray(&mut self, i: usize, to: &mut Ray) {
        *to = self.read(i);
    }

    fn put(&mut self, i: usize, answer: bool) {
        // SAFETY: writable for every ray.
        unsafe { put(self.answers, i, u8::from(answer)) };
    }
}

/// hug_intersect_n with an array for each component of rays and hits. Arrays need
/// no alignment beyond that of floats and integers of any address; an array of hits
/// may be one of rays, element for element, but must not overlap otherwise.
///
/// HUG_ERROR_NULL: scene, rays, hits, or an array of org or dir is NULL;
/// HUG_ERROR_ALIGNMENT, HUG_ERROR_STRUCT_SIZE: a descriptor is not one. Nothing is
/// done then.
///
/// # Safety
/// Each pointer is valid or NULL, arrays for n elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_soa(
    scene: *const hug_scene,
    rays: *const hug_ray_soa,
    hits: *const hug_hit_soa,
    n: usize,
) -> hug_status {
    guard(|| {
        if scene.is_null() {
            return Err(Error::Null);
        }
        // SAFETY: valid or NULL by contract; zeros are a value of every field.
        unsafe {
            let hits = sized::read(hits, size_of::<hug_hit_soa>())?;
            let mut port = Arrays::new(rays, hits)?;
            view(scene).intersect_port(&mut port, n, &mut Uncounted);
        }
        Ok(())
    })
}

/// hug_occluded_n with an array for each component of rays. Errors as
/// hug_intersect_soa.
///
/// # Safety
/// Each pointer is valid or NULL, arrays for n elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded_soa(
    scene: *const hug_scene,
    rays: *const hug_ray_soa,
    occluded: *mut u8,
    n: usize,
) -> hug_status {
    guard(|| {
        if scene.is_null() || occluded.is_null() {
            return Err(Error::Null);
        }
        // SAFETY: valid or NULL by contract.
        unsafe {
            let mut port = Arrays::new(rays, occluded)?;
            view(scene).occluded_port(&mut port, n, &mut Uncounted);
        }
        Ok(())
    })
}
