//! Voxels that become grids, many at a time, in tasks.
//!
//! A batch is collected, what the voxels' lists refer to is found in the new grids, it is
//! decided which grids are kept, and these are filled. Which voxels are a batch, and what
//! memory each new grid gets, follows from the lists' lengths alone.

mod tasks;

use super::bucket::Notes;
use super::control::{Control, TASKS, parts};
use super::draft::Draft;
use super::frame::Grid;
use super::scratch::cut;
use crate::Error;
use tasks::{Filling, Finding, Input, Split, find_single, sums, take};

/// Voxels of a batch, at most.
const MOST: usize = 256;
/// Words of the stream that a batch of several voxels takes, at most: 8 megabytes.
const WORDS: usize = 1 << 21;

/// What became of a voxel that was to join a batch.
pub enum Joined {
    Yes,
    /// The batch is full.
    Later,
    /// The memory is, whatever the batch leaves of it.
    Never,
}

/// Voxels to be split. Their grids are the last of the draft, without voxels yet.
pub struct Batch {
    splits: [Split; MOST],
    count: usize,
    words: usize,
    voxels: usize,
    /// References of splits that were undone so far.
    wasted: usize,
}

impl Batch {
    pub fn new() -> Self {
        Self { splits: [Split::default(); MOST], count: 0, words: 0, voxels: 0, wasted: 0 }
    }

    /// Takes a voxel of `objects` references that is to become `grid`.
    pub fn join(&mut self, draft: &mut Draft<'_>, voxel: u32, objects: u32, grid: Grid) -> Joined {
        let words = objects as usize * (draft.max_refs as usize + 1);
        let room = WORDS.min(draft.stream.len());
        if self.count == MOST || self.count > 0 && self.words + words > room {
            return Joined::Later;
        }
        let voxels = grid.voxels() as usize;
        let room = draft.span_memory.len() - draft.spans - self.voxels;
        let fits = voxels <= room && words <= draft.stream.len();
        if !fits || draft.push(grid).is_err() {
            // What others of the batch do not need after all may be enough.
            return if self.count > 0 { Joined::Later } else { Joined::Never };
        }
        let [start, size, count] = [self.words, words, voxels].map(|x| x as u32);
        self.splits[self.count] =
            Split { voxel, start, words: size, voxels: count, ..Split::default() };
        self.count += 1;
        self.words += words;
        self.voxels += voxels;
        Joined::Yes
    }

    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Splits what was collected; the batch is empty then. False if there is no room, or no
    /// patience, for more.
    pub fn split(
        &mut self,
        draft: &mut Draft<'_>,
        control: &mut Control<'_>,
    ) -> Result<bool, Error> {
        let first = draft.grids - self.count;
        self.find(draft, first, control)?;
        let goes_on = self.settle(draft, first);
        self.fill(draft, first, control)?;
        (self.count, self.words, self.voxels) = (0, 0, 0);
        Ok(goes_on)
    }

    /// Notes which voxels of the grids, from number `first` on, their objects meet.
    fn find(
        &mut self,
        draft: &mut Draft<'_>,
        first: usize,
        control: &mut Control<'_>,
    ) -> Result<(), Error> {
        let (done, mut spans) = draft.span_memory.split_at_mut(draft.spans);
        let input = Input {
            soup: &draft.soup,
            order: &draft.order[..draft.numbered],
            spans: done,
            refs: &draft.ref_memory[..draft.refs],
            max_refs: draft.max_refs,
        };
        let mut grids = &mut draft.grid_memory[first..draft.grids];
        let mut splits = &mut self.splits[..self.count];
        let mut stream = &mut *draft.stream;
        // Many triangles in one place would be one task.
        if let ([split], [grid]) = (&mut *splits, &*grids) {
            let notes = Notes { spans, stream, starts: &mut *draft.notes[0] };
            if control.within(|control| find_single(split, grid, notes, &input, control))? {
                return Ok(());
            }
        }
        let share = self.words.div_ceil(TASKS);
        let mut tasks = parts(|| {
            let count = take(splits, share, |split| split.words);
            let [words, voxels] = sums(&splits[..count], |split| [split.words, split.voxels]);
            (count > 0).then(|| Finding {
                splits: cut(&mut splits, count),
                grids: cut(&mut grids, count),
                spans: cut(&mut spans, voxels),
                stream: cut(&mut stream, words),
            })
        });
        control.each(&mut tasks, |task| task.find(&input))?;
        let work: u64 = self.splits[..self.count].iter().map(|split| split.work).sum();
        control.count(work as usize);
        Ok(())
    }

    /// Decides which grids are kept, and moves these together. False if others are not even
    /// looked at.
    fn settle(&mut self, draft: &mut Draft<'_>, first: usize) -> bool {
        let (mut kept, mut source, mut refs) = (0, draft.spans, draft.refs);
        let mut goes_on = true;
        for i in 0..self.count {
            let split = self.splits[i];
            let objects = draft.span_memory[split.voxel as usize].count;
            if refs + split.refs as usize > draft.ref_memory.len() {
                goes_on = false;
            } else if split.together && split.refs >= 2 * objects {
                self.wasted += split.refs as usize;
                goes_on = self.wasted <= draft.ref_memory.len();
            } else {
                let grid = draft.grid_memory[first + i];
                let voxels = grid.voxels() as usize;
                if source != draft.spans {
                    draft.span_memory.copy_within(source..source + voxels, draft.spans);
                }
                draft.grid_memory[first + kept] = Grid { first: draft.spans as u32, ..grid };
                self.splits[kept] = Split { voxels: voxels as u32, ..split };
                kept += 1;
                draft.spans += voxels;
                refs += split.refs as usize;
            }
            if !goes_on {
                break;
            }
            source += split.voxels as usize;
        }
        (self.count, draft.grids) = (kept, first + kept);
        goes_on
    }

    /// Fills the grids, from number `first` on, and puts them into their voxels.
    fn fill(
        &mut self,
        draft: &mut Draft<'_>,
        first: usize,
        control: &Control<'_>,
    ) -> Result<(), Error> {
        let mut splits = &self.splits[..self.count];
        let [total, voxels] = sums(splits, |split| [split.refs, split.voxels]);
        let (done, mut spans) = draft.span_memory[..draft.spans].split_at_mut(draft.spans - voxels);
        let (lists, free) = draft.ref_memory.split_at_mut(draft.refs);
        let mut refs = &mut free[..total];
        let input = Input {
            soup: &draft.soup,
            order: &[],
            spans: done,
            refs: lists,
            max_refs: draft.max_refs,
        };
        // An object at the border of a voxel may be in none of the grid's.
        let share = (total + self.count).div_ceil(TASKS);
        let mut first_ref = draft.refs;
        let mut tasks = parts(|| {
            let (some, rest) = splits.split_at(take(splits, share, |split| split.refs + 1));
            splits = rest;
            let [count, voxels] = sums(some, |split| [split.refs, split.voxels]);
            let (spans, refs) = (cut(&mut spans, voxels), cut(&mut refs, count));
            first_ref += count;
            let filling = Filling { splits: some, spans, refs, first_ref: first_ref - count };
            (!some.is_empty()).then_some(filling)
        });
        let stream = &*draft.stream;
        control.each(&mut tasks, |task| task.fill(&input, stream))?;
        draft.refs += total;
        for (number, split) in (first..).zip(&self.splits[..self.count]) {
            draft.replace(split.voxel, number);
        }
        Ok(())
    }
}
