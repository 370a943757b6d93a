//! `hug render`.

use crate::args::{Mode, Render};
use crate::input::Input;
use crate::progress;
use hug::{Counters, Hit, Ray, View};
use hug_bench::clock;
use hug_bench::shade::squareness;
use hug_kit::rays;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

/// Rays in one stream.
const CHUNK: usize = 16384;

pub fn run(args: &Render) -> Result<(), String> {
    let input = Input::new(&args.scene, &args.how, args.quiet)?;
    let camera = match &args.camera {
        Some(numbers) => given(numbers)?,
        None => input.camera(args.view.as_deref())?,
    };
    let out = args.out.clone().unwrap_or_else(|| {
        let stem = Path::new(&args.scene).file_stem().unwrap_or_default();
        PathBuf::from(stem).with_extension("png")
    });
    let rays: Vec<Ray> = rays::primary(&camera, args.size).map(bytemuck::cast).collect();
    let view = input.view()?;
    let traced = Traced::new(&view, &rays, args.mode == Mode::Steps, args.quiet);
    let mut pixels = vec![0; rays.len()];
    let grey = greys(args.mode, &rays, &traced);
    for ([x, y], grey) in rays::primary_pixels(args.size).zip(grey) {
        pixels[(y * args.size + x) as usize] = grey;
    }
    write(&out, args.size, &pixels)?;
    let hits = traced.hits.iter().filter(|hit| hit.is_hit()).count();
    println!(
        "{}: {} rays, {:.1} % hit, {:.2} million a second",
        out.display(),
        rays.len(),
        100.0 * hits as f64 / rays.len() as f64,
        1e-6 * rays.len() as f64 / traced.seconds
    );
    Ok(())
}

fn given(numbers: &[f32]) -> Result<hug_kit::View, String> {
    let [ex, ey, ez, ax, ay, az, ux, uy, uz, fov_deg] = *numbers else {
        return Err(format!("--camera: {} numbers, not ten", numbers.len()));
    };
    if !numbers.iter().all(|n| n.is_finite()) {
        return Err("--camera: a number is not finite".to_owned());
    }
    Ok(hug_kit::View { eye: [ex, ey, ez], at: [ax, ay, az], up: [ux, uy, uz], fov_deg })
}

/// What the rays found, in their order.
struct Traced {
    hits: Vec<Hit>,
    /// Of each ray, if they were to be counted.
    steps: Vec<u64>,
    /// CPU time of the streams.
    seconds: f64,
}

impl Traced {
    fn new(view: &View<'_>, rays: &[Ray], count: bool, quiet: bool) -> Self {
        let bar = progress::bar("tracing", rays.len() as u64, quiet);
        let mut hits = vec![Hit::miss(0.0); rays.len()];
        let (mut steps, mut seconds) = (Vec::new(), 0.0);
        for (rays, hits) in rays.chunks(CHUNK).zip(hits.chunks_mut(CHUNK)) {
            seconds += clock::seconds(clock::thread, || view.intersect_n(rays, hits));
            if count {
                steps.extend(rays.iter().map(|ray| steps_of(view, ray)));
            }
            bar.inc(rays.len() as u64);
        }
        bar.finish_and_clear();
        Self { hits, steps, seconds }
    }
}

fn steps_of(view: &View<'_>, ray: &Ray) -> u64 {
    let mut counters = Counters::default();
    view.intersect_counted(ray, &mut counters);
    counters.voxels
}

fn greys(mode: Mode, rays: &[Ray], traced: &Traced) -> Vec<u8> {
    match mode {
        Mode::Shaded => rays.iter().zip(&traced.hits).map(|(ray, hit)| shade(ray, hit)).collect(),
        Mode::Depth => {
            let mut t: Vec<f32> =
                traced.hits.iter().filter(|hit| hit.is_hit()).map(|hit| hit.t).collect();
            t.sort_by(f32::total_cmp);
            // A hundredth of the hits at each end is let go, for one pixel near the eye
            // would leave the rest alike.
            let at = |part: usize| t.get(part * t.len().saturating_sub(1) / 100).copied();
            let (near, far) = (at(1).unwrap_or(0.0), at(99).unwrap_or(1.0));
            let grey = |hit: &Hit| {
                let share = (hit.t - near) / (far - near).max(f32::MIN_POSITIVE);
                if hit.is_hit() { 255 - (share.clamp(0.0, 1.0) * 215.0) as u8 } else { 0 }
            };
            traced.hits.iter().map(grey).collect()
        }
        Mode::Steps => {
            let mut sorted = traced.steps.clone();
            sorted.sort_unstable();
            let most = sorted.get(sorted.len() * 199 / 200).copied().unwrap_or(1).max(1);
            traced.steps.iter().map(|&steps| (255 * steps.min(most) / most) as u8).collect()
        }
    }
}

/// A lamp at the eye.
fn shade(ray: &Ray, hit: &Hit) -> u8 {
    if !hit.is_hit() {
        return 30;
    }
    (60.0 + 190.0 * squareness(ray, hit)) as u8
}

fn write(path: &Path, size: u32, pixels: &[u8]) -> Result<(), String> {
    let failed = |what: &dyn std::fmt::Display| format!("{}: {what}", path.display());
    let file = File::create(path).map_err(|error| failed(&error))?;
    let mut encoder = png::Encoder::new(BufWriter::new(file), size, size);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(|error| failed(&error))?;
    writer.write_image_data(pixels).map_err(|error| failed(&error))?;
    writer.finish().map_err(|error| failed(&error))
}
