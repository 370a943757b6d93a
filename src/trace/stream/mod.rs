//! Many rays at a time.
//!
//! A ray alone waits: for memory, for its own last result, and after each branch
//! that was not foreseen. So some [`SLOTS`](columns::SLOTS) rays are in flight, and all do
//! the same at the same time (`round`): lanes are rays where they step (`columns`),
//! boxes where a ray looks at a list (`meet`), and pairs of any ray and any triangle
//! where triangles are sieved (`pairs`). A ray that has its answer makes room for the next at once
//! (`ways`), so that few lanes idle, however different the rays are. Rays that are much the
//! same go together instead (`super::packet`), and in a scene with a tree of boxes those that are
//! not go down that, in flocks (`super::flock`).
//!
//! Answers are those of single rays, bit for bit, as every answer is what `triangle`
//! defines (in an arena that a build wrote: what a forged one says may depend on the ray's
//! neighbours). What is counted is the paper's walk of each ray, so streams that count
//! take one ray at a time.

mod columns;
mod flight;
mod meet;
mod pairs;
mod recent;
mod round;
mod ways;

use core::ops::Range;

use super::counters::{Count, Counters, Uncounted};
use super::course::Course;
use super::flock::{self, Flock};
use super::packet::{self, Together};
use super::profile::Profile;
use super::query::{Any, Closest, Query};
use super::sieve::Sieve;
use crate::arena::View;
use crate::ray::{Hit, Ray};
use crate::simd::{AnyKernel, Isa, Lanes, dispatch, fpenv};
use columns::{Columns, SLOTS};
use flight::{Flight, Frame};
use pairs::Pairs;
use recent::Recent;
use round::{Lists, Rounds, Sets};

/// Grids above their own in which all rays in flight can be together.
const FRAMES: usize = 4 * SLOTS;

/// Rays that go apart after some that are no packet, or one that was not worth it, at first;
/// then twice as many each time, up to one of these.
const APART: usize = 64;
const MOST: usize = 1 << 15;
const MOST_ALIKE: usize = 1 << 10;

/// The same of rays that are no packet, where they go in flocks.
const FLOCKS: usize = 1 << 11;

/// Rays that are sooner answered one by one.
const FEW: usize = 12;

/// Where rays come from and answers go.
pub(crate) trait Port<Out> {
    /// Writes ray `i`: perhaps more than once, but not after it was answered.
    fn ray(&mut self, i: usize, to: &mut Ray);
    /// Takes the answer to ray `i`.
    fn put(&mut self, i: usize, answer: Out);
}

struct Run<'a, 'p, Q: Query> {
    view: &'a View<'a>,
    port: &'p mut dyn Port<Q::Out>,
    n: usize,
}

/// Rays of a stream that go as they are, some dozens in flight.
struct Apart<'a, 'p, Q: Query> {
    view: &'a View<'a>,
    port: &'p mut dyn Port<Q::Out>,
    first: usize,
    end: usize,
}

impl<Q: Query> AnyKernel for Run<'_, '_, Q> {
    type Out = ();
    // Packets are no quicker with AVX-512.
    const BEST: Isa = Isa::Avx2;
    #[inline(always)]
    fn run_on<L: Lanes>(self, lanes: L) {
        let Self { view, port, n } = self;
        let together = !Q::ANY && packet::suits(view);
        let down = view.header().nodes.count > 0;
        let in_flocks = down && view.header().quantized == 0 && flock::suits::<L>();
        let (mut next, mut apart) = (0, APART);
        while next < n {
            let mut end = n;
            if together {
                let progress =
                    lanes.run_in_function(Together::<Q> { view, port: &mut *port, next, n });
                if progress.worth {
                    apart = APART;
                }
                next = progress.next;
                end = n.min(next + apart);
                if in_flocks && !progress.alike {
                    apart = apart.max(FLOCKS);
                    end = n.min(next + apart);
                }
                let most = if progress.alike { MOST_ALIKE } else { MOST };
                apart = most.min(2 * apart);
            }
            if next < end && down {
                if in_flocks && end - next >= flock::LEAST {
                    run_in_own_frame(Flock::<Q> { view, port: &mut *port, rays: next..end });
                } else {
                    view.one_by_one::<Q, _>(port, next..end, &mut Uncounted);
                }
            } else if next < end {
                run_in_own_frame(Apart::<Q> { view, port: &mut *port, first: next, end });
            }
            next = end;
        }
    }

    // On processors that nearly always have a better set, a stream without it need not be
    // fast, and its kernels would be a twelfth of the library.
    #[cfg(any(target_arch = "x86_64", all(target_arch = "aarch64", target_feature = "neon")))]
    fn run_portable(self) {
        self.view.one_by_one::<Q, _>(self.port, 0..self.n, &mut Uncounted);
    }
}

/// Not inlined, so that rays of one kind do not need the memory of those of another as well.
#[inline(never)]
fn run_in_own_frame<K: AnyKernel>(kernel: K) -> K::Out {
    dispatch(kernel)
}

