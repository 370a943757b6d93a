//! The C programs, compiled strictly as C99 and as C++11 against the static
//! library, and run.
#![allow(missing_docs)]
#![cfg(feature = "capi")]

mod common;

use common::native::{kit, library, make, require_packages, root, run, target};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

/// Where the programs are, as C and as C++; built once for all tests.
static PROGRAMS: LazyLock<[PathBuf; 2]> = LazyLock::new(|| {
    require_packages();
    library("staticlib", &["--features", "capi"], "release");
    kit();
    ["c", "c++"].map(|mode| make(mode, &["all"]))
});

fn program(bin: &Path, name: &str) -> Command {
    let mut command = Command::new(bin.join(name));
    // Libraries that cargo put in the way of ours.
    command.env_remove("LD_LIBRARY_PATH");
    command
}

#[test]
fn minimal_prints_the_hit() {
    for bin in &*PROGRAMS {
        let printed = run(&mut program(bin, "minimal"));
        assert!(printed.starts_with("t 2, u 0.25, v 0.5, geometry 0, primitive 0"), "{printed}");
    }
}

/// What it does with fifty million triangles too, given the memory.
#[test]
fn every_ray_hits_its_triangle_of_a_sheet() {
    for (bin, structure) in PROGRAMS.iter().zip(["0", "3"]) {
        let printed = run(program(bin, "scale").args(["3000", "8", structure]));
        assert!(printed.contains("each hit its triangle"), "{printed}");
    }
}

#[test]
fn all_hits_are_found_in_several_calls() {
    for bin in &*PROGRAMS {
        let printed = run(&mut program(bin, "allhits"));
        assert!(printed.starts_with("t 1: enters box 0 at triangle 8"), "{printed}");
        assert_eq!(printed.lines().count(), 13, "{printed}");
        assert!(printed.ends_with("3 inside, found in 3 calls\n"), "{printed}");
    }
}

#[test]
fn bad_input_and_promises() {
    for bin in &*PROGRAMS {
        let printed = run(&mut program(bin, "abi_errors"));
        let count = printed.split_whitespace().nth(1).and_then(|n| n.parse::<u32>().ok());
        assert!(count > Some(100) && printed.contains(" 0 failed"), "{printed}");
    }
}

/// Width and height of a PNG file.
fn size(path: &Path) -> [u32; 2] {
    let bytes = fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n", "{}", path.display());
    assert!(bytes.windows(4).any(|w| w == b"IEND"), "{} has no end", path.display());
    [16, 20].map(|at| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("four bytes")))
}

#[test]
fn render_writes_pictures() {
    for (bin, mode) in PROGRAMS.iter().zip(["c", "cpp"]) {
        for structure in ["auto", "uniform", "recursive", "hug"] {
            let out = target().join(format!("{mode}-{structure}.png"));
            let picture = |kind| target().join(format!("{mode}-{structure}-{kind}.png"));
            for kind in ["shaded", "depth", "steps"] {
                // Of an earlier run; there may be none.
                let _ = fs::remove_file(picture(kind));
            }
            let mut render = program(bin, "render");
            render.args(["--mode", "all", "--size", "48", "--structure", structure]);
            run(render.arg("--out").arg(&out));
            for kind in ["shaded", "depth", "steps"] {
                assert_eq!(size(&picture(kind)), [48, 48], "{kind}");
            }
            // Hits do not depend on the structure, steps do.
            let same = |kind| {
                let first = target().join(format!("{mode}-auto-{kind}.png"));
                fs::read(picture(kind)).ok() == fs::read(first).ok()
            };
            assert!(same("shaded") && same("depth"), "{structure} looks different");
        }
    }
}

#[test]
fn bad_options_are_refused() {
    for name in ["render", "compare"] {
        for wrong in [&["--size", "0"][..], &["--nonsense"], &["--scene"]] {
            let output = program(&PROGRAMS[0], name).args(wrong).output().expect("was built");
            assert_eq!(output.status.code(), Some(2), "{name} {wrong:?}");
            assert!(!output.stderr.is_empty(), "{name} {wrong:?} says nothing");
        }
        let missing = ["--scene", "no such scene"];
        let output = program(&PROGRAMS[0], name).args(missing).output().expect("was built");
        assert_eq!(output.status.code(), Some(1), "{name} {missing:?}");
    }
}

/// Everything in the header is ours by name: it is included by others.
#[test]
fn every_macro_has_the_prefix() {
    let headers = [
        "hug.h",
        "hug.hpp",
        "hug_builder.hpp",
        "hug_queries.hpp",
        "hug_embree.h",
        "hug_embree_packets.h",
    ];
    for file in headers.map(|name| format!("include/{name}")) {
        let header = fs::read_to_string(root().join(&file)).expect("a header");
        for line in header.lines().filter_map(|line| line.strip_prefix("#define ")) {
            assert!(line.starts_with("HUG_"), "{file} defines {line}");
        }
    }
}
