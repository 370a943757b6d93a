//! Rays from one point: streams of them, which go together, against single rays, bit for
//! bit, on every instruction set.
#![allow(missing_docs)]

mod common;

use common::{build, configurations, soups};
use hug::{Hit, Isa, Ray, Scene, View, force_isa};
use hug_kit::random::Random;
use hug_kit::{Bounds, Mesh};

/// 48 kB, and 8 for the thread itself; for many rays 256 kB.
const STACK: usize = 56 << 10;

/// As many as go together.
const RAYS: usize = 64;

fn bits(hit: &Hit) -> &[u32; 10] {
    bytemuck::cast_ref(hit)
}

/// Where rays may come from.
fn eye(mesh: &Mesh, bounds: &Bounds, random: &mut Random) -> [f64; 3] {
    let middle = bounds.at([0.5; 3]);
    let size = bounds.diagonal();
    let away = |distance: f64, random: &mut Random| {
        let way = match random.below(3) {
            // Along an axis, so that faces are seen from the side.
            0 => {
                let mut way = [0.0; 3];
                way[random.below(3)] = if random.chance(0.5) { 1.0 } else { -1.0 };
                way
            }
            _ => random.direction(),
        };
        [0, 1, 2].map(|k| middle[k] + way[k] * distance * size)
    };
    match random.below(6) {
        0 => away(0.6, random),
        1 => away(3.0, random),
        2 => away(20.0, random),
        3 => away(1e5, random),
        4 => bounds.at([(); 3].map(|()| random.unit())),
        _ => mesh.vertices[random.below(mesh.vertices.len())].map(f64::from),
    }
}

/// Rays from one point to corners, edges and faces, or to anywhere about one of these.
fn packet(mesh: &Mesh, bounds: &Bounds, random: &mut Random) -> Vec<Ray> {
    let eye = eye(mesh, bounds, random).map(|x| x as f32);
    let about = mesh.triangle(random.below(mesh.indices.len()))[0];
    let width = bounds.diagonal() * [0.0, 1e-4, 0.05][random.below(3)];
    let lengths = random.chance(0.3);
    let aim = |random: &mut Random| {
        let corners = mesh.triangle(random.below(mesh.indices.len()));
        match random.below(4) {
            0 => corners[0],
            1 => [0, 1, 2].map(|k| 0.5 * (corners[0][k] + corners[1][k])),
            2 => [0, 1, 2].map(|k| (corners[0][k] + corners[1][k] + corners[2][k]) / 3.0),
            _ => about,
        }
    };
    let ray = |random: &mut Random| -> Ray {
        let aim = if width > 0.0 {
            about.map(|x| x + random.range(-width, width) as f32)
        } else {
            aim(random)
        };
        let way = [0, 1, 2].map(|k| f64::from(aim[k]) - f64::from(eye[k]));
        let longest = way.iter().fold(f64::MIN_POSITIVE, |a, b| a.max(b.abs()));
        let length = if lengths { random.range(0.01, 100.0) } else { 1.0 } / longest;
        Ray::new(eye, way.map(|x| (x * length) as f32))
    };
    (0..RAYS).map(|_| ray(random)).collect()
}

/// Ends rays at what they hit, or just before, and gives them masks and flags.
fn vary(view: &View, rays: &mut [Ray], random: &mut Random) {
    let kind = random.below(8);
    let (flags, start) = (1 + random.below(3) as u32, view.intersect(&rays[0]).t);
    for ray in rays {
        let hit = view.intersect(ray);
        match kind {
            0 if hit.is_hit() => match random.below(4) {
                0 => ray.tmax = hit.t,
                1 => ray.tmax = hit.t.next_down(),
                2 => ray.tmin = hit.t.max(0.0),
                _ => (ray.skip_geom, ray.skip_prim) = (hit.geom, hit.prim),
            },
            1 => ray.flags = random.below(4) as u32,
            2 => ray.mask = if random.chance(0.5) { 0 } else { 1 },
            3 => *ray = ray.with_range(hit.t.abs().min(1e30) * 0.5, hit.t.abs().min(1e30) * 1.5),
            // In these, all are alike but for where they end.
            4 => ray.flags = flags,
            5 if start.is_finite() => ray.tmin = start.max(0.0),
            6 if hit.is_hit() => {
                ray.tmax = [hit.t, hit.t.next_down(), hit.t.next_up()][random.below(3)];
            }
            _ => {}
        }
    }
}

fn check(what: &str, scene: &Scene, rays: &[Ray], wanted: &[Hit]) {
    let mut hits = vec![Hit::miss(7.0); rays.len()];
    for (rays, hits) in rays.chunks(RAYS).zip(hits.chunks_mut(RAYS)) {
        scene.view().intersect_n(rays, hits);
    }
    for (i, (hit, wanted)) in hits.iter().zip(wanted).enumerate() {
        assert_eq!(bits(hit), bits(wanted), "{what}: ray {i}, {:?}", rays[i]);
    }
    let mut together = vec![Hit::miss(7.0); rays.len()];
    scene.view().intersect_n(rays, &mut together);
    assert!(together.iter().zip(wanted).all(|(a, b)| bits(a) == bits(b)), "{what}, in a row");
    // Rays that are much the same are stopped by what has stopped others.
    let mut occluded = vec![false; rays.len()];
    scene.view().occluded_n(rays, &mut occluded);
    for (i, (occluded, wanted)) in occluded.iter().zip(wanted).enumerate() {
        assert_eq!(*occluded, wanted.is_hit(), "{what}: any hit, ray {i}, {:?}", rays[i]);
    }
}

