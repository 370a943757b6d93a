//! The hierarchy of uniform grids (section 1.3): filter, cluster, link, fill.

use bytemuck::Zeroable;

use super::capacity::Capacity;
use super::cluster::{Part, cluster};
use super::components::components;
use super::control::Control;
use super::draft::{Crowded, Draft};
use super::filter::Levels;
use super::frame::{Grid, Rule};
use super::hierarchy::link;
use super::orient;
use super::scratch::Scratch;
use super::sort;
use super::uniform::{inner_rule, outer_crowded, outer_rule};
use crate::Error;
use crate::aabb::Aabb;
use crate::arena::layout::GRID_BIT;
use crate::options::{Clustering, Delta, Gridding, Options, Orientation};

/// Builds the hierarchy. `objects` is room for
/// the triangles' numbers and all links.
pub fn hug<'s>(
    draft: &mut Draft<'s>,
    options: &Options,
    capacity: &Capacity,
    objects: &mut [u32],
    scratch: &mut Scratch<'s>,
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let count = draft.soup.triangles.len();
    let boxes = draft.soup.boxes;
    let levels = Levels::fit(&options.filter, boxes);
    let world = levels.count() as u8 - 1;
    let home = &mut scratch.take::<u8>(capacity.filtered)?[..count];
    let order = &mut scratch.take::<u32>(capacity.filtered)?[..count];
    let parts = scratch.take::<Part>(capacity.filtered)?;
    let ranges = scratch.take::<[u32; 2]>(capacity.grids)?;
    let links = scratch.take::<[u32; 2]>(capacity.links)?;

    control.pass(0.25)?;
    let bounds = level_ranges(&levels, boxes, home, order);
    control.count(count);
    draft.push(Grid::around(&draft.soup.bounds, u32::from(world), &draft.soup.bounds))?;
    ranges[0] = Zeroable::zeroed();
    for level in (0..usize::from(world)).rev() {
        let range = bounds[level] as usize..bounds[level + 1] as usize;
        let delta = f64::from(options.connectivity)
            * length(&levels, level, &order[range.clone()], boxes, options);
        let home = (&mut *home, world);
        clusters(draft, options, (order, range), delta, home, parts, ranges, level, control)?;
    }
    control.pass(0.3)?;
    let grids = draft.grids().len();
    // The index array's tail beyond the triangles is not in use yet.
    let count_links = {
        let (free, parent) = objects.split_at_mut(grids.min(objects.len() / 2));
        link(draft, options.hierarchy, links, free, parent, control)?
    };
    if options.orientation != Orientation::Aligned {
        orient::clusters(draft, options, ranges, order, &links[..count_links], control)?;
    }
    control.pass(0.45)?;
    fill(draft, options, ranges, order, (home, world), &links[..count_links], objects, control)
}

/// Sorts the triangles' numbers by level, into `order`; level k is the range
/// from entry k to entry k + 1 of the result.
pub(super) fn level_ranges(
    levels: &Levels,
    boxes: &[Aabb],
    home: &mut [u8],
    order: &mut [u32],
) -> [u32; 17] {
    let mut bounds = [0u32; 17];
    for (home, b) in home.iter_mut().zip(boxes) {
        *home = levels.of(b.diagonal()) as u8;
        bounds[usize::from(*home) + 1] += 1;
    }
    for level in 1..17 {
        bounds[level] += bounds[level - 1];
    }
    let mut next = bounds;
    for (i, home) in (0..).zip(home.iter()) {
        let at = &mut next[usize::from(*home)];
        order[*at as usize] = i;
        *at += 1;
    }
    bounds
}

/// The length that delta is a multiple of.
pub(super) fn length(
    levels: &Levels,
    level: usize,
    members: &[u32],
    boxes: &[Aabb],
    options: &Options,
) -> f64 {
    match options.delta {
        Delta::Midpoint => levels.middle(level),
        Delta::Mean => {
            let sum: f64 = members.iter().map(|&i| boxes[i as usize].diagonal()).sum();
            sum / members.len().max(1) as f64
        }
    }
}

/// Makes a grid of each cluster of a level that is large enough; the objects of
/// the others pop up into the world.
#[allow(clippy::too_many_arguments)]
fn clusters(
    draft: &mut Draft<'_>,
    options: &Options,
    (order, range): (&mut [u32], core::ops::Range<usize>),
    delta: f64,
    (home, world): (&mut [u8], u8),
    parts: &mut [Part],
    ranges: &mut [[u32; 2]],
    level: usize,
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let boxes = draft.soup.boxes;
    let start = range.start;
    let mut number = draft.grids().len();
    let first = number;
    let mut found = |_: &[u32], found: core::ops::Range<usize>| {
        if found.len() >= options.min_cluster as usize {
            ranges[number] = [(start + found.start) as u32, (start + found.end) as u32];
            number += 1;
        }
    };
    match options.clustering {
        Clustering::Projections => {
            cluster(&mut order[range], boxes, delta, parts, control, &mut found)?;
        }
        Clustering::Components => {
            let room = bytemuck::cast_slice_mut(parts);
            components(&mut order[range], boxes, room, control, &mut found)?;
        }
    }
    control.count(home.len());
    // Whatever is in no grid of the level goes to the world.
    for home in home.iter_mut().filter(|home| usize::from(**home) == level) {
        *home = world;
    }
    for &[start, end] in &ranges[first..number] {
        let members = &mut order[start as usize..end as usize];
        sort::by_key(members, &u64::from);
        let mut b = Aabb::EMPTY;
        for &i in members.iter() {
            b.join(&boxes[i as usize]);
            home[i as usize] = level as u8;
        }
        draft.push(Grid::around(&b, level as u32, &draft.soup.bounds))?;
    }
    Ok(())
}

/// Cuts each grid into voxels and sorts its objects and lower grids into them.
#[allow(clippy::too_many_arguments)]
fn fill(
    draft: &mut Draft<'_>,
    options: &Options,
    ranges: &[[u32; 2]],
    order: &[u32],
    (home, world): (&[u8], u8),
    mut links: &[[u32; 2]],
    objects: &mut [u32],
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let inner = inner_rule(options);
    for (number, range) in ranges.iter().enumerate().take(draft.grids().len()) {
        let (mut count, outer) = (0, number == 0);
        let mut add = |object: u32| {
            objects[count] = object;
            count += 1;
        };
        if outer {
            (0..).zip(home).filter(|(_, home)| **home == world).for_each(|(i, _)| add(i));
        } else {
            let [start, end] = *range;
            order[start as usize..end as usize].iter().for_each(|&i| add(i));
        }
        let below = links.iter().take_while(|l| l[0] as usize == number).count();
        links[..below].iter().for_each(|l| add(GRID_BIT | l[1]));
        links = &links[below..];
        let rule = if outer {
            let alpha = options.cluster_alpha(count, draft.soup.triangles.len());
            Rule { alpha, ..outer_rule(options) }
        } else {
            inner
        };
        let crowded = if outer { outer_crowded(options) } else { Crowded::Coarsen };
        let grid = draft.grids()[number];
        // Overlap is looked at along the axes of the scene.
        let rule = if grid.is_turned() && rule.gridding.overlaps() {
            Rule { gridding: Gridding::Proportional, ..rule }
        } else {
            draft.weighed(&rule, &grid, &objects[..count])
        };
        let grid = grid.divided(&rule, count);
        draft.grids_mut()[number] = grid;
        control.tick(count, number, ranges.len())?;
        control.within(|control| draft.fill(number, &objects[..count], crowded, control))?;
    }
    Ok(())
}
