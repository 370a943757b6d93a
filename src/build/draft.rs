//! The structure as it grows: grids, the lists of their voxels, references.
//!
//! Where a triangle is put into its first grid, it gets its number in the arena, by the
//! lowest voxel that it meets: what a ray meets together lies together, and lists, also
//! those of the grids below, are in order without being sorted.

use super::arrangement::Objects;
use super::bucket::{self, Lists, Notes, Shapes, find, find_in_tasks, total};
use super::capacity::Capacity;
use super::control::Control;
use super::frame::{Grid, Rule};
use super::gather::Soup;
use super::scratch::Scratch;
use super::turn::{Turn, place};
use crate::Error;
use crate::arena::layout::{GRID_BIT, Triangle};
use bytemuck::{Pod, Zeroable};

/// A voxel's list: `count` references from number `start` on.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub struct Span {
    pub start: u32,
    pub count: u32,
}

/// What [`Draft::fill`] does when a grid's references exceed its budget.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Crowded {
    /// Halve the voxel counts.
    Coarsen,
    /// Give up with [`Error::Limit`].
    Fail,
}

/// Grids, voxels and references in scratch memory.
pub struct Draft<'s> {
    pub soup: Soup<'s>,
    /// The places in the soup of the triangles that have numbers, by number.
    pub(super) order: &'s mut [u32],
    pub(super) numbered: usize,
    /// Whether triangles are numbered as they come.
    ordered: bool,
    /// Room for what the bucket sort notes of each triangle.
    pub(super) notes: [&'s mut [u32]; 2],
    pub(super) grid_memory: &'s mut [Grid],
    /// How turned grids are turned, by number, if there can be such.
    turns: &'s mut [Turn],
    pub(super) span_memory: &'s mut [Span],
    pub(super) ref_memory: &'s mut [u32],
    /// Room for what the bucket sort finds.
    pub(super) stream: &'s mut [u32],
    pub(super) grids: usize,
    pub(super) spans: usize,
    pub(super) refs: usize,
    pub(super) max_refs: u32,
}

/// Sizes of a draft, to go back to.
#[derive(Clone, Copy)]
pub struct Mark {
    grids: usize,
    spans: usize,
    refs: usize,
}

impl<'s> Draft<'s> {
    pub fn new(
        soup: Soup<'s>,
        capacity: &Capacity,
        max_refs: u32,
        scratch: &mut Scratch<'s>,
    ) -> Result<Self, Error> {
        let mut note = || scratch.take(capacity.triangles);
        Ok(Self {
            soup,
            order: note()?,
            numbered: 0,
            ordered: false,
            notes: [note()?, note()?],
            grid_memory: scratch.take(capacity.grids)?,
            turns: scratch.take(capacity.turns)?,
            span_memory: scratch.take(capacity.voxels)?,
            ref_memory: scratch.take(capacity.refs)?,
            stream: scratch.take(capacity.stream)?,
            grids: 0,
            spans: 0,
            refs: 0,
            max_refs,
        })
    }

    /// Has the next grid number its triangles in the order in which it is given them.
    pub fn keep_order(&mut self) {
        self.ordered = true;
    }

    /// Whether it does.
    pub fn is_ordered(&self) -> bool {
        self.ordered
    }

    /// How many triangles have numbers.
    pub fn numbered(&self) -> usize {
        self.numbered
    }

    /// Writes the triangles in the order of their numbers.
    pub fn copy_triangles(
        &self,
        to: &mut [Triangle],
        control: &mut Control<'_>,
    ) -> Result<(), Error> {
        self.soup.copy(&self.order[..self.numbered], to, control)
    }

    /// A word for each triangle that nothing else uses between two fillings.
    pub fn spare(&mut self) -> &mut [u32] {
        &mut self.notes[0][..self.numbered]
    }

    pub fn grids(&self) -> &[Grid] {
        &self.grid_memory[..self.grids]
    }

    pub fn grids_mut(&mut self) -> &mut [Grid] {
        &mut self.grid_memory[..self.grids]
    }

    /// How grid `number` is turned, if it is.
    pub fn turn(&self, number: usize) -> Option<&Turn> {
        self.turns.get(number).filter(|_| self.grids()[number].is_turned())
    }

    /// Makes a grid without voxels a turned one.
    pub fn set_turn(&mut self, number: usize, grid: Grid, turn: Turn) {
        self.grid_memory[number] = grid;
        self.turns[number] = turn;
    }

    /// The lowest and the highest corner of a box around what grid `number` holds.
    pub fn place(&self, number: usize) -> [[f64; 3]; 2] {
        place(self.grids(), self.turns, number)
    }

    pub fn spans(&self, grid: &Grid) -> &[Span] {
        &self.span_memory[grid.first as usize..][..grid.voxels() as usize]
    }

    pub fn list(&self, span: Span) -> &[u32] {
        &self.ref_memory[span.start as usize..][..span.count as usize]
    }

