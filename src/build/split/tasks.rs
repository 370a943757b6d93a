//! The tasks of a batch: finding what new grids refer to, and filling these.

use crate::Error;
use crate::build::bucket::{Lists, Notes, Shapes, find, find_in_tasks, total};
use crate::build::control::Control;
use crate::build::draft::{Crowded, Span};
use crate::build::frame::Grid;
use crate::build::gather::Soup;
use crate::build::scratch::cut;
use crate::simd::fetch;

/// Triangles of a list that are fetched before they are looked at: some 64 kB of them.
const SOON: usize = 1024;

/// A voxel that is to become a grid.
#[derive(Clone, Copy, Default)]
pub struct Split {
    pub voxel: u32,
    /// Where its piece of the stream begins, and the size of that.
    pub start: u32,
    pub words: u32,
    /// Voxels of the grid, at first those that it was meant to have.
    pub voxels: u32,
    /// References of the grid.
    pub refs: u32,
    /// Whether some voxel of the grid still holds all objects.
    pub together: bool,
    pub work: u64,
}

/// What tasks read.
pub struct Input<'a> {
    pub soup: &'a Soup<'a>,
    pub order: &'a [u32],
    pub spans: &'a [Span],
    pub refs: &'a [u32],
    pub max_refs: u32,
}

impl Input<'_> {
    fn shapes(&self) -> Shapes<'_> {
        let (soup, order) = (self.soup.triangles, Some(self.order));
        Shapes { soup, order, turn: None, grids: &[], turns: &[] }
    }

    fn list(&self, split: &Split) -> &[u32] {
        let Span { start, count } = self.spans[split.voxel as usize];
        &self.refs[start as usize..][..count as usize]
    }
}

/// Some splits of a batch, their grids, and free memory for these.
pub struct Finding<'a> {
    pub splits: &'a mut [Split],
    pub grids: &'a mut [Grid],
    pub spans: &'a mut [Span],
    pub stream: &'a mut [u32],
}

/// The same, once it is known what they refer to.
pub struct Filling<'a> {
    pub splits: &'a [Split],
    pub spans: &'a mut [Span],
    pub refs: &'a mut [u32],
    pub first_ref: usize,
}

/// How many splits, from the first on, it takes for `share` of something.
pub fn take(splits: &[Split], share: usize, of: impl Fn(&Split) -> u32) -> usize {
    let mut sum = 0;
    let short = |split: &&Split| {
        let short = sum < share;
        sum += of(split) as usize;
        short
    };
    splits.iter().take_while(short).count()
}

/// Sums of two things of splits.
pub fn sums(splits: &[Split], of: impl Fn(&Split) -> [u32; 2]) -> [usize; 2] {
    splits.iter().fold([0; 2], |[a, b], split| {
        let [x, y] = of(split);
        [a + x as usize, b + y as usize]
    })
}

/// Finds what the only grid of a batch refers to, in tasks of its own. `false` if nothing was found
/// so ([`find_in_tasks`]).
pub fn find_single(
    split: &mut Split,
    grid: &Grid,
    mut notes: Notes<'_>,
    input: &Input<'_>,
    control: &mut Control<'_>,
) -> Result<bool, Error> {
    let objects = input.list(split);
    if !find_in_tasks(grid, objects, input.shapes(), &mut notes, input.max_refs, control)? {
        return Ok(false);
    }
    split.found(&notes.spans[..grid.voxels() as usize], objects.len());
    Ok(true)
}

impl Split {
    /// Sums up what the grid's voxels refer to, of so many objects.
    fn found(&mut self, spans: &[Span], objects: usize) {
        self.refs = total(spans) as u32;
        self.together = spans.iter().any(|span| span.count as usize >= objects);
    }
}

impl Finding<'_> {
    pub fn find(&mut self, input: &Input<'_>) {
        let (mut spans, mut stream) = (&mut *self.spans, &mut *self.stream);
        for (split, grid) in self.splits.iter_mut().zip(&mut *self.grids) {
            let objects = input.list(split);
            let triangle =
                |object: u32| &input.soup.triangles[input.order[object as usize] as usize];
            // They lie about in the soup.
            objects.iter().take(SOON).for_each(|&object| fetch(triangle(object)));
            let spans = cut(&mut spans, split.voxels as usize);
            let stream = cut(&mut stream, split.words as usize);
            let mut work = 0;
            let tick = |more, _| {
                work += more as u64;
                Ok(())
            };
            let notes = Notes { spans, stream, starts: &mut [] };
            // Memory suffices for the budget, and a grid of one voxel is in it.
            let limits = (input.max_refs, Crowded::Coarsen);
            let found = find(grid, objects, input.shapes(), notes, limits, tick);
            debug_assert_eq!(found, Ok(()), "a piece is too small");
            split.found(&spans[..grid.voxels() as usize], objects.len());
            split.work = work;
        }
    }
}

impl Filling<'_> {
    pub fn fill(&mut self, input: &Input<'_>, stream: &[u32]) {
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
