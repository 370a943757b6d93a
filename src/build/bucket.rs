//! The bucket sort that puts objects into the voxels of a grid: note which voxels each
//! object meets and count the objects of each voxel, turn counts into positions, put the
//! objects there.

mod tasks;

use super::draft::{Crowded, Span};
use super::footprint::Near;
use super::frame::Grid;
use super::overlap::{Range, voxels};
use super::turn::{Turn, place};
use crate::Error;
use crate::arena::layout::{GRID_BIT, Triangle};

pub use tasks::find_in_tasks;

/// A voxel that no object was found for yet.
pub const EMPTY: Span = Span { start: 0, count: 0 };

/// What finding writes to.
pub struct Notes<'a> {
    /// Of the grid's voxels and perhaps more.
    pub spans: &'a mut [Span],
    /// For each object the number of voxels that it meets, then these, ascending.
    pub stream: &'a mut [u32],
    /// Where each object's part of the stream begins, of as many as there is room for.
    pub starts: &'a mut [u32],
}

impl Notes<'_> {
    /// The same, for another user.
    pub fn again(&mut self) -> Notes<'_> {
        Notes { spans: self.spans, stream: self.stream, starts: self.starts }
    }
}

/// What objects are: triangles and, marked, grids.
#[derive(Clone, Copy)]
pub struct Shapes<'a> {
    pub soup: &'a [Triangle],
    /// Triangles' numbers are places in this order of the soup, or in the soup.
    pub order: Option<&'a [u32]>,
    /// How the grid is turned that they are put into.
    pub turn: Option<&'a Turn>,
    pub grids: &'a [Grid],
    pub turns: &'a [Turn],
}

impl Shapes<'_> {
    #[inline(always)]
    fn triangle(&self, object: u32) -> Triangle {
        let number = self.order.map_or(object, |order| order[object as usize]);
        let triangle = &self.soup[number as usize];
        self.turn.map_or(*triangle, |turn| turn.local(triangle))
    }
}

/// Objects, as a grid sees them.
pub struct Finder<'a> {
    grid: &'a Grid,
    near: Option<Near>,
    shapes: Shapes<'a>,
}

impl<'a> Finder<'a> {
    pub fn new(grid: &'a Grid, shapes: Shapes<'a>) -> Self {
        Self { grid, near: Near::new(grid), shapes }
    }

    /// Notes at the start of `stream`, as far as there is room, how many voxels an object
    /// meets, and these, ascending. Returns their number, and how many rows of voxels were
    /// looked at. Not inlined: there would be a copy for each who asks.
    #[inline(never)]
    pub fn note(&self, object: u32, stream: &mut [u32]) -> [usize; 2] {
        let mut none = 0;
        let (head, list) = stream.split_first_mut().unwrap_or((&mut none, &mut []));
        let noted = if object & GRID_BIT == 0 {
            voxels(&self.shapes.triangle(object), self.grid, self.near.as_ref(), list)
        } else {
            let Shapes { grids, turns, .. } = self.shapes;
            let [lo, hi] = place(grids, turns, (object & !GRID_BIT) as usize);
            Range::of(self.grid, lo, hi).map_or([0, 1], |range| {
                let mut list = list.iter_mut();
                range.each(self.grid, |voxel| {
                    if let Some(entry) = list.next() {
                        *entry = voxel as u32;
                    }
                });
                [range.voxels(), range.rows()]
            })
        };
        *head = noted[0] as u32;
        noted
    }
}

/// Notes which voxels of `grid` objects meet, and how many there are for each voxel. The
/// grid is made coarser where it would have too many references. `tick` is told of work, and of how
/// many objects were looked at.
///
/// # Errors
/// [`Error::Limit`] if `notes` have too little room; those of `tick`.
pub fn find(
    grid: &mut Grid,
    objects: &[u32],
    shapes: Shapes<'_>,
    Notes { spans, stream, starts }: Notes<'_>,
    (max_refs, crowded): (u32, Crowded),
    mut tick: impl FnMut(usize, usize) -> Result<(), Error>,
) -> Result<(), Error> {
    let budget = objects.len().saturating_mul(max_refs as usize);
    // Objects whose boxes fill the grid cost time even where they leave no
    // references.
    let work = if crowded == Crowded::Fail { usize::MAX } else { budget.saturating_mul(4) };
    loop {
        let finder = Finder::new(grid, shapes);
        let spans = spans.get_mut(..grid.voxels() as usize).ok_or(Error::Limit)?;
        spans.fill(EMPTY);
        tick(spans.len(), 0)?;
        let (mut end, mut rows, mut seen) = (0, 0, 0);
        for &object in objects {
            let free = stream.get_mut(end..).unwrap_or_default();
            let [count, looked_at] = finder.note(object, free);
            for &voxel in free.iter().skip(1).take(count) {
                spans[voxel as usize].count += 1;
            }
            if let Some(start) = starts.get_mut(seen) {
                *start = end as u32;
            }
            end += 1 + count;
            rows += looked_at;
            seen += 1;
            tick(1 + count + looked_at, seen)?;
            if end > budget + seen || rows > work {
                break;
            }
        }
        if end - seen <= budget && rows <= work {
            return if end > stream.len() { Err(Error::Limit) } else { Ok(()) };
        }
        if crowded == Crowded::Fail || grid.n == [1; 3] {
            return Err(Error::Limit);
        }
        // Half the counts leave a flat object a quarter of its references.
        let mut excess = objects.len() / seen;
        *grid = grid.coarser();
        while excess >= 4 && grid.n != [1; 3] {
            *grid = grid.coarser();
            excess /= 4;
        }
    }
}

/// Orders objects by the lowest voxel that they meet; those of one keep their order.
/// `lowest` is room for a word for each.
pub fn order(notes: Notes<'_>, lowest: &mut [u32], order: &mut [u32]) {
    let Notes { spans, stream, starts } = notes;
    for (lowest, &start) in lowest.iter_mut().zip(&*starts) {
        // One that meets none, which there is not, would go with the first.
        let [count, voxel] = [0, 1].map(|k| stream.get(start as usize + k).copied());
        *lowest = count.and(voxel).filter(|_| count != Some(0)).unwrap_or(0);
        spans[*lowest as usize].start += 1;
    }
    let mut next = 0;
    for span in spans.iter_mut() {
        next += core::mem::replace(&mut span.start, next);
    }
    for (i, &lowest) in (0..).zip(&*lowest) {
        let at = &mut spans[lowest as usize].start;
        order[*at as usize] = i;
        *at += 1;
    }
}

/// References that were counted.
pub fn total(spans: &[Span]) -> usize {
    spans.iter().map(|span| span.count as usize).sum()
}

/// Lists while they are filled.
pub struct Lists<'a> {
    spans: &'a mut [Span],
    refs: &'a mut [u32],
    first_ref: usize,
    stream: &'a [u32],
}

impl<'a> Lists<'a> {
    /// Those of a grid, whose references, of which `refs` begins with number `first_ref`,
    /// were counted in `spans` and are in `stream`.
    pub fn open(
        spans: &'a mut [Span],
        refs: &'a mut [u32],
        first_ref: usize,
        stream: &'a [u32],
    ) -> Self {
        let mut start = 0;
        for span in spans.iter_mut() {
            span.start = start;
            start += span.count;
        }
        Self { spans, refs, first_ref, stream }
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

    /// Finishes them.
    pub fn close(self) {
        for span in self.spans.iter_mut() {
            span.start = self.first_ref as u32 + span.start - span.count;
        }
    }
}
