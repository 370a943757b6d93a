//! `hug info`.

use crate::args::Info;
use crate::input::Input;
use hug::{Lengths, Level, Stats};
use hug_bench::table::Table;

pub fn run(args: &Info) -> Result<(), String> {
    let input = Input::new(&args.scene, &args.how, args.quiet)?;
    let view = input.view()?;
    let stats = Stats::of(&view);
    let (lower, upper) = view.bounds();
    println!("{}", args.scene);
    println!("structure    {:?}, {} levels", stats.structure, stats.levels().len());
    println!("box          {lower:?} to {upper:?}");
    println!("outer grid   {} x {} x {} voxels", stats.counts[0], stats.counts[1], stats.counts[2]);
    println!(
        "triangles    {} (left out: {} without area, {} not finite)",
        stats.triangles, stats.dropped_degenerate, stats.dropped_non_finite
    );
    let lengths = Lengths::of(&view);
    println!(
        "lengths      shortest / longest {:.2e}; below a fifth of the longest {:.2} %",
        lengths.min_over_max(),
        lengths.percent_below_fifth()
    );
    println!();
    sections(&stats);
    levels(&stats);
    Ok(())
}

fn sections(stats: &Stats) {
    let mut table = Table::new(["section", "bytes", "of all, %", "a triangle"]);
    let listed = [
        ("triangles", stats.triangle_bytes),
        ("grids", stats.grid_bytes),
        ("voxels", stats.voxel_bytes),
        ("references", stats.ref_bytes),
        ("tree of boxes", stats.node_bytes),
    ];
    let rest = stats.bytes - listed.iter().map(|section| section.1).sum::<u64>();
    for (name, bytes) in listed.into_iter().chain([("header, gaps", rest), ("all", stats.bytes)]) {
        let share = 100.0 * bytes as f64 / stats.bytes as f64;
        let each = bytes as f64 / stats.triangles.max(1) as f64;
        table.row([
            name.to_owned(),
            bytes.to_string(),
            format!("{share:.1}"),
            format!("{each:.2}"),
        ]);
    }
    table.print();
}

fn levels(stats: &Stats) {
    let mut table = Table::new([
        "level",
        "grids",
        "voxels",
        "with triangles, %",
        "with grids, %",
        "triangles",
        "references",
        "a filled voxel",
        "bytes",
    ]);
    for (number, level) in stats.levels().iter().enumerate() {
        table.row(row(number.to_string(), level));
    }
    table.row(row("all".to_owned(), &stats.total));
    table.print();
}

fn row(name: String, level: &Level) -> [String; 9] {
    let percent = |part: u64| format!("{:.1}", 100.0 * part as f64 / level.voxels.max(1) as f64);
    [
        name,
        level.grids.to_string(),
        level.voxels.to_string(),
        percent(level.object_voxels),
        percent(level.grid_voxels),
        level.objects.to_string(),
        level.pointers().to_string(),
        format!("{:.2}", level.objects_per_filled_voxel().mean),
        level.bytes.to_string(),
    ]
}
