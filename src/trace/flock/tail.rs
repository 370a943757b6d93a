//! Rays of a flock that go on by themselves: each from some part of a node on, nearest parts first.
//!
//! All that are to do the same do it one after the other, in loops of which none
//! waits for the ray before: look at the boxes of a node; sieve a leaf; decide one triangle each,
//! four rays in lanes; take the nearest of the parts that wait (`flight`). The loops are short,
//! so that a processor has several rays' of them in the works, and hardly a branch in them depends
//! on a ray. What is to be done with a ray next is which of the [`Sets`](super::flight::Sets) it is in. A ray may be here
//! more than once, at different parts.

use super::super::query::Query;
use super::Flocking;
use super::flight::{Next, SLOTS, Sets, first};
use crate::arena::node::NODE;
use crate::simd::{Kernel, Lanes};

/// Slots that become free before others of the flock go on.
const FREE: u32 = 6;

/// Until so many slots are free.
pub(super) struct Rest<'s, 'a, 'p, 'f, Q: Query, L: Lanes> {
    pub flocking: &'s mut Flocking<'a, 'p, 'f, Q, L>,
    pub free: u32,
}

impl<Q: Query, L: Lanes> Kernel<L> for Rest<'_, '_, '_, '_, Q, L> {
    type Out = ();
    #[inline(always)]
    fn run(self, _: L) {
        let Self { flocking, free } = self;
        while flocking.sets.free.count_ones() < free {
            flocking.look();
            flocking.sieve();
            flocking.decide();
            flocking.go_on();
        }
    }
}

impl<Q: Query, L: Lanes> Flocking<'_, '_, '_, Q, L> {
    /// Lets a ray go on by itself.
    #[inline(always)]
    pub(super) fn part_with(&mut self, ray: u32, part: u32) {
        if self.sets.free == 0 {
            self.l.run_in_function(Rest { flocking: self, free: FREE });
        }
        let Some(slot) = first(&mut self.sets.free) else { return };
        self.flights[slot].begin(ray, &self.members[ray as usize].rows, part);
        let is_node = u32::from(part & NODE == NODE);
        self.sets.nodes |= is_node << slot;
        self.sets.leaves |= (is_node ^ 1) << slot;
    }

    /// Looks at the boxes of nodes.
    #[inline(always)]
    fn look(&mut self) {
        let mut slots = core::mem::take(&mut self.sets.nodes);
        self.sets.next |= slots;
        while let Some(slot) = first(&mut slots) {
            let flight = &mut self.flights[slot];
            let ray = flight.ray();
            let to = self.lists.tos[ray];
            if !flight.look(self.l, &self.sections, [&self.near, &self.far], to) {
                self.members[ray].lost = true;
                self.lists.tos[ray] = f32::NEG_INFINITY;
            }
        }
    }

    /// Sieves leaves.
    #[inline(always)]
    fn sieve(&mut self) {
        let mut slots = core::mem::take(&mut self.sets.leaves);
        let (mut due, mut next) = (0, 0);
        while let Some(slot) = first(&mut slots) {
            let flight = &mut self.flights[slot];
            let ray = flight.ray();
            let (member, kept) = (&mut self.members[ray], &mut self.kept[slot]);
            let [some, enough] = flight.sieve(self.l, &self.sections, member, kept);
            if Q::ANY && enough {
                member.query.take_any();
                self.lists.tos[ray] = f32::NEG_INFINITY;
            }
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
            let (mut slots, mut due) = ([0; 4], [[0; 2]; 4]);
            let mut count = 0;
            while count < 4 {
                let Some(slot) = first(&mut self.sets.due) else { break };
                let flight = &self.flights[slot];
                (slots[count], due[count]) = (slot, [flight.ray() as u32, flight.number]);
                count += 1;
            }
            self.decide_four(due, count);
            for &slot in &slots[..count] {
                self.decide_rest(slot);
                self.sets.next |= 1 << slot;
            }
        }
    }

    /// Decides the others of a leaf.
    #[inline(always)]
    fn decide_rest(&mut self, slot: usize) {
        loop {
            let flight = &mut self.flights[slot % SLOTS];
            let ray = flight.ray();
            let sieve = &self.members[ray].sieve;
            if !flight.other::<Q, L>(self.l, sieve, &self.kept[slot % SLOTS]) {
                return;
            }
            let number = flight.number;
            self.decide_one(ray, number);
        }
    }

    /// Takes rays to the next parts that wait.
    #[inline(always)]
    fn go_on(&mut self) {
        let mut slots = core::mem::take(&mut self.sets.next);
        // Sets one after the other, so that each takes a few operations on a register.
        let mut all = 0u64;
        while let Some(slot) = first(&mut slots) {
            let flight = &mut self.flights[slot];
            let to = self.lists.tos[flight.ray()];
            let next = flight.next(self.l, &self.sections, to);
            all |= 1 << (next as usize * SLOTS + slot);
        }
        let Sets { nodes, leaves, free, .. } = self.sets;
        let set = |next: Next| (all >> (next as usize * SLOTS)) as u32 & (u32::MAX >> (32 - SLOTS));
        self.sets.nodes = nodes | set(Next::Node);
        self.sets.leaves = leaves | set(Next::Leaf);
        self.sets.next = set(Next::Again);
        self.sets.free = free | set(Next::Nothing);
    }
}
