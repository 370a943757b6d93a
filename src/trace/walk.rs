//! The walk: front to back through a grid's voxels, and through the grids that
//! they point to.
//!
//! A step leaves not the voxel but its exit box (`build::exit`), so that what
//! holds nothing new is crossed at once; where boxes are single voxels this is
//! the plain 3-D DDA. The next voxel is looked up by position, on the axis of
//! the exit by count, so each step strictly advances. A grid below is walked only
//! over the part of the ray inside the block that points to it: a grid in many
//! voxels costs its own steps and one entry per voxel, the order stays front to
//! back, and no list of visited grids is needed. Recursion is as deep as the
//! levels, at most 16.

#[cfg(feature = "replay")]
pub mod replay;

use super::bounds::{BATCH, Few, Part};
use super::counters::Count;
use super::course::Course;
use super::decided::Decided;
use super::local::{Boxes, Local, Span};
use super::query::{Query, beyond, decide};
use super::sieve::{Sieve, chunk, holds};
use crate::arena::layout::{EMPTY, GRID_BIT, LIST, PAYLOAD, TAG_SHIFT};
use crate::arena::{Sections, View};
use crate::ray::Ray;
use crate::simd::{Kernel, Lanes};

/// References up to which a list is sieved as it is: for a ray alone, looking at boxes
/// first takes longer.
const SHORT: usize = 16;

/// What came of a voxel.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Met {
    /// Nothing that the query did not know.
    Nothing,
    /// Perhaps a hit: the query's limit may be another.
    Something,
    /// All that the query wants.
    Enough,
}

/// A query on its way.
pub(crate) struct Walk<'a, Q, C, L: Lanes> {
    lanes: L,
    sections: Sections<'a>,
    ray: &'a Ray,
    sieve: Sieve<'a>,
    course: Course<L>,
    decided: Decided,
    pub query: Q,
    counters: &'a mut C,
}

/// [`Walk::grid`], compiled for the walk's instruction set.
struct Enter<'w, 'a, Q, C, L: Lanes> {
    walk: &'w mut Walk<'a, Q, C, L>,
    number: u32,
    t0: f64,
    t1: f64,
}

impl<Q: Query, C: Count, L: Lanes> Kernel<L> for Enter<'_, '_, Q, C, L> {
    type Out = bool;
    #[inline(always)]
    fn run(self, _: L) -> bool {
        self.walk.grid(self.number, self.t0, self.t1)
    }
}

/// [`Walk::long`], likewise.
struct Long<'w, 'a, Q, C, L: Lanes> {
    walk: &'w mut Walk<'a, Q, C, L>,
    place: u32,
    boxes: &'w Boxes,
    taus: [f64; 2],
}

impl<Q: Query, C: Count, L: Lanes> Kernel<L> for Long<'_, '_, Q, C, L> {
    type Out = Met;
    #[inline(always)]
    fn run(self, _: L) -> Met {
        self.walk.long(self.place, self.boxes, self.taus)
    }
}

impl<'a, Q: Query, C: Count, L: Lanes> Walk<'a, Q, C, L> {
    /// A walk for a ray that is known to be usable.
    #[inline(always)]
    pub fn new(l: L, view: &View<'a>, ray: &'a Ray, query: Q, counters: &'a mut C) -> Self {
        let [org, dir, _] = ray.rows();
        let (org, dir) = (l.load3(org), l.load3(dir));
        let [lo, hi] = view.header().corners();
        let holds = holds(l, org, [l.load_f32(lo), l.load_f32(hi)]);
        let sections = view.sections();
        Self {
            lanes: l,
            sections,
            ray,
            sieve: Sieve::new(l, &sections, ray, [org, dir], holds),
            course: Course::new(l, org, dir, view.header().unit),
            decided: Decided::NONE,
            query,
            counters,
        }
    }

    /// Walks the scene from its outermost grid. What is counted is the paper's walk,
    /// without a look at `occluders` first.
    #[inline(always)]
    pub fn run(&mut self, occluders: &[u32]) {
        if Q::ANY && !C::COUNTS && self.triangles(occluders) == Met::Enough {
            return;
        }
        // A t that rounds to tmin may lie below it, one that rounds to tmax above.
        let t0 = -beyond(-self.ray.tmin) * self.course.per_t;
        let t1 = beyond(self.ray.tmax) * self.course.per_t;
        self.grid(0, t0, t1);
    }

    /// Where it stops in a grid, all hits considered.
    #[inline(always)]
    fn stop(&self, span: &Span) -> f32 {
        span.stop(self.query.limit(), self.course.per_t)
    }

