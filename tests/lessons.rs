//! The programs of c_examples that show one thing each: they run and say what they should.
#![allow(missing_docs)]
#![cfg(feature = "capi")]

mod common;

use common::native::{kit, library, make, require_packages, run, target};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

const PROGRAMS: [&str; 9] = [
    "animate",
    "cpp_cost",
    "cpp_scene",
    "embree_packets",
    "embree_records",
    "mmap",
    "mpi_render",
    "path_tracer",
    "threads",
];

/// Where the programs are; built once for all tests.
static BIN: LazyLock<PathBuf> = LazyLock::new(|| {
    require_packages();
    library("staticlib", &["--features", "capi"], "release");
    kit();
    make("c", &PROGRAMS)
});

fn program(name: &str) -> Command {
    let mut command = Command::new(BIN.join(name));
    // Libraries that cargo put in the way of ours.
    command.env_remove("LD_LIBRARY_PATH");
    command
}

/// A file that is not there yet.
fn fresh(name: &str) -> PathBuf {
    let folder = target().join("lessons");
    fs::create_dir_all(&folder).expect("a folder below the target");
    let path = folder.join(name);
    let _ = fs::remove_file(&path);
    path
}

/// The number before these words.
fn number(printed: &str, words: &str) -> f64 {
    let before = printed.split(words).next().unwrap_or_default();
    let number = before.split_whitespace().next_back().map(str::parse::<f64>);
    number.and_then(Result::ok).unwrap_or_else(|| panic!("no number before {words:?}: {printed}"))
}

fn is_png(path: &Path) {
    let bytes = fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n", "{}", path.display());
}

#[test]
fn one_file_in_many_processes() {
    let arena = fresh("mmap.hug");
    let printed = run(program("mmap").arg(&arena).arg("3"));
    assert!(printed.contains("3 processes") && printed.contains(" in each"), "{printed}");
    let nowhere = program("mmap").arg("no such folder/scene.hug").output().expect("was built");
    assert_eq!(nowhere.status.code(), Some(1));
    let said = String::from_utf8_lossy(&nowhere.stderr).into_owned();
    assert!(said.contains("no such folder/scene.hug: "), "{said}");
}

#[test]
fn lent_threads() {
    let printed = run(program("threads").arg("3"));
    assert!(printed.contains("on 3 threads: the same bytes"), "{printed}");
    assert!(printed.contains("cancelled half-way"), "{printed}");
}

#[test]
fn frames_in_the_same_memory() {
    let out = fresh("frame");
    let mut animate = program("animate");
    animate.args(["--side", "60", "--size", "64", "--frames", "3", "--out"]).arg(&out);
    let printed = run(&mut animate);
    is_png(&out.with_file_name("frame-0002.png"));
    let last = printed.lines().last().unwrap_or_default();
    assert!(number(&format!("{last}."), " %.") < 1.0, "{printed}");
    assert_eq!(printed.matches("frames per second").count(), 2, "{printed}");
}

#[test]
fn ranks_make_the_same_picture() {
    let mut pictures = Vec::new();
    for ranks in ["1", "3"] {
        let (arena, out) = (fresh("mpi.hug"), fresh("mpi.png"));
        let mut mpirun = Command::new("mpirun");
        mpirun.args(["--oversubscribe", "-n", ranks]).arg(BIN.join("mpi_render"));
        mpirun.arg(&arena).arg(&out).arg("128").env_remove("LD_LIBRARY_PATH");
        // Where tests run as root, in a container.
        mpirun.env("OMPI_ALLOW_RUN_AS_ROOT", "1").env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
        let printed = run(&mut mpirun);
        assert!(printed.contains(&format!("by {ranks} ranks")), "{printed}");
        is_png(&out);
        pictures.push(fs::read(&out).expect("a picture"));
    }
    assert!(pictures[0] == pictures[1], "the pictures differ");
}

#[test]
fn paths_by_hug_and_by_embree() {
    let out = fresh("paths.png");
    let mut tracer = program("path_tracer");
    tracer.args(["--kernel", "both", "--size", "48", "--samples", "3", "--out"]).arg(&out);
    let printed = run(&mut tracer);
    is_png(&out);
    is_png(&out.with_file_name("paths-embree.png"));
    assert!(number(&printed, " of 255") < 1.0, "{printed}");

    // A closed room is black but for a lamp.
    let room = ["lamp", "none"].map(|how| {
        let out = fresh(&format!("room-{how}.png"));
        let mut tracer = program("path_tracer");
        tracer.args(["--scene", "kitchen", "--size", "64", "--samples", "1", "--out"]).arg(&out);
        if how == "none" {
            tracer.args(["--lamp", "none"]);
        }
        (run(&mut tracer), fs::read(&out).expect("a picture").len())
    });
    assert!(room[0].0.contains("a lamp at") && !room[1].0.contains("a lamp at"), "{room:?}");
    assert!(room[0].1 > 5 * room[1].1, "{room:?}");
    let refused = program("path_tracer").args(["--kernel", "neither"]).output().expect("was built");
    assert_eq!(refused.status.code(), Some(2));
}

#[test]
fn embree_records_convert() {
    run(&mut program("embree_records"));
}

#[test]
fn embree_packets_convert() {
    assert_eq!(run(&mut program("embree_packets")), "embree_packets: ok\n");
}

#[test]
fn cpp_works() {
    let printed = run(&mut program("cpp_scene"));
    assert!(printed.starts_with("cpp_scene: ok"), "{printed}");
}

/// A function's instructions, without the places that they and other functions are at.
fn instructions(function: &str) -> Vec<String> {
    let mut objdump = Command::new("objdump");
    objdump.args(["-d", "--no-show-raw-insn", "--no-addresses"]);
    objdump.arg(format!("--disassemble={function}"));
    let listed = run(objdump.arg(BIN.join("cpp_cost")));
    let plain = |line: &str| match line.split_once("(%rip)") {
        Some((address, _)) => address.split_whitespace().next().unwrap_or_default().to_owned(),
        None => line.replace(function, ""),
    };
    let lines: Vec<_> =
        listed.lines().filter_map(|line| line.strip_prefix('\t')).map(plain).collect();
    assert!(lines.len() > 1, "{function}: {listed}");
    lines
}

#[test]
fn cpp_costs_nothing() {
    for query in ["closest", "occluded", "stream", "all", "filtered", "nearest"] {
        let [plain, wrapped] = ["plain", "wrapped"].map(|how| format!("{how}_{query}"));
        assert_eq!(instructions(&plain), instructions(&wrapped), "{query}");
    }
    // Rays are filled in by other moves, but not by more.
    assert!(instructions("wrapped_ray").len() <= instructions("plain_ray").len());
    for how in ["plain", "wrapped"] {
        run(program("cpp_cost").args([how, "10"]));
    }
}

#[test]
fn bare_needs_no_allocator() {
    let options = ["--no-default-features", "--features", "panic-handler"];
    library("staticlib", &options, "freestanding");
    let program = make("c", &["bare"]).join("bare");
    let printed = run(Command::new(program).env_remove("LD_LIBRARY_PATH"));
    assert!(number(&printed, " of 1200 rays hit") > 500.0, "{printed}");
}
