//! The two doors of the build, with and without an allocator, make the same
//! bytes, whatever memory they are given.
#![allow(missing_docs)]

mod common;

use common::aligned::Aligned;
use common::{configurations, soups, structures};
use hug::{Error, Geometry, Options, Scene, build};
use hug_kit::{Mesh, soups as kit};

fn soup(mesh: &Mesh) -> [Geometry<'_>; 1] {
    [Geometry::from_mesh(&mesh.vertices, &mesh.indices)]
}

fn easy(mesh: &Mesh, options: &Options) -> Vec<u8> {
    let scene = Scene::build(&soup(mesh), options).expect("the soup is valid");
    scene.view().bytes().to_vec()
}

#[test]
fn measured_memory_makes_the_bytes_of_the_easy_door() {
    for (name, mesh) in soups() {
        for (kind, options) in configurations() {
            let what = format!("{name} in {kind}");
            let sizes = build::measure(&soup(&mesh), &options).expect("fits");
            assert_eq!((sizes.arena % 64, sizes.scratch % 64), (0, 0), "{what}");
            let (mut scratch, mut arena) =
                (vec![0; sizes.scratch], Aligned::filled(sizes.arena, 0));
            let made = build::build_into(&soup(&mesh), &options, &mut scratch, &mut arena)
                .unwrap_or_else(|error| panic!("{what}: {error}"));
            assert!(made == easy(&mesh, &options), "{what}");
            assert!(made.len() <= sizes.arena && made.len().is_multiple_of(64), "{what}");
        }
    }
}

/// Neither what the memory held before nor where the scratch memory begins.
#[test]
fn what_the_memory_held_does_not_matter() {
    let mesh = kit::tangle(1, 600);
    for (name, options) in configurations() {
        let expected = easy(&mesh, &options);
        let sizes = build::measure(&soup(&mesh), &options).expect("fits");
        for (offset, garbage) in [(0, 0xff), (1, 0x00), (3, 0x7f), (13, 0xa5), (63, 0x80)] {
            let mut scratch = vec![garbage; sizes.scratch + offset + 1000];
            let mut arena = Aligned::filled(sizes.arena + 64, garbage);
            let part = &mut scratch[offset..offset + sizes.scratch];
            let made = build::build_into(&soup(&mesh), &options, part, &mut arena);
            assert!(made == Ok(&expected[..]), "{name}: {offset} bytes off, {garbage:#x}");
            let used = expected.len();
            assert!(arena[used..].iter().all(|&b| b == garbage), "{name}: wrote past the arena");
            let after = &scratch[offset + sizes.scratch..];
            assert!(after.iter().all(|&b| b == garbage), "{name}: wrote past the scratch memory");
        }
    }
}

/// A build's scratch memory is full of itself: the next one must not care.
#[test]
fn scratch_memory_can_be_used_again() {
    let meshes = [kit::tangle(1, 600), kit::clustered(900), kit::single(), kit::lattice(4, 600, 8)];
    for (name, options) in configurations() {
        let size = |m| build::measure(&soup(m), &options).expect("fits");
        let scratch = meshes.iter().map(|m| size(m).scratch).max().unwrap_or(0);
        let arena = meshes.iter().map(|m| size(m).arena).max().unwrap_or(0);
        let (mut scratch, mut arena) = (vec![0; scratch], Aligned::filled(arena, 0));
        for (i, mesh) in meshes.iter().chain(&meshes).enumerate() {
            let made = build::build_into(&soup(mesh), &options, &mut scratch, &mut arena);
            assert!(made == Ok(&easy(mesh, &options)[..]), "{name}: build {i}");
        }
    }
}

/// Sizes from 0 to `enough`: all small ones, then ever fewer, and just too small.
fn too_small(enough: usize) -> impl Iterator<Item = usize> {
    let falling = (0..64).map(move |k| enough.saturating_sub(1 << (k / 2)).saturating_sub(k % 2));
    (0..80).chain((1..40).map(move |k| enough * k / 40)).chain(falling).filter(move |&n| n < enough)
}

#[test]
fn too_little_scratch_is_an_error() {
    for mesh in [kit::tangle(1, 200), kit::clustered(300), kit::single()] {
        for (name, options) in structures() {
            let expected = easy(&mesh, &options);
            let sizes = build::measure(&soup(&mesh), &options).expect("fits");
            let mut scratch = vec![0; sizes.scratch];
            let mut arena = Aligned::filled(sizes.arena, 0);
            let mut refused = 0;
            for size in too_small(sizes.scratch) {
                let part = &mut scratch[..size];
                match build::build_into(&soup(&mesh), &options, part, &mut arena) {
                    // Measured is an upper bound: a little less may do.
                    Ok(made) => assert!(made == expected, "{name} with {size} bytes of scratch"),
                    Err(error) => {
                        refused += 1;
                        assert_eq!(error, Error::BufferTooSmall, "{name}, {size} bytes");
                    }
                }
            }
            assert!(refused > 100, "{name}: {refused} sizes were too small");
        }
    }
}

#[test]
fn too_little_or_misaligned_arena_is_an_error() {
    for mesh in [kit::tangle(1, 200), kit::single(), kit::empty()] {
        for (name, options) in structures() {
            let expected = easy(&mesh, &options);
            let sizes = build::measure(&soup(&mesh), &options).expect("fits");
            let mut scratch = vec![0; sizes.scratch];
            let mut arena = Aligned::filled(expected.len() + 64, 0x5a);
            let mut into = |part: &mut [u8]| {
                build::build_into(&soup(&mesh), &options, &mut scratch, part).map(<[u8]>::len)
            };
            for size in too_small(expected.len()) {
                let made = into(&mut arena[..size]);
                assert_eq!(made, Err(Error::BufferTooSmall), "{name} with {size} bytes");
            }
            for offset in [1, 4, 8, 16, 32, 63] {
                let made = into(&mut arena[offset..]);
                assert_eq!(made, Err(Error::Alignment), "{name}, {offset} bytes off");
            }
            assert!(arena.iter().all(|&b| b == 0x5a), "{name}: a refused build wrote");
            assert_eq!(into(&mut arena), Ok(expected.len()), "{name}");
        }
    }
}

#[test]
fn building_twice_makes_the_same_bytes() {
    for (name, mesh) in soups() {
        for (kind, options) in configurations() {
            assert!(easy(&mesh, &options) == easy(&mesh, &options), "{name} in {kind}");
        }
    }
}
