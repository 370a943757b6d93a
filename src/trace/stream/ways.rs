//! Ways between grids, and in and out of the stream.

use super::super::counters::Uncounted;
use super::super::course::{Course, Mirror};
use super::super::local::Local;
use super::super::query::{Query, beyond, decide, usable};
use super::super::sieve::{Sieve, holds};
use super::super::turned::{Turned, turned};
use super::columns::SLOTS;
use super::flight::{Flight, Frame};
use super::round::{Rounds, Slots};
use crate::arena::layout::{GRID_BIT, TURNED};
use crate::ray::Ray;
use crate::simd::{Kernel, Lanes};

/// Slots whose rays leave their grids, are to be loaded, or enter the grids that they are
/// to enter: a bit each.
#[derive(Default)]
pub(super) struct Moves {
    pub leave: u32,
    pub load: u32,
    pub enter: u32,
}

/// What a ray for any hit is held against before its walk.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Hiding {
    Occluders,
    Recent,
}

/// Where a ray goes that leaves a grid.
enum Way {
    /// On, in the grid above.
    On,
    /// Down to the next grid of a list.
    Down,
    /// Nowhere: it is answered.
    Out,
}

/// The frames of a slot.
#[inline(always)]
fn frames(frames: &mut [Frame], depth: usize, slot: usize) -> &mut [Frame] {
    frames.get_mut(slot * depth..(slot + 1) * depth).unwrap_or_default()
}

/// [`Rounds::enter_turned`], compiled for the rays' instruction set.
struct EnterTurned<'r, 'a, 'p, Q: Query, L: Lanes> {
    rounds: &'r mut Rounds<'a, 'p, Q, L>,
    slot: usize,
    grid: u32,
    range: [f64; 2],
}

impl<Q: Query, L: Lanes> Kernel<L> for EnterTurned<'_, '_, '_, Q, L> {
    type Out = bool;
    #[inline(always)]
    fn run(self, l: L) -> bool {
        let Self { rounds, slot, grid, range } = self;
        let Flight { ref course, ref ray, .. } = rounds.flights[slot];
        let (record, frame) = (rounds.sections.grid(grid), rounds.sections.frame(grid));
        let ray = &Turned { grid: record, frame, course, ray, range };
        let Some(local) = turned(l, ray) else { return false };
        rounds.arrive(slot, &local);
        true
    }
}

impl<Q: Query, L: Lanes> Rounds<'_, '_, Q, L> {
    /// Takes the whole stream through.
    #[inline(always)]
    pub fn run(&mut self, flying: usize) {
        let slots = u32::MAX >> (SLOTS - flying.min(SLOTS));
        self.send(Moves { load: slots, ..Moves::default() });
        self.columns.arrive();
        while self.sets.live != 0 {
            self.round();
        }
    }

    /// Moves rays until all are in voxels. Each move is made for all rays at once, so
    /// that there is one copy of it.
    #[inline(always)]
    pub fn send(&mut self, mut moves: Moves) {
        loop {
            for slot in Slots(core::mem::take(&mut moves.leave)) {
                match self.leave(slot) {
                    Way::On => {}
                    Way::Down => moves.enter |= 1 << slot,
                    Way::Out => moves.load |= 1 << slot,
                }
            }
            for slot in Slots(core::mem::take(&mut moves.load)) {
                self.load(slot);
            }
            for slot in Slots(core::mem::take(&mut moves.enter)) {
                let (grid, range) = (self.lists.grids[slot], self.lists.ranges[slot]);
                moves.leave |= u32::from(!self.enter(slot, grid, range)) << slot;
            }
            if moves.leave == 0 {
                return;
            }
        }
    }

    /// Puts the next ray in a slot, in the outermost grid, if there is one left.
    #[inline(always)]
    fn load(&mut self, slot: usize) {
        self.sets.live &= !(1 << slot);
        self.sets.done &= !(1 << slot);
        while self.next < self.n {
            let index = self.next;
            self.next += 1;
            let mut ray = Ray::new([0.0; 3], [0.0; 3]);
            self.port.ray(index, &mut ray);
            if !usable(self.lanes, &ray) {
                self.port.put(index, Q::miss(&ray));
                continue;
            }
            if self.begin(slot, ray, index) {
                self.sets.live |= 1 << slot;
                return;
            }
            let Flight { ref query, ref ray, .. } = self.flights[slot];
            self.port.put(index, query.found(&self.sections, ray));
        }
    }

    /// Whether a ray enters the outermost grid, and is not answered before.
    #[inline(always)]
    fn begin(&mut self, slot: usize, ray: Ray, index: usize) -> bool {
        let l = self.lanes;
        let [org, dir, _] = ray.rows();
        let rows = [l.load3(org), l.load3(dir)];
        let header = self.view.header();
        let course = Course::new(l, rows[0], rows[1], header.unit);
        let [lo, hi] = header.corners();
        let holds = holds(l, rows[0], [l.load_f32(lo), l.load_f32(hi)]);
        self.sieves[slot] = Sieve::new(l, &self.sections, &ray, rows, holds);
        self.flights[slot] = Flight::new(ray, index, course);
        if Q::ANY && self.is_hidden(slot) {
            return false;
        }
        self.columns.turn(slot, course.mirror);
        // A t that rounds to tmin may lie below it, one that rounds to tmax above.
        let range = [-beyond(-ray.tmin) * course.per_t, beyond(ray.tmax) * course.per_t];
        self.enter(slot, 0, range)
    }

