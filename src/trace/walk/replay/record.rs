//! A walk that keeps the arguments of what it calls.

use alloc::vec::Vec;
use core::cell::RefCell;

use super::super::Walk;
use crate::arena::View;
use crate::options::MAX_LEVELS;
use crate::ray::Ray;
use crate::simd::{Kernel, Lanes};
use crate::trace::counters::Count;
use crate::trace::query::Query;

/// Of a walk into a grid: its arguments, and the voxels that it went through.
pub struct Entry {
    pub ray: u32,
    pub grid: u32,
    pub t0: f64,
    pub t1: f64,
    pub steps: u32,
}

/// Of a list that was met: the grid's entry, voxel, place, and the part of the ray.
pub struct Met {
    pub entry: u32,
    pub place: u32,
    pub at: [i32; 4],
    pub range: [f32; 2],
}

#[derive(Default)]
pub struct Log {
    pub entries: Vec<Entry>,
    pub lists: Vec<Met>,
    /// The entry that the walk is in on each level: a grid's children are of lower ones.
    open: [u32; MAX_LEVELS],
    level: usize,
    pub ray: u32,
}

#[derive(Clone, Copy)]
pub struct Recorder<'r>(pub &'r RefCell<Log>);

impl Count for Recorder<'_> {
    type Meter<'m>
        = Self
    where
        Self: 'm;
    fn meter(&mut self) -> Self {
        *self
    }
    // It takes the walk of those that count nothing.
    const COUNTS: bool = false;
    const KEEPS: bool = true;
    type Level = u8;
    fn of(level: u8) -> u8 {
        level
    }
    fn level(&mut self, level: u8) {
        self.0.borrow_mut().level = usize::from(level) % MAX_LEVELS;
    }
    fn voxel(&mut self) {
        let mut log = self.0.borrow_mut();
        let entry = log.open[log.level] as usize;
        log.entries[entry].steps += 1;
    }
    fn keep_grid(&mut self, grid: u32, [t0, t1]: [f64; 2]) {
        let mut log = self.0.borrow_mut();
        let (level, ray) = (log.level, log.ray);
        log.open[level] = log.entries.len() as u32;
        log.entries.push(Entry { ray, grid, t0, t1, steps: 0 });
    }
    fn keep_list(&mut self, place: u32, at: [i32; 4], range: [f32; 2]) {
        let mut log = self.0.borrow_mut();
        let entry = log.open[log.level];
        log.lists.push(Met { entry, place, at, range });
    }
}

pub struct Whole<'a, 'r, Q> {
    pub view: View<'a>,
    pub query: Q,
    pub ray: &'a Ray,
    pub recorder: Recorder<'r>,
}

impl<Q: Query, L: Lanes> Kernel<L> for Whole<'_, '_, Q> {
    type Out = ();
    #[inline(always)]
    fn run(mut self, l: L) {
        Walk::new(l, &self.view, self.ray, self.query, &mut self.recorder).run(&[]);
    }
}
