//! Nodes from above, split until they have eight parts.

use super::item::Item;
use super::split::{Bins, Care, Part, split};
use crate::Error;
use crate::arena::layout::{LEAF, Node, PARTS};
use crate::build::control::{Control, TASKS, parts};
use crate::build::scratch::cut;

/// Some nodes of a level and their items, the first of which is number `start`.
struct Share<'a> {
    nodes: &'a mut [Node],
    ranges: &'a [[u32; 2]],
    items: &'a mut [Item],
    start: usize,
}

/// Splits the nodes of a level, in tasks.
pub fn split_level(
    mut nodes: &mut [Node],
    mut ranges: &[[u32; 2]],
    mut items: &mut [Item],
    care: Option<Care>,
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let all: usize = ranges.iter().map(|range| range[1] as usize).sum();
    let share = all.div_ceil(TASKS);
    let mut at = 0;
    let mut tasks = parts(|| {
        let (mut count, mut sum) = (0, 0);
        for range in ranges {
            if sum >= share {
                break;
            }
            (count, sum) = (count + 1, sum + range[1] as usize);
        }
        let (some, rest) = ranges.split_at(count);
        ranges = rest;
        let [start, _] = *some.first()?;
        let [last, len] = *some.last()?;
        cut(&mut items, start as usize - at);
        at = (last + len) as usize;
        let items = cut(&mut items, at - start as usize);
        Some(Share { nodes: cut(&mut nodes, count), ranges: some, items, start: start as usize })
    });
    control.each(&mut tasks, |some| {
        let mut bins = Bins::new();
        for (node, [start, len]) in some.nodes.iter_mut().zip(some.ranges) {
            let start = *start as usize - some.start;
            let items = &mut some.items[start..start + *len as usize];
            *node = split_node(items, (start + some.start) as u32, care, &mut bins);
        }
    })?;
    control.count(all);
    Ok(())
}

/// A node over some items. Its parts have no places yet: where they begin among all items,
/// the first of these being `start`, is in the words that are reserved.
fn split_node(items: &mut [Item], start: u32, care: Option<Care>, bins: &mut Bins) -> Node {
    let mut parts = [Part::EMPTY; PARTS];
    parts[0] = Part::of(items);
    let mut count = 1;
    while count < PARTS {
        // A part's place among its neighbours stays, so that items of a level are in order.
        let size = |part: &Part| if care.is_some() { part.surface() } else { part.len as f32 };
        let large = (0..count).filter(|&k| parts[k].len > LEAF as usize);
        let Some(k) = large.reduce(|a, b| if size(&parts[b]) > size(&parts[a]) { b } else { a })
        else {
            break;
        };
        let first: usize = parts[..k].iter().map(|part| part.len).sum();
        let some = &mut items[first..first + parts[k].len];
        let [a, b] = split(some, &parts[k], care, bins);
        parts.copy_within(k + 1..count, k + 2);
        (parts[k], parts[k + 1]) = (a, b);
        count += 1;
    }
    let mut node = Node { bounds: [[0.0; PARTS]; 6], parts: [0; PARTS], reserved: [0; PARTS] };
    let mut at = start;
    for (i, part) in parts.iter().enumerate() {
        for k in 0..3 {
            (node.bounds[2 * k][i], node.bounds[2 * k + 1][i]) = (part.lo[k], part.hi[k]);
        }
        (node.parts[i], node.reserved[i]) = (part.len as u32, at);
        at += part.len as u32;
    }
    node
}
