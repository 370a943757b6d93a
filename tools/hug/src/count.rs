//! `hug count`: what section 7's options change, counted, so that it is the same on every machine.

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
            table.row(row(named, &scene, &sets));
        }
        table.print();
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

fn row(named: &Named, scene: &Scene, sets: &RaySets) -> Vec<String> {
    let view = scene.view();
    let stats = Stats::of(&view);
    let mut cells = vec![
        named.name.clone(),
        format!("{:.1}", 100.0 * stats.total.volume),
        stats.total.grids.to_string(),
        stats.total.pointers().to_string(),
        format!("{:.1}", stats.bytes as f64 / stats.triangles.max(1) as f64),
    ];
    for set in SETS {
        let counted = count(&view, sets.get(set));
        cells.extend(counted.map(|x| format!("{x:.2}")));
    }
    cells
}

/// Grids entered, voxels traversed and tests made, a ray.
fn count(view: &View<'_>, rays: &[Ray]) -> [f64; 3] {
    let mut sum = Counters::default();
    for ray in rays {
        view.intersect_counted(ray, &mut sum);
    }
    [sum.grids, sum.voxels, sum.tests].map(|n| n as f64 / rays.len().max(1) as f64)
}