    /// Whether one of the occluders, or of what has stopped others lately, is all that a ray
    /// wants.
    #[inline(always)]
    fn is_hidden(&mut self, slot: usize) -> bool {
        let flight = &mut self.flights[slot];
        for list in [Hiding::Occluders, Hiding::Recent] {
            let (recent, len);
            let triangles = match list {
                Hiding::Occluders => self.view.header().occluders(),
                Hiding::Recent => {
                    (recent, len) = self.recent.next();
                    &recent[..len]
                }
            };
            for few in triangles.chunks(L::WIDE) {
                let (sections, sieve) = (self.sections, &self.sieves[slot]);
                let (mut left, sieved) = sieve.few(self.lanes, few);
                let triangle = |i: usize| sections.triangle(few[i]);
                if sieve.hits(self.lanes, &flight.ray, &sieved, left, triangle) {
                    if list == Hiding::Recent {
                        self.recent.stopped();
                    }
                    flight.query.take_any();
                    return true;
                }
                while left != 0 {
                    let number = few[left.trailing_zeros() as usize];
                    left &= left - 1;
                    let triangle = self.sections.triangle(number);
                    if flight.decided.is_due::<Uncounted>(number)
                        && decide(self.lanes, &mut flight.query, &flight.ray, triangle, number)
                            == Some(true)
                    {
                        if list == Hiding::Recent {
                            self.recent.stopped();
                        }
                        return true;
                    }
                }
            }
        }
        false
    }

    /// Whether a ray can be in a grid for tau in `range`; then it is.
    #[inline(always)]
    fn enter(&mut self, slot: usize, grid: u32, range: [f64; 2]) -> bool {
        let l = self.lanes;
        let record = self.sections.grid(grid);
        if record.flags & TURNED != 0 {
            return self.enter_turned(slot, grid, range);
        }
        let Flight { ref course, ref ray, .. } = self.flights[slot];
        let Some(local) = Local::enter_aligned(l, record, course, ray, range) else {
            return false;
        };
        self.arrive(slot, &local);
        true
    }

    /// [`Rounds::enter`] for a grid that is turned; apart, as that is seldom.
    #[cold]
    fn enter_turned(&mut self, slot: usize, grid: u32, range: [f64; 2]) -> bool {
        self.lanes.run(EnterTurned { rounds: self, slot, grid, range })
    }

    /// Puts a ray in a grid.
    #[inline(always)]
    fn arrive(&mut self, slot: usize, local: &Local<L>) {
        let l = self.lanes;
        self.face(slot, local.mirror);
        let flight = &mut self.flights[slot];
        flight.span = local.span;
        self.columns.enter(l, slot, local);
        self.columns.stop[slot] = flight.stop();
        self.sections.fetch_voxel(l, self.columns.number[slot]);
    }

    /// Goes on in coordinates in which the ray has this mirror.
    #[inline(always)]
    fn face(&mut self, slot: usize, mirror: &'static Mirror) {
        let flight = &mut self.flights[slot];
        if !core::ptr::eq(flight.mirror, mirror) {
            flight.mirror = mirror;
            self.columns.turn(slot, mirror);
        }
    }

    /// Whether a ray goes down to a grid, over the part of it in the exit box. `on`: will go
    /// on in this grid then.
    #[inline(always)]
    pub fn descend(&mut self, slot: usize, on: bool) -> bool {
        let flight = &mut self.flights[slot];
        let [from, until] = self.columns.range(slot);
        if until < from {
            // A hit has ended it before.
            return false;
        }
        let range = [flight.span.low(from), flight.span.high(until)];
        self.lists.ranges[slot] = range;
        if (on || !flight.grids.is_empty())
            && let Some(frame) = frames(self.frames, self.depth, slot).get_mut(flight.depth)
        {
            let kept = self.columns.keep(slot);
            let Flight { mirror, span, grids, .. } = *flight;
            *frame = Frame { kept, mirror, span, grids, range };
            flight.depth += 1;
        }
        true
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

    /// Leaves a grid: for the next of a list, for the one above, or for good.
    #[inline(always)]
    fn leave(&mut self, slot: usize) -> Way {
        if self.sets.done >> slot & 1 == 0 {
            let way = self.climb(slot);
            if !matches!(way, Way::Out) {
                return way;
            }
        }
        let Flight { index, ref query, ref ray, .. } = self.flights[slot];
        self.port.put(index, query.found(&self.sections, ray));
        Way::Out
    }

    /// Where a ray goes from a grid that it is through with.
    #[inline(always)]
    fn climb(&mut self, slot: usize) -> Way {
        while let Some(top) = self.flights[slot].depth.checked_sub(1) {
            let frame = match frames(self.frames, self.depth, slot).get_mut(top) {
                Some(frame) => *frame,
                None => return Way::Out,
            };
            let flight = &mut self.flights[slot];
            if !frame.grids.is_empty() {
                flight.grids = frame.grids;
                self.lists.grids[slot] = self.next_grid(slot);
                self.lists.ranges[slot] = frame.range;
                frames(self.frames, self.depth, slot)[top].grids = self.flights[slot].grids;
                return Way::Down;
            }
            flight.depth = top;
            flight.span = frame.span;
            self.columns.stop[slot] = flight.stop();
            self.columns.restore(slot, &frame.kept);
            self.face(slot, frame.mirror);
            if self.columns.goes_on(slot) {
                self.sections.fetch_voxel(self.lanes, self.columns.number[slot]);
                return Way::On;
            }
        }
        Way::Out
    }
}
