//! Section 7.2: clusters in turned boxes, beside the same clusters in aligned ones.
//!
//! `boxes` compares the boxes, `steps` counts what rays do in them.

pub mod boxes;
pub mod steps;

pub use boxes::{Measure, Ratios};
pub use steps::Steps;

use crate::measure::{Frame, VIEWS};
use crate::progress::Progress;
use crate::selected::contest::{SETS, rays};
use hug::{Ray, Scene};
use hug_bench::load::Loaded;
use hug_bench::notation::{Notation, short};

/// Whose clusters: those of the paper's kitchen, and connected components that do not pop up.
pub const CLUSTERED: [&str; 2] = ["u.f3.sqrt2", "u.f2.sqrt2+components+min=8"];

/// What boxes lie along, in the notation's words.
pub const ALONG: [&str; 3] = ["vertices", "hull", "search"];

/// The largest share of the aligned box's surface that the library takes: every cluster without
/// grids below is turned, for better or worse.
const ALL: &str = "+turn=1000000";

/// One scene.
pub struct Oriented {
    pub name: String,
    /// The paper's name for it, or its own.
    pub short: String,
    /// One for each of [`CLUSTERED`].
    pub clusterings: Vec<Clustered>,
}

/// One clustering of a scene.
pub struct Clustered {
    pub notation: &'static str,
    pub clusters: usize,
    /// In aligned boxes, by set of rays.
    pub aligned: [Steps; 2],
    /// One for each of [`ALONG`].
    pub turned: Vec<Turned>,
}

/// Its clusters along one kind of axes.
pub struct Turned {
    pub along: &'static str,
    /// With all clusters turned: by grid, `None` where that cannot be.
    pub boxes: Vec<Option<Ratios>>,
    /// How many are turned where that has to pay, and what rays then do.
    pub kept: usize,
    pub steps: [Steps; 2],
}

impl Oriented {
    pub fn measure(scene: &str, size: u32, bar: &Progress) -> Result<Self, String> {
        let loaded = Loaded::new(scene)?;
        let short = short(&loaded.name).to_owned();
        bar.more(CLUSTERED.len() * (1 + 2 * ALONG.len()));
        let build = |text: &str| {
            bar.at(&format!("{short}: building {text}"));
            let notation: Notation = text.parse()?;
            let scene = loaded.build(&notation.options_for(loaded.mesh.indices.len() as u64));
            bar.done();
            scene.map_err(|error| format!("{short}.{text}: {error}"))
        };
        let mut sets: Option<[Vec<Ray>; 2]> = None;
        let mut clusterings = Vec::new();
        for notation in CLUSTERED {
            let plain = build(notation)?;
            let sets = sets.get_or_insert_with(|| of_views(&loaded, &plain, size));
            let steps = |scene: &Scene| [0, 1].map(|set| Steps::of(&scene.view(), &sets[set]));
            let mut turned = Vec::new();
            for along in ALONG {
                let all = build(&format!("{notation}+{along}{ALL}"))?;
                let boxes = boxes::compare(&plain.view(), &all.view());
                drop(all);
                let scene = build(&format!("{notation}+{along}"))?;
                let kept = boxes::turned(&scene.view());
                turned.push(Turned { along, boxes, kept, steps: steps(&scene) });
            }
            let clusters = plain.view().grid_count().saturating_sub(1);
            clusterings.push(Clustered { notation, clusters, aligned: steps(&plain), turned });
        }
        Ok(Self { name: loaded.name, short, clusterings })
    }
}

/// The sets of rays, named by [`SETS`].
fn of_views(loaded: &Loaded, scene: &Scene, size: u32) -> [Vec<Ray>; SETS.len()] {
    let frame = |(name, view): (String, _)| Frame::new(name, &view, size, loaded, &scene.view());
    let frames: Vec<Frame> = loaded.first_views(VIEWS).into_iter().map(frame).collect();
    rays(&frames, &loaded.bounds, size)
}

impl Clustered {
    pub fn along(&self, name: &str) -> Option<&Turned> {
        self.turned.iter().find(|turned| turned.along == name)
    }
}

impl Turned {
    /// One figure of all clusters that have it.
    pub fn all(&self, of: Measure) -> Vec<f64> {
        self.boxes.iter().flatten().filter_map(of).collect()
    }
}
