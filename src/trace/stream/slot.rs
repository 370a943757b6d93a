//! A ray in flight, and where it goes on in the grids above its own.

use super::super::bounds::Few;
use super::super::counters::Count;
use super::super::course::Course;
use super::super::decided::Decided;
use super::super::local::{Boxes, Local};
use super::super::query::{Query, beyond};
use super::super::sieve::Sieve;
use super::queues::Phase;
use crate::arena::View;
use crate::ray::Ray;
use crate::simd::Lanes;

/// Some of a list's references: their numbers in it.
#[derive(Clone, Copy, Default)]
pub(super) struct Refs {
    pub at: u32,
    pub end: u32,
}

impl Refs {
    pub fn is_empty(self) -> bool {
        self.at >= self.end
    }
}

/// A ray on its way.
#[derive(Clone, Copy)]
pub(super) struct Slot<'a, Q, C: Count, L: Lanes> {
    pub ray: Ray,
    /// Its place in the stream.
    pub index: usize,
    pub query: Q,
    pub course: Course<L>,
    pub sieve: Sieve<'a>,
    pub decided: Decided,
    /// The grid to enter, and the range of tau to walk there.
    pub grid: u32,
    pub range: [f64; 2],
    /// The level of the grid it is in, as counters keep it.
    pub level: C::Level,
    /// The grid it is in, its voxel there, since when it is in that, and where it
    /// stopped in the grid when it came to the voxel.
    pub local: Local<L>,
    pub at: L::I32,
    pub s: f32,
    pub stop: f32,
    /// Where it stops in the grid, all hits considered.
    pub cut: f32,
    /// The number of its voxel, then where the voxel's list is, and how long.
    pub place: u32,
    pub len: u32,
    /// The exit box of its voxel, and the boxes in it.
    pub exit: u32,
    pub boxes: Boxes,
    /// The triangles of the list whose boxes are still to be looked at.
    pub triangles: Refs,
    /// Those whose boxes it met, how many of them were sieved, and a bit for each of the
    /// last of these that is still to be decided.
    pub few: Few,
    pub sieved: u32,
    pub left: u32,
    /// The grids of the list that are still to be entered.
    pub grids: Refs,
    /// What follows the triangles.
    pub then: Phase,
    /// Number of frames in use.
    pub depth: usize,
}

impl<'a, Q: Query, C: Count, L: Lanes> Slot<'a, Q, C, L> {
    /// A ray that is known to be usable, before the outermost grid.
    #[inline(always)]
    pub fn new(l: L, view: &View<'a>, ray: Ray, index: usize) -> Self {
        let [org, dir, _] = ray.rows();
        let (org, dir) = (l.load3(org), l.load3(dir));
        let [lo, hi] = view.header().corners();
        let course = Course::new(l, org, dir, view.header().unit);
        Self {
            ray,
            index,
            query: Q::new(&ray),
            course,
            sieve: Sieve::new(
                l,
                &view.sections(),
                &ray,
                [org, dir],
                [l.load_f32(lo), l.load_f32(hi)],
            ),
            decided: Decided::NONE,
            grid: 0,
            // A t that rounds to tmin may lie below it, one that rounds to tmax above.
            range: [-beyond(-ray.tmin) * course.per_t, beyond(ray.tmax) * course.per_t],
            level: C::Level::default(),
            local: Local::nowhere(l),
            at: l.splat_i32(0),
            s: 0.0,
            stop: 0.0,
            cut: 0.0,
            place: 0,
            len: 0,
            exit: 0,
            boxes: Boxes::nowhere(course.mirror),
            triangles: Refs::default(),
            few: Few::NONE,
            sieved: 0,
            left: 0,
            grids: Refs::default(),
            then: Phase::Advance,
            depth: 0,
        }
    }

    /// The largest tau of interest.
    #[inline(always)]
    pub fn limit(&self) -> f64 {
        beyond(self.query.limit()) * self.course.per_t
    }
}

/// Where a ray goes on in a grid when it has left those below.
#[derive(Clone, Copy)]
pub(super) struct Frame<C: Count, L: Lanes> {
    pub level: C::Level,
    pub local: Local<L>,
    pub to: L::I32,
    pub out: f32,
    /// The grids still to be entered, and the range of tau to walk there.
    pub grids: Refs,
    pub range: [f64; 2],
}

impl<C: Count, L: Lanes> Frame<C, L> {
    pub fn unused(l: L) -> Self {
        let (local, to) = (Local::nowhere(l), l.splat_i32(0));
        let level = C::Level::default();
        Self { level, local, to, out: 0.0, grids: Refs::default(), range: [0.0; 2] }
    }
}
