//! The last pass: the draft becomes an arena.
//!
//! Triangles are numbered in the order in which voxels, first to last, refer
//! to them, so that what a ray meets together lies together.

use super::draft::Draft;
use crate::Error;
use crate::arena::layout::{
    ALIGN, BYTE_ORDER, GRID_BIT, Grid, Header, MAGIC, Section, Triangle, VERSION, sections,
};
use crate::options::{MAX_LEVELS, Structure};

/// A finished structure in scratch memory, ready to be written to an arena.
pub struct Plan<'s> {
    pub(super) draft: Draft<'s>,
    pub(super) structure: Structure,
    pub(super) levels: u32,
    /// Room for the triangles' new numbers.
    pub(super) numbers: &'s mut [u32],
    pub(super) sections: [Section; 4],
    pub(super) bytes: usize,
}

impl<'s> Plan<'s> {
    pub(super) fn new(
        draft: Draft<'s>,
        structure: Structure,
        numbers: &'s mut [u32],
    ) -> Result<Self, Error> {
        let grids = draft.grids();
        let voxels: u64 = grids.iter().map(Grid::voxels).sum();
        let refs = |g| {
            draft
                .spans(g)
                .iter()
                .map(|s| u64::from(s.count))
                .sum::<u64>()
        };
        let refs: u64 = grids.iter().map(refs).sum();
        let ends = if grids.is_empty() { 0 } else { voxels + 1 };
        let triangles = draft.soup.triangles.len() as u64;
        let levels = grids.iter().map(|g| g.level + 1).max().unwrap_or(0);
        if refs > u64::from(u32::MAX) || ends > u64::from(u32::MAX) {
            return Err(Error::Limit);
        }
        let (sections, bytes) = sections(grids.len() as u64, ends, refs, triangles)?;
        Ok(Self {
            draft,
            structure,
            levels,
            numbers,
            sections,
            bytes: bytes as usize,
        })
    }

    /// Size of the arena that [`Plan::write`] makes, a multiple of 64.
    #[must_use]
    pub fn arena_bytes(&self) -> usize {
        self.bytes
    }

    /// Writes the arena to the start of `arena`.
    ///
    /// # Errors
    /// [`Error::BufferTooSmall`], or [`Error::Alignment`] unless `arena` is
    /// aligned to 64.
    pub fn write(self, arena: &mut [u8]) -> Result<(), Error> {
        if !(arena.as_ptr() as usize).is_multiple_of(ALIGN) {
            return Err(Error::Alignment);
        }
        let arena = arena.get_mut(..self.bytes).ok_or(Error::BufferTooSmall)?;
        arena.fill(0);
        let (head, mut rest) = arena.split_at_mut(size_of::<Header>());
        let head: &mut Header = bytemuck::from_bytes_mut(head);
        *head = self.header();
        let mut at = size_of::<Header>();
        let mut section = |i: usize, record: usize| {
            let Section { offset, count } = self.sections[i];
            let block = core::mem::take(&mut rest);
            let (part, tail) = block.split_at_mut(offset as usize - at + count as usize * record);
            rest = tail;
            let skip = offset as usize - at;
            at = offset as usize + count as usize * record;
            &mut part[skip..]
        };
        let grids: &mut [Grid] = bytemuck::cast_slice_mut(section(0, size_of::<Grid>()));
        let voxels: &mut [u32] = bytemuck::cast_slice_mut(section(1, 4));
        let refs: &mut [u32] = bytemuck::cast_slice_mut(section(2, 4));
        let triangles: &mut [Triangle] =
            bytemuck::cast_slice_mut(section(3, size_of::<Triangle>()));
        flatten(&self.draft, self.numbers, grids, voxels, refs, triangles);
        count_walks(grids, voxels, refs);
        head.objects = count_objects(grids, voxels, refs, self.numbers);
        Ok(())
    }

    fn header(&self) -> Header {
        let soup = &self.draft.soup;
        Header {
            magic: MAGIC,
            byte_order: BYTE_ORDER,
            version: VERSION,
            bytes: self.bytes as u64,
            structure: self.structure as u32,
            levels: self.levels,
            grids: self.sections[0],
            voxels: self.sections[1],
            refs: self.sections[2],
            triangles: self.sections[3],
            dropped_non_finite: soup.dropped_non_finite,
            dropped_degenerate: soup.dropped_degenerate,
            lower: soup.bounds.lo,
            upper: soup.bounds.hi,
            objects: [0; MAX_LEVELS],
            reserved: [0; 7],
        }
    }
}

fn flatten(
    draft: &Draft<'_>,
    numbers: &mut [u32],
    grids: &mut [Grid],
    voxels: &mut [u32],
    refs: &mut [u32],
    triangles: &mut [Triangle],
) {
    const UNSEEN: u32 = u32::MAX;
    numbers.fill(UNSEEN);
    let (mut seen, mut voxel, mut end) = (0, 0, 0);
    for (grid, from) in grids.iter_mut().zip(draft.grids()) {
        *grid = Grid {
            first: voxel as u32,
            ..*from
        };
        for &span in draft.spans(from) {
            let list = &mut refs[end..end + span.count as usize];
            for (to, &object) in list.iter_mut().zip(draft.list(span)) {
                *to = object;
                if object & GRID_BIT == 0 {
                    let number = &mut numbers[object as usize];
                    if *number == UNSEEN {
                        *number = seen;
                        triangles[seen as usize] = draft.soup.triangles[object as usize];
                        seen += 1;
                    }
                    *to = *number;
                }
            }
            list.sort_unstable();
            voxels[voxel] = end as u32;
            voxel += 1;
            end += list.len();
        }
    }
    if let Some(last) = voxels.last_mut() {
        *last = end as u32;
    }
    debug_assert_eq!(seen as usize, triangles.len(), "a triangle is in no voxel");
}

/// How many triangles each level refers to; a level's grids are neighbours.
fn count_objects(
    grids: &[Grid],
    voxels: &[u32],
    refs: &[u32],
    last: &mut [u32],
) -> [u32; MAX_LEVELS] {
    let mut objects = [0; MAX_LEVELS];
    last.fill(u32::MAX);
    for grid in grids {
        let (first, count) = (grid.first as usize, grid.voxels() as usize);
        let list = voxels[first] as usize..voxels[first + count] as usize;
        for &r in refs[list].iter().filter(|&&r| r & GRID_BIT == 0) {
            if core::mem::replace(&mut last[r as usize], grid.level) != grid.level {
                objects[grid.level as usize] += 1;
            }
        }
    }
    objects
}

/// Sets each grid's `walks`, children before parents.
fn count_walks(grids: &mut [Grid], voxels: &[u32], refs: &[u32]) {
    for number in (0..grids.len()).rev() {
        let (first, count) = (
            grids[number].first as usize,
            grids[number].voxels() as usize,
        );
        let entries = |list: &[u32]| {
            let below = list.iter().filter(|&&r| r & GRID_BIT != 0);
            below
                .map(|&r| u64::from(grids[(r & !GRID_BIT) as usize].walks))
                .sum::<u64>()
        };
        let lists = voxels[first..=first + count].windows(2);
        let most = lists
            .map(|pair| entries(&refs[pair[0] as usize..pair[1] as usize]))
            .max();
        grids[number].walks = (1 + most.unwrap_or(0)).min(u64::from(u32::MAX)) as u32;
    }
}
