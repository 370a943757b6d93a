//! The closest and any hit, where the sieve alone can tell and where it must not: at the ends of the range, at edges,
//! of triangles that the ray does not see. With the tree and without, one by one and in streams.

use super::{built, trees};
use crate::common::{adversarial_rays, assert_same, build, ray};
use hug::{Hit, Options, Quality, Ray, View};
use hug_kit::{Mesh, soups};

/// What the definition says, for rays that begin or end at the closest hit or next to it; how many
/// of these hit something.
fn check(view: &View<'_>, one: &Ray, name: &str) -> usize {
    let hit = view.intersect_brute(one);
    let near = [hit.t.next_down(), hit.t, hit.t.next_up()];
    let any = [f32::NEG_INFINITY, f32::MIN, -0.0, f32::MAX, f32::INFINITY, f32::NAN];
    let (starts, ends) = (near.into_iter().chain(any), near.into_iter().chain(any));
    let mut rays = Vec::new();
    for tmin in starts.chain([one.tmin]) {
        for tmax in ends.clone().chain([one.tmax]) {
            let within = Ray { tmin, tmax, ..*one };
            let beside = Ray { skip_geom: hit.geom, skip_prim: hit.prim, ..within };
            let masked = Ray { mask: 2, ..within };
            let culled = [Ray::CULL_BACK, Ray::CULL_FRONT].map(|flags| Ray { flags, ..within });
            rays.extend([within, beside, masked, culled[0], culled[1]]);
        }
    }
    let mut stream = vec![false; rays.len()];
    view.occluded_n(&rays, &mut stream);
    // Every other one from elsewhere, so that they are not taken for rays that are alike.
    let (lower, upper) = view.bounds();
    let away = std::array::from_fn(|k| upper[k] + 0.5 * (upper[k] - lower[k]));
    let away = Ray::new(away, std::array::from_fn(|k| lower[k] - away[k]));
    let mixed: Vec<Ray> = rays.iter().flat_map(|ray| [*ray, away]).collect();
    let mut hits = vec![Hit::miss(7.0); mixed.len()];
    view.intersect_n(&mixed, &mut hits);
    let expected = view.intersect_brute(&away);
    for hit in hits.iter().skip(1).step_by(2) {
        assert_same(hit, &expected, &away, &name);
    }
    let mut found = 0;
    for ((ray, in_stream), closest) in rays.iter().zip(stream).zip(hits.iter().step_by(2)) {
        let hit = view.intersect_brute(ray);
        assert_same(&view.intersect(ray), &hit, ray, &name);
        assert_same(closest, &hit, ray, &name);
        let expected = hit.is_hit();
        assert_eq!(view.occluded(ray), expected, "{name}: {ray:?}");
        assert_eq!(in_stream, expected, "{name}, in a stream: {ray:?}");
        found += usize::from(expected);
    }
    found
}

/// No tree.
fn fast() -> Options {
    Options { quality: Quality::Fast, ..Options::default() }
}

#[test]
fn any_hit_at_the_ends_of_the_range() {
    for (name, mesh, options) in built() {
        for options in [options, fast()] {
            let scene = build(&mesh, &options);
            let found: usize = adversarial_rays(&mesh, 11, 3)
                .iter()
                .map(|(_, one)| check(&scene.view(), &ray(one), name))
                .sum();
            assert!(found > 200, "{name}: {found}");
        }
    }
}

/// Far from the origin and close to it, large and small: errors grow with what they are of.
#[test]
fn any_hit_at_any_scale() {
    for (scale, shift) in [(1e-9, 0.0), (1.0, 1e4), (1e-3, 1.0), (1e8, 1e9)] {
        let from = soups::tangle(3, 200);
        let mut mesh = Mesh::default();
        for i in 0..200 {
            mesh.push(from.triangle(i).map(|v| v.map(|x| x * scale + shift)));
        }
        for options in trees().into_iter().chain([fast()]) {
            let scene = build(&mesh, &options);
            let rays = adversarial_rays(&mesh, 12, 3);
            let found: usize =
                rays.iter().map(|(_, one)| check(&scene.view(), &ray(one), "scale")).sum();
            assert!(found > 50, "{scale}: {found}");
        }
    }
}

/// Directions so short that what is met has no t.
#[test]
fn what_is_met_too_late_is_no_hit() {
    let mesh = soups::tangle(4, 100);
    for options in trees() {
        let scene = build(&mesh, &options);
        let mut found = 0;
        for (_, one) in adversarial_rays(&mesh, 13, 5) {
            for speed in [1e-37, 1e-38, 1e-39, 1e-40] {
                let one = ray(&one);
                let slow = Ray { dir: one.dir.map(|d| d * speed), ..one };
                found += check(&scene.view(), &slow, "slow");
            }
        }
        assert!(found > 50, "{found}");
    }
}

/// A hit whose t is less than half the least denormal behind the origin, and rounds to where the
/// range begins, of a triangle as large as it can be.
#[test]
fn what_rounds_to_the_start_is_a_hit() {
    let large = 2f32.powi(27);
    let mut mesh = Mesh::default();
    for k in 0..16 {
        let z = if k == 0 { f32::from_bits(1) } else { k as f32 * 2f32.powi(22) };
        mesh.push([[0.0, 0.0, z], [large, 0.0, z], [0.0, large, z]]);
    }
    for options in trees() {
        let scene = build(&mesh, &options);
        let view = scene.view();
        for tmin in [0.0, -0.0] {
            for x in [0.0, 1.0, 1e6] {
                let one = Ray { tmin, ..Ray::new([x, x, 0.0], [0.0, 0.0, -1e6]) };
                let expected = view.intersect_brute(&one);
                assert!(expected.is_hit() && expected.t == 0.0, "{expected:?}");
                let rays = vec![one; 600];
                let (mut hits, mut any) = (vec![Hit::miss(7.0); 600], vec![false; 600]);
                view.intersect_n(&rays, &mut hits);
                view.occluded_n(&rays, &mut any);
                hits.iter().for_each(|hit| assert_same(hit, &expected, &one, &"start"));
                assert!(any.iter().all(|&any| any));
            }
        }
    }
}
