//! A round: each ray in flight reads its voxel, steps, and meets what the voxel has.
//!
//! Each of these is done for all rays before the next: nothing depends on the ray
//! before, and memory was asked for one of them earlier. A ray steps before it meets
//! what its voxel has, so that the next voxel is on its way meanwhile.

use super::super::query::Query;
use super::super::sieve::Sieve;
use super::Port;
use super::columns::{Columns, SLOTS};
use super::flight::{Flight, Frame, Grids};
use super::pairs::Pairs;
use super::recent::Recent;
use super::ways::Moves;
use crate::arena::layout::PAYLOAD;
use crate::arena::{Sections, View};
use crate::simd::Lanes;

/// The lists of voxels, by slot.
pub(super) struct Lists {
    /// Where they are, and how long.
    pub places: [u32; SLOTS],
    pub lens: [u32; SLOTS],
    /// The grids to enter, and for what range of tau.
    pub grids: [u32; SLOTS],
    pub ranges: [[f64; 2]; SLOTS],
}

impl Lists {
    pub const NONE: Self =
        Self { places: [0; SLOTS], lens: [0; SLOTS], grids: [0; SLOTS], ranges: [[0.0; 2]; SLOTS] };
}

/// Sets of slots, a bit each.
#[derive(Clone, Copy, Default)]
pub(super) struct Sets {
    /// In flight.
    pub live: u32,
    /// In voxels with lists.
    pub lists: u32,
    /// About to go down to a grid.
    pub down: u32,
    /// Having all they want.
    pub done: u32,
}

/// Rays on their way.
pub(super) struct Rounds<'a, 'p, Q: Query, L: Lanes> {
    pub lanes: L,
    pub view: &'a View<'a>,
    pub sections: Sections<'a>,
    pub port: &'p mut dyn Port<Q::Out>,
    /// The next ray of the stream, and their number.
    pub next: usize,
    pub n: usize,
    pub columns: &'p mut Columns,
    pub flights: &'p mut [Flight<Q, L>; SLOTS],
    pub sieves: &'p mut [Sieve<'a>; SLOTS],
    pub frames: &'p mut [Frame],
    /// Frames of each slot.
    pub depth: usize,
    pub lists: &'p mut Lists,
    /// What is to be sieved, and to be decided.
    pub pairs: &'p mut Pairs,
    pub due: &'p mut Pairs,
    pub sets: Sets,
    pub recent: &'p mut Recent,
}

/// The slots of a set. No `from_fn`: a closure might not be inlined.
pub(super) struct Slots(pub u32);

impl Iterator for Slots {
    type Item = usize;
    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let slot = self.0.trailing_zeros() as usize;
        self.0 &= self.0.wrapping_sub(1);
        (slot < SLOTS).then_some(slot)
    }
}

impl<Q: Query, L: Lanes> Rounds<'_, '_, Q, L> {
    /// Takes each ray one step.
    #[inline(always)]
    pub fn round(&mut self) {
        self.visit();
        self.step();
        self.look();
        self.meet_apart();
        self.settle();
    }

    /// Reads voxels, and heads of lists.
    #[inline(always)]
    fn visit(&mut self) {
        let Self { lanes: l, ref sections, ref mut columns, ref mut lists, .. } = *self;
        let live = self.sets.live;
        for slot in 0..SLOTS {
            // Voxel 0 always exists; the numbers of rays that are not there mean nothing.
            let number = if live >> slot & 1 != 0 { columns.number[slot] } else { 0 };
            columns.exit[slot] = sections.voxel(number as usize);
        }
        let mut tags = [0; 2];
        for i in (0..SLOTS).step_by(L::WIDE) {
            let here = columns.tags(l, i);
            tags = [tags[0] | here[0] << i, tags[1] | here[1] << i];
        }
        let (with_list, down) = (tags[0] & live, tags[1] & live);
        self.sets.lists = with_list;
        self.sets.down = down;
        for slot in Slots(down) {
            lists.grids[slot] = columns.exit[slot] & PAYLOAD;
            columns.exit[slot] = 0;
            sections.fetch_grid(l, lists.grids[slot]);
            self.flights[slot].grids = Grids::NONE;
        }
        for slot in Slots(with_list) {
            sections.fetch_list(l, columns.exit[slot] & PAYLOAD);
        }
        for slot in Slots(with_list) {
            let place = columns.exit[slot] & PAYLOAD;
            let (exit, len) = sections.head(place);
            lists.places[slot] = place;
            lists.lens[slot] = len;
            columns.exit[slot] = exit;
            sections.fetch_list(l, place + len);
        }
    }

    /// Leaves exit boxes.
    #[inline(always)]
    fn step(&mut self) {
        let Self { lanes: l, ref mut columns, sets: Sets { live, lists, .. }, .. } = *self;
        let row = u32::MAX >> (32 - L::WIDE);
        for i in (0..SLOTS).step_by(L::WIDE) {
            if live >> i & row != 0 {
                columns.step(l, i, lists >> i & row != 0);
            }
        }
        for slot in Slots(live) {
            self.sections.fetch_voxel(l, columns.number[slot]);
        }
    }

    /// Sends each ray where it goes next.
    #[inline(always)]
    fn settle(&mut self) {
        let mut on = 0;
        for i in (0..SLOTS).step_by(L::WIDE) {
            on |= self.columns.who_go_on(self.lanes, i) << i;
        }
        let Sets { live, down, done, .. } = self.sets;
        let (on, down) = (on & live & !done, down & !done);
        let mut moves = Moves { leave: live & !on & !down, ..Moves::default() };
        for slot in Slots(down) {
            if self.descend(slot, on >> slot & 1 != 0) {
                moves.enter |= 1 << slot;
            } else {
                moves.leave |= 1 << slot;
            }
        }
        self.send(moves);
        self.columns.arrive();
    }
}
