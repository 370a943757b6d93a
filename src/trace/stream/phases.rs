//! What happens to a ray in flight, piece by piece: each function takes it through
//! one [`Phase`] and says what it needs next. Together they are
//! [`super::super::walk::Walk`], cut where that has to wait for memory or cannot know
//! what comes. What the next piece reads is fetched at the end of the one before.

use super::super::counters::Count;
use super::super::local::{Local, Step};
use super::super::query::{Query, visible};
use super::queues::Phase;
use super::slot::{DECIDED, Frame, Refs, Slot};
use crate::arena::Sections;
use crate::arena::layout::{EMPTY, GRID_BIT, LIST, LIST_HEAD, PAYLOAD, TAG_SHIFT};
use crate::simd::Lanes;
use crate::triangle::Line;

/// What all rays share.
pub(super) struct Common<'a, 'c, C, L: Lanes> {
    pub lanes: L,
    pub sections: Sections<'a>,
    pub counters: &'c mut C,
}

/// What follows a voxel's tag.
const BY_TAG: [Phase; 4] = [Phase::Advance, Phase::Open, Phase::Descend, Phase::Descend];

impl<Q: Query, L: Lanes> Slot<'_, Q, L> {
    /// Enters a grid.
    #[inline(always)]
    pub fn enter<C: Count>(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        with.counters.grid();
        let grid = with.sections.grid(self.grid);
        let [t0, t1] = self.range;
        let Some(local) = Local::enter(with.lanes, grid, &self.course, &self.ray, t0, t1) else {
            return Phase::Return;
        };
        self.local = local;
        self.come(with, 0.0, local.at, local.stop(self.limit()))
    }

    /// Comes to voxel `at`.
    #[inline(always)]
    fn come<C: Count>(
        &mut self,
        with: &mut Common<'_, '_, C, L>,
        s: f32,
        at: L::I32,
        stop: f32,
    ) -> Phase {
        (self.s, self.at, self.stop, self.cut) = (s, at, stop, stop);
        self.place = self.local.number(with.lanes, &self.course, at);
        with.sections.fetch_voxel(with.lanes, self.place);
        Phase::Visit
    }

    /// Reads a voxel.
    #[inline(always)]
    pub fn visit<C: Count>(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
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
    pub fn open<C: Count>(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        let (exit, refs) = with.sections.list(self.place);
        self.exit = exit;
        let at = self.place + LIST_HEAD as u32;
        self.triangles = Refs { at, len: refs.len() as u32 };
        self.then = Phase::Advance;
        if refs.last().is_some_and(|r| r & GRID_BIT != 0) {
            let triangles = refs.partition_point(|r| r & GRID_BIT == 0) as u32;
            self.triangles.len = triangles;
            self.grids = Refs { at: at + triangles, len: refs.len() as u32 - triangles };
            self.next_grid(with);
            self.then = Phase::Descend;
        }
        if let Some(first) = refs.first() {
            with.sections.fetch_triangles(with.lanes, *first & !GRID_BIT);
        }
        if self.triangles.len == 0 { self.then } else { Phase::Sieve }
    }

    /// Takes the next grid of the list.
    #[inline(always)]
    fn next_grid<C: Count>(&mut self, with: &mut Common<'_, '_, C, L>) {
        let Refs { at, len } = self.grids;
        self.grid = with.sections.refs(at, 1)[0] & !GRID_BIT;
        self.grids = Refs { at: at + 1, len: len - 1 };
        with.sections.fetch_grid(with.lanes, self.grid);
    }

    /// What follows the triangles that were sieved.
    #[inline(always)]
    fn after(&self) -> Phase {
        let then = if self.triangles.len == 0 { self.then } else { Phase::Sieve };
        if self.left == 0 { then } else { Phase::Decide }
    }

    /// Sieves a few triangles of the list.
    #[inline(always)]
    pub fn sift<C: Count>(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        let Refs { at, len } = self.triangles;
        let few = len.min(L::WIDE as u32);
        with.counters.tests(few as usize);
        let refs = with.sections.refs(at, few);
        self.left = self.sieve.pass(with.lanes, refs);
        self.few = at;
        self.triangles = Refs { at: at + few, len: len - few };
        self.after()
    }

    /// Decides one of them.
    #[inline(always)]
    pub fn decide<C: Count>(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        let number = with.sections.refs(self.few + self.left.trailing_zeros(), 1)[0];
        self.left &= self.left - 1;
        let decided = &mut self.decided[number as usize % DECIDED];
        if *decided != number || C::COUNTS {
            *decided = number;
            let triangle = with.sections.triangle(number);
            if visible(&self.ray, triangle)
                && let Some(enough) = self.query.meet(&Line::new(&self.ray), triangle, number)
            {
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
    fn step<C: Count>(&self, with: &Common<'_, '_, C, L>) -> Step<L> {
        if C::COUNTS {
            self.local.step::<true>(with.lanes, &self.course, self.at, self.exit)
        } else {
            self.local.step::<false>(with.lanes, &self.course, self.at, self.exit)
        }
    }

    /// Leaves the exit box.
    #[inline(always)]
    pub fn advance<C: Count>(&mut self, with: &mut Common<'_, '_, C, L>) -> Phase {
        let Step { out, to } = self.step(with);
        let inside = !with.lanes.any_greater(to, self.local.last);
        let goes_on = (out < self.cut) & inside;
        self.come(with, out, to, self.cut);
        if goes_on { Phase::Visit } else { Phase::Return }
    }

    /// Goes down to a grid, over the part of the ray in the exit box.
    #[inline(always)]
    pub fn descend<C: Count>(
        &mut self,
        with: &mut Common<'_, '_, C, L>,
        frames: &mut [Frame<L>],
    ) -> Phase {
        let Step { out, to } = self.step(with);
        let until = if out < self.stop { out } else { self.stop };
        self.range = [self.local.low(self.s), self.local.high(until)];
        let inside = !with.lanes.any_greater(to, self.local.last);
        let goes_on = (out < self.cut) & inside;
        if (goes_on || self.grids.len > 0)
            && let Some(frame) = frames.get_mut(self.depth)
        {
            *frame = Frame { local: self.local, to, out, grids: self.grids, range: self.range };
            self.depth += 1;
        }
        Phase::Enter
    }

    /// Goes on in the grid above, or in the next one of the list.
    #[inline(always)]
    pub fn climb<C: Count>(
        &mut self,
        with: &mut Common<'_, '_, C, L>,
        frames: &mut [Frame<L>],
    ) -> Phase {
        while let Some(frame) = self.depth.checked_sub(1).and_then(|top| frames.get_mut(top)) {
            if frame.grids.len > 0 {
                (self.grids, self.range) = (frame.grids, frame.range);
                self.next_grid(with);
                frame.grids = self.grids;
                return Phase::Enter;
            }
            self.depth -= 1;
            self.local = frame.local;
            let stop = self.local.stop(self.limit());
            if frame.out < stop && !with.lanes.any_greater(frame.to, self.local.last) {
                return self.come(with, frame.out, frame.to, stop);
            }
        }
        Phase::Done
    }
}
