//! [`find`](super::find) in tasks, for many triangles and a grid that need not be coarser.
//!
//! Each task notes the voxels of some triangles in a piece of the stream of its own; then
//! the pieces are moved together and counted. Where a piece is too short, or the grid has
//! too many references, nothing is lost but time: `find` starts anew.

use super::{EMPTY, Finder, Notes, Shapes};
use crate::Error;
use crate::build::control::{Control, TASKS, parts};
use crate::build::frame::Grid;
use crate::build::scratch::cut;

/// Triangles of a task, at most.
const PART: usize = 2048;
/// Words for a triangle of a task at first, itself and its voxels: what a batch of tasks notes is then
/// in one large page.
const WORDS: usize = 8;

/// Some triangles and their piece of the stream.
struct Part<'a> {
    objects: &'a [u32],
    stream: &'a mut [u32],
    /// The words that it takes.
    words: usize,
    rows: usize,
}

/// Notes the voxels of a batch of triangles, `size` words for each part of it. How many words parts
/// take, or more than that if there are not enough, and rows of voxels that were looked at: not many
/// more than `work`.
#[inline(never)]
fn note(
    finder: &Finder<'_>,
    batch: &[u32],
    (mut free, size): (&mut [u32], usize),
    work: usize,
    control: &Control<'_>,
) -> Result<[[usize; 2]; TASKS], Error> {
    let mut objects = batch.chunks(PART);
    let mut parts = parts(|| {
        let objects = objects.next()?;
        Some(Part { objects, stream: cut(&mut free, size), words: 0, rows: 0 })
    });
    control.each(&mut parts, |part| {
        for &object in part.objects {
            // What is too much for a part, `find` looks at more closely.
            if part.words > size || part.rows > work {
                break;
            }
            let free = part.stream.get_mut(part.words..).unwrap_or_default();
            let [count, rows] = finder.note(object, free);
            part.words += 1 + count;
            part.rows += rows;
        }
    })?;
    let mut found = [[0; 2]; TASKS];
    for (found, part) in found.iter_mut().zip(parts.iter().flatten()) {
        *found = [part.words, part.rows];
    }
    Ok(found)
}

/// Does what [`find`](super::find) does, or returns `false`: where the grid would have to be
/// made coarser, where a part has much more than its share of references, where triangles are
/// few, and where there is nobody to share the work with.
pub fn find_in_tasks(
    grid: &Grid,
    objects: &[u32],
    shapes: Shapes<'_>,
    notes: &mut Notes<'_>,
    max_refs: u32,
    control: &mut Control<'_>,
) -> Result<bool, Error> {
    let voxels = grid.voxels() as usize;
    if !control.shares() || objects.len() < 2 * PART || notes.spans.len() < voxels {
        return Ok(false);
    }
    notes.spans[..voxels].fill(EMPTY);
    let finder = Finder::new(grid, shapes);
    let most = PART * (max_refs as usize + 1);
    let mut room = most.min(PART * WORDS);
    let budget = objects.len().saturating_mul(max_refs as usize);
    let work = 4 * PART * max_refs as usize;
    let (all, mut end, mut seen, mut rows) = (objects.len(), 0, 0, 0);
    for batch in objects.chunks(PART * TASKS) {
        let count = batch.len().div_ceil(PART);
        let mut found;
        let mut size;
        loop {
            let free = &mut notes.stream[end..];
            size = (free.len() / count).min(room);
            found = note(&finder, batch, (free, size), work, control)?;
            let fits = found[..count].iter().all(|&[words, _]| words <= size);
            if fits || size < room || room == most {
                break;
            }
            room = most;
        }
        let mut piece = end;
        for &[words, looked_at] in &found[..count] {
            if words > size || looked_at > work {
                return Ok(false);
            }
            notes.stream.copy_within(piece..piece + words, end);
            piece += size;
            let last = end + words;
            while end < last {
                notes.starts[seen] = end as u32;
                seen += 1;
                let next = end + 1 + notes.stream[end] as usize;
                for &voxel in &notes.stream[end + 1..next] {
                    notes.spans[voxel as usize].count += 1;
                }
                end = next;
            }
            rows += looked_at;
        }
        control.at(seen, all)?;
        // As `find` would.
        if end - seen > budget || rows > budget.saturating_mul(4) {
            return Ok(false);
        }
    }
    // As much as `find` counts, which nothing of what is in vain adds to.
    control.count(voxels + end + rows);
    Ok(true)
}
