//! The hierarchy of clusters: which grids point to which (section 1.3).
//!
//! The world is grid 0; the others follow, grouped by level, highest first.
//! Candidates come from a uniform grid over the boxes of each level, built with
//! the bucket sort of `draft` in memory that is still free.

use core::ops::Range;

use super::control::Control;
use super::draft::{Crowded, Draft, Mark};
use super::frame::Grid;
use super::overlap;
use super::sort;
use super::uniform::inner_rule;
use crate::Error;
use crate::arena::layout::{GRID_BIT, MAX_WALKS};
use crate::options::{Hierarchy, MAX_LEVELS, Options};

/// No parent yet.
const NONE: u32 = u32::MAX;
/// Candidates for parents that are looked at, for each grid that there is; when they are
/// used up, the world serves. Scenes take a few; only where thousands of clusters of
/// each of several levels crowd together would it be one for each pair.
const LOOKS: usize = 1024;

/// Links every grid but the world to its parents: fills `links` with pairs
/// `[parent, child]` and returns how many, sorted. `objects` and `parent` are
/// free memory for as many numbers as there are grids. Nested, whatever the rule, if a
/// ray could otherwise enter grids more often than an arena may say.
pub fn link(
    draft: &mut Draft<'_>,
    rule: Hierarchy,
    links: &mut [[u32; 2]],
    objects: &mut [u32],
    parent: &mut [u32],
    control: &mut Control<'_>,
) -> Result<usize, Error> {
    let total = draft.grids().len();
    let mut looks = total.saturating_mul(LOOKS);
    let mut above: [Range<usize>; MAX_LEVELS] = core::array::from_fn(|_| 0..0);
    let (mut groups, mut count, mut first) = (0, 0, 1);
    while first < total {
        let level = draft.grids()[first].level;
        let same = draft.grids()[first..].iter().take_while(|g| g.level == level);
        let group = first..first + same.count();
        parent[group.clone()].fill(NONE);
        for upper in above[..groups].iter().rev() {
            let index = Index::new(draft, upper.clone(), objects, control)?;
            for child in group.clone() {
                if looks == 0 {
                    break;
                }
                let before = looks;
                if rule == Hierarchy::Paper {
                    // Where the memory for links runs out, the world serves: one link is
                    // kept back for each grid of this level and of those still to come.
                    let room = links.len().saturating_sub(total - group.start);
                    let cover = &mut parent[child];
                    count = index.under_all(draft, child, (links, count, room), cover, &mut looks);
                } else if parent[child] == NONE {
                    parent[child] = index.smallest_around(draft, child, &mut looks);
                }
                control.tick(1 + before - looks, child, total)?;
            }
            index.drop(draft);
        }
        for child in group.clone() {
            let covered = parent[child] != NONE;
            if rule == Hierarchy::Paper && covered {
                continue;
            }
            let above = if covered { parent[child] } else { 0 };
            *links.get_mut(count).ok_or(Error::Limit)? = [above, child as u32];
            count += 1;
        }
        above[groups] = group.clone();
        groups += 1;
        first = group.end;
    }
    sort::pairs(&mut links[..count]);
    // Nested, it is a tree, with one path to each grid.
    if walks(&links[..count], &mut parent[..total]) > MAX_WALKS * total as u64 {
        return link(draft, Hierarchy::Nested, links, objects, parent, control);
    }
    Ok(count)
}

/// No less than the world's `walks` will be: the paths to all grids, were all in each voxel
/// of those above. `paths` is room for a number of each grid.
fn walks(links: &[[u32; 2]], paths: &mut [u32]) -> u64 {
    paths.fill(1);
    // Children have higher numbers than parents: theirs are known first.
    for &[above, below] in links.iter().rev() {
        paths[above as usize] = paths[above as usize].saturating_add(paths[below as usize]);
    }
    paths.first().copied().unwrap_or(0).into()
}

fn contains(outer: &Grid, inner: &Grid) -> bool {
    (0..3).all(|k| {
        outer.lo[k] <= inner.lo[k] && inner.lo[k] + inner.extent[k] <= outer.lo[k] + outer.extent[k]
    })
}

fn intersects(a: &Grid, b: &Grid) -> bool {
    (0..3).all(|k| a.lo[k] <= b.lo[k] + b.extent[k] && b.lo[k] <= a.lo[k] + a.extent[k])
}

