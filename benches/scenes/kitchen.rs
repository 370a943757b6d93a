//! The kitchen in the three configurations of the paper's section 5.

use hug::{Error, Geometry, Hierarchy, Options, Scene, Stats};
use hug_bench::notation::Notation;
use hug_bench::paper::{self, Other, Table};
use hug_bench::variation::Variation;
use hug_kit::Mesh;

/// One configuration: what the paper prints, and what the library counts.
pub struct Figure {
    pub title: &'static str,
    pub paper: Table,
    pub ours: Table,
    pub other: Vec<Other>,
    /// Whether the kitchen was calibrated on it.
    pub calibrated: bool,
}

pub fn figures(mesh: &Mesh) -> Result<Vec<Figure>, Error> {
    let options = |notation: Notation| notation.options();
    let uniform = options(Notation::Uniform(Some(28)));
    let hug = options(Notation::Hug {
        levels: 3,
        alpha: core::f32::consts::SQRT_2,
        with: Variation::default(),
    });
    let nested = Options { hierarchy: Hierarchy::Nested, ..hug };
    let recursive = options(Notation::Recursive(50));
    let figure = |title, paper, options: &Options, calibrated| {
        let soup = [Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
        let scene = Scene::build(&soup, options)?;
        let stats = Stats::of(&scene.view());
        let (ours, other) = (Table::of(&stats), Other::levels(&stats));
        Ok(Figure { title, paper, ours, other, calibrated })
    };
    Ok(vec![
        figure("figure 12, kit.g28", paper::figure_12(), &uniform, true)?,
        figure("figure 14, kit.u.f3.sqrt2", paper::figure_14(), &hug, true)?,
        figure("the same, nested hierarchy", paper::figure_14(), &nested, false)?,
        figure("figure 17, kit.r50", paper::figure_17(), &recursive, true)?,
    ])
}
