//! The command line.

use clap::{Parser, Subcommand, ValueEnum};
use hug::{Options, Quality};
use hug_bench::kind::Kind;
use hug_bench::notation::Notation;
use hug_bench::variation::Variation;
use std::path::PathBuf;

const SCENES: &str = "\
A SCENE is a PLY file (ASCII or binary), an OBJ file, the name of one in the folder
$HUG_SCENES, a built-in scene (kitchen, building, building_walls, city, garden, or
surface:N, uniform:N, clustered:N with about N triangles), or, for info and render, a
file that `hug build --out` has written.";

/// Builds scenes for ray tracing, looks into them, renders and compares them
#[derive(Parser, Debug)]
#[command(name = "hug", version, after_help = SCENES)]
pub struct Args {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand, Debug)]
pub enum Command {
    /// Builds a scene, says what it took, and saves it if told where
    #[command(after_help = SCENES, visible_alias = "save")]
    Build(Build),
    /// Prints what a scene is made of: sections, levels, bytes
    #[command(after_help = SCENES)]
    Info(Info),
    /// Renders a picture
    #[command(after_help = SCENES)]
    Render(Render),
    /// Compares the structures on a scene: builds, memory, rays, and that all agree
    #[command(after_help = SCENES)]
    Compare(Compare),
    /// Counts what structures are made of and what rays do in them; no clock is read
    #[command(after_help = SCENES)]
    Count(Count),
    /// Repeats the tables, plots and claims of Cazals & Puech 1997, as a page
    Report(hug_report::args::Args),
}

const BUILDING: &str = "Building";

/// What to build.
#[derive(clap::Args, Clone, Debug)]
pub struct How {
    /// auto, uniform, recursive or hug; or a structure in the paper's notation: g28, r50,
    /// u.f3.sqrt2. Options may follow, as in hug+components+min=32 or uniform+overlap
    #[arg(long, help_heading = BUILDING, value_name = "NAME", default_value = "auto",
          value_parser = structure)]
    pub structure: Named,
    /// How fine a structure auto builds
    #[arg(long, help_heading = BUILDING, value_enum, default_value_t = Fineness::Default)]
    pub quality: Fineness,
    /// The smallest grids that are still sensible (auto), and a tree of boxes in less memory
    #[arg(long, help_heading = BUILDING)]
    pub compact: bool,
    /// Threads to build with; the bytes built are the same
    #[arg(long, help_heading = BUILDING, value_name = "N", default_value_t = 1,
          value_parser = clap::value_parser!(u32).range(1..=256))]
    pub threads: u32,
}

impl How {
    pub fn options(&self) -> Options {
        Options {
            quality: match self.quality {
                Fineness::Fast => Quality::Fast,
                Fineness::Default => Quality::Default,
                Fineness::High => Quality::High,
            },
            compact: self.compact,
            ..self.structure.options
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Fineness {
    /// Built soonest
    Fast,
    /// Between the two
    Default,
    /// Traced soonest
    High,
}

/// A structure as it was asked for.
#[derive(Clone, Debug)]
pub struct Named {
    pub name: String,
    pub options: Options,
}

fn structure(text: &str) -> Result<Named, String> {
    let (name, with) = Variation::split(text)?;
    let options = match Kind::from_str(name, true) {
        Ok(kind) => kind.options(),
        Err(_) => name.parse::<Notation>()?.options(),
    };
    let options = with.apply(options);
    Ok(Named { name: text.to_owned(), options })
}

#[derive(clap::Args, Debug)]
pub struct Build {
    /// What to build
    pub scene: String,
    /// File to save the built scene to, for `hug info`, `hug render` and hug_open
    #[arg(long, short, value_name = "FILE")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub how: How,
    /// No progress bars
    #[arg(long, short)]
    pub quiet: bool,
}

#[derive(clap::Args, Debug)]
pub struct Info {
    /// A built scene's file, or a scene to build first
    pub scene: String,
    #[command(flatten)]
    pub how: How,
    /// No progress bars
    #[arg(long, short)]
    pub quiet: bool,
}

#[derive(clap::Args, Debug)]
pub struct Render {
    /// A built scene's file, or a scene to build first
    pub scene: String,
    /// The picture, a PNG file; SCENE.png in this folder unless given
    #[arg(long, short, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// What a pixel shows
    #[arg(long, value_enum, default_value_t = Mode::Shaded)]
    pub mode: Mode,
    /// A view of the scene by name: a built-in one, or from scenes.json beside the file
    #[arg(long, value_name = "NAME", conflicts_with = "camera")]
    pub view: Option<String>,
    /// Where to look from: eye, point looked at, up, field of view in degrees
    #[arg(
        long,
        value_name = "ex,ey,ez,ax,ay,az,ux,uy,uz,fov",
        value_delimiter = ',',
        num_args = 1,
        allow_hyphen_values = true
    )]
    pub camera: Option<Vec<f32>>,
    /// Pixels along each side
    #[arg(long, value_name = "N", default_value_t = 768, value_parser = clap::value_parser!(u32).range(1..=16384))]
    pub size: u32,
    #[command(flatten)]
    pub how: How,
    /// No progress bars
    #[arg(long, short)]
    pub quiet: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Mode {
    /// Grey by the light of a lamp at the eye
    Shaded,
    /// Near is bright
    Depth,
    /// Steps that the ray took through voxels
    Steps,
}

#[derive(clap::Args, Debug)]
pub struct Compare {
    /// What to compare on
    pub scene: String,
    /// Structures, as for build; again or with commas
    #[arg(long, value_name = "NAMES", value_delimiter = ',', default_value = "auto,uniform,recursive,hug",
          value_parser = structure)]
    pub structure: Vec<Named>,
    /// A view of the scene by name
    #[arg(long, value_name = "NAME")]
    pub view: Option<String>,
    /// Pixels along each side of the frame that rays come from
    #[arg(long, value_name = "N", default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=2048))]
    pub size: u32,
    /// How often each set of rays is traced; the median counts
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    pub rounds: u32,
    /// Rays of each set to check against every triangle
    #[arg(long, value_name = "N", default_value_t = 32)]
    pub check: u32,
    /// No progress bars
    #[arg(long, short)]
    pub quiet: bool,
}

#[derive(clap::Args, Debug)]
pub struct Count {
    /// What to count in; several with spaces
    #[arg(required = true)]
    pub scene: Vec<String>,
    /// Structures, as for build; again or with commas
    #[arg(long, value_delimiter = ',', default_value = crate::count::VARIANTS,
          value_parser = structure)]
    pub structure: Vec<Named>,
    /// Pixels along each side of the frame that rays come from
    #[arg(long, default_value_t = 128, value_parser = clap::value_parser!(u32).range(1..=2048))]
    pub size: u32,
    /// No progress bars
    #[arg(long, short)]
    pub quiet: bool,
}
