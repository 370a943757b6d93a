//! The whole report on small input: files that are there, say what they should, and need no other.
#![allow(missing_docs)]

use clap::Parser;
use hug_report::args::Args;
use hug_report::run::run;
use std::fs;
use std::path::PathBuf;

fn folder(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn args(given: &[&str], out: &str) -> Args {
    let folder = folder(out);
    // Of an earlier run; there may be none.
    let _ = fs::remove_dir_all(&folder);
    let path = folder.to_str().expect("a path in letters").to_owned();
    let fixed = ["hug-report", "--quiet", "--rounds", "1", "--out", &path];
    Args::parse_from(fixed.iter().chain(given))
}

/// The cells of a line that begins so.
fn line(table: &str, start: &str) -> Vec<String> {
    let found = table.lines().find(|line| line.starts_with(start));
    let found = found.unwrap_or_else(|| panic!("no {start} in\n{table}"));
    found.split(',').map(str::to_owned).collect()
}

#[test]
fn the_papers_configurations_of_a_small_scene() {
    let args = args(&["--scene", "clustered:400", "--size", "8"], "small");
    let page = run(&args, "as in a test").expect("the report is written");
    let text = fs::read_to_string(&page).expect("the page");
    for part in ["<svg", "data:image/png;base64,", "clustered:400.r50", "Claims", "Heat maps"] {
        assert!(text.contains(part), "no {part}");
    }
    // Nothing is fetched: links lead to the tables beside it, or into the page.
    assert!(!text.contains("src=\"http") && !text.contains("<link") && !text.contains("<script"));
    let links = text.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next());
    for link in links.filter(|link| !link.starts_with('#')) {
        assert!(args.out.join(link).is_file(), "{link} is not there");
    }
    for picture in ["derived", "r50.slice-y", "auto.derived.tests", "u.f3.1.derived.voxels"] {
        let path = args.out.join(format!("pictures/clustered_400.{picture}.png"));
        assert!(fs::read(&path).is_ok_and(|bytes| bytes.starts_with(b"\x89PNG")), "{picture}");
    }
    let figure_4 = fs::read_to_string(args.out.join("tables/figure_4.csv")).expect("figure 4");
    assert_eq!(line(&figure_4, "clustered:400,ours")[2], "400");
    let histogram = fs::read_to_string(args.out.join("tables/clustered_400.r50.histogram.csv"));
    let resources = fs::read_to_string(args.out.join("tables/clustered_400.r50.resources.csv"));
    let voxels: u64 = histogram
        .expect("a histogram")
        .lines()
        .skip(1)
        .flat_map(|line| line.split(',').skip(1).map(|n| n.parse::<u64>().expect("a count")))
        .sum();
    let sums = line(&resources.expect("a table"), "sum,ours");
    assert_eq!(sums[4], voxels.to_string());
    // Every structure has costs, and each predicts every other.
    let table = |name| {
        let path = args.out.join(format!("tables/clustered_400.derived.{name}.csv"));
        fs::read_to_string(path).expect("a table of costs")
    };
    for structure in ["r500", "u.f2.sqrt2", "auto"] {
        let start = format!("clustered:400.{structure}");
        let costs = line(&table("figure_10_top"), &start);
        let nanoseconds = |i: usize| costs[i].parse::<f64>().expect("a number");
        assert!([2, 4, 6].into_iter().all(|i| nanoseconds(i) >= 0.0), "{costs:?}");
        assert_eq!(line(&table("cost_matrix"), &start).len(), 9);
        assert_eq!(line(&table("call_sums"), &start).len(), 13);
    }
}

#[test]
fn claims_are_judged_on_the_kitchen() {
    let given = ["--config", "kit.g28,kit.r50,kit.u.f3.sqrt2,kit.u.f3.1", "--size", "16"];
    let args = args(&given, "claims");
    run(&args, "as in a test").expect("the report is written");
    let claims = fs::read_to_string(args.out.join("tables/claims.csv")).expect("the claims");
    for start in ["About 98 %", "r50: two levels"] {
        let cells = line(&claims, start);
        assert!(cells.iter().any(|cell| cell == "holds"), "{cells:?}");
    }
    // The paper's line stands beside ours.
    let table =
        fs::read_to_string(args.out.join("tables/kit.r50.resources.csv")).expect("figure 17");
    assert_eq!(line(&table, "2,paper")[2], "70.4");
    assert_eq!(line(&table, "sum,paper")[5], "196232");
}

#[test]
fn what_is_asked_for() {
    let jobs = |given: &[&str]| {
        let jobs = args(given, "unused").jobs();
        let text = |n: &hug_bench::notation::Notation| n.to_string();
        jobs.iter()
            .map(|job| (job.scene.clone(), job.structures.iter().map(text).collect::<Vec<_>>()))
            .collect::<Vec<_>>()
    };
    let of = |scene: &str, structures: &[&str]| {
        (scene.to_owned(), structures.iter().map(|&s| s.to_owned()).collect::<Vec<_>>())
    };
    let four = ["kitchen", "building", "city", "garden"].map(|scene| of(scene, &[]));
    assert_eq!(jobs(&[]), four);
    assert_eq!(jobs(&["--scene", "kit,kitchen,city"]), [of("kitchen", &[]), of("city", &[])]);
    assert_eq!(
        jobs(&["--config", "kit.r50,csbc.u.f3.1", "--config", "kit.r500"]),
        [of("kitchen", &["r50", "r500"]), of("building", &["u.f3.1"])]
    );
    assert_eq!(
        jobs(&["--scene", "city", "--structure", "g28", "--config", "city.auto"]),
        [of("city", &["g28", "auto"])]
    );
}

#[test]
fn bad_input_has_an_error() {
    for wrong in [
        &["--scene", "no such scene"][..],
        &["--config", "no_such_scene.r50"],
        &["--config", "clustered:200.g2000"],
    ] {
        let error = run(&args(wrong, "wrong"), "").expect_err("nothing to measure");
        assert!(error.contains(": "), "{error}");
    }
    for wrong in [&["--size", "0"][..], &["--structure", "r0"], &["--config", "kit"], &["--x"]] {
        let given = ["hug-report", "--out", "unused"].iter().chain(wrong);
        assert!(Args::try_parse_from(given).is_err(), "{wrong:?}");
    }
}
