//! Queries that ask the caller about each hit.
//!
//! A ray's hits are offered in their order, from the first on, until one is accepted: so
//! no triangle is offered twice, however many voxels it is in, no hit behind the one
//! accepted is offered at all, and the calls are the same in every structure. The first
//! hit comes from the query without a filter; a rejected one is where the search for the
//! next begins. The caller's function is called between walks, never in one.

use super::all::Hits;
use super::stream::{Port, Slices};
use crate::arena::View;
use crate::ray::{Hit, Ray};

/// Rays of a stream at a time.
const CHUNK: usize = 128;

impl View<'_> {
    /// The closest hit of `ray` that `accept` accepts, or the record of a miss: an alpha
    /// test, say. A triangle is offered once at most, in no order to rely on, with the
    /// hit that [`View::intersect`] would write. A rejected hit takes about as long as
    /// another ray that starts there.
    ///
    /// ```
    /// # let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// # let mesh = hug::Geometry::from_mesh(&vertices, &[[0, 1, 2], [1, 2, 3]]);
    /// # let scene = hug::Scene::build(&[mesh], &hug::Options::default())?;
    /// let ray = hug::Ray::new([0.25, 0.25, 2.0], [0.0, 0.0, -1.0]);
    /// let hit = scene.view().intersect_filtered(&ray, |hit| hit.prim == 0);
    /// assert_eq!((hit.t, hit.prim), (2.0, 0));
    /// # Ok::<(), hug::Error>(())
    /// ```
    pub fn intersect_filtered(&self, ray: &Ray, mut accept: impl FnMut(&Hit) -> bool) -> Hit {
        self.first_accepted(ray, &mut accept)
    }

    /// Whether `ray` hits anything that `accept` accepts, asked as by
    /// [`View::intersect_filtered`].
    pub fn occluded_filtered(&self, ray: &Ray, mut accept: impl FnMut(&Hit) -> bool) -> bool {
        self.first_accepted(ray, &mut accept).is_hit()
    }

    /// [`View::intersect_filtered`] for many rays, as [`View::intersect_n`]; `accept` is
    /// told the number of the ray too. Rays can be asked about in any order.
    pub fn intersect_n_filtered(
        &self,
        rays: &[Ray],
        hits: &mut [Hit],
        mut accept: impl FnMut(usize, &Hit) -> bool,
    ) {
        let n = rays.len().min(hits.len());
        let mut port = Slices { rays, answers: hits };
        self.filtered(&mut port, n, &mut |i, _, hit| accept(i, hit));
    }

    /// [`View::occluded_filtered`] for many rays, likewise.
    pub fn occluded_n_filtered(
        &self,
        rays: &[Ray],
        occluded: &mut [bool],
        mut accept: impl FnMut(usize, &Hit) -> bool,
    ) {
        let n = rays.len().min(occluded.len());
        let mut port = Flags(&mut Slices { rays, answers: occluded });
        self.filtered(&mut port, n, &mut |i, _, hit| accept(i, hit));
    }

    #[inline(never)]
    fn first_accepted(&self, ray: &Ray, accept: &mut dyn FnMut(&Hit) -> bool) -> Hit {
        self.accepted(ray, self.intersect(ray), accept)
    }

    /// The first hit from `first` on that is accepted.
    #[inline(never)]
    fn accepted(&self, ray: &Ray, first: Hit, accept: &mut dyn FnMut(&Hit) -> bool) -> Hit {
        if !first.is_hit() || accept(&first) {
            return first;
        }
        Hits::new(*self, *ray, Some(first)).find(accept).unwrap_or_else(|| Hit::miss(ray.tmax))
    }

    /// Answers `n` rays of a port, asking `accept` about number, ray and hit.
    pub(crate) fn filtered(
        &self,
        port: &mut dyn Port<Hit>,
        n: usize,
        accept: &mut dyn FnMut(usize, &Ray, &Hit) -> bool,
    ) {
        let mut rays = [Ray::new([0.0; 3], [0.0; 3]); CHUNK];
        let mut hits = [Hit::miss(0.0); CHUNK];
        let mut first = 0;
        while first < n {
            let rays = &mut rays[..CHUNK.min(n - first)];
            for (i, to) in (first..).zip(&mut *rays) {
                port.ray(i, to);
            }
            self.intersect_n(rays, &mut hits);
            for ((i, ray), hit) in (first..).zip(&*rays).zip(&hits) {
                port.put(i, self.accepted(ray, *hit, &mut |hit| accept(i, ray, hit)));
            }
            first += rays.len();
        }
    }
}

/// A port that wants to know whether there are hits.
pub(crate) struct Flags<'p>(pub &'p mut dyn Port<bool>);

impl Port<Hit> for Flags<'_> {
    fn ray(&mut self, i: usize, to: &mut Ray) {
        self.0.ray(i, to);
    }

    fn put(&mut self, i: usize, hit: Hit) {
        self.0.put(i, hit.is_hit());
    }
}
