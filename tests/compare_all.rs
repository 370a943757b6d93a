//! The C program `compare` on every scene at once: the built-in ones, and folders.
#![allow(missing_docs)]
#![cfg(feature = "capi")]

mod common;

use common::compare::{Row, SMALL, printed, rows, run, set, values};
use common::native::target;
use std::fs;
use std::path::PathBuf;

/// Geometric means and minima are those of the rows above them.
#[test]
fn all_built_in_scenes_are_summed_up() {
    let arguments = [&SMALL[..], &["--all", "--views", "all", "--query", "single"]].concat();
    let rows = rows(&printed(None, &arguments));
    let sums = ["geomean", "minimum"];
    let (sums, rows): (Vec<Row>, Vec<Row>) =
        rows.into_iter().partition(|row| sums.contains(&&*row["scene"]));
    let scenes = ["building", "building_walls", "city", "garden", "kitchen"];
    assert_eq!(values(&rows, &["scene"]), set(&scenes));
    assert_eq!(values(&rows, &["structure"]), set(&["auto", "hug", "recursive", "uniform"]));
    // Every view has primary rays; random rays are the same in all.
    assert!(values(&rows, &["scene", "view"]).len() > scenes.len());
    assert_eq!(rows.iter().filter(|row| row["rays"] == "random").count(), 4 * scenes.len());
    assert_eq!(sums.iter().filter(|sum| sum["query"] == "build").count(), 2 * 5);
    for sum in sums.iter().filter(|sum| sum["query"] != "build") {
        let same = |row: &&Row| ["structure", "rays"].iter().all(|c| row[c] == sum[c]);
        let ratio = |row: &Row| row["ratio"].parse::<f64>().expect("a ratio");
        let ratios: Vec<f64> = rows.iter().filter(same).map(ratio).collect();
        assert_eq!(sum["number"], ratios.len().to_string());
        let expected = if sum["scene"] == "minimum" {
            ratios.iter().copied().fold(f64::INFINITY, f64::min)
        } else {
            (ratios.iter().map(|r| r.ln()).sum::<f64>() / ratios.len() as f64).exp()
        };
        // The rows have four digits after the point, of ratios around a tenth.
        assert!((ratio(sum) - expected).abs() <= 0.01 * expected + 2e-4, "{sum:?}, {expected}");
    }
}

/// Two tetrahedra in a folder of their own; views for one of them.
fn folder(name: &str, json: Option<&str>) -> PathBuf {
    let folder = target().join("scenes").join(name);
    // Of an earlier run; there may be none.
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a new folder");
    let faces = "f 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n";
    for (file, size) in [("small.obj", 1), ("large.obj", 1000)] {
        let corners = [[0, 0, 0], [size, 0, 0], [0, size, 0], [0, 0, size]];
        let line = |[x, y, z]: &[i32; 3]| format!("v {x} {y} {z}\n");
        let vertices: String = corners.iter().map(line).collect();
        fs::write(folder.join(file), vertices + faces).expect("a new file");
    }
    if let Some(json) = json {
        fs::write(folder.join("scenes.json"), json).expect("a new file");
    }
    folder
}

const VIEWS: &str = r#"[
    {"file": "small.obj", "views": [
        {"name": "front", "eye": [0.3, 0.3, 3], "at": [0.3, 0.3, 0], "up": [0, 1, 0], "fov_deg": 30},
        {"name": "above", "eye": [0.3, 3, 0.3], "at": [0.3, 0, 0.3], "up": [0, 0, 1], "fov_deg": 30}]},
    {"file": "large.obj"}]"#;

/// The order is that of scenes.json, or of the names; a scene without a view gets one.
#[test]
fn a_folder_is_gone_through() {
    let listed = folder("listed", Some(VIEWS));
    for (views, expected) in [
        ("first", &["small front", "large derived"][..]),
        ("all", &["small front", "small above", "large derived"]),
    ] {
        let csv = printed(Some(&listed), &[&SMALL[..], &["--all", "--views", views]].concat());
        let mut rows = rows(&csv);
        rows.retain(|row| !["geomean", "minimum"].contains(&&*row["scene"]));
        let mut order: Vec<String> =
            rows.iter().map(|row| format!("{} {}", row["scene"], row["view"])).collect();
        order.dedup();
        assert_eq!(order, expected);
    }
    let plain = folder("plain", None);
    let found = rows(&printed(Some(&plain), &[&SMALL[..], &["--all"]].concat()));
    assert_eq!(found[0]["scene"], "large");
    let scenes = values(&found, &["scene"]);
    assert_eq!(scenes, set(&["geomean", "large", "minimum", "small"]));
}

/// What is pasted elsewhere names no folder of this machine, nor does the progress.
#[test]
fn tables_name_no_path() {
    let listed = folder("pasted", Some(VIEWS));
    for form in [&["--markdown"][..], &["--csv"], &[]] {
        let arguments = [&["--all", "--size", "16", "--rounds", "1"], form].concat();
        let output = run(Some(&listed), &arguments);
        assert!(output.status.success(), "{form:?}");
        for said in [output.stdout, output.stderr] {
            let said = String::from_utf8_lossy(&said).into_owned();
            assert!(!said.contains("pasted") && !said.contains(".."), "{form:?}: {said}");
        }
    }
    let file = listed.join("small.obj");
    let file = file.to_str().expect("a path in UTF-8");
    let tables = printed(None, &["--markdown", "--size=16", "--rounds", "1", "--scene", file]);
    assert!(!tables.contains("pasted"), "{tables}");
    assert!(tables.contains("`compare --markdown --size=16 --rounds 1 --scene small.obj`"));
    for part in ["- Machine: ", "- Date: ", "scene by scene", "Geometric means", "Builds of "] {
        assert!(tables.contains(part), "no {part} in\n{tables}");
    }
}

/// The scenes that are there are measured; the exit status tells of the other.
#[test]
fn a_missing_scene_fails_at_the_end() {
    let json = r#"[{"file": "gone.obj"}, {"file": "small.obj"}]"#;
    let output = run(Some(&folder("gone", Some(json))), &[&SMALL[..], &["--all"]].concat());
    assert_eq!(output.status.code(), Some(1));
    let found = rows(&String::from_utf8_lossy(&output.stdout));
    assert_eq!(values(&found, &["scene"]), set(&["geomean", "minimum", "small"]));
}

#[test]
fn bad_folders_are_refused() {
    let empty = target().join("scenes/empty");
    fs::create_dir_all(&empty).expect("a new folder");
    let folders = [
        empty.clone(),
        empty.join("nowhere"),
        folder("no_json", Some("{")),
        folder("no_file", Some(r#"[{"name": "small"}]"#)),
    ];
    for folder in folders {
        let output = run(Some(&folder), &["--all"]);
        assert_eq!(output.status.code(), Some(1), "{folder:?}");
        assert!(!output.stderr.is_empty(), "{folder:?}: nothing said");
    }
}
