//! The tables.

use super::measure::{Point, RayCost};
use hug_bench::fit;
use hug_bench::table::Table;

/// Fits start here: below it constant costs and the caches say more than growth does.
const FIT_FROM: f64 = 1e4;

fn name(point: &Point) -> String {
    format!("{}, {}", point.family, point.kind.name())
}

fn count(point: &Point) -> String {
    format!("{:.0}", point.triangles)
}

/// Build time, and what a ray costs.
pub fn growth(points: &[Point]) {
    let mut table = Table::new([
        "family, structure",
        "triangles",
        "build ms",
        "random ns",
        "steps",
        "grids",
        "tests",
        "primary ns",
        "steps",
        "grids",
        "tests",
    ]);
    for point in points {
        let mut row = vec![name(point), count(point)];
        row.push(format!("{:.2}", 1e3 * point.build_seconds));
        for cost in [&point.random, &point.primary] {
            let RayCost { nanoseconds, voxels, grids, tests } = cost;
            row.push(format!("{nanoseconds:.0}"));
            row.extend([voxels, grids, tests].map(|count| format!("{count:.2}")));
        }
        table.row(row);
    }
    table.print();
}

/// Bytes a triangle, by section of the arena.
pub fn memory(points: &[Point]) {
    let mut table = Table::new([
        "family, structure",
        "triangles",
        "arena bytes",
        "B/tri",
        "grids",
        "voxels",
        "references",
        "triangles",
    ]);
    for point in points {
        let stats = &point.stats;
        let per_triangle = |bytes: u64| format!("{:.1}", bytes as f64 / point.triangles);
        let mut row = vec![name(point), count(point), stats.bytes.to_string()];
        let sections = [
            stats.bytes,
            stats.grid_bytes,
            stats.voxel_bytes,
            stats.ref_bytes,
            stats.triangle_bytes,
        ];
        row.extend(sections.map(per_triangle));
        table.row(row);
    }
    table.print();
}

/// The power p of each figure, from the least size that fits start at.
pub fn exponents(points: &[Point]) {
    println!("Exponents p of n^p, n the number of triangles, from {FIT_FROM:.0} triangles up\n");
    let figures: [fn(&Point) -> f64; 6] = [
        |p| p.build_seconds,
        |p| p.stats.bytes as f64,
        |p| p.random.nanoseconds,
        |p| p.random.voxels + p.random.tests,
        |p| p.primary.nanoseconds,
        |p| p.primary.voxels + p.primary.tests,
    ];
    let mut table = Table::new([
        "family, structure",
        "build time",
        "bytes",
        "random ns",
        "steps + tests",
        "primary ns",
        "steps + tests",
    ]);
    let mut names: Vec<String> = Vec::new();
    for point in points {
        if !names.contains(&name(point)) {
            names.push(name(point));
        }
    }
    for series in names {
        let fitted: Vec<&Point> =
            points.iter().filter(|p| p.triangles >= 0.99 * FIT_FROM && name(p) == series).collect();
        let power = |figure: fn(&Point) -> f64| {
            let line: Vec<_> = fitted.iter().map(|p| (p.triangles, figure(p))).collect();
            fit::exponent(&line).map_or_else(|| "-".to_owned(), |p| format!("{p:.3}"))
        };
        let cells: Vec<String> = figures.into_iter().map(power).collect();
        table.row(std::iter::once(series).chain(cells));
    }
    table.print();
}
