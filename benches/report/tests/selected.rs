//! Section 7.5 on small input: the tables are whole, and say of counts what their figures give.
#![allow(missing_docs)]

use clap::Parser;
use hug_report::args::Args;
use hug_report::run::run;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

fn args(given: &[&str], out: &str) -> Args {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(out);
    // Of an earlier run; there may be none.
    let _ = fs::remove_dir_all(&folder);
    let path = folder.to_str().expect("a path in letters").to_owned();
    let fixed = ["hug-report", "--quiet", "--rounds", "1", "--out", &path];
    Args::parse_from(fixed.iter().chain(given))
}

type Row = HashMap<String, String>;

fn table(out: &Path, name: &str) -> Vec<Row> {
    let path = out.join(format!("tables/{name}.csv"));
    let mut file = csv::Reader::from_path(path).expect("a table");
    let rows = file.deserialize().collect::<Result<Vec<Row>, _>>();
    rows.expect("as many cells in every row, each column with a name of its own")
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column} of {row:?}"))
}

#[test]
fn tables_and_plots_of_the_kitchen() {
    let given = ["--part", "selected", "--scene", "kit", "--size", "8"];
    let args = args(&[&given[..], &["--curve", "u.f2.ALPHA,auto"]].concat(), "selected");
    let page = run(&args, "as in a test").expect("the report is written");
    let text = fs::read_to_string(page).expect("the page");
    let links = text.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next());
    for link in links.filter(|link| !link.starts_with('#')) {
        assert!(args.out.join(link).is_file(), "{link} is not there");
    }
    assert!(text.contains("<svg") && !args.out.join("pictures").exists());
    let steps = table(&args.out, "kit.selected.steps.measured");
    let exits = table(&args.out, "kit.selected.exits.measured");
    // Two sets of rays each; auto has exit boxes and is nowhere without.
    assert_eq!([steps.len(), exits.len()], [2 * (7 + 8), 2 * (7 + 8 + 1)]);
    assert!(steps.iter().all(|row| row["DS"] != "kit.auto"));
    for row in steps.iter().chain(&exits) {
        let [least, median, most] = ["ns least", "ns", "ns most"].map(|c| number(row, c));
        assert!(0.0 <= least && least <= median && median <= most, "{row:?}");
        assert!(number(row, "bytes") > f64::from(1 << 20) * number(row, "MB"), "{row:?}");
        let both = number(row, "voxels") + number(row, "tests");
        assert!((both - number(row, "both")).abs() < 1e-9, "{row:?}");
    }
    // The same rays cross no more voxels by exit boxes.
    for (plain, jumped) in steps.iter().zip(&exits) {
        assert_eq!((&plain["DS"], &plain["rays"]), (&jumped["DS"], &jumped["rays"]));
        assert!(number(jumped, "voxels") <= number(plain, "voxels"), "{plain:?} {jumped:?}");
    }
    equal_memory_by_work(&args.out, &steps);
    for set in ["primary", "random"] {
        for cost in ["time", "work"] {
            let path = args.out.join(format!("plots/kit.selected.exits.{set}.{cost}.svg"));
            let svg = fs::read_to_string(path).expect("a plot");
            let named = ["rMAXP", "u.f2.ALPHA", "auto"].map(|name| svg.contains(name));
            assert!(svg.starts_with("<svg") && named == [true; 3], "{set}, {cost}");
        }
    }
    let claims = table(&args.out, "claims");
    let building = claims.iter().find(|row| row["claim"].ends_with("building"));
    assert_eq!(building.expect("a claim")["verdict"], "not measured");
    let kitchen = claims.iter().find(|row| row["claim"].ends_with("kitchen"));
    assert_ne!(kitchen.expect("a claim")["verdict"], "not measured");
}

/// The table at equal work from the measured one, with a line between neighbours of its own.
fn equal_memory_by_work(out: &Path, measured: &[Row]) {
    let equal = table(out, "kit.selected.steps.equal_work");
    assert_eq!(equal.len(), 2 * 8);
    let mut compared = 0;
    for row in &equal {
        let same = |r: &&Row| r["rays"] == row["rays"];
        let mut points: Vec<[f64; 2]> = measured
            .iter()
            .filter(|r| r["curve"] == "rMAXP")
            .filter(same)
            .map(|r| [number(r, "MB").log10(), number(r, "both").log10()])
            .collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let at = number(row, "MB").log10();
        let pair = points.windows(2).find(|p| p[0][0] <= at && at <= p[1][0]);
        let Some([a, b]) = pair else {
            assert!(row["times as cheap"].is_empty() && !row["out of range"].is_empty(), "{row:?}");
            continue;
        };
        let recursive = a[1] + (b[1] - a[1]) * (at - a[0]) / (b[0] - a[0]);
        let hug = measured.iter().filter(same).find(|r| r["DS"] == row["DS"]).expect("measured");
        let expected = 10f64.powf(recursive) / number(hug, "both");
        let ours = number(row, "times as cheap");
        assert!((ours / expected - 1.0).abs() < 1e-9, "{ours} instead of {expected}: {row:?}");
        compared += 1;
    }
    assert!(compared > 0, "no HUG in the recursive grid's range");
}

#[test]
fn a_curve_of_one_and_a_scene_of_no_paper() {
    let given = ["--part", "selected", "--scene", "clustered:300", "--size", "4", "--curve", "g4"];
    let args = args(&given, "selected_small");
    run(&args, "as in a test").expect("the report is written");
    let summary = table(&args.out, "selected_summary");
    assert_eq!(summary.len(), 2 * 2 * 2);
    assert!(summary.iter().all(|row| row["curve"] == "g4"));
    let claims = table(&args.out, "claims");
    assert!(!claims.is_empty() && claims.iter().all(|row| row["verdict"] == "not measured"));
}

#[test]
fn parts_and_structures_that_do_not_go_together() {
    for wrong in [
        &["--part", "selected", "--structure", "r50"][..],
        &["--part", "instruments,selected", "--config", "kit.r50"],
        &["--part", "boxes", "--structure", "r50"],
        &["--structure", "r50", "--curve", "g"],
        &["--part", "instruments", "--curve", "g"],
    ] {
        let args = args(wrong, "selected_wrong");
        let error = run(&args, "").expect_err("nothing to measure");
        assert!(error.starts_with("--") && !args.out.exists(), "{error}");
    }
    let given = ["hug-report", "--out", "unused", "--curve", "u.f2.BETA"];
    assert!(Args::try_parse_from(given).is_err());
}
