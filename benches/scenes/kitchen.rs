//! The kitchen in the three configurations of the paper's section 5.

use super::paper;
use super::table::{Other, Table};
use hug::{Error, Filter, Geometry, Gridding, Hierarchy, Options, Scene, Stats, Structure};
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

/// Plain steps, so that nothing but the paper's structure counts, and capacities that no grid of
/// the kitchen reaches.
fn base() -> Options {
    Options {
        gridding: Gridding::Homogeneous,
        exit_boxes: false,
        max_refs: 4096,
        ..Options::default()
    }
}

pub fn figures(mesh: &Mesh) -> Result<Vec<Figure>, Error> {
    let uniform = Options { structure: Structure::Uniform, counts: [28; 3], ..base() };
    let hug = Options {
        structure: Structure::Hug,
        filter: Filter::ThreeLevels,
        world_alpha: Some(core::f32::consts::SQRT_2),
        hierarchy: Hierarchy::Paper,
        min_cluster: 1,
        ..base()
    };
    let nested = Options { hierarchy: Hierarchy::Nested, ..hug };
    let recursive = Options { structure: Structure::Recursive, maxp: 50, ..base() };
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
