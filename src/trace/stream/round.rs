//! A round: each ray in flight reads its voxel, steps, and meets what the voxel has.
//!
//! Each of these is done for all rays before the next: nothing depends on the ray
//! before, and memory was asked for one of them earlier. A ray steps before it meets
//! what its voxel has, so that the next voxel is on its way meanwhile.

use super::super::counters::Uncounted;
use super::super::query::{Query, visible};
use super::super::sieve::Sieve;
use super::Port;
use super::columns::{Columns, SLOTS};
use super::flight::{Flight, Frame, Grids};
use super::pairs::Pairs;
use crate::arena::layout::{GRID_BIT, LIST_HEAD, PAYLOAD};
use crate::arena::{Sections, View};
use crate::simd::{Kernel, Lanes};
use crate::triangle::Line;

/// How many triangles of a row of boxes to fetch: more are seldom met.
const FETCH: usize = 2;

/// The lists of voxels, by slot.
pub(super) struct Lists {
    /// Where they are, and how long.
    places: [u32; SLOTS],
    lens: [u32; SLOTS],
    /// The grids to go down to.
    pub grids: [u32; SLOTS],
}

impl Lists {
    pub const NONE: Self = Self { places: [0; SLOTS], lens: [0; SLOTS], grids: [0; SLOTS] };
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
}

/// The slots of a set. No `from_fn`: a closure might not be inlined.
struct Slots(u32);

impl Iterator for Slots {
    type Item = usize;
    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let slot = self.0.trailing_zeros() as usize;
        self.0 &= self.0.wrapping_sub(1);
        (slot < SLOTS).then_some(slot)
    }
}

/// [`Rounds::meet`], compiled for the rays' instruction set.
struct Meet<'r, 'a, 'p, Q: Query, L: Lanes>(&'r mut Rounds<'a, 'p, Q, L>);

impl<Q: Query, L: Lanes> Kernel<L> for Meet<'_, '_, '_, Q, L> {
    type Out = ();
    #[inline(always)]
    fn run(self, _: L) {
        self.0.meet();
    }
}

/// [`Rounds::split`], likewise.
struct Split<'r, 'a, 'p, Q: Query, L: Lanes>(&'r mut Rounds<'a, 'p, Q, L>, usize);

