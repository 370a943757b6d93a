//! Bytes damaged at random, and arenas made to be hostile: they do not open, or
//! every query on them ends.
#![allow(missing_docs)]

mod common;

use common::aligned::Aligned;
use common::layout::*;
use common::{adversarial_rays, build, configurations, ray, soups};
use hug::{Counters, Hit, Isa, Probe, Ray, Stats, View, force_isa};
use hug_kit::random::Random;
use hug_kit::soups as kit;

/// Does all there is to do with a scene; that it ends is the test.
fn query(view: &View<'_>, rays: &[Ray]) {
    let most = view.most_steps();
    for r in rays {
        let mut counters = Counters::default();
        let hit = view.intersect_counted(r, &mut counters);
        let steps = counters.grids + counters.voxels + counters.tests;
        assert!(steps <= most, "{r:?}: {steps} steps, {most} should suffice");
        // A damaged arena gives any hits, but what it says is a hit is one.
        let inside = |t: f32| r.tmin <= t && t <= r.tmax;
        assert!(!hit.is_hit() || inside(hit.t), "{r:?} hit {hit:?}");
        let _ = (view.intersect(r), view.occluded(r), view.intersect_brute(r));
        let all = view.hits(r).fold(r.tmin, |before, hit| {
            assert!(before <= hit.t && inside(hit.t), "{r:?} hit {hit:?} after {before}");
            hit.t
        });
        let _ = view.closest_point(&Probe::new(r.org, all));
        let _ = view.closest_point(&Probe::new(r.org, f32::INFINITY));
    }
    let _ = (Stats::of(view), view.bounds(), view.bytes().len());
    // As many as are in flight, and some that take their places; on any instruction set, as
    // tests force them side by side.
    let mut many: Vec<Ray> = rays.iter().cycle().take(rays.len().max(40)).copied().collect();
    // First those that go together, from one point.
    for r in rays {
        let together = (0..64).map(|i| {
            let aside = |k: usize| [i % 8, i / 8, 0][k] as f32 * 1e-3;
            Ray::new(r.org, [0, 1, 2].map(|k| r.dir[k] + aside(k))).with_range(0.0, r.tmax)
        });
        many.splice(0..0, together);
    }
    let (mut hits, mut occluded) = (vec![Hit::miss(0.0); many.len()], vec![false; many.len()]);
    for set in Isa::ALL.into_iter().filter(|&set| force_isa(set)) {
        view.intersect_n(&many, &mut hits);
        view.occluded_n(&many, &mut occluded);
        for (r, hit) in many.iter().zip(&hits) {
            let inside = r.tmin <= hit.t && hit.t <= r.tmax;
            assert!(!hit.is_hit() || inside, "{set:?}: {r:?} hit {hit:?}");
        }
    }
}

/// One change, of a kind that files and attackers make.
fn mutate(bytes: &mut [u8], random: &mut Random) {
    let words = bytes.len() / 4;
    // Half of them where the structure is, and not the triangles.
    let structure = if words > 64 { get64(bytes, TRIANGLES) as usize / 4 } else { words };
    let reach = if random.chance(0.5) { structure.clamp(1, words) } else { words };
    let at = 4 * random.below(reach);
    let word = get32(bytes, at);
    let new = match random.below(8) {
        0 => random.bits(),
        1 => word ^ 1 << random.below(32),
        2 => word.wrapping_add(1),
        3 => word.wrapping_sub(1),
        4 => get32(bytes, 4 * random.below(words)),
        5 => [0, 1, u32::MAX, 1 << 31, 0x7f80_0000, 0x7fc0_0000][random.below(6)],
        6 => word & !(0xff << (8 * random.below(4))) | random.bits() & 0xff,
        _ => word.rotate_left(8 * random.below(4) as u32),
    };
    put32(bytes, at, new);
}

