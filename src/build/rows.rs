//! Rows of a grid's voxels as bits, and unions of them: whether a layer of voxels is empty
//! is told by a few words.

/// Rows in a union.
pub const UNION: usize = 4;

/// Rows of bits, of all of which the same 64 bits are looked at.
#[derive(Clone, Copy)]
pub struct Rows<'a> {
    pub single: &'a [u8],
    /// Unions of four rows, from the one named on, along y and along z.
    pub unions: [&'a [u8]; 2],
    /// Of four times four.
    pub squares: &'a [u8],
    /// From a row to the next, along y and along z.
    pub steps: [usize; 2],
}

/// The union of each row with the three that follow at distance `step`, in words.
pub fn unite(from: &[u64], to: &mut [u64], step: usize) {
    let Some(used) = from.len().checked_sub((UNION - 1) * step) else { return };
    let rows = from.iter().zip(&from[step..]).zip(&from[2 * step..]).zip(&from[3 * step..]);
    for (to, (((a, b), c), d)) in to[..used].iter_mut().zip(rows) {
        *to = a | b | c | d;
    }
}

#[inline(always)]
fn load(bytes: &[u8], at: usize) -> u64 {
    bytes[at..].first_chunk().map_or(0, |&bytes| u64::from_le_bytes(bytes))
}

impl Rows<'_> {
    /// The row at a place.
    #[inline(always)]
    pub fn at(&self, place: usize) -> u64 {
        load(self.single, place)
    }

    /// The union of `count` rows from `place` on, along y (0) or z (1).
    #[inline(always)]
    pub fn union<const ALONG: usize>(&self, place: usize, count: usize) -> u64 {
        unite_at([self.single, self.unions[ALONG]], place, self.steps[ALONG], count)
    }

    /// The union of four layers of rows: these and those behind them along the other axis.
    #[inline(always)]
    pub fn union_of_four<const ALONG: usize>(&self, place: usize, count: usize) -> u64 {
        unite_at([self.unions[1 - ALONG], self.squares], place, self.steps[ALONG], count)
    }

    /// The union of `count[0]` rows along y, of `count[1]` planes.
    #[inline(always)]
    pub fn block(&self, mut place: usize, count: [usize; 2]) -> u64 {
        let step = self.steps[1];
        let mut bits = 0;
        if count[1] < UNION {
            for _ in 0..count[1] {
                bits |= self.union::<0>(place, count[0]);
                place += step;
            }
            return bits;
        }
        let last = place + (count[1] - UNION) * step;
        while place < last {
            bits |= self.union_of_four::<0>(place, count[0]);
            place += UNION * step;
        }
        bits | self.union_of_four::<0>(last, count[0])
    }
}

/// The union of `count` entries, `step` apart, of the first of two tables; the second has
/// the unions of four.
#[inline(always)]
fn unite_at([single, unions]: [&[u8]; 2], mut place: usize, step: usize, count: usize) -> u64 {
    let mut bits = 0;
    if count < UNION {
        for _ in 0..count {
            bits |= load(single, place);
            place += step;
        }
        return bits;
    }
    let last = place + (count - UNION) * step;
    while place < last {
        bits |= load(unions, place);
        place += UNION * step;
    }
    bits | load(unions, last)
}
