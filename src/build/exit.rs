//! Exit boxes: how far a ray can go before it meets anything new.
//!
//! The exit box of a voxel is a block of voxels around it, none of which refers
//! to anything that the voxel itself does not refer to; a ray that has met the
//! voxel's list leaves the block in one step. Related are proximity clouds
//! (Cohen & Sheffer 1994), macro-regions (Devillers 1988) and the cells of
//! irregular grids (Perard-Gayot, Kalojanov & Slusallek 2017). Boxes are grown
//! inside one grid only, greedily: the largest empty cube, then slabs in each of
//! the six directions. An empty voxel takes the box of a neighbour if that leaves
//! it as much room on every side as its cube would, as nine of ten do; one with a
//! list takes that of a neighbour that refers to nothing else, if it goes on.

use super::draft::{Draft, Span};
use super::frame::Grid;
use super::grow::Grower;
use super::masks::Masks;
use super::reach::Reach;

/// A voxel with a longer list keeps to itself: comparing lists costs more than
/// the step it saves.
const LONG: u32 = 16;

/// Planes of voxels that share boxes among each other, at most. Those of different slabs
/// do not, so that each can be a task.
pub const SLAB: usize = 8;
/// Slabs that a large grid has, if it has planes for them, so that there are tasks to share.
const SLABS: usize = 8;

/// Planes of a slab of a grid of `n` voxels that is large.
pub fn slab_of(n: [usize; 3]) -> usize {
    n[2].div_ceil(SLABS).clamp(2, SLAB)
}

/// Words of memory that [`planes`] takes.
pub fn plane_len(n: [usize; 3]) -> usize {
    n[0] * n[1]
}

/// Looks at which of a grid's voxels refer to something.
pub fn masks<'a>(grid: &Grid, draft: &Draft<'_>, memory: &'a mut [u64]) -> Masks<'a> {
    Masks::new(grid.n.map(|n| n as usize), draft.spans(grid), memory)
}

/// Writes the exit boxes of whole planes of a grid, from number `first` on, which
/// begins a slab of `slab` planes, in the arena's form. `memory`: [`plane_len`] words.
pub fn planes(
    grid: &Grid,
    draft: &Draft<'_>,
    masks: &Masks<'_>,
    (first, slab): (usize, usize),
    memory: &mut [u64],
    words: &mut [u32],
) {
    let n = grid.n.map(|n| n as usize);
    // The boxes of the last voxels looked at, one for each x and y.
    let plane: &mut [Reach] = bytemuck::cast_slice_mut(&mut memory[..plane_len(n)]);
    let spans = draft.spans(grid);
    let grower = Grower { n, spans, draft, masks, rows: masks.rows() };
    let mut rows =
        spans[first * n[0] * n[1]..].chunks_exact(n[0]).zip(words.chunks_exact_mut(n[0]));
    for z in first..n[2] {
        if z % slab == 0 {
            plane.fill(Reach::NONE);
        }
        for y in 0..n[1] {
            let Some((spans, words)) = rows.next() else { return };
            row(&grower, [y, z], spans, plane, words);
        }
    }
}

/// One row of voxels. `plane` has the boxes of the row before and, from this
/// row's entries on, those of the plane before.
fn row(
    grower: &Grower<'_>,
    [y, z]: [usize; 2],
    spans: &[Span],
    plane: &mut [Reach],
    words: &mut [u32],
) {
    let nx = grower.n[0];
    let (before, here) = plane.split_at_mut(y * nx);
    let before = before.len().checked_sub(nx).map(|at| &before[at..]);
    let index = (z * grower.n[1] + y) * nx;
    let mut last = Reach::NONE;
    let mut rooms = 0;
    for (x, (span, word)) in spans.iter().zip(words).enumerate() {
        rooms = if x % 8 == 0 { grower.masks.rooms([x, y, z]) } else { rooms >> 8 };
        let room = (rooms & 0xff) as usize;
        let at = [x, y, z];
        last = if room > 0 {
            let shared = (last.next::<0>(room))
                .or_else(|| before.and_then(|b| b[x].next::<1>(room)))
                .or_else(|| here[x].next::<2>(room));
            shared.unwrap_or_else(|| Reach::new(&grower.empty(at, room - 1), at, grower.n, false))
        } else if span.count <= LONG {
            let list = grower.draft.list(*span);
            let fits = |before: usize| grower.adds_nothing(index + x - before, list);
            let shared = (last.next_listed::<0>().filter(|_| fits(1)))
                .or_else(|| before.and_then(|b| b[x].next_listed::<1>()).filter(|_| fits(nx)))
                .or_else(|| here[x].next_listed::<2>().filter(|_| fits(nx * grower.n[1])));
            shared.unwrap_or_else(|| Reach::new(&grower.listed(at, list), at, grower.n, true))
        } else {
            Reach::NONE
        };
        *word = last.encode();
        here[x] = last;
    }
}
