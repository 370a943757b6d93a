//! What has stopped rays lately: the first that a ray for any hit is held against.
//!
//! Rays that come one after the other, to the same lights from neighbouring points, are often
//! stopped by the same triangles; sieving eight of these costs a tenth of a walk. Where that
//! stops few rays, it is left for a while, then tried again. Kept are the last ones that have
//! stopped a ray on its walk, in whatever order.

use crate::ray::NONE;

/// Triangles that are kept, and sieved together.
const KEPT: usize = 8;
/// Rays after which it is decided whether to go on, and how many of them have to be stopped.
const TRIAL: u32 = 64;
const WORTH: u32 = 12;
/// Rays that are spared after a trial in vain, at first; then twice as many each time, up to
/// so many.
const SPARED: u32 = 256;
const MOST: u32 = 4096;

/// Triangles by number, and how many rays they have stopped.
#[derive(Clone, Copy)]
pub(super) struct Recent {
    numbers: [u32; KEPT],
    len: usize,
    next: usize,
    /// Rays still to be held against them in this trial, those that were stopped, and those
    /// to be spared before the next.
    left: u32,
    stopped: u32,
    spared: u32,
    spare: u32,
}

impl Recent {
    pub const NONE: Self = Self {
        numbers: [NONE; KEPT],
        len: 0,
        next: 0,
        left: TRIAL,
        stopped: 0,
        spared: 0,
        spare: SPARED,
    };

    /// The triangles, and how many of them the next ray is to be held against.
    #[inline(always)]
    pub fn next(&mut self) -> ([u32; KEPT], usize) {
        if self.left == 0 {
            self.judge();
        }
        if self.spared > 0 {
            self.spared -= 1;
            return (self.numbers, 0);
        }
        // Before there are any, nothing is tried.
        self.left -= u32::from(self.len > 0);
        (self.numbers, self.len)
    }

    /// Begins another trial, or puts it off.
    #[cold]
    fn judge(&mut self) {
        if self.stopped < WORTH {
            self.spared = self.spare;
            self.spare = MOST.min(2 * self.spare);
        } else {
            self.spare = SPARED;
        }
        (self.left, self.stopped) = (TRIAL, 0);
    }

    /// One of them has stopped that ray.
    #[inline(always)]
    pub fn stopped(&mut self) {
        self.stopped += 1;
    }

    /// Keeps a triangle that has stopped a ray on its walk.
    #[inline(always)]
    pub fn keep(&mut self, number: u32) {
        // While rays are spared nothing is kept until the next trial is near, as it is they who
        // would pay for it.
        if self.spared > TRIAL || self.numbers.contains(&number) {
            return;
        }
        self.numbers[self.next] = number;
        self.next = (self.next + 1) % KEPT;
        self.len = KEPT.min(self.len + 1);
    }
}

#[cfg(test)]
mod tests {
    use super::{KEPT, MOST, Recent, TRIAL, WORTH};

    /// Of so many rays, those held against triangles, if every `each`th is stopped.
    fn held(recent: &mut Recent, rays: u32, each: u32) -> u32 {
        (0..rays).fold(0, |held, ray| {
            let tried = recent.next().1 > 0;
            if tried && ray % each == 0 {
                recent.stopped();
            }
            held + u32::from(tried)
        })
    }

    #[test]
    fn keeps_the_last_ones_once() {
        let mut recent = Recent::NONE;
        for number in [5, 5, 6, 5, 7, 8, 9, 10, 11, 12, 13] {
            recent.keep(number);
        }
        let (mut numbers, len) = recent.next();
        numbers.sort_unstable();
        assert_eq!((numbers, len), ([6, 7, 8, 9, 10, 11, 12, 13], KEPT));
    }

    #[test]
    fn rests_where_it_is_in_vain() {
        let mut recent = Recent::NONE;
        assert_eq!(held(&mut recent, 10 * TRIAL, 1), 0, "there is nothing yet");
        (0..KEPT as u32).for_each(|number| recent.keep(number));
        assert!(held(&mut recent, 100 * MOST, 2 * TRIAL / WORTH) < 3 * 100 * TRIAL);
        let rays = 1000 * TRIAL;
        assert!(held(&mut recent, rays, TRIAL / WORTH / 2) > rays - MOST - TRIAL);
    }
}
