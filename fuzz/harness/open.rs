//! Open any bytes, or damaged arenas; what opens answers every query, and ends.

use super::arena::{damage, sample};
use super::block::Block;
use super::input::Input;
use super::soup::probe;
use hug::{Counters, Hit, Isa, Lengths, Occupancy, Probe, Profile, Ray, Stats, View, force_isa};

fn query(view: &View<'_>, input: &mut Input<'_>) {
    let mut rays = vec![
        Ray::new([0.0; 3], [1.0; 3]),
        Ray::new([-9.0, -9.0, -9.0], [1.0, 1.0, 1.0]),
        Ray::new([0.5, 0.25, 9.0], [0.0, -0.0, -1.0]),
        Ray::new([3.1, -3.1, 50.0], [0.0, 1e-3, -1.0]),
        Ray::new([1e20, 1e20, 1e20], [-1.0, -1.0, -1.0]),
    ];
    for _ in 0..input.below(8) {
        rays.push(Ray::new(input.point(), input.point()).with_range(input.float(), input.float()));
    }
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    let mut shadows = vec![false; rays.len()];
    view.intersect_n(&rays, &mut hits);
    view.occluded_n(&rays, &mut shadows);
    let (most, mut profile) = (view.most_steps(), Profile::default());
    for (ray, streamed) in rays.iter().zip(&hits) {
        let hit = view.intersect(ray);
        let inside = ray.tmin <= hit.t && hit.t <= ray.tmax;
        assert!(!hit.is_hit() || inside, "{ray:?} hit {hit:?}");
        // What a forged arena says is hit may depend on the path, not so its triangles.
        let _ = (view.occluded(ray), view.intersect_brute(ray), streamed);
        let mut counters = Counters::default();
        let _ = view.intersect_counted(ray, &mut counters);
        let steps = counters.grids + counters.voxels + counters.tests;
        assert!(steps <= most, "{ray:?}: {steps} steps, {most} should suffice");
        assert!(view.occluded_within(ray, most).is_ok(), "{ray:?}");
        let _ = view.intersect_profiled(ray, &mut profile);
        let mut before = ray.tmin;
        for hit in view.hits(ray) {
            assert!(before <= hit.t && hit.t <= ray.tmax, "{ray:?} hit {hit:?} after {before}");
            before = hit.t;
        }
        let mut few = [Hit::miss(0.0); 3];
        let _ = view.intersect_all(ray, Some(&hit), &mut few);
        assert!(!view.occluded_filtered(ray, |_| false), "{ray:?}");
        let _ = view.closest_point(&Probe::new(ray.org, hit.t));
    }
    view.intersect_n_filtered(&rays, &mut hits, |i, hit| (i + hit.prim as usize).is_multiple_of(2));
    view.intersect_n_counted(&rays, &mut hits, &mut Counters::default());
    view.occluded_n_profiled(&rays, &mut shadows, &mut profile);
    for _ in 0..=input.below(4) {
        let near = probe(input);
        let _ = (view.closest_point(&near), view.closest_point_brute(&near));
    }
    let stats = Stats::of(view);
    let mut counts = [0; 8];
    for level in 0..stats.levels().len() {
        let _ = Occupancy::count(view, Some(level), &mut counts);
    }
    Lengths::of(view).histogram(view, 0.2, &mut counts);
    let _ = (view.bounds(), view.bytes().len());
    // As many from one point as go together.
    let (org, [x, y, z]) = (input.point(), input.point());
    let ray = |i: u32| {
        let [right, up] = [i % 8, i / 8].map(|k| k as f32 * 1e-3);
        Ray::new(org, [x + right, y, z + up])
    };
    let rays: Vec<Ray> = (0..64).map(ray).collect();
    let mut hits = vec![Hit::miss(0.0); rays.len()];
    view.intersect_n(&rays, &mut hits);
}

/// The target.
pub fn open(data: &[u8]) {
    let mut input = Input::new(data);
    force_isa(input.one_of(&Isa::ALL));
    let raw = input.rarely(8);
    let mut block = if raw { Block::copy(input.rest()) } else { sample(&mut input) };
    if !raw {
        for _ in 0..input.below(12) {
            damage(block.bytes_mut(), &mut input);
        }
    }
    if let Ok(view) = View::open(block.bytes()) {
        query(&view, &mut input);
    }
}
