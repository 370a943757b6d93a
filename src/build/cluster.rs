//! Clustering (Definitions 2 and 3), in place.
//!
//! A level's objects are a range of one index array. The range is sorted along
//! an axis and cut into runs whose neighbours are closer than delta; each run
//! goes on with the next axis, until it is connected along x, y and z in a row
//! (pi_xyz). Distances are between boxes, so an object that reaches far keeps
//! its run together. Cost: O(n log n) for each round of three axes; real scenes
//! need a few.

use bytemuck::{Pod, Zeroable};

use super::control::Control;
use super::sort;
use crate::Error;
use crate::aabb::Aabb;
use crate::math::ordered;

/// A range of the index array that is still to be looked at.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub struct Part {
    start: u32,
    end: u32,
    /// Low byte: the axis to look along. Next: axes found connected in a row.
    /// The rest: how often it was cut.
    state: u32,
}

/// A part that has been cut this often is taken as it is: bounds the time on
/// inputs made to be cut one object at a time.
const MAX_CUTS: u32 = 64;

/// Splits `order` into clusters by permuting it and calls `found` with it and the
/// range of each, which is final by then. `parts` is room for as many parts as there are objects.
pub fn cluster(
    order: &mut [u32],
    boxes: &[Aabb],
    delta: f64,
    parts: &mut [Part],
    control: &mut Control<'_>,
    found: &mut dyn FnMut(&[u32], core::ops::Range<usize>),
) -> Result<(), Error> {
    if order.is_empty() {
        return Ok(());
    }
    let mut settled = 0;
    let mut waiting = 0;
    let push = |parts: &mut [Part], waiting: &mut usize, start: usize, end: usize, state: u32| {
        parts[*waiting] = Part { start: start as u32, end: end as u32, state };
        *waiting += 1;
    };
    push(parts, &mut waiting, 0, order.len(), 0);
    while waiting > 0 {
        waiting -= 1;
        let part = parts[waiting];
        let (start, end) = (part.start as usize, part.end as usize);
        let (axis, connected, cuts) = (part.state & 0xff, part.state >> 8 & 0xff, part.state >> 16);
        if end - start == 1 || connected == 3 || cuts == MAX_CUTS {
            settled += end - start;
            found(order, start..end);
            continue;
        }
        control.tick(end - start, settled, order.len())?;
        let k = axis as usize;
        let range = &mut order[start..end];
        sort::by_key(range, &|i| u64::from(ordered(boxes[i as usize].lo[k])) << 32 | u64::from(i));
        let next_axis = (axis + 1) % 3;
        let (mut run, mut reach) = (start, f64::NEG_INFINITY);
        for i in start..end {
            let b = &boxes[order[i] as usize];
            if i > run && f64::from(b.lo[k]) - reach >= delta {
                push(parts, &mut waiting, run, i, next_axis | 1 << 8 | (cuts + 1) << 16);
                run = i;
            }
            reach = reach.max(f64::from(b.hi[k]));
        }
        let whole = run == start;
        let state =
            if whole { (connected + 1) << 8 | cuts << 16 } else { 1 << 8 | (cuts + 1) << 16 };
        push(parts, &mut waiting, run, end, next_axis | state);
    }
    Ok(())
}
