//! All hits, filters and culling against exact arithmetic that shares nothing with the
//! library, in every structure and on every instruction set.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, assert_same, build, configurations, ray, soups};
use hug::{Hit, Isa, Ray, Scene, View, force_isa, intersect_triangle};
use hug_kit::{Mesh, arbiter, rays};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A ray and all that it hits, with the side that it comes from.
struct Case {
    ray: Ray,
    hits: Vec<(Hit, bool)>,
}

/// The records that exact arithmetic asks for; normals are those of the triangles alone.
fn case(mesh: &Mesh, kit_ray: &rays::Ray) -> Case {
    let ray = ray(kit_ray);
    let triangles: Vec<_> = mesh.triangles().collect();
    let named = (0..).zip(&triangles).map(|(prim, corners)| (0, prim, *corners));
    let record = |found: arbiter::Closest| {
        let any = Ray { skip_geom: hug::NONE, skip_prim: hug::NONE, ..ray };
        let alone = intersect_triangle(&any, &triangles[found.prim as usize]);
        let exact = found.hit;
        let hit = Hit { t: exact.t, u: exact.u, v: exact.v, prim: found.prim, ..alone };
        assert_same(&Hit { prim: found.prim, ..alone }, &hit, &ray, &"a triangle alone");
        (hit, exact.front)
    };
    Case { ray, hits: arbiter::all(kit_ray, named).into_iter().map(record).collect() }
}

fn first(hits: &[(Hit, bool)], ray: &Ray, keep: impl Fn(&(Hit, bool)) -> bool) -> Hit {
    hits.iter().find(|hit| keep(hit)).map_or(Hit::miss(ray.tmax), |hit| hit.0)
}

#[track_caller]
fn same(found: &[Hit], expected: &[(Hit, bool)], ray: &Ray, what: &str) {
    let expected: Vec<Hit> = expected.iter().map(|hit| hit.0).collect();
    let bits = |hits: &[Hit]| bytemuck::cast_slice::<Hit, [u32; 10]>(hits).to_vec();
    assert!(bits(found) == bits(&expected), "{what}: {ray:?}\n{found:?}\n{expected:?}");
}

/// The hits, in room for all of them or less, and from any of them on.
fn compare_all(view: View<'_>, Case { ray, hits }: &Case, what: &str) {
    let n = hits.len();
    let mut room = vec![Hit::miss(0.0); n + 1];
    for capacity in [n + 1, n, n.saturating_sub(1), n / 2, 1, 0] {
        let room = &mut room[..capacity.min(n + 1)];
        let found = view.intersect_all(ray, None, room);
        assert_eq!(found.more, n > room.len(), "{what}, room for {capacity}: {ray:?}");
        same(&room[..found.count], &hits[..n.min(room.len())], ray, what);
        let mut all = room[..found.count].to_vec();
        let mut more = found.more;
        while more && !all.is_empty() {
            let found = view.intersect_all(ray, all.last(), room);
            all.extend(&room[..found.count]);
            more = found.more;
        }
        same(&all[..], if capacity > 0 { hits } else { &[] }, ray, "one call after the other");
    }
    same(&view.hits(ray).collect::<Vec<_>>(), hits, ray, what);
}

/// What a filter accepts: some triangles.
fn accepts(hit: &Hit, kind: u32) -> bool {
    hit.prim % kind == kind - 1
}

fn compare_filtered(view: View<'_>, Case { ray, hits }: &Case, what: &str) {
    for kind in [1, 2, 7] {
        let mut offered = Vec::new();
        let found = view.intersect_filtered(ray, |hit| {
            offered.push(*hit);
            accepts(hit, kind)
        });
        let expected = first(hits, ray, |(hit, _)| accepts(hit, kind));
        assert_same(&found, &expected, ray, &what);
        // Each once, with the hit that it is, and none behind the one accepted.
        let all = hits.len().min(
            1 + hits.partition_point(|(hit, _)| {
                (hit.t, hit.geom, hit.prim) < (expected.t, expected.geom, expected.prim)
            }),
        );
        offered.sort_by(|a, b| (a.t, a.prim).partial_cmp(&(b.t, b.prim)).expect("no NaN"));
        same(&offered, &hits[..all], ray, what);
        let any = view.occluded_filtered(ray, |hit| accepts(hit, kind));
        assert_eq!(any, expected.is_hit(), "{what}: {ray:?}");
    }
}

