//! The calls that walks make, recorded and made again: the costs of section 4, where what
//! a function takes depends on who calls it with what.
//!
//! Behind the feature `replay` and hidden, for the report and the benchmarks alone: the
//! pieces of a walk are no interface, but to be timed in their place they must be the
//! library's own, compiled as it compiles them. A walk that records is one more kind of
//! `Count`, so others do not change by a single instruction.

mod half;
mod record;

use alloc::boxed::Box;

use crate::arena::View;
use crate::ray::Ray;
use crate::simd::{AnyKernel, Isa, Lanes, dispatch, fpenv};
use crate::trace::query::{Any, Closest};
use half::Half;

/// What a walk calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// The start of a ray and its answer: everything but the walk.
    Ray,
    /// Intersection with a grid's box and setting up of the walk there: t_bi + t_rg.
    Grid,
    /// Reading a voxel and finding the next: t_nc.
    Voxel,
    /// Intersection with the triangles of a list: t_pi for each of them.
    Test,
}

impl Function {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Ray, Self::Grid, Self::Voxel, Self::Test];
}

/// The functions of either kind of query, on any instruction set.
trait Machine {
    fn calls(&self, function: Function) -> u64;
    /// Makes all calls again; how many of them found something.
    fn run(&mut self, function: Function) -> u64;
    fn each_test(&mut self, visit: &mut Visitor<'_>);
}

/// Takes the ray, the triangle, and the largest t of interest at the time.
type Visitor<'v> = dyn FnMut(&Ray, [[f32; 3]; 3], f32) + 'v;

/// The calls of closest-hit queries and of occlusion queries in a scene.
pub struct Tape<'a>([Box<dyn Machine + 'a>; 2]);

struct Record<'a> {
    view: View<'a>,
    closest: &'a [Ray],
    any: &'a [Ray],
}

impl<'a> AnyKernel for Record<'a> {
    type Out = Tape<'a>;
    const BEST: Isa = Isa::Avx512;
    fn run_on<L: Lanes>(self, lanes: L) -> Tape<'a> {
        Tape([
            Box::new(Half::<Closest, L>::record(lanes, self.view, self.closest)),
            Box::new(Half::<Any, L>::record(lanes, self.view, self.any)),
        ])
    }
}

impl<'a> Tape<'a> {
    /// Lets the rays walk, and keeps the arguments of all calls, on the instruction set
    /// in use; rays that cannot hit anything make none. A scene without triangles has
    /// nothing to walk through: no calls.
    #[must_use]
    pub fn record(view: View<'a>, closest: &'a [Ray], any: &'a [Ray]) -> Self {
        let empty = view.header().grids.count == 0;
        let (closest, any) = if empty { (&[][..], &[][..]) } else { (closest, any) };
        fpenv::with_default(|| dispatch(Record { view, closest, any }))
    }

    /// How often a function was called; [`Function::Test`] once a triangle.
    #[must_use]
    pub fn calls(&self, function: Function) -> u64 {
        self.0.iter().map(|half| half.calls(function)).sum()
    }

    /// Makes all calls of a function again, in their order and each ray's state; how many
    /// found something.
    pub fn run(&mut self, function: Function) -> u64 {
        fpenv::with_default(|| self.0.iter_mut().map(|half| half.run(function)).sum())
    }

    /// Visits all tests: ray, triangle, and the largest t of interest before its list.
    pub fn each_test(&mut self, mut visit: impl FnMut(&Ray, [[f32; 3]; 3], f32)) {
        fpenv::with_default(|| self.0.iter_mut().for_each(|half| half.each_test(&mut visit)));
    }
}
