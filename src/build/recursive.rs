//! The recursive grid (section 1.3): a voxel of more than MAXP references
//! becomes a grid of about as many voxels over its own box.
//!
//! Breadth first, so that the capacity, if it runs out, is spent on the upper
//! levels, and so that parents come before children in the arena. Splits that
//! separate nothing are undone and counted: when they have cost as much as the
//! capacity, the rest stays as it is. So time, like memory, is linear in the
//! references allowed.

use super::control::Control;
use super::draft::{Draft, Span};
use super::frame::{Grid, Rule};
use super::uniform::{inner_rule, uniform};
use crate::Error;
use crate::options::Options;

/// Builds a uniform grid and splits its crowded voxels, and theirs.
pub fn recursive(
    draft: &mut Draft<'_>,
    options: &Options,
    objects: &mut [u32],
    control: &mut Control<'_>,
) -> Result<(), Error> {
    control.pass(0.3)?;
    uniform(draft, options, objects, control)?;
    control.pass(0.45)?;
    let mut splitter = Splitter { rule: inner_rule(options), maxp: options.maxp, wasted: 0 };
    let mut number = 0;
    while number < draft.grids().len() {
        // Depth for now; levels count from the deepest and are set below.
        if draft.grids()[number].level + 1 < options.max_depth
            && !control.within(|control| splitter.split_all(draft, number, control))?
        {
            break;
        }
        control.tick(draft.grids()[number].voxels() as usize, number, draft.grids().len())?;
        number += 1;
    }
    let deepest = draft.grids().iter().map(|g| g.level).max().unwrap_or(0);
    for grid in draft.grids_mut() {
        grid.level = deepest - grid.level;
    }
    Ok(())
}

struct Splitter {
    rule: Rule,
    maxp: u32,
    /// References of splits that were undone.
    wasted: usize,
}

impl Splitter {
    /// Splits the crowded voxels of one grid; false when it is time to stop.
    fn split_all(
        &mut self,
        draft: &mut Draft<'_>,
        number: usize,
        control: &mut Control<'_>,
    ) -> Result<bool, Error> {
        let grid = draft.grids()[number];
        let [nx, ny, nz] = grid.n;
        let cells =
            (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])));
        for (voxel, at) in cells.enumerate() {
            let span = draft.spans(&grid)[voxel];
            if span.count > self.maxp {
                let child = grid.inside(at, grid.level + 1);
                let rule = draft.weighed_from(&self.rule, &child, span);
                let child = child.divided(&rule, span.count as usize);
                if !self.split(draft, child, (grid.first as usize + voxel, span), control)? {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// Makes `child` of a voxel, unless that separates nothing. False if there is no
    /// room, or no patience.
    fn split(
        &mut self,
        draft: &mut Draft<'_>,
        child: Grid,
        (voxel, span): (usize, Span),
        control: &mut Control<'_>,
    ) -> Result<bool, Error> {
        let before = draft.mark();
        let filled = draft.push(child).and_then(|n| draft.fill_from(n, voxel, control).map(|()| n));
        let number = match filled {
            Ok(number) => number,
            Err(Error::Limit) => {
                draft.back_to(before);
                return Ok(false);
            }
            Err(other) => return Err(other),
        };
        let child = draft.grids()[number];
        // A voxel that still holds all objects is no loss where hardly any other
        // holds some: a dense clump in a corner is reached a split or two later.
        let used = draft.refs_since(before);
        let together = draft.spans(&child).iter().any(|s| s.count >= span.count);
        if together && used >= 2 * span.count as usize {
            self.wasted += used;
            draft.back_to(before);
            return Ok(self.wasted <= draft.capacity());
        }
        draft.replace(voxel, number);
        Ok(true)
    }
}
