//! How many steps a ray can take at most, from the arena alone.
//!
//! A walk of a grid of n_x, n_y, n_z voxels strictly advances in integer coordinates, so
//! it visits at most P = n_x + n_y + n_z - 2 of them. A voxel costs a step, one for each
//! triangle in its list, and what walking each grid in it costs, which are of lower
//! levels. So what a grid costs is at most one more than its P dearest voxels do. Levels
//! are taken from the lowest up, each grid for the dearest of its level: no memory is
//! needed, and time linear in the arena.
//!
//! Nothing here depends on how the arena came to be: it holds for every one that opens.

use crate::arena::layout::{GRID, GRID_BIT, Grid, LIST, PAYLOAD, TAG_SHIFT};
use crate::arena::{Sections, View};
use crate::options::MAX_LEVELS;

/// What voxels cost, by the number of bits of it.
struct Costs {
    count: [u64; BITS],
    sum: [u64; BITS],
}

const BITS: usize = u64::BITS as usize;

impl Costs {
    fn add(&mut self, cost: u64) {
        let class = cost.max(1).ilog2() as usize;
        self.count[class] += 1;
        self.sum[class] = self.sum[class].saturating_add(cost);
    }

    /// An upper bound on the sum of the `most` largest.
    fn largest(&self, most: u64) -> u64 {
        let (mut left, mut sum) = (most, 0u64);
        for class in (0..BITS).rev() {
            let taken = left.min(self.count[class]);
            // The largest of the class, or all of it.
            let top = (u64::MAX >> (BITS - 1 - class)).saturating_mul(taken);
            sum = sum.saturating_add(top.min(self.sum[class]));
            left -= taken;
        }
        sum
    }
}

/// What a voxel costs, where grids of level i cost `level[i]`.
fn cost(sections: &Sections<'_>, voxel: u32, level: &[u64; MAX_LEVELS]) -> u64 {
    let below = |number: u32| level[usize::from(sections.grid(number).level) % MAX_LEVELS];
    let payload = voxel & PAYLOAD;
    match voxel >> TAG_SHIFT {
        LIST => {
            let (_, refs) = sections.list(payload);
            refs.iter().fold(1u64, |sum, r| {
                let of_ref = if r & GRID_BIT == 0 { 1 } else { below(r & !GRID_BIT) };
                sum.saturating_add(of_ref)
            })
        }
        GRID => below(payload).saturating_add(1),
        _ => 1,
    }
}

fn grid_cost(sections: &Sections<'_>, grid: &Grid, level: &[u64; MAX_LEVELS]) -> u64 {
    let mut costs = Costs { count: [0; BITS], sum: [0; BITS] };
    let first = grid.first as usize;
    for number in first..first + grid.voxels() as usize {
        costs.add(cost(sections, sections.voxel(number), level));
    }
    let path = grid.n.iter().map(|&n| u64::from(n)).sum::<u64>().saturating_sub(2);
    costs.largest(path).saturating_add(1)
}

impl View<'_> {
    /// Steps that suffice for any ray: an upper bound on the sum of what
    /// [`crate::Counters`] counts of grids, voxels and tests for one. 0 for an empty
    /// scene. A ray that takes the tree of boxes, as those that are counted do not, looks at
    /// each of its nodes and triangles once at most. Cost: linear in the arena, with no allocation.
    #[must_use]
    pub fn most_steps(&self) -> u64 {
        let (grids, sections) = (self.grids(), self.sections());
        let mut level = [0; MAX_LEVELS];
        for this in 0..MAX_LEVELS {
            let of_level = grids.iter().filter(|grid| usize::from(grid.level) == this);
            level[this] = of_level.map(|g| grid_cost(&sections, g, &level)).max().unwrap_or(0);
        }
        grids.first().map_or(0, |outermost| level[usize::from(outermost.level) % MAX_LEVELS])
    }
}