impl<Q: Query, L: Lanes> Kernel<L> for Split<'_, '_, '_, Q, L> {
    type Out = u32;
    #[inline(always)]
    fn run(self, _: L) -> u32 {
        self.0.split(self.1)
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

    /// Looks at the boxes of lists.
    #[inline(always)]
    fn look(&mut self) {
        let (l, sections) = (self.lanes, self.sections);
        let mut n = self.pairs.len;
        for slot in Slots(self.sets.lists) {
            let (place, len) = (self.lists.places[slot], self.lists.lens[slot]);
            let refs = place + LIST_HEAD as u32;
            // If the list is empty this is its length, 0.
            let mixed = sections.eight(refs + len - 1)[0] & GRID_BIT != 0;
            let triangles = if mixed { self.split_apart(slot) } else { len };
            let planes = self.columns.planes(l, slot, self.flights[slot].course.mirror);
            let mut at = 0;
            while at < triangles {
                if n > Pairs::MOST - 8 {
                    self.pairs.len = n;
                    self.meet_apart();
                    n = 0;
                }
                let met = planes.met(l, sections.eight(refs + len + at));
                let met = met & !u32::MAX.checked_shl(triangles - at).unwrap_or(0);
                let [slots, numbers] = self.pairs.eight_mut(n);
                *slots = [slot as u32; 8];
                l.compress(sections.eight(refs + at), met, numbers);
                let count = met.count_ones() as usize;
                for (i, &number) in numbers[..FETCH].iter().enumerate() {
                    // What is not met had better not be fetched; triangle 0 costs nothing.
                    sections.fetch_triangle(l, if i < count { number } else { 0 });
                }
                n += count;
                at += L::WIDE as u32;
            }
        }
        self.pairs.len = n;
    }

    /// The number of triangles in a list of which the last are grids. If the ray meets the
    /// box of one of these it goes down to them.
    #[inline(always)]
    fn split(&mut self, slot: usize) -> u32 {
        let (_, refs) = self.sections.list(self.lists.places[slot]);
        let planes = self.columns.planes(self.lanes, slot, self.flights[slot].course.mirror);
        let triangles = refs.partition_point(|r| r & GRID_BIT == 0) as u32;
        let (first, len) = (self.lists.places[slot] + LIST_HEAD as u32, refs.len() as u32);
        let mut at = triangles;
        while at < len {
            let met = planes.met(self.lanes, self.sections.eight(first + len + at));
            let met = met & !u32::MAX.checked_shl(len - at).unwrap_or(0);
            if met != 0 {
                let at = first + at + met.trailing_zeros();
                self.flights[slot].grids = Grids { at, end: first + len };
                self.lists.grids[slot] = self.next_grid(slot);
                self.sets.down |= 1 << slot;
                break;
            }
            at += L::WIDE as u32;
        }
        triangles
    }

    /// [`Rounds::split`], so that the registers of what is done more often are not spilled.
    #[cold]
    #[inline(never)]
    fn split_apart(&mut self, slot: usize) -> u32 {
        self.lanes.run(Split(self, slot))
    }

    /// [`Rounds::meet`], likewise, and so that there is one of it.
    #[inline(never)]
    fn meet_apart(&mut self) {
        self.lanes.run(Meet(self));
    }

    /// Takes the next grid of a list.
    #[inline(always)]
    pub fn next_grid(&mut self, slot: usize) -> u32 {
        let grids = &mut self.flights[slot].grids;
        let grid = self.sections.eight(grids.at)[0] & !GRID_BIT;
        grids.at += 1;
        self.sections.fetch_grid(self.lanes, grid);
        grid
    }

    /// Sieves and decides all pairs.
    #[inline(always)]
    fn meet(&mut self) {
        let Self { lanes: l, ref sieves, ref mut pairs, ref mut due, .. } = *self;
        let mut n = 0;
        for i in (0..pairs.len).step_by(L::WIDE) {
            let [slots, numbers] = pairs.eight(i);
            let sieve = |j: usize| &sieves[slots[j] as usize % SLOTS];
            let left = Sieve::pass_each(l, sieve, numbers);
            let left = left & !u32::MAX.checked_shl((pairs.len - i) as u32).unwrap_or(0);
            let [slots_due, numbers_due] = due.eight_mut(n);
            l.compress(slots, left, slots_due);
            l.compress(numbers, left, numbers_due);
            n += left.count_ones() as usize;
        }
        pairs.len = 0;
        for i in 0..n {
            let (slot, number) = self.due.get(i);
            self.decide(slot, number);
        }
    }

    /// The exact test.
    #[inline(always)]
    fn decide(&mut self, slot: usize, number: u32) {
        let flight = &mut self.flights[slot];
        let done = self.sets.done >> slot & 1 != 0;
        if done || !flight.decided.is_due::<Uncounted>(number) {
            return;
        }
        let triangle = self.sections.triangle(number);
        if !visible(&flight.ray, triangle) {
            return;
        }
        if let Some(enough) = flight.query.meet(&Line::new(&flight.ray), triangle, number) {
            self.sets.done |= u32::from(enough) << slot;
            self.sieves[slot].limit(flight.query.limit());
            self.columns.stop[slot] = flight.stop();
        }
    }

    /// Sends each ray where it goes next.
    #[inline(always)]
    fn settle(&mut self) {
        let mut on = 0;
        for i in (0..SLOTS).step_by(L::WIDE) {
            on |= self.columns.go_on(self.lanes, i) << i;
        }
        let Sets { live, down, done, .. } = self.sets;
        let (on, down) = (on & live & !done, down & !done);
        for slot in Slots(down) {
            self.descend(slot, on >> slot & 1 != 0);
        }
        for slot in Slots(live & !on & !down) {
            self.leave(slot);
        }
        self.columns.arrive();
    }
}
