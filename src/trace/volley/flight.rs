//! A ray of a volley: what it keeps to itself.

use super::super::descent::{Line, Slabs, beyond, start};
use super::super::query::Query;
use super::super::sieve::{Sieve, Sieved};
use crate::arena::node::{LEAF_SHIFT, NODE, Node, PARTS};
use crate::arena::{Sections, View};
use crate::ray::Ray;
use crate::simd::Lanes;

/// Nodes of which parts wait, at most: as many as levels, mostly half of these. A ray that needs
/// more goes alone.
const ROWS: usize = 16;

/// A ray on its way.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct Flight<'a, Q> {
    /// Nodes of which parts wait, the one to go on with last: where the ray enters these parts,
    /// infinity for others; and the nodes' words.
    entries: [[f32; PARTS]; ROWS],
    nodes: [u32; ROWS],
    /// How many there are.
    len: usize,
    line: Line<'a, Node>,
    /// No tau above it is of interest. Finite, as infinity is where there is no part.
    to: f32,
    /// The word of the part where it is.
    part: u32,
    /// In a leaf, the triangle that is to be decided, and a bit for each of the others.
    pub number: u32,
    left: u32,
    /// The ray's place in the stream.
    pub index: usize,
    sieve: Sieve<'a>,
    pub ray: Ray,
    pub query: Q,
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

/// [`beyond`], but finite.
#[inline(always)]
fn end<L: Lanes>(l: L, limit: f32, unit: f32) -> f32 {
    beyond(l, limit, unit).min(f32::MAX)
}

impl<'a, Q: Query> Flight<'a, Q> {
    /// That of no ray.
    #[inline(always)]
    pub fn new<L: Lanes>(l: L, sections: &Sections<'a>) -> Self {
        let ray = Ray::new([0.0; 3], [0.0, 0.0, 1.0]);
        let [org, dir, _] = ray.rows();
        Self {
            entries: [[0.0; PARTS]; ROWS],
            nodes: [NODE; ROWS],
            len: 0,
            line: Line::none(sections),
            to: 0.0,
            part: NODE,
            number: 0,
            left: 0,
            index: 0,
            sieve: Sieve::new(l, sections, &ray, [l.load_f32(org), l.load_f32(dir)], true),
            ray,
            query: Q::new(&ray),
        }
    }

    /// Begins with the ray that was put here; `false` if it is not for the tree.
    #[inline(always)]
    pub fn begin<L: Lanes>(
        &mut self,
        l: L,
        view: &View,
        sections: &Sections<'a>,
        unit: f32,
        index: usize,
    ) -> bool {
        let ray = &self.ray;
        let Some(start) = start(l, view, ray) else { return false };
        let [org, dir, _] = ray.rows();
        self.line = Line::new(l, sections, &start, ray, unit);
        self.to = end(l, ray.tmax, unit);
        self.sieve = Sieve::new(l, sections, ray, [l.load_f32(org), l.load_f32(dir)], true);
        self.query = Q::new(ray);
        (self.part, self.len, self.index) = (NODE, 0, index);
        true
    }

    /// Looks at the boxes of the node where it is, and lets the parts that it meets wait; `false` if
    /// there is no room.
    #[inline(always)]
    pub fn look<L: Lanes>(&mut self, l: L, sections: &Sections<'_>) -> bool {
        if self.len == ROWS {
            return false;
        }
        let slabs = Slabs::<Node, L>::new(l, &self.line);
        let (entries, met) = slabs.entries(l, sections, self.part, self.to);
        let row = self.len % ROWS;
        l.store_wide(entries, &mut self.entries[row]);
        self.nodes[row] = self.part;
        self.len += usize::from(met);
        true
    }

    /// Goes to the nearest part of the last node of which some wait.
    #[inline(always)]
    pub fn next<L: Lanes>(&mut self, l: L, sections: &Sections<'_>) -> Next {
        let (below, none) = (self.len.wrapping_sub(1), self.len == 0);
        let row = below % ROWS;
        let entries = l.load_wide(&self.entries[row]);
        let met = l.at_most(entries, l.splat_wide(self.to));
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

    /// Sieves the leaf where it is; whether there is a triangle to be decided. All that was found is
    /// kept if there are several.
    #[inline(always)]
    pub fn sieve<L: Lanes>(&mut self, l: L, kept: &mut Sieved<L>) -> bool {
        let first = self.part >> LEAF_SHIFT;
        let sieved = self.sieve.run(l, first);
        let left = !(u32::MAX << (self.part & NODE)) & !sieved.out;
        let mut nearest = left.trailing_zeros();
        if left & left.wrapping_sub(1) != 0 {
            *kept = sieved;
            nearest = self.sieve.first(l, &sieved, left);
        }
        self.number = first.wrapping_add(nearest);
        self.left = left & !1u32.wrapping_shl(nearest);
        left != 0
    }

    /// After the triangle that was decided, the next of the leaf that may be nearer than what was
    /// found.
    #[inline(always)]
    pub fn other<L: Lanes>(&mut self, l: L, kept: &Sieved<L>) -> bool {
        if self.left == 0 {
            return false;
        }
        self.left &= self.sieve.again(l, kept);
        if self.left == 0 {
            return false;
        }
        let nearest = self.sieve.first(l, kept, self.left);
        self.left &= !(1 << nearest);
        self.number = (self.part >> LEAF_SHIFT) + nearest;
        true
    }

    /// Looks no farther than what was found.
    #[inline(always)]
    pub fn shorten<L: Lanes>(&mut self, l: L, unit: f32) {
        let limit = self.query.limit();
        self.sieve.limit(l, limit);
        self.to = end(l, limit, unit);
    }
}
