//! Pictures, as the paper renders its own: primary rays, and shadow rays from what they hit.

use hug::{Hit, Profile, Ray, View};
use hug_bench::clock;
use hug_bench::figures::Spread;
use hug_bench::load::Loaded;
use hug_bench::rounds::{self, Contender};
use hug_bench::shade::squareness;
use hug_kit::rays;
use std::hint::black_box;

/// The rays of a picture.
pub struct Frame {
    pub view: String,
    pub size: u32,
    pub primary: Vec<Ray>,
    pub shadow: Vec<Ray>,
    /// Grey values by row and column, for the picture on the page.
    pub shades: Vec<u8>,
}

impl Frame {
    /// Where the hits are is the same in every structure.
    pub fn new(
        name: String,
        camera: &hug_kit::View,
        size: u32,
        loaded: &Loaded,
        view: &View<'_>,
    ) -> Self {
        let primary: Vec<rays::Ray> = rays::primary(camera, size).collect();
        let hits: Vec<Hit> = primary.iter().map(|&r| view.intersect(&bytemuck::cast(r))).collect();
        let kit: Vec<rays::Hit> = hits.iter().map(|&hit| bytemuck::cast(hit)).collect();
        let shadow = rays::shadow(&loaded.bounds, size, &primary, &kit).map(bytemuck::cast);
        let shadow = shadow.collect();
        let primary: Vec<Ray> = primary.into_iter().map(bytemuck::cast).collect();
        let mut shades = vec![0; (size * size) as usize];
        for ((ray, hit), [x, y]) in primary.iter().zip(&hits).zip(rays::primary_pixels(size)) {
            shades[(y * size + x) as usize] = shade(ray, hit);
        }
        Self { view: name, size, primary, shadow, shades }
    }
}

/// Grey by the angle between ray and surface; white where nothing is hit.
fn shade(ray: &Ray, hit: &Hit) -> u8 {
    if !hit.is_hit() {
        return 255;
    }
    (40.0 + 200.0 * squareness(ray, hit)) as u8
}

/// What a picture cost in one structure.
pub struct Rendered {
    /// Of all its rays, level by level.
    pub profile: Profile,
    /// CPU seconds by the queries that count nothing.
    pub seconds: Spread,
    /// Tests and voxels of each pixel's primary ray, by row and column.
    pub tests: Vec<u64>,
    pub voxels: Vec<u64>,
}

impl Rendered {
    pub fn new(frame: &Frame, view: &View<'_>, seconds: Spread) -> Self {
        let mut profile = Profile::default();
        let pixels = (frame.size * frame.size) as usize;
        let (mut tests, mut voxels) = (vec![0; pixels], vec![0; pixels]);
        for (ray, [x, y]) in frame.primary.iter().zip(rays::primary_pixels(frame.size)) {
            let mut seen = Profile::default();
            view.intersect_profiled(ray, &mut seen);
            profile.add(&seen);
            let pixel = (y * frame.size + x) as usize;
            (tests[pixel], voxels[pixel]) = (seen.total().tests, seen.total().voxels);
        }
        for ray in &frame.shadow {
            view.occluded_profiled(ray, &mut profile);
        }
        Self { profile, seconds, tests, voxels }
    }
}

/// CPU seconds of the picture in each of some scenes, by the queries that count nothing. They
/// take turns, so that a machine that slows down does so for all.
pub fn times(frame: &Frame, views: &[View<'_>], rounds: u32) -> Vec<Spread> {
    let picture = |view| -> Contender<'_> {
        Box::new(move |items| {
            let share = |rays: &[Ray]| rays.len() * items / frame.primary.len().max(1);
            for ray in &frame.primary[..share(&frame.primary)] {
                black_box(View::intersect(view, ray));
            }
            for ray in &frame.shadow[..share(&frame.shadow)] {
                black_box(View::occluded(view, ray));
            }
        })
    };
    let mut all: Vec<Contender<'_>> = views.iter().map(picture).collect();
    let times = rounds::run(&mut all, frame.primary.len(), rounds as usize, clock::thread);
    times.into_iter().map(Spread::of).collect()
}
