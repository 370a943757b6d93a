//! Section 7.5: what time and memory HUGs and recursive grids need, at equal memory and at equal
//! time.
//!
//! `curves` lists what is compared, `contest` measures it, `equal` reads a recursive grid that
//! was not built off those that were, `judged` sets each structure beside it.

pub mod contest;
pub mod curves;
pub mod entry;
pub mod equal;
pub mod judged;
pub mod walk;

pub use contest::{Contest, SETS};
pub use curves::Curve;
pub use entry::{Cost, Entry};
pub use judged::{Judged, Ordinate};
pub use walk::Walk;

use crate::measure::{Frame, VIEWS};
use crate::progress::Progress;
use hug::{Options, Structure};
use hug_bench::load::Loaded;
use hug_bench::notation::short;

/// One scene, all structures measured in it.
pub struct Comparison {
    /// The scene's name, and the paper's name for it.
    pub name: String,
    pub short: String,
    pub triangles: u64,
    /// The views whose primary rays are traced.
    pub views: Vec<String>,
    /// One with steps of one voxel, one with exit boxes.
    pub contests: Vec<Contest>,
}

impl Comparison {
    pub fn measure(
        scene: &str,
        curves: &[Curve],
        size: u32,
        rounds: u32,
        bar: &Progress,
    ) -> Result<Self, String> {
        let loaded = Loaded::new(scene)?;
        let short = short(&loaded.name).to_owned();
        let uniform = Options { structure: Structure::Uniform, ..Options::default() };
        let plain = loaded.build(&uniform)?;
        let frames: Vec<Frame> = loaded
            .first_views(VIEWS)
            .into_iter()
            .map(|(name, view)| Frame::new(name, &view, size, &loaded, &plain.view()))
            .collect();
        drop(plain);
        let sets = contest::rays(&frames, &loaded.bounds, size);
        let measure =
            |walk| Contest::measure(&loaded, &short, walk, curves, &sets, rounds as usize, bar);
        let contests = Walk::ALL.into_iter().map(measure).collect::<Result<_, _>>()?;
        Ok(Self {
            triangles: (loaded.mesh.indices.len()) as u64,
            views: frames.into_iter().map(|frame| frame.view).collect(),
            name: loaded.name,
            short,
            contests,
        })
    }

    pub fn contest(&self, walk: Walk) -> Option<&Contest> {
        self.contests.iter().find(|contest| contest.walk == walk)
    }
}
