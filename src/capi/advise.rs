//! What to know of a scene before it is built.
#![allow(non_camel_case_types)]

use core::ffi::{c_char, c_void};

use super::desc::Parsed;
use super::guard::{guard, overlap};
use super::types::{hug_build_desc, hug_clustering, hug_status, hug_structure};
use crate::Error;
use crate::advice::{Advice, Reason};
use crate::build::{Clusters, Survey};
use crate::options::Filter;

/// Why a structure was chosen: HUG_REASON_*.
pub type hug_reason = u32;
/// There are too few triangles for the choice to matter.
pub const HUG_REASON_FEW: hug_reason = 0;
/// Lengths are alike and the triangles lie evenly: one grid divides them.
pub const HUG_REASON_EVEN: hug_reason = 1;
/// Lengths are alike, so that a filter parts nothing, but the triangles lie unevenly.
pub const HUG_REASON_ALIKE: hug_reason = 2;
/// Most triangles are small, but they lie all over the scene.
pub const HUG_REASON_SCATTERED: hug_reason = 3;
/// Most triangles are small, and stand together in a part of the scene.
pub const HUG_REASON_CLUSTERED: hug_reason = 4;

/// What was measured of triangles, and what to build of them. Zero it and set
/// struct_size; the rest is written.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_advice {
    /// sizeof(hug_advice).
    pub struct_size: usize,
    /// Triangles with finite corners and a length, the diagonal of their box.
    pub triangles: u64,
    /// The share of them shorter than 5 % of the longest: the small ones.
    pub small: f64,
    /// Deviation over mean of the lengths.
    pub variation: f64,
    /// The share of the cells of a 10 x 10 x 10 grid over the scene that centres of small
    /// triangles lie in; of all triangles, if fewer than half of them are small.
    pub occupied: f64,
    /// What that share would be if as many points were scattered at random.
    pub expected: f64,
    /// How many times more likely two of the centres share a cell than two such points.
    pub crowding: f64,
    /// 1 if clusters are to be expected, else 0.
    pub prone: u32,
    /// What to build: HUG_STRUCTURE_*.
    pub structure: hug_structure,
    /// For hug_build_desc, should it be a HUG.
    pub filter_levels: u32,
    /// The same.
    pub filter_share: f32,
    /// The same.
    pub clustering: hug_clustering,
    /// Why: HUG_REASON_*.
    pub reason: hug_reason,
}

/// The clusters that one way of clustering makes of all levels below the world's.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_clusters {
    /// All of them.
    pub clusters: u64,
    /// Those of at least min_cluster triangles, which become grids.
    pub grids: u64,
    /// Triangles in these; all others are in the world.
    pub objects: u64,
    /// The sum of %vol over all levels, over 100.
    pub volume: f64,
}

/// What filter and clusterings make of triangles. Zero it and set struct_size; the rest
/// is written.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_clusterings {
    /// sizeof(hug_clusterings).
    pub struct_size: usize,
    /// Triangles that a build keeps.
    pub triangles: u64,
    /// Those in levels below the world's.
    pub filtered: u64,
    /// Pairs of these, of the same level, whose boxes intersect in projection along z.
    pub plane_pairs: u64,
    /// Pairs whose boxes intersect.
    pub pairs: u64,
    /// HUG_CLUSTERING_PROJECTIONS.
    pub projections: hug_clusters,
    /// HUG_CLUSTERING_COMPONENTS.
    pub components: hug_clusters,
}

/// Whether *out can be written, and is of a size that this library knows.
///
/// # Safety
/// out is NULL or begins with a readable size.
unsafe fn writable<T>(out: *const T) -> Result<(), Error> {
    if out.is_null() {
        return Err(Error::Null);
    }
    if !out.is_aligned() {
        return Err(Error::Alignment);
    }
    // SAFETY: readable by the caller.
    let size = unsafe { out.cast::<usize>().read() };
    if size < size_of::<T>() { Err(Error::StructSize) } else { Ok(()) }
}

