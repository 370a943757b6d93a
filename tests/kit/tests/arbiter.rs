//! The arbiter against hand-made cases and against exact comparison with neighbouring floats.

use hug_kit::arbiter::{
    Claim, Verdict, closest, hit, judge, judge_occluded, occluded, round_to_f32,
};
use hug_kit::rays::{Aim, Ray, adversarial, watertight};
use hug_kit::{Mesh, soups};
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;

const TRIANGLE: [[f32; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn down(x: f32, y: f32) -> Ray {
    Ray::new([x, y, 2.0], [0.0, 0.0, -1.0], 0.0, f32::INFINITY)
}

fn named(mesh: &Mesh) -> impl Iterator<Item = (u32, u32, [[f32; 3]; 3])> + '_ {
    mesh.triangles().enumerate().map(|(i, t)| (0, i as u32, t))
}

#[test]
fn the_boundary_belongs_to_the_triangle() {
    for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5), (0.5, 0.0), (0.25, 0.25)] {
        let found = hit(&down(x, y), &TRIANGLE).expect("a hit");
        assert_eq!((found.t, found.u, found.v), (2.0, x, y));
    }
    let outside = f32::from_bits(0.5f32.to_bits() + 1);
    assert_eq!(hit(&down(outside, 0.5), &TRIANGLE), None);
    assert_eq!(hit(&down(-f32::from_bits(1), 0.5), &TRIANGLE), None);
}

#[test]
fn what_is_no_query_hits_nothing() {
    let good = down(0.25, 0.25);
    let bad = [
        Ray { dir: [0.0, -0.0, 0.0], ..good },
        Ray { dir: [0.0, f32::NAN, -1.0], ..good },
        Ray { org: [f32::INFINITY, 0.0, 0.0], ..good },
        Ray { tmin: f32::NAN, ..good },
        Ray { tmax: f32::NAN, ..good },
        Ray { tmin: 3.0, tmax: 2.5, ..good },
        Ray { tmin: 2.5, ..good },
        Ray { tmax: 1.5, ..good },
        Ray { skip_geom: 7, skip_prim: 9, ..good },
    ];
    for ray in bad {
        assert_eq!(closest(&ray, [(7, 9, TRIANGLE)]), None, "{ray:?}");
        assert!(!occluded(&ray, [(7, 9, TRIANGLE)]));
    }
    let instant = Ray { tmin: 2.0, tmax: 2.0, ..good };
    assert!(hit(&instant, &TRIANGLE).is_some());
    let endless = Ray { tmin: f32::NEG_INFINITY, ..good };
    assert!(hit(&endless, &TRIANGLE).is_some());
    let in_plane = Ray::new([-1.0, 0.25, 0.0], [1.0, 0.0, 0.0], 0.0, 9.0);
    assert_eq!(hit(&in_plane, &TRIANGLE), None);
    let flat = [TRIANGLE[0], TRIANGLE[1], TRIANGLE[1]];
    assert_eq!(hit(&down(0.5, 0.0), &flat), None);
    let broken = [TRIANGLE[0], TRIANGLE[1], [0.0, f32::NAN, 0.0]];
    assert_eq!(hit(&good, &broken), None);
}

#[test]
fn verdicts() {
    let claim = |geom, prim, corners| Some(Claim { geom, prim, corners });
    let ray = down(0.25, 0.25);
    let low = claim(0, 5, TRIANGLE);
    let tied = claim(0, 4, TRIANGLE);
    let high = claim(0, 9, TRIANGLE.map(|[x, y, _]| [x, y, 1.0]));
    let aside = claim(0, 1, TRIANGLE.map(|[x, y, z]| [x + 3.0, y, z]));
    let judge = |a: Option<Claim>, b: Option<Claim>| judge(&ray, a.as_ref(), b.as_ref());
    assert_eq!(judge(low, low), Verdict::Both);
    assert_eq!(judge(None, None), Verdict::Both);
    assert_eq!(judge(high, low), Verdict::Ours);
    assert_eq!(judge(low, high), Verdict::Theirs);
    assert_eq!(judge(tied, low), Verdict::Ours);
    assert_eq!(judge(low, tied), Verdict::Theirs);
    assert_eq!(judge(low, None), Verdict::Ours);
    assert_eq!(judge(None, low), Verdict::Theirs);
    assert_eq!(judge(None, aside), Verdict::Ours);
    assert_eq!(judge(aside, None), Verdict::Theirs);
    assert_eq!(judge(aside, aside), Verdict::Theirs);
    let scene = || [(0, 5, TRIANGLE)];
    assert_eq!(judge_occluded(&ray, true, true, scene()), Verdict::Both);
    assert_eq!(judge_occluded(&ray, true, false, scene()), Verdict::Ours);
    assert_eq!(judge_occluded(&ray, false, true, scene()), Verdict::Theirs);
    assert_eq!(judge_occluded(&ray, false, false, scene()), Verdict::Theirs);
}