    /// References from number `start` on, whatever lists they are of.
    pub fn refs_from(&self, start: usize) -> &[u32] {
        self.ref_memory[..self.refs].get(start..).unwrap_or_default()
    }

    pub fn mark(&self) -> Mark {
        Mark { grids: self.grids, spans: self.spans, refs: self.refs }
    }

    pub fn back_to(&mut self, mark: Mark) {
        (self.grids, self.spans, self.refs) = (mark.grids, mark.spans, mark.refs);
    }

    /// Adds a grid without voxels; returns its number.
    pub fn push(&mut self, grid: Grid) -> Result<usize, Error> {
        *self.grid_memory.get_mut(self.grids).ok_or(Error::Limit)? = grid;
        self.grids += 1;
        Ok(self.grids - 1)
    }

    /// A rule with the weights that it wants for these objects, as [`Draft::fill`] takes
    /// them, in a grid. Cost: if it wants any, sorting the objects' ends.
    pub fn weighed(&mut self, rule: &Rule, grid: &Grid, objects: &[u32]) -> Rule {
        let (soup, grids) = (&self.soup, &self.grid_memory[..self.grids]);
        let triangle = |object: u32| &soup.triangles[object as usize];
        rule.weighed(grid, Objects { objects, grids, triangle: &triangle }, self.stream)
    }

    /// The same for the list of a voxel, of triangles that have numbers.
    pub fn weighed_from(&mut self, rule: &Rule, grid: &Grid, span: Span) -> Rule {
        let (soup, order) = (&self.soup, &self.order[..self.numbered]);
        let triangle = |object: u32| &soup.triangles[order[object as usize] as usize];
        let objects = &self.ref_memory[span.start as usize..][..span.count as usize];
        rule.weighed(grid, Objects { objects, grids: &[], triangle: &triangle }, self.stream)
    }

    /// Sorts `objects` (triangles without numbers, by their places in the soup, then
    /// grids, both ascending, or triangles alone in an order to keep) into the voxels of a
    /// grid, and numbers the triangles.
    /// Cost: one overlap test for each reference, plus the voxels.
    ///
    /// # Errors
    /// [`Error::Limit`] if the capacity does not suffice.
    pub fn fill(
        &mut self,
        number: usize,
        objects: &[u32],
        crowded: Crowded,
        control: &mut Control<'_>,
    ) -> Result<(), Error> {
        let triangles = objects.partition_point(|object| object & GRID_BIT == 0);
        let (soup, turns) = (&self.soup, &*self.turns);
        let (first, first_ref) = (self.numbered as u32, self.refs);
        let [starts, lowest] = &mut self.notes;
        let (starts, lowest) = (&mut starts[..triangles], &mut lowest[..triangles]);
        let order = &mut self.order[self.numbered..][..triangles];
        let spans = &mut self.span_memory[self.spans..];
        let mut grid = Grid { first: self.spans as u32, ..self.grid_memory[number] };
        let grids = &self.grid_memory[..self.grids];
        let turn = turns.get(number).filter(|_| grid.is_turned());
        let shapes = Shapes { soup: soup.triangles, order: None, turn, grids, turns };
        let mut notes = Notes { spans, stream: self.stream, starts };
        let alike = turn.is_none() && triangles == objects.len();
        if !(alike && find_in_tasks(&grid, objects, shapes, &mut notes, self.max_refs, control)?) {
            let limits = (self.max_refs, crowded);
            let tick = |work, seen| control.tick(work, seen, objects.len());
            find(&mut grid, objects, shapes, notes.again(), limits, tick)?;
        }
        self.grid_memory[number] = grid;
        let Notes { spans, stream, starts } = notes;
        let spans = &mut spans[..grid.voxels() as usize];
        if self.ordered {
            (0..).zip(&mut *order).for_each(|(i, to)| *to = i);
        } else {
            bucket::order(Notes { spans, stream, starts }, lowest, order);
        }
        let refs = total(spans);
        let room = self.ref_memory[self.refs..].get_mut(..refs).ok_or(Error::Limit)?;
        let mut lists = Lists::open(spans, room, first_ref, stream);
        // The stream has the grids behind the triangle that was last before.
        let mut end = 0;
        for (number, i) in (first..).zip(order.iter_mut()) {
            end = end.max(lists.put(number, starts[*i as usize]));
            *i = objects[*i as usize];
        }
        for &below in &objects[triangles..] {
            end = lists.put(below, end);
        }
        lists.close();
        self.spans += grid.voxels() as usize;
        self.refs += refs;
        self.numbered += triangles;
        Ok(())
    }

    /// Makes the list of a voxel the one reference to grid `number`.
    pub fn replace(&mut self, voxel: u32, number: usize) {
        let span = &mut self.span_memory[voxel as usize];
        span.count = 1;
        self.ref_memory[span.start as usize] = GRID_BIT | number as u32;
    }
}
