//! A first look at a list: which of its references' boxes does the ray meet?
//!
//! Boxes lie beside the references, eight of them in as many words as one row of one
//! triangle, so that most of what a list refers to is never touched.
//!
//! A hit at s in `[from, to]` has its box met: there the walk is within 2^-10 of a
//! voxel of the ray (`local`), on each axis, and boxes are padded by 2^-9
//! (`build::bounds`). What is left, 2^-10 or 2^14 e at e = 2^-24, is more than the
//! rounding of a plane here: of the place, the width and the sum, `3 n e`, with n at
//! most 2^11.

use super::counters::Count;
use super::course::Mirror;
use super::local::Boxes;
use crate::arena::Sections;
use crate::arena::layout::{GRID_BIT, LIST_HEAD};
use crate::simd::{Kernel, Lanes};

/// References looked at in one go.
pub(super) const BATCH: usize = 32;

/// Some references of a list and their boxes, as places in the references' section.
#[derive(Clone, Copy)]
pub(super) struct Part {
    refs: u32,
    boxes: u32,
    len: u32,
}

impl Part {
    /// Of the list of `len` references at `place`, those from number `at` on, [`BATCH`] at
    /// most.
    #[inline(always)]
    pub fn new(place: u32, len: u32, at: u32) -> Self {
        let refs = place + LIST_HEAD as u32 + at;
        Self { refs, boxes: refs + len, len: (len - at).min(BATCH as u32) }
    }
}

/// References that a ray may have to do with.
#[derive(Clone, Copy)]
pub(super) struct Few {
    /// With room for writing eight at a time.
    refs: [u32; BATCH + 8],
    len: usize,
}

impl Few {
    /// None yet.
    pub const NONE: Self = Self { refs: [0; BATCH + 8], len: 0 };

    /// Those of a part of a list whose boxes the ray meets; each where tests are
    /// counted. Not inlined: it needs all registers for itself.
    #[inline(never)]
    pub fn fill<C: Count, L: Lanes>(
        &mut self,
        l: L,
        sections: &Sections<'_>,
        part: Part,
        boxes: &Boxes,
    ) {
        if C::COUNTS {
            l.run(Fill::<true> { few: self, sections, part, boxes });
        } else {
            l.run(Fill::<false> { few: self, sections, part, boxes });
        }
    }

    /// All of them.
    #[inline(always)]
    pub fn refs(&self) -> &[u32] {
        &self.refs[..self.len]
    }

    /// Triangles and grids.
    #[inline(always)]
    pub fn split(&self) -> (&[u32], &[u32]) {
        let refs = self.refs();
        let grids = refs.last().is_some_and(|r| r & GRID_BIT != 0);
        let at = if grids { refs.partition_point(|r| r & GRID_BIT == 0) } else { refs.len() };
        refs.split_at(at)
    }
}

/// [`Few::fill`], compiled for an instruction set.
struct Fill<'w, 'a, const ALL: bool> {
    few: &'w mut Few,
    sections: &'w Sections<'a>,
    part: Part,
    boxes: &'w Boxes,
}

impl<const ALL: bool, L: Lanes> Kernel<L> for Fill<'_, '_, ALL> {
    type Out = ();
    #[inline(always)]
    fn run(self, l: L) {
        let Part { refs, boxes, len } = self.part;
        let planes = Planes::new(l, self.boxes);
        let sections = *self.sections;
        let (mut at, mut count) = (0, 0);
        while at < len {
            let all = u32::MAX >> (32 - (len - at).min(L::WIDE as u32));
            let met = if ALL { all } else { all & planes.met(l, sections.eight(boxes + at)) };
            if let Some(to) = self.few.refs[count..].first_chunk_mut() {
                l.compress(sections.eight(refs + at), met, to);
            }
            count = (count + met.count_ones() as usize).min(BATCH);
            at += L::WIDE as u32;
        }
        self.few.len = count;
    }
}

/// [`Boxes`] for [`Lanes::WIDE`] of them.
pub(super) struct Planes<L: Lanes> {
    pub near: [[L::Wide; 3]; 2],
    pub far: [[L::Wide; 3]; 2],
    pub range: [L::Wide; 2],
    pub mirror: &'static Mirror,
}

/// The first three numbers, each in all lanes.
#[inline(always)]
pub(super) fn splat3<L: Lanes>(l: L, a: &[f32; 4]) -> [L::Wide; 3] {
    [l.splat_wide(a[0]), l.splat_wide(a[1]), l.splat_wide(a[2])]
}

impl<L: Lanes> Planes<L> {
    #[inline(always)]
    pub fn new(l: L, boxes: &Boxes) -> Self {
        Self {
            near: [splat3(l, &boxes.near[0]), splat3(l, &boxes.near[1])],
            far: [splat3(l, &boxes.far[0]), splat3(l, &boxes.far[1])],
            range: [l.splat_wide(boxes.range[0]), l.splat_wide(boxes.range[1])],
            mirror: boxes.mirror,
        }
    }

    /// One bit for each box that the ray meets.
    #[inline(always)]
    pub fn met(&self, l: L, boxes: &[u32; 8]) -> u32 {
        let words = l.words(boxes);
        let [mut near, mut far] = self.range;
        let mut k = 0;
        while k < 3 {
            let first = l.field(words, &self.mirror.near.mask[k]);
            let last = l.field(words, &self.mirror.far.mask[k]);
            near = l.max_wide(near, l.mul_add_wide(first, self.near[0][k], self.near[1][k]));
            far = l.min_wide(far, l.mul_add_wide(last, self.far[0][k], self.far[1][k]));
            k += 1;
        }
        l.at_most(near, far)
    }
}
