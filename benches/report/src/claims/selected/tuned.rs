//! The HUG that section 7.5 compares: tuned by the subdivision of its world.

use crate::selected::{Comparison, Contest, Entry, Judged, Ordinate, Walk};
use crate::sheet::number;

/// The HUG that is tuned, and the recursive grid that it is tuned to.
pub const HUG: &str = "u.f2.ALPHA";
pub const TARGET: &str = "r50";
/// Times within this factor are equal.
const SAME: f64 = 1.1;
/// Primary rays, as the paper's pictures begin with.
pub const PRIMARY: usize = 0;

pub fn time(entry: &Entry) -> f64 {
    Ordinate::Time.of(entry, PRIMARY)
}

fn judged(contest: &Contest, entry: &Entry) -> Option<Judged> {
    Judged::new(contest, entry, PRIMARY, Ordinate::Time)
}

fn as_fast(entry: &Entry, target: &Entry) -> bool {
    time(entry) <= SAME * time(target)
}

/// The smallest HUG that is as fast as the target; if none is, the fastest.
pub struct Tuned<'a> {
    pub contest: &'a Contest,
    pub hug: &'a Entry,
    target: &'a Entry,
    pub judged: Judged,
}

impl<'a> Tuned<'a> {
    /// Among those that have a recursive grid of their memory to compare with, if any has and
    /// `comparable` asks for it.
    pub fn of(all: &'a [Comparison], short: &str, walk: Walk, comparable: bool) -> Option<Self> {
        let contest = all.iter().find(|c| c.short == short)?.contest(walk)?;
        let target = contest.find(TARGET)?;
        let has_equal =
            |e: &&Entry| judged(contest, e).is_some_and(|j| j.equal_memory.at().is_some());
        let any = contest.curve(HUG).any(|e| has_equal(&e));
        let hugs = || contest.curve(HUG).filter(|e| !(comparable && any) || has_equal(e));
        let smallest = hugs()
            .filter(|e| as_fast(e, target))
            .min_by(|a, b| a.megabytes().total_cmp(&b.megabytes()));
        let fastest = || hugs().min_by(|a, b| time(a).total_cmp(&time(b)));
        let hug = smallest.or_else(fastest)?;
        Some(Self { contest, hug, target, judged: judged(contest, hug)? })
    }

    /// The share of the target's memory, if it is as fast.
    pub fn share_of_target(&self) -> Option<f64> {
        as_fast(self.hug, self.target).then(|| self.hug.megabytes() / self.target.megabytes())
    }

    pub fn by_work(&self) -> Option<Judged> {
        Judged::new(self.contest, self.hug, PRIMARY, Ordinate::Work)
    }

    /// What the verdict is about, in figures.
    pub fn figures(&self) -> String {
        let figure = |e: &Entry| {
            let (mb, ns) = (number(e.megabytes()), number(time(e)));
            format!("{} {mb} MB, {ns} ns a primary ray", e.name)
        };
        let (hug, target) = (figure(self.hug), figure(self.target));
        format!("{hug}; {target}; sum of %vol {}", number(self.hug.volume))
    }

    /// What of the HUG's curve has the most of a figure, or the least.
    pub fn along(&self, of: fn(&Judged) -> Option<f64>, most: bool) -> String {
        let all = self
            .contest
            .curve(HUG)
            .filter_map(|e| Some((of(&judged(self.contest, e)?)?, e.notation.to_string())));
        let sign = if most { 1.0 } else { -1.0 };
        let best = all.max_by(|a, b| (sign * a.0).total_cmp(&(sign * b.0)));
        best.map_or("out of range".into(), |(x, name)| format!("{} ({name})", number(x)))
    }
}
