//! Who is right when two libraries disagree about a ray.

use super::Triangle;
use super::closest::{hit_named, occluded};
use crate::rays::Ray;

/// The triangle a library says is hit first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claim {
    pub geom: u32,
    pub prim: u32,
    pub corners: Triangle,
}

/// The outcome, from the side of the library under test ("ours").
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Verdict {
    /// Both answers are right.
    Both = 0,
    /// Ours is right, theirs is not.
    Ours = 1,
    /// Ours is proven wrong, whatever theirs is.
    Theirs = 2,
}

impl Verdict {
    fn of(ours_right: bool, theirs_right: bool) -> Self {
        match (ours_right, theirs_right) {
            (true, true) => Self::Both,
            (true, false) => Self::Ours,
            (false, _) => Self::Theirs,
        }
    }
}

/// Judges two claims about the closest hit; `None` is a claimed miss.
///
/// An answer is wrong if what it names is no hit, or if the other names a hit that comes before
/// it. Triangles that neither names are not looked at.
pub fn judge(ray: &Ray, ours: Option<&Claim>, theirs: Option<&Claim>) -> Verdict {
    let find =
        |claim: Option<&Claim>| claim.and_then(|c| hit_named(ray, c.geom, c.prim, &c.corners));
    let (our_hit, their_hit) = (find(ours), find(theirs));
    let right = |claimed: bool, own: &Option<_>, other: &Option<super::Closest>| match (own, other)
    {
        (None, None) => !claimed,
        (None, Some(_)) => false,
        (Some(_), None) => true,
        (Some(own), Some(other)) => !other.before(own),
    };
    Verdict::of(
        right(ours.is_some(), &our_hit, &their_hit),
        right(theirs.is_some(), &their_hit, &our_hit),
    )
}

/// Judges two claims about occlusion by all the triangles the ray's mask lets it see.
pub fn judge_occluded(
    ray: &Ray,
    ours: bool,
    theirs: bool,
    triangles: impl IntoIterator<Item = (u32, u32, Triangle)>,
) -> Verdict {
    let truth = occluded(ray, triangles);
    Verdict::of(ours == truth, theirs == truth)
}
