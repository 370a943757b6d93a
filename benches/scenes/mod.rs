//! The built-in scenes measured as the paper measures its own, and the tolerances they keep.

pub mod kitchen;

use hug::{Error, Options, Scene, Structure};
use hug_bench::paper::Lengths;
use hug_kit::Mesh;
use kitchen::Figure;

/// The mesh measured; the structure makes no difference.
pub fn lengths(mesh: &Mesh) -> Result<Lengths, Error> {
    let options = Options { structure: Structure::Uniform, ..Options::default() };
    let soup = [hug::Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
    Ok(Lengths::of(&hug::Lengths::of(&Scene::build(&soup, &options)?.view())))
}

/// How far a figure may be from the paper's.
#[derive(Clone, Copy, Debug)]
pub enum Tolerance {
    /// Up to this many times more or less.
    Factor(f64),
    /// Up to this much more or less.
    Points(f64),
}

/// The same order of magnitude: half of one to either side.
const MAGNITUDE: Tolerance = Tolerance::Factor(3.162_277_660_168_379_5);

/// A calibrated figure.
#[derive(Clone, Debug)]
pub struct Check {
    pub what: String,
    pub ours: f64,
    pub paper: f64,
    pub tolerance: Tolerance,
}

impl Check {
    pub fn holds(&self) -> bool {
        match self.tolerance {
            Tolerance::Factor(f) => self.ours <= self.paper * f && self.paper <= self.ours * f,
            Tolerance::Points(p) => (self.ours - self.paper).abs() <= p,
        }
    }
}

/// What figure 4 asks of a scene.
pub fn length_checks(name: &str, ours: &Lengths, paper: &Lengths) -> Vec<Check> {
    let check = |what: &str, ours, paper, tolerance| {
        let what = format!("figure 4, {name}: {what}");
        Check { what, ours, paper, tolerance }
    };
    vec![
        check("triangles", ours.count as f64, paper.count as f64, MAGNITUDE),
        check("min/max", ours.min_max, paper.min_max, MAGNITUDE),
        check("min/diag", ours.min_diag, paper.min_diag, MAGNITUDE),
        check("%.2", ours.below, paper.below, Tolerance::Points(1.0)),
    ]
}

/// What figures 12, 14 and 17 ask of the kitchen: %obj, empty voxels, occupancy of the others.
/// Levels count from the outermost grid; one that is missing fails.
pub fn table_checks(figure: &Figure) -> Vec<Check> {
    let levels = figure.paper.rows.len();
    let mut checks = Vec::new();
    for (level, paper) in figure.paper.rows.iter().enumerate() {
        let ours = figure.ours.below_top(levels - 1 - level);
        let mut check = |what: &str, ours: Option<f64>, paper| {
            let what = format!("{}, level {level}: {what}", figure.title);
            let ours = ours.unwrap_or(0.0);
            checks.push(Check { what, ours, paper, tolerance: Tolerance::Factor(2.0) });
        };
        check("%obj", ours.map(|r| r.objects), paper.objects);
        check("% empty voxels", ours.map(|r| 100.0 - r.filled), 100.0 - paper.filled);
        check("references in the others", ours.map(|r| r.per_filled[0]), paper.per_filled[0]);
    }
    checks
}
