//! The shapes scenes are made of, and where they stand.

use crate::Mesh;
use glam::{DAffine3, DMat3, DVec3};

/// A point or vector; y is up.
pub fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// Standing at `origin`, turned about the vertical axis: `turn` is a share of a full circle, by
/// which x goes towards -z.
pub fn stand(origin: DVec3, turn: f64) -> DAffine3 {
    let (sin, cos) = sin_cos(turn);
    let turned = DMat3::from_cols(at(cos, 0.0, -sin), DVec3::Y, at(sin, 0.0, cos));
    DAffine3::from_mat3_translation(turned, origin)
}

/// At `origin` with the shape's y axis along `axis`.
pub fn point_along(origin: DVec3, axis: DVec3) -> DAffine3 {
    let y = axis.normalize();
    let side = if y.x.abs() < 0.6 { DVec3::X } else { DVec3::Z };
    let z = side.cross(y).normalize();
    DAffine3::from_mat3_translation(DMat3::from_cols(y.cross(z), y, z), origin)
}

/// Sine and cosine of a share of a full circle.
pub fn sin_cos(turn: f64) -> (f64, f64) {
    libm::sincos(turn * core::f64::consts::TAU)
}

/// A mesh under construction: shapes are given in the coordinates of the current place.
#[derive(Default)]
pub struct Model {
    mesh: Mesh,
    place: DAffine3,
}

impl Model {
    /// The finished mesh.
    pub fn finish(self) -> Mesh {
        self.mesh
    }

    /// Builds something whose coordinates are relative to `place`.
    pub fn within(&mut self, place: DAffine3, build: impl FnOnce(&mut Self)) {
        let outer = self.place;
        self.place = outer * place;
        build(self);
        self.place = outer;
    }

    fn vertex(&mut self, point: DVec3) -> u32 {
        let p = self.place.transform_point3(point);
        self.mesh.vertices.push(p.to_array().map(|c| c as f32));
        (self.mesh.vertices.len() - 1) as u32
    }

    /// Triangles whose corners coincide are left out, so that poles and tips close.
    fn face(&mut self, names: [u32; 3]) {
        let [a, b, c] = names.map(|v| self.mesh.vertices[v as usize]);
        if a != b && b != c && c != a {
            self.mesh.indices.push(names);
        }
    }

    /// One triangle.
    pub fn triangle(&mut self, corners: [DVec3; 3]) {
        let names = corners.map(|c| self.vertex(c));
        self.face(names);
    }

    /// A patch of n x m quadrilaterals through the points `point(i, j)`.
    pub fn patch(&mut self, n: usize, m: usize, point: impl Fn(usize, usize) -> DVec3) {
        let mut names = Vec::with_capacity((n + 1) * (m + 1));
        for j in 0..=m {
            for i in 0..=n {
                names.push(self.vertex(point(i, j)));
            }
        }
        for j in 0..m {
            for i in 0..n {
                let a = j * (n + 1) + i;
                let [a, b, c, d] = [a, a + 1, a + n + 1, a + n + 2].map(|k| names[k]);
                self.face([a, c, b]);
                self.face([b, c, d]);
            }
        }
    }

    /// A parallelogram cut into n x m.
    pub fn panel(&mut self, corner: DVec3, u: DVec3, v: DVec3, n: usize, m: usize) {
        self.patch(n, m, |i, j| corner + u * (i as f64 / n as f64) + v * (j as f64 / m as f64));
    }

    /// A box.
    pub fn block(&mut self, lo: DVec3, hi: DVec3) {
        self.blocks(lo, hi, [1, 1, 1]);
    }

    /// A box with its sides cut into as many pieces along x, y and z.
    pub fn blocks(&mut self, lo: DVec3, hi: DVec3, cuts: [usize; 3]) {
        let size = hi - lo;
        let (x, y, z) = (at(size.x, 0.0, 0.0), at(0.0, size.y, 0.0), at(0.0, 0.0, size.z));
        let [nx, ny, nz] = cuts;
        for (corner, u, v, n, m) in [
            (lo, x, y, nx, ny),
            (lo + z, y, x, ny, nx),
            (lo, y, z, ny, nz),
            (lo + x, z, y, nz, ny),
            (lo, z, x, nz, nx),
            (lo + y, x, z, nx, nz),
        ] {
            self.panel(corner, u, v, n, m);
        }
    }

    /// A box standing on the middle of its bottom.
    pub fn slab(&mut self, foot: DVec3, width: f64, height: f64, depth: f64) {
        let half = at(width / 2.0, 0.0, depth / 2.0);
        self.block(foot - half, foot + half + at(0.0, height, 0.0));
    }

    /// A surface of revolution about the y axis through points (radius, height).
    pub fn revolve(&mut self, profile: &[[f64; 2]], segments: usize) {
        self.patch(segments, profile.len() - 1, |i, j| {
            let [radius, height] = profile[j];
            // The seam's two ends must be the same point.
            let (sin, cos) = sin_cos((i % segments) as f64 / segments as f64);
            at(radius * cos, height, radius * sin)
        });
    }

    /// A pipe along a path, with one radius a point; open at its ends unless their radius is 0.
    pub fn tube(&mut self, path: &[DVec3], radius: impl Fn(usize) -> f64, segments: usize) {
        let frames: Vec<DAffine3> = (0..path.len())
            .map(|j| {
                let (before, after) = (j.saturating_sub(1), (j + 1).min(path.len() - 1));
                point_along(path[j], path[after] - path[before])
            })
            .collect();
        self.patch(segments, path.len() - 1, |i, j| {
            let (sin, cos) = sin_cos((i % segments) as f64 / segments as f64);
            frames[j].transform_point3(at(radius(j) * cos, 0.0, radius(j) * sin))
        });
    }

    /// An ellipsoid, or with `rings` of 2 and few `segments` a faceted stone.
    pub fn ball(&mut self, centre: DVec3, radii: DVec3, rings: usize, segments: usize) {
        self.within(DAffine3::from_translation(centre), |m| {
            m.patch(segments, rings, |i, j| {
                let (sin, cos) = sin_cos((i % segments) as f64 / segments as f64);
                let (mut radius, height) = sin_cos(j as f64 / rings as f64 / 2.0);
                if j == rings {
                    radius = 0.0;
                }
                at(radius * cos, -height, radius * sin) * radii
            });
        });
    }
}

/// Points on an arc: `n + 1` of them, `centre` + cos u + sin v, from turn `start` to `end`.
pub fn arc(centre: DVec3, u: DVec3, v: DVec3, [start, end]: [f64; 2], n: usize) -> Vec<DVec3> {
    (0..=n)
        .map(|i| {
            let (sin, cos) = sin_cos(start + (end - start) * i as f64 / n as f64);
            centre + u * cos + v * sin
        })
        .collect()
}
