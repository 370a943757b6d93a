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

use super::counters::Count;
use super::course::Course;
use super::local::Local;
use super::query::{Query, beyond, visible};
use super::sieve::Sieve;
use crate::arena::layout::{EMPTY, EXIT_MAX, GRID_BIT, LIST, PAYLOAD, TAG_SHIFT};
use crate::arena::{Sections, View};
use crate::ray::{NONE, Ray};
use crate::simd::{Kernel, Lanes};
use crate::triangle::Line;

/// Entries of [`Walk::decided`].
const DECIDED: usize = 8;

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
    sieve: Sieve<'a, L>,
    course: Course<'a, L>,
    /// Triangles that were decided lately, by the low bits of their numbers: what is
    /// in many voxels is decided once.
    decided: [u32; DECIDED],
    pub query: Q,
    counters: &'a mut C,
}

/// A step: where the ray leaves, and the voxel there.
struct Step<L: Lanes> {
    out: f32,
    to: L::I32,
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

/// [`Walk::decide`], likewise.
struct Decide<'w, 'a, Q, C, L: Lanes> {
    walk: &'w mut Walk<'a, Q, C, L>,
    number: u32,
}

impl<Q: Query, C: Count, L: Lanes> Kernel<L> for Decide<'_, '_, Q, C, L> {
    type Out = bool;
    #[inline(always)]
    fn run(self, _: L) -> bool {
        self.walk.decide(self.number)
    }
}

impl<'a, Q: Query, C: Count, L: Lanes> Walk<'a, Q, C, L> {
    /// A walk for a ray that is known to be usable.
    #[inline(always)]
    pub fn new(l: L, view: &View<'a>, ray: &'a Ray, query: Q, counters: &'a mut C) -> Self {
        let [org, dir, _] = ray.rows();
        let (org, dir) = (l.load3(org), l.load3(dir));
        let [lo, hi] = view.header().corners();
        let sections = view.sections();
        Self {
            lanes: l,
            sections,
            ray,
            sieve: Sieve::new(l, &sections, ray, [org, dir], [l.load_f32(lo), l.load_f32(hi)]),
            course: Course::new(l, org, dir, ray, view.header().unit),
            decided: [NONE; DECIDED],
            query,
            counters,
        }
    }

    /// Walks the scene from its outermost grid.
    #[inline(always)]
    pub fn run(&mut self) {
        // A t that rounds to tmin may lie below it, one that rounds to tmax above.
        let t0 = -beyond(-self.ray.tmin) * self.course.per_t;
        let t1 = beyond(self.ray.tmax) * self.course.per_t;
        self.grid(0, t0, t1);
    }

    fn limit(&self) -> f64 {
        self.query.beyond() * self.course.per_t
    }

