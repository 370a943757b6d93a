//! What a ray of a flock keeps to itself.

use super::super::descent::{Line, Start, beyond, hidden, start};
use super::super::query::Query;
use super::super::sieve::Sieve;
use crate::arena::node::Node;
use crate::arena::{Sections, View};
use crate::ray::Ray;
use crate::simd::Lanes;

/// A ray and what it has found.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub struct Member<'a, Q> {
    /// The ray as boxes want it ([`Line`]).
    pub rows: [[f32; 4]; 3],
    pub ray: Ray,
    pub sieve: Sieve<'a>,
    pub query: Q,
    /// Its place in the stream.
    pub index: usize,
    /// It needs more room on its way than there is, and is to be answered alone.
    pub lost: bool,
}

/// [`beyond`], but finite, as infinity is where there is no part. Nor is it minus infinity, which is
/// for a ray that has all it wants: where the product is, what is allowed for rounding is infinite, too.
#[inline(always)]
fn end<L: Lanes>(l: L, limit: f32, unit: f32) -> f32 {
    beyond(l, limit, unit).min(f32::MAX)
}

impl<'a, Q: Query> Member<'a, Q> {
    /// That of no ray.
    #[inline(always)]
    pub fn none<L: Lanes>(l: L, sections: &Sections<'a>) -> Self {
        let ray = Ray::new([0.0; 3], [0.0, 0.0, 1.0]);
        let [org, dir, _] = ray.rows();
        let sieve = Sieve::new(l, sections, &ray, [l.load_f32(org), l.load_f32(dir)], true);
        Self { rows: [[0.0; 4]; 3], ray, sieve, query: Q::new(&ray), index: 0, lost: false }
    }

    /// Begins with the ray that was put here, where it was written: what is copied has to be waited
    /// for. No tau above what is returned is of interest; `None` if the ray is not for the tree.
    #[inline(always)]
    pub fn begin<L: Lanes>(
        &mut self,
        l: L,
        view: &View<'a>,
        sections: &Sections<'a>,
        unit: f32,
        index: usize,
    ) -> Option<f32> {
        let ray = &self.ray;
        let start: Start<L> = start(l, view, ray)?;
        let [org, dir, _] = ray.rows();
        self.rows = Line::<Node>::new(l, sections, &start, ray, unit).rows;
        self.sieve = Sieve::new(l, sections, ray, [l.load_f32(org), l.load_f32(dir)], true);
        self.query = Q::new(ray);
        (self.index, self.lost) = (index, false);
        let occluders = view.header().occluders();
        if Q::ANY && hidden(l, sections, &self.sieve, &self.ray, occluders, &mut self.query) {
            return Some(f32::NEG_INFINITY);
        }
        Some(end(l, self.ray.tmax, unit))
    }

    /// Looks no farther than what was found: no tau above that is of interest.
    #[inline(always)]
    pub fn shorten<L: Lanes>(&mut self, l: L, unit: f32) -> f32 {
        let limit = self.query.limit();
        self.sieve.limit(l, limit);
        end(l, limit, unit)
    }
}
