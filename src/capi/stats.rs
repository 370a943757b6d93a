//! What a scene holds, and what the library is.

use core::ffi::{CStr, c_char};

use super::build::hug_scene;
use super::guard::guard;
use super::types::{
    HUG_MAX_LEVELS, hug_level_shares, hug_level_stats, hug_scene_stats, hug_status,
};
use crate::arena::View;
use crate::stats::{Level, Stats};
use crate::{Error, Isa, force_isa};

/// Sizes of earlier versions of [`hug_scene_stats`].
const EARLIER_STATS: [usize; 2] = [
    core::mem::offset_of!(hug_scene_stats, total_share),
    core::mem::offset_of!(hug_scene_stats, node_bytes),
];

/// Fills *stats (struct_size set by the caller) with the statistics of
/// section 3 of the paper. Cost: linear in the arena, with no allocation.
///
/// # Safety
/// scene must be valid or NULL, stats writable or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_stats(
    scene: *const hug_scene,
    stats: *mut hug_scene_stats,
) -> hug_status {
    guard(|| {
        if scene.is_null() || stats.is_null() {
            return Err(Error::Null);
        }
        if !stats.is_aligned() {
            return Err(Error::Alignment);
        }
        // SAFETY: not NULL, valid by contract.
        let (view, size) = unsafe { (View::from_ptr(scene.cast()), stats.cast::<usize>().read()) };
        let known = size_of::<hug_scene_stats>();
        if size < known && !EARLIER_STATS.contains(&size) {
            return Err(Error::StructSize);
        }
        let s = Stats::of(&view);
        let mut level = [mirror(&Level::default()); HUG_MAX_LEVELS];
        for (to, from) in level.iter_mut().zip(s.levels()) {
            *to = mirror(from);
        }
        let mut level_share = [shares(&s, &Level::default()); HUG_MAX_LEVELS];
        for (to, from) in level_share.iter_mut().zip(s.levels()) {
            *to = shares(&s, from);
        }
        let all = hug_scene_stats {
            struct_size: size,
            structure: s.structure as u32,
            levels: s.levels().len() as u32,
            triangles: s.triangles,
            dropped_non_finite: s.dropped_non_finite,
            dropped_degenerate: s.dropped_degenerate,
            counts: s.counts,
            reserved: 0,
            bytes: s.bytes,
            triangle_bytes: s.triangle_bytes,
            grid_bytes: s.grid_bytes,
            voxel_bytes: s.voxel_bytes,
            ref_bytes: s.ref_bytes,
            total: mirror(&s.total),
            level,
            total_share: shares(&s, &s.total),
            level_share,
            node_bytes: s.node_bytes,
        };
        // SAFETY: writable by contract, for the size that the caller stated.
        unsafe {
            let bytes = (&raw const all).cast::<u8>();
            stats.cast::<u8>().copy_from_nonoverlapping(bytes, size.min(known));
        }
        Ok(())
    })
}

fn mirror(l: &Level) -> hug_level_stats {
    let (o, of) = (l.objects_per_voxel(), l.objects_per_filled_voxel());
    let (g, gf) = (l.grids_per_voxel(), l.grids_per_filled_voxel());
    hug_level_stats {
        objects: l.objects,
        grids: l.grids,
        voxels: l.voxels,
        object_voxels: l.object_voxels,
        grid_voxels: l.grid_voxels,
        object_refs: l.object_refs,
        grid_refs: l.grid_refs,
        volume: l.volume,
        object_mean: o.mean,
        object_deviation: o.deviation,
        object_mean_filled: of.mean,
        object_deviation_filled: of.deviation,
        grid_mean: g.mean,
        grid_deviation: g.deviation,
        grid_mean_filled: gf.mean,
        grid_deviation_filled: gf.deviation,
        bytes: l.bytes,
    }
}

