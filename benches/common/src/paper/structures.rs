//! Figures 12, 14 and 17: the kitchen in three structures.

use super::table::{Row, Sums, Table};

const fn row(resources: [f64; 5], objects: [f64; 6], grids: [f64; 5]) -> Row {
    let [share, grid_share, voxels, pointers, volume] = resources;
    let [per_grid, filled, mean, sigma, mean_filled, sigma_filled] = objects;
    Row {
        objects: share,
        grids: grid_share,
        voxels,
        pointers,
        volume,
        per_grid,
        filled,
        per_voxel: [mean, sigma],
        per_filled: [mean_filled, sigma_filled],
        grid_pointers: grids,
    }
}

/// Figure 12, but for the means per voxel: it prints objects, 0.952 and, of the voxels that have
/// any, 3.35, beside 58387 pointers. Here the pointers are spread over its voxels, as in figures
/// 14 and 17.
pub fn figure_12() -> Table {
    let (pointers, voxels, filled) = (58387.0, 21952.0, 28.4);
    let means = [pointers / voxels, pointers / voxels / filled * 100.0];
    Table {
        rows: vec![row([100.0; 5], [1.0, filled, means[0], 23.0, means[1], 42.8], [0.0; 5])],
        sums: Sums { objects: 20891, grids: 1, voxels: 21952, pointers: 58387, megabytes: 2.11 },
    }
}

pub fn figure_14() -> Table {
    Table {
        rows: vec![
            row([82.6, 70.0, 65.3, 66.1, 0.152], [1.18, 43.6, 3.32, 6.87, 7.62, 8.7], [0.0; 5]),
            row(
                [5.84, 29.7, 5.22, 10.9, 0.0218],
                [0.197, 81.4, 6.01, 6.1, 7.38, 5.96],
                [84.6, 0.87, 0.403, 1.03, 0.17],
            ),
            row(
                [11.5, 0.286, 29.5, 23.0, 100.0],
                [40.4, 34.2, 2.49, 7.08, 7.28, 10.6],
                [3.37, 0.0669, 0.449, 1.99, 1.48],
            ),
        ],
        sums: Sums { objects: 20891, grids: 350, voxels: 31443, pointers: 103_150, megabytes: 4.0 },
    }
}

pub fn figure_17() -> Table {
    Table {
        rows: vec![
            row([0.11, 0.813, 0.21, 0.713, 3.37], [0.135, 89.1, 10.9, 9.22, 12.3, 8.88], [0.0; 5]),
            row(
                [11.5, 39.0, 13.8, 22.0, 0.00144],
                [0.296, 58.9, 5.15, 6.49, 8.75, 6.33],
                [0.0238, 0.000_238, 0.0154, 1.0, 0.0],
            ),
            row(
                [70.4, 59.8, 50.1, 59.8, 0.67],
                [1.18, 48.4, 3.84, 6.81, 7.93, 7.95],
                [0.314, 0.003_14, 0.056, 1.0, 0.0],
            ),
            row(
                [18.0, 0.407, 36.0, 17.4, 100.0],
                [44.2, 27.7, 1.55, 4.75, 5.59, 7.67],
                [0.67, 0.0067, 0.0816, 1.0, 0.0],
            ),
        ],
        sums: Sums {
            objects: 20891,
            grids: 246,
            voxels: 61030,
            pointers: 196_232,
            megabytes: 7.87,
        },
    }
}
