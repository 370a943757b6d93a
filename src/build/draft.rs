//! The structure as it grows: grids, the lists of their voxels, references.
//!
//! `fill` is the pass that every structure shares, a bucket sort: note which voxels each
//! object meets and count the objects of each voxel, turn counts into positions, put the
//! objects there.

use super::capacity::Capacity;
use super::control::Control;
use super::frame::Grid;
use super::gather::Soup;
use super::overlap::{Range, voxels};
use super::scratch::Scratch;
use crate::Error;
use crate::arena::layout::GRID_BIT;
use bytemuck::{Pod, Zeroable};

/// A voxel's list: `count` references from number `start` on.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub struct Span {
    pub start: u32,
    pub count: u32,
}

/// What [`Draft::fill`] does when a grid's references exceed its budget.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Crowded {
    /// Halve the voxel counts.
    Coarsen,
    /// Give up with [`Error::Limit`].
    Fail,
}

/// Grids, voxels and references in scratch memory.
pub struct Draft<'s> {
    pub soup: Soup<'s>,
    grid_memory: &'s mut [Grid],
    span_memory: &'s mut [Span],
    ref_memory: &'s mut [u32],
    /// Room for what the bucket sort finds, see [`sort`].
    stream: &'s mut [u32],
    grids: usize,
    spans: usize,
    refs: usize,
    max_refs: u32,
}

/// Sizes of a draft, to go back to.
#[derive(Clone, Copy)]
pub struct Mark {
    grids: usize,
    spans: usize,
    refs: usize,
}

impl<'s> Draft<'s> {
    pub fn new(
        soup: Soup<'s>,
        capacity: &Capacity,
        max_refs: u32,
        scratch: &mut Scratch<'s>,
    ) -> Result<Self, Error> {
        Ok(Self {
            soup,
            grid_memory: scratch.take(capacity.grids)?,
            span_memory: scratch.take(capacity.voxels)?,
            ref_memory: scratch.take(capacity.refs)?,
            stream: scratch.take(capacity.stream)?,
            grids: 0,
            spans: 0,
            refs: 0,
            max_refs,
        })
    }

    pub fn grids(&self) -> &[Grid] {
        &self.grid_memory[..self.grids]
    }

    pub fn grids_mut(&mut self) -> &mut [Grid] {
        &mut self.grid_memory[..self.grids]
    }

    pub fn spans(&self, grid: &Grid) -> &[Span] {
        &self.span_memory[grid.first as usize..][..grid.voxels() as usize]
    }

    pub fn list(&self, span: Span) -> &[u32] {
        &self.ref_memory[span.start as usize..][..span.count as usize]
    }

    pub fn mark(&self) -> Mark {
        Mark { grids: self.grids, spans: self.spans, refs: self.refs }
    }

    pub fn back_to(&mut self, mark: Mark) {
        (self.grids, self.spans, self.refs) = (mark.grids, mark.spans, mark.refs);
    }

    /// References added since `mark`.
    pub fn refs_since(&self, mark: Mark) -> usize {
        self.refs - mark.refs
    }

    /// Most references there can be.
    pub fn capacity(&self) -> usize {
        self.ref_memory.len()
    }

    /// Adds a grid without voxels; returns its number.
    pub fn push(&mut self, grid: Grid) -> Result<usize, Error> {
        *self.grid_memory.get_mut(self.grids).ok_or(Error::Limit)? = grid;
        self.grids += 1;
        Ok(self.grids - 1)
    }

    /// Sorts `objects` (ascending: triangles, then grids) into the voxels of a
    /// grid. Cost: one overlap test for each reference, plus the voxels.
    ///
    /// # Errors
    /// [`Error::Limit`] if the capacity does not suffice.
    pub fn fill(
        &mut self,
        number: usize,
        objects: &[u32],
        crowded: Crowded,
        control: &mut Control<'_>,
    ) -> Result<(), Error> {
        let (soup, grids) = (&self.soup, &mut self.grid_memory[..self.grids]);
        let spans = &mut self.span_memory[self.spans..];
        let refs = &mut self.ref_memory[self.refs..];
        sort(
            soup,
            grids,
            number,
            objects,
            (spans, self.spans),
            (refs, self.refs),
            self.stream,
            self.max_refs,
            crowded,
            control,
        )
        .map(|(voxels, used)| {
            self.spans += voxels;
            self.refs += used;
        })
    }

