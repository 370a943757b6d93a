//! The last pass: the draft becomes an arena.
//!
//! Triangles are copied in the order of the numbers that they got with their first grid.

use super::control::Control;
use super::counts;
use super::draft::Draft;
use super::frame::{self, unit};
use super::occluders;
use super::parts::{self, words};
use super::tree::quantize;
use crate::Error;
use crate::arena::layout::{
    ALIGN, BYTE_ORDER, Counts, Frame, Grid, Header, MAGIC, MAX_WALKS, OCCLUDERS, PAYLOAD, SECTIONS,
    Section, Triangle, VERSION, sections,
};
use crate::arena::node::{Node, QuantizedNode};
use crate::options::{MAX_LEVELS, Options, Structure};
use crate::ray::NONE;
use crate::simd::fpenv;

/// A finished structure in scratch memory, ready to be written to an arena.
pub struct Plan<'s> {
    pub(super) draft: Draft<'s>,
    pub(super) structure: Structure,
    pub(super) levels: u32,
    /// Whether voxels get exit boxes, and room for the sums that takes.
    pub(super) exits: bool,
    pub(super) table: &'s mut [u64],
    pub(super) nodes: &'s [Node],
    /// Whether nodes are written in less.
    pub(super) quantized: bool,
    pub(super) sections: [Section; SECTIONS],
    pub(super) bytes: usize,
}

impl<'s> Plan<'s> {
    pub(super) fn new(
        draft: Draft<'s>,
        options: &Options,
        table: &'s mut [u64],
        nodes: &'s [Node],
    ) -> Result<Self, Error> {
        let grids = draft.grids();
        let voxels: u64 = grids.iter().map(frame::Grid::voxels).sum();
        let words = |g| draft.spans(g).iter().map(|&s| words(&draft, s)).sum::<u64>();
        let refs: u64 = grids.iter().map(words).sum();
        let levels = grids.iter().map(|g| g.level + 1).max().unwrap_or(0);
        let triangles = draft.numbered();
        let frames = if grids.iter().any(frame::Grid::is_turned) { grids.len() } else { 0 };
        debug_assert_eq!(triangles, draft.soup.triangles.len(), "a triangle is in no grid");
        // A list's place must fit a voxel's payload.
        if refs > u64::from(PAYLOAD) {
            return Err(Error::Limit);
        }
        let quantized = options.compact && !nodes.is_empty();
        let counts = Counts {
            grids: grids.len() as u64,
            voxels,
            refs,
            triangles: triangles as u64,
            frames: frames as u64,
            nodes: nodes.len() as u64,
            quantized,
        };
        let (sections, bytes) = sections(&counts)?;
        let bytes = bytes as usize;
        let (structure, exits) = (options.structure, options.exit_boxes);
        Ok(Self { draft, structure, levels, exits, table, nodes, quantized, sections, bytes })
    }

    /// Size of the arena that [`Plan::write`] makes, a multiple of 64.
    #[must_use]
    pub fn arena_bytes(&self) -> usize {
        self.bytes
    }

    /// Writes the arena to the start of `arena`.
    ///
    /// # Errors
    /// [`Error::Limit`] if, in the paper's hierarchy, clusters overlap so much that
    /// the grids of a voxel are entered over and over; [`Error::BufferTooSmall`], or [`Error::Alignment`] unless `arena` is
    /// aligned to 64.
    pub fn write(self, arena: &mut [u8]) -> Result<(), Error> {
        self.write_with(arena, &mut Control::default())
    }

    /// [`Plan::write`] with the control that [`super::plan_with`] was given. What
    /// it leaves in `arena` after an error is no arena.
    ///
    /// # Errors
    /// As [`Plan::write`]; [`Error::Cancelled`], [`Error::Unfinished`].
    pub fn write_with(self, arena: &mut [u8], control: &mut Control<'_>) -> Result<(), Error> {
        fpenv::with_default(|| self.write_arena(arena, control))
    }

    fn write_arena(mut self, arena: &mut [u8], control: &mut Control<'_>) -> Result<(), Error> {
        if !(arena.as_ptr() as usize).is_multiple_of(ALIGN) {
            return Err(Error::Alignment);
        }
        let arena = arena.get_mut(..self.bytes).ok_or(Error::BufferTooSmall)?;
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
            // Nothing of what was there before stays between the sections.
            part[..skip].fill(0);
            &mut part[skip..]
        };
        let grids: &mut [Grid] = bytemuck::cast_slice_mut(section(0, size_of::<Grid>()));
        let voxels: &mut [u32] = bytemuck::cast_slice_mut(section(1, 4));
        let refs: &mut [u32] = bytemuck::cast_slice_mut(section(2, 4));
        let triangles: &mut [Triangle] =
            bytemuck::cast_slice_mut(section(3, size_of::<Triangle>()));
        let frames: &mut [Frame] = bytemuck::cast_slice_mut(section(4, size_of::<Frame>()));
        control.pass(0.5)?;
        if self.quantized {
            let nodes = section(5, size_of::<QuantizedNode>());
            quantize(self.nodes, bytemuck::cast_slice_mut(nodes), control)?;
        } else {
            let nodes = bytemuck::cast_slice_mut(section(5, size_of::<Node>()));
            nodes.copy_from_slice(self.nodes);
        }
        rest.fill(0);
        self.draft.copy_triangles(triangles, control)?;
        control.pass(0.95)?;
        let unit = unit(&self.draft.soup.bounds);
        let mut first = 0;
        for (grid, from) in grids.iter_mut().zip(self.draft.grids()) {
            *grid = frame::Grid { first, ..*from }.record(unit);
            first += from.voxels() as u32;
        }
        for (number, frame) in frames.iter_mut().enumerate() {
            *frame = self.draft.turn(number).map(|turn| turn.record(unit)).unwrap_or_default();
        }
        let table = if self.exits { &mut *self.table } else { &mut [] };
        parts::write(&self.draft, triangles, table, (voxels, refs), control)?;
        control.pass(1.0)?;
        counts::walks(grids, (voxels, refs), control)?;
        if grids.first().is_some_and(|g| u64::from(g.walks) > MAX_WALKS * grids.len() as u64) {
            return Err(Error::Limit);
        }
        head.occluders = occluders::choose(triangles, &self.draft.soup.bounds, control)?;
        head.objects =
            counts::objects(grids, (voxels, refs), triangles.len(), self.draft.spare(), control)?;
        control.at(1, 1)
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
            unit: unit(&soup.bounds),
            occluders: [NONE; OCCLUDERS],
            frames: self.sections[4],
            nodes: self.sections[5],
            quantized: u64::from(self.quantized),
            reserved: [0; 5],
        }
    }
}
