//! The bytes of an arena, format version 7.
//!
//! One block, position-independent, little-endian, 64-byte aligned: the header,
//! then the grids, the voxels, the references, the triangles, the frames and the nodes, each
//! section at a multiple of 64, in this order, without gaps other than the padding
//! (zeros). Where there are nodes, this goes on at the end until seven triangles would have room
//! behind the last. The same bytes serve in memory, in a file and in a mapping.

use bytemuck::{Pod, Zeroable};

use super::node::{LEAF, Node, QuantizedNode};
use crate::Error;
use crate::options::MAX_LEVELS;
use crate::ray::NONE;

/// Alignment of an arena and of each of its sections, in bytes.
pub const ALIGN: usize = 64;
/// The first eight bytes of an arena.
pub const MAGIC: [u8; 8] = *b"hug-rt\r\n";
/// The format's version; any other is refused.
pub const VERSION: u32 = 7;
/// Reads differently where the byte order is not the writer's.
pub const BYTE_ORDER: u32 = 0x0102_0304;
/// Marks a reference to a grid; the other bits are the grid's or triangle's number.
pub const GRID_BIT: u32 = 1 << 31;

/// The two top bits of a voxel say what its 30 others are.
pub const TAG_SHIFT: u32 = 30;
/// The other bits.
pub const PAYLOAD: u32 = (1 << TAG_SHIFT) - 1;
/// Nothing here: the payload is the voxel's exit box.
pub const EMPTY: u32 = 0;
/// The payload is where the voxel's list starts in the references' section: a
/// word with the exit box, one with the number of references, then these,
/// ascending: triangles first, then grids, then a [box](BOX_CELLS) for each.
pub const LIST: u32 = 1;
/// One grid and nothing else: the payload is its number.
pub const GRID: u32 = 2;
/// Largest `walks` of the outermost grid, per grid of the arena: in a tree it is
/// at most 1, in the paper's hierarchy a little more; without a bound, a few
/// kilobytes of grids that all name each other would keep a ray for hours.
pub const MAX_WALKS: u64 = 16;

/// Most triangles that queries for any hit look at first.
pub const OCCLUDERS: usize = 8;

/// Words of a list before its references.
pub const LIST_HEAD: usize = 2;
/// Words of a reference: itself and its box.
pub const REF_WORDS: usize = 2;

/// An exit box: how many voxels it reaches beyond its own in -x, +x, -y, +y,
/// -z, +z, five bits each. No voxel in it refers to anything that its own
/// voxel does not refer to.
pub const EXIT_BITS: u32 = 5;
/// Largest reach of an exit box.
pub const EXIT_MAX: u32 = (1 << EXIT_BITS) - 1;

/// A reference's box bounds what it refers to, inside the exit box: the lower and the
/// upper bound along x, then y, then z, in the bits of an exit box's word. The exit
/// box, larger by [`BOX_MARGIN`] on each side, is cut into 32 cells along each axis;
/// bounds are the first and the last cell.
pub const BOX_CELLS: u32 = 1 << EXIT_BITS;
/// In voxels.
pub const BOX_MARGIN: f32 = 1.0 / 16.0;

/// Where a section lies and how many records it has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Section {
    /// Bytes from the header's first byte.
    pub offset: u64,
    /// Number of records.
    pub count: u64,
}

/// The first 320 bytes.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct Header {
    pub magic: [u8; 8],
    pub byte_order: u32,
    pub version: u32,
    /// Size of the arena, a multiple of [`ALIGN`].
    pub bytes: u64,
    /// 1 uniform grid, 2 recursive grid, 3 HUG.
    pub structure: u32,
    /// Number of levels, 1 to 16; 0 for an empty scene.
    pub levels: u32,
    pub grids: Section,
    /// One word a voxel, see [`EMPTY`], [`LIST`] and [`GRID`].
    pub voxels: Section,
    /// The voxels' lists, in the order of the voxels.
    pub refs: Section,
    pub triangles: Section,
    /// Triangles of the soup left out for a coordinate that is not finite.
    pub dropped_non_finite: u64,
    /// Triangles of the soup left out for having no area.
    pub dropped_degenerate: u64,
    /// Box of the triangles; inverted infinities for an empty scene.
    pub lower: [f32; 3],
    pub upper: [f32; 3],
    /// Distinct triangles that each level refers to.
    pub objects: [u32; MAX_LEVELS],
    /// A power of two: grids are in coordinates times this, in which the longest
    /// side of the box is about 1, so that walks can use `f32`.
    pub unit: f64,
    /// Triangles that queries for any hit look at first, then `u32::MAX`.
    pub occluders: [u32; OCCLUDERS],
    /// Of all grids or, if none is turned, of none.
    pub frames: Section,
    /// The tree of boxes over all triangles, or nothing.
    pub nodes: Section,
    /// 0, or 1 if its nodes are [`QuantizedNode`]s.
    pub quantized: u64,
    pub reserved: [u64; 5],
}