const SIDES: [(u32, bool, bool); 3] = [
    (Ray::CULL_BACK, true, false),
    (Ray::CULL_FRONT, false, true),
    (Ray::CULL_BACK | Ray::CULL_FRONT, false, false),
];

fn compare_culled(view: View<'_>, Case { ray, hits }: &Case, what: &str) {
    for (flags, front, back) in SIDES {
        let ray = ray.with_flags(flags);
        let expected = first(hits, &ray, |hit| if hit.1 { front } else { back });
        let what = format!("{what}, flags {flags}");
        assert_same(&view.intersect(&ray), &expected, &ray, &what);
        assert_same(&view.intersect_brute(&ray), &expected, &ray, &what);
        assert_eq!(view.occluded(&ray), expected.is_hit(), "{what}: {ray:?}");
        let all: Vec<_> =
            hits.iter().copied().filter(|hit| if hit.1 { front } else { back }).collect();
        same(&view.hits(&ray).collect::<Vec<_>>(), &all, &ray, &what);
    }
}

/// Streams with a filter and with flags.
fn compare_streams(scene: &Scene, cases: &[Case], what: &str) {
    let view = scene.view();
    let rays: Vec<Ray> = cases.iter().map(|case| case.ray).collect();
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    let mut occluded = vec![false; rays.len()];
    let mut offered = vec![0; rays.len()];
    view.intersect_n_filtered(&rays, &mut hits, |i, hit| {
        offered[i] += 1;
        accepts(hit, 2)
    });
    view.occluded_n_filtered(&rays, &mut occluded, |_, hit| accepts(hit, 2));
    for (i, case) in cases.iter().enumerate() {
        let expected = first(&case.hits, &case.ray, |(hit, _)| accepts(hit, 2));
        assert_same(&hits[i], &expected, &case.ray, &format!("{what}, filtered stream"));
        assert_eq!(occluded[i], expected.is_hit(), "{what}: {:?}", case.ray);
        assert!(offered[i] <= case.hits.len(), "{what}: {:?}", case.ray);
    }
    for (flags, front, back) in SIDES {
        let rays: Vec<Ray> = rays.iter().map(|ray| ray.with_flags(flags)).collect();
        view.intersect_n(&rays, &mut hits);
        view.occluded_n(&rays, &mut occluded);
        for (i, case) in cases.iter().enumerate() {
            let expected = first(&case.hits, &rays[i], |hit| if hit.1 { front } else { back });
            assert_same(&hits[i], &expected, &rays[i], &format!("{what}, culled stream"));
            assert_eq!(occluded[i], expected.is_hit(), "{what}: {:?}", rays[i]);
        }
    }
}

/// Runs `f` on each of some items, on as many threads as there are processors.
fn on_all_processors<T: Sync>(items: &[T], f: impl Fn(&T) + Sync) {
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(item) = items.get(next.fetch_add(1, Ordering::Relaxed)) {
                    f(item);
                }
            });
        }
    });
}

/// The one test that forces instruction sets, which are the whole process's.
#[test]
fn exact_in_every_structure_on_every_instruction_set() {
    let sets: Vec<Isa> = Isa::ALL.into_iter().filter(|&i| force_isa(i)).collect();
    let soups = soups();
    let all: Vec<OnceLock<Vec<Case>>> = soups.iter().map(|_| OnceLock::new()).collect();
    on_all_processors(&soups.iter().zip(&all).collect::<Vec<_>>(), |((soup, mesh), cases)| {
        let rays = adversarial_rays(mesh, 41, 15);
        let cases = cases.get_or_init(|| rays.iter().map(|(_, r)| case(mesh, r)).collect());
        let several = cases.iter().filter(|case| case.hits.len() > 1).count();
        assert!(several > 0 || mesh.indices.len() < 2, "{soup}: no ray hit two triangles");
    });
    let mut scenes = Vec::new();
    for ((soup, mesh), cases) in soups.iter().zip(&all) {
        for (name, options) in configurations() {
            let cases = cases.get().expect("they were made");
            scenes.push((format!("{soup} in {name}"), cases, build(mesh, &options)));
        }
    }
    assert!(scenes.len() > 100);
    for set in sets {
        assert!(force_isa(set), "{set:?}");
        on_all_processors(&scenes, |(what, cases, scene)| {
            let what = format!("{what}, {set:?}");
            for case in *cases {
                compare_all(scene.view(), case, &what);
                compare_filtered(scene.view(), case, &what);
                compare_culled(scene.view(), case, &what);
            }
            compare_streams(scene, cases, &what);
        });
    }
}
