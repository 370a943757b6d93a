//! A ray of a flock on its own way.

use super::super::descent::Slabs;
use super::super::query::Query;
use super::super::sieve::{Sieve, Sieved};
use super::RAYS;
use super::member::Member;
use crate::arena::node::{LEAF_SHIFT, NODE, Node, PARTS};
use crate::arena::{Bounds, Sections};
use crate::simd::Lanes;

/// Ways at a time. Of more, the caches next to the processor do not hold all that is needed.
pub const SLOTS: usize = 16;

// What is next for each of them is a bit in one of four sets of one number.
const _: () = assert!(4 * SLOTS <= u64::BITS as usize);

/// Nodes of which parts wait, at most; mostly they are half as many as levels. A ray that needs more is
/// answered alone.
const ROWS: usize = 16;

/// Slots, a bit each, by what is to be done.
#[derive(Clone, Copy)]
pub struct Sets {
    /// Without a ray.
    pub free: u32,
    /// At a node whose boxes are to be looked at.
    pub nodes: u32,
    /// At a leaf that is to be sieved.
    pub leaves: u32,
    /// With a triangle that is to be decided.
    pub due: u32,
    /// To go to the next part that waits.
    pub next: u32,
}

impl Sets {
    pub const ALL_FREE: Self =
        Self { free: u32::MAX >> (32 - SLOTS), nodes: 0, leaves: 0, due: 0, next: 0 };
}

/// The first of some slots, which is taken out.
#[inline(always)]
pub fn first(slots: &mut u32) -> Option<usize> {
    let slot = slots.trailing_zeros() as usize;
    if *slots == 0 {
        return None;
    }
    *slots &= *slots - 1;
    Some(slot % SLOTS)
}

/// The way of a ray.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct Flight {
    /// Nodes of which parts wait, the one to go on with last: where the ray enters these parts,
    /// infinity for others; and the nodes' words.
    entries: [[f32; PARTS]; ROWS],
    nodes: [u32; ROWS],
    /// The ray as boxes want it, which is wanted often.
    rows: [[f32; 4]; 3],
    /// How many there are.
    len: usize,
    /// The word of the part where it is.
    part: u32,
    ray: u32,
    /// In a leaf, the triangle that is to be decided, and a bit for each of the others.
    pub number: u32,
    left: u32,
}

/// What there is for a ray next.
#[derive(Clone, Copy)]
pub enum Next {
    Node,
    Leaf,
    /// Nothing of the last node is near enough by now.
    Again,
    Nothing,
}

impl Flight {
    pub const NONE: Self = Self {
        entries: [[0.0; PARTS]; ROWS],
        nodes: [NODE; ROWS],
        rows: [[0.0; 4]; 3],
        len: 0,
        part: NODE,
        ray: 0,
        number: 0,
        left: 0,
    };

    /// Begins at some part.
    #[inline(always)]
    pub fn begin(&mut self, ray: u32, rows: &[[f32; 4]; 3], part: u32) {
        self.rows = *rows;
        (self.ray, self.part, self.len) = (ray, part, 0);
    }

    /// The number of its ray.
    #[inline(always)]
    pub fn ray(&self) -> usize {
        self.ray as usize % RAYS
    }

    /// Looks at the boxes of the node where it is, and lets the parts that it meets wait; `false` if
    /// there is no room.
    #[inline(always)]
    pub fn look<L: Lanes>(
        &mut self,
        l: L,
        sections: &Sections<'_>,
        [near, far]: [&[Bounds<'_, Node>; 3]; 2],
        to: f32,
    ) -> bool {
        if self.len == ROWS {
            self.len = 0;
            return false;
        }
        let slabs = Slabs::<Node, L>::of(l, &self.rows, *near, *far);
        let (entries, met) = slabs.entries(l, sections, self.part, to);
        let row = self.len % ROWS;
        l.store_wide(entries, &mut self.entries[row]);
        self.nodes[row] = self.part;
        self.len += usize::from(met);
        true
    }

    /// Goes to the nearest part of the last node of which some wait.
    #[inline(always)]
    pub fn next<L: Lanes>(&mut self, l: L, sections: &Sections<'_>, to: f32) -> Next {
        let (below, none) = (self.len.wrapping_sub(1), self.len == 0);
        let row = below % ROWS;
        let entries = l.load_wide(&self.entries[row]);
        let met = l.at_most(entries, l.splat_wide(to));
        let met = if none { 0 } else { met };
        let lane = l.least(entries).trailing_zeros() as usize % PARTS;
        self.entries[row][lane] = f32::INFINITY;
        self.part = sections.node::<Node>(self.nodes[row]).parts[lane];
        sections.fetch_part::<Node, L>(l, self.part);
        let others = met & met.wrapping_sub(1) != 0;
        self.len = below.wrapping_add(usize::from(others | none));
        let going = if self.part & NODE == NODE { Next::Node } else { Next::Leaf };
        let stopped = if self.len == 0 { Next::Nothing } else { Next::Again };
        if met != 0 { going } else { stopped }
    }

    /// Sieves the leaf where it is: whether there is a triangle to be decided, and whether one is
    /// hit for certain, and that is enough. All that was found is kept if there are several.
    #[inline(always)]
    pub fn sieve<'a, Q: Query, L: Lanes>(
        &mut self,
        l: L,
        sections: &Sections<'a>,
        member: &Member<'a, Q>,
        kept: &mut Sieved<L>,
    ) -> [bool; 2] {
        let first = self.part >> LEAF_SHIFT;
        let sieve = &member.sieve;
        let sieved = sieve.run(l, first);
        let left = !(u32::MAX << (self.part & NODE)) & !sieved.out;
        let triangle = |i: usize| sections.triangle(first + i as u32);
        if Q::ANY && sieve.hits(l, &member.ray, &sieved, left, triangle) {
            return [false, true];
        }
        let mut nearest = left.trailing_zeros();
        if left & left.wrapping_sub(1) != 0 {
            *kept = sieved;
            if !Q::ANY {
                nearest = sieve.first(l, &sieved, left);
            }
        }
        self.number = first.wrapping_add(nearest);
        self.left = left & !1u32.wrapping_shl(nearest);
        [left != 0, false]
    }

    /// After the triangle that was decided, the next of the leaf that may be nearer than what was
    /// found.
    #[inline(always)]
    pub fn other<Q: Query, L: Lanes>(&mut self, l: L, sieve: &Sieve<'_>, kept: &Sieved<L>) -> bool {
        if self.left == 0 {
            return false;
        }
        let mut nearest = self.left.trailing_zeros();
        if !Q::ANY {
            self.left &= sieve.again(l, kept);
            if self.left == 0 {
                return false;
            }
            nearest = sieve.first(l, kept, self.left);
        }
        self.left &= !(1 << nearest);
        self.number = (self.part >> LEAF_SHIFT) + nearest;
        true
    }
}
