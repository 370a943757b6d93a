//! Small soups, each of one kind that structures and kernels get wrong.

use crate::Mesh;
use crate::random::Random;

/// One stream of the kit's seed for each kind and seed.
fn random(kind: u64, seed: u64) -> Random {
    Random::stream((kind << 48) ^ seed)
}

fn point(random: &mut Random) -> [f64; 3] {
    [(); 3].map(|()| random.range(-1.0, 1.0))
}

fn offset(a: [f64; 3], b: [f64; 3], scale: f64) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] + b[k] * scale)
}

fn collect(n: usize, mut make: impl FnMut(usize) -> [[f64; 3]; 3]) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..n {
        mesh.push(make(i).map(|v| v.map(|c| c as f32)));
    }
    mesh
}

/// No triangle at all.
pub fn empty() -> Mesh {
    Mesh::default()
}

/// One ordinary triangle.
pub fn single() -> Mesh {
    let mut mesh = Mesh::default();
    mesh.push([[0.0, 0.0, 0.0], [1.0, 0.25, 0.0], [0.25, 1.0, 0.5]]);
    mesh
}

/// `n` overlapping triangles in the cube [-1, 1]^3, long and short; a third of the corners are
/// corners of earlier triangles.
pub fn tangle(seed: u64, n: usize) -> Mesh {
    let mut random = random(1, seed);
    let mut used: Vec<[f64; 3]> = Vec::new();
    collect(n, |_| {
        let centre = point(&mut random);
        let size = libm::pow(10.0, random.range(-2.5, 0.0));
        [(); 3].map(|()| {
            if !used.is_empty() && random.chance(1.0 / 3.0) {
                return used[random.below(used.len())];
            }
            let corner = offset(centre, point(&mut random), size);
            used.push(corner);
            corner
        })
    })
}

/// `n` triangles with heights 1e-2 to 1e-7 of their length: needles, and caps whose third corner
/// lies almost on the opposite edge.
pub fn slivers(seed: u64, n: usize) -> Mesh {
    let mut random = random(2, seed);
    collect(n, |i| {
        let (a, b) = (point(&mut random), point(&mut random));
        let along = match i % 2 {
            0 => random.range(0.0, 1e-3),
            _ => random.unit(),
        };
        let foot = [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * along);
        let height = libm::pow(10.0, random.range(-7.0, -2.0));
        [a, b, offset(foot, point(&mut random), height)]
    })
}

/// `n` triangles in stacks of 16 identical ones, every second copy wound the other way.
pub fn stacked(seed: u64, n: usize) -> Mesh {
    let mut random = random(3, seed);
    let mut current = [[0.0; 3]; 3];
    collect(n, |i| {
        if i % 16 == 0 {
            let centre = point(&mut random);
            current = [(); 3].map(|()| offset(centre, point(&mut random), 0.3));
        }
        let [a, b, c] = current;
        if i % 2 == 0 { [a, b, c] } else { [a, c, b] }
    })
}

/// `n` triangles with integer corners in [0, cells]^3, most of them in planes x, y or z = integer:
/// coplanar with the voxel faces of a grid with `cells` (or a divisor) voxels an axis. The box is
/// exactly the cube, for n of at least 2.
pub fn lattice(seed: u64, n: usize, cells: u32) -> Mesh {
    let mut random = random(4, seed);
    let top = f64::from(cells);
    collect(n, |i| match i {
        0 => [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        1 => [[top; 3], [top - 1.0, top, top], [top, top - 1.0, top]],
        _ => {
            let mut pick = || f64::from(random.below(cells as usize + 1) as u32);
            let mut corners = [(); 3].map(|()| [pick(), pick(), pick()]);
            let plane = pick();
            if i % 8 != 0 {
                for corner in &mut corners {
                    corner[i % 3] = plane;
                }
            }
            corners
        }
    })
}

/// `n` triangles whose lengths run from 1e-6 to 1e3, the small ones in clumps about the origin
/// and about one far corner.
pub fn mixed_scales(seed: u64, n: usize) -> Mesh {
    let mut random = random(5, seed);
    collect(n, |i| {
        let size = libm::pow(10.0, random.range(-6.0, 3.0));
        let home = if i % 2 == 0 { [0.0; 3] } else { [700.0, -300.0, 500.0] };
        let centre = offset(home, point(&mut random), 3.0 * size);
        [(); 3].map(|()| offset(centre, point(&mut random), size))
    })
}

/// A copy with every coordinate multiplied by `factor`, such as 1e-30 or 1e30.
pub fn rescaled(mesh: &Mesh, factor: f32) -> Mesh {
    Mesh {
        vertices: mesh.vertices.iter().map(|v| v.map(|c| c * factor)).collect(),
        indices: mesh.indices.clone(),
    }
}