fn shares(s: &Stats, l: &Level) -> hug_level_shares {
    let share = s.shares(l);
    hug_level_shares {
        objects: share.objects,
        objects_of_levels: share.objects_of_levels,
        grids: share.grids,
        voxels: share.voxels,
        pointers: share.pointers,
        volume: share.volume,
        bytes: share.bytes,
        object_voxels: share.object_voxels,
        grid_voxels: share.grid_voxels,
        objects_per_grid: l.objects_per_grid(),
        objects_per_grid_printed: share.objects_per_grid_printed(),
        distinct_per_voxel: l.distinct_per_voxel(),
        distinct_per_filled_voxel: l.distinct_per_filled_voxel(),
    }
}

/// The box of the scene's triangles: lower[3] and upper[3], in the units of the
/// scene. An empty scene gives lower = +infinity, upper = -infinity.
///
/// # Safety
/// scene must be valid or NULL, lower and upper writable (3 floats) or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_bounds(
    scene: *const hug_scene,
    lower: *mut f32,
    upper: *mut f32,
) -> hug_status {
    guard(|| {
        if scene.is_null() || lower.is_null() || upper.is_null() {
            return Err(Error::Null);
        }
        // SAFETY: not NULL, valid by contract.
        unsafe {
            let (lo, hi) = View::from_ptr(scene.cast()).bounds();
            lower.cast::<[f32; 3]>().write_unaligned(lo);
            upper.cast::<[f32; 3]>().write_unaligned(hi);
        }
        Ok(())
    })
}

/// The library's version as "major.minor.patch", never NULL.
#[unsafe(no_mangle)]
pub extern "C" fn hug_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// The version of this interface: programs compiled against a header of the
/// same number can use the library.
#[unsafe(no_mangle)]
pub extern "C" fn hug_abi_version() -> u32 {
    1
}

/// The instruction set that queries run on: "avx512", "avx2", "neon" or
/// "portable", never NULL. Results do not depend on it.
#[unsafe(no_mangle)]
pub extern "C" fn hug_isa() -> *const c_char {
    crate::isa().name().as_ptr()
}

/// Whether a string is `other`, without the C library's `strlen`: freestanding programs
/// have none.
///
/// # Safety
/// `name` is a string.
unsafe fn same(name: *const c_char, other: &CStr) -> bool {
    let mut bytes = other.to_bytes_with_nul().iter().enumerate();
    // SAFETY: not beyond the first difference, so not beyond the string's end.
    bytes.all(|(i, &byte)| unsafe { name.add(i).read() } as u8 == byte)
}

/// Makes all queries of the process run on the instruction set of this name,
/// for tests and comparisons. HUG_ERROR_INVALID_VALUE, and no change, if the
/// name is unknown or the processor does not have it.
///
/// # Safety
/// name must be a string or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_force_isa(name: *const c_char) -> hug_status {
    guard(|| {
        if name.is_null() {
            return Err(Error::Null);
        }
        // SAFETY: a string by contract.
        let known = Isa::ALL.into_iter().find(|isa| unsafe { same(name, isa.name()) });
        match known {
            Some(isa) if force_isa(isa) => Ok(()),
            _ => Err(Error::InvalidValue),
        }
    })
}

/// A status in English, never NULL, also for numbers that are no status.
#[unsafe(no_mangle)]
pub extern "C" fn hug_status_string(status: hug_status) -> *const c_char {
    let error = match status {
        0 => return c"success".as_ptr(),
        1 => Error::Null,
        2 => Error::StructSize,
        3 => Error::InvalidValue,
        4 => Error::Alignment,
        5 => Error::Overlap,
        6 => Error::Overflow,
        7 => Error::IndexRange,
        8 => Error::OutOfMemory,
        9 => Error::BufferTooSmall,
        10 => Error::Limit,
        11 => Error::Truncated,
        12 => Error::Magic,
        13 => Error::Version,
        14 => Error::Endianness,
        15 => Error::Corrupt,
        16 => Error::Internal,
        17 => Error::Cancelled,
        18 => Error::Unfinished,
        _ => return c"unknown status".as_ptr(),
    };
    error.message().as_ptr()
}
