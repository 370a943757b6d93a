//! Many rays at a time.
//!
//! A ray alone waits: for memory, for its own last result, and after each branch
//! that was not foreseen. So some [`SLOTS`] rays are in flight, and what they do next
//! is sorted: all that need to read a voxel do so one after the other, then all that
//! need to sieve triangles, and so on. Within such a round nothing depends on the
//! ray before, memory was asked for a round earlier, and there is nearly nothing to
//! foresee. A ray that has its answer makes room for the next at once, so lanes never
//! idle, however different the rays are.
//!
//! Answers are those of single rays, bit for bit, as every answer is what `triangle`
//! defines, and the numbers of counted and profiled streams too: each ray takes the
//! same steps.

mod phases;
mod queues;
mod slot;

use super::counters::{Count, Counters, Uncounted, best};
use super::profile::Profile;
use super::query::{Any, Closest, Query, usable};
use crate::arena::View;
use crate::ray::{Hit, Ray};
use crate::simd::{AnyKernel, Isa, Lanes, dispatch, fpenv};
use phases::Common;
use queues::{Phase, Queues, SLOTS};
use slot::{Frame, Slot};

/// Grids above their own in which all rays in flight can be together.
const FRAMES: usize = 2 * SLOTS;

/// Rays that are sooner answered one by one.
const FEW: usize = 8;

/// Where rays come from and answers go.
pub(crate) trait Port<Out> {
    /// Ray `i`; asked for once.
    fn ray(&mut self, i: usize) -> Ray;
    /// Takes the answer to ray `i`.
    fn put(&mut self, i: usize, answer: Out);
}

/// The frames of a slot.
#[inline(always)]
fn frames<C: Count, L: Lanes>(
    frames: &mut [Frame<C, L>; FRAMES],
    depth: usize,
    slot: usize,
) -> &mut [Frame<C, L>] {
    frames.get_mut(slot * depth..(slot + 1) * depth).unwrap_or_default()
}

struct Stream<'a, 'p, Q: Query, C: Count, L: Lanes> {
    view: &'a View<'a>,
    with: Common<'a, 'p, C, L>,
    port: &'p mut dyn Port<Q::Out>,
    /// The next ray of the stream, and their number.
    next: usize,
    n: usize,
    flying: usize,
    queues: Queues,
    slots: &'p mut [Slot<'a, Q, C, L>; SLOTS],
    frames: &'p mut [Frame<C, L>; FRAMES],
    /// Frames of each slot.
    depth: usize,
}

/// Takes all that wait for a phase through it. A closure would not be compiled for the
/// instruction set.
macro_rules! turn {
    ($stream:ident, $phase:ident, $method:ident $(, $frames:ident)?) => {
        for i in 0..$stream.queues.take(Phase::$phase) {
            let slot = $stream.queues.taken(Phase::$phase, i);
            let phase = $stream.slots[slot].$method(&mut $stream.with $(, frames($stream.$frames, $stream.depth, slot))?);
            $stream.queues.push(phase, slot);
        }
    };
}

impl<'a, 'p, Q: Query, C: Count, L: Lanes> Stream<'a, 'p, Q, C, L> {
    /// Puts the next ray in a slot, if there is one left.
    #[inline(always)]
    fn load(&mut self, slot: usize) {
        while self.next < self.n {
            let index = self.next;
            self.next += 1;
            let ray = self.port.ray(index);
            if usable(self.with.lanes, &ray) {
                self.slots[slot] = Slot::new(self.with.lanes, self.view, ray, index);
                self.queues.push(Phase::Enter, slot);
                return;
            }
            self.port.put(index, Q::miss(&ray));
        }
        self.flying -= 1;
    }

    #[inline(always)]
    fn run(&mut self) {
        for i in 0..self.queues.take(Phase::Done) {
            self.load(self.queues.taken(Phase::Done, i));
        }
        while self.flying > 0 {
            turn!(self, Enter, enter);
            turn!(self, Visit, visit);
            turn!(self, Open, open);
            turn!(self, Look, look);
            turn!(self, Sieve, sift);
            turn!(self, Decide, decide);
            turn!(self, Descend, descend, frames);
            turn!(self, Advance, advance);
            turn!(self, Return, climb, frames);
            for i in 0..self.queues.take(Phase::Done) {
                let slot = self.queues.taken(Phase::Done, i);
                let Slot { index, ref query, ref ray, .. } = self.slots[slot];
                self.port.put(index, query.found(&self.with.sections, ray));
                self.load(slot);
            }
        }
    }
}

struct Run<'a, 'p, Q: Query, C> {
    view: &'a View<'a>,
    port: &'p mut dyn Port<Q::Out>,
    n: usize,
    counters: &'p mut C,
}

