//! Rays of a stream down the tree of boxes, a flock of them at a time.
//!
//! A ray alone waits: for memory, for its own last result, and after each branch that was not
//! foreseen; and what it reads of a node or a triangle serves it alone. Here rays that descend
//! along the same axes go down together (ray streams: Tsakok 2009, *Faster incoherent rays:
//! multi-BVH ray stream tracing*; Fuetterer et al. 2015, *Efficient ray tracing kernels for modern
//! CPU architectures*): each part of a node has a list of the rays that meet it (`lists`), lanes
//! are rays where boxes and triangles are met (`boxes`, `leaf`), and the part that a ray in the
//! middle of the list comes to first is next. A list that has become short would
//! leave lanes idle, and each of its steps waits for the one before: its rays go on by
//! themselves, sixteen at a time, each in the order of its own (`tail`, `flight`). Exact tests are
//! made four at a time, a ray and a triangle each (`four`).
//!
//! Answers are those of single rays, bit for bit: `triangle` defines them.

mod boxes;
mod flight;
mod four;
mod leaf;
mod lists;
mod member;
mod octants;
mod tail;

use core::ops::Range;

use super::counters::Uncounted;
use super::query::Query;
use super::sieve::Sieved;
use super::stream::Port;
use crate::arena::node::{Node, PARTS};
use crate::arena::{Bounds, Sections, View};
use crate::simd::{AnyKernel, Isa, Lanes, Shelf};
use flight::{Flight, SLOTS, Sets};
use four::Due;
use leaf::Leaf;
use lists::Lists;
use member::Member;
use octants::Octants;

/// Rays at a time. More are hardly quicker, and would need more of the stack.
const RAYS: usize = 512;

/// Rays that are parted by the axes along which they descend, at a time.
const BLOCK: usize = 4096;

/// Rays of a stream for which it is worth it to make all this ready.
pub(super) const LEAST: usize = 256;

/// Rays of a stream that go down a tree of nodes in full, which the scene has.
pub(super) struct Flock<'a, 'p, Q: Query> {
    pub view: &'a View<'a>,
    pub port: &'p mut dyn Port<Q::Out>,
    pub rays: Range<usize>,
}

/// Whether rows have a lane for each part of a node, and so many triangles are sieved at once.
pub(super) const fn suits<L: Lanes>() -> bool {
    L::REGISTERS && L::WIDE == PARTS
}

/// A flock on its way.
struct Flocking<'a, 'p, 'f, Q: Query, L: Lanes> {
    l: L,
    view: &'a View<'a>,
    sections: Sections<'a>,
    /// The scene's, and its reciprocal.
    unit: f32,
    inverse: f32,
    port: &'p mut dyn Port<Q::Out>,
    /// Which bounds of a node all of them come to first, and last.
    near: [Bounds<'a, Node>; 3],
    far: [Bounds<'a, Node>; 3],
    /// Rays, and that of none.
    members: &'f mut Shelf<Member<'a, Q>, RAYS>,
    none: &'f Member<'a, Q>,
    lists: &'f mut Lists,
    leaf: &'f mut Leaf,
    due: Due,
    /// Those that go on by themselves.
    sets: Sets,
    flights: &'f mut [Flight; SLOTS],
    /// Of their leaves of which several triangles are to be decided.
    kept: &'f mut [Sieved<L>; SLOTS],
}

impl<Q: Query> AnyKernel for Flock<'_, '_, Q> {
    type Out = ();
    // One for any hit with AVX-512 as well would be a fiftieth of the library.
    const BEST: Isa = if Q::ANY { Isa::Avx2 } else { Isa::Avx512 };
    #[inline(always)]
    fn run_on<L: Lanes>(self, l: L) {
        let Self { view, port, rays } = self;
        debug_assert!(view.header().nodes.count > 0 && view.header().quantized == 0);
        if !suits::<L>() {
            return view.one_by_one::<Q, _>(port, rays, &mut Uncounted);
        }
        let sections = view.sections();
        let mut flocking = Flocking::<Q, L> {
            l,
            view,
            sections,
            unit: view.header().unit as f32,
            inverse: (1.0 / view.header().unit) as f32,
            port,
            near: sections.bounds(0),
            far: sections.bounds(7),
            members: &mut Shelf::new(),
            none: &Member::none(l, &sections),
            lists: &mut { Lists::NONE },
            leaf: &mut { Leaf::NONE },
            due: Due::default(),
            sets: Sets::ALL_FREE,
            flights: &mut [Flight::NONE; SLOTS],
            kept: &mut [Sieved::none(l); SLOTS],
        };
        let mut next = rays.start;
        while next < rays.end {
            let block = next..rays.end.min(next + BLOCK);
            next = block.end;
            flocking.part(block);
        }
    }

    // As of streams themselves.
    #[cfg(any(target_arch = "x86_64", all(target_arch = "aarch64", target_feature = "neon")))]
    fn run_portable(self) {
        self.view.one_by_one::<Q, _>(self.port, self.rays, &mut Uncounted);
    }
}

impl<'a, Q: Query, L: Lanes> Flocking<'a, '_, '_, Q, L> {
    /// Answers up to [`BLOCK`] rays, those that descend along the same axes together.
    #[inline(always)]
    fn part(&mut self, block: Range<usize>) {
        let octants = Octants::new(self.l, self.port, &block);
        for octant in 0..8 {
            self.near = self.sections.bounds(octant);
            self.far = self.sections.bounds(!octant);
            for places in octants.of(octant).chunks(RAYS) {
                self.run(block.start, places);
            }
        }
    }

    /// Answers the rays at these places from `first` on.
    #[inline(always)]
    fn run(&mut self, first: usize, places: &[u16]) {
        let mut count = 0;
        for &place in places {
            let index = first + usize::from(place);
            let member = self.members.place(count, self.none);
            self.port.ray(index, &mut member.ray);
            if let Some(to) = member.begin(self.l, self.view, &self.sections, self.unit, index) {
                self.lists.begin(count, to);
                count += 1;
            } else {
                self.view.alone::<Q>(self.port, index);
            }
        }
        self.descend(count);
        for member in &self.members.all()[..count] {
            if member.lost {
                self.view.alone::<Q>(self.port, member.index);
                continue;
            }
            self.port.put(member.index, member.query.found(&self.sections, &member.ray));
        }
    }

    /// Takes so many rays down.
    #[inline(always)]
    fn descend(&mut self, count: usize) {
        let l = self.l;
        self.lists.root(count);
        while let Some((part, count)) = self.lists.pop(l) {
            self.meet(part, count);
        }
        self.decide_due();
        l.run_in_function(tail::Rest { flocking: self, free: SLOTS as u32 });
    }
}
