//! The calls of one kind of query, and how each is made again.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::cell::RefCell;
use core::hint::black_box;

use super::super::{Met as Outcome, SHORT, Walk};
use super::record::{Entry, Log, Met, Recorder, Whole};
use super::{Function, Machine, Visitor};
use crate::arena::View;
use crate::arena::layout::{EMPTY, GRID_BIT, LIST, PAYLOAD, TAG_SHIFT};
use crate::ray::Ray;
use crate::simd::{Kernel, Lanes};
use crate::trace::bounds::{BATCH, Few, Part};
use crate::trace::counters::Uncounted;
use crate::trace::decided::Decided;
use crate::trace::local::Local;
use crate::trace::query::{Query, usable};
use crate::triangle::Corners;

/// What a query of one kind did for some rays.
pub struct Half<'a, Q: Query, L: Lanes> {
    lanes: L,
    view: View<'a>,
    entries: Vec<Entry>,
    lists: Vec<Met>,
    /// By ray; each has met the lists before its end.
    walks: Vec<Walk<'a, Q, Uncounted, L>>,
    ends: Vec<u32>,
    /// By entry; none if the ray missed the grid.
    locals: Vec<Option<Local<L>>>,
}

impl<'a, Q: Query, L: Lanes> Half<'a, Q, L> {
    pub fn record(lanes: L, view: View<'a>, rays: &'a [Ray]) -> Self {
        let log = RefCell::new(Log::default());
        let (mut walks, mut ends) = (Vec::new(), Vec::new());
        for ray in rays.iter().filter(|ray| usable(lanes, ray)) {
            log.borrow_mut().ray = walks.len() as u32;
            lanes.run(Whole { view, query: Q::new(ray), ray, recorder: Recorder(&log) });
            walks.push(begin(lanes, &view, ray));
            ends.push(log.borrow().lists.len() as u32);
        }
        let Log { entries, lists, .. } = log.into_inner();
        let enter = |entry: &Entry| {
            let (walk, range) = (&walks[entry.ray as usize], [entry.t0, entry.t1]);
            Local::enter(lanes, &view.sections(), entry.grid, &walk.course, walk.ray, range)
        };
        let locals = entries.iter().map(enter).collect();
        Self { lanes, view, entries, lists, walks, ends, locals }
    }
}

#[inline(always)]
fn begin<'a, Q: Query, L: Lanes>(l: L, view: &View<'a>, ray: &'a Ray) -> Walk<'a, Q, Uncounted, L> {
    // Of no size: nothing is allocated.
    Walk::new(l, view, ray, Q::new(ray), Box::leak(Box::new(Uncounted)))
}

impl<Q: Query, L: Lanes> Walk<'_, Q, Uncounted, L> {
    /// To the start of the ray.
    #[inline(always)]
    fn rewind(&mut self) {
        self.query = Q::new(self.ray);
        self.decided = Decided::NONE;
        self.sieve.limit(self.lanes, self.query.limit());
    }

    /// Meets the triangles of a list, as [`Walk::grid`] does; the grids in it are calls of
    /// their own.
    #[inline(always)]
    fn again(&mut self, list: &Met, local: Option<&Local<L>>) -> Outcome {
        let l = self.lanes;
        let (exit, refs) = self.sections.list(list.place);
        if refs.len() <= SHORT && refs.last().is_none_or(|r| r & GRID_BIT == 0) {
            return self.triangles(refs);
        }
        // There are lists only where the grid was entered.
        let Some(local) = local else { return Outcome::Nothing };
        let boxes = local.boxes(l, l.load_i32(&list.at), exit, list.range);
        let (mut met, mut few, mut at) = (Outcome::Nothing, Few::NONE, 0);
        let len = refs.len() as u32;
        while at < len && met != Outcome::Enough {
            let part = Part::new(list.place, len, at);
            few.fill::<Uncounted, L>(l, &self.sections, part, &boxes);
            met = met.max(self.triangles(few.split().0));
            at += BATCH as u32;
        }
        met
    }
}

struct Run<'h, 'a, Q: Query, L: Lanes> {
    half: &'h mut Half<'a, Q, L>,
    function: Function,
}

