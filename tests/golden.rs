//! Arenas as files, one folder a format version: those of the present version are what a
//! build writes today, to the last byte, and answer; those of others are refused by name.
//!
//! `HUG_BLESS=1 cargo test --test golden` writes the present version's files. It is for
//! a new version only: a file that differs without one is a broken promise.
#![allow(missing_docs)]

mod common;

use common::aligned::Aligned;
use common::layout::{VERSION, get32};
use common::{adversarial_rays, assert_same, build, ray, structures};
use hug::{Error, View};
use hug_kit::{Mesh, soups};
use std::f32::consts::SQRT_2;
use std::fs;
use std::path::PathBuf;

fn folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden"))
}

fn mesh() -> Mesh {
    soups::clustered(60)
}

/// What is built today: file names and bytes.
fn fresh() -> Vec<(String, Vec<u8>)> {
    let empty = build(&soups::empty(), &structures()[0].1).view().bytes().to_vec();
    let mut all = vec![("empty.hug".to_owned(), empty)];
    for (name, options) in structures() {
        // In full, so that a default may change without a new version.
        let world_alpha = (options.structure == hug::Structure::Hug).then_some(SQRT_2);
        let options = hug::Options { maxp: 8, min_cluster: 2, world_alpha, ..options };
        let bytes = build(&mesh(), &options).view().bytes().to_vec();
        all.push((format!("{}.hug", name.to_lowercase()), bytes));
    }
    let turned = hug::Options {
        structure: hug::Structure::Hug,
        orientation: hug::Orientation::Search,
        turn_below: 1e6,
        min_cluster: 2,
        ..hug::Options::default()
    };
    let treed = hug::Options {
        structure: hug::Structure::Recursive,
        maxp: 8,
        tree: true,
        ..hug::Options::default()
    };
    let compact = hug::Options { compact: true, ..treed };
    all.push(("tree.hug".to_owned(), build(&mesh(), &treed).view().bytes().to_vec()));
    all.push(("compact.hug".to_owned(), build(&mesh(), &compact).view().bytes().to_vec()));
    all.push(("turned.hug".to_owned(), build(&mesh(), &turned).view().bytes().to_vec()));
    all
}

fn present() -> u32 {
    get32(&fresh()[0].1, VERSION)
}

#[test]
fn files_of_this_version_are_what_is_built() {
    let folder = folder().join(present().to_string());
    for (name, bytes) in fresh() {
        let path = folder.join(name);
        if std::env::var_os("HUG_BLESS").is_some() {
            fs::create_dir_all(&folder).expect("a folder");
            fs::write(&path, &bytes).expect("a file");
        }
        let golden = fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert!(golden == bytes, "{} is not what is built", path.display());
    }
}

#[test]
fn files_of_this_version_answer() {
    let mesh = mesh();
    let expected = build(&mesh, &structures()[0].1);
    let mut hits = 0;
    for (name, _) in fresh().into_iter().filter(|(name, _)| name != "empty.hug") {
        let path = folder().join(present().to_string()).join(name);
        let bytes = Aligned::copy(&fs::read(&path).expect("a golden file"));
        let view = View::open(&bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        for r in adversarial_rays(&mesh, 5, 20).iter().map(|(_, r)| ray(r)) {
            let hit = view.intersect(&r);
            assert_same(&hit, &expected.view().intersect_brute(&r), &r, &path.display());
            hits += u32::from(hit.is_hit());
        }
    }
    assert!(hits > 100, "{hits}");
}

#[test]
fn files_of_other_versions_are_refused() {
    let present = present();
    for entry in fs::read_dir(folder()).expect("the golden files") {
        let folder = entry.expect("an entry").path();
        let name = folder.file_name().and_then(|name| name.to_str());
        let version: u32 = name.and_then(|n| n.parse().ok()).expect("a folder's name is a version");
        for file in fs::read_dir(&folder).expect("a folder") {
            let path = file.expect("an entry").path();
            let bytes = Aligned::copy(&fs::read(&path).expect("a file"));
            assert_eq!(get32(&bytes, VERSION), version, "{}", path.display());
            let expected = (version != present).then_some(Error::Version);
            assert_eq!(View::open(&bytes).err(), expected, "{}", path.display());
        }
    }
}
