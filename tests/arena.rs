//! An arena's bytes are the scene: wherever they lie they open and give the
//! same hits; cut short, moved off or relabelled they do not open.
#![allow(missing_docs)]

mod common;

use common::aligned::Aligned;
use common::layout::*;
use common::{
    adversarial_rays, assert_same, build, configurations, is_damage, ray, soups, structures,
};
use hug::{Error, Ray, View};
use hug_kit::soups as kit;

#[test]
fn copied_bytes_are_the_scene() {
    for (name, mesh) in soups() {
        let rays: Vec<Ray> = adversarial_rays(&mesh, 5, 10).iter().map(|(_, r)| ray(r)).collect();
        for (kind, options) in configurations() {
            let what = format!("{name} in {kind}");
            let scene = build(&mesh, &options);
            let bytes = scene.view().bytes();
            assert_eq!(bytes.len() % 64, 0, "{what}");
            let in_place = View::open(bytes).unwrap_or_else(|error| panic!("{what}: {error}"));
            // Elsewhere, and with something else behind.
            let mut copy = Aligned::filled(bytes.len() + 100, 0xc3);
            copy[..bytes.len()].copy_from_slice(bytes);
            let copied = View::open(&copy).unwrap_or_else(|error| panic!("{what}: {error}"));
            assert!(copied.bytes() == bytes, "{what}: what follows is not part of it");
            assert_eq!(copied.bounds(), scene.view().bounds(), "{what}");
            assert!(hug::Stats::of(&copied) == hug::Stats::of(&scene.view()), "{what}");
            for r in &rays {
                let expected = scene.view().intersect(r);
                assert_same(&in_place.intersect(r), &expected, r, &what);
                assert_same(&copied.intersect(r), &expected, r, &what);
                assert_eq!(copied.occluded(r), expected.is_hit(), "{what}: {r:?}");
            }
        }
    }
}

/// Bytes of arenas with all kinds of records, and of the empty scene.
fn samples() -> Vec<(&'static str, Aligned)> {
    let mut samples = Vec::new();
    for (name, options) in structures() {
        let scene = build(&kit::clustered(900), &options);
        samples.push((name, Aligned::copy(scene.view().bytes())));
    }
    let nothing = build(&kit::empty(), &structures()[0].1);
    samples.push(("empty", Aligned::copy(nothing.view().bytes())));
    samples
}

#[test]
fn cut_short_anywhere() {
    for (name, bytes) in samples() {
        let headers = 0..HEADER.min(bytes.len());
        let lines = (HEADER..bytes.len()).step_by(64);
        for len in headers.chain(lines).chain([bytes.len() - 1]) {
            let error = View::open(&bytes[..len]).err();
            assert_eq!(error, Some(Error::Truncated), "{name}: {len} of {}", bytes.len());
        }
    }
}

#[test]
fn off_alignment() {
    for (name, bytes) in samples() {
        let mut moved = Aligned::filled(bytes.len() + 64, 0);
        for offset in [1, 2, 4, 8, 16, 32, 63] {
            let part = offset..offset + bytes.len();
            moved[part.clone()].copy_from_slice(&bytes);
            assert_eq!(View::open(&moved[part]).err(), Some(Error::Alignment), "{name}: {offset}");
        }
    }
    assert!(View::open(&[]).is_err());
}

#[test]
fn not_an_arena_at_all() {
    for (name, bytes) in samples() {
        for at in 0..8 {
            for bit in 0..8 {
                let mut other = bytes.clone();
                other[at] ^= 1 << bit;
                assert_eq!(View::open(&other).err(), Some(Error::Magic), "{name}: byte {at}");
            }
        }
    }
    // As some programs damage files: line ends, the eighth bit.
    let text = Aligned::copy(&[b"hug-rt\n\n", &[0; 1024][..]].concat());
    assert_eq!(View::open(&text).err(), Some(Error::Magic));
    assert_eq!(View::open(&Aligned::filled(4096, 0)).err(), Some(Error::Magic));
    assert_eq!(View::open(&Aligned::filled(4096, 0xff)).err(), Some(Error::Magic));
}

