//! Uniform and recursive grids as lists of references, with no thought of speed.

use crate::overlap::{Cell, bounds_of, overlaps};
use hug_kit::Mesh;

pub struct Grid {
    pub voxels: Vec<Vec<u32>>,
    cells: Vec<Cell>,
}

impl Grid {
    pub fn new(mesh: &Mesh, members: &[u32], bounds: &Cell, counts: [usize; 3]) -> Self {
        let edge = |k: usize, i: usize| {
            let share = i as f64 / counts[k] as f64;
            bounds.lo[k] + (bounds.hi[k] - bounds.lo[k]) * share
        };
        let mut cells = Vec::new();
        for z in 0..counts[2] {
            for y in 0..counts[1] {
                for x in 0..counts[0] {
                    let i = [x, y, z];
                    cells.push(Cell {
                        lo: [0, 1, 2].map(|k| edge(k, i[k])),
                        hi: [0, 1, 2].map(|k| edge(k, i[k] + 1)),
                    });
                }
            }
        }
        let mut voxels = vec![Vec::new(); cells.len()];
        for &prim in members {
            let own = bounds_of(mesh, &[prim]);
            let index = |k: usize, c: f64| {
                let size = bounds.hi[k] - bounds.lo[k];
                let share = if size > 0.0 { (c - bounds.lo[k]) / size } else { 0.0 };
                ((share * counts[k] as f64).max(0.0) as usize).min(counts[k] - 1)
            };
            let range = |k: usize| index(k, own.lo[k])..=index(k, own.hi[k]);
            for z in range(2) {
                for y in range(1) {
                    for x in range(0) {
                        let voxel = (z * counts[1] + y) * counts[0] + x;
                        if overlaps(mesh, prim as usize, &cells[voxel]) {
                            voxels[voxel].push(prim);
                        }
                    }
                }
            }
        }
        Self { voxels, cells }
    }

    pub fn references(&self) -> usize {
        self.voxels.iter().map(Vec::len).sum()
    }

    pub fn occupied(&self) -> usize {
        self.voxels.iter().filter(|v| !v.is_empty()).count()
    }

    /// Mean and standard deviation of the references a voxel, of all or of the non-empty ones.
    pub fn spread(&self, only_occupied: bool) -> (f64, f64) {
        let chosen = self.voxels.iter().filter(|v| !(only_occupied && v.is_empty()));
        let sizes: Vec<f64> = chosen.map(|v| v.len() as f64).collect();
        let mean = sizes.iter().sum::<f64>() / sizes.len() as f64;
        let variance = sizes.iter().map(|s| (s - mean).powi(2)).sum::<f64>() / sizes.len() as f64;
        (mean, variance.sqrt())
    }
}

/// What the grids of one depth hold.
#[derive(Clone, Default)]
pub struct Depth {
    pub grids: usize,
    pub voxels: usize,
    pub references: usize,
    pub occupied: usize,
}

/// The recursive grid: a voxel with more than `maxp` references becomes a grid of as many voxels.
pub fn recursive(mesh: &Mesh, members: &[u32], bounds: &Cell, maxp: usize) -> Vec<Depth> {
    let mut depths: Vec<Depth> = Vec::new();
    let mut open = vec![(members.to_vec(), *bounds, 0)];
    while let Some((members, cell, depth)) = open.pop() {
        let count = (members.len() as f64).cbrt().ceil() as usize;
        let grid = Grid::new(mesh, &members, &cell, [count; 3]);
        if depths.len() <= depth {
            depths.resize(depth + 1, Depth::default());
        }
        let total = &mut depths[depth];
        total.grids += 1;
        total.voxels += grid.voxels.len();
        for (voxel, cell) in grid.voxels.into_iter().zip(grid.cells) {
            total.occupied += usize::from(!voxel.is_empty());
            if voxel.len() > maxp && depth < 5 {
                open.push((voxel, cell, depth + 1));
            } else {
                total.references += voxel.len();
            }
        }
    }
    depths
}
