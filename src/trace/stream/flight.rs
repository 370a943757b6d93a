//! A ray in flight: what it keeps to itself, and the grids that it is to go back to.

use super::super::course::{Course, Mirror};
use super::super::decided::Decided;
use super::super::local::Span;
use super::super::query::Query;
use super::columns::Kept;
use crate::ray::Ray;
use crate::simd::Lanes;

/// References to grids that are still to be entered, by their places.
#[derive(Clone, Copy)]
pub(super) struct Grids {
    pub at: u32,
    pub end: u32,
}

impl Grids {
    pub const NONE: Self = Self { at: 0, end: 0 };

    pub fn is_empty(self) -> bool {
        self.at >= self.end
    }
}

/// A ray on its way.
#[derive(Clone, Copy)]
pub(super) struct Flight<Q, L: Lanes> {
    pub ray: Ray,
    /// Its place in the stream.
    pub index: usize,
    pub query: Q,
    pub course: Course<L>,
    /// In the coordinates of the grid where it is.
    pub mirror: &'static Mirror,
    pub decided: Decided,
    /// In the grid where it is.
    pub span: Span,
    /// Grids of its voxel's list.
    pub grids: Grids,
    /// Number of frames in use.
    pub depth: usize,
}

impl<Q: Query, L: Lanes> Flight<Q, L> {
    pub fn new(ray: Ray, index: usize, course: Course<L>) -> Self {
        Self {
            ray,
            index,
            query: Q::new(&ray),
            course,
            mirror: course.mirror,
            decided: Decided::NONE,
            span: Span::NONE,
            grids: Grids::NONE,
            depth: 0,
        }
    }

    /// Where it stops in its grid, all hits considered.
    #[inline(always)]
    pub fn stop(&self) -> f32 {
        self.span.stop(self.query.limit(), self.course.per_t)
    }
}

/// Where a ray goes on in a grid when it has left those below.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub kept: Kept,
    pub mirror: &'static Mirror,
    pub span: Span,
    /// The grids still to be entered, and the range of tau to walk there.
    pub grids: Grids,
    pub range: [f64; 2],
}

impl Frame {
    pub const NONE: Self = Self {
        kept: Kept::NONE,
        mirror: Mirror::ASCENDING,
        span: Span::NONE,
        grids: Grids::NONE,
        range: [0.0; 2],
    };
}
