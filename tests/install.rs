//! `make install` and, where cargo-c is there, `cargo cinstall` into a prefix, and projects of
//! somebody else's built against it: C by pkg-config, C++ by CMake, static and shared.
#![allow(missing_docs)]
#![cfg(feature = "capi")]

mod common;

use common::native::{declared, root, run, symbols, target};
use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

/// What every one of the programs prints.
const PRINTED: &str = concat!("hug ", env!("CARGO_PKG_VERSION"), ": t 2\n");

fn make(what: &str, prefix: &Path) {
    // Both tests build in the same place.
    static TURN: Mutex<()> = Mutex::new(());
    let _turn = TURN.lock();
    let mut make = Command::new("make");
    make.arg("-C").arg(root()).args(["--silent", what]);
    make.arg(format!("PREFIX={}", prefix.display()));
    make.arg(format!("TARGET_DIR={}", target().join("install").display()));
    // Settings of an outer make or cargo are not for this one.
    make.env_remove("MAKEFLAGS").env_remove("MFLAGS").env_remove("CARGO_BUILD_TARGET");
    run(&mut make);
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.expect("an entry").path();
        if path.is_dir() { found.extend(files(&path)) } else { found.push(path) }
    }
    found
}

fn pkg_config(prefix: &Path, options: &[&str]) -> Vec<String> {
    let mut command = Command::new("pkg-config");
    command.env("PKG_CONFIG_PATH", prefix.join("lib/pkgconfig")).args(options);
    run(command.arg("hug")).split_whitespace().map(str::to_owned).collect()
}

/// Compiles the outside C program and returns what it prints.
fn c_program(prefix: &Path, out: &str, flags: &[String]) -> String {
    let program = prefix.with_file_name(out);
    let mut cc = Command::new("cc");
    cc.args(["-std=c99", "-O2", "-Wall", "-Werror", "-o"]).arg(&program);
    run(cc.arg(root().join("tests/outside/outside.c")).args(flags));
    run(Command::new(&program).env("LD_LIBRARY_PATH", prefix.join("lib")))
}

fn cmake_programs(prefix: &Path) {
    let build = prefix.with_file_name("cmake");
    let _ = fs::remove_dir_all(&build);
    let mut configure = Command::new("cmake");
    configure.arg("-S").arg(root().join("tests/outside")).arg("-B").arg(&build);
    run(configure.arg(format!("-DCMAKE_PREFIX_PATH={}", prefix.display())));
    run(Command::new("cmake").arg("--build").arg(&build));
    for kind in ["static", "shared", "hug", "c"] {
        // CMake has written where the shared library is into the program.
        let mut program = Command::new(build.join(format!("outside_{kind}")));
        assert_eq!(run(program.env_remove("LD_LIBRARY_PATH")), PRINTED, "{kind}");
    }
    let linked = symbols(&["--undefined-only"], &build.join("outside_shared"));
    assert!(linked.contains("hug_build"), "outside_shared does not use the shared library");
    let linked = symbols(&["--defined-only"], &build.join("outside_static"));
    assert!(linked.contains("hug_build"), "outside_static does not hold the library");
}

/// By pkg-config: against the shared library, the static one, and with nothing shared at all,
/// for which `unwinder` is what unwinds.
fn c_programs(prefix: &Path, unwinder: Option<&str>) {
    let shared = pkg_config(prefix, &["--cflags", "--libs"]);
    assert_eq!(c_program(prefix, "shared", &shared), PRINTED);
    let archive = pkg_config(prefix, &["--static", "--cflags", "--libs"]);
    let chosen: Vec<_> = archive.iter().map(|flag| flag.replace("-lhug", "-l:libhug.a")).collect();
    assert_eq!(c_program(prefix, "static", &chosen), PRINTED);
    let fitting = |flag: &String| match unwinder {
        Some(unwinder) if flag == "-lgcc_s" => unwinder.to_owned(),
        _ => flag.clone(),
    };
    let whole: Vec<_> = ["-static".to_owned()].iter().chain(&archive).map(fitting).collect();
    assert_eq!(c_program(prefix, "whole", &whole), PRINTED);
    assert_eq!(pkg_config(prefix, &["--modversion"]), [env!("CARGO_PKG_VERSION")]);
}

