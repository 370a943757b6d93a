//! What the damage tests know of an arena's bytes, in one place: a second
//! reading of src/arena/layout.rs, which it must follow.

use super::aligned::Aligned;
use std::ops::Range;

pub const HEADER: usize = 320;

/// Places in the header.
pub const BYTE_ORDER: usize = 8;
pub const VERSION: usize = 12;
pub const BYTES: usize = 16;
pub const STRUCTURE: usize = 24;
pub const LEVELS: usize = 28;
/// Each an offset and a number of records, eight bytes each.
pub const GRIDS: usize = 32;
pub const VOXELS: usize = 48;
pub const REFS: usize = 64;
pub const TRIANGLES: usize = 80;
pub const SECTIONS: [usize; 4] = [GRIDS, VOXELS, REFS, TRIANGLES];
/// Sizes of their records.
pub const RECORDS: [usize; 4] = [64, 4, 4, 48];
/// The box of the triangles: three numbers of four bytes, then its other corner.
pub const LOWER: usize = 112;
pub const UNIT: usize = 200;
/// Of the triangles that any-hit queries look at first.
pub const OCCLUDERS: Range<usize> = 208..240;
/// A section too, behind the others.
pub const FRAMES: usize = 240;
pub const FRAME: usize = 128;
/// And another, whether its records are the small ones; eight-byte words of zeros follow.
pub const NODES: usize = 256;
pub const QUANTIZED: usize = 272;
pub const RESERVED: Range<usize> = 280..320;
pub const NODE: usize = 256;
/// Places in a node: the words of its eight parts, and eight of zeros.
pub const PARTS: Range<usize> = 192..224;
pub const UNUSED: Range<usize> = 224..256;
/// The same of a small one, and what its bounds are counted in: three numbers of four bytes, and
/// three bytes.
pub const QUANTIZED_NODE: usize = 96;
pub const QUANTIZED_PARTS: Range<usize> = 48..80;
pub const ORIGIN: usize = 80;
pub const EXPONENTS: usize = 92;
pub const QUANTIZED_UNUSED: Range<usize> = 95..96;
/// In the low bits of a part's word: it is a node, not so many triangles.
pub const IS_NODE: u32 = 15;

/// Places in a grid: three numbers of eight, four, four and two bytes.
pub const LO: usize = 0;
pub const INV_CELL: usize = 24;
pub const CELL: usize = 36;
pub const N: usize = 48;
/// One byte each.
pub const LEVEL: usize = 54;
pub const FLAGS: usize = 55;
/// One of them.
pub const TURNED: u8 = 2;
/// Four bytes each.
pub const FIRST: usize = 56;
pub const WALKS: usize = 60;

/// Marks a reference to a grid.
pub const GRID_BIT: u32 = 1 << 31;
/// Places in a triangle that are coordinates.
pub const COORDINATES: [usize; 9] = [0, 4, 8, 16, 20, 24, 32, 36, 40];

/// What a voxel's two top bits say.
pub const EMPTY: u32 = 0;
pub const LIST: u32 = 1;
pub const GRID: u32 = 2;

pub fn get16(bytes: &[u8], at: usize) -> u16 {
    u16::from_le_bytes(bytes[at..at + 2].try_into().expect("two bytes"))
}

pub fn put16(bytes: &mut [u8], at: usize, value: u16) {
    bytes[at..at + 2].copy_from_slice(&value.to_le_bytes());
}

pub fn put_f32(bytes: &mut [u8], at: usize, value: f32) {
    put32(bytes, at, value.to_bits());
}

pub fn get32(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"))
}

pub fn get64(bytes: &[u8], at: usize) -> u64 {
    u64::from_le_bytes(bytes[at..at + 8].try_into().expect("eight bytes"))
}

pub fn put32(bytes: &mut [u8], at: usize, value: u32) {
    bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
}

pub fn put64(bytes: &mut [u8], at: usize, value: u64) {
    bytes[at..at + 8].copy_from_slice(&value.to_le_bytes());
}

pub fn put_f64(bytes: &mut [u8], at: usize, value: f64) {
    put64(bytes, at, value.to_bits());
}

/// Number of records in a section.
pub fn count(bytes: &[u8], section: usize) -> usize {
    get64(bytes, section + 8) as usize
}

/// Where a record of a section is.
pub fn record(bytes: &[u8], section: usize, number: usize) -> usize {
    let size = match section {
        FRAMES => FRAME,
        NODES if get64(bytes, QUANTIZED) == 0 => NODE,
        NODES => QUANTIZED_NODE,
        _ => RECORDS[(section - GRIDS) / 16],
    };
    get64(bytes, section) as usize + number * size
}

/// A voxel's word, with its two top bits apart.
pub fn voxel(bytes: &[u8], number: usize) -> (u32, u32) {
    let word = get32(bytes, record(bytes, VOXELS, number));
    (word >> 30, word & (u32::MAX >> 2))
}