#[test]
fn another_version_or_byte_order() {
    for (name, bytes) in samples() {
        let version = get32(&bytes, VERSION);
        for other in [0, version + 1, version << 24, u32::MAX] {
            let mut damaged = bytes.clone();
            put32(&mut damaged, VERSION, other);
            assert_eq!(View::open(&damaged).err(), Some(Error::Version), "{name}: {other}");
        }
        let order = get32(&bytes, BYTE_ORDER);
        // A whole header of the other endianness, where the version is swapped too.
        let mut swapped = bytes.clone();
        put32(&mut swapped, BYTE_ORDER, order.swap_bytes());
        put32(&mut swapped, VERSION, version.swap_bytes());
        assert_eq!(View::open(&swapped).err(), Some(Error::Endianness), "{name}");
    }
}

#[test]
fn another_size() {
    for (name, bytes) in samples() {
        let size = get64(&bytes, BYTES);
        assert_eq!(size as usize, bytes.len(), "{name}");
        let mut longer = Aligned::filled(bytes.len() + 256, 0);
        longer[..bytes.len()].copy_from_slice(&bytes);
        for other in [0, 1, 64, size - 64, size - 1, size + 1, size + 64, size + 256] {
            put64(&mut longer, BYTES, other);
            assert_eq!(View::open(&longer).err(), Some(Error::Sections), "{name}: {other}");
        }
        for other in [size + 257, 1 << 32, 1 << 63, u64::MAX] {
            put64(&mut longer, BYTES, other);
            assert_eq!(View::open(&longer).err(), Some(Error::Truncated), "{name}: {other}");
        }
    }
}

/// Sections that are not where the counts put them.
#[test]
fn another_header() {
    for (name, bytes) in samples() {
        let open = |place: usize, wrong: u64| {
            let mut damaged = bytes.clone();
            put64(&mut damaged, place, wrong);
            View::open(&damaged).err()
        };
        let corrupt = |place: usize, wrong: u64| {
            let error = open(place, wrong);
            assert_eq!(error, Some(Error::Corrupt), "{name}: {wrong} at {place}");
        };
        let elsewhere = |place: usize, wrong: u64| {
            let error = open(place, wrong);
            assert_eq!(error, Some(Error::Sections), "{name}: {wrong} at {place}");
        };
        let (structure, levels) = (get32(&bytes, STRUCTURE), get32(&bytes, LEVELS));
        let both = |structure: u32, levels: u32| u64::from(levels) << 32 | u64::from(structure);
        for wrong in [0, 4, u32::MAX] {
            corrupt(STRUCTURE, both(wrong, levels));
        }
        for wrong in [17, u32::MAX] {
            corrupt(STRUCTURE, both(structure, wrong));
        }
        for unit in [0.0, -1.0, 0.75, 3.0, 1e-60, 1e60, f64::NAN, f64::INFINITY] {
            corrupt(UNIT, unit.to_bits());
        }
        let grids = get64(&bytes, GRIDS + 8);
        for wrong in [1, grids.wrapping_sub(1), grids + 1, 1 << 57, u64::MAX] {
            if wrong != get64(&bytes, FRAMES + 8) && wrong != 0 {
                elsewhere(FRAMES + 8, wrong);
            }
        }
        elsewhere(FRAMES, get64(&bytes, FRAMES) + 64);
        for section in SECTIONS {
            let (offset, count) = (get64(&bytes, section), get64(&bytes, section + 8));
            let past = bytes.len() as u64 + 64;
            for wrong in [0, 1, offset - 64, offset + 4, offset + 64, past, 1 << 63, u64::MAX - 63]
            {
                elsewhere(section, wrong);
            }
            for wrong in [2 * count + 64, 1 << 31, 1 << 60, u64::MAX, u64::MAX / 48] {
                elsewhere(section + 8, wrong);
            }
            // What stays within the padding is found by the records. One triangle more
            // may find room in it, and does no harm there.
            let none = [0].into_iter().filter(|_| count > 0);
            for wrong in [count.wrapping_sub(1), count + 2].into_iter().chain(none) {
                let error = open(section + 8, wrong);
                assert!(is_damage(error), "{name}: {wrong} at {section} + 8: {error:?}");
            }
        }
    }
}

/// Two sections of records of one size that make up for each other.
#[test]
fn another_border_between_sections() {
    for (name, mut bytes) in samples() {
        let (voxels, refs) = (get64(&bytes, VOXELS + 8), get64(&bytes, REFS + 8));
        if refs >= 16 {
            let border = get64(&bytes, REFS);
            put64(&mut bytes, VOXELS + 8, voxels + 16);
            put64(&mut bytes, REFS, border + 64);
            put64(&mut bytes, REFS + 8, refs - 16);
            let error = View::open(&bytes).err();
            assert!(is_damage(error), "{name}: {error:?}");
        }
    }
}
