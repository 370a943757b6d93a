//! `hug compare`: the structures beside each other. All must give the same hits, bit for bit,
//! and some rays are checked against every triangle.

use crate::args::{Compare, Named};
use crate::{input, progress};
use hug::{Hit, Ray, Scene, Stats};
use hug_bench::clock;
use hug_bench::load::Loaded;
use hug_bench::ray_sets::{RaySets, Set};
use hug_bench::table::Table;

/// One structure, built.
struct Built<'a> {
    named: &'a Named,
    scene: Scene,
    build_seconds: f64,
    /// Of each set, single rays and as a stream: million rays a second.
    rates: Vec<[f64; 2]>,
}

pub fn run(args: &Compare) -> Result<(), String> {
    let loaded = input::load(&args.scene, args.quiet)?;
    let mut all = Vec::new();
    for named in &args.structure {
        let (scene, build_seconds) = input::build(&loaded, &named.options, 1, args.quiet)?;
        all.push(Built { named, scene, build_seconds, rates: Vec::new() });
    }
    let Some(first) = all.first() else { return Err("--structure: none given".to_owned()) };
    let camera = loaded.view(args.view.as_deref())?;
    let sets = RaySets::new(&first.scene.view(), &loaded.bounds, &camera, args.size);
    let bar = progress::bar("tracing", (Set::ALL.len() * all.len()) as u64, args.quiet);
    for set in Set::ALL {
        let rays = sets.get(set);
        let mut agreed: Option<Vec<Hit>> = None;
        for built in &mut all {
            let hits = trace(built, rays, args.rounds);
            let agreed = agreed.get_or_insert_with(|| hits.clone());
            differences(&loaded, set, built.named, rays, agreed, &hits)?;
            bar.inc(1);
        }
        check(args.check, &loaded, set, &all, rays, &agreed.unwrap_or_default())?;
    }
    bar.finish_and_clear();
    print(&loaded, &all, args);
    Ok(())
}

/// Times both kinds of query; the hits of the last.
fn trace(built: &mut Built<'_>, rays: &[Ray], rounds: u32) -> Vec<Hit> {
    let view = built.scene.view();
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    let mut seconds = [Vec::new(), Vec::new()];
    for _ in 0..rounds {
        seconds[0].push(clock::seconds(clock::thread, || {
            for (ray, hit) in rays.iter().zip(&mut hits) {
                *hit = view.intersect(ray);
            }
        }));
        seconds[1].push(clock::seconds(clock::thread, || view.intersect_n(rays, &mut hits)));
    }
    built.rates.push(seconds.map(|mut times| {
        times.sort_by(f64::total_cmp);
        1e-6 * rays.len() as f64 / times[times.len() / 2].max(f64::MIN_POSITIVE)
    }));
    hits
}

fn same(a: &Hit, b: &Hit) -> bool {
    bytemuck::bytes_of(a) == bytemuck::bytes_of(b)
}

fn differences(
    loaded: &Loaded,
    set: Set,
    named: &Named,
    rays: &[Ray],
    expected: &[Hit],
    found: &[Hit],
) -> Result<(), String> {
    match expected.iter().zip(found).position(|(a, b)| !same(a, b)) {
        None => Ok(()),
        Some(i) => Err(format!(
            "{}: {} ray {i} of {}: {} finds another hit: {:?}, not {:?}",
            loaded.name,
            set.name(),
            rays.len(),
            named.name,
            found[i],
            expected[i]
        )),
    }
}

/// So many of the rays, evenly chosen, against every triangle.
fn check(
    count: u32,
    loaded: &Loaded,
    set: Set,
    all: &[Built<'_>],
    rays: &[Ray],
    hits: &[Hit],
) -> Result<(), String> {
    let view = all[0].scene.view();
    for i in (0..rays.len()).step_by(rays.len() / (count.max(1) as usize) + 1).take(count as usize)
    {
        let exact = view.intersect_brute(&rays[i]);
        if !same(&exact, &hits[i]) {
            let what = format!("{} ray {i}: {:?}, not {exact:?}", set.name(), hits[i]);
            return Err(format!("{}: {what}, which is the closest of all triangles", loaded.name));
        }
    }
    Ok(())
}

fn print(loaded: &Loaded, all: &[Built<'_>], args: &Compare) {
    println!("{}: {} triangles", loaded.name, loaded.mesh.indices.len());
    let sets = Set::ALL.map(|set| format!("{}, single / stream", set.name()));
    let head = ["structure", "build, ms", "bytes a triangle"].map(str::to_owned);
    let mut table = Table::new(head.into_iter().chain(sets));
    for built in all {
        let stats = Stats::of(&built.scene.view());
        let each = stats.bytes as f64 / stats.triangles.max(1) as f64;
        let rates = built.rates.iter().map(|[single, stream]| format!("{single:.2} / {stream:.2}"));
        let first = [
            built.named.name.clone(),
            format!("{:.1}", 1e3 * built.build_seconds),
            format!("{each:.1}"),
        ];
        table.row(first.into_iter().chain(rates));
    }
    table.print();
    println!(
        "Million closest-hit rays a second on one thread, median of {}. All structures agree bit for bit; {} rays of each set checked against every triangle.",
        args.rounds, args.check
    );
}