    /// Walks a grid where the ray's parameter tau is in `[t0, t1]`; `true` if the
    /// query wants no more.
    #[inline(always)]
    fn grid(&mut self, number: u32, t0: f64, t1: f64) -> bool {
        self.counters.level(C::of(self.sections.grid(number).level));
        self.counters.grid();
        if C::KEEPS {
            self.counters.keep_grid(number, [t0, t1]);
        }
        if self.counters.spent() {
            return true;
        }
        let l = self.lanes;
        let grid = self.sections.grid(number);
        let Some(local) = Local::enter(l, &self.sections, number, &self.course, self.ray, [t0, t1])
        else {
            return false;
        };
        let mut at = local.at;
        let mut s = 0.0;
        let mut stop = self.stop(&local.span);
        loop {
            let voxel = self.sections.voxel(local.number(l, at) as usize);
            self.counters.voxel();
            if self.counters.spent() {
                return true;
            }
            let (tag, payload) = (voxel >> TAG_SHIFT, voxel & PAYLOAD);
            let step = if tag == EMPTY {
                // The tag's bits are beyond those of the exit box, and 0.
                local.step::<C>(l, at, voxel)
            } else {
                let (exit, refs) =
                    if tag == LIST { self.sections.list(payload) } else { (0, &[][..]) };
                let step = local.step::<C>(l, at, exit);
                if C::KEEPS && tag == LIST {
                    let until = if step.out < stop { step.out } else { stop };
                    self.counters.keep_list(payload, l.array(at), [s, until]);
                }
                let short = refs.len() <= SHORT && refs.last().is_none_or(|r| r & GRID_BIT == 0);
                let met = if tag == LIST && short {
                    self.triangles(refs)
                } else {
                    let until = if step.out < stop { step.out } else { stop };
                    let taus = [local.span.low(s), local.span.high(until)];
                    let met = if tag == LIST {
                        let boxes = local.boxes(l, at, exit, [s, until]);
                        self.long_apart(payload, &boxes, taus)
                    } else {
                        self.below(payload, taus)
                    };
                    self.counters.level(C::of(grid.level));
                    met
                };
                match met {
                    Met::Nothing => {}
                    Met::Something => stop = self.stop(&local.span),
                    Met::Enough => return true,
                }
                step
            };
            // No NaN passes this.
            let goes_on = step.out < stop;
            if !goes_on {
                return false;
            }
            s = step.out;
            at = step.to;
            if l.any_greater(at, local.last) {
                return false;
            }
        }
    }

    /// [`Walk::long`], so that the walk's registers are not spilled elsewhere.
    #[cold]
    fn long_apart(&mut self, place: u32, boxes: &Boxes, taus: [f64; 2]) -> Met {
        self.lanes.run(Long { walk: self, place, boxes, taus })
    }

    /// Meets what a list refers to that is long, or that refers to grids, by its boxes;
    /// the ray is in its exit box for tau in `taus`.
    #[inline(always)]
    fn long(&mut self, place: u32, boxes: &Boxes, taus: [f64; 2]) -> Met {
        let (l, sections) = (self.lanes, self.sections);
        let len = sections.head(place).1;
        let mut met = Met::Nothing;
        let mut few = Few::NONE;
        let mut at = 0;
        while at < len && met != Met::Enough {
            let part = Part::new(place, len, at);
            few.fill::<C, L>(l, &sections, part, boxes);
            let (triangles, grids) = few.split();
            met = met.max(self.triangles(triangles));
            for r in grids {
                if met != Met::Enough {
                    met = met.max(self.below(r & !GRID_BIT, taus));
                }
            }
            at += BATCH as u32;
        }
        met
    }

    #[cold]
    fn below(&mut self, number: u32, [t0, t1]: [f64; 2]) -> Met {
        if self.lanes.run(Enter { walk: self, number, t0, t1 }) {
            Met::Enough
        } else {
            Met::Something
        }
    }

    #[inline(always)]
    fn triangles(&mut self, refs: &[u32]) -> Met {
        let mut met = Met::Nothing;
        for few in refs.chunks(chunk::<C, L>()) {
            if C::LOOKS {
                few.iter().for_each(|&r| self.counters.look(self.ray, self.sections.triangle(r)));
            }
            self.counters.tests(few.len());
            if self.counters.spent() {
                return Met::Enough;
            }
            let mut left;
            if Q::ANY && !C::COUNTS && few.len() > 1 {
                let (sections, sieved) = (self.sections, self.sieve.few(self.lanes, few));
                left = sieved.0;
                let triangle = |i: usize| sections.triangle(few[i]);
                if self.sieve.hits(self.lanes, self.ray, &sieved.1, left, triangle) {
                    self.query.take_any();
                    return Met::Enough;
                }
            } else {
                left = self.sieve.pass(self.lanes, few);
            }
            while left != 0 {
                let number = few[left.trailing_zeros() as usize];
                left &= left - 1;
                if self.decided.is_due::<C>(number) {
                    if self.decide(number) {
                        return Met::Enough;
                    }
                    met = Met::Something;
                }
            }
        }
        met
    }

    /// The exact test of what the sieve let through.
    #[inline(always)]
    fn decide(&mut self, number: u32) -> bool {
        let triangle = self.sections.triangle(number);
        let Some(enough) = decide(self.lanes, &mut self.query, self.ray, triangle, number) else {
            return false;
        };
        self.counters.hit();
        self.sieve.limit(self.lanes, self.query.limit());
        enough
    }
}
