//! Which clusters get turned grids.

use super::{axes, ends, surface};
use crate::Error;
use crate::build::control::Control;
use crate::build::draft::Draft;
use crate::build::frame::Grid;
use crate::build::turn::Turn;
use crate::options::Options;
use core::cmp::Ordering;
use glam::DVec3;

/// Turns the grids of clusters that have no grids below and are the better for it. What
/// refers to them has been decided, by their aligned boxes.
pub fn clusters(
    draft: &mut Draft<'_>,
    options: &Options,
    ranges: &[[u32; 2]],
    order: &[u32],
    links: &[[u32; 2]],
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let total = draft.grids().len();
    for (number, &[start, end]) in ranges.iter().enumerate().take(total).skip(1) {
        let members = &order[start as usize..end as usize];
        control.tick(members.len(), number, total)?;
        let below = links.partition_point(|link| (link[0] as usize) < number);
        if links.get(below).is_some_and(|link| link[0] as usize == number) {
            continue;
        }
        if let Some((grid, turn)) = oriented(draft, options, number, members) {
            draft.set_turn(number, grid, turn);
        }
    }
    Ok(())
}

/// The turned grid of a cluster, if it is to have one.
fn oriented(
    draft: &Draft<'_>,
    options: &Options,
    number: usize,
    members: &[u32],
) -> Option<(Grid, Turn)> {
    let (soup, aligned) = (&draft.soup, &draft.grids()[number]);
    let lower = DVec3::from(aligned.lo);
    let origin = lower + 0.5 * DVec3::from(aligned.extent);
    let corners = members.iter().flat_map(|&i| soup.triangles[i as usize].corners());
    let points = corners.map(|p| DVec3::from(p.map(f64::from)) - origin);
    let turned = axes(options.orientation, points.clone());
    let around = ends(&turned, points.clone());
    let plain = ends(&[DVec3::X, DVec3::Y, DVec3::Z], points);
    let share = f64::from(options.turn_below);
    // No NaN is less.
    if surface(around).partial_cmp(&(share * surface(plain))) != Some(Ordering::Less) {
        return None;
    }
    let turn = Turn::new(&turned, origin, aligned);
    Some((turn.grid(around, aligned.level, &soup.bounds)?, turn))
}
