//! Voxels and lists of the arena, written in parts that can be tasks.
//!
//! A part is a run of small grids or a slab of a large one. Where parts begin
//! follows from the grids alone, and each has voxels, lists and working memory of
//! its own.

use super::bounds::Frame;
use super::control::{Control, TASKS, parts};
use super::draft::{Draft, Span};
use super::exit::{SLAB, masks, plane_len, planes, slab_of};
use super::frame::Grid;
use super::masks::Masks;
use super::scratch::cut;
use crate::Error;
use crate::arena::layout::{
    EMPTY, GRID, GRID_BIT, LIST, LIST_HEAD, REF_WORDS, TAG_SHIFT, Triangle,
};
use crate::simd::fetch;
use core::ops::Range;

/// Voxels from which on a grid is cut into slabs.
const LARGE: u64 = 1 << 13;
/// Voxels of a run of small grids, about.
const RUN: u64 = 1 << 11;

/// How many references ahead triangles are fetched: those of the lists to come, as lists lie
/// in the order of the voxels.
const AHEAD: usize = 16;

/// Words of the references' section that a voxel takes.
pub fn words(draft: &Draft<'_>, span: Span) -> u64 {
    match span.count {
        0 => 0,
        1 if draft.list(span)[0] & GRID_BIT != 0 => 0,
        count => LIST_HEAD as u64 + REF_WORDS as u64 * u64::from(count),
    }
}

/// What the parts read.
struct Input<'a> {
    draft: &'a Draft<'a>,
    /// The triangles of the arena.
    triangles: &'a [Triangle],
}

/// What is not handed out yet of the arena.
struct Free<'a> {
    voxels: &'a mut [u32],
    refs: &'a mut [u32],
    /// Number of the first of these references.
    first: u32,
}

/// Some voxels of the arena and the lists of these.
#[derive(Default)]
struct Output<'a> {
    voxels: &'a mut [u32],
    refs: &'a mut [u32],
    first: u32,
}

impl<'a> Free<'a> {
    /// Cuts off what the next spans of the draft take.
    fn take<'d>(
        &mut self,
        draft: &Draft<'_>,
        spans: impl Iterator<Item = &'d [Span]>,
    ) -> Output<'a> {
        let (mut voxels, mut refs) = (0, 0);
        for spans in spans {
            voxels += spans.len();
            refs += spans.iter().map(|&s| words(draft, s)).sum::<u64>() as usize;
        }
        let first = self.first;
        self.first += refs as u32;
        Output { voxels: cut(&mut self.voxels, voxels), refs: cut(&mut self.refs, refs), first }
    }
}

fn sides(grid: &Grid) -> [usize; 3] {
    grid.n.map(|n| n as usize)
}

/// Words of memory for a grid's exit boxes; 0 where there are to be none, as the
/// whole `table` is too small.
fn memory_len(grid: &Grid, table: usize) -> usize {
    let n = sides(grid);
    let words = Masks::size(n).min(table.saturating_sub(plane_len(n)));
    if words < Masks::least(n) { 0 } else { words + plane_len(n) }
}

/// Writes all voxels and lists. `triangles`: those of the arena; `table`: memory for exit
/// boxes; a grid that needs more of it goes without.
pub fn write(
    draft: &Draft<'_>,
    triangles: &[Triangle],
    table: &mut [u64],
    (voxels, refs): (&mut [u32], &mut [u32]),
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let total = voxels.len();
    let input = &Input { draft, triangles };
    let mut free = Free { voxels, refs, first: 0 };
    let (mut number, mut written) = (0, 0);
    while let Some(grid) = draft.grids().get(number) {
        if grid.voxels() < LARGE {
            number = runs(input, number, table, &mut free, control)?;
        } else {
            slabs(input, number, table, &mut free, control)?;
            number += 1;
        }
        let words = (total - free.voxels.len()) + free.first as usize;
        control.count(words - core::mem::replace(&mut written, words));
        control.at(total - free.voxels.len(), total)?;
    }
    Ok(())
}

/// Small grids, one after the other.
struct Run<'a> {
    grids: Range<usize>,
    memory: &'a mut [u64],
    output: Output<'a>,
}

/// Writes some of the small grids from number `next` on; returns the number of the one
/// behind them.
fn runs(
    input: &Input<'_>,
    mut next: usize,
    table: &mut [u64],
    free: &mut Free<'_>,
    control: &Control<'_>,
) -> Result<usize, Error> {
    let draft = input.draft;
    let size = table.len();
    let mut memory = table;
    let mut runs = parts(|| {
        let (count, words) = run_len(&draft.grids()[next..], size, memory.len());
        if count == 0 {
            return None;
        }
        let grids = next..next + count;
        next = grids.end;
        let run = draft.grids()[grids.clone()].iter();
        let output = free.take(draft, run.map(|grid| draft.spans(grid)));
        Some(Run { grids, memory: cut(&mut memory, words), output })
    });
    control.each(&mut runs, |run| {
        let mut at = 0;
        for grid in &draft.grids()[run.grids.clone()] {
            let spans = draft.spans(grid);
            let words = &mut run.output.voxels[at..at + spans.len()];
            at += spans.len();
            let len = memory_len(grid, size);
            if len == 0 {
                words.fill(0);
            } else {
                let (plane, rest) = run.memory[..len].split_at_mut(plane_len(sides(grid)));
                let masks = masks(grid, draft, rest);
                planes(grid, draft, &masks, (0, SLAB), plane, words);
            }
        }
        for number in run.grids.clone() {
            run.output.write(input, number, 0, draft.spans(&draft.grids()[number]));
        }
    })?;
    Ok(next)
}

