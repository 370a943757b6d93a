//! Queries that give up after so many steps, and say so.
//!
//! A step is a grid whose box is tested, a voxel traversed or a triangle tested: what
//! [`Counters`](super::Counters) counts, hits apart. So the same budget ends the same
//! ray at the same step on every machine and instruction set.

use super::counters::{Count, Meter};
use super::query::{Any, Closest, Query};
use crate::arena::View;
use crate::ray::{Hit, Ray};

/// A query used up its steps before it had an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Truncated;

impl core::fmt::Display for Truncated {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the query used up its steps before it had an answer")
    }
}

impl core::error::Error for Truncated {}

/// Steps that are left, until one too many is taken.
#[derive(Clone, Copy)]
pub(crate) struct Budget(Option<u64>);

impl Budget {
    fn take(&mut self, steps: u64) {
        self.0 = self.0.and_then(|left| left.checked_sub(steps));
    }
}

impl Count for Budget {
    type Meter<'m> = Meter<'m>;
    fn meter(&mut self) -> Meter<'_> {
        Meter::Budget(self)
    }
    type Level = ();
    fn of(_: u8) {}
    fn grid(&mut self) {
        self.take(1);
    }
    fn voxel(&mut self) {
        self.take(1);
    }
    fn tests(&mut self, n: usize) {
        self.take(n as u64);
    }
    fn spent(&self) -> bool {
        self.0.is_none()
    }
}

impl View<'_> {
    /// [`View::intersect`] in at most `steps` steps: boxes of grids, voxels traversed and
    /// triangles tested, as [`crate::Counters`] counts them. [`View::most_steps`] always
    /// suffice.
    ///
    /// # Errors
    /// [`Truncated`] if they do not suffice: whatever was met by then need not be the
    /// closest.
    pub fn intersect_within(&self, ray: &Ray, steps: u64) -> Result<Hit, Truncated> {
        self.within::<Closest>(ray, steps)
    }

    /// [`View::occluded`] in at most `steps` steps, as [`View::intersect_within`].
    ///
    /// # Errors
    /// [`Truncated`] if nothing was hit in so many steps, and there are more to take.
    pub fn occluded_within(&self, ray: &Ray, steps: u64) -> Result<bool, Truncated> {
        self.within::<Any>(ray, steps)
    }

    fn within<Q: Query>(&self, ray: &Ray, steps: u64) -> Result<Q::Out, Truncated> {
        let mut budget = Budget(Some(steps));
        let found = self.single::<Q, _>(ray, &mut budget);
        if budget.spent() { Err(Truncated) } else { Ok(found) }
    }
}