    /// [`Draft::fill`] with the list of a voxel, which is then replaced by a
    /// reference to the grid.
    pub fn fill_from(
        &mut self,
        number: usize,
        voxel: usize,
        control: &mut Control<'_>,
    ) -> Result<(), Error> {
        let span = self.span_memory[voxel];
        let (soup, grids) = (&self.soup, &mut self.grid_memory[..self.grids]);
        let spans = &mut self.span_memory[self.spans..];
        let (done, refs) = self.ref_memory.split_at_mut(self.refs);
        let objects = &done[span.start as usize..][..span.count as usize];
        let (voxels, used) = sort(
            soup,
            grids,
            number,
            objects,
            (spans, self.spans),
            (refs, self.refs),
            self.stream,
            self.max_refs,
            Crowded::Coarsen,
            control,
        )?;
        self.spans += voxels;
        self.refs += used;
        Ok(())
    }

    /// Makes the list of a voxel the one reference to grid `number`.
    pub fn replace(&mut self, voxel: usize, number: usize) {
        let span = &mut self.span_memory[voxel];
        span.count = 1;
        self.ref_memory[span.start as usize] = GRID_BIT | number as u32;
    }
}

/// The bucket sort. `spans` and `refs` are free memory with the number of its
/// first record; returns how much of each was used.
#[allow(clippy::too_many_arguments)]
fn sort(
    soup: &Soup<'_>,
    grids: &mut [Grid],
    number: usize,
    objects: &[u32],
    (spans, first_span): (&mut [Span], usize),
    (refs, first_ref): (&mut [u32], usize),
    stream: &mut [u32],
    max_refs: u32,
    crowded: Crowded,
    control: &mut Control<'_>,
) -> Result<(usize, usize), Error> {
    let budget = objects.len().saturating_mul(max_refs as usize);
    // Objects whose boxes fill the grid cost time even where they leave no
    // references.
    let work = if crowded == Crowded::Fail { usize::MAX } else { budget.saturating_mul(4) };
    loop {
        grids[number].first = first_span as u32;
        let grid = grids[number];
        let spans = spans.get_mut(..grid.voxels() as usize).ok_or(Error::Limit)?;
        spans.fill(Span::default());
        let (mut end, mut rows, mut seen) = (0, 0, 0);
        for &object in objects {
            let head = end;
            rows += each(soup, grids, &grid, object, |voxel| {
                spans[voxel].count += 1;
                end += 1;
                // Beyond the end the grid is over its budget.
                if let Some(entry) = stream.get_mut(end) {
                    *entry = voxel as u32;
                }
            });
            if let Some(entry) = stream.get_mut(head) {
                *entry = (end - head) as u32;
            }
            end += 1;
            seen += 1;
            control.tick(end - head, seen, objects.len())?;
            if end > budget + seen || rows > work {
                break;
            }
        }
        let total = end - seen;
        if total > budget || rows > work {
            if crowded == Crowded::Fail || grid.n == [1; 3] {
                return Err(Error::Limit);
            }
            // Half the counts leave a flat object a quarter of its references.
            let mut excess = objects.len() / seen;
            grids[number] = grid.coarser();
            while excess >= 4 && grids[number].n != [1; 3] {
                grids[number] = grids[number].coarser();
                excess /= 4;
            }
            continue;
        }
        if end > stream.len() {
            return Err(Error::Limit);
        }
        let refs = refs.get_mut(..total).ok_or(Error::Limit)?;
        let mut start = 0;
        for span in spans.iter_mut() {
            span.start = start;
            start += span.count;
        }
        let mut rest = &stream[..end];
        for &object in objects {
            let Some((&count, tail)) = rest.split_first() else { break };
            let (voxels, tail) = tail.split_at(count as usize);
            for &voxel in voxels {
                let span = &mut spans[voxel as usize];
                refs[span.start as usize] = object;
                span.start += 1;
            }
            rest = tail;
        }
        for span in spans.iter_mut() {
            span.start = first_ref as u32 + span.start - span.count;
        }
        return Ok((spans.len(), total));
    }
}

/// The voxels of `grid` that an object meets; returns the rows looked at.
#[inline(always)]
fn each(
    soup: &Soup<'_>,
    grids: &[Grid],
    grid: &Grid,
    object: u32,
    visit: impl FnMut(usize),
) -> usize {
    if object & GRID_BIT == 0 {
        let i = object as usize;
        voxels(&soup.triangles[i], &soup.boxes[i], grid, visit)
    } else if let Some(range) = Range::of_grid(grid, &grids[(object & !GRID_BIT) as usize]) {
        range.each(grid, visit);
        range.rows()
    } else {
        1
    }
}
