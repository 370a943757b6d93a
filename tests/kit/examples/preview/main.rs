//! Renders every view of the named scenes (all without names) to PNG files in a folder:
//! `preview FOLDER [SCENE...]`.

mod tracer;

use hug_kit::rays::{Ray, primary, primary_pixels};
use hug_kit::scenes::{NAMES, generate};
use hug_kit::{Mesh, View};
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use tracer::Tracer;

const SIZE: u32 = 768;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let folder = PathBuf::from(args.next().ok_or("usage: preview FOLDER [SCENE...]")?);
    std::fs::create_dir_all(&folder)?;
    let mut names: Vec<String> = args.collect();
    if names.is_empty() {
        names = NAMES.map(String::from).to_vec();
    }
    for name in names {
        let scene = generate(&name).ok_or_else(|| format!("no scene {name}"))?;
        let tracer = Tracer::new(&scene.mesh);
        for named in &scene.views {
            let file = format!("{}-{}.png", name.replace(':', "-"), named.name);
            let path = folder.join(file);
            save(&path, &render(&scene.mesh, &tracer, &named.view))?;
            println!("{}", path.display());
        }
    }
    Ok(())
}

/// Shades by the angle to the viewer and to a light above, with its shadow.
fn render(mesh: &Mesh, tracer: &Tracer, view: &View) -> Vec<u8> {
    let mut image = vec![0; (SIZE * SIZE * 3) as usize];
    for ([x, y], ray) in primary_pixels(SIZE).zip(primary(view, SIZE)) {
        let colour = shade(mesh, tracer, &ray).map(|c| (255.0 * c.clamp(0.0, 1.0).sqrt()) as u8);
        let at = ((y * SIZE + x) * 3) as usize;
        image[at..at + 3].copy_from_slice(&colour);
    }
    image
}

fn shade(mesh: &Mesh, tracer: &Tracer, ray: &Ray) -> [f64; 3] {
    let Some((t, prim)) = tracer.closest(ray) else {
        return [0.25, 0.4, 0.7];
    };
    let [a, b, c] = mesh.triangle(prim).map(|v| glam::DVec3::from_array(v.map(f64::from)));
    let dir = glam::DVec3::from_array(ray.dir.map(f64::from));
    let mut normal = (b - a).cross(c - a).normalize();
    if normal.dot(dir) > 0.0 {
        normal = -normal;
    }
    let light = glam::DVec3::new(0.4, 0.8, 0.3).normalize();
    let facing = 0.15 + 0.35 * -normal.dot(dir) + 0.5 * normal.dot(light).max(0.0);
    let depth = 1.0 / (1.0 + 0.002 * t);
    // A faint tint by triangle tells neighbours apart.
    let tint = |salt: usize| 0.85 + 0.15 * ((prim / 2 * salt) % 97) as f64 / 97.0;
    [facing * depth * tint(31), facing * depth * tint(57), facing * depth * tint(71)]
}

fn save(path: &Path, image: &[u8]) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), SIZE, SIZE);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(image)?;
    Ok(())
}
