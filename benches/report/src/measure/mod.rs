//! What is measured of a scene: its lengths, its structures, and pictures of it in each.

pub mod built;
pub mod render;

pub use built::Built;
pub use render::{Frame, Rendered};

use crate::args::{Job, paper_structures};
use crate::progress::Progress;
use hug::{Lengths, Options, Structure};
use hug_bench::load::Loaded;
use hug_bench::notation::{Notation, short};

/// Classes of a histogram of lengths, up to a fifth of the largest.
pub const CLASSES: usize = 50;
/// Where that histogram ends, as in the paper's charts.
pub const SHARE: f64 = 0.2;

/// Views of a scene that are rendered.
const VIEWS: usize = 2;

/// One scene, measured.
pub struct Subject {
    pub loaded: Loaded,
    /// The paper's name for it, or its own.
    pub short: String,
    pub lengths: Lengths,
    pub length_counts: Vec<u64>,
    pub frames: Vec<Frame>,
    /// The structures asked for.
    pub built: Vec<Built>,
    /// More recursive grids, for memory against time.
    pub recursive: Vec<Built>,
}

/// MAXP of the recursive grids that memory and time are compared over.
const CURVE: [u32; 9] = [10, 25, 50, 100, 200, 350, 500, 1000, 2000];

impl Subject {
    pub fn measure(job: &Job, size: u32, rounds: u32, bar: &Progress) -> Result<Self, String> {
        let loaded = Loaded::new(&job.scene)?;
        let short = short(&loaded.name).to_owned();
        let uniform = Options { structure: Structure::Uniform, ..Options::default() };
        let plain = loaded.build(&uniform)?;
        let lengths = Lengths::of(&plain.view());
        let mut length_counts = vec![0; CLASSES];
        lengths.histogram(&plain.view(), SHARE, &mut length_counts);
        let frames: Vec<Frame> = loaded
            .first_views(VIEWS)
            .into_iter()
            .map(|(name, view)| Frame::new(name, &view, size, &loaded, &plain.view()))
            .collect();
        let structures = match &job.structures[..] {
            [] => paper_structures(lengths.count),
            given => given.to_vec(),
        };
        let curve = CURVE.map(Notation::Recursive);
        let more: Vec<Notation> = if job.structures.is_empty() {
            curve.into_iter().filter(|n| !structures.contains(n)).collect()
        } else {
            Vec::new()
        };
        bar.more(structures.len() + more.len());
        let measure = |notation: &Notation, whole: bool| {
            bar.at(&format!("{short}.{notation}"));
            let built = Built::measure(&loaded, &short, *notation, &frames, rounds, whole);
            bar.done();
            built
        };
        let built = structures.iter().map(|n| measure(n, true)).collect::<Result<Vec<_>, _>>()?;
        let recursive = more.iter().map(|n| measure(n, false)).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { loaded, short, lengths, length_counts, frames, built, recursive })
    }

    /// A structure by its notation, among all that were built.
    pub fn find(&self, notation: &str) -> Option<&Built> {
        let all = self.built.iter().chain(&self.recursive);
        all.into_iter().find(|built| built.notation.to_string() == notation)
    }

    /// All recursive grids, the finest first.
    pub fn all_recursive(&self) -> Vec<&Built> {
        let maxp = |built: &Built| match built.notation {
            Notation::Recursive(maxp) => Some(maxp),
            _ => None,
        };
        let mut all: Vec<&Built> =
            self.built.iter().chain(&self.recursive).filter(|b| maxp(b).is_some()).collect();
        all.sort_by_key(|b| maxp(b));
        all
    }
}
