//! A closed surface to shoot at from within.

use crate::Mesh;
use core::f64::consts::{PI, TAU};

/// A mesh without boundary: every edge belongs to exactly two triangles.
#[derive(Clone, Debug)]
pub struct ClosedMesh {
    pub mesh: Mesh,
    /// Each edge once, as two vertices in rising order.
    pub edges: Vec<[u32; 2]>,
    /// A point inside, from which the whole surface is visible.
    pub centre: [f32; 3],
}

/// A sphere about `centre` of radius about `scale` with bumps, star-shaped about its centre:
/// `rings` (at least 2) bands from pole to pole, twice as many segments (triangles:
/// 4 rings (rings - 1)). The poles are vertices of high degree.
pub fn bumpy_sphere(rings: u32, scale: f64, centre: [f64; 3]) -> ClosedMesh {
    let segments = 2 * rings;
    let point = |ring: u32, segment: u32| {
        let theta = PI * f64::from(ring) / f64::from(rings);
        let phi = TAU * f64::from(segment) / f64::from(segments);
        let (sin, cos) = match ring {
            0 => (0.0, 1.0),
            r if r == rings => (0.0, -1.0),
            _ => (libm::sin(theta), libm::cos(theta)),
        };
        let bump = sin * sin * (libm::sin(5.0 * phi) + libm::sin(7.0 * theta));
        let radius = scale * (1.0 + 0.1 * bump);
        let unit = [sin * libm::cos(phi), cos, sin * libm::sin(phi)];
        [0, 1, 2].map(|k| (centre[k] + radius * unit[k]) as f32)
    };
    let name = |ring: u32, segment: u32| match ring {
        0 => 0,
        r if r == rings => 1 + (rings - 1) * segments,
        r => 1 + (r - 1) * segments + segment % segments,
    };

    let mut mesh = Mesh::default();
    mesh.vertices.push(point(0, 0));
    for ring in 1..rings {
        mesh.vertices.extend((0..segments).map(|s| point(ring, s)));
    }
    mesh.vertices.push(point(rings, 0));
    for ring in 0..rings {
        for s in 0..segments {
            let (a, b) = (name(ring, s), name(ring, s + 1));
            let (c, d) = (name(ring + 1, s), name(ring + 1, s + 1));
            if a != b {
                mesh.indices.push([a, b, c]);
            }
            if c != d {
                mesh.indices.push([b, d, c]);
            }
        }
    }
    let mut edges: Vec<[u32; 2]> = mesh
        .indices
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    edges.sort_unstable();
    edges.dedup();
    ClosedMesh { mesh, edges, centre: centre.map(|c| c as f32) }
}