/// The voxels of a grid that another meets; none is turned yet.
fn reach(grid: &Grid, other: &Grid) -> Option<overlap::Range> {
    let hi = core::array::from_fn(|k| other.lo[k] + other.extent[k]);
    overlap::Range::of(grid, other.lo, hi)
}

fn volume(grid: &Grid) -> f64 {
    grid.extent.iter().product()
}

/// Takes `wanted` from what is left, or all of that; returns how much.
fn spend(left: &mut usize, wanted: usize) -> usize {
    let spent = wanted.min(*left);
    *left -= spent;
    spent
}

/// A uniform grid over the grids of one level.
struct Index {
    grid: Grid,
    before: Mark,
}

impl Index {
    fn new(
        draft: &mut Draft<'_>,
        grids: Range<usize>,
        objects: &mut [u32],
        control: &mut Control<'_>,
    ) -> Result<Self, Error> {
        let before = draft.mark();
        let rule = inner_rule(&Options::default());
        let grid =
            Grid::around(&draft.soup.bounds, 0, &draft.soup.bounds).divided(&rule, grids.len());
        let objects = &mut objects[..grids.len()];
        for (number, object) in grids.zip(objects.iter_mut()) {
            *object = GRID_BIT | number as u32;
        }
        let number = draft.push(grid)?;
        control.within(|control| draft.fill(number, objects, Crowded::Coarsen, control))?;
        Ok(Self { grid: draft.grids()[number], before })
    }

    fn drop(self, draft: &mut Draft<'_>) {
        draft.back_to(self.before);
    }

    /// The indexed grid of least volume that contains grid `child`.
    /// Takes from `looks` what it looks at, and ends when there are none left.
    fn smallest_around(&self, draft: &Draft<'_>, child: usize, looks: &mut usize) -> u32 {
        let inner = draft.grids()[child];
        let middle = core::array::from_fn(|k| inner.lo[k] + 0.5 * inner.extent[k]);
        let mut best = NONE;
        let Some(range) = overlap::Range::of(&self.grid, middle, middle) else {
            return best;
        };
        range.each(&self.grid, |voxel| {
            let list = draft.list(draft.spans(&self.grid)[voxel]);
            for &object in &list[..spend(looks, list.len())] {
                let number = object & !GRID_BIT;
                let outer = &draft.grids()[number as usize];
                let smaller = best == NONE
                    || volume(outer)
                        .total_cmp(&volume(&draft.grids()[best as usize]))
                        .then(number.cmp(&best))
                        .is_lt();
                if smaller && contains(outer, &inner) {
                    best = number;
                }
            }
        });
        best
    }

    /// Links `child` to every indexed grid that it intersects, up to `room`
    /// links in all; `cover` becomes one that contains it. `looks` as above, voxels
    /// included.
    fn under_all(
        &self,
        draft: &Draft<'_>,
        child: usize,
        (links, mut count, room): (&mut [[u32; 2]], usize, usize),
        cover: &mut u32,
        looks: &mut usize,
    ) -> usize {
        let inner = draft.grids()[child];
        let Some(range) = reach(&self.grid, &inner) else {
            return count;
        };
        let voxels = range.voxels();
        if spend(looks, voxels) < voxels {
            return count;
        }
        range.each(&self.grid, |voxel| {
            let list = draft.list(draft.spans(&self.grid)[voxel]);
            for &object in &list[..spend(looks, list.len())] {
                let number = object & !GRID_BIT;
                let outer = &draft.grids()[number as usize];
                let Some(other) = reach(&self.grid, outer) else {
                    continue;
                };
                // A pair shares a block of voxels; its lowest one reports it.
                let lowest: [u32; 3] = core::array::from_fn(|k| range.lo[k].max(other.lo[k]));
                let mut owner = false;
                overlap::Range { lo: lowest, hi: lowest, inside: 0 }
                    .each(&self.grid, |v| owner = v == voxel);
                if owner && intersects(outer, &inner) && count < room {
                    links[count] = [number, child as u32];
                    count += 1;
                    if contains(outer, &inner) {
                        *cover = number;
                    }
                }
            }
        });
        count
    }
}
