//! The tables of figures 12, 14 and 17, in one reading for the paper's and ours.
//!
//! The paper's tables do not always follow its section 3. To be comparable, all of them are read
//! as figures 14 and 17 print theirs:
//! - %obj is the share among the objects of all levels, which sums to 100. (By section 3, of the
//!   scene's: more than 100 in sum where levels share objects.)
//! - mu_og is %obj / %grids. (By section 3, objects a grid.)
//! - mu_ov and its like count references. (Figure 12 prints objects.)
//!
//! [`Other`] has the readings in brackets.

use hug::{Level, Moments, Stats};

/// A table, deepest level first.
#[derive(Clone, Debug)]
pub struct Table {
    pub rows: Vec<Row>,
    pub sums: Sums,
}

/// One level. What sums to 100 over the levels, and %vol, is in percent.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// %obj.
    pub objects: f64,
    /// %grids.
    pub grids: f64,
    /// %voxels.
    pub voxels: f64,
    /// %ptrs, to objects and grids.
    pub pointers: f64,
    /// %vol.
    pub volume: f64,
    /// mu_og.
    pub per_grid: f64,
    /// %o: voxels with references to objects.
    pub filled: f64,
    /// mu_ov, sigma_ov.
    pub per_voxel: [f64; 2],
    /// mu'_ov, sigma'_ov: of the voxels that %o counts.
    pub per_filled: [f64; 2],
    /// %g, mu_gv, sigma_gv, mu'_gv, sigma'_gv: the same of references to grids.
    pub grid_pointers: [f64; 5],
}

/// The line under a table. Paper: of the whole process; ours: the arena without its triangles.
#[derive(Clone, Copy, Debug)]
pub struct Sums {
    pub objects: u64,
    pub grids: u64,
    pub voxels: u64,
    pub pointers: u64,
    pub megabytes: f64,
}

/// A level in the readings that [`Row`] does not take.
#[derive(Clone, Copy, Debug)]
pub struct Other {
    /// Percentage of the scene's objects that the level refers to.
    pub objects: f64,
    /// Objects a grid.
    pub per_grid: f64,
    /// Objects a voxel, and a voxel that refers to any.
    pub per_voxel: [f64; 2],
}

fn pair(moments: Moments) -> [f64; 2] {
    [moments.mean, moments.deviation]
}

impl Row {
    pub fn new(stats: &Stats, level: &Level) -> Self {
        let shares = stats.shares(level);
        let [mean, sigma] = pair(level.grids_per_voxel());
        let [mean_filled, sigma_filled] = pair(level.grids_per_filled_voxel());
        Self {
            objects: shares.objects_of_levels,
            grids: shares.grids,
            voxels: shares.voxels,
            pointers: shares.pointers,
            volume: shares.volume,
            per_grid: shares.objects_per_grid_printed(),
            filled: shares.object_voxels,
            per_voxel: pair(level.objects_per_voxel()),
            per_filled: pair(level.objects_per_filled_voxel()),
            grid_pointers: [shares.grid_voxels, mean, sigma, mean_filled, sigma_filled],
        }
    }
}

impl Table {
    pub fn of(stats: &Stats) -> Self {
        let total = &stats.total;
        Self {
            rows: stats.levels().iter().map(|level| Row::new(stats, level)).collect(),
            sums: Sums {
                objects: stats.triangles,
                grids: total.grids,
                voxels: total.voxels,
                pointers: total.pointers(),
                megabytes: (stats.bytes - stats.triangle_bytes) as f64 / f64::from(1 << 20),
            },
        }
    }

    /// The level that is `up` levels below the outermost grid.
    pub fn below_top(&self, up: usize) -> Option<&Row> {
        self.rows.iter().rev().nth(up)
    }
}

impl Other {
    pub fn levels(stats: &Stats) -> Vec<Self> {
        stats.levels().iter().map(|level| Self::new(stats, level)).collect()
    }

    pub fn new(stats: &Stats, level: &Level) -> Self {
        Self {
            objects: stats.shares(level).objects,
            per_grid: level.objects_per_grid(),
            per_voxel: [level.distinct_per_voxel(), level.distinct_per_filled_voxel()],
        }
    }
}
