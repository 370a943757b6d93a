//! What happens to a ray in flight, piece by piece: each function takes it through
//! one [`Phase`] and says what it needs next. Together they are
//! [`super::super::walk::Walk`], cut where that has to wait for memory or cannot know
//! what comes. What the next piece reads is fetched at the end of the one before.

use super::super::bounds::{BATCH, Part};
use super::super::counters::Count;
use super::super::local::{Local, Step};
use super::super::query::{Query, visible};
use super::super::sieve::chunk;
use super::queues::Phase;
use super::slot::{Frame, Refs, Slot};
use crate::arena::Sections;
use crate::arena::layout::{EMPTY, GRID_BIT, LIST, LIST_HEAD, PAYLOAD, TAG_SHIFT};
use crate::simd::Lanes;
use crate::triangle::Line;

/// How many triangles to fetch that are to be sieved.
const FETCH: usize = 4;

/// What all rays share.
pub(super) struct Common<'a, 'c, C, L: Lanes> {
    pub lanes: L,
    pub sections: Sections<'a>,
    pub counters: &'c mut C,
}

/// What follows a voxel's tag.
const BY_TAG: [Phase; 4] = [Phase::Advance, Phase::Open, Phase::Descend, Phase::Descend];

impl<Q: Query, C: Count, L: Lanes> Slot<'_, Q, C, L> {
    /// Enters a grid.
    #[inline(always)]
    pub fn enter(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        let grid = with.sections.grid(self.grid);
        self.level = C::of(grid.level);
        with.counters.level(self.level);
        with.counters.grid();
        let [t0, t1] = self.range;
        let Some(local) = Local::enter(with.lanes, grid, &self.course, &self.ray, t0, t1) else {
            return Phase::Return;
        };
        self.local = local;
        self.come(with, 0.0, local.at, local.stop(self.limit()))
    }

    /// Comes to voxel `at`.
    #[inline(always)]
    fn come(&mut self, with: &mut Common<'_, '_, C, L>, s: f32, at: L::I32, stop: f32) -> Phase {
        (self.s, self.at, self.stop, self.cut) = (s, at, stop, stop);
        self.place = self.local.number(with.lanes, &self.course, at);
        with.sections.fetch_voxel(with.lanes, self.place);
        Phase::Visit
    }

    /// Reads a voxel.
    #[inline(always)]
    pub fn visit(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        with.counters.level(self.level);
        with.counters.voxel();
        let voxel = with.sections.voxel(self.place as usize);
        let (tag, payload) = (voxel >> TAG_SHIFT, voxel & PAYLOAD);
        // The exit box if it is empty, else its list's place or one grid.
        self.exit = if tag == EMPTY { payload } else { 0 };
        self.place = payload;
        self.grid = payload;
        self.grids = Refs::default();
        with.sections.fetch_list(with.lanes, if tag == LIST { payload } else { 0 });
        BY_TAG[tag as usize % 4]
    }

    /// Reads the head of a list.
    #[inline(always)]
    pub fn open(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        (self.exit, self.len) = with.sections.head(self.place);
        with.sections.fetch_list(with.lanes, self.place + self.len);
        let out = self.step(with).out;
        let until = if out < self.stop { out } else { self.stop };
        let range = [self.s, until];
        self.boxes = self.local.boxes(with.lanes, &self.course, self.at, self.exit, range);
        self.triangles = Refs { at: 0, end: self.len };
        self.then = Phase::Advance;
        Phase::Look
    }

    /// Looks at the next boxes.
    #[inline(always)]
    pub fn look(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        let Refs { at, end } = self.triangles;
        let part = Part::new(self.place, self.len, at, end);
        self.few.fill::<C, L>(with.lanes, &with.sections, part, &self.boxes);
        self.triangles.at = end.min(at + BATCH as u32);
        if self.few.drop_grids() {
            let (_, refs) = with.sections.list(self.place);
            let first = refs.partition_point(|r| r & GRID_BIT == 0) as u32;
            let refs = self.place + LIST_HEAD as u32;
            self.grids = Refs { at: refs + first, end: refs + self.len };
            self.next_grid(with);
            self.triangles.at = end;
            self.then = Phase::Descend;
        }
        self.sieved = 0;
        // Some, rather than a number that cannot be foreseen.
        for i in 0..FETCH {
            with.sections.fetch_triangle(with.lanes, self.few.any(i));
        }
        self.after()
    }

    /// Takes the next grid of the list.
    #[inline(always)]
    fn next_grid(&mut self, with: &mut Common<'_, '_, C, L>) {
        self.grid = with.sections.eight(self.grids.at)[0] & !GRID_BIT;
        self.grids.at += 1;
        with.sections.fetch_grid(with.lanes, self.grid);
    }

    /// What follows the triangles that were sieved.
    #[inline(always)]
    fn after(&self) -> Phase {
        let Refs { at, end } = self.triangles;
        let then = if at == end { self.then } else { Phase::Look };
        let then = if self.sieved as usize == self.few.refs().len() { then } else { Phase::Sieve };
        if self.left == 0 { then } else { Phase::Decide }
    }

    /// Sieves a few triangles of the list.
    #[inline(always)]
    pub fn sift(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        let refs = &self.few.refs()[self.sieved as usize..];
        let few = &refs[..refs.len().min(chunk::<C, L>())];
        with.counters.level(self.level);
        if C::LOOKS {
            few.iter().for_each(|&r| with.counters.look(&self.ray, with.sections.triangle(r)));
        }
        with.counters.tests(few.len());
        self.left = self.sieve.pass(with.lanes, few);
        self.sieved += few.len() as u32;
        self.after()
    }

    /// Decides one of them.
    #[inline(always)]
    pub fn decide(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        let chunk = chunk::<C, L>() as u32;
        let first = (self.sieved - 1) / chunk * chunk;
        let number = self.few.any((first + self.left.trailing_zeros()) as usize);
        self.left &= self.left - 1;
        if self.decided.is_due::<C>(number) {
            let triangle = with.sections.triangle(number);
            if visible(&self.ray, triangle)
                && let Some(enough) = self.query.meet(&Line::new(&self.ray), triangle, number)
            {
                with.counters.level(self.level);
                with.counters.hit();
                if enough {
                    return Phase::Done;
                }
                self.sieve.limit(self.query.limit());
                self.cut = self.local.stop(self.limit());
            }
        }
        self.after()
    }

    #[inline(always)]
    fn step(&self, with: &Common<'_, '_, C, L>) -> Step<L> {
        self.local.step::<C>(with.lanes, &self.course, self.at, self.exit)
    }

    /// Leaves the exit box.
    #[inline(always)]
    pub fn advance(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        let Step { out, to } = self.step(with);
        let inside = !with.lanes.any_greater(to, self.local.last);
        let goes_on = (out < self.cut) & inside;
        self.come(with, out, to, self.cut);
        if goes_on { Phase::Visit } else { Phase::Return }
    }

    /// Goes down to a grid, over the part of the ray in the exit box.
    #[inline(always)]
    pub fn descend(
        &mut self,
        with: &mut Common<'_, '_, C, L>,
        frames: &mut [Frame<C, L>],
    ) -> Phase {
        let Step { out, to } = self.step(with);
        let until = if out < self.stop { out } else { self.stop };
        self.range = [self.local.low(self.s), self.local.high(until)];
        let inside = !with.lanes.any_greater(to, self.local.last);
        let goes_on = (out < self.cut) & inside;
        if (goes_on || !self.grids.is_empty())
            && let Some(frame) = frames.get_mut(self.depth)
        {
            let Self { level, local, grids, range, .. } = *self;
            *frame = Frame { level, local, to, out, grids, range };
            self.depth += 1;
        }
        Phase::Enter
    }

    /// Goes on in the grid above, or in the next one of the list.
    #[inline(always)]
    pub fn climb(&mut self, with: &mut Common<'_, '_, C, L>, frames: &mut [Frame<C, L>]) -> Phase {
        while let Some(frame) = self.depth.checked_sub(1).and_then(|top| frames.get_mut(top)) {
            if !frame.grids.is_empty() {
                (self.grids, self.range) = (frame.grids, frame.range);
                self.next_grid(with);
                frame.grids = self.grids;
                return Phase::Enter;
            }
            self.depth -= 1;
            (self.level, self.local) = (frame.level, frame.local);
            let stop = self.local.stop(self.limit());
            if frame.out < stop && !with.lanes.any_greater(frame.to, self.local.last) {
                return self.come(with, frame.out, frame.to, stop);
            }
        }
        Phase::Done
    }
}
