//! The library without std, in a C program without a C library; and what the
//! archives and the shared library show to a linker.
#![allow(missing_docs)]

mod common;

use common::native::{declared, library, make, run, symbols, target};
use std::fs;
use std::process::Command;

const WITHOUT_STD: [&str; 3] = ["--no-default-features", "--features", "panic-handler"];

#[test]
fn a_program_without_an_operating_system_runs() {
    let folder = library("staticlib", &WITHOUT_STD, "freestanding");
    let archive = symbols(&["--defined-only", "--extern-only"], &folder.join("libhug.a"));
    let missing: Vec<_> = declared().difference(&archive).cloned().collect();
    assert!(missing.is_empty(), "not in the archive: {missing:?}");
    let program = make("c", &["freestanding"]).join("freestanding");
    run(&mut Command::new(&program));
    // It is the library that ran, linked in whole: nothing is left to find.
    let linked = symbols(&["--defined-only"], &program);
    for name in ["hug_measure", "hug_build_into", "hug_intersect", "hug_occluded", "hug_open"] {
        assert!(linked.contains(name), "{name} is not in the program");
    }
    assert_eq!(symbols(&["--undefined-only"], &program).len(), 0);
}

#[test]
fn the_archive_with_std_has_every_function() {
    let folder = library("staticlib", &["--features", "capi"], "release");
    let archive = symbols(&["--defined-only", "--extern-only"], &folder.join("libhug.a"));
    let missing: Vec<_> = declared().difference(&archive).cloned().collect();
    assert!(missing.is_empty(), "not in the archive: {missing:?}");
}

/// A shared library exports what the header declares, nothing else, and is small.
#[test]
fn the_shared_library_exports_the_header() {
    let folder = library("cdylib", &["--features", "capi"], "release");
    let library = folder.join("libhug.so");
    assert_eq!(symbols(&["--dynamic", "--defined-only"], &library), declared());
    let stripped = target().join("libhug-stripped.so");
    run(Command::new("strip").arg("-o").arg(&stripped).arg(&library));
    let size = fs::metadata(&stripped).expect("strip wrote it").len();
    assert!(size < 1 << 20, "{size} bytes stripped");
}
