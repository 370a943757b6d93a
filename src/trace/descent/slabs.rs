//! A ray and the boxes of a node's parts: which it meets, and where it enters them.

use super::before;
use crate::arena::node::{AnyNode, Node, PARTS, QuantizedNode};
use crate::arena::{Bounds, Sections};
use crate::ray::Ray;
use crate::simd::Lanes;

/// 16 e ([`super`]).
const MARGIN: f32 = 1.0 / (1 << 20) as f32;
/// 2^-115.
const LEAST_SPEED: f32 = f32::from_bits((127 - 115) << 23);

/// Nodes whose boxes a descent can read.
pub trait Boxes: AnyNode {
    /// Two rows along each axis of the bounds of the parts, those from `at` on, of the node that `part`
    /// names.
    fn bounds<L: Lanes>(
        l: L,
        sections: &Sections<'_>,
        part: u32,
        rows: [&[Bounds<'_, Self>; 3]; 2],
        at: usize,
    ) -> [[L::Wide; 3]; 2];
}

impl Boxes for Node {
    #[inline(always)]
    fn bounds<L: Lanes>(
        l: L,
        _: &Sections<'_>,
        part: u32,
        [near, far]: [&[Bounds<'_, Self>; 3]; 2],
        at: usize,
    ) -> [[L::Wide; 3]; 2] {
        [
            each!(k => l.load_from(near[k].row(part), at)),
            each!(k => l.load_from(far[k].row(part), at)),
        ]
    }
}

impl Boxes for QuantizedNode {
    /// So many steps are an `f32`, so that it is one rounding to the same number on every processor,
    /// that of the build.
    #[inline(always)]
    fn bounds<L: Lanes>(
        l: L,
        sections: &Sections<'_>,
        part: u32,
        [near, far]: [&[Bounds<'_, Self>; 3]; 2],
        at: usize,
    ) -> [[L::Wide; 3]; 2] {
        let known = sections.node::<Self>(part);
        let step = each!(k => l.splat_wide(known.step(k)));
        let origin = each!(k => l.splat_wide(known.origin[k]));
        let near = each!(k => l.bytes_from(near[k].row(part), at));
        let far = each!(k => l.bytes_from(far[k].row(part), at));
        [
            each!(k => l.mul_add_wide(near[k], step[k], origin[k])),
            each!(k => l.mul_add_wide(far[k], step[k], origin[k])),
        ]
    }
}

/// A ray as boxes want it: numbers for each axis, of which the fourth is something else.
#[derive(Clone, Copy)]
pub struct Line<'a, N> {
    /// Pace, and the tau below which none is of interest; where the ray is at plane 0 as it enters,
    /// and as it leaves, the fourth of which mean nothing.
    pub rows: [[f32; 4]; 3],
    /// Which bounds of a node it comes to first, and last.
    near: [Bounds<'a, N>; 3],
    far: [Bounds<'a, N>; 3],
}

/// The same, each number in all lanes.
#[derive(Clone, Copy)]
pub struct Slabs<'a, N, L: Lanes> {
    pace: [L::Wide; 3],
    enter: [L::Wide; 3],
    leave: [L::Wide; 3],
    from: L::Wide,
    near: [Bounds<'a, N>; 3],
    far: [Bounds<'a, N>; 3],
}

/// A ray in the tree's coordinates: the way from where it begins to their origin, its direction, and
/// the sizes of that; fourth lanes mean nothing.
#[derive(Clone, Copy)]
pub struct Start<L: Lanes> {
    pub way: L::F32,
    pub dir: L::F32,
    pub speed: L::F32,
}

impl<'a, N: Boxes> Line<'a, N> {
    #[inline(always)]
    pub fn new<L: Lanes>(
        l: L,
        sections: &Sections<'a>,
        start: &Start<L>,
        ray: &Ray,
        unit: f32,
    ) -> Self {
        let &Start { way, dir, speed } = start;
        let pace = l.div_f32(l.splat_f32(1.0), l.max_f32(speed, l.splat_f32(LEAST_SPEED)));
        let room = l.add_f32(l.abs_f32(way), l.splat_f32(2.0));
        let room = l.mul_f32(l.mul_f32(room, pace), l.splat_f32(MARGIN));
        let pace = l.sign_f32(pace, dir);
        let at = l.mul_f32(way, pace);
        let signs = l.signs(dir) as usize;
        let mut rows =
            [l.array_f32(pace), l.array_f32(l.sub_f32(at, room)), l.array_f32(l.add_f32(at, room))];
        rows[0][3] = before(l, ray.tmin, unit);
        Self { rows, near: sections.bounds(signs), far: sections.bounds(!signs) }
    }
}

impl<'a, N: Boxes, L: Lanes> Slabs<'a, N, L> {
    #[inline(always)]
    pub fn new(l: L, line: &Line<'a, N>) -> Self {
        Self::of(l, &line.rows, line.near, line.far)
    }

    /// Those of a line with these rows.
    #[inline(always)]
    pub fn of(
        l: L,
        [pace, enter, leave]: &[[f32; 4]; 3],
        near: [Bounds<'a, N>; 3],
        far: [Bounds<'a, N>; 3],
    ) -> Self {
        Self {
            pace: each!(k => l.splat_wide(pace[k])),
            enter: each!(k => l.splat_wide(enter[k])),
            leave: each!(k => l.splat_wide(leave[k])),
            from: l.splat_wide(pace[3]),
            near,
            far,
        }
    }

    /// A bit for each part of the node that `part` names that the ray meets up to `to`, and where it
    /// enters these: in one wide row, or two.
    #[inline(always)]
    pub fn meet(&self, l: L, sections: &Sections<'_>, part: u32, to: f32) -> (u32, [L::Wide; 2]) {
        let [enter, last] = self.ends(l, sections, part, to, 0);
        let met = l.at_most(enter, last);
        if L::WIDE == PARTS {
            return (met, [enter, enter]);
        }
        let [after, last] = self.ends(l, sections, part, to, L::WIDE);
        (met | l.at_most(after, last) << L::WIDE, [enter, after])
    }

    /// Where the ray enters the first [`Lanes::WIDE`] of these parts, infinity for those that it
    /// does not meet, and whether it meets any.
    #[inline(always)]
    pub fn entries(&self, l: L, sections: &Sections<'_>, part: u32, to: f32) -> (L::Wide, bool) {
        let [enter, last] = self.ends(l, sections, part, to, 0);
        let entries = l.choose_wide(enter, last, enter, l.splat_wide(f32::INFINITY));
        (entries, l.at_most(enter, last) != 0)
    }

    /// Where the ray is in all planes of the parts from `at` on, and up to where.
    #[inline(always)]
    fn ends(&self, l: L, sections: &Sections<'_>, part: u32, to: f32, at: usize) -> [L::Wide; 2] {
        let [near, far] = N::bounds(l, sections, part, [&self.near, &self.far], at);
        let enter = each!(k => l.mul_add_wide(near[k], self.pace[k], self.enter[k]));
        let leave = each!(k => l.mul_add_wide(far[k], self.pace[k], self.leave[k]));
        let first = l.max_wide(l.max_wide(enter[0], enter[1]), l.max_wide(enter[2], self.from));
        let last = l.min_wide(leave[0], leave[1]);
        [first, l.min_wide(last, l.min_wide(leave[2], l.splat_wide(to)))]
    }
}
