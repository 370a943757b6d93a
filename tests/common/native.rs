//! The library as C sees it: built by cargo as an archive or a shared library,
//! linked by make into the programs of c_examples.
//!
//! All of it goes to a target folder of its own: the one that the running
//! `cargo test` uses may be locked, and holds other features.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Where everything native is built.
pub fn target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("native")
}

/// Runs a program and returns what it printed; panics with all of it, and with
/// what to install if it is not there, unless it exits with 0.
#[track_caller]
pub fn run(command: &mut Command) -> String {
    let output = match command.output() {
        Ok(output) => output,
        Err(error) => panic!("{command:?}: {error}\n{}", packages()),
    };
    let (out, err) =
        (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{command:?}: {}\n{out}\n{err}", output.status);
    out.into_owned()
}

/// What the C side needs, as one line to run on Debian.
pub fn packages() -> String {
    let setup = fs::read_to_string(root().join(".ci/setup")).unwrap_or_default();
    let list = setup.lines().find_map(|line| line.strip_prefix("packages=(")?.strip_suffix(')'));
    let list = list.unwrap_or("gcc g++ make pkg-config (and see .ci/setup)");
    format!("the C programs need: sudo apt-get install -y --no-install-recommends {list}")
}

/// Makes sure, before a compiler fails in its own words, that headers and
/// libraries are installed.
#[track_caller]
pub fn require_packages() {
    let modules = ["assimp", "libcjson", "stb"];
    let found = Command::new("pkg-config").arg("--exists").args(modules).status();
    assert!(found.is_ok_and(|status| status.success()), "{modules:?}: {}", packages());
    let embree = ["-E", "-include", "embree3/rtcore.h", "-x", "c", "/dev/null"];
    let found = Command::new("cc").args(embree).output();
    assert!(found.is_ok_and(|o| o.status.success()), "embree3/rtcore.h: {}", packages());
}

/// Runs cargo on this package and returns the folder of the profile.
#[track_caller]
fn cargo(arguments: &[&str], profile: &str) -> PathBuf {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(arguments).args(["--profile", profile, "--target-dir"]).arg(target());
    // A default for this host only: the programs are to run here.
    cargo.env_remove("CARGO_BUILD_TARGET").current_dir(root());
    run(&mut cargo);
    target().join(profile)
}

/// This library as a crate type of Rust's, e.g. "staticlib".
#[track_caller]
pub fn library(kind: &str, features: &[&str], profile: &str) -> PathBuf {
    let base = ["rustc", "--lib", "--crate-type", kind];
    cargo(&[&base, features].concat(), profile)
}

/// libhug_kit.so, beside the release build of the library.
#[track_caller]
pub fn kit() -> PathBuf {
    let manifest = root().join("tests/kit/Cargo.toml");
    let manifest = manifest.to_str().expect("a path in UTF-8");
    cargo(&["build", "--lib", "--manifest-path", manifest], "release")
}

/// Makes programs of c_examples as C or C++ and returns where they are.
#[track_caller]
pub fn make(mode: &str, programs: &[&str]) -> PathBuf {
    let variable = |name: &str, path: &Path| {
        let mut text = OsStr::new(name).to_owned();
        text.push("=");
        text.push(path);
        text
    };
    let build = target().join("c_examples").join(mode);
    let mut make = Command::new("make");
    make.arg("-C").arg(root().join("c_examples")).args(["--silent", "-j2"]);
    make.arg(format!("MODE={mode}"));
    make.arg(variable("BUILD", &build));
    make.arg(variable("HUG_LIB", &target().join("release/libhug.a")));
    make.arg(variable("HUG_FREESTANDING_LIB", &target().join("freestanding/libhug.a")));
    make.arg(variable("KIT_DIR", &target().join("release")));
    // Settings of an outer make are not for this one.
    make.env_remove("MAKEFLAGS").env_remove("MFLAGS");
    run(make.args(programs));
    build.join("bin")
}

/// The functions that include/hug.h declares.
pub fn declared() -> BTreeSet<String> {
    let header = fs::read_to_string(root().join("include/hug.h")).expect("include/hug.h");
    // Between comments: every second part but for what ends the comment.
    let code = header.split("/*").map(|part| part.rsplit_once("*/").map_or(part, |(_, code)| code));
    let code: String = code.collect();
    let mut functions = BTreeSet::new();
    for (at, _) in code.match_indices('(') {
        let name = code[..at].rsplit(|c: char| !c.is_alphanumeric() && c != '_').next();
        functions.extend(name.filter(|name| name.starts_with("hug_")).map(str::to_owned));
    }
    assert!(functions.contains("hug_build") && functions.len() > 10, "{functions:?}");
    functions
}

/// Names that nm lists with these options.
#[track_caller]
pub fn symbols(options: &[&str], file: &Path) -> BTreeSet<String> {
    let listed = run(Command::new("nm").args(options).arg(file));
    let name = |line: &str| Some(line.split_whitespace().last()?.to_owned());
    listed.lines().filter(|line| !line.ends_with(':')).filter_map(name).collect()
}
