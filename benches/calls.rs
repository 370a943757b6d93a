//! What a call costs when there is nothing to traverse: through the Rust interface, and through
//! the C interface as C calls it. Nanoseconds.

#[path = "calls/abi.rs"]
mod abi;
#[path = "calls/cases.rs"]
mod cases;

use abi::Handle;
use cases::Case;
use clap::Parser;
use hug::Hit;
use hug_bench::args::{self, Cargo};
use hug_bench::figures::Spread;
use hug_bench::kind::Kind;
use hug_bench::rounds::{self, Contender};
use hug_bench::table::Table;
use hug_bench::{clock, machine};
use std::hint::black_box;
use std::process::ExitCode;

/// The fixed cost of a call, in nanoseconds.
#[derive(Parser)]
struct Args {
    /// The structure to put one triangle in
    #[arg(long, value_enum, default_value = "auto")]
    structure: Kind,
    /// Calls a round
    #[arg(long, default_value_t = 1 << 18, value_parser = clap::value_parser!(u64).range(1..))]
    calls: u64,
    /// Rounds
    #[arg(long, default_value_t = 15, value_parser = clap::value_parser!(u64).range(1..))]
    rounds: u64,
    #[command(flatten)]
    cargo: Cargo,
}

/// Rays a case: enough that no branch predictor knows them by heart, few enough for the caches.
const RAYS: usize = 1 << 12;

/// A case through one query of both interfaces.
fn contenders(case: &Case, occlusion: bool) -> [Contender<'_>; 2] {
    let (view, handle) = (case.scene.view(), Handle::new(&case.scene));
    let mut hits = vec![Hit::miss(0.0); case.rays.len()];
    let mut own_hits = hits.clone();
    if occlusion {
        [
            over(case, move |i| usize::from(view.occluded(&case.rays[i]))),
            over(case, move |i| usize::from(handle.occluded(&case.rays[i]))),
        ]
    } else {
        [
            over(case, move |i| {
                own_hits[i] = view.intersect(&case.rays[i]);
                usize::from(own_hits[i].is_hit())
            }),
            over(case, move |i| usize::from(handle.intersect(&case.rays[i], &mut hits[i]))),
        ]
    }
}

/// Calls `query` with the number of one ray after another, and makes sure that the rays end as
/// the case says.
fn over<'a>(case: &'a Case, mut query: impl FnMut(usize) -> usize + 'a) -> Contender<'a> {
    Box::new(move |calls| {
        let mut found = 0;
        for call in 0..calls {
            found += query(call % RAYS);
        }
        let expected = if case.hits { calls } else { 0 };
        assert_eq!(black_box(found), expected, "{}: rays that hit", case.what);
    })
}

fn run(args: &Args) -> Result<(), String> {
    let cases = cases::all(RAYS, &args.structure.options())?;
    let queries = || cases.iter().flat_map(|case| [(case, false), (case, true)]);
    let mut all: Vec<Contender<'_>> =
        queries().flat_map(|(case, occlusion)| contenders(case, occlusion)).collect();
    let calls = args.calls as usize;
    let seconds = rounds::run(&mut all, calls, args.rounds as usize, clock::thread);
    println!("{}\n", machine::line());
    println!(
        "Nanoseconds a call: medians, least and most of {} rounds of {calls} calls\n",
        args.rounds
    );
    let mut table = Table::new(["case", "query", "Rust", "least - most", "C", "least - most"]);
    for ((case, occlusion), seconds) in queries().zip(seconds.chunks(2)) {
        let query = if occlusion { "occluded" } else { "intersect" };
        let mut row = vec![case.what.to_owned(), query.to_owned()];
        for side in seconds {
            let nanoseconds = Spread::of(side.iter().copied()).times(1e9 / calls as f64);
            row.extend([format!("{:.1}", nanoseconds.median), nanoseconds.range(1)]);
        }
        table.row(row);
    }
    table.print();
    Ok(())
}

fn main() -> ExitCode {
    args::finish(run(&Args::parse()))
}