/// Says before a build whether the triangles of a descriptor are prone to clustering
/// (section 7.1), and what to build of them. The descriptor's options change nothing, but
/// must be in range. Two passes over the triangles, no allocation, some 8 kB of stack; any
/// number of threads may call it. After an error nothing was written.
///
/// # Safety
/// desc and what it points to must be readable or NULL, advice writable or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_advise(
    desc: *const hug_build_desc,
    advice: *mut hug_advice,
) -> hug_status {
    guard(|| {
        // SAFETY: by contract.
        let parsed = unsafe {
            writable(advice)?;
            Parsed::read(desc)
        }?;
        parsed.sizes()?;
        let found = Advice::of_each(parsed.each())?;
        let share = match found.filter {
            Filter::TwoLevels(share) => share,
            _ => 0.0,
        };
        // SAFETY: writable by contract.
        unsafe {
            advice.write(hug_advice {
                struct_size: (*advice).struct_size,
                triangles: found.triangles,
                small: found.small,
                variation: found.variation,
                occupied: found.occupied,
                expected: found.expected,
                crowding: found.crowding,
                prone: u32::from(found.prone),
                structure: found.structure as u32,
                filter_levels: 2,
                filter_share: share,
                clustering: found.clustering as u32,
                reason: found.reason as u32,
            });
        }
        Ok(())
    })
}

/// A short English sentence for a reason, without a full stop; never NULL.
#[unsafe(no_mangle)]
pub extern "C" fn hug_reason_string(reason: hug_reason) -> *const c_char {
    let known = [Reason::Few, Reason::Even, Reason::Alike, Reason::Scattered, Reason::Clustered];
    let found = known.into_iter().find(|&known| known as u32 == reason);
    found.map_or(c"unknown reason", Reason::message).as_ptr()
}

/// Counts what the filter of a descriptor and each clustering make of its triangles: how
/// many boxes intersect in the plane and in space (section 7.4), and the sum of %vol that
/// a HUG would have. scratch is as for hug_build_into with HUG_STRUCTURE_HUG (hug_measure),
/// aligned to 16. Cost: O(n log^3 n) at most, with no allocation. After an error nothing
/// was written to *out.
///
/// # Safety
/// desc and what it points to must be readable or NULL, scratch and out writable or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_survey(
    desc: *const hug_build_desc,
    scratch: *mut c_void,
    scratch_bytes: usize,
    out: *mut hug_clusterings,
) -> hug_status {
    guard(|| {
        if scratch.is_null() {
            return Err(Error::Null);
        }
        if !(scratch as usize).is_multiple_of(16) {
            return Err(Error::Alignment);
        }
        if isize::try_from(scratch_bytes).is_err() {
            return Err(Error::Overflow);
        }
        // SAFETY: by contract.
        let parsed = unsafe {
            writable(out)?;
            Parsed::read(desc)
        }?;
        if overlap(scratch as usize, scratch_bytes, out as usize, size_of::<hug_clusterings>())? {
            return Err(Error::Overlap);
        }
        parsed.apart_from(scratch as usize, scratch_bytes)?;
        // SAFETY: writable by contract, and apart from the input.
        let scratch =
            unsafe { core::slice::from_raw_parts_mut(scratch.cast::<u8>(), scratch_bytes) };
        let (soup, scratch) = parsed.soup(scratch)?;
        let found = Survey::of(soup, &parsed.options, scratch)?;
        // SAFETY: writable by contract.
        unsafe {
            out.write(hug_clusterings {
                struct_size: (*out).struct_size,
                triangles: found.triangles,
                filtered: found.filtered,
                plane_pairs: found.plane_pairs,
                pairs: found.pairs,
                projections: mirror(&found.projections),
                components: mirror(&found.components),
            });
        }
        Ok(())
    })
}

fn mirror(of: &Clusters) -> hug_clusters {
    let Clusters { clusters, grids, objects, volume } = *of;
    hug_clusters { clusters, grids, objects, volume }
}
