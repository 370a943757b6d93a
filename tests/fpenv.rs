//! A caller that flushes denormals, or rounds another way, gets the same bytes
//! and the same hits.
#![allow(missing_docs)]
#![cfg(target_arch = "x86_64")]

mod common;

use common::aligned::Aligned;
use common::{adversarial_rays, build, configurations, ray, soups, structures};
use hug::{Filter, Geometry, Hit, Options, Ray, Scene, Stats, View};
use hug_kit::{Mesh, soups as kit};
use std::arch::asm;

/// Bits of the control register to turn over: flush to zero, denormals are zero, rounding,
/// and the masks of exceptions.
const MODES: [(&str, u32); 7] = [
    ("FTZ", 0x8000),
    ("DAZ", 0x0040),
    ("FTZ and DAZ", 0x8040),
    ("rounding down", 0x2000),
    ("rounding up", 0x4000),
    ("rounding to zero, FTZ and DAZ", 0xe040),
    ("invalid operations, divisions by zero and overflows stop the program", 0x0680),
];
const ALL: u32 = 0xe040 | 0x1f80;

fn control() -> u32 {
    let mut word = 0u32;
    // SAFETY: stores the register to a variable.
    unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut word) };
    word
}

fn set_control(word: u32) {
    // SAFETY: only mode bits are ever changed; no code of these tests raises what is unmasked.
    unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const word) };
}

/// Runs `f` as a caller in this mode would; the mode must survive the call.
#[inline(never)]
fn in_mode<R>(mode: (&str, u32), f: impl FnOnce() -> R) -> R {
    let normal = control();
    set_control((normal ^ mode.1) & !0x3f);
    let result = f();
    let kept = control();
    set_control(normal);
    assert_eq!((kept ^ normal) & ALL, mode.1, "{}: the caller's mode was changed", mode.0);
    result
}

/// The usual soups, and one whose coordinates are all denormal.
fn all_soups() -> Vec<(&'static str, Mesh)> {
    let mut all = soups();
    all.push(("denormal", kit::rescaled(&kit::tangle(1, 600), 1e-39)));
    all
}

fn bits(hit: Hit) -> [u32; 10] {
    bytemuck::cast(hit)
}

#[test]
fn builds_make_the_same_bytes() {
    for (name, mesh) in all_soups() {
        for (kind, options) in configurations() {
            let normal = build(&mesh, &options);
            for mode in MODES {
                let made = in_mode(mode, || build(&mesh, &options));
                let same = made.view().bytes() == normal.view().bytes();
                assert!(same, "{name} in {kind}, {}", mode.0);
            }
        }
    }
}

#[test]
fn queries_find_the_same() {
    for (name, mesh) in all_soups() {
        let rays: Vec<Ray> = adversarial_rays(&mesh, 7, 40).iter().map(|(_, r)| ray(r)).collect();
        for (kind, options) in structures() {
            let scene = build(&mesh, &options);
            let trace = || -> Vec<_> {
                let view = scene.view();
                let one = |r| (bits(view.intersect(r)), view.occluded(r));
                rays.iter().map(one).collect()
            };
            let normal = trace();
            for mode in MODES {
                let found = in_mode(mode, trace);
                for ((found, normal), ray) in found.iter().zip(&normal).zip(&rays) {
                    assert_eq!(found, normal, "{name} in {kind}, {}: {ray:?}", mode.0);
                }
            }
        }
    }
}

/// Opening computes with the records' numbers to check them.
#[test]
fn arenas_open_all_the_same() {
    for (name, mesh) in all_soups() {
        for (kind, options) in structures() {
            let bytes = Aligned::copy(build(&mesh, &options).view().bytes());
            for mode in MODES {
                let opened = in_mode(mode, || View::open(&bytes).err());
                assert_eq!(opened, None, "{name} in {kind}, {}", mode.0);
            }
        }
    }
}

#[test]
fn statistics_are_the_same() {
    for (name, mesh) in all_soups() {
        for (kind, options) in structures() {
            let scene = build(&mesh, &options);
            let normal = Stats::of(&scene.view());
            for mode in MODES {
                let counted = in_mode(mode, || Stats::of(&scene.view()));
                assert!(counted == normal, "{name} in {kind}, {}", mode.0);
            }
        }
    }
}

/// Denormal options are in range, whatever the processor makes of them.
#[test]
fn denormal_options_are_options() {
    let mesh = kit::rescaled(&kit::tangle(1, 600), 1e-38);
    let soup = [Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
    let mut at = [0.0; 15];
    at[..2].copy_from_slice(&[1e-40, 3e-39]);
    let thresholds = Filter::Thresholds { count: 2, at };
    let options = [
        Options { connectivity: 1e-40, ..Options::default() },
        Options { filter: thresholds, ..Options::default() },
        Options { filter: Filter::TwoLevels(1e-40), ..Options::default() },
    ];
    for options in options {
        let options = Options { structure: hug::Structure::Hug, ..options };
        let normal = Scene::build(&soup, &options).expect("options in range");
        for mode in MODES {
            let made = in_mode(mode, || Scene::build(&soup, &options));
            let bytes = made.as_ref().map(|scene| scene.view().bytes());
            let same = bytes.is_ok_and(|bytes| bytes == normal.view().bytes());
            assert!(same, "{}: {options:?}, {:?}", mode.0, made.err());
        }
    }
}

/// In a C descriptor 0 stands for a default, and a denormal does not.
#[cfg(feature = "capi")]
#[test]
fn denormal_numbers_of_a_descriptor_are_not_zero() {
    use hug::capi::types::{HUG_OK, hug_build_desc, hug_geometry};
    use hug::capi::{hug_build, hug_data, hug_free};
    let mesh = kit::rescaled(&kit::tangle(1, 600), 1e-38);
    // SAFETY: zeros are a value of every field.
    let mut geometry: hug_geometry = unsafe { std::mem::zeroed() };
    geometry.vertices = mesh.vertices.as_flattened().as_ptr();
    geometry.vertex_count = mesh.vertices.len();
    geometry.indices = mesh.indices.as_ptr().cast();
    geometry.triangle_count = mesh.indices.len();
    geometry.index_type = hug::capi::types::HUG_INDEX_U32;
    // SAFETY: as above.
    let mut desc: hug_build_desc = unsafe { std::mem::zeroed() };
    desc.struct_size = size_of::<hug_build_desc>();
    (desc.geometries, desc.geometry_count) = (&raw const geometry, 1);
    desc.structure = hug::Structure::Hug as u32;
    desc.connectivity = 1e-40;
    let make = || {
        let (mut scene, mut len) = (std::ptr::null_mut(), 0);
        // SAFETY: the descriptor and its memory are valid.
        unsafe {
            assert_eq!(hug_build(&raw const desc, &raw mut scene), HUG_OK);
            let data = hug_data(scene, &raw mut len).cast::<u8>();
            let bytes = std::slice::from_raw_parts(data, len).to_vec();
            hug_free(scene);
            bytes
        }
    };
    let normal = make();
    for mode in MODES {
        assert!(in_mode(mode, make) == normal, "{}", mode.0);
    }
}