/// A flag of a grid that covers every voxel that refers to it, so that a ray in such a
/// voxel is in the grid.
pub const COVERS: u8 = 1;
/// A flag of a grid that lies in coordinates of its own, those of its [`Frame`]. The
/// outermost grid does not.
pub const TURNED: u8 = 2;

/// Coordinates of a grid's own: a place p, times `unit`, is at `axes (p - origin)`.
/// Two cache lines; fourth lanes are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C, align(64))]
pub struct Frame {
    /// A rotation, by columns: where the x, y and z axes point in these coordinates.
    pub axes: [[f64; 4]; 3],
    pub origin: [f64; 4],
}

impl Frame {
    /// A direction in these coordinates.
    #[inline(always)]
    pub fn turn(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = &self.axes;
        let along = |k: usize| a[k] * x + b[k] * y + c[k] * z;
        [along(0), along(1), along(2)]
    }

    /// A place relative to the origin of these coordinates.
    #[inline(always)]
    pub fn relative(&self, p: [f64; 3]) -> [f64; 3] {
        [p[0] - self.origin[0], p[1] - self.origin[1], p[2] - self.origin[2]]
    }
}

/// A uniform grid over a box: voxel (x, y, z) is number
/// `first + (z * n.y + y) * n.x + x` of the voxels' section. One cache line, in
/// the order in which vector loads want it: a fourth lane of each of the first
/// three is a positive finite number that means nothing.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(64))]
pub struct Grid {
    /// Lowest corner of the box times the header's `unit`.
    pub lo: [f64; 3],
    /// Voxels per `1 / unit`. With `lo` it defines where voxels are.
    pub inv_cell: [f32; 3],
    /// `1 / inv_cell`.
    pub cell: [f32; 3],
    /// Voxels along each axis, 1 to 2048.
    pub n: [u16; 3],
    /// Level of the hierarchy; 0 is the deepest.
    pub level: u8,
    /// [`COVERS`] and [`TURNED`].
    pub flags: u8,
    /// Number of the first voxel.
    pub first: u32,
    /// 1 plus the largest sum of `walks` over the grids of one voxel: how often
    /// a ray can enter grids while it is in one voxel of this one, plus 1.
    pub walks: u32,
}

/// Four numbers from `lo`, `inv_cell`, `cell` and `n` of a grid.
pub struct GridLanes<'a> {
    pub lo: &'a [f64; 4],
    pub inv_cell: &'a [f32; 4],
    pub n: &'a [u16; 4],
}

/// A triangle, coordinate by coordinate so that one load brings the three
/// corners' x; ids and mask fill the fourth lanes.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Triangle {
    pub x: [f32; 3],
    pub geom: u32,
    pub y: [f32; 3],
    pub prim: u32,
    pub z: [f32; 3],
    pub mask: u32,
}

impl Triangle {
    pub fn new(corners: &[[f32; 3]; 3], geom: u32, prim: u32, mask: u32) -> Self {
        let [x, y, z] = [0, 1, 2].map(|k| corners.map(|c| c[k]));
        Self { x, geom, y, prim, z, mask }
    }

    pub fn corners(&self) -> [[f32; 3]; 3] {
        [0, 1, 2].map(|i| [self.x[i], self.y[i], self.z[i]])
    }

    /// x, y and z of the corners; fourth lanes mean nothing.
    #[inline(always)]
    pub fn rows(&self) -> [&[f32; 4]; 3] {
        let rows: &[[f32; 4]; 3] = bytemuck::cast_ref(self);
        [&rows[0], &rows[1], &rows[2]]
    }
}

impl Header {
    /// How many records there are.
    pub fn counts(&self) -> Counts {
        let [grids, voxels, refs, triangles, frames, nodes] = self.sections().map(|s| s.count);
        let quantized = self.quantized != 0;
        Counts { grids, voxels, refs, triangles, frames, nodes, quantized }
    }

