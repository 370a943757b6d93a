//! The tree of boxes: triangles split in two and again, by boxes of least surface, into nodes
//! of eight parts and leaves of up to eight triangles.
//!
//! Splits are those of least expected cost by surface area (MacDonald & Booth 1990) among
//! the borders of a few bins (Wald 2007). A node is split at the part of the largest surface
//! until it has eight parts. Level by level, a node is a task: its triangles lie together, and those of a
//! level in the order of its nodes. Numbers are given between levels, so the tree does not
//! depend on who did what. Where it becomes deep, triangles are halved instead, so that its
//! depth, and with it the work, is bounded: there are at most [`CHOSEN`] + log2 n levels, and of
//! each a triangle is in at most seven splits.

mod item;
mod split;

use super::control::{Control, TASKS, parts};
use super::frame::unit;
use super::gather::Soup;
use super::scratch::{Scratch, cut};
use crate::Error;
use crate::arena::layout::{LEAF, NODE, Node, PART_SHIFT, PARTS, TREE_UNITS};
use item::{Item, items};
use split::{Bins, Part, split};

pub use split::Care;

/// Levels of nodes whose splits are chosen; below, triangles are halved.
const CHOSEN: usize = 36;
/// Triangles above which parts' places do not fit a node's words.
pub const MOST: usize = 1 << (32 - PART_SHIFT);

/// By how much a descent meets boxes early and late, where the ray begins in the scene
/// (`trace::descent`).
const MARGIN: f64 = 3.0 / (1 << 20) as f64;

/// Half the surface of a box.
fn surface([x, y, z]: [f64; 3]) -> f64 {
    x * y + y * z + z * x
}

/// Most nodes over so many triangles. One without nodes below holds nine triangles at least,
/// but for the root; one with such has eight parts, so these are a seventh of all leaves.
pub fn capacity(triangles: usize) -> usize {
    if triangles == 0 || triangles >= MOST { 0 } else { triangles / 9 + triangles / 7 + 2 }
}

/// Working memory.
pub struct Memory<'s> {
    items: &'s mut [Item],
    nodes: &'s mut [Node],
    /// Of each node that is named, the first of its items, and their number.
    ranges: &'s mut [[u32; 2]],
}

impl<'s> Memory<'s> {
    /// For up to so many triangles; none for none.
    pub fn take(triangles: usize, scratch: &mut Scratch<'s>) -> Result<Self, Error> {
        let nodes = capacity(triangles);
        Ok(Self {
            items: scratch.take(triangles)?,
            nodes: scratch.take(nodes)?,
            ranges: scratch.take(nodes)?,
        })
    }

    /// Bytes for up to so many triangles.
    pub fn records(triangles: usize) -> [(usize, usize); 2] {
        let nodes = capacity(triangles);
        [(triangles, size_of::<Item>()), (nodes, size_of::<Node>() + size_of::<[u32; 2]>())]
    }

    /// Builds the tree over all triangles of a soup that is not empty, and orders them as its
    /// leaves are. Where most triangles are in leaves so small beside the scene's extent that
    /// the descent's margins, which are in proportion to that, double their boxes' surface, there
    /// are no nodes: grids have coordinates of their own.
    pub fn build(
        self,
        soup: &Soup<'_>,
        order: &mut [u32],
        care: Care,
        control: &mut Control<'_>,
    ) -> Result<&'s [Node], Error> {
        let Self { items: memory, nodes, ranges } = self;
        if !TREE_UNITS.contains(&unit(&soup.bounds)) {
            return Ok(&[]);
        }
        let memory = &mut memory[..soup.triangles.len()];
        items(soup, memory, control)?;
        let mut numbers = Numbers { next: 1, first: 0, ranges, order, tiny: 0 };
        numbers.ranges[0] = [0, memory.len() as u32];
        let (mut level, mut depth) = (0..1, 0);
        while !level.is_empty() {
            let some = &mut nodes[level.clone()];
            let ranges = &numbers.ranges[level.clone()];
            split_level(some, ranges, memory, (depth < CHOSEN).then_some(care), control)?;
            for node in some {
                numbers.give(node, memory);
            }
            control.at(numbers.first, memory.len())?;
            level = level.end..numbers.next;
            depth += 1;
        }
        Ok(if 2 * numbers.tiny > memory.len() { &[] } else { &nodes[..numbers.next] })
    }
}

/// Some nodes of a level and their items, the first of which is number `start`.
struct Share<'a> {
    nodes: &'a mut [Node],
    ranges: &'a [[u32; 2]],
    items: &'a mut [Item],
    start: usize,
}

/// Splits the nodes of a level, in tasks.
fn split_level(
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

/// The numbers of nodes and triangles to come.
struct Numbers<'a> {
    next: usize,
    first: usize,
    ranges: &'a mut [[u32; 2]],
    order: &'a mut [u32],
    /// Triangles in leaves whose boxes have twice the surface with a descent's margins, or more.
    tiny: usize,
}

impl Numbers<'_> {
    /// Gives the parts of a node their places, and puts the largest first: where any hit will do,
    /// it is most likely to be there (surface area traversal order, Nah & Manocha 2014).
    fn give(&mut self, node: &mut Node, items: &[Item]) {
        let bounds = node.bounds;
        let sides = |i: usize| {
            [0, 1, 2].map(|k| f64::from(bounds[2 * k + 1][i]) - f64::from(bounds[2 * k][i]))
        };
        let mut order = [(0.0, 0); PARTS];
        for (i, (part, start)) in node.parts.iter_mut().zip(&mut node.reserved).enumerate() {
            let (len, start) = (*part, core::mem::take(start));
            *part = if len > LEAF {
                self.ranges[self.next] = [start, len];
                self.next += 1;
                (self.next as u32 - 1) << PART_SHIFT | NODE
            } else if len > 0 {
                let leaf = &items[start as usize..][..len as usize];
                let met = surface(sides(i).map(|side| side + 2.0 * MARGIN));
                if met > 2.0 * surface(sides(i)) {
                    self.tiny += leaf.len();
                }
                for (to, item) in self.order[self.first..].iter_mut().zip(leaf) {
                    *to = item.number();
                }
                self.first += leaf.len();
                (self.first as u32 - len) << PART_SHIFT | len
            } else {
                0
            };
            order[i] = (if len > 0 { surface(sides(i)) } else { -1.0 }, i);
        }
        order.sort_unstable_by(|(a, i), (b, j)| b.total_cmp(a).then(i.cmp(j)));
        let parts = node.parts;
        for (to, (_, from)) in order.into_iter().enumerate() {
            node.parts[to] = parts[from];
            for (row, bounds) in node.bounds.iter_mut().zip(&bounds) {
                row[to] = bounds[from];
            }
        }
    }
}
