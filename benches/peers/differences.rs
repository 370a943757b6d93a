//! Rays that end differently. hug's hits are exact, so it is the peer that is wrong, except that
//! of triangles met at the same t each library takes one by its own rule, which is not counted.

use super::peer::Found;
use hug::Hit;

#[derive(Clone, Copy, Debug, Default)]
pub struct Differences {
    /// Hit by hug, missed by the peer.
    pub lost: usize,
    /// Hit by the peer alone.
    pub invented: usize,
    /// Hit by both, at t that differ by more than 1e-4 of the larger.
    pub elsewhere: usize,
}

const TOLERANCE: f32 = 1e-4;

impl Differences {
    pub fn of_hits(hits: &[Hit], found: &[Found]) -> Self {
        let mut seen = Self::default();
        for (ours, theirs) in hits.iter().zip(found) {
            seen.add(ours.is_hit(), theirs.is_hit());
            let apart = (ours.t - theirs.t).abs() > TOLERANCE * ours.t.max(theirs.t);
            seen.elsewhere += usize::from(ours.is_hit() && theirs.is_hit() && apart);
        }
        seen
    }

    pub fn of_answers(ours: &[bool], theirs: &[bool]) -> Self {
        let mut seen = Self::default();
        for (&ours, &theirs) in ours.iter().zip(theirs) {
            seen.add(ours, theirs);
        }
        seen
    }

    fn add(&mut self, ours: bool, theirs: bool) {
        self.lost += usize::from(ours && !theirs);
        self.invented += usize::from(theirs && !ours);
    }
}
