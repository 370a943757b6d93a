//! Voxels that become grids, many at a time, in tasks.
//!
//! A batch is collected, what the voxels' lists refer to is found in the new grids, it is
//! decided which grids are kept, and these are filled. Which voxels are a batch, and what
//! memory each new grid gets, follows from the lists' lengths alone.

use super::bucket::{Lists, Notes, find, total};
use super::control::{Control, TASKS, parts};
use super::draft::{Crowded, Draft, Span};
use super::frame::Grid;
use super::gather::Soup;
use super::scratch::cut;
use crate::Error;

/// Voxels of a batch, at most.
const MOST: usize = 256;
/// Words of the stream that a batch of several voxels takes, at most: 8 megabytes.
const WORDS: usize = 1 << 21;

/// A voxel that is to become a grid.
#[derive(Clone, Copy, Default)]
struct Split {
    voxel: u32,
    /// Where its piece of the stream begins, and the size of that.
    start: u32,
    words: u32,
    /// Voxels of the grid, at first those that it was meant to have.
    voxels: u32,
    /// References of the grid.
    refs: u32,
    /// Whether some voxel of the grid still holds all objects.
    together: bool,
    work: u64,
}

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

/// What tasks read.
struct Input<'a> {
    soup: &'a Soup<'a>,
    order: &'a [u32],
    spans: &'a [Span],
    refs: &'a [u32],
    max_refs: u32,
}

impl Input<'_> {
    fn list(&self, split: &Split) -> &[u32] {
        let Span { start, count } = self.spans[split.voxel as usize];
        &self.refs[start as usize..][..count as usize]
    }
}

/// Some splits of a batch, their grids, and free memory for these.
struct Finding<'a> {
    splits: &'a mut [Split],
    grids: &'a mut [Grid],
    spans: &'a mut [Span],
    stream: &'a mut [u32],
}

/// The same, once it is known what they refer to.
struct Filling<'a> {
    splits: &'a [Split],
    spans: &'a mut [Span],
    refs: &'a mut [u32],
    first_ref: usize,
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

/// How many splits, from the first on, it takes for `share` of something.
fn take(splits: &[Split], share: usize, of: impl Fn(&Split) -> u32) -> usize {
    let mut sum = 0;
    let short = |split: &&Split| {
        let short = sum < share;
        sum += of(split) as usize;
        short
    };
    splits.iter().take_while(short).count()
}

/// Sums of two things of splits.
fn sums(splits: &[Split], of: impl Fn(&Split) -> [u32; 2]) -> [usize; 2] {
    splits.iter().fold([0; 2], |[a, b], split| {
        let [x, y] = of(split);
        [a + x as usize, b + y as usize]
    })
}

impl Finding<'_> {
    fn find(&mut self, input: &Input<'_>) {
        let (mut spans, mut stream) = (&mut *self.spans, &mut *self.stream);
        for (split, grid) in self.splits.iter_mut().zip(&mut *self.grids) {
            let objects = input.list(split);
            let triangle =
                |object: u32| input.soup.triangles[input.order[object as usize] as usize];
            let spans = cut(&mut spans, split.voxels as usize);
            let stream = cut(&mut stream, split.words as usize);
            let mut work = 0;
            let tick = |more, _| {
                work += more as u64;
                Ok(())
            };
            let notes = Notes { spans, stream, starts: &mut [] };
            let shapes = (triangle, |_| [[0.0; 3]; 2]);
            // Memory suffices for the budget, and a grid of one voxel is in it.
            let limits = (input.max_refs, Crowded::Coarsen);
            let found = find(grid, objects, shapes, notes, limits, tick);
            debug_assert_eq!(found, Ok(()), "a piece is too small");
            let spans = &spans[..grid.voxels() as usize];
            split.refs = total(spans) as u32;
            split.together = spans.iter().any(|span| span.count as usize >= objects.len());
            split.work = work;
        }
    }
}

impl Filling<'_> {
    fn fill(&mut self, input: &Input<'_>, stream: &[u32]) {
        let (mut spans, mut refs) = (&mut *self.spans, &mut *self.refs);
        let mut first_ref = self.first_ref;
        for split in self.splits {
            let voxels = cut(&mut spans, split.voxels as usize);
            let refs = cut(&mut refs, split.refs as usize);
            let mut lists = Lists::open(voxels, refs, first_ref, stream);
            let mut start = split.start;
            for &object in input.list(split) {
                start = lists.put(object, start);
            }
            lists.close();
            first_ref += split.refs as usize;
        }
    }
}
