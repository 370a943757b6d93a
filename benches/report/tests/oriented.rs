//! Section 7.2 on small input: ratios, what rays meet, and the files that say so.
#![allow(missing_docs)]

use clap::Parser;
use hug::{GridFrame, GridShape, Ray};
use hug_report::args::Args;
use hug_report::oriented::Ratios;
use hug_report::oriented::boxes::{CLASSES, START, WIDTH, beside_one, histogram, median};
use hug_report::oriented::steps::meets;
use hug_report::run::run;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

type Row = HashMap<String, String>;

fn table(out: &Path, name: &str) -> Vec<Row> {
    let mut file = csv::Reader::from_path(out.join(format!("tables/{name}.csv"))).expect("a table");
    file.deserialize().collect::<Result<_, _>>().expect("as many cells in every row")
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column} of {row:?}"))
}

#[test]
fn ratios_of_boxes() {
    let cube = Ratios::new([1.0; 3], [2.0, 1.0, 1.0]);
    assert_eq!(cube, Ratios { surface: Some(5.0 / 3.0), volume: Some(2.0) });
    // A wall along the axes, which has no volume but the room that its grid gets.
    let room = 1e-6;
    let wall = Ratios::new([2.0, 2.0, room], [4.0, 2.0, 2.0 * room]);
    assert_eq!(wall, Ratios { surface: Some(2.0), volume: None });
    // A wall at an angle is flat only in a turned box.
    let slanted = Ratios::new([1.0, 1.0, 1.0], [1.5, 1.0, room]);
    assert_eq!(slanted, Ratios { surface: Some(0.5), volume: Some(0.0) });
    let lost = Ratios::new([1.5, 1.0, room], [1.0; 3]);
    assert_eq!(lost.volume, Some(f64::INFINITY));
    assert_eq!(Ratios::new([1.0, room, room], [1.0, room, room]).surface, None);
}

#[test]
fn classes_and_shares() {
    let ratios = [0.0, 0.5, 0.999_999, 1.000_001, 1.2, 3.01, 3.5, f64::INFINITY];
    let counts = histogram(&ratios);
    assert_eq!(counts.len(), CLASSES);
    let class = |ratio: f64| counts[((ratio - START) / WIDTH) as usize];
    // What is 1 but for rounding is in one class, and what is too large in none.
    assert_eq!([class(0.0), class(0.5), class(1.0), class(1.2), class(3.0)], [1, 1, 2, 1, 1]);
    assert_eq!(counts.iter().sum::<u64>(), 6);
    assert_eq!(beside_one(&ratios), [25.0, 25.0, 50.0]);
    assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
    assert_eq!(median(vec![3.0, 1.0]), Some(2.0));
    assert_eq!(median(vec![]), None);
}

#[test]
fn rays_and_turned_boxes() {
    let straight =
        GridShape { lower: [-1.0; 3], upper: [1.0; 3], counts: [1; 3], level: 0, frame: None };
    let half = 0.5_f64.sqrt();
    let axes = [[half, half, 0.0], [-half, half, 0.0], [0.0, 0.0, 1.0]];
    let turned = GridShape { frame: Some(GridFrame { axes, origin: [0.0; 3] }), ..straight };
    let at = |x: f32| Ray::new([x, -5.0, 0.25], [0.0, 1.0, 0.0]);
    let both = |ray: &Ray, end: f64| [&straight, &turned].map(|shape| meets(shape, ray, end));
    assert_eq!(both(&at(0.0), 100.0), [true, true]);
    // Past the cube's side, but not past the corner that points this way.
    assert_eq!(both(&at(1.2), 100.0), [false, true]);
    assert_eq!(both(&at(1.5), 100.0), [false, false]);
    // Its corner is nearer, too.
    assert_eq!(both(&at(0.0), 3.8), [false, true]);
    assert_eq!(both(&at(0.0), 3.5), [false, false]);
    let behind = Ray { tmin: 6.2, ..at(0.0) };
    assert_eq!(both(&behind, 100.0), [false, true]);
}

fn args(given: &[&str], out: &str) -> Args {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(out);
    // Of an earlier run; there may be none.
    let _ = fs::remove_dir_all(&folder);
    let path = folder.to_str().expect("a path in letters").to_owned();
    let fixed = ["hug-report", "--quiet", "--rounds", "1", "--out", &path];
    Args::parse_from(fixed.iter().chain(given))
}

#[test]
fn figure_25_of_the_kitchen() {
    let args = args(&["--part", "boxes", "--scene", "kit", "--size", "16"], "boxes");
    let page = run(&args, "as in a test").expect("the report is written");
    let text = fs::read_to_string(page).expect("the page");
    let links = text.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next());
    for link in links.filter(|link| !link.starts_with('#')) {
        assert!(args.out.join(link).is_file(), "{link} is not there");
    }
    assert!(text.contains("<svg") && !args.out.join("pictures").exists());
    let boxes = table(&args.out, "kit.figure_25");
    // Two clusterings, three kinds of axes, surface and volume.
    assert_eq!(boxes.len(), 2 * 3 * 2);
    for row in &boxes {
        let shares = ["% smaller", "% same", "% larger"].map(|column| number(row, column));
        assert!((shares.iter().sum::<f64>() - 100.0).abs() < 1e-9, "{row:?}");
        assert!(number(row, "ratios") > 100.0, "{row:?}");
    }
    let larger = |along: &str| {
        let found = boxes.iter().find(|row| row["along"] == along && row["of"] == "surface");
        number(found.expect("a row"), "% larger")
    };
    // Axes that were not searched for can be worse; those that were begin with the aligned ones.
    assert!(larger("vertices") > 10.0 && larger("search") < 5.0);
    let histogram = table(&args.out, "kit.figure_25.histogram");
    assert_eq!(histogram.len(), CLASSES);
    let column = "u.f3.sqrt2 vertices surface";
    let sum: f64 = histogram.iter().map(|row| number(row, column)).sum();
    assert_eq!(sum, number(&boxes[0], "ratios"), "none is above 3");
    let rays = table(&args.out, "kit.turned_rays");
    assert_eq!(rays.len(), 2 * 4 * 2);
    for pair in rays.chunks(8) {
        let (aligned, search) = (&pair[0], &pair[6]);
        assert_eq!((&*aligned["along"], &*search["along"]), ("aligned", "search"));
        assert_eq!(number(aligned, "% turned"), 0.0);
        // A grid is referred to, and so tested, wherever its aligned box is.
        assert_eq!(aligned["box tests"], search["box tests"]);
        assert!(number(aligned, "boxes met") <= number(aligned, "box tests"));
    }
    let claims = table(&args.out, "claims");
    assert!(claims.len() == 3 && claims.iter().all(|row| row["verdict"] != "not measured"));
}
