//! What an arena says in sum: how many triangles each level refers to, and how often the
//! grids below a grid can be entered.

use super::control::{self, Control, TASKS};
use super::scratch::cut;
use crate::Error;
use crate::arena::layout::{GRID, GRID_BIT, Grid, LIST, LIST_HEAD, PAYLOAD, TAG_SHIFT};
use crate::options::MAX_LEVELS;

/// Voxels of a task, at least.
const PART: usize = 1 << 12;

/// The references of a voxel of an arena being written.
fn list<'a>(voxel: &u32, refs: &'a [u32]) -> &'a [u32] {
    let start = (voxel & PAYLOAD) as usize;
    match voxel >> TAG_SHIFT {
        LIST => &refs[start + LIST_HEAD..][..refs[start + 1] as usize],
        _ => &[],
    }
}

/// Where the grids begin whose level is that of the one before `end`; they are grouped by
/// level, highest first.
fn level_start(grids: &[Grid], end: usize) -> usize {
    grids[..end].partition_point(|grid| grid.level > grids[end - 1].level)
}

/// How many of `triangles` triangles each level refers to; `marks` is room for a word for
/// each.
pub fn objects(
    grids: &[Grid],
    (voxels, refs): (&[u32], &[u32]),
    triangles: usize,
    marks: &mut [u32],
    control: &mut Control<'_>,
) -> Result<[u32; MAX_LEVELS], Error> {
    let mut objects = [0; MAX_LEVELS];
    if grids.iter().all(|grid| grid.level == 0) {
        // Every triangle is in some voxel.
        objects[0] = triangles as u32;
        return Ok(objects);
    }
    let words = triangles.div_ceil(32);
    let mut last = voxels.len();
    let mut end = grids.len();
    while end > 0 {
        let start = level_start(grids, end);
        let first = grids[start].first as usize;
        let some = &voxels[first..last];
        let count = (marks.len() / words).clamp(1, TASKS).min(some.len().div_ceil(PART));
        let mut parts = some.chunks(some.len().div_ceil(count));
        let mut free = &mut *marks;
        let mut tasks = control::parts(|| {
            let part = parts.next()?;
            Some((part, cut(&mut free, words)))
        });
        control.each(&mut tasks, |(voxels, marks)| {
            marks.fill(0);
            let lists = voxels.iter().flat_map(|voxel| list(voxel, refs));
            for r in lists.filter(|&r| r & GRID_BIT == 0) {
                marks[*r as usize / 32] |= 1 << (r % 32);
            }
        })?;
        let seen =
            |word: usize| tasks.iter().flatten().fold(0, |seen, (_, marks)| seen | marks[word]);
        let count = (0..words).map(|word| seen(word).count_ones()).sum();
        objects[usize::from(grids[start].level)] = count;
        control.count(some.len());
        control.at(voxels.len() - first, voxels.len())?;
        (end, last) = (start, first);
    }
    Ok(objects)
}

/// Sets each grid's `walks`, children before parents.
pub fn walks(
    grids: &mut [Grid],
    (voxels, refs): (&[u32], &[u32]),
    control: &Control<'_>,
) -> Result<(), Error> {
    // The deepest have none below.
    let mut end = level_start(grids, grids.len());
    while end > 0 {
        let start = level_start(grids, end);
        let (above, below) = grids.split_at_mut(end);
        let below = &*below;
        let walks = |child: u32| u64::from(below[child as usize - end].walks);
        let entries = |voxel: &u32| match voxel >> TAG_SHIFT {
            GRID => walks(voxel & PAYLOAD),
            _ => {
                let below = list(voxel, refs).iter().rev().take_while(|&&r| r & GRID_BIT != 0);
                below.map(|&r| walks(r & !GRID_BIT)).sum()
            }
        };
        let run = &mut above[start..];
        let mut parts = run.chunks_mut(run.len().div_ceil(TASKS));
        control.each(&mut control::parts(|| parts.next()), |grids| {
            for grid in grids.iter_mut() {
                let own = &voxels[grid.first as usize..][..grid.voxels() as usize];
                let most = own.iter().map(entries).max();
                grid.walks = (1 + most.unwrap_or(0)).min(u64::from(u32::MAX)) as u32;
            }
        })?;
        end = start;
    }
    Ok(())
}
