//! One configuration: a scene in a data structure.

use super::render::{Frame, Rendered};
use crate::pictures::slice::{self, Slice};
use hug::{Calls, Occupancy, Scene, Stats};
use hug_bench::clock;
use hug_bench::figures::Spread;
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

/// A scene in a data structure, not yet looked at.
pub struct Plain {
    pub notation: Notation,
    pub scene: Scene,
    /// CPU time of the build.
    pub seconds: f64,
}

impl Plain {
    pub fn build(loaded: &Loaded, notation: Notation) -> Result<Self, String> {
        let mut scene = None;
        let options = notation.options_for(loaded.mesh.indices.len() as u64);
        let seconds = clock::seconds(clock::process, || scene = Some(loaded.build(&options)));
        let scene = scene.ok_or("the clock did not run the build")?;
        Ok(Self { notation, scene: scene.map_err(|e| format!("{notation}: {e}"))?, seconds })
    }
}

impl Built {
    /// Counts everything.
    pub fn of(
        plain: &Plain,
        loaded: &Loaded,
        short: &str,
        frames: &[Frame],
        times: &[Spread],
    ) -> Self {
        let view = plain.scene.view();
        let stats = Stats::of(&view);
        let levels = 0..stats.levels().len();
        let frames = frames.iter().zip(times);
        Self {
            name: format!("{short}.{}", plain.notation),
            notation: plain.notation,
            stats,
            histograms: levels.map(|level| Occupancy::histogram(&view, Some(level))).collect(),
            seconds: plain.seconds,
            rendered: frames.map(|(f, &t)| Rendered::new(f, &view, t)).collect(),
            slices: slice::both(&view, &loaded.mesh),
        }
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

    /// CPU seconds of the picture of this number, the median.
    pub fn time(&self, frame: usize) -> Option<f64> {
        self.rendered.get(frame).map(|r| r.seconds.median)
    }
}
