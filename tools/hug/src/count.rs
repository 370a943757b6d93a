//! `hug count`: what section 7's options change, counted, so that it is the same on every machine.

mod means;

use self::means::Means;
use crate::args::{Count, Named};
use crate::input;
use hug::build::Survey;
use hug::{Advice, Counters, Options, Ray, Scene, Stats, Structure, View};
use hug_bench::load::Loaded;
use hug_bench::ray_sets::{RaySets, Set};
use hug_bench::table::Table;

/// What is counted unless asked otherwise.
pub const VARIANTS: &str = "auto,recursive,uniform,uniform+overlap,uniform+mixed,hug,\
    hug+world=1.4142135,hug+components,hug+components+world=1.4142135,\
    hug+components+homogeneous,hug+components+overlap,hug+components+mixed";

const SETS: [Set; 2] = [Set::Primary, Set::Random];

pub fn run(args: &Count) -> Result<(), String> {
    let mut means = Means::default();
    for name in &args.scene {
        let loaded = input::load(name, args.quiet)?;
        let advised = advice(&loaded)?;
        survey(&loaded)?;
        let camera = loaded.view(None)?;
        let plain = loaded.build(&Options::default())?;
        let sets = RaySets::new(&plain.view(), &loaded.bounds, &camera, args.size);
        let head = ["structure", "%vol", "grids", "references", "B/tri"].map(str::to_owned);
        let figures = SETS.iter().flat_map(|set| {
            ["grids", "voxels", "tests"].map(|what| format!("{}: {what}", set.name()))
        });
        let mut table = Table::new(head.into_iter().chain(figures));
        for named in args.structure.iter().chain([&advised]) {
            let (scene, _) = input::build(&loaded, &named.options, 1, args.quiet)?;
            let counted = Counted::of(&scene, &sets);
            table.row(row(&named.name, &counted));
            // What is advised is another structure for every scene, but one way to choose it.
            let advice = std::ptr::eq(named, &advised);
            means.add(if advice { "advised" } else { &named.name }, &counted);
        }
        table.print();
    }
    if args.scene.len() > 1 {
        means.print(args.scene.len());
    }
    Ok(())
}

/// What both clusterings make of the scene's triangles, by the defaults.
fn survey(loaded: &Loaded) -> Result<(), String> {
    let options = Options { structure: Structure::Hug, ..Options::default() };
    let survey = Survey::new(&loaded.soup(), &options)
        .map_err(|error| format!("{}: {error}", loaded.name))?;
    println!(
        "{}: {} triangles, {} in level 0; {} pairs of these meet in the plane, of which {:.1} % \
         not along z",
        loaded.name,
        survey.triangles,
        survey.filtered,
        survey.plane_pairs,
        100.0 * survey.denied()
    );
    for (name, of) in [("projections", survey.projections), ("components", survey.components)] {
        println!(
            "{name}: {} clusters, {} of them grids of {} triangles, %vol {:.1}",
            of.clusters,
            of.grids,
            of.objects,
            100.0 * of.volume
        );
    }
    println!();
    Ok(())
}

/// What is to be built, and why.
fn advice(loaded: &Loaded) -> Result<Named, String> {
    let of = |error| format!("{}: {error}", loaded.name);
    let advice = Advice::of(&loaded.soup()).map_err(of)?;
    let name = match advice.structure {
        Structure::Hug => format!("advised: {:?}, {:?}", advice.filter, advice.clustering),
        other => format!("advised: {other:?}"),
    };
    println!(
        "{}: {}; small {:.3}, variation {:.2}, cells {:.3} of {:.3}, crowding {:.2}",
        loaded.name,
        advice.reason.message().to_string_lossy(),
        advice.small,
        advice.variation,
        advice.occupied,
        advice.expected,
        advice.crowding
    );
    Ok(Named { name, options: advice.options(Options::default()) })
}

/// What was counted of a structure.
struct Counted {
    stats: Stats,
    /// Grids of these, turned.
    turned: usize,
    /// Grids tested, voxels traversed and triangles tested, a ray of each of [`SETS`].
    rays: [[f64; 3]; SETS.len()],
}

impl Counted {
    fn of(scene: &Scene, sets: &RaySets) -> Self {
        let view = scene.view();
        let shapes = (0..view.grid_count()).filter_map(|number| view.grid_shape(number));
        Self {
            stats: Stats::of(&view),
            turned: shapes.filter(|shape| shape.frame.is_some()).count(),
            rays: SETS.map(|set| count(&view, sets.get(set))),
        }
    }

    /// Of the arena.
    fn bytes(&self) -> f64 {
        self.stats.bytes as f64 / self.stats.triangles.max(1) as f64
    }
}

fn row(name: &str, counted: &Counted) -> Vec<String> {
    let total = &counted.stats.total;
    let turned = match counted.turned {
        0 => String::new(),
        n => format!(", {n} turned"),
    };
    let mut cells = vec![
        name.to_owned(),
        format!("{:.1}", 100.0 * total.volume),
        format!("{}{turned}", total.grids),
        total.pointers().to_string(),
        format!("{:.1}", counted.bytes()),
    ];
    cells.extend(counted.rays.iter().flatten().map(|x| format!("{x:.2}")));
    cells
}

fn count(view: &View<'_>, rays: &[Ray]) -> [f64; 3] {
    let mut sum = Counters::default();
    for ray in rays {
        view.intersect_counted(ray, &mut sum);
    }
    [sum.grids, sum.voxels, sum.tests].map(|n| n as f64 / rays.len().max(1) as f64)
}