impl<Q: Query> AnyKernel for Apart<'_, '_, Q> {
    type Out = ();
    // With AVX-512 as well it would be a fiftieth of the library, for what no stream in a tree needs.
    const BEST: Isa = Isa::Avx2;
    #[inline(always)]
    fn run_on<L: Lanes>(self, lanes: L) {
        let Self { view, port, first, end } = self;
        let depth = (view.header().levels as usize).saturating_sub(1);
        let nowhere = Ray::new([0.0; 3], [0.0, 0.0, 1.0]);
        let [org, dir, _] = nowhere.rows();
        let rows = [lanes.load3(org), lanes.load3(dir)];
        let course = Course::new(lanes, rows[0], rows[1], 1.0);
        let sections = view.sections();
        let (mut columns, mut lists) = (Columns::NONE, Lists::NONE);
        let (mut pairs, mut due, mut recent) = (Pairs::NONE, Pairs::NONE, Recent::NONE);
        Rounds {
            lanes,
            view,
            sections,
            port,
            next: first,
            n: end,
            columns: &mut columns,
            flights: &mut [Flight::<Q, L>::new(nowhere, 0, course); SLOTS],
            sieves: &mut [Sieve::new(lanes, &sections, &nowhere, rows, true); SLOTS],
            frames: &mut [Frame::NONE; FRAMES],
            depth,
            lists: &mut lists,
            pairs: &mut pairs,
            due: &mut due,
            sets: Sets::default(),
            recent: &mut recent,
        }
        .run(FRAMES / depth.max(1));
    }

    // As of streams themselves.
    #[cfg(any(target_arch = "x86_64", all(target_arch = "aarch64", target_feature = "neon")))]
    fn run_portable(self) {
        self.view.one_by_one::<Q, _>(self.port, self.first..self.end, &mut Uncounted);
    }
}

/// Rays and answers in slices.
pub(crate) struct Slices<'s, Out> {
    pub rays: &'s [Ray],
    pub answers: &'s mut [Out],
}

impl<Out> Port<Out> for Slices<'_, Out> {
    fn ray(&mut self, i: usize, to: &mut Ray) {
        *to = self.rays[i];
    }

    fn put(&mut self, i: usize, answer: Out) {
        self.answers[i] = answer;
    }
}

impl View<'_> {
    /// The closest hits of rays, one each: those of [`View::intersect`], bit for bit. Where 64
    /// rays in a row come from one point and go much the same way, as tiles of 8 by 8 pixels
    /// of a camera do, they go together, and take a third of the time of single rays, or less.
    /// 256 or more others in a scene with a tree of boxes
    /// ([`Options::tree`](crate::Options::tree)) go down that together and take 0.7 to 1 of that
    /// time; in one without, some dozens or more take about half of it. If there are more rays
    /// than hits, or the reverse, the rest is left alone. Takes up to 48 kB of stack, of 256 rays
    /// or more 256 kB.
    pub fn intersect_n(&self, rays: &[Ray], hits: &mut [Hit]) {
        let n = rays.len().min(hits.len());
        self.intersect_port(&mut Slices { rays, answers: hits }, n, &mut Uncounted);
    }

    /// Whether rays hit anything, one answer each, as [`View::intersect_n`].
    pub fn occluded_n(&self, rays: &[Ray], occluded: &mut [bool]) {
        let n = rays.len().min(occluded.len());
        self.occluded_port(&mut Slices { rays, answers: occluded }, n, &mut Uncounted);
    }

    /// [`View::intersect_n`], adding what [`View::intersect_counted`] counts for each ray to
    /// `counters`; it takes one ray at a time.
    pub fn intersect_n_counted(&self, rays: &[Ray], hits: &mut [Hit], counters: &mut Counters) {
        let n = rays.len().min(hits.len());
        self.intersect_port(&mut Slices { rays, answers: hits }, n, counters);
    }

    /// [`View::occluded_n`], counting likewise.
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
            if self.header().grids.count > 0 && n >= FEW && !C::COUNTS {
                dispatch(Run::<Q> { view: self, port, n });
            } else {
                self.one_by_one::<Q, C>(port, 0..n, counters);
            }
        });
    }

    /// Answers a ray that is not for those that go together.
    #[cold]
    pub(super) fn alone<Q: Query>(&self, port: &mut dyn Port<Q::Out>, i: usize) {
        self.one_by_one::<Q, _>(port, i..i + 1, &mut Uncounted);
    }

    /// Not inlined, as several kinds of streams come to it.
    #[inline(never)]
    pub(super) fn one_by_one<Q: Query, C: Count>(
        &self,
        port: &mut dyn Port<Q::Out>,
        rays: Range<usize>,
        counters: &mut C,
    ) {
        let mut ray = Ray::new([0.0; 3], [0.0; 3]);
        for i in rays {
            port.ray(i, &mut ray);
            let answer = self.single::<Q, C>(&ray, counters);
            port.put(i, answer);
        }
    }
}
