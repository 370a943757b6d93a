//! Reading a build descriptor: from raw pointers to geometries and options.

use core::mem::MaybeUninit;

use super::guard::overlap;
use super::options::options;
use super::sized;
use super::types::{HUG_INDEX_NONE, HUG_INDEX_U16, HUG_INDEX_U32, hug_build_desc, hug_geometry};
use crate::build::{self, Sizes};
use crate::geometry::{Geometry, Indices};
use crate::options::Options;
use crate::simd::fpenv;
use crate::{Error, MAX_TRIANGLES};

/// A descriptor whose options are in range and whose pointers are not NULL and
/// are aligned.
pub struct Parsed<'a> {
    pub desc: hug_build_desc,
    pub options: Options,
    geometries: &'a [hug_geometry],
}

impl<'a> Parsed<'a> {
    /// Reads and checks a descriptor.
    ///
    /// # Safety
    /// `desc`, its thresholds and its geometries are readable (or NULL), for `'a`.
    pub unsafe fn read(desc: *const hug_build_desc) -> Result<Self, Error> {
        // SAFETY: by the caller.
        let (head, geometries) = unsafe { Self::listed(desc) }?;
        // A denormal is not 0, which would be a default, whatever the caller's modes say.
        // SAFETY: thresholds are readable by contract.
        let options = fpenv::with_default(|| unsafe { options(&head) })?;
        options.check()?;
        for geometry in geometries {
            check(geometry)?;
        }
        Ok(Self { desc: head, options, geometries })
    }

    /// A descriptor and its geometries, of which nothing is checked.
    ///
    /// # Safety
    /// As [`Parsed::read`].
    unsafe fn listed(
        desc: *const hug_build_desc,
    ) -> Result<(hug_build_desc, &'a [hug_geometry]), Error> {
        // SAFETY: by the caller; zeros are a value of every field.
        let head = unsafe { sized::read(desc, FIRST_DESC) }?;
        if head.geometry_count > 0 && head.geometries.is_null() {
            return Err(Error::Null);
        }
        // SAFETY: not NULL unless empty; readable by contract.
        Ok((head, unsafe { slice(head.geometries, head.geometry_count) }?))
    }

    /// The first geometry that a build refuses, with its triangle if it is one, and why.
    ///
    /// # Safety
    /// As [`Parsed::read`].
    pub unsafe fn fault(
        desc: *const hug_build_desc,
    ) -> Result<Option<(usize, Option<usize>, Error)>, Error> {
        // SAFETY: by the caller.
        let (_, geometries) = unsafe { Self::listed(desc) }?;
        for (number, of) in geometries.iter().enumerate() {
            // SAFETY: it passed the check; readable by contract.
            match check(of).and_then(|()| unsafe { geometry(of) }) {
                Err(error) => return Ok(Some((number, None, error))),
                Ok(geometry) => {
                    if let Some(prim) = geometry.first_bad_index() {
                        return Ok(Some((number, Some(prim), Error::IndexRange)));
                    }
                }
            }
        }
        // SAFETY: by the caller.
        unsafe { Self::read(desc) }.map(|_| None)
    }

    /// Number of triangles in all geometries.
    fn triangle_count(&self) -> Result<usize, Error> {
        let mut counts = self.geometries.iter().map(|g| g.triangle_count);
        let sum = counts.try_fold(0usize, usize::checked_add);
        sum.filter(|&n| n <= MAX_TRIANGLES).ok_or(Error::Limit)
    }

    /// The geometries, one by one.
    pub fn each(&self) -> impl Iterator<Item = Result<Geometry<'a>, Error>> + Clone + use<'a> {
        // SAFETY: each passed the check; readable by the contract of `read`.
        self.geometries.iter().map(|of| unsafe { geometry(of) })
    }

    /// What the build proper needs.
    pub fn sizes(&self) -> Result<Sizes, Error> {
        build::measure_count(self.triangle_count()?, &self.options)
    }

    /// Scratch memory for the build and [`Parsed::soup`].
    pub fn scratch_bytes(&self) -> Result<usize, Error> {
        self.sizes()?.scratch.checked_add(self.soup_bytes()?).ok_or(Error::Overflow)
    }

