//! What rays meet in their voxels: the boxes of lists, then pairs of a ray and a triangle.

use super::super::counters::Uncounted;
use super::super::query::{Query, decide};
use super::super::sieve::Sieve;
use super::columns::SLOTS;
use super::flight::Grids;
use super::pairs::Pairs;
use super::round::{Rounds, Slots};
use crate::arena::layout::{GRID_BIT, LIST_HEAD};
use crate::simd::{Kernel, Lanes};

/// How many triangles of a row of boxes to fetch: more are seldom met.
const FETCH: usize = 2;

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
    /// Looks at the boxes of lists.
    #[inline(always)]
    pub fn look(&mut self) {
        let (l, sections) = (self.lanes, self.sections);
        let mut n = self.pairs.len;
        for slot in Slots(self.sets.lists) {
            let (place, len) = (self.lists.places[slot], self.lists.lens[slot]);
            let refs = place + LIST_HEAD as u32;
            // If the list is empty this is its length, 0.
            let mixed = sections.eight(refs + len - 1)[0] & GRID_BIT != 0;
            let triangles = if mixed { self.split_apart(slot) } else { len };
            let planes = self.columns.planes(l, slot, self.flights[slot].mirror);
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
        let planes = self.columns.planes(self.lanes, slot, self.flights[slot].mirror);
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
    pub fn meet_apart(&mut self) {
        self.lanes.run(Meet(self));
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
        if let Some(enough) = decide(self.lanes, &mut flight.query, &flight.ray, triangle, number) {
            self.sets.done |= u32::from(enough) << slot;
            if Q::ANY && enough {
                self.recent.keep(number);
            }
            self.sieves[slot].limit(self.lanes, flight.query.limit());
            self.columns.stop[slot] = flight.stop();
        }
    }
}
