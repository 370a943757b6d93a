//! Lists of rays, one for each part of a node that waits.
//!
//! Lists lie one behind the other, those of the parts of a node after each other: what is taken
//! is the last, and the lists of its own parts take its place.

use super::RAYS;
use crate::arena::node::{MAX_DEPTH, NODE, PARTS};
use crate::simd::Lanes;

/// Rays in all lists.
pub const ROOM: usize = 12 * RAYS;

/// At most so many are read and written at once, from any place on.
pub const SPARE: usize = 16;

/// Lists: those of seven parts of each node on the way, and one.
const LISTS: usize = (PARTS - 1) * MAX_DEPTH + 1;

/// Numbers of the rows of [`Columns`].
pub const FROM: usize = 3;
pub const TO: usize = 7;

/// Rays of a list as boxes want them, a column each: pace and where they begin, entering and
/// where they end, leaving ([`Line`](super::super::descent::Line)).
pub type Columns = [[f32; RAYS + SPARE]; 11];

#[repr(C, align(64))]
pub struct Lists {
    pub columns: Columns,
    /// By rays: no tau above it is of interest; minus infinity if nothing is by now.
    pub tos: [f32; RAYS],
    /// The rays of the list that was taken, and the same of them.
    pub rays: [u32; RAYS + SPARE],
    pub ends: [f32; RAYS + SPARE],
    /// All lists: rays, and where they enter the list's part.
    pub ids: [u32; ROOM + SPARE],
    pub entries: [f32; ROOM + SPARE],
    /// How many rays are in lists.
    pub len: usize,
    /// Of each list its part's word and its first ray.
    parts: [[u32; 2]; LISTS],
    count: usize,
}

impl Lists {
    pub const NONE: Self = Self {
        columns: [[0.0; RAYS + SPARE]; 11],
        tos: [0.0; RAYS],
        rays: [0; RAYS + SPARE],
        ends: [0.0; RAYS + SPARE],
        ids: [0; ROOM + SPARE],
        entries: [0.0; ROOM + SPARE],
        len: 0,
        parts: [[0; 2]; LISTS],
        count: 0,
    };

    /// Puts a ray, one after the other, into the list of the root.
    #[inline(always)]
    pub fn begin(&mut self, ray: usize, to: f32) {
        let ray = ray % RAYS;
        self.tos[ray] = to;
        self.ids[ray] = ray as u32;
        self.entries[ray] = f32::MIN;
    }

    /// Makes a list of the root with the first so many rays, which is the only one.
    #[inline(always)]
    pub fn root(&mut self, count: usize) {
        self.parts[0] = [NODE, 0];
        (self.len, self.count) = (count, 1);
    }

    /// Whether there is room for lists of all parts of a node, of so many rays, repeated ones included.
    #[inline(always)]
    pub fn have_room(&self, count: usize) -> bool {
        self.len + PARTS * count.next_multiple_of(SPARE) <= ROOM
    }

    /// Makes what has come after the first `start` rays a list of its own, if it is anything.
    #[inline(always)]
    pub fn push(&mut self, part: u32, start: usize) -> bool {
        let any = self.len > start;
        self.parts[self.count % LISTS] = [part, start as u32];
        self.count += usize::from(any);
        any
    }

    /// Takes the last list: its part's word, and how many of its rays still want it, which are
    /// `rays` with their `ends`.
    #[inline(always)]
    pub fn pop<L: Lanes>(&mut self, l: L) -> Option<(u32, usize)> {
        self.count = self.count.checked_sub(1)?;
        let [part, start] = self.parts[self.count % LISTS];
        let (start, end) = (start as usize, self.len);
        let (mut at, mut count) = (start, 0);
        while at < end {
            let ids = self.ids[at % ROOM..].first_chunk().expect("there is room for more");
            let entries = self.entries[at % ROOM..].first_chunk().expect("likewise");
            let ends = l.gather(&self.tos, ids);
            let there = u32::MAX >> (32 - (end - at).min(L::WIDE));
            let some = l.at_most(l.load_wide(entries), ends) & there;
            let to = count % RAYS;
            l.compress(ids, some, self.rays[to..].first_chunk_mut().expect("likewise"));
            l.compress_wide(ends, some, self.ends[to..].first_chunk_mut().expect("likewise"));
            count += some.count_ones() as usize;
            at += L::WIDE;
        }
        self.len = start;
        Some((part, count))
    }

    /// Repeats the last of `count` rays until they are a multiple of `many`; what is repeated meets
    /// no box whose bounds are finite.
    #[inline(always)]
    pub fn fill_up(&mut self, count: usize, many: usize) -> usize {
        let whole = count.next_multiple_of(many);
        for i in count..whole {
            self.rays[i % RAYS] = self.rays[(count - 1) % RAYS];
            self.ends[i % RAYS] = f32::NEG_INFINITY;
        }
        whole
    }
}
