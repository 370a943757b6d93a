//! Rays of a stream on their way down the tree of boxes, sixteen at a time.
//!
//! A ray alone waits: for memory, for its own last result, and after each branch that was not
//! foreseen. Here all rays that are to do the same do it one after the other, in loops of which none
//! waits for the ray before: look at the boxes of a node; sieve a leaf; decide one triangle each,
//! four rays in lanes; take the nearest of the parts that wait (`flight`). The loops are short,
//! so that a processor has several rays' of them in the works, and hardly a branch in them depends
//! on a ray. What is to be done with a ray next is which of the [`Sets`] it is in.
//!
//! It is for the closest hits of rays that begin far from each other (`scattered`).
//! Answers are those of single rays, bit for bit: `triangle` defines them.

mod flight;
mod four;
mod scattered;

use core::ops::Range;

use super::query::Query;
use super::sieve::Sieved;
use super::stream::Port;
use crate::arena::node::PARTS;
use crate::arena::{Sections, View};
use crate::simd::{Kernel, Lanes};
use flight::{Flight, Next};
pub(super) use scattered::scattered;

/// Rays at a time. Of more, the caches next to the processor do not hold all that is needed.
const SLOTS: usize = 16;

// What is next for each of them is a bit in one of four sets of one number.
const _: () = assert!(4 * SLOTS <= u64::BITS as usize);

/// Rays of a stream for closest hits that go down a tree of nodes in full, which the scene has, in lanes
/// that [`suits`].
pub(super) struct Volley<'a, 'p, Q: Query> {
    pub view: &'a View<'a>,
    pub port: &'p mut dyn Port<Q::Out>,
    pub rays: Range<usize>,
}

/// Whether rows have a lane for each part of a node, and so many triangles are sieved at once.
pub(super) const fn suits<L: Lanes>() -> bool {
    L::REGISTERS && L::WIDE == PARTS
}

/// Slots, a bit each, by what is to be done with their rays.
#[derive(Clone, Copy)]
struct Sets {
    /// Without a ray.
    free: u32,
    /// At a node whose boxes are to be looked at.
    nodes: u32,
    /// At a leaf that is to be sieved.
    leaves: u32,
    /// With a triangle that is to be decided.
    due: u32,
    /// To go to the next part that waits.
    next: u32,
    /// With their answers.
    done: u32,
}

/// The first of some slots, which is taken out.
#[inline(always)]
fn first(slots: &mut u32) -> Option<usize> {
    let slot = slots.trailing_zeros() as usize;
    if *slots == 0 {
        return None;
    }
    *slots &= *slots - 1;
    Some(slot % SLOTS)
}

/// All that is on its way.
struct Rounds<'a, 'p, 'f, Q: Query, L: Lanes> {
    l: L,
    view: &'a View<'a>,
    sections: Sections<'a>,
    /// The scene's.
    unit: f32,
    port: &'p mut dyn Port<Q::Out>,
    rays: Range<usize>,
    flights: &'f mut [Flight<'a, Q>; SLOTS],
    /// Of leaves of which several triangles are to be decided.
    kept: &'f mut [Sieved<L>; SLOTS],
    sets: Sets,
}

impl<Q: Query, L: Lanes> Kernel<L> for Volley<'_, '_, Q> {
    type Out = ();
    #[inline(always)]
    fn run(self, l: L) {
        let Self { view, port, rays } = self;
        debug_assert!(suits::<L>() && !Q::ANY);
        debug_assert!(view.header().nodes.count > 0 && view.header().quantized == 0);
        let sections = view.sections();
        let mut flights = [Flight::<Q>::new(l, &sections); SLOTS];
        let free = u32::MAX >> (32 - SLOTS);
        Rounds {
            l,
            view,
            sections,
            unit: view.header().unit as f32,
            port,
            rays,
            flights: &mut flights,
            kept: &mut [Sieved::none(l); SLOTS],
            sets: Sets { free, nodes: 0, leaves: 0, due: 0, next: 0, done: 0 },
        }
        .run();
    }
}