impl<Q: Query, L: Lanes> Kernel<L> for Run<'_, '_, Q, L> {
    type Out = u64;
    #[inline(always)]
    fn run(self, l: L) -> u64 {
        let half = self.half;
        match self.function {
            Function::Ray => half.rays(l),
            Function::Grid => half.grids(l),
            Function::Voxel => half.voxels(l),
            Function::Test => half.tests(),
        }
    }
}

impl<Q: Query, L: Lanes> Half<'_, Q, L> {
    #[inline(always)]
    fn rays(&mut self, l: L) -> u64 {
        let sections = self.view.sections();
        let mut usables = 0;
        for walk in &self.walks {
            usables += u64::from(usable(l, walk.ray));
            black_box(&begin::<Q, L>(l, &self.view, walk.ray));
            black_box(&walk.query.found(&sections, walk.ray));
        }
        usables
    }

    /// A call waits for the one before, as it does in a walk.
    #[inline(always)]
    fn grids(&mut self, l: L) -> u64 {
        let sections = self.view.sections();
        let (mut last, nothing, mut entered) = (0, black_box(0), 0);
        for entry in &self.entries {
            let walk = &self.walks[entry.ray as usize];
            let t0 = f64::from_bits(entry.t0.to_bits() | (last & nothing));
            let range = [t0, entry.t1];
            let local = Local::enter(l, &sections, entry.grid, &walk.course, walk.ray, range);
            last = local.as_ref().map_or(0, |local| {
                entered += 1;
                local.span.low(0.0).to_bits() | l.array(local.at)[0] as u64
            });
            black_box(&local);
        }
        entered
    }

    /// The voxels of an entry are found one from another; how many have lists.
    #[inline(always)]
    fn voxels(&mut self, l: L) -> u64 {
        let sections = self.view.sections();
        let mut lists = 0;
        for (entry, local) in self.entries.iter().zip(&self.locals) {
            let Some(local) = local else { continue };
            let (mut at, mut out) = (local.at, 0.0);
            for _ in 0..entry.steps {
                if l.any_greater(at, local.last) {
                    break;
                }
                let voxel = sections.voxel(local.number(l, at) as usize);
                let exit = match voxel >> TAG_SHIFT {
                    EMPTY => voxel,
                    LIST => {
                        lists += 1;
                        sections.head(voxel & PAYLOAD).0
                    }
                    _ => 0,
                };
                let step = local.step::<Uncounted>(l, at, exit);
                (at, out) = (step.to, step.out);
            }
            black_box(out);
        }
        lists
    }

    /// How many lists had something to decide.
    #[inline(always)]
    fn tests(&mut self) -> u64 {
        let (mut start, mut decided) = (0, 0);
        for (walk, &end) in self.walks.iter_mut().zip(&self.ends) {
            walk.rewind();
            for list in &self.lists[start..end as usize] {
                let met = walk.again(list, self.locals[list.entry as usize].as_ref());
                decided += u64::from(met != Outcome::Nothing);
            }
            start = end as usize;
        }
        decided
    }
}

impl<Q: Query, L: Lanes> Machine for Half<'_, Q, L> {
    fn calls(&self, function: Function) -> u64 {
        let sections = self.view.sections();
        let triangles = |list: &Met| {
            let (_, refs) = sections.list(list.place);
            refs.iter().filter(|&&r| r & GRID_BIT == 0).count() as u64
        };
        match function {
            Function::Ray => self.walks.len() as u64,
            Function::Grid => self.entries.len() as u64,
            Function::Voxel => self.entries.iter().map(|e| u64::from(e.steps)).sum(),
            Function::Test => self.lists.iter().map(triangles).sum(),
        }
    }

    fn run(&mut self, function: Function) -> u64 {
        self.lanes.run(Run { half: self, function })
    }

    fn each_test(&mut self, visit: &mut Visitor<'_>) {
        let sections = self.view.sections();
        let mut start = 0;
        for (walk, &end) in self.walks.iter_mut().zip(&self.ends) {
            walk.rewind();
            for list in &self.lists[start..end as usize] {
                let (_, refs) = sections.list(list.place);
                for &r in refs.iter().filter(|&&r| r & GRID_BIT == 0) {
                    visit(walk.ray, sections.triangle(r).all(), walk.query.limit());
                }
                walk.again(list, self.locals[list.entry as usize].as_ref());
            }
            start = end as usize;
        }
    }
}
