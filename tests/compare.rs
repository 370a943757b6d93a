//! The C program `compare`: what it prints, that it agrees with Embree, and that it
//! says no to what makes no sense. Speed is not looked at.
#![allow(missing_docs)]
#![cfg(feature = "capi")]

mod common;

use common::compare::{COLUMNS, Row, SMALL, printed, rows, run, set, values};
use std::fs;
use std::path::PathBuf;

fn agrees(scene: &str, size: &str) {
    let arguments = ["--scene", scene, "--size", size, "--rounds", "1", "--csv"];
    let rows = rows(&printed(None, &arguments));
    assert!(rows.iter().all(|row| row.values().all(|field| !field.is_empty())), "{scene}");
    let found = values(&rows, &["structure", "rays", "query"]);
    assert_eq!(found.len(), 3 * 5 * 2, "{scene}");
    for structure in ["uniform", "recursive", "hug"] {
        for rays in ["primary", "bounce1", "bounce2", "random"] {
            for query in ["closest", "closest_stream"] {
                assert!(found.contains(&format!("{structure} {rays} {query}")), "{scene}");
            }
        }
        for query in ["occluded", "occluded_stream"] {
            assert!(found.contains(&format!("{structure} shadow {query}")), "{scene}");
        }
    }
}

#[test]
fn agrees_with_embree_on_built_in_scenes() {
    for scene in ["kitchen", "building", "building_walls", "city", "garden"] {
        agrees(scene, "64");
    }
}

/// On the two smallest scenes of the folder that `HUG_SCENES` names, if it does.
#[test]
fn agrees_with_embree_on_real_scenes() {
    let Some(folder) = std::env::var_os("HUG_SCENES").filter(|folder| !folder.is_empty()) else {
        println!("HUG_SCENES names no folder of scenes");
        return;
    };
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{folder:?}: {error}"));
    let mut scenes: Vec<(u64, PathBuf)> = entries
        .map(|entry| entry.expect("a readable folder"))
        .filter(|entry| entry.path().extension().is_some_and(|e| e == "ply" || e == "obj"))
        .map(|entry| (entry.metadata().expect("a readable file").len(), entry.path()))
        .collect();
    scenes.sort();
    assert!(!scenes.is_empty(), "{folder:?} has no scenes");
    for (_, path) in scenes.iter().take(2) {
        agrees(path.to_str().expect("a path in UTF-8"), "128");
    }
}

#[test]
fn queries_are_chosen_by_name() {
    for (words, queries) in [
        ("closest", &["closest"][..]),
        ("occluded_stream", &["occluded_stream"]),
        ("single", &["closest", "occluded"]),
        ("stream,occluded", &["closest_stream", "occluded", "occluded_stream"]),
    ] {
        let rows = rows(&printed(None, &[&SMALL[..], &["--query", words]].concat()));
        assert_eq!(values(&rows, &["query"]), set(queries), "{words}");
    }
}

#[test]
fn peers_and_instruction_sets_are_rows() {
    let one = [&SMALL[..], &["--structure", "auto", "--query", "single"]].concat();
    let isa = rows(&printed(None, &one))[0]["isa"].clone();
    let isas = if isa == "portable" { isa } else { format!("portable,{isa}") };
    let both = [&one[..], &["--isa", &isas, "--peers", "all"]].concat();
    let rows = rows(&printed(None, &both));
    let (hug, peers): (Vec<Row>, Vec<Row>) =
        rows.into_iter().partition(|row| row["structure"] == "auto");
    assert_eq!(values(&hug, &["isa"]), isas.split(',').map(str::to_owned).collect());
    let names = ["compact", "high", "low", "packet16", "packet8", "robust"];
    let names = names.map(|name| format!("embree_{name}"));
    assert_eq!(values(&peers, &["structure"]), names.into());
    assert_eq!(peers.len(), 6 * 5);
    for row in &peers {
        assert!(row["hug_mrays"].is_empty() && row["isa"].is_empty());
        assert!(!row["embree_mrays"].is_empty() && !row["ratio"].is_empty());
    }
}

#[test]
fn more_threads_are_more_columns() {
    let arguments = [&SMALL[..], &["--threads", "2", "--structure", "hug"]].concat();
    let csv = printed(None, &arguments);
    let more = ["embree_threads_build_ms", "embree_threads_build_wall_ms"];
    let hug = ["hug_threads_build_ms", "hug_threads_build_wall_ms"];
    let more = format!("{COLUMNS},{},{}", more.join(","), hug.join(","));
    assert_eq!(csv.lines().next(), Some(&*more));
}

#[test]
fn bad_options_are_refused() {
    for wrong in [
        &["--query", "intersect"][..],
        &["--query", ""],
        &["--query", "occluded", "--rays", "primary"],
        &["--peers", "robust,packet4"],
        &["--isa", "portable,abacus"],
        &["--isa", "portable,portable"],
        &["--views", "all"],
        &["--all", "--views", "some"],
        &["--all", "--scene", "kitchen"],
        &["--all", "--view", "wide"],
        &["--csv", "--markdown"],
        &["--rounds", "0"],
        &["--build-rounds", "1.5"],
        &["--quality", "best"],
        &["--quality", "fast,high"],
        &["--threads", "-1"],
        &["--threads", "0"],
    ] {
        let output = run(None, wrong);
        assert_eq!(output.status.code(), Some(2), "{wrong:?}");
        assert!(output.stdout.is_empty(), "{wrong:?}");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        // One line, which names the option.
        assert!(said.lines().count() == 1 && said.contains("--"), "{wrong:?}: {said}");
    }
}