/// A voxel that has a list.
#[derive(Clone, Debug)]
pub struct List {
    /// The grid that the voxel is of.
    pub grid: usize,
    /// Where the voxel's word is, which says where its list starts.
    pub voxel: usize,
    /// Where its exit box is, and how long the list is.
    pub exit: usize,
    pub len: usize,
    /// Where each of its references is.
    pub refs: Vec<usize>,
}

/// All lists of an arena, in order.
pub fn lists(bytes: &[u8]) -> Vec<List> {
    let mut lists = Vec::new();
    for grid in 0..count(bytes, GRIDS) {
        let at = record(bytes, GRIDS, grid);
        let first = get32(bytes, at + FIRST) as usize;
        let voxels: usize = (0..3).map(|k| usize::from(get16(bytes, at + N + 2 * k))).product();
        for number in first..first + voxels {
            let (LIST, start) = voxel(bytes, number) else { continue };
            let exit = record(bytes, REFS, start as usize);
            let refs = (0..get32(bytes, exit + 4) as usize).map(|i| exit + 8 + 4 * i).collect();
            let voxel = record(bytes, VOXELS, number);
            lists.push(List { grid, voxel, exit, len: exit + 4, refs });
        }
    }
    lists
}

/// An arena of towers: `width` grids on each level below the first, one voxel
/// each, whose list has all grids of the next level; at the bottom a triangle.
/// All in one place, so that every ray through it is through all of them.
pub fn towers(levels: usize, width: usize) -> Aligned {
    let grids = 1 + (levels - 1) * width;
    let above = 1 + (levels - 2) * width;
    let refs = above * (2 + 2 * width) + width * 4;
    let counts = [grids, grids, refs, 1];
    let mut offsets = [0; 4];
    let mut end = HEADER;
    for i in 0..4 {
        offsets[i] = end;
        end = (end + counts[i] * RECORDS[i]).next_multiple_of(64);
    }
    let mut bytes = Aligned::filled(end, 0);
    bytes[..8].copy_from_slice(b"hug-rt\r\n");
    put32(&mut bytes, BYTE_ORDER, 0x0102_0304);
    put32(&mut bytes, VERSION, 7);
    put_f64(&mut bytes, UNIT, 1.0);
    put64(&mut bytes, BYTES, end as u64);
    put32(&mut bytes, STRUCTURE, 3);
    put32(&mut bytes, LEVELS, levels as u32);
    for i in 0..4 {
        put64(&mut bytes, SECTIONS[i], offsets[i] as u64);
        put64(&mut bytes, SECTIONS[i] + 8, counts[i] as u64);
    }
    put64(&mut bytes, FRAMES, end as u64);
    put64(&mut bytes, NODES, end as u64);
    let mut next = 0;
    for number in 0..grids {
        let depth = number.div_ceil(width);
        let at = record(&bytes, GRIDS, number);
        for k in 0..3 {
            put_f64(&mut bytes, at + LO + 8 * k, -1.0);
            put_f32(&mut bytes, at + CELL + 4 * k, 2.0);
            put_f32(&mut bytes, at + INV_CELL + 4 * k, 0.5);
            put16(&mut bytes, at + N + 2 * k, 1);
        }
        bytes[at + LEVEL] = (levels - 1 - depth) as u8;
        put32(&mut bytes, at + FIRST, number as u32);
        // 1 + width + width^2 + ... of the levels from here on.
        let walks =
            (depth + 1..levels).fold(1u64, |w, _| w.wrapping_mul(width as u64).wrapping_add(1));
        put32(&mut bytes, at + WALKS, walks as u32);
        let word = record(&bytes, VOXELS, number);
        put32(&mut bytes, word, LIST << 30 | next as u32);
        let below = depth * width + 1;
        let list: Vec<u32> = if depth + 1 == levels {
            vec![0]
        } else {
            (below..below + width).map(|g| GRID_BIT | g as u32).collect()
        };
        let head = record(&bytes, REFS, next);
        put32(&mut bytes, head + 4, list.len() as u32);
        for (i, r) in list.iter().enumerate() {
            put32(&mut bytes, head + 8 + 4 * i, *r);
            // Its box is the whole exit box.
            put32(&mut bytes, head + 8 + 4 * (list.len() + i), 31 << 5 | 31 << 15 | 31 << 25);
        }
        next += 2 + 2 * list.len();
    }
    let triangle = record(&bytes, TRIANGLES, 0);
    for (place, value) in
        COORDINATES.into_iter().zip([0.9_f32, 0.8, 0.9, 0.8, 0.9, 0.9, 0.9, 0.9, 0.8])
    {
        put32(&mut bytes, triangle + place, value.to_bits());
    }
    put32(&mut bytes, triangle + 44, u32::MAX);
    bytes
}
