//! The three ways triangles lie in space, at any count: on a surface, everywhere, in clumps.

use crate::Mesh;
use crate::random::Random;

/// The side of the square or cube that all three fill.
const SIDE: f64 = 100.0;

/// Streams of the kit's seed that no other generator uses.
const UNIFORM_STREAM: u64 = 11;
const CLUSTERED_STREAM: u64 = 12;

/// Rolling hills: about `n` triangles of a height field, neighbours sharing vertices.
pub fn surface(n: usize) -> Mesh {
    let cells = (libm::round(libm::sqrt(n as f64 / 2.0)) as usize).max(1);
    let step = SIDE / cells as f64;
    let waves = |a: f64| libm::sin(a * 0.11) * 4.0 + libm::sin(a * 0.47) + libm::sin(a * 2.3) * 0.2;
    let profile: Vec<f64> = (0..=cells).map(|i| waves(i as f64 * step)).collect();
    let cross: Vec<f64> = (0..=cells).map(|i| waves(i as f64 * step * 1.3 + 1.0)).collect();
    let mut mesh = Mesh::default();
    mesh.vertices.reserve((cells + 1) * (cells + 1));
    mesh.indices.reserve(2 * cells * cells);
    for (j, across) in cross.iter().enumerate() {
        for (i, along) in profile.iter().enumerate() {
            let height = along + across + 0.1 * along * across;
            let point = [i as f64 * step, height, j as f64 * step];
            mesh.vertices.push(point.map(|c| c as f32));
        }
    }
    for j in 0..cells {
        for i in 0..cells {
            let a = (j * (cells + 1) + i) as u32;
            let (b, c) = (a + 1, a + 1 + cells as u32);
            mesh.indices.push([a, c, b]);
            mesh.indices.push([b, c, c + 1]);
        }
    }
    mesh
}

/// `n` triangles, uniform in a cube; as long as a voxel of a grid with one voxel a triangle.
pub fn uniform(n: usize) -> Mesh {
    let mut random = Random::stream(UNIFORM_STREAM);
    let size = SIDE / libm::cbrt(n as f64);
    let mut mesh = with_room(n);
    for _ in 0..n {
        let centre = [random.unit(), random.unit(), random.unit()].map(|c| c * SIDE);
        mesh.push(small_triangle(&mut random, centre, size));
    }
    mesh
}

/// `n` triangles in clumps inside clumps: most of the cube is empty, sizes span three decades.
pub fn clustered(n: usize) -> Mesh {
    let mut random = Random::stream(CLUSTERED_STREAM);
    let mut mesh = with_room(n);
    let clumps = (libm::cbrt(n as f64) as usize).max(1);
    while mesh.indices.len() < n {
        let centre = [random.unit(), random.unit(), random.unit()].map(|c| c * SIDE);
        let radius = SIDE * 0.1 * libm::pow(10.0, -2.0 * random.unit());
        let members = (2 * n).div_ceil(clumps);
        let count = (1 + random.below(members)).min(n - mesh.indices.len());
        let size = radius / libm::cbrt(count as f64);
        for _ in 0..count {
            let away = random.direction();
            let distance = radius * random.unit();
            let point = [0, 1, 2].map(|k| centre[k] + away[k] * distance);
            mesh.push(small_triangle(&mut random, point, size));
        }
    }
    mesh
}

fn with_room(n: usize) -> Mesh {
    Mesh { vertices: Vec::with_capacity(3 * n), indices: Vec::with_capacity(n) }
}

fn small_triangle(random: &mut Random, centre: [f64; 3], size: f64) -> [[f32; 3]; 3] {
    [(); 3].map(|()| centre.map(|c| (c + random.range(-0.5, 0.5) * size) as f32))
}