/// How many small grids a run takes, and the words of memory that the largest of
/// them needs: none if `left` of the table's `size` words are too few.
fn run_len(grids: &[Grid], size: usize, left: usize) -> (usize, usize) {
    let (mut count, mut voxels, mut most) = (0, 0, 0);
    for grid in grids.iter().take_while(|grid| grid.voxels() < LARGE) {
        let words = memory_len(grid, size);
        if voxels >= RUN || words > left {
            break;
        }
        (count, voxels, most) = (count + 1, voxels + grid.voxels(), most.max(words));
    }
    (count, most)
}

/// Some planes of a large grid.
struct Slab<'a> {
    first: usize,
    spans: &'a [Span],
    memory: &'a mut [u64],
    output: Output<'a>,
}

/// Writes a large grid.
fn slabs(
    input: &Input<'_>,
    number: usize,
    table: &mut [u64],
    free: &mut Free<'_>,
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let draft = input.draft;
    let grid = &draft.grids()[number];
    let n = sides(grid);
    let exits = memory_len(grid, table.len()) > 0;
    let (memory, masks) = if exits {
        // A quarter at most is kept for the tasks' planes.
        let planes = (TASKS * plane_len(n)).min(table.len() / 4).max(plane_len(n));
        let most = Masks::size(n).min(table.len() - planes).max(Masks::least(n));
        let (head, rest) = table.split_at_mut(most);
        (rest, Some(masks(grid, draft, head)))
    } else {
        (&mut table[..0], None)
    };
    let plane = if exits { plane_len(n) } else { 0 };
    let most = memory.len().checked_div(plane).map_or(TASKS, |fit| fit.min(TASKS));
    let height = slab_of(n);
    let mut slabs = draft.spans(grid).chunks(height * n[0] * n[1]).enumerate();
    let total = n[2].div_ceil(height);
    while slabs.len() > 0 {
        let mut memory = &mut *memory;
        let mut next = slabs.by_ref().take(most);
        let mut tasks = parts(|| {
            let (slab, spans) = next.next()?;
            let output = free.take(draft, core::iter::once(spans));
            Some(Slab { first: slab * height, spans, memory: cut(&mut memory, plane), output })
        });
        control.each(&mut tasks, |slab| {
            match &masks {
                Some(masks) => {
                    let words = &mut *slab.output.voxels;
                    planes(grid, draft, masks, (slab.first, height), slab.memory, words);
                }
                None => slab.output.voxels.fill(0),
            }
            slab.output.write(input, number, slab.first, slab.spans);
        })?;
        control.at(total - slabs.len(), total)?;
    }
    Ok(())
}

impl Output<'_> {
    /// Writes the next voxels: whole planes of grid `number`, from number `plane` on. Their
    /// words hold exit boxes.
    fn write(&mut self, input: &Input<'_>, number: usize, plane: usize, spans: &[Span]) {
        let (grid, turn) = (&input.draft.grids()[number], input.draft.turn(number));
        let [nx, ny, _] = sides(grid);
        let words = cut(&mut self.voxels, spans.len());
        for (i, (word, &span)) in words.iter_mut().zip(spans).enumerate() {
            *word = match input.draft.list(span) {
                [] => EMPTY << TAG_SHIFT | *word,
                [only] if only & GRID_BIT != 0 => GRID << TAG_SHIFT | (only & !GRID_BIT),
                list => {
                    let at = [i % nx, i / nx % ny, plane + i / (nx * ny)];
                    let place = LIST << TAG_SHIFT | self.first;
                    let words = LIST_HEAD + REF_WORDS * list.len();
                    self.first += words as u32;
                    let (head, rest) = cut(&mut self.refs, words).split_at_mut(LIST_HEAD);
                    head.copy_from_slice(&[*word, span.count]);
                    let (refs, boxes) = rest.split_at_mut(list.len());
                    refs.copy_from_slice(list);
                    let frame = Frame::new(grid, at, *word);
                    let ahead = input.draft.refs_from(span.start as usize + AHEAD);
                    for (j, (to, &reference)) in boxes.iter_mut().zip(&*refs).enumerate() {
                        if let Some(triangle) =
                            ahead.get(j).and_then(|&r| input.triangles.get(r as usize))
                        {
                            fetch(triangle);
                        }
                        *to = if reference & GRID_BIT != 0 {
                            let [lo, hi] = input.draft.place((reference & !GRID_BIT) as usize);
                            frame.word(lo, hi)
                        } else {
                            let triangle = &input.triangles[reference as usize];
                            match turn {
                                None => frame.of_triangle(triangle),
                                Some(turn) => frame.of_triangle(&turn.local(triangle)),
                            }
                        };
                    }
                    place
                }
            };
        }
    }
}
