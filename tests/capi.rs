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

const COLUMNS: &str = "scene,triangles,structure,rays,query,isa,hug_mrays,embree_mrays,ratio,\
    ratio_min,ratio_max,hug_build_ms,embree_build_ms,hug_bytes,embree_bytes,hit_mismatch,\
    t_mismatch,prim_mismatch";

/// Compares a scene with Embree; the exit status says that nothing was decided
/// against us, the rest says that something was compared.
fn compare(scene: &str, size: &str) {
    let mut compare = program(&PROGRAMS[0], "compare");
    compare.args(["--scene", scene, "--size", size, "--rounds", "1", "--structure", "all"]);
    let output = compare.arg("--csv").output().expect("compare was built");
    let (out, err) =
        (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{scene}: {}\n{err}", output.status);
    let mut lines = out.lines();
    assert_eq!(lines.next(), Some(COLUMNS), "{scene}");
    let width = COLUMNS.split(',').count();
    let mut rows = Vec::new();
    for line in lines {
        let fields: Vec<&str> = line.split(',').collect();
        assert_eq!(fields.len(), width, "{scene}: {line}");
        for number in [1].into_iter().chain(6..width) {
            let value = fields[number].parse::<f64>();
            assert!(value.is_ok_and(|v| v.is_finite() && v >= 0.0), "{scene}: {line}");
        }
        rows.push((fields[2].to_owned(), fields[3].to_owned()));
    }
    for structure in ["uniform", "recursive", "hug"] {
        for rays in ["primary", "shadow", "bounce1", "bounce2", "random"] {
            let row = (structure.to_owned(), rays.to_owned());
            assert!(rows.contains(&row), "{scene}: no {structure}, {rays} in\n{out}");
        }
    }
    // The arbiter's verdicts, a line a kind of difference: the last column counts
    // those against us.
    for line in err.lines().filter(|line| line.split_whitespace().count() > 4) {
        let structure = line.split_whitespace().next();
        if matches!(structure, Some("uniform" | "recursive" | "hug")) {
            assert_eq!(line.split_whitespace().last(), Some("0"), "{scene}: {line}");
        }
    }
}

#[test]
fn agrees_with_embree_on_built_in_scenes() {
    for scene in ["kitchen", "building", "building_walls", "city", "garden"] {
        compare(scene, "64");
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
        compare(path.to_str().expect("a path in UTF-8"), "128");
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
    for file in ["include/hug.h", "include/hug_embree.h"] {
        let header = fs::read_to_string(root().join(file)).expect("a header");
        for line in header.lines().filter_map(|line| line.strip_prefix("#define ")) {
            assert!(line.starts_with("HUG_"), "{file} defines {line}");
        }
    }
}
