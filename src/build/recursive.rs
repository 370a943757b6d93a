//! The recursive grid (section 1.3): a voxel of more than MAXP references
//! becomes a grid of about as many voxels over its own box.
//!
//! Breadth first, so that the capacity, if it runs out, is spent on the upper
//! levels, and so that parents come before children in the arena.

use super::draft::{Draft, Span};
use super::frame::Rule;
use super::uniform::uniform;
use crate::Error;
use crate::arena::layout::GRID_BIT;
use crate::options::Options;

/// Builds a uniform grid and splits its crowded voxels, and theirs.
pub fn recursive(
    draft: &mut Draft<'_>,
    options: &Options,
    objects: &mut [u32],
) -> Result<(), Error> {
    uniform(draft, options, objects)?;
    let rule = Rule {
        gridding: options.gridding,
        alpha: options.alpha,
        counts: [0; 3],
    };
    let mut number = 0;
    let mut deepest = 0;
    while number < draft.grids().len() {
        // Depth for now; levels count from the deepest and are set below.
        let depth = draft.grids()[number].level;
        deepest = deepest.max(depth);
        if depth + 1 < options.max_depth {
            split(draft, number, options.maxp, &rule);
        }
        number += 1;
    }
    for grid in draft.grids_mut() {
        grid.level = deepest - grid.level;
    }
    Ok(())
}

/// Splits the crowded voxels of one grid.
fn split(draft: &mut Draft<'_>, number: usize, maxp: u32, rule: &Rule) {
    let grid = draft.grids()[number];
    let mut voxel = grid.first as usize;
    for z in 0..grid.n[2] {
        for y in 0..grid.n[1] {
            for x in 0..grid.n[0] {
                let span = draft.spans(&grid)[voxel - grid.first as usize];
                if span.count > maxp {
                    let mark = draft.mark();
                    let child = grid.inside([x, y, z], grid.level + 1);
                    let child = child.divided(rule, span.count as usize);
                    if !try_split(draft, child, voxel, span) {
                        draft.back_to(mark);
                    }
                }
                voxel += 1;
            }
        }
    }
}

/// Fills `child` with the voxel's objects. `false` if there is no room or if
/// that separates nothing: some voxel would still hold all of them.
fn try_split(
    draft: &mut Draft<'_>,
    child: crate::arena::layout::Grid,
    voxel: usize,
    span: Span,
) -> bool {
    let Ok(number) = draft.push(child) else {
        return false;
    };
    if draft.fill_from(number, voxel).is_err() {
        return false;
    }
    let grid = draft.grids()[number];
    if draft.spans(&grid).iter().any(|s| s.count >= span.count) {
        return false;
    }
    debug_assert!(draft.list(span).iter().all(|r| r & GRID_BIT == 0));
    draft.replace(voxel, number);
    true
}