/// What a linker sees of the shared library is ours and all of it, under the right name.
fn shared_library(libraries: &Path) {
    let shared = symbols(&["--defined-only", "--dynamic"], &libraries.join("libhug.so"));
    assert_eq!(shared, declared());
    let [major, minor, _] = *env!("CARGO_PKG_VERSION").split('.').collect::<Vec<_>>() else {
        panic!("a version of three numbers");
    };
    let version = if major == "0" { format!("0.{minor}") } else { major.to_owned() };
    let dynamic = run(Command::new("readelf").arg("-d").arg(libraries.join("libhug.so")));
    assert!(dynamic.contains(&format!("[libhug.so.{version}]")), "{dynamic}");
}

/// A folder below the target in which nothing is installed yet.
fn fresh(name: &str) -> PathBuf {
    let folder = target().join(name);
    let _ = fs::remove_dir_all(&folder);
    folder.join("first")
}

#[test]
fn outside_projects_use_an_installed_tree() {
    let prefix = fresh("outside");
    make("install", &prefix);
    c_programs(&prefix, None);

    // The tree may be moved: its CMake files say nothing of where it was.
    let moved = prefix.with_file_name("second");
    fs::rename(&prefix, &moved).expect("the tree can be moved");
    cmake_programs(&moved);

    let libraries = moved.join("lib");
    let archive = symbols(&["--defined-only", "--extern-only"], &libraries.join("libhug.a"));
    assert_eq!(archive, declared());
    shared_library(&libraries);

    make("uninstall", &moved);
    let left = files(&moved);
    assert!(left.is_empty(), "left behind: {left:?}");
}

/// The same tree by the other way. Its archive is as rustc makes it, with Rust's own names.
#[test]
fn outside_projects_use_what_cargo_c_installs() {
    if !Command::new("cargo-cinstall").arg("--version").output().is_ok_and(|o| o.status.success()) {
        // Not by eprintln, which only those who fail get to see.
        let said = "skipped: no cargo-c (cargo install cargo-c --locked)\n";
        std::io::stderr().write_all(said.as_bytes()).expect("standard error");
        return;
    }
    let prefix = fresh("outside-cargo-c");
    let mut cinstall = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cinstall.args(["cinstall", "--release"]).current_dir(root());
    cinstall.arg("--prefix").arg(&prefix).arg("--libdir").arg(prefix.join("lib"));
    cinstall.arg("--target-dir").arg(target().join("cargo-c")).env_remove("CARGO_BUILD_TARGET");
    run(&mut cinstall);
    // rustc names a library of GCC's that is only there as a shared one.
    c_programs(&prefix, Some("-lgcc_eh"));
    let names = |prefix: &Path| {
        let below = |path: PathBuf| path.strip_prefix(prefix).expect("below it").to_owned();
        files(prefix).into_iter().map(below).collect::<BTreeSet<_>>()
    };
    let made = fresh("outside-made");
    make("install", &made);
    assert_eq!(names(&prefix), names(&made));

    let moved = prefix.with_file_name("second");
    fs::rename(&prefix, &moved).expect("the tree can be moved");
    cmake_programs(&moved);
    shared_library(&moved.join("lib"));
    let archive = symbols(&["--defined-only", "--extern-only"], &moved.join("lib/libhug.a"));
    assert!(declared().is_subset(&archive));
}

/// Files that no tool writes the version into.
#[test]
fn versions_agree() {
    let cmake = root().join("cmake/hug-config-version.cmake");
    let cmake = fs::read_to_string(cmake).expect("hug-config-version.cmake");
    let line = format!("set(PACKAGE_VERSION \"{}\")", env!("CARGO_PKG_VERSION"));
    assert!(cmake.contains(&line), "hug-config-version.cmake does not say {line}");
}
