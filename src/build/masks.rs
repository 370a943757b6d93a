//! Which voxels of a grid refer to something, a bit each, and how much room there is
//! around those that do not: the chessboard distance to the nearest that does.
//!
//! Rows along x are whole words, so that one operation tells of 64 voxels. Level `k`
//! has the voxels within distance `k` of one that refers to something, and follows
//! from the level below by a dilation, one axis after the other. Besides there are
//! unions of four rows, along y, along z and of four times four, with which exit boxes
//! are grown.

use super::draft::Span;
use super::rows::{Rows, UNION, unite};

/// Most levels besides the voxels themselves; fewer than the free bits before and
/// after a wide row's voxels, so that none reaches another row.
const LEVELS: usize = 24;
/// Voxels of the longest row that is one word, without free bits.
const NARROW: usize = 64;
/// Free bits before a wide row's voxels.
const LEAD: usize = 32;
/// How far a window on a wide row certainly reaches on either side of its voxel.
const WIDE_REACH: usize = 28;
/// Sets of bits before the first level: the voxels themselves and three of unions.
const BELOW: usize = 4;

/// The bits of a grid.
pub struct Masks<'a> {
    words: &'a [u64],
    n: [usize; 3],
    /// Words of a row, and of a level.
    row: usize,
    size: usize,
    levels: usize,
}

/// 64 bits of a row around one of its voxels.
#[derive(Clone, Copy)]
pub struct Window {
    /// First byte in its row.
    byte: usize,
    /// The voxel's bit.
    pub bit: usize,
}

/// Words of a row of `nx` voxels.
fn row_len(nx: usize) -> usize {
    if nx <= NARROW { 1 } else { (nx + LEAD + 35).div_ceil(64) }
}

impl<'a> Masks<'a> {
    /// Words of memory that a grid of `n` voxels needs; more of them tell more of
    /// the room there is.
    pub fn least(n: [usize; 3]) -> usize {
        (BELOW + 1) * row_len(n[0]) * n[1] * n[2]
    }

    /// Words of memory that tell all.
    pub fn size(n: [usize; 3]) -> usize {
        let levels = n[0].max(n[1]).max(n[2]).min(LEVELS);
        (BELOW + levels) * row_len(n[0]) * n[1] * n[2]
    }

    /// Looks at a grid's voxels. `words`: at least [`Masks::least`] of them.
    pub fn new(n: [usize; 3], spans: &[Span], words: &'a mut [u64]) -> Self {
        let row = row_len(n[0]);
        let size = row * n[1] * n[2];
        let lead = if row == 1 { 0 } else { LEAD };
        let (single, rest) = words.split_at_mut(size);
        for (bits, spans) in single.chunks_exact_mut(row).zip(spans.chunks_exact(n[0])) {
            bits.fill(0);
            let mut spans = spans.iter();
            let mut at = lead;
            for word in bits {
                let (mut bit, mut set) = (at, 0);
                for span in spans.by_ref().take(64 - at) {
                    set |= u64::from(span.count != 0) << bit;
                    bit += 1;
                }
                *word = set;
                at = 0;
            }
        }
        let (along_y, rest) = rest.split_at_mut(size);
        if n[1] >= UNION {
            unite(single, along_y, row);
        }
        let (along_z, rest) = rest.split_at_mut(size);
        if n[2] >= UNION {
            unite(single, along_z, row * n[1]);
        }
        let (squares, rest) = rest.split_at_mut(size);
        if n[1].min(n[2]) >= UNION {
            unite(along_y, squares, row * n[1]);
        }
        let mut below = &*single;
        let mut levels = 0;
        let most = n[0].max(n[1]).max(n[2]).min(LEVELS);
        for level in rest.chunks_exact_mut(size).take(most) {
            levels += 1;
            if !dilate(below, level, n, row) {
                break;
            }
            below = level;
        }
        // Of each word the bytes are in the order of its bits.
        if cfg!(target_endian = "big") {
            words.iter_mut().for_each(|word| *word = word.to_le());
        }
        Self { words, n, row, size, levels }
    }

    fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(self.words)
    }

    /// The room around eight voxels of a row from number `x`, a multiple of 8, on, a
    /// byte each: 0 if the voxel refers to something, else one more than the reach of
    /// the largest cube around it that is known to be empty where it lies in the grid.
    #[inline(always)]
    pub fn rooms(&self, [x, y, z]: [usize; 3]) -> u64 {
        let lead = if self.row == 1 { 0 } else { LEAD };
        let mut at = (z * self.n[1] + y) * self.row * 8 + (lead + x) / 8;
        let mut rooms = 0;
        let bytes = self.bytes();
        for level in 0..=self.levels {
            let free = !bytes[at];
            if free == 0 {
                break;
            }
            rooms += spread(free);
            at += if level == 0 { BELOW * self.size * 8 } else { self.size * 8 };
        }
        rooms
    }

    /// The window around voxel `x` of any row.
    #[inline(always)]
    pub fn window(&self, x: usize) -> Window {
        if self.row == 1 {
            return Window { byte: 0, bit: x };
        }
        let byte = (x + LEAD - WIDE_REACH) / 8;
        Window { byte, bit: x + LEAD - 8 * byte }
    }

    /// The place of row y, z as [`Rows`] knows it, seen through a window.
    #[inline(always)]
    pub fn place(&self, window: Window, y: usize, z: usize) -> usize {
        (z * self.n[1] + y) * self.row * 8 + window.byte
    }

    pub fn rows(&self) -> Rows<'_> {
        let bytes = self.bytes();
        let level = |i: usize| &bytes[i * self.size * 8..][..self.size * 8];
        let step = self.row * 8;
        Rows {
            single: level(0),
            unions: [level(1), level(2)],
            squares: level(3),
            steps: [step, step * self.n[1]],
        }
    }
}

/// A byte for each bit.
#[inline(always)]
fn spread(bits: u8) -> u64 {
    const ONES: u64 = 0x0101_0101_0101_0101;
    let apart = (u64::from(bits) * ONES) & 0x8040_2010_0804_0201;
    (apart + 0x7f * ONES) >> 7 & ONES
}

/// The voxels that are in `from` or next to such a one; false if these are all.
fn dilate(from: &[u64], to: &mut [u64], n: [usize; 3], row: usize) -> bool {
    let plane = row * n[1];
    let planes = |z: usize| &from[z * plane..][..plane];
    for (z, to) in to.chunks_exact_mut(plane).enumerate() {
        let around = planes(z.saturating_sub(1)).iter().zip(planes((z + 1).min(n[2] - 1)));
        for (to, (from, (a, b))) in to.iter_mut().zip(planes(z).iter().zip(around)) {
            *to = from | a | b;
        }
    }
    let mut free = 0;
    for to in to.chunks_exact_mut(plane) {
        for word in 0..row {
            let (mut before, mut at) = (0, word);
            while at < plane {
                let here = to[at];
                let after = to.get(at + row).copied().unwrap_or(0);
                to[at] = before | here | after;
                (before, at) = (here, at + row);
            }
        }
    }
    if row == 1 {
        let voxels = u64::MAX >> (64 - n[0]);
        for to in to.iter_mut() {
            *to |= *to << 1 | *to >> 1;
            free |= !*to & voxels;
        }
        return free != 0;
    }
    for to in to.chunks_exact_mut(row) {
        let mut before = 0;
        for word in 0..row {
            let here = to[word];
            let after = to.get(word + 1).copied().unwrap_or(0);
            let all = here | here << 1 | here >> 1 | before >> 63 | after << 63;
            to[word] = all;
            before = here;
            let (lo, hi) = (word * 64, word * 64 + 64);
            let first = LEAD.saturating_sub(lo).min(63);
            let past = hi.saturating_sub(LEAD + n[0]).min(64);
            if past < 64 {
                free |= !all & u64::MAX << first & u64::MAX >> past;
            }
        }
    }
    free != 0
}