#[test]
fn random_damage() {
    const STORMS: usize = 20_000;
    let mut random = Random::stream(4711);
    let meshes = [kit::tangle(1, 60), kit::clustered(90), kit::lattice(4, 60, 8), kit::single()];
    let (mut opened, mut refused) = (0, 0);
    let samples: Vec<_> = meshes
        .iter()
        .flat_map(|mesh| {
            let rays: Vec<Ray> = adversarial_rays(mesh, 3, 1).iter().map(|(_, r)| ray(r)).collect();
            configurations().into_iter().map(move |(_, options)| {
                (Aligned::copy(build(mesh, &options).view().bytes()), rays.clone())
            })
        })
        .collect();
    for storm in 0..STORMS {
        let (bytes, rays) = &samples[storm % samples.len()];
        let mut damaged = bytes.clone();
        for _ in 0..=random.below(4) {
            mutate(&mut damaged, &mut random);
        }
        if random.chance(0.2) {
            // A HUG that says it is a recursive grid.
            put32(&mut damaged, STRUCTURE, 2);
        }
        match View::open(&damaged) {
            Ok(view) => {
                opened += 1;
                query(&view, rays);
            }
            Err(_) => refused += 1,
        }
    }
    // Both must happen often, or the storm tests nothing.
    assert!(opened > STORMS / 20 && refused > STORMS / 20, "{opened} opened, {refused} refused");
}

/// Bytes that never were an arena, behind a header that says so.
#[test]
fn random_bytes() {
    let mut random = Random::stream(4712);
    let scene = build(&kit::tangle(1, 60), &configurations()[0].1);
    for _ in 0..2000 {
        let mut bytes = Aligned::copy(scene.view().bytes());
        let kept = [8, 16, 32, 96, HEADER][random.below(5)];
        for byte in &mut bytes[kept..] {
            *byte = random.bits() as u8;
        }
        assert!(View::open(&bytes).is_err(), "random bytes after {kept} opened");
    }
}

/// Frames that agree with themselves, of any place and size: nothing is found,
/// or something, but every walk ends and no index leaves the grid.
#[test]
fn frames_of_any_size() {
    let sizes = [1e-24_f32, 1e-20, 1e-10, 1e-3, 1.0, 4.0];
    let places = [0.0, -1.0, 1e-30, 1e10, -1e30, 1e38, -1e38];
    let mut random = Random::stream(4713);
    let (mut opened, mut tried) = (0, 0);
    for (name, mesh) in soups() {
        let rays: Vec<Ray> = adversarial_rays(&mesh, 3, 2).iter().map(|(_, r)| ray(r)).collect();
        for (_, options) in configurations() {
            let scene = build(&mesh, &options);
            let mut bytes = Aligned::copy(scene.view().bytes());
            for number in 0..count(&bytes, GRIDS) {
                let at = record(&bytes, GRIDS, number);
                for k in 0..3 {
                    let cell = sizes[random.below(sizes.len())];
                    put_f64(&mut bytes, at + LO + 8 * k, places[random.below(places.len())]);
                    put_f32(&mut bytes, at + CELL + 4 * k, cell);
                    put_f32(&mut bytes, at + INV_CELL + 4 * k, 1.0 / cell);
                }
            }
            tried += 1;
            if let Ok(view) = View::open(&bytes) {
                opened += 1;
                query(&view, &rays);
            }
        }
        assert!(opened > 0, "{name}: none of {tried} opened: are they still such frames?");
    }
}

/// Grids that all point to all grids of the next level, all in one place: a walk
/// that follows each pointer takes a time exponential in the levels. However
/// it is prevented, a ray must not enter more grids than the arena has bytes.
#[test]
fn towers_of_grids() {
    let rays = [
        Ray::new([0.0; 3], [1.0; 3]),
        Ray::new([-5.0, -5.0, -5.0], [1.0, 1.0, 1.0]),
        Ray::new([0.5, 0.25, 9.0], [0.0, 0.0, -1.0]),
    ];
    assert!(View::open(&towers(2, 1)).is_ok(), "this is how towers are built");
    for width in [2, 3, 4, 8, 64] {
        for levels in [3, 4, 8, 16] {
            let bytes = towers(levels, width);
            let Ok(view) = View::open(&bytes) else { continue };
            for r in &rays {
                let mut counters = Counters::default();
                let _ = view.intersect_counted(r, &mut counters);
                let (entered, size) = (counters.grids, bytes.len() as u64);
                let _ = view.closest_point(&Probe::new(r.org, f32::INFINITY));
                assert!(
                    entered <= size,
                    "{levels} levels of {width}: {entered} grids, {size} bytes"
                );
            }
        }
    }
}
