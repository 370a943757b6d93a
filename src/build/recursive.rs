//! The recursive grid (section 1.3): a voxel of more than MAXP references
//! becomes a grid of about as many voxels over its own box.
//!
//! Breadth first, so that the capacity, if it runs out, is spent on the upper
//! levels, and so that parents come before children in the arena. Splits that
//! separate nothing are undone and counted: when they have cost as much as the
//! capacity, the rest stays as it is. So time, like memory, is linear in the
//! references allowed.

use super::control::Control;
use super::draft::Draft;
use super::frame::Rule;
use super::split::{Batch, Joined};
use super::uniform::{inner_rule, uniform};
use crate::Error;
use crate::math::cbrt;
use crate::options::Options;

/// Builds a uniform grid and splits its crowded voxels, and theirs.
pub fn recursive(
    draft: &mut Draft<'_>,
    options: &Options,
    objects: &mut [u32],
    control: &mut Control<'_>,
) -> Result<(), Error> {
    control.pass(0.42)?;
    uniform(draft, options, objects, control)?;
    control.pass(0.45)?;
    let mut batch = Batch::new();
    let rule = rule_below(draft, options, control)?;
    let mut next = Place { grid: 0, voxel: 0 };
    loop {
        let room = next.collect(&mut batch, draft, (options, &rule), control)?;
        if batch.is_empty() {
            break;
        }
        let goes_on = batch.split(draft, control)?;
        control.at(next.grid, draft.grids().len())?;
        if !(room && goes_on) {
            break;
        }
    }
    // Depth until now; levels count from the deepest.
    let deepest = draft.grids().iter().map(|g| g.level).max().unwrap_or(0);
    for grid in draft.grids_mut() {
        grid.level = deepest - grid.level;
    }
    Ok(())
}

/// The rule of the grids below. Where it is finer than `options` say by themselves, the
/// capacity is still what their alpha needs: deep grids meet it sooner.
fn rule_below(
    draft: &Draft<'_>,
    options: &Options,
    control: &mut Control<'_>,
) -> Result<Rule, Error> {
    let rule = inner_rule(options);
    if !options.fill_up {
        return Ok(rule);
    }
    let mut references = 0u64;
    for spans in draft.spans(&draft.grids()[0]).chunks(TICK) {
        let crowded = spans.iter().filter(|span| span.count > options.maxp);
        references += crowded.map(|span| u64::from(span.count)).sum::<u64>();
        control.tick(spans.len(), 0, 1)?;
    }
    let finer = cbrt(draft.soup.triangles.len() as f64 / references.max(1) as f64) as f32;
    Ok(Rule { alpha: (rule.alpha * finer).min(1.0).max(rule.alpha), ..rule })
}

/// Voxels looked at between two reports.
const TICK: usize = 4096;

/// A voxel of a grid, to be looked at next.
struct Place {
    grid: usize,
    voxel: usize,
}

impl Place {
    /// Puts crowded voxels into a batch, until it is full or there are no more among the
    /// grids that are filled. False if there is no room for another grid.
    fn collect(
        &mut self,
        batch: &mut Batch,
        draft: &mut Draft<'_>,
        (options, rule): (&Options, &Rule),
        control: &mut Control<'_>,
    ) -> Result<bool, Error> {
        let filled = draft.grids().len();
        while self.grid < filled {
            let grid = draft.grids()[self.grid];
            let splits = grid.level + 1 < options.max_depth;
            let [nx, ny, _] = grid.n.map(|n| n as usize);
            while splits && self.voxel < grid.voxels() as usize {
                let span = draft.spans(&grid)[self.voxel];
                if span.count > options.maxp {
                    let i = self.voxel;
                    let at = [i % nx, i / nx % ny, i / (nx * ny)].map(|i| i as u32);
                    let child = grid.inside(at, grid.level + 1);
                    let rule = draft.weighed_from(rule, &child, span);
                    let child = child.divided(&rule, span.count as usize);
                    match batch.join(draft, grid.first + i as u32, span.count, child) {
                        Joined::Yes => {}
                        Joined::Later => return Ok(true),
                        Joined::Never => return Ok(false),
                    }
                }
                self.voxel += 1;
                if self.voxel.is_multiple_of(TICK) {
                    control.tick(TICK, self.grid, filled)?;
                }
            }
            control.tick(self.voxel % TICK, self.grid, filled)?;
            *self = Self { grid: self.grid + 1, voxel: 0 };
        }
        Ok(true)
    }
}