    /// The sections, in their order.
    pub fn sections(&self) -> [Section; SECTIONS] {
        [self.grids, self.voxels, self.refs, self.triangles, self.frames, self.nodes]
    }

    /// Numbers of the triangles to look at first.
    #[inline(always)]
    pub fn occluders(&self) -> &[u32] {
        let end = self.occluders.iter().position(|&number| number == NONE);
        &self.occluders[..end.unwrap_or(OCCLUDERS)]
    }

    /// `lower` and `upper`, each with a fourth lane that means nothing.
    #[inline(always)]
    pub fn corners(&self) -> [&[f32; 4]; 2] {
        let words: &[f32] = bytemuck::cast_slice(core::slice::from_ref(self));
        let first = core::mem::offset_of!(Self, lower) / 4;
        [first, first + 3].map(|i| words[i..i + 4].first_chunk().unwrap_or(&[0.0; 4]))
    }
}

const _: () = assert!(size_of::<Header>() == 320);
const _: () = assert!(size_of::<Grid>() == 64);
const _: () = assert!(size_of::<Frame>() == 128);
const _: () = assert!(size_of::<Triangle>() == 48);

impl Grid {
    /// Number of voxels; no overflow for counts in range.
    pub fn voxels(&self) -> u64 {
        self.n.iter().map(|&n| u64::from(n)).product()
    }

    /// The record as vector loads want it; fourth lanes mean nothing.
    #[inline(always)]
    pub fn lanes(&self) -> GridLanes<'_> {
        let (doubles, singles): (&[f64; 8], &[f32; 16]) =
            (bytemuck::cast_ref(self), bytemuck::cast_ref(self));
        let shorts: &[u16; 32] = bytemuck::cast_ref(self);
        let four = |i: usize| singles[i..i + 4].first_chunk().unwrap_or(&[0.0; 4]);
        GridLanes {
            lo: doubles.first_chunk().unwrap_or(&[0.0; 4]),
            inv_cell: four(6),
            n: shorts[24..].first_chunk().unwrap_or(&[0; 4]),
        }
    }

    /// Volume of the box, in the cube of `1 / unit`.
    pub fn volume(&self) -> f64 {
        (0..3).map(|k| f64::from(self.n[k]) * f64::from(self.cell[k])).product()
    }
}

/// How many records an arena has.
#[derive(Clone, Copy)]
pub struct Counts {
    pub grids: u64,
    pub voxels: u64,
    /// Words of the references' section.
    pub refs: u64,
    pub triangles: u64,
    pub frames: u64,
    pub nodes: u64,
    /// Whether nodes are [`QuantizedNode`]s.
    pub quantized: bool,
}

impl Counts {
    /// Bytes of a node.
    pub fn node(&self) -> usize {
        if self.quantized { size_of::<QuantizedNode>() } else { size_of::<Node>() }
    }
}

/// Sections of an arena.
pub const SECTIONS: usize = 6;

/// The sections of an arena with these many records, and its size.
///
/// # Errors
/// [`Error::Overflow`] if the size does not fit the address space.
pub fn sections(counts: &Counts) -> Result<([Section; SECTIONS], u64), Error> {
    let mut at = size_of::<Header>() as u64;
    let mut place = |count: u64, size: usize| -> Result<Section, Error> {
        let section = Section { offset: at, count };
        let bytes = count.checked_mul(size as u64).ok_or(Error::Overflow)?;
        at = at
            .checked_add(bytes)
            .and_then(|end| end.checked_next_multiple_of(ALIGN as u64))
            .ok_or(Error::Overflow)?;
        Ok(section)
    };
    let sections = [
        place(counts.grids, size_of::<Grid>())?,
        place(counts.voxels, size_of::<u32>())?,
        place(counts.refs, size_of::<u32>())?,
        place(counts.triangles, size_of::<Triangle>())?,
        place(counts.frames, size_of::<Frame>())?,
        place(counts.nodes, counts.node())?,
    ];
    if counts.nodes > 0 {
        // Leaves are read eight triangles at a time.
        let [_, _, _, triangles, ..] = sections;
        let end = u64::from(LEAF - 1)
            .checked_add(triangles.count)
            .and_then(|count| count.checked_mul(size_of::<Triangle>() as u64))
            .and_then(|bytes| bytes.checked_add(triangles.offset))
            .and_then(|end| end.checked_next_multiple_of(ALIGN as u64));
        at = at.max(end.ok_or(Error::Overflow)?);
    }
    isize::try_from(at).map_err(|_| Error::Overflow)?;
    Ok((sections, at))
}