#[test]
fn the_filter_rejects_no_hit() {
    let meshes = [
        soups::tangle(1, 60),
        soups::slivers(2, 60),
        soups::stacked(3, 60),
        soups::lattice(4, 60, 8),
        soups::mixed_scales(5, 60),
        soups::rescaled(&soups::tangle(6, 60), 1e-30),
        soups::rescaled(&soups::tangle(7, 60), 1e30),
    ];
    let mut total = 0;
    for (seed, mesh) in meshes.iter().enumerate() {
        let bounds = mesh.bounds().expect("a box");
        for aim in Aim::ALL {
            for ray in adversarial(aim, mesh, &bounds, [8; 3], seed as u64, 30) {
                let plain = named(mesh).any(|(_, _, tri)| hit(&ray, &tri).is_some());
                assert_eq!(plain, closest(&ray, named(mesh)).is_some(), "{aim:?} {ray:?}");
                assert_eq!(plain, occluded(&ray, named(mesh)));
                total += u32::from(plain);
            }
        }
    }
    assert!(total > 700, "adversarial rays hardly hit: {total}");
}

#[test]
fn nothing_slips_through_a_closed_mesh() {
    for scale in [1e-30, 1e-3, 1.0, 1e6, 1e30] {
        let sphere = soups::bumpy_sphere(6, scale, [0.3 * scale, -scale, 2.0 * scale]);
        for ray in watertight(&sphere, 9, 300) {
            assert!(closest(&ray, named(&sphere.mesh)).is_some(), "{scale} {ray:?}");
        }
    }
}

fn ratio(x: f32) -> BigRational {
    BigRational::from_float(x).expect("finite")
}

/// The floats next to a finite, positive `x`; past the largest, what the next would be.
fn neighbours(x: f32) -> [BigRational; 2] {
    let below = if x == 0.0 { -f32::from_bits(1) } else { f32::from_bits(x.to_bits() - 1) };
    let above = match x.to_bits() + 1 {
        bits if f32::from_bits(bits).is_finite() => ratio(f32::from_bits(bits)),
        _ => BigRational::from_integer(BigInt::from(1) << 128),
    };
    [ratio(below), above]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn rounding_keeps_floats(bits in 0u32..0x7f80_0000) {
        let x = f32::from_bits(bits);
        prop_assert_eq!(round_to_f32(&ratio(x)).to_bits(), bits);
        let negative = round_to_f32(&ratio(-x));
        prop_assert_eq!(negative, -x);
        prop_assert!(bits != 0 || negative.is_sign_positive());
    }

    #[test]
    fn rounding_takes_the_nearest(n in 1u64.., d in 1u64.., shift in -215i32..190) {
        let mut x = BigRational::new(n.into(), d.into());
        let power = BigRational::from_integer(BigInt::from(1) << shift.unsigned_abs());
        x = if shift < 0 { x / power } else { x * power };
        let rounded = round_to_f32(&x);
        if rounded.is_finite() {
            let [below, above] = neighbours(rounded);
            let own = ratio(rounded);
            let two = BigRational::from_integer(2.into());
            prop_assert!((&below + &own) / &two <= x && x <= (&own + &above) / &two);
        } else {
            let limit = (BigInt::from(1) << 128) - (BigInt::from(1) << 103);
            prop_assert!(x >= BigRational::from_integer(limit));
        }
    }

    #[test]
    fn ties_go_to_even(bits in 0u32..0x7f7f_ffff) {
        let [a, b] = [bits, bits + 1].map(|b| ratio(f32::from_bits(b)));
        let middle = (a + b) / BigRational::from_integer(2.into());
        let even = if bits % 2 == 0 { bits } else { bits + 1 };
        prop_assert_eq!(round_to_f32(&middle).to_bits(), even);
    }

    #[test]
    fn hits_satisfy_their_equation(seed in 0u64..500) {
        let mesh = soups::tangle(seed, 4);
        let bounds = mesh.bounds().expect("a box");
        for ray in adversarial(Aim::Axis, &mesh, &bounds, [2; 3], seed, 4) {
            for tri in mesh.triangles() {
                let Some(found) = hit(&ray, &tri) else { continue };
                for k in 0..3 {
                    let [a, b, c] = tri.map(|v| ratio(v[k]));
                    let on_ray = ratio(ray.org[k]) + &found.exact_t * ratio(ray.dir[k]);
                    let on_triangle = &a + &found.exact_u * (b - &a) + &found.exact_v * (c - &a);
                    prop_assert_eq!(on_ray, on_triangle);
                }
            }
        }
    }
}