/// The one test that forces instruction sets, which are the whole process's.
#[test]
fn packets_are_single_rays() {
    let sets: Vec<Isa> = Isa::ALL.into_iter().filter(|&i| force_isa(i)).collect();
    for (name, mesh) in soups() {
        let Some(bounds) = mesh.bounds() else { continue };
        for (kind, options) in configurations() {
            let scene = build(&mesh, &options);
            let mut random = Random::stream(0x9ac4e7);
            let mut rays = Vec::new();
            for _ in 0..24 {
                let mut some = packet(&mesh, &bounds, &mut random);
                vary(&scene.view(), &mut some, &mut random);
                rays.append(&mut some);
            }
            assert!(force_isa(Isa::Portable));
            let wanted: Vec<Hit> = rays.iter().map(|r| scene.view().intersect(r)).collect();
            for &set in &sets {
                assert!(force_isa(set), "{set:?}");
                check(&format!("{name} in {kind}, {set:?}"), &scene, &rays, &wanted);
            }
        }
    }
}

/// Rays of one packet that end sooner or later than each other, in the deepest grids.
#[test]
fn rays_of_many_lengths() {
    for (name, mesh) in soups() {
        let Some(bounds) = mesh.bounds() else { continue };
        for (kind, options) in configurations() {
            if !["auto", "r4", "r1 deep"].contains(&kind) {
                continue;
            }
            let scene = build(&mesh, &options);
            let mut random = Random::stream(0x9ac4e9);
            for _ in 0..400 {
                let mut rays = packet(&mesh, &bounds, &mut random);
                for ray in &mut rays {
                    let hit = scene.view().intersect(ray);
                    let t = if hit.is_hit() { hit.t.abs().min(1e30) } else { 2.0 };
                    ray.tmax = t * random.range(0.2, 1.5) as f32;
                }
                let wanted: Vec<Hit> = rays.iter().map(|r| scene.view().intersect(r)).collect();
                check(&format!("{name} in {kind}"), &scene, &rays, &wanted);
            }
        }
    }
}

/// In the stack that the documentation names, and a little for the thread itself.
#[test]
fn little_stack_suffices() {
    for (name, mesh) in soups() {
        let Some(bounds) = mesh.bounds() else { continue };
        for (kind, options) in configurations() {
            let scene = build(&mesh, &options);
            let mut random = Random::stream(0x9ac4ea);
            let rays: Vec<Ray> = (0..8).flat_map(|_| packet(&mesh, &bounds, &mut random)).collect();
            let mut hits = vec![Hit::miss(7.0); rays.len()];
            // Every other one the other way, so that they are no packets.
            let back = |i: usize, ray: &Ray| Ray {
                dir: ray.dir.map(|x| if i.is_multiple_of(2) { x } else { -x }),
                ..*ray
            };
            let many: Vec<Ray> = rays.iter().enumerate().map(|(i, ray)| back(i, ray)).collect();
            let wanted: Vec<Hit> = many.iter().map(|ray| scene.view().intersect(ray)).collect();
            let (mut found, mut occluded) = (hits.clone(), vec![false; many.len()]);
            std::thread::scope(|scope| {
                let spawn = |stack: usize| std::thread::Builder::new().stack_size(stack);
                let few = spawn(STACK).spawn_scoped(scope, || {
                    for (rays, hits) in rays.chunks(RAYS).zip(hits.chunks_mut(RAYS)) {
                        scene.view().intersect_n(rays, hits);
                    }
                });
                few.expect("a thread").join().expect("no panic");
                let all = spawn(STACK + (208 << 10)).spawn_scoped(scope, || {
                    scene.view().intersect_n(&many, &mut found);
                    scene.view().occluded_n(&many, &mut occluded);
                });
                all.expect("a thread").join().expect("no panic");
            });
            assert_eq!(found, wanted, "{name} in {kind}");
        }
    }
}

/// Views of many sizes and places: the same scene, scaled and moved.
#[test]
fn at_any_scale() {
    let (_, mesh) = soups().into_iter().find(|(name, _)| *name == "sphere").expect("a soup");
    for scale in [1e-9, 1e-3, 1.0, 1e3, 1e9] {
        for offset in [0.0, 100.0, -1e5] {
            let mut mesh = mesh.clone();
            for vertex in &mut mesh.vertices {
                *vertex = vertex.map(|x| (x + offset) * scale);
            }
            let bounds = mesh.bounds().expect("it is not empty");
            let scene = build(&mesh, &configurations()[0].1);
            let mut random = Random::stream(0x9ac4e8);
            for _ in 0..32 {
                let rays = packet(&mesh, &bounds, &mut random);
                let wanted: Vec<Hit> = rays.iter().map(|r| scene.view().intersect(r)).collect();
                check(&format!("{scale} ({offset})"), &scene, &rays, &wanted);
            }
        }
    }
}
