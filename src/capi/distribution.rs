//! Distributions: voxels by what they hold, triangles by length.
#![allow(non_camel_case_types)]

use super::build::hug_scene;
use super::guard::{guard, overlap};
use super::types::hug_status;
use crate::arena::View;
use crate::simd::fpenv;
use crate::stats::{Lengths, Occupancy, cumulated};
use crate::{Error, MAX_LEVELS};

/// hug_voxel_histogram.level: the voxels of all levels.
pub const HUG_ALL_LEVELS: u32 = 0xffff_ffff;

/// Voxels by the number of triangles they refer to. Zero it, set struct_size and
/// what is marked "in".
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_voxel_histogram {
    /// In: sizeof(hug_voxel_histogram).
    pub struct_size: usize,
    /// In: the level, or HUG_ALL_LEVELS.
    pub level: u32,
    /// Must be 0.
    pub reserved: u32,
    /// In: length of counts and of cumulated.
    pub capacity: usize,
    /// In: counts[i] becomes the number of voxels that refer to i triangles; the
    /// last also counts those that refer to more. NULL if not wanted.
    pub counts: *mut u64,
    /// In: cumulated[i] becomes the percentage of voxels that counts[0] to
    /// counts[i] hold. NULL if not wanted; needs counts.
    pub cumulated: *mut f64,
    /// Out: voxels.
    pub voxels: u64,
    /// Out: most triangles that a voxel refers to; a capacity of one more has room
    /// for the whole histogram.
    pub most: u64,
}

/// Section 2's statistics of a scene (figure 4). The length of a triangle is the
/// diagonal of its box. Zero it, set struct_size and what is marked "in".
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_scene_lengths {
    /// In: sizeof(hug_scene_lengths).
    pub struct_size: usize,
    /// In: length of counts and of cumulated.
    pub capacity: usize,
    /// In: triangles by length, in capacity classes of equal width from 0 to share
    /// of the largest length; longer ones are in no class. NULL if not wanted.
    pub counts: *mut u64,
    /// In: cumulated[i] becomes the percentage of all triangles that counts[0] to
    /// counts[i] hold. NULL if not wanted; needs counts.
    pub cumulated: *mut f64,
    /// In: the share, greater than 0; 0 means 0.2, where the paper's charts stop.
    pub share: f64,
    /// Out: triangles (#polys).
    pub triangles: u64,
    /// Out: the smallest length.
    pub min: f64,
    /// Out: the largest length.
    pub max: f64,
    /// Out: the diagonal of the scene's box.
    pub diagonal: f64,
    /// Out: percentage of triangles shorter than a fifth of the largest (%.2).
    pub below_fifth: f64,
}

/// The arrays that a descriptor names, or empty ones.
///
/// # Safety
/// Each is NULL or writable for `capacity` elements, for `'a`.
unsafe fn arrays<'a>(
    counts: *mut u64,
    cumulated: *mut f64,
    capacity: usize,
) -> Result<(&'a mut [u64], &'a mut [f64]), Error> {
    if counts.is_null() && !cumulated.is_null() {
        return Err(Error::Null);
    }
    if !counts.is_aligned() || !cumulated.is_aligned() {
        return Err(Error::Alignment);
    }
    let bytes = capacity.checked_mul(8).filter(|&bytes| isize::try_from(bytes).is_ok());
    let bytes = bytes.ok_or(Error::Overflow)?;
    if !counts.is_null() && overlap(counts.addr(), bytes, cumulated.addr(), bytes)? {
        return Err(Error::Overlap);
    }
    let length = |absent: bool| if absent { 0 } else { capacity };
    // SAFETY: writable by contract, apart, of a size that fits; or empty.
    unsafe {
        Ok((
            core::slice::from_raw_parts_mut(present(counts), length(counts.is_null())),
            core::slice::from_raw_parts_mut(present(cumulated), length(cumulated.is_null())),
        ))
    }
}

/// A pointer that an empty slice may have.
fn present<T>(pointer: *mut T) -> *mut T {
    if pointer.is_null() { core::ptr::dangling_mut() } else { pointer }
}

/// Whether a descriptor can be read.
fn readable<T>(scene: *const hug_scene, desc: *const T) -> Result<(), Error> {
    if scene.is_null() || desc.is_null() {
        return Err(Error::Null);
    }
    if desc.is_aligned() { Ok(()) } else { Err(Error::Alignment) }
}

/// Fills *histogram. Cost: linear in the arena, with no allocation.
/// HUG_ERROR_INVALID_VALUE for a level that the scene does not have. After an
/// error nothing was written.
///
/// # Safety
/// scene must be valid or NULL; histogram, and the arrays that it names, writable
/// or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_histogram(
    scene: *const hug_scene,
    histogram: *mut hug_voxel_histogram,
) -> hug_status {
    guard(|| {
        readable(scene, histogram)?;
        // SAFETY: not NULL, valid by contract; every descriptor begins with its size.
        let (view, size) =
            unsafe { (View::from_ptr(scene.cast()), histogram.cast::<usize>().read()) };
        if size < size_of::<hug_voxel_histogram>() {
            return Err(Error::StructSize);
        }
        // SAFETY: of full size.
        let mut desc = unsafe { histogram.read() };
        let level = (desc.level != HUG_ALL_LEVELS).then_some(desc.level as usize);
        if desc.reserved != 0 || level.is_some_and(|level| level >= levels(&view)) {
            return Err(Error::InvalidValue);
        }
        // SAFETY: writable by contract.
        let (counts, percent) = unsafe { arrays(desc.counts, desc.cumulated, desc.capacity) }?;
        let seen = Occupancy::count(&view, level, counts);
        cumulated(counts, seen.voxels, percent);
        (desc.voxels, desc.most) = (seen.voxels, seen.most);
        // SAFETY: writable by contract.
        unsafe { histogram.write(desc) };
        Ok(())
    })
}

fn levels(view: &View<'_>) -> usize {
    (view.header().levels as usize).min(MAX_LEVELS)
}

/// Fills *lengths. Cost: linear in the triangles, with no allocation. After an
/// error nothing was written.
///
/// # Safety
/// scene must be valid or NULL; lengths, and the arrays that it names, writable
/// or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_lengths(
    scene: *const hug_scene,
    lengths: *mut hug_scene_lengths,
) -> hug_status {
    guard(|| {
        readable(scene, lengths)?;
        // SAFETY: as in `hug_histogram`.
        let (view, size) =
            unsafe { (View::from_ptr(scene.cast()), lengths.cast::<usize>().read()) };
        if size < size_of::<hug_scene_lengths>() {
            return Err(Error::StructSize);
        }
        // SAFETY: of full size.
        let mut desc = unsafe { lengths.read() };
        let share = fpenv::with_default(|| match desc.share {
            0.0 => Ok(0.2),
            share if share > 0.0 && share < f64::INFINITY => Ok(share),
            _ => Err(Error::InvalidValue),
        })?;
        // SAFETY: writable by contract.
        let (counts, percent) = unsafe { arrays(desc.counts, desc.cumulated, desc.capacity) }?;
        let seen = Lengths::of(&view);
        seen.histogram(&view, share, counts);
        cumulated(counts, seen.count, percent);
        desc.triangles = seen.count;
        (desc.min, desc.max, desc.diagonal) = (seen.min, seen.max, seen.diagonal);
        desc.below_fifth = seen.percent_below_fifth();
        // SAFETY: writable by contract.
        unsafe { lengths.write(desc) };
        Ok(())
    })
}
