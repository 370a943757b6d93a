//! The C program `compare`, and what it prints taken apart.

use super::native::{kit, library, make, require_packages};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
    require_packages();
    library("staticlib", &["--features", "capi"], "release");
    kit();
    make("c", &["compare"]).join("compare")
});

/// Runs it with the folder of scenes, or none.
pub fn run(folder: Option<&Path>, arguments: &[&str]) -> Output {
    let mut compare = Command::new(&*PROGRAM);
    // Libraries that cargo put in the way of ours.
    compare.env_remove("LD_LIBRARY_PATH").env_remove("HUG_SCENES").args(arguments);
    if let Some(folder) = folder {
        compare.env("HUG_SCENES", folder);
    }
    compare.output().expect("compare was built")
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// What it printed, once its exit status says that nothing was decided against us.
#[track_caller]
pub fn printed(folder: Option<&Path>, arguments: &[&str]) -> String {
    let output = run(folder, arguments);
    let err = text(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {}\n{err}", output.status);
    // The arbiter's verdicts, a line a kind of difference: the last column counts
    // those against us.
    for line in err.lines().filter(|line| line.split_whitespace().count() > 4) {
        let structure = line.split_whitespace().next();
        if matches!(structure, Some("auto" | "uniform" | "recursive" | "hug")) {
            assert_eq!(line.split_whitespace().last(), Some("0"), "{arguments:?}: {line}");
        }
    }
    text(&output.stdout)
}

pub const COLUMNS: &str = "scene,triangles,structure,rays,query,isa,hug_mrays,embree_mrays,ratio,\
    ratio_min,ratio_max,hug_build_ms,embree_build_ms,hug_bytes,embree_bytes,hit_mismatch,\
    t_mismatch,prim_mismatch,view,number,hug_build_wall_ms,embree_build_wall_ms,build_ratio,\
    bytes_per_triangle,grid_bytes,voxel_bytes,ref_bytes,triangle_bytes";

const NOT_NUMBERS: [&str; 6] = ["scene", "structure", "rays", "query", "isa", "view"];

pub type Row = BTreeMap<&'static str, String>;

/// The rows by column; what is no name is a number of 0 or more, or empty.
#[track_caller]
pub fn rows(csv: &str) -> Vec<Row> {
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some(COLUMNS));
    let columns: Vec<&'static str> = COLUMNS.split(',').collect();
    let row = |line: &str| {
        let fields: Vec<String> = line.split(',').map(str::to_owned).collect();
        assert_eq!(fields.len(), columns.len(), "{line}");
        let row: Row = columns.iter().copied().zip(fields).collect();
        for (column, field) in row.iter().filter(|(column, _)| !NOT_NUMBERS.contains(*column)) {
            let value = field.parse::<f64>();
            let good = field.is_empty() || value.is_ok_and(|v| v.is_finite() && v >= 0.0);
            assert!(good, "{column}: {line}");
        }
        row
    };
    lines.map(row).collect()
}

/// The different values of some columns, together.
pub fn values(rows: &[Row], columns: &[&str]) -> BTreeSet<String> {
    let join = |row: &Row| columns.iter().map(|c| row[c].as_str()).collect::<Vec<_>>().join(" ");
    rows.iter().map(join).collect()
}

pub fn set(values: &[&str]) -> BTreeSet<String> {
    values.iter().copied().map(str::to_owned).collect()
}

/// Quick, and enough to see every row.
pub const SMALL: [&str; 5] = ["--csv", "--size", "16", "--rounds", "2"];
