//! The command line, and what it asks to be measured.

use crate::selected::Curve;
use clap::{Parser, ValueEnum};
use hug_bench::notation::{Configuration, Notation, scene};
use hug_bench::variation::Variation;
use std::path::PathBuf;

/// Repeats the tables, plots and claims of Cazals & Puech 1997 on the project's scenes and any
/// other: one HTML page that needs no other file, and beside it the tables as CSV and the pictures
/// as PNG.
#[derive(Parser, Clone, Debug)]
#[command(name = "hug-report")]
pub struct Args {
    /// Folder to write to; made if it is not there
    #[arg(long)]
    pub out: PathBuf,
    /// Built-in scenes, also by the paper's names, or PLY files, also those in $HUG_SCENES; again
    /// or with commas. The four of the paper unless given
    #[arg(long, value_delimiter = ',')]
    pub scene: Vec<String>,
    /// Structures for every scene, in the paper's notation: g28, r50, u.f3.sqrt2, auto; again or
    /// with commas. Those of the paper unless given
    #[arg(long, value_delimiter = ',')]
    pub structure: Vec<Notation>,
    /// One scene in one structure, as kit.u.f3.sqrt2 or csbc.r50; again or with commas
    #[arg(long, value_delimiter = ',')]
    pub config: Vec<Configuration>,
    /// What to make; all unless given. The boxes and the selected results have structures of
    /// their own, so with --structure or --config only the instruments are made
    #[arg(long, value_enum, value_delimiter = ',')]
    pub part: Vec<Part>,
    /// What the selected results set beside recursive grids of MAXP from 10 to 1000: a structure,
    /// ALPHA in it for each of several subdivisions of the world; again or with commas.
    /// u.f2.ALPHA, u.f3.ALPHA, u.f2.ALPHA+components, g and auto unless given
    #[arg(long, value_delimiter = ',')]
    pub curve: Vec<Curve>,
    /// Pixels along each side of a picture; the paper's had 250
    #[arg(long, default_value_t = 250, value_parser = clap::value_parser!(u32).range(1..=2048))]
    pub size: u32,
    /// How often each picture is timed
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    pub rounds: u32,
    /// No progress bar
    #[arg(long)]
    pub quiet: bool,
}

/// A part of the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Part {
    /// Sections 2 to 6: tables, charts, pictures, call costs
    Instruments,
    /// Section 7.2: turned boxes of clusters, figure 25
    Boxes,
    /// Section 7.5: time and memory of HUGs and recursive grids
    Selected,
}

/// A scene and the structures to build of it; with none, those of the paper.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    pub scene: String,
    pub structures: Vec<Notation>,
}

const PAPER: [&str; 4] = ["kitchen", "building", "city", "garden"];

impl Args {
    /// Whether a part is asked for.
    pub fn wants(&self, part: Part) -> bool {
        let own = !self.structure.is_empty() || !self.config.is_empty();
        match &self.part[..] {
            [] => part == Part::Instruments || !own,
            given => given.contains(&part),
        }
    }

    /// Whether the parts asked for go together with the structures asked for.
    pub fn check(&self) -> Result<(), String> {
        let own = !self.structure.is_empty() || !self.config.is_empty();
        if own && self.part.contains(&Part::Selected) {
            return Err("--part selected: name its structures by --curve, not by --structure or \
                        --config"
                .into());
        }
        if own && self.part.contains(&Part::Boxes) {
            return Err(
                "--part boxes: its structures are given, so no --structure or --config".into()
            );
        }
        if !self.curve.is_empty() && !self.wants(Part::Selected) {
            return Err("--curve: only for --part selected".into());
        }
        Ok(())
    }

    /// What to measure, every scene once.
    pub fn jobs(&self) -> Vec<Job> {
        let mut jobs: Vec<Job> = Vec::new();
        let named = self.scene.iter().map(String::as_str);
        let all = PAPER.iter().copied().filter(|_| self.scene.is_empty() && self.config.is_empty());
        for name in named.chain(all) {
            let job = Job { scene: scene(name).0.to_owned(), structures: self.structure.clone() };
            if !jobs.iter().any(|known| known.scene == job.scene) {
                jobs.push(job);
            }
        }
        for config in &self.config {
            match jobs.iter_mut().find(|job| job.scene == config.scene) {
                // A scene asked for as a whole keeps its own structures.
                Some(job) if job.structures.is_empty() => {}
                Some(job) if job.structures.contains(&config.structure) => {}
                Some(job) => job.structures.push(config.structure),
                None => jobs
                    .push(Job { scene: config.scene.clone(), structures: vec![config.structure] }),
            }
        }
        jobs
    }
}

/// The paper's structures for a scene of this name and so many triangles, and the library's own
/// choice. The uniform grid is cut by the cube-root criterion: 28 for the paper's kitchen. For the
/// building the paper has a finer one.
pub fn paper_structures(short: &str, triangles: u64) -> Vec<Notation> {
    let side = (triangles as f64).cbrt().round().clamp(1.0, 2048.0) as u32;
    let hug = |levels, alpha| Notation::Hug { levels, alpha, with: Variation::default() };
    let mut all = vec![
        Notation::Uniform(Some(side)),
        Notation::Recursive(50),
        Notation::Recursive(500),
        hug(3, std::f32::consts::SQRT_2),
        hug(3, 1.0),
        hug(2, std::f32::consts::SQRT_2),
        hug(2, 1.0),
        Notation::Auto,
    ];
    if short == "csb" {
        all.insert(1, Notation::Uniform(Some(80)));
    }
    all
}
