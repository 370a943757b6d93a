//! What the rays in flight wait for.

/// Rays in flight.
pub(super) const SLOTS: usize = 32;

/// What a slot's ray needs next; the order is that of [`super::Stream::round`].
#[derive(Clone, Copy)]
#[repr(u8)]
pub(super) enum Phase {
    /// To enter a grid.
    Enter,
    /// To read its voxel.
    Visit,
    /// To read the head of its voxel's list.
    Open,
    /// To sieve the next triangles of the list.
    Sieve,
    /// To decide a triangle that the sieve let through.
    Decide,
    /// To go down to a grid of the list.
    Descend,
    /// To leave its voxel's exit box.
    Advance,
    /// To go on in the grid above.
    Return,
    /// Nothing: its answer is known.
    Done,
}

/// Number of phases.
const PHASES: usize = Phase::Done as usize + 1;

/// Numbers of slots.
#[derive(Clone, Copy)]
pub(super) struct Queue {
    slots: [u8; SLOTS],
    len: usize,
}

impl Queue {
    const EMPTY: Self = Self { slots: [0; SLOTS], len: 0 };

    #[inline(always)]
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        // The remainder spares a test where slots are looked up.
        self.slots[..self.len.min(SLOTS)].iter().map(|&slot| usize::from(slot) % SLOTS)
    }
}

/// A queue for each phase. Each slot is in one at most.
pub(super) struct Queues([Queue; PHASES]);

impl Queues {
    pub const EMPTY: Self = Self([Queue::EMPTY; PHASES]);

    /// Where a slot goes is computed, not branched to: what rays do next cannot be
    /// predicted.
    #[inline(always)]
    pub fn push(&mut self, phase: Phase, slot: usize) {
        let queue = &mut self.0[phase as usize];
        queue.slots[queue.len % SLOTS] = slot as u8;
        queue.len += 1;
    }

    /// Empties a queue, and gives what was in it.
    #[inline(always)]
    pub fn take(&mut self, phase: Phase) -> Queue {
        let queue = &mut self.0[phase as usize];
        let taken = *queue;
        queue.len = 0;
        taken
    }
}
