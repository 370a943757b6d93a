//! The bucket sort that puts objects into the voxels of a grid: note which voxels each
//! object meets and count the objects of each voxel, turn counts into positions, put the
//! objects there.

use super::control::Control;
use super::draft::{Crowded, Span};
use super::footprint::Near;
use super::frame::Grid;
use super::overlap::{Range, voxels};
use super::turn::{Turn, place};
use crate::Error;
use crate::arena::layout::{GRID_BIT, Triangle};

/// Ends a chain of objects.
const NONE: u32 = u32::MAX;

/// A grid while it is filled.
pub struct Buckets<'a> {
    pub grids: &'a mut [Grid],
    /// Of all grids, or none.
    pub turns: &'a [Turn],
    pub number: usize,
    /// Free memory for voxels, then the grid's, and the number of the first.
    pub spans: &'a mut [Span],
    pub first_span: usize,
    /// Free memory for references, and the number of the first.
    pub refs: &'a mut [u32],
    pub first_ref: usize,
    /// For each object the number of voxels that it meets, then these, ascending.
    pub stream: &'a mut [u32],
}

impl<'a> Buckets<'a> {
    /// Notes which voxels objects meet, and how many there are for each voxel. `starts`:
    /// where each object's part of the stream begins, of as many as there is room for.
    pub fn find(
        &mut self,
        objects: &[u32],
        triangle: impl Fn(u32) -> Triangle,
        starts: &mut [u32],
        (max_refs, crowded): (u32, Crowded),
        control: &mut Control<'_>,
    ) -> Result<(), Error> {
        let budget = objects.len().saturating_mul(max_refs as usize);
        // Objects whose boxes fill the grid cost time even where they leave no
        // references.
        let work = if crowded == Crowded::Fail { usize::MAX } else { budget.saturating_mul(4) };
        loop {
            self.grids[self.number].first = self.first_span as u32;
            let grid = self.grids[self.number];
            let near = Near::new(&grid);
            let spans = self.spans.get_mut(..grid.voxels() as usize).ok_or(Error::Limit)?;
            spans.fill(Span { start: NONE, count: 0 });
            control.count(spans.len());
            let stream = &mut *self.stream;
            let (mut end, mut rows, mut seen) = (0, 0, 0);
            for &object in objects {
                let head = end;
                end += 1;
                let mut visit = |voxel: usize| {
                    spans[voxel].count += 1;
                    // Beyond the end the grid is over its budget.
                    if let Some(entry) = stream.get_mut(end) {
                        *entry = voxel as u32;
                    }
                    end += 1;
                };
                let looked_at = if object & GRID_BIT == 0 {
                    voxels(&triangle(object), &grid, near.as_ref(), visit)
                } else {
                    let [lo, hi] = place(self.grids, self.turns, (object & !GRID_BIT) as usize);
                    Range::of(&grid, lo, hi).map_or(1, |range| {
                        range.each(&grid, &mut visit);
                        range.rows()
                    })
                };
                rows += looked_at;
                if let Some(start) = starts.get_mut(seen) {
                    *start = head as u32;
                }
                if let Some(entry) = stream.get_mut(head) {
                    *entry = (end - head - 1) as u32;
                }
                seen += 1;
                control.tick(end - head + looked_at, seen, objects.len())?;
                if end > budget + seen || rows > work {
                    break;
                }
            }
            if end - seen <= budget && rows <= work {
                self.spans = &mut core::mem::take(&mut self.spans)[..grid.voxels() as usize];
                return if end > self.stream.len() { Err(Error::Limit) } else { Ok(()) };
            }
            if crowded == Crowded::Fail || grid.n == [1; 3] {
                return Err(Error::Limit);
            }
            // Half the counts leave a flat object a quarter of its references.
            let mut excess = objects.len() / seen;
            let coarse = &mut self.grids[self.number];
            *coarse = grid.coarser();
            while excess >= 4 && coarse.n != [1; 3] {
                *coarse = coarse.coarser();
                excess /= 4;
            }
        }
    }

    /// Orders objects by the lowest voxel that they meet; those of one keep their order.
    pub fn order(&mut self, starts: &[u32], next: &mut [u32], order: &mut [u32]) {
        for (i, &start) in starts.iter().enumerate().rev() {
            // One that meets none, which there is not, would go with the first.
            let [count, voxel] = [0, 1].map(|k| self.stream.get(start as usize + k).copied());
            let lowest = count.and(voxel).filter(|_| count != Some(0)).unwrap_or(0);
            let first = &mut self.spans[lowest as usize].start;
            next[i] = core::mem::replace(first, i as u32);
        }
        let mut order = order.iter_mut();
        for span in &*self.spans {
            let mut i = span.start;
            while i != NONE {
                if let Some(order) = order.next() {
                    *order = i;
                }
                i = next[i as usize];
            }
        }
    }

    /// Makes room for the references; returns how many there are.
    pub fn open(&mut self) -> Result<usize, Error> {
        let mut start = 0;
        for span in self.spans.iter_mut() {
            span.start = start;
            start += span.count;
        }
        let total = start as usize;
        self.refs = core::mem::take(&mut self.refs).get_mut(..total).ok_or(Error::Limit)?;
        Ok(total)
    }

    /// Puts an object into its voxels, which the stream has at `start`; returns where it
    /// has the next object's.
    #[inline(always)]
    pub fn put(&mut self, object: u32, start: u32) -> u32 {
        let start = start as usize;
        let end = start + 1 + self.stream[start] as usize;
        for &voxel in &self.stream[start + 1..end] {
            let span = &mut self.spans[voxel as usize];
            self.refs[span.start as usize] = object;
            span.start += 1;
        }
        end as u32
    }

    /// Finishes the lists; returns the number of voxels.
    pub fn close(self) -> usize {
        for span in self.spans.iter_mut() {
            span.start = self.first_ref as u32 + span.start - span.count;
        }
        self.spans.len()
    }
}
