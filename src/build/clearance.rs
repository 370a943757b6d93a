//! How much room there is around each voxel of a grid: the chessboard distance
//! to the nearest voxel that refers to something.
//!
//! Two raster passes (Rosenfeld & Pfaltz 1968), exact for this metric. Rows are
//! padded with one byte and planes with one row that stand for the outside,
//! where nothing is, so that the passes need no case for the border.

use super::draft::Span;

/// The largest clearance that is told apart: an empty cube of reach 31.
pub const MOST: u8 = 32;
/// What lies outside the grid.
const OUTSIDE: u8 = u8::MAX;
/// Bytes handled at once, and read beyond the last row.
const CHUNK: usize = 16;

/// One byte a voxel: 0 if it refers to something, else one more than the reach
/// of the largest cube around it that is empty where it lies in the grid.
pub struct Clearance<'a> {
    bytes: &'a [u8],
    pub row: usize,
    pub plane: usize,
}

/// Bytes before the first voxel's, between rows, and between planes.
fn layout(n: [usize; 3]) -> (usize, usize, usize) {
    let row = n[0] + 1;
    let plane = row * (n[1] + 1);
    (plane + row + 1, row, plane)
}

impl<'a> Clearance<'a> {
    /// Bytes of memory for a grid of `n` voxels.
    pub fn size(n: [usize; 3]) -> usize {
        let (first, row, plane) = layout(n);
        first + n[2] * plane + plane + row + CHUNK
    }

    /// Measures a grid's voxels; `bytes` are [`Clearance::size`] of them.
    pub fn new(n: [usize; 3], spans: &[Span], bytes: &'a mut [u8]) -> Self {
        let (first, row, plane) = layout(n);
        bytes.fill(OUTSIDE);
        let rows = |z: usize| (0..n[1]).map(move |y| first + z * plane + y * row);
        let mut spans = spans.chunks_exact(n[0]);
        for at in (0..n[2]).flat_map(rows) {
            let filled = spans.next().unwrap_or_default();
            let nearest = |x: usize, b: &[u8]| {
                let [below, under] = [at + x - plane - 1, at + x - row - 1];
                [below - row, below, below + row, under].map(|i| chunk(b, i))
            };
            let mut last = OUTSIDE;
            for start in (0..n[0]).step_by(CHUNK) {
                let around = spread(|side| nearest(start + side, bytes));
                let part = &filled[start..n[0].min(start + CHUNK)];
                for ((to, near), span) in bytes[at + start..].iter_mut().zip(around).zip(part) {
                    let empty = u8::from(span.count == 0);
                    last = (last.min(near).min(MOST - 1) + 1) * empty;
                    *to = last;
                }
            }
        }
        for at in (0..n[2]).rev().flat_map(|z| rows(z).rev()) {
            let nearest = |x: usize, b: &[u8]| {
                let [above, over] = [at + x + plane - 1, at + x + row - 1];
                [above - row, above, above + row, over].map(|i| chunk(b, i))
            };
            let mut last = OUTSIDE;
            for start in (0..n[0]).step_by(CHUNK).rev() {
                let around = spread(|side| nearest(start + side, bytes));
                let end = n[0].min(start + CHUNK);
                let part = &mut bytes[at + start..at + end];
                for (to, near) in part.iter_mut().zip(around).rev() {
                    last = (*to).min(last.min(near).min(MOST - 1) + 1);
                    *to = last;
                }
            }
        }
        Self { bytes, row, plane }
    }

    /// Where voxel `at`'s byte is.
    #[inline(always)]
    pub fn index(&self, at: [usize; 3]) -> usize {
        self.plane + self.row + 1 + at[2] * self.plane + at[1] * self.row + at[0]
    }

    #[inline(always)]
    pub fn at(&self, index: usize) -> u8 {
        self.bytes[index]
    }
}

#[inline(always)]
fn chunk(bytes: &[u8], at: usize) -> [u8; CHUNK] {
    bytes[at..at + CHUNK].try_into().unwrap_or([0; CHUNK])
}

/// The least byte of the rows that `rows` gives, of each voxel and of its two
/// neighbours in x; its argument is where to read from, less one.
#[inline(always)]
fn spread(rows: impl Fn(usize) -> [[u8; CHUNK]; 4]) -> [u8; CHUNK] {
    let mut least = [OUTSIDE; CHUNK];
    for side in 0..3 {
        for row in rows(side) {
            for (a, b) in least.iter_mut().zip(row) {
                *a = (*a).min(b);
            }
        }
    }
    least
}
