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
    /// To look at the next boxes of the list.
    Look,
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
struct Queue {
    slots: [u8; SLOTS],
    len: usize,
}

/// A queue for each phase, and another for what comes to it while it is worked off.
/// Each slot is in one of all of them at most.
pub(super) struct Queues {
    queues: [[Queue; PHASES]; 2],
    /// Which of the two of each phase is filled.
    filled: [usize; PHASES],
}

impl Queues {
    pub const EMPTY: Self =
        Self { queues: [[Queue { slots: [0; SLOTS], len: 0 }; PHASES]; 2], filled: [0; PHASES] };

    /// Where a slot goes is computed, not branched to: what rays do next cannot be
    /// predicted.
    #[inline(always)]
    pub fn push(&mut self, phase: Phase, slot: usize) {
        let queue = &mut self.queues[self.filled[phase as usize] % 2][phase as usize];
        queue.slots[queue.len % SLOTS] = slot as u8;
        queue.len += 1;
    }

    /// Begins to work off a phase: how many slots wait for it, numbered from 0.
    #[inline(always)]
    pub fn take(&mut self, phase: Phase) -> usize {
        let filled = &mut self.filled[phase as usize];
        let taken = *filled % 2;
        *filled = 1 - taken;
        core::mem::take(&mut self.queues[taken][phase as usize].len)
    }

    /// Slot number `i` of those taken last.
    #[inline(always)]
    pub fn taken(&self, phase: Phase, i: usize) -> usize {
        let taken = 1 - self.filled[phase as usize] % 2;
        // The remainder spares a test where slots are looked up.
        usize::from(self.queues[taken][phase as usize].slots[i % SLOTS]) % SLOTS
    }
}
