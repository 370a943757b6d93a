//! hug in other company: beside a second Rust library, and loaded and unloaded at run
//! time. `tests/freestanding.rs` has what the libraries export.
#![allow(missing_docs)]
#![cfg(target_os = "linux")]

mod common;

use common::native::{library, root, run, symbols, target};
use std::path::{Path, PathBuf};
use std::process::Command;

const HOSTED: [&str; 2] = ["--features", "capi"];
const SYSTEM: [&str; 3] = ["-lpthread", "-ldl", "-lm"];

fn folder() -> PathBuf {
    root().join("tests/neighbour")
}

/// A compiler for programs of this folder, which go to `out`.
fn cc(source: &str, out: &Path) -> Command {
    let mut cc = Command::new("cc");
    cc.args(["-std=gnu99", "-Wall", "-Wextra", "-Werror", "-O1", "-g", "-I"]);
    cc.arg(root().join("include")).arg(folder().join(source)).arg("-o").arg(out);
    cc
}

/// The other library.
fn neighbour() -> PathBuf {
    let out = target().join("libneighbour.a");
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    rustc.args(["--edition", "2024", "--crate-type", "staticlib", "-O", "-o"]).arg(&out);
    run(rustc.arg(folder().join("neighbour.rs")));
    out
}

#[test]
fn the_shared_library_beside_a_static_one() {
    let hug = library("cdylib", &HOSTED, "release");
    let program = target().join("beside-shared");
    let mut path = std::ffi::OsString::from("-Wl,-rpath,");
    path.push(&hug);
    let mut cc = cc("main.c", &program);
    cc.arg(neighbour()).arg("-L").arg(&hug).arg("-lhug").arg(path);
    run(cc.args(SYSTEM));
    assert_eq!(run(&mut Command::new(&program)).trim(), "1 2 42");
}

/// An archive of one object in which all but hug's own names are local.
#[test]
fn the_static_library_with_its_own_names_alone() {
    let archive = library("staticlib", &HOSTED, "release").join("libhug.a");
    let object = target().join("hug-alone.o");
    let mut ld = Command::new("ld");
    ld.args(["-r", "--gc-sections", "--force-group-allocation"]);
    let exported = symbols(&["--defined-only", "--extern-only"], &archive);
    let exported: Vec<_> = exported.iter().filter(|name| name.starts_with("hug_")).collect();
    assert!(exported.len() > 20, "{exported:?}");
    ld.args(exported.iter().flat_map(|name| ["-u", name.as_str()]));
    run(ld.arg("-o").arg(&object).arg(&archive));
    let mut objcopy = Command::new("objcopy");
    objcopy.args(["--wildcard", "--keep-global-symbol=hug_*"]);
    // Bitcode, which some tools take for the object itself.
    objcopy.args(["--remove-section=.llvmbc", "--remove-section=.llvmcmd"]);
    run(objcopy.arg(&object));
    let left = symbols(&["--defined-only", "--extern-only"], &object);
    assert!(left.iter().all(|name| name.starts_with("hug_")), "{left:?}");
    let program = target().join("beside-static");
    let mut cc = cc("main.c", &program);
    run(cc.arg(&object).arg(neighbour()).args(SYSTEM));
    assert_eq!(run(&mut Command::new(&program)).trim(), "1 2 42");
}

#[test]
fn loaded_used_by_two_threads_at_once_and_unloaded() {
    let shared = library("cdylib", &HOSTED, "release").join("libhug.so");
    let program = target().join("loading");
    run(cc("loading.c", &program).args(SYSTEM));
    let printed = run(Command::new(&program).arg(shared));
    assert_eq!(printed.trim(), "loaded 20 times, unloaded 20 times");
}