    /// Bytes that [`Parsed::soup`] needs.
    fn soup_bytes(&self) -> Result<usize, Error> {
        let bytes = self.geometries.len().checked_mul(size_of::<Geometry<'_>>());
        bytes
            .and_then(|b| b.checked_add(2 * 64)?.checked_next_multiple_of(64))
            .ok_or(Error::Overflow)
    }

    /// Writes the geometries to the start of `memory` and returns them with the
    /// rest of it.
    pub fn soup<'m>(
        &self,
        memory: &'m mut [u8],
    ) -> Result<(&'m [Geometry<'a>], &'m mut [u8]), Error> {
        let skip = memory.as_ptr().align_offset(align_of::<Geometry<'_>>());
        let end = self.soup_bytes()? - 64;
        if memory.len() < end || skip > 64 {
            return Err(Error::BufferTooSmall);
        }
        let (head, rest) = memory.split_at_mut(end);
        let count = self.geometries.len();
        // SAFETY: aligned, large enough, and borrowed for 'm; uninitialised is fine.
        let list = unsafe {
            let start = head.as_mut_ptr().add(skip).cast::<MaybeUninit<Geometry<'a>>>();
            core::slice::from_raw_parts_mut(start, count)
        };
        for (to, from) in list.iter_mut().zip(self.geometries) {
            // SAFETY: the geometry's memory is readable by contract.
            to.write(unsafe { geometry(from) }?);
        }
        // SAFETY: every element was written.
        Ok((unsafe { &*(&raw const *list as *const [Geometry<'a>]) }, rest))
    }

    /// Whether the build's input keeps clear of memory it will write.
    pub fn apart_from(&self, start: usize, len: usize) -> Result<(), Error> {
        let list = size_of_val(self.geometries);
        let mut shared = overlap(self.geometries.as_ptr() as usize, list, start, len)?;
        for g in self.geometries {
            let vertices = vertex_bytes(g)?;
            shared |= overlap(g.vertices as usize, vertices, start, len)?;
            shared |= overlap(g.indices as usize, index_bytes(g)?, start, len)?;
        }
        if shared { Err(Error::Overlap) } else { Ok(()) }
    }
}

/// The first version of the descriptor ended before this field.
const FIRST_DESC: usize = core::mem::offset_of!(hug_build_desc, quality);

/// # Safety
/// `count` records are readable, unless `count` is 0.
pub unsafe fn slice<'a, T>(start: *const T, count: usize) -> Result<&'a [T], Error> {
    if count == 0 {
        return Ok(&[]);
    }
    if !start.is_aligned() {
        return Err(Error::Alignment);
    }
    let bytes = count.checked_mul(size_of::<T>()).ok_or(Error::Overflow)?;
    if isize::try_from(bytes).is_err() || (start as usize).checked_add(bytes).is_none() {
        return Err(Error::Overflow);
    }
    // SAFETY: aligned, no overflow, readable by the caller.
    Ok(unsafe { core::slice::from_raw_parts(start, count) })
}

fn stride(g: &hug_geometry) -> usize {
    if g.vertex_stride == 0 { 12 } else { g.vertex_stride }
}

/// Bytes from the first vertex to the end of the last one's z.
fn vertex_bytes(g: &hug_geometry) -> Result<usize, Error> {
    match g.vertex_count {
        0 => Ok(0),
        n => (n - 1).checked_mul(stride(g)).and_then(|b| b.checked_add(12)).ok_or(Error::Overflow),
    }
}

fn index_bytes(g: &hug_geometry) -> Result<usize, Error> {
    let size = match g.index_type {
        HUG_INDEX_NONE => 0,
        HUG_INDEX_U16 => 2,
        _ => 4,
    };
    g.triangle_count.checked_mul(3 * size).ok_or(Error::Overflow)
}

/// Checks a geometry without reading its arrays.
fn check(g: &hug_geometry) -> Result<(), Error> {
    if g.index_type > HUG_INDEX_U32 {
        return Err(Error::InvalidValue);
    }
    let indexed = g.index_type != HUG_INDEX_NONE;
    if g.vertex_count > 0 && g.vertices.is_null()
        || indexed && g.triangle_count > 0 && g.indices.is_null()
    {
        return Err(Error::Null);
    }
    if !g.vertices.is_aligned() || !stride(g).is_multiple_of(4) || stride(g) < 12 {
        return Err(Error::Alignment);
    }
    let align = if g.index_type == HUG_INDEX_U16 { 2 } else { 4 };
    if indexed && !(g.indices as usize).is_multiple_of(align) {
        return Err(Error::Alignment);
    }
    for (start, bytes) in
        [(g.vertices as usize, vertex_bytes(g)?), (g.indices as usize, index_bytes(g)?)]
    {
        if isize::try_from(bytes).is_err() || start.checked_add(bytes).is_none() {
            return Err(Error::Overflow);
        }
    }
    if !indexed && g.triangle_count > g.vertex_count / 3 {
        return Err(Error::IndexRange);
    }
    Ok(())
}

/// # Safety
/// The arrays of a geometry that passed [`check`] are readable.
unsafe fn geometry<'a>(g: &hug_geometry) -> Result<Geometry<'a>, Error> {
    let indexed = g.index_type != HUG_INDEX_NONE;
    let vertices = if indexed { g.vertex_count } else { 3 * g.triangle_count };
    let floats = match vertices {
        0 => 0,
        n => (n - 1) * (stride(g) / 4) + 3,
    };
    // SAFETY: readable by the caller; sizes were checked.
    let geometry = unsafe {
        let coords = slice(g.vertices, floats)?;
        let indices = match g.index_type {
            HUG_INDEX_NONE => Indices::None,
            HUG_INDEX_U16 => Indices::U16(slice(g.indices.cast(), 3 * g.triangle_count)?),
            _ => Indices::U32(slice(g.indices.cast(), 3 * g.triangle_count)?),
        };
        Geometry::new(coords, stride(g) / 4, indices)?
    };
    Ok(geometry.with_mask(if g.mask == 0 { u32::MAX } else { g.mask }))
}
