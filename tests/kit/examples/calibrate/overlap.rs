//! Boxes, and the exact (in doubles) overlap of a triangle and a box.

use hug_kit::Mesh;

/// A box in doubles.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    pub lo: [f64; 3],
    pub hi: [f64; 3],
}

impl Cell {
    pub fn diagonal(&self) -> f64 {
        (0..3).map(|k| (self.hi[k] - self.lo[k]).powi(2)).sum::<f64>().sqrt()
    }

    fn join(self, other: Self) -> Self {
        Self {
            lo: [0, 1, 2].map(|k| self.lo[k].min(other.lo[k])),
            hi: [0, 1, 2].map(|k| self.hi[k].max(other.hi[k])),
        }
    }
}

fn corners(mesh: &Mesh, prim: usize) -> [[f64; 3]; 3] {
    mesh.triangle(prim).map(|v| v.map(f64::from))
}

fn box_of(mesh: &Mesh, prim: usize) -> Cell {
    let [a, b, c] = corners(mesh, prim).map(|p| Cell { lo: p, hi: p });
    a.join(b).join(c)
}

pub fn boxes(mesh: &Mesh) -> Vec<Cell> {
    (0..mesh.indices.len()).map(|i| box_of(mesh, i)).collect()
}

pub fn bounds_of(mesh: &Mesh, members: &[u32]) -> Cell {
    let boxes = members.iter().map(|&i| box_of(mesh, i as usize));
    boxes.reduce(Cell::join).expect("no empty clusters")
}

pub fn bounds(mesh: &Mesh) -> Cell {
    boxes(mesh).into_iter().reduce(Cell::join).expect("no empty scenes")
}

/// Separating axes: three of the box, one of the triangle, nine of pairs of edges.
pub fn overlaps(mesh: &Mesh, prim: usize, cell: &Cell) -> bool {
    let half = [0, 1, 2].map(|k| (cell.hi[k] - cell.lo[k]) / 2.0);
    let middle = [0, 1, 2].map(|k| (cell.hi[k] + cell.lo[k]) / 2.0);
    let v = corners(mesh, prim).map(|p| [0, 1, 2].map(|k| p[k] - middle[k]));
    let edge = |a: usize, b: usize| [0, 1, 2].map(|k| v[b][k] - v[a][k]);
    let edges = [edge(0, 1), edge(1, 2), edge(2, 0)];
    let separates = |axis: [f64; 3]| {
        let on = v.map(|p| dot(axis, p));
        let reach = dot(axis.map(f64::abs), half);
        on.iter().all(|&d| d > reach) || on.iter().all(|&d| d < -reach)
    };
    let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    !(units.into_iter().any(separates)
        || separates(cross(edges[0], edges[1]))
        || edges.iter().any(|&e| units.iter().any(|&u| separates(cross(e, u)))))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
