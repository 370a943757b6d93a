//! Build from any soup and options, trace any rays: every form of query says what brute
//! force says, whatever the structure and the instruction set.

use super::block::Block;
use super::input::Input;
use super::soup::{Soup, later, options, probe};
use hug::force_isa;
use hug::{Counters, Error, Hit, Isa, Nearest, Probe, Ray, Scene, Structure, Truncated, View};

const STRUCTURES: [Structure; 4] =
    [Structure::Auto, Structure::Uniform, Structure::Recursive, Structure::Hug];

fn bits(hit: &Hit) -> [u32; 10] {
    // SAFETY: ten fields of four bytes each.
    unsafe { std::mem::transmute(*hit) }
}

fn near(nearest: &Nearest) -> [u32; 10] {
    // SAFETY: as above.
    unsafe { std::mem::transmute(*nearest) }
}

/// All hits, in room for some of them, and the first that a filter accepts.
fn check_all(view: &View<'_>, soup: &Soup, ray: &Ray, room: usize) {
    let expected = soup.all_hits(ray);
    let mut hits = vec![Hit::miss(0.0); room];
    let found = view.intersect_all(ray, None, &mut hits);
    assert_eq!(found.count, room.min(expected.len()), "{ray:?}");
    assert_eq!(found.more, room < expected.len(), "{ray:?}");
    for (hit, other) in hits[..found.count].iter().zip(&expected) {
        assert_eq!(bits(hit), bits(other), "{ray:?}");
    }
    let all: Vec<Hit> = view.hits(ray).collect();
    assert_eq!(all.len(), expected.len(), "{ray:?}");
    for (hit, other) in all.iter().zip(&expected) {
        assert_eq!(bits(hit), bits(other), "{ray:?}");
    }
    let accepts = |hit: &Hit| (hit.prim as usize + room).is_multiple_of(3);
    let first = expected.iter().copied().find(accepts).unwrap_or(Hit::miss(ray.tmax));
    assert_eq!(bits(&view.intersect_filtered(ray, accepts)), bits(&first), "{ray:?}");
    assert_eq!(view.occluded_filtered(ray, accepts), first.is_hit(), "{ray:?}");
}

fn check_near(view: &View<'_>, probe: &Probe) {
    let expected = near(&view.closest_point_brute(probe));
    assert_eq!(near(&view.closest_point(probe)), expected, "{probe:?}");
}

fn check(view: &View<'_>, rays: &[Ray]) {
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    let mut shadows = vec![false; rays.len()];
    view.intersect_n(rays, &mut hits);
    view.occluded_n(rays, &mut shadows);
    let most = view.most_steps();
    for ((ray, hit), shadow) in rays.iter().zip(&hits).zip(&shadows) {
        let expected = bits(&view.intersect_brute(ray));
        let mut counters = Counters::default();
        assert_eq!(bits(&view.intersect(ray)), expected, "{ray:?}");
        assert_eq!(bits(&view.intersect_counted(ray, &mut counters)), expected, "{ray:?}");
        assert_eq!(bits(hit), expected, "{ray:?} in a stream");
        let is_hit = hit.is_hit();
        assert_eq!(view.occluded(ray), is_hit, "{ray:?}");
        assert_eq!(*shadow, is_hit, "{ray:?} in a stream");
        let steps = counters.grids + counters.voxels + counters.tests;
        assert!(steps <= most, "{ray:?}: {steps} steps, {most} should suffice");
        assert_eq!(view.intersect_within(ray, steps).map(|hit| bits(&hit)), Ok(expected));
        assert_eq!(view.occluded_within(ray, most), Ok(is_hit));
        if steps > 0 {
            assert_eq!(view.intersect_within(ray, steps - 1), Err(Truncated), "{ray:?}");
        }
    }
}

/// Rays from one point, about the way of one of them, as many as go together: `spread`
/// apart, and ending at some part of the way to a hit.
fn check_packet(view: &View<'_>, ray: &Ray, spread: f32) {
    let hit = view.intersect_brute(ray);
    let rays: Vec<Ray> = (0..64)
        .map(|i| {
            let [right, up] = [i % 8, i / 8].map(|k| k as f32 * spread);
            let [x, y, z] = ray.dir;
            let dir = [x + right * y, y + up * z, z + right * x];
            let tmax = if hit.is_hit() && i % 3 > 0 { hit.t * (i as f32 / 32.0) } else { ray.tmax };
            Ray { dir, tmin: ray.tmin.max(0.0), tmax, ..*ray }
        })
        .collect();
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    let mut shadows = vec![false; rays.len()];
    view.intersect_n(&rays, &mut hits);
    // More of them than are in flight: the last may be stopped by what has stopped the first.
    view.occluded_n(&rays, &mut shadows);
    for ((ray, hit), shadow) in rays.iter().zip(&hits).zip(&shadows) {
        assert_eq!(bits(hit), bits(&view.intersect_brute(ray)), "{ray:?} in a packet");
        assert_eq!(*shadow, hit.is_hit(), "{ray:?} among many");
    }
}

/// The target.
pub fn trace(data: &[u8]) {
    let mut input = Input::new(data);
    force_isa(input.one_of(&Isa::ALL));
    let soup = Soup::read(&mut input);
    let structure = input.one_of(&STRUCTURES);
    let options = options(&mut input, structure);
    let mut rays: Vec<Ray> = (0..input.below(24)).map(|_| soup.ray(&mut input)).collect();
    let probes: Vec<Probe> = (0..input.below(8)).map(|_| probe(&mut input)).collect();
    let room = input.below(8);
    if input.rarely(3) {
        rays.iter_mut().for_each(|ray| ray.flags = input.below(4) as u32);
    }
    let options = later(&mut input, options);
    let scene = match Scene::build(&soup.geometries(), &options) {
        Ok(scene) => scene,
        // Only explicit counts may ask for more references than max_refs allows.
        Err(Error::Limit) if options.counts != [0; 3] => return,
        Err(error) => panic!("{error}: {options:?}"),
    };
    let copy = Block::copy(scene.view().bytes());
    let view = View::open(copy.bytes()).expect("what was built opens");
    check(&view, &rays);
    rays.iter().for_each(|ray| check_all(&view, &soup, ray, room));
    probes.iter().for_each(|probe| check_near(&view, probe));
    let spread = [1e-4, 1e-3, 1e-2][input.below(3)];
    rays.iter().take(4).for_each(|ray| check_packet(&view, ray, spread));
}
