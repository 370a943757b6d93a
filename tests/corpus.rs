//! The fuzz targets (`fuzz/`), without a fuzzer, on the inputs that are checked in: what
//! it once found stays found, on every toolchain.
#![allow(missing_docs)]
#![cfg(feature = "capi")]

#[path = "../fuzz/harness/mod.rs"]
mod harness;

use std::fs;
use std::path::Path;

#[track_caller]
fn run(target: &str, f: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(target);
    let mut inputs = 0;
    for entry in fs::read_dir(&folder).expect("a corpus") {
        let path = entry.expect("an entry").path();
        println!("{}", path.display());
        f(&fs::read(&path).expect("an input"));
        inputs += 1;
    }
    assert!(inputs > 0, "{} is empty", folder.display());
    f(&[]);
}

#[test]
fn trace() {
    run("trace", harness::trace);
}

#[test]
fn open() {
    run("open", harness::open);
}

#[test]
fn descriptors() {
    run("descriptors", harness::descriptors);
}
