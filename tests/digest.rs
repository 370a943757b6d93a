//! The program whose numbers are the same on every processor: here with std and
//! without, on each instruction set that there is. `.ci/targets` runs it elsewhere.
#![allow(missing_docs)]

mod common;

use common::native::{library, make, run};
use std::collections::BTreeSet;
use std::process::Command;

#[test]
fn digests_are_the_same_with_std_and_without() {
    library("staticlib", &["--features", "capi"], "release");
    let bare = ["--no-default-features", "--features", "panic-handler"];
    library("staticlib", &bare, "freestanding");
    let bin = make("c", &["digest", "digest_bare"]);
    let numbers = |program: &str| -> BTreeSet<String> {
        let printed = run(&mut Command::new(bin.join(program)));
        // Without the names of instruction sets.
        printed.lines().map(|l| l.split_once(": ").map_or(l, |(_, n)| n).to_owned()).collect()
    };
    let hosted = numbers("digest");
    assert_eq!(hosted.len(), 2, "one scene, one outcome: {hosted:?}");
    assert_eq!(hosted, numbers("digest_bare"));
}
