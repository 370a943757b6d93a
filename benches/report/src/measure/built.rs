//! One configuration: a scene in a data structure.

use super::render::{Frame, Rendered};
use crate::pictures::slice::{self, Slice};
use hug::{Calls, Occupancy, Stats};
use hug_bench::clock;
use hug_bench::load::Loaded;
use hug_bench::notation::Notation;

pub struct Built {
    /// As in the paper: `kit.r50`.
    pub name: String,
    pub notation: Notation,
    pub stats: Stats,
    /// Voxels by their triangles, level by level.
    pub histograms: Vec<Vec<u64>>,
    /// CPU time of the build.
    pub seconds: f64,
    /// One of each frame of the scene.
    pub rendered: Vec<Rendered>,
    pub slices: Vec<Slice>,
}

impl Built {
    /// Builds and measures; `whole` with slices and maps, which take memory.
    pub fn measure(
        loaded: &Loaded,
        short: &str,
        notation: Notation,
        frames: &[Frame],
        rounds: u32,
        whole: bool,
    ) -> Result<Self, String> {
        let name = format!("{short}.{notation}");
        let mut scene = None;
        let options = notation.options_for(loaded.mesh.indices.len() as u64);
        let seconds = clock::seconds(clock::process, || scene = Some(loaded.build(&options)));
        let scene = scene.ok_or("the clock did not run the build")?;
        let scene = scene.map_err(|error| format!("{name}: {error}"))?;
        let view = scene.view();
        let stats = Stats::of(&view);
        let levels = 0..stats.levels().len();
        let histograms = levels.map(|level| Occupancy::histogram(&view, Some(level))).collect();
        let rendered = frames.iter().map(|f| Rendered::new(f, &view, rounds, whole)).collect();
        let slices = if whole { slice::both(&view, &loaded.mesh) } else { Vec::new() };
        Ok(Self { name, notation, stats, histograms, seconds, rendered, slices })
    }

    /// Bytes of grids, voxels and references, in units of 2^20; the triangles' own are the same
    /// in every structure.
    pub fn megabytes(&self) -> f64 {
        (self.stats.bytes - self.stats.triangle_bytes) as f64 / f64::from(1 << 20)
    }

    /// All calls of the picture of this number.
    pub fn calls(&self, frame: usize) -> Calls {
        self.rendered.get(frame).map(|r| r.profile.total()).unwrap_or_default()
    }

    /// CPU seconds of the picture of this number.
    pub fn time(&self, frame: usize) -> Option<f64> {
        self.rendered.get(frame).map(|r| r.seconds)
    }
}
