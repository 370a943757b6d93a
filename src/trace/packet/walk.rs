//! The way of a packet through a grid, and through those that its voxels point to.

use super::lines::{Exit, Lines, Rect};
use super::look::List;
use super::{Packet, Part, TOO_MUCH};
use crate::arena::layout::{EMPTY, LIST, PAYLOAD, TAG_SHIFT};
use crate::simd::{Kernel, Lanes};
use crate::trace::query::Query;

/// [`Packet::grid`], compiled for the packet's instruction set.
struct Enter<'w, 'a, 't, Q, L> {
    packet: &'w mut Packet<'a, 't, Q, L>,
    number: u32,
    part: Part,
    from: f64,
}

impl<Q: Query, L: Lanes> Kernel<L> for Enter<'_, '_, '_, Q, L> {
    type Out = ();
    #[inline(always)]
    fn run(self, _: L) {
        self.packet.grid(self.number, self.part, self.from);
    }
}

impl<Q: Query, L: Lanes> Packet<'_, '_, Q, L> {
    /// [`Packet::grid`], which is not inlined, as it comes back to itself.
    #[inline(never)]
    pub(super) fn grid_apart(&mut self, number: u32, part: Part, from: f64) {
        let lanes = self.lanes;
        lanes.run(Enter { packet: self, number, part, from });
    }

    /// Takes a part of the packet through a grid, from a distance on.
    #[inline(always)]
    fn grid(&mut self, number: u32, part: Part, from: f64) {
        let mut end = self.end(part);
        if end < from || self.lost {
            return;
        }
        let grid = self.sections.grid(number);
        let Some(lines) = Lines::new(self, grid, part, from) else {
            self.lost = true;
            return;
        };
        self.work += 10;
        let mut z = lines.first_slab();
        let start = from * lines.scale;
        while z < lines.n[2] {
            let slab = f64::from(z) - lines.at[2];
            // A part begins where a slab does, and so would be in the one before again.
            if slab + 1.0 <= start {
                z += 1;
                continue;
            }
            let near = if slab > start { slab } else { start };
            let range = [near, slab + 1.0];
            if near > lines.range[1] || near > end * lines.scale {
                return;
            }
            self.work = self.work.saturating_add(1);
            let Some(rect) = lines.voxels(range) else {
                z += 1;
                continue;
            };
            self.work = self.work.saturating_add(3 + rect.count() as u32);
            self.lost |= self.work > TOO_MUCH;
            if self.lost {
                return;
            }
            if rect.count() > part.count as i32 / 4 + 3 && part.count > 1 {
                for half in part.halves() {
                    self.grid_apart(number, half, near / lines.scale);
                }
                return;
            }
            let at = [rect.x[0], rect.y[0]];
            let (word, mut list) = self.voxel(&lines, [at[0], at[1], z], range);
            let exit = Exit::new(self.axes, self.down, at, list.exit);
            let slabs = exit.slabs(&lines, range, &rect);
            if slabs > 0 && word >> TAG_SHIFT <= LIST {
                if word >> TAG_SHIFT == LIST {
                    list.range[1] += f64::from(slabs - 1);
                    self.look(&lines, part, &list);
                }
                z += slabs;
            } else {
                self.fetch(&lines, &rect, z);
                for y in rect.y[0]..=rect.y[1] {
                    for x in rect.x[0]..=rect.x[1] {
                        let (word, list) = self.voxel(&lines, [x, y, z], range);
                        match word >> TAG_SHIFT {
                            EMPTY => {}
                            LIST => self.look(&lines, part, &list),
                            _ => {
                                self.meet_apart(part, &lines);
                                self.grid_apart(word & PAYLOAD, part, near / lines.scale);
                                self.nearer = true;
                            }
                        }
                    }
                }
                z += 1;
            }
            if z < lines.n[2] {
                let next = f64::from(z) - lines.at[2];
                if let Some(rect) = lines.voxels([next, next + 1.0]) {
                    for y in rect.y[0]..=rect.y[1] {
                        let number = lines.number([rect.x[0], y, z]);
                        self.sections.fetch_voxel(self.lanes, number);
                    }
                }
            }
            self.meet_apart(part, &lines);
            if core::mem::take(&mut self.nearer) {
                end = self.end(part);
            }
        }
    }

    /// Fetches what voxels of a slab have.
    #[inline(always)]
    fn fetch(&self, lines: &Lines, rect: &Rect<i32>, z: i32) {
        for y in rect.y[0]..=rect.y[1] {
            for x in rect.x[0]..=rect.x[1] {
                let word = self.sections.voxel(lines.number([x, y, z]) as usize);
                if word >> TAG_SHIFT == LIST {
                    self.sections.fetch_list(self.lanes, word & PAYLOAD);
                } else if word >> TAG_SHIFT != EMPTY {
                    self.sections.fetch_grid(self.lanes, word & PAYLOAD);
                }
            }
        }
    }

    /// A voxel's word, and its list if it has one.
    #[inline(always)]
    fn voxel(&self, lines: &Lines, at: [i32; 3], range: [f64; 2]) -> (u32, List) {
        let word = self.sections.voxel(lines.number(at) as usize);
        let place = word & PAYLOAD;
        let (exit, len) = match word >> TAG_SHIFT {
            EMPTY => (word, 0),
            LIST => self.sections.head(place),
            _ => (0, 0),
        };
        (word, List { at, place, exit, len, range })
    }
}