impl<Q: Query, C: Count> AnyKernel for Run<'_, '_, Q, C> {
    type Out = ();
    const BEST: Isa = best::<C>();
    #[inline(always)]
    fn run_on<L: Lanes>(self, lanes: L) {
        let Self { view, port, n, counters } = self;
        let depth = (view.header().levels as usize).saturating_sub(1);
        let flying = (FRAMES / depth.max(1)).min(SLOTS);
        let mut queues = Queues::EMPTY;
        for slot in 0..flying {
            queues.push(Phase::Done, slot);
        }
        let idle = Slot::<Q, C, L>::new(lanes, view, Ray::new([0.0; 3], [0.0, 0.0, 1.0]), 0);
        Stream {
            view,
            with: Common { lanes, sections: view.sections(), counters },
            port,
            next: 0,
            n,
            flying,
            queues,
            // Here and not in a function, which might copy them.
            slots: &mut [idle; SLOTS],
            frames: &mut [Frame::unused(lanes); FRAMES],
            depth,
        }
        .run();
    }
}

/// Rays and answers in slices.
struct Slices<'s, Out> {
    rays: &'s [Ray],
    answers: &'s mut [Out],
}

impl<Out> Port<Out> for Slices<'_, Out> {
    fn ray(&mut self, i: usize) -> Ray {
        self.rays[i]
    }

    fn put(&mut self, i: usize, answer: Out) {
        self.answers[i] = answer;
    }
}

impl View<'_> {
    /// The closest hits of rays, one each: those of [`View::intersect`], bit for bit. Rays
    /// that go all ways take less time so than one by one; rays that are alike, in a scene
    /// that the caches hold, take more. If there are more rays than hits, or the
    /// reverse, the rest is left alone. Takes about 100 kB of stack.
    pub fn intersect_n(&self, rays: &[Ray], hits: &mut [Hit]) {
        let n = rays.len().min(hits.len());
        self.intersect_port(&mut Slices { rays, answers: hits }, n, &mut Uncounted);
    }

    /// Whether rays hit anything, one answer each, as [`View::intersect_n`].
    pub fn occluded_n(&self, rays: &[Ray], occluded: &mut [bool]) {
        let n = rays.len().min(occluded.len());
        self.occluded_port(&mut Slices { rays, answers: occluded }, n, &mut Uncounted);
    }

    /// [`View::intersect_n`], adding what it did to `counters`: the sum of what
    /// [`View::intersect_counted`] counts.
    pub fn intersect_n_counted(&self, rays: &[Ray], hits: &mut [Hit], counters: &mut Counters) {
        let n = rays.len().min(hits.len());
        self.intersect_port(&mut Slices { rays, answers: hits }, n, counters);
    }

    /// [`View::occluded_n`], adding what it did to `counters`.
    pub fn occluded_n_counted(&self, rays: &[Ray], occluded: &mut [bool], counters: &mut Counters) {
        let n = rays.len().min(occluded.len());
        self.occluded_port(&mut Slices { rays, answers: occluded }, n, counters);
    }

    /// [`View::intersect_n`], adding what it did on each level to `profile`: the sum of
    /// what [`View::intersect_profiled`] counts.
    pub fn intersect_n_profiled(&self, rays: &[Ray], hits: &mut [Hit], profile: &mut Profile) {
        let n = rays.len().min(hits.len());
        self.intersect_port(&mut Slices { rays, answers: hits }, n, profile);
    }

    /// [`View::occluded_n`], adding what it did on each level to `profile`.
    pub fn occluded_n_profiled(&self, rays: &[Ray], occluded: &mut [bool], profile: &mut Profile) {
        let n = rays.len().min(occluded.len());
        self.occluded_port(&mut Slices { rays, answers: occluded }, n, profile);
    }

    pub(crate) fn intersect_port<C: Count>(
        &self,
        port: &mut dyn Port<Hit>,
        n: usize,
        counters: &mut C,
    ) {
        self.stream::<Closest, C>(port, n, counters);
    }

    pub(crate) fn occluded_port<C: Count>(
        &self,
        port: &mut dyn Port<bool>,
        n: usize,
        counters: &mut C,
    ) {
        self.stream::<Any, C>(port, n, counters);
    }

    fn stream<Q: Query, C: Count>(&self, port: &mut dyn Port<Q::Out>, n: usize, counters: &mut C) {
        fpenv::with_default(|| {
            if self.header().grids.count > 0 && n >= FEW {
                dispatch(Run::<Q, C> { view: self, port, n, counters });
            } else {
                for i in 0..n {
                    let answer = self.single::<Q, C>(&port.ray(i), counters);
                    port.put(i, answer);
                }
            }
        });
    }
}