impl<Q: Query, L: Lanes> Rounds<'_, '_, '_, Q, L> {
    #[inline(always)]
    fn run(mut self) {
        loop {
            self.load();
            let Sets { nodes, leaves, due, next, .. } = self.sets;
            if nodes | leaves | due | next == 0 {
                return;
            }
            self.look();
            self.sieve();
            self.decide();
            self.go_on();
            self.answer();
        }
    }

    /// Puts the next rays in slots that are free, at the root.
    #[inline(always)]
    fn load(&mut self) {
        while let Some(slot) = first(&mut self.sets.free) {
            let flight = &mut self.flights[slot];
            for index in self.rays.by_ref() {
                self.port.ray(index, &mut flight.ray);
                if flight.begin(self.l, self.view, &self.sections, self.unit, index) {
                    self.sets.nodes |= 1 << slot;
                    break;
                }
                self.view.alone::<Q>(self.port, index);
            }
        }
    }

    /// Looks at the boxes of nodes.
    #[inline(always)]
    fn look(&mut self) {
        let mut slots = core::mem::take(&mut self.sets.nodes);
        self.sets.next |= slots;
        while let Some(slot) = first(&mut slots) {
            let flight = &mut self.flights[slot];
            if !flight.look(self.l, &self.sections) {
                self.view.alone::<Q>(self.port, flight.index);
                self.sets.next &= !(1 << slot);
                self.sets.free |= 1 << slot;
            }
        }
    }

    /// Sieves leaves.
    #[inline(always)]
    fn sieve(&mut self) {
        let mut slots = core::mem::take(&mut self.sets.leaves);
        let (mut due, mut next) = (0, 0);
        while let Some(slot) = first(&mut slots) {
            let some = self.flights[slot].sieve(self.l, &mut self.kept[slot]);
            due |= u32::from(some) << slot;
            next |= u32::from(!some) << slot;
        }
        self.sets.due |= due;
        self.sets.next |= next;
    }

    /// Decides triangles, as long as there are four, or nothing else to do.
    #[inline(always)]
    fn decide(&mut self) {
        while self.sets.due.count_ones() >= 4 || (self.sets.due != 0 && self.sets.next == 0) {
            let mut slots = [self.sets.due.trailing_zeros() as usize % SLOTS; 4];
            let mut count = 0;
            while count < 4 {
                let Some(slot) = first(&mut self.sets.due) else { break };
                slots[count] = slot;
                count += 1;
            }
            self.decide_four(slots, count);
            for &slot in &slots[..count] {
                self.decide_rest(slot);
                self.sets.next |= 1 << slot;
            }
        }
    }

    /// Takes rays to the next parts that wait.
    #[inline(always)]
    fn go_on(&mut self) {
        let mut slots = core::mem::take(&mut self.sets.next);
        // Sets one after the other, so that each takes a few operations on a register.
        let mut all = 0u64;
        while let Some(slot) = first(&mut slots) {
            let next = self.flights[slot].next(self.l, &self.sections);
            all |= 1 << (next as usize * SLOTS + slot);
        }
        let set = |next: Next| (all >> (next as usize * SLOTS)) as u32 & (u32::MAX >> (32 - SLOTS));
        self.sets.nodes |= set(Next::Node);
        self.sets.leaves |= set(Next::Leaf);
        self.sets.next = set(Next::Again);
        self.sets.done = set(Next::Nothing);
    }

    /// Gives answers.
    #[inline(always)]
    fn answer(&mut self) {
        let mut slots = core::mem::take(&mut self.sets.done);
        self.sets.free |= slots;
        while let Some(slot) = first(&mut slots) {
            let Flight { index, query, ray, .. } = &self.flights[slot];
            self.port.put(*index, query.found(&self.sections, ray));
        }
    }
}
