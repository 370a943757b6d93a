//! What is measured of a scene: its lengths, its structures, and pictures of it in each.

pub mod built;
pub mod render;

pub use built::{Built, Plain};
pub use render::{Frame, Rendered};

use crate::args::{Job, paper_structures};
use crate::progress::Progress;
use hug::{Lengths, Options, Structure, View};
use hug_bench::costs::{self, Costs, Rays};
use hug_bench::figures::Spread;
use hug_bench::load::Loaded;
use hug_bench::notation::{Notation, short};

/// Classes of a histogram of lengths, up to a fifth of the largest.
pub const CLASSES: usize = 50;
/// Where that histogram ends, as in the paper's charts.
pub const SHARE: f64 = 0.2;

/// Rounds of the calls for one of the pictures: they are shorter, and their costs are compared.
const CALL_ROUNDS: usize = 3;

/// Views of a scene that are rendered.
pub const VIEWS: usize = 2;

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
    /// What their calls cost, by frame and structure.
    pub costs: Vec<Vec<Costs>>,
}

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
            [] => paper_structures(&short, lengths.count),
            given => given.to_vec(),
        };
        bar.more(2 * structures.len() + 2 * frames.len());
        let step = |what: &str| bar.at(&format!("{short}: {what}"));
        let build = |notation: &Notation| {
            step(&format!("building {notation}"));
            let plain = Plain::build(&loaded, *notation);
            bar.done();
            plain.map_err(|error| format!("{short}.{error}"))
        };
        let plain: Vec<Plain> = structures.iter().map(build).collect::<Result<_, _>>()?;
        let views: Vec<View<'_>> = plain.iter().map(|p| p.scene.view()).collect();
        let (mut times, mut costs) = (Vec::new(), Vec::new());
        for frame in &frames {
            step(&format!("timing view {}", frame.view));
            times.push(render::times(frame, &views, rounds));
            bar.done();
            step(&format!("timing the calls of view {}", frame.view));
            let rays = Rays::of(&frame.primary, &frame.shadow);
            costs.push(costs::measure(&views, &rays, CALL_ROUNDS * rounds as usize));
            bar.done();
        }
        let count = |(i, plain): (usize, &Plain)| {
            step(&format!("counting in {}", plain.notation));
            let times: Vec<Spread> = times.iter().map(|of: &Vec<Spread>| of[i]).collect();
            let built = Built::of(plain, &loaded, &short, &frames, &times);
            bar.done();
            built
        };
        let built = plain.iter().enumerate().map(count).collect();
        Ok(Self { loaded, short, lengths, length_counts, frames, built, costs })
    }

    /// A structure by its notation, if it was built.
    pub fn find(&self, notation: &str) -> Option<&Built> {
        self.built.iter().find(|built| built.notation.to_string() == notation)
    }
}