    /// Walks a grid where the ray's parameter tau is in `[t0, t1]`; `true` if the
    /// query wants no more.
    #[inline(always)]
    fn grid(&mut self, number: u32, t0: f64, t1: f64) -> bool {
        self.counters.level(self.sections.grid(number).level);
        self.counters.grid();
        let l = self.lanes;
        let grid = self.sections.grid(number);
        let Some(local) = Local::enter(l, grid, &self.course, t0, t1) else {
            return false;
        };
        let mut at = local.at;
        let mut s = 0.0;
        let mut stop = local.stop(self.limit());
        loop {
            let voxel = self.sections.voxel(local.number(l, &self.course, at) as usize);
            self.counters.voxel();
            let (tag, payload) = (voxel >> TAG_SHIFT, voxel & PAYLOAD);
            let step = if tag == EMPTY {
                // The tag's bits are beyond those of the exit box, and 0.
                self.step(&local, at, voxel)
            } else {
                let (exit, refs) =
                    if tag == LIST { self.sections.list(payload) } else { (0, &[][..]) };
                let step = self.step(&local, at, exit);
                let met = if tag == LIST && refs.last().is_none_or(|r| r & GRID_BIT == 0) {
                    self.triangles(refs)
                } else {
                    let until = if step.out < stop { step.out } else { stop };
                    let met = self.mixed(tag, payload, refs, local.low(s), local.high(until));
                    self.counters.level(grid.level);
                    met
                };
                match met {
                    Met::Nothing => {}
                    Met::Something => stop = local.stop(self.limit()),
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

    /// Leaves the exit box `exit` of voxel `at`.
    #[inline(always)]
    fn step(&self, local: &Local<L>, at: L::I32, exit: u32) -> Step<L> {
        let l = self.lanes;
        let most = l.splat_i32(EXIT_MAX as i32);
        let reach = l.and(l.shift_right(l.splat_i32(exit as i32), self.course.shift), most);
        // The planes behind the box, and where the ray is at the first of them.
        let behind = l.add(l.add(at, l.splat_i32(1)), reach);
        let leave = Self::mul_add(l, l.to_f32(behind), local.pace, local.zero);
        let lowest = l.lowest(leave);
        // Off the axis of the exit the position says where, inside the box.
        let exits = l.equal(leave, lowest);
        let low = l.select(exits, at, behind);
        let high = l.sub(l.sub(behind, l.splat_i32(1)), exits);
        let position = l.truncate(Self::mul_add(l, lowest, local.speed, local.start));
        Step { out: l.first(lowest), to: l.min(l.max(position, low), high) }
    }

    /// Rounded once wherever steps are counted, so that their number depends on
    /// no instruction set.
    #[inline(always)]
    fn mul_add(l: L, a: L::F32, b: L::F32, c: L::F32) -> L::F32 {
        if C::COUNTS { l.mul_add::<true>(a, b, c) } else { l.mul_add::<false>(a, b, c) }
    }

    /// Meets what a voxel that refers to grids refers to; the ray is in its exit
    /// box for tau in `[t0, t1]`.
    #[inline(always)]
    fn mixed(&mut self, tag: u32, payload: u32, refs: &[u32], t0: f64, t1: f64) -> Met {
        if tag != LIST {
            return self.below(payload, t0, t1);
        }
        let triangles = refs.partition_point(|r| r & GRID_BIT == 0);
        let mut met = self.triangles(&refs[..triangles]);
        for r in &refs[triangles..] {
            if met == Met::Enough {
                break;
            }
            met = met.max(self.below(r & !GRID_BIT, t0, t1));
        }
        met
    }

    #[cold]
    fn below(&mut self, number: u32, t0: f64, t1: f64) -> Met {
        if self.lanes.run(Enter { walk: self, number, t0, t1 }) {
            Met::Enough
        } else {
            Met::Something
        }
    }

    #[inline(always)]
    fn triangles(&mut self, refs: &[u32]) -> Met {
        let mut met = Met::Nothing;
        for few in refs.chunks(L::WIDE) {
            if C::LOOKS {
                few.iter().for_each(|&r| self.counters.look(self.ray, self.sections.triangle(r)));
            }
            self.counters.tests(few.len());
            let mut left = self.sieve.pass(few);
            while left != 0 {
                let number = few[left.trailing_zeros() as usize];
                left &= left - 1;
                let decided = &mut self.decided[number as usize % DECIDED];
                if *decided != number || C::COUNTS {
                    *decided = number;
                    if self.decide_apart(number) {
                        return Met::Enough;
                    }
                    met = Met::Something;
                }
            }
        }
        met
    }

    /// [`Walk::decide`]; cold, so that the walk's registers are not spilled where
    /// there is nothing to decide.
    #[cold]
    fn decide_apart(&mut self, number: u32) -> bool {
        self.lanes.run(Decide { walk: self, number })
    }

    /// The exact test of what the sieve let through.
    #[inline(always)]
    fn decide(&mut self, number: u32) -> bool {
        let triangle = self.sections.triangle(number);
        if !visible(self.ray, triangle) {
            return false;
        }
        let Some(enough) = self.query.meet(&Line::new(self.ray), triangle, number) else {
            return false;
        };
        self.counters.hit();
        self.sieve.limit(self.query.limit());
        enough
    }
}
