//! The uniform grid (section 1.3): the box of all objects, cut once.

use super::control::Control;
use super::draft::{Crowded, Draft};
use super::frame::{Grid, Rule};
use crate::Error;
use crate::options::Options;

/// The outermost grid's rule for its counts.
pub fn outer_rule(options: &Options) -> Rule {
    Rule { alpha: options.outer_alpha(), counts: options.counts, ..inner_rule(options) }
}

/// The rule of the grids below.
pub fn inner_rule(options: &Options) -> Rule {
    let Options { gridding, alpha, overlap_power: power, .. } = *options;
    Rule { gridding, alpha, power, counts: [0; 3], weights: [1.0; 3] }
}

/// What to do when the outermost grid's references exceed its budget.
pub fn outer_crowded(options: &Options) -> Crowded {
    if options.counts == [0; 3] { Crowded::Coarsen } else { Crowded::Fail }
}

/// Puts all triangles into one grid. `objects` is room for their numbers, or has them in an
/// order that is to be kept.
pub fn uniform(
    draft: &mut Draft<'_>,
    options: &Options,
    objects: &mut [u32],
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let count = draft.soup.triangles.len();
    let objects = &mut objects[..count];
    if !draft.is_ordered() {
        (0..).zip(objects.iter_mut()).for_each(|(i, object)| *object = i);
    }
    let grid = Grid::around(&draft.soup.bounds, 0, &draft.soup.bounds);
    let rule = draft.weighed(&outer_rule(options), &grid, objects);
    let number = draft.push(grid.divided(&rule, count))?;
    draft.fill(number, objects, outer_crowded(options), control)
}
