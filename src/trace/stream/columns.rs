//! The walks of all rays in flight, turned around: an array for each component, so that
//! as many rays as a wide row has lanes leave their exit boxes together.
//!
//! It is [`super::super::local::Local`] with voxels as `f32`, in which whole numbers up to
//! 2^24 are exact; its error bound holds here too.

use super::super::course::{Course, Mirror};
use super::super::local::{Boxes, Local};
use crate::arena::layout::{BOX_CELLS, BOX_MARGIN};
use crate::simd::Lanes;

/// Rays in flight.
pub(super) const SLOTS: usize = 32;
/// Rows of eight are read wherever one may begin.
const ROOM: usize = SLOTS + 8;

type Column = [f32; ROOM];
type Words = [u32; ROOM];

const ZEROS: Column = [0.0; ROOM];

/// Eight from number `i` on.
#[inline(always)]
fn eight<T>(column: &[T; ROOM], i: usize) -> &[T; 8] {
    column[i % SLOTS..].first_chunk().expect("there is room for eight more")
}

#[inline(always)]
fn eight_mut<T>(column: &mut [T; ROOM], i: usize) -> &mut [T; 8] {
    column[i % SLOTS..].first_chunk_mut().expect("there is room for eight more")
}

/// Bounds of exit boxes that rays come to first, or last; see
/// [`super::super::course::Bounds`].
struct Sides {
    mask: [Words; 3],
    unit: [Column; 3],
}

impl Sides {
    const NONE: Self = Self { mask: [[0; ROOM]; 3], unit: [ZEROS; 3] };

    /// How far an exit box reaches along axis `k`, in voxels.
    #[inline(always)]
    fn reach<L: Lanes>(&self, l: L, exits: L::Words, k: usize, i: usize) -> L::Wide {
        let bits = l.field(exits, eight(&self.mask[k], i));
        l.mul_wide(bits, l.abs_wide(self.unit(l, k, i)))
    }

    #[inline(always)]
    fn unit<L: Lanes>(&self, l: L, k: usize, i: usize) -> L::Wide {
        l.load_wide(eight(&self.unit[k], i))
    }
}

/// What a ray keeps of its walk through a grid while it is in one below.
#[derive(Clone, Copy)]
pub(super) struct Kept {
    columns: [[f32; 3]; 7],
    nx: f32,
    plane: u32,
    first: u32,
    number: u32,
    out: f32,
}

impl Kept {
    pub const NONE: Self =
        Self { columns: [[0.0; 3]; 7], nx: 0.0, plane: 0, first: 0, number: 0, out: 0.0 };
}

/// Where rays are and how they step, by slot.
pub(super) struct Columns {
    /// Voxel, place at s = 0, voxels per s and its reciprocal, s of plane 0, last
    /// voxel, and that again on axes along which the ray descends (0 on others).
    at: [Column; 3],
    start: [Column; 3],
    speed: [Column; 3],
    pace: [Column; 3],
    zero: [Column; 3],
    last: [Column; 3],
    flip: [Column; 3],
    near: Sides,
    far: Sides,
    /// Voxels in a row and in a plane, number of the first, and of the ray's.
    nx: Column,
    plane: Words,
    first: Words,
    pub number: Words,
    /// Since when it is in its voxel, when it leaves that's exit box, when it stops.
    s: Column,
    out: Column,
    pub stop: Column,
    pub exit: Words,
    /// [`Boxes`] of its voxel.
    box_near: [[Column; 3]; 2],
    box_far: [[Column; 3]; 2],
    until: Column,
}

impl Columns {
    pub const NONE: Self = Self {
        at: [ZEROS; 3],
        start: [ZEROS; 3],
        speed: [ZEROS; 3],
        pace: [ZEROS; 3],
        zero: [ZEROS; 3],
        last: [ZEROS; 3],
        flip: [ZEROS; 3],
        near: Sides::NONE,
        far: Sides::NONE,
        nx: ZEROS,
        plane: [0; ROOM],
        first: [0; ROOM],
        number: [0; ROOM],
        s: ZEROS,
        out: ZEROS,
        stop: ZEROS,
        exit: [0; ROOM],
        box_near: [[ZEROS; 3]; 2],
        box_far: [[ZEROS; 3]; 2],
        until: ZEROS,
    };

    /// A ray begins its course.
    #[inline(always)]
    pub fn begin(&mut self, slot: usize, mirror: &Mirror) {
        for k in 0..3 {
            self.near.mask[k][slot] = mirror.near.mask[k][0];
            self.near.unit[k][slot] = mirror.near.unit[k];
            self.far.mask[k][slot] = mirror.far.mask[k][0];
            self.far.unit[k][slot] = mirror.far.unit[k];
        }
    }

    /// A ray enters a grid; what follows is a step that has led to its first voxel.
    #[inline(always)]
    pub fn enter<L: Lanes>(&mut self, l: L, slot: usize, local: &Local<L>, course: &Course<L>) {
        let (at, last) = (l.to_f32(local.at), l.to_f32(local.last));
        let flip = l.mask_f32(last, course.down);
        let columns = [at, local.start, local.speed, local.pace, local.zero, last, flip];
        self.put(slot, &columns.map(|a| l.array_f32(a)));
        self.nx[slot] = local.nx as f32;
        self.plane[slot] = local.plane;
        self.first[slot] = local.first;
        self.number[slot] = local.number(l, course, local.at);
        self.out[slot] = 0.0;
    }

    #[inline(always)]
    fn put<const N: usize>(&mut self, slot: usize, columns: &[[f32; N]; 7]) {
        for k in 0..3 {
            self.at[k][slot] = columns[0][k];
            self.start[k][slot] = columns[1][k];
            self.speed[k][slot] = columns[2][k];
            self.pace[k][slot] = columns[3][k];
            self.zero[k][slot] = columns[4][k];
            self.last[k][slot] = columns[5][k];
            self.flip[k][slot] = columns[6][k];
        }
    }

    /// What a ray needs to go on later where its step led.
    #[inline(always)]
    pub fn keep(&self, slot: usize) -> Kept {
        let all =
            [&self.at, &self.start, &self.speed, &self.pace, &self.zero, &self.last, &self.flip];
        Kept {
            columns: all.map(|c| [c[0][slot], c[1][slot], c[2][slot]]),
            nx: self.nx[slot],
            plane: self.plane[slot],
            first: self.first[slot],
            number: self.number[slot],
            out: self.out[slot],
        }
    }

    /// Goes on there.
    #[inline(always)]
    pub fn restore(&mut self, slot: usize, kept: &Kept) {
        self.put(slot, &kept.columns);
        self.nx[slot] = kept.nx;
        self.plane[slot] = kept.plane;
        self.first[slot] = kept.first;
        self.number[slot] = kept.number;
        self.out[slot] = kept.out;
    }

    /// The part of a ray, in s, in the exit box that it has just left.
    #[inline(always)]
    pub fn range(&self, slot: usize) -> [f32; 2] {
        let (out, stop) = (self.out[slot], self.stop[slot]);
        [self.s[slot], if out < stop { out } else { stop }]
    }

    /// The boxes of a slot's list.
    #[inline(always)]
    pub fn boxes(&self, slot: usize, mirror: &'static Mirror) -> Boxes {
        let row = |c: &[Column; 3]| [c[0][slot], c[1][slot], c[2][slot], 0.0];
        Boxes {
            near: [row(&self.box_near[0]), row(&self.box_near[1])],
            far: [row(&self.box_far[0]), row(&self.box_far[1])],
            mirror,
            range: [self.s[slot], self.until[slot]],
        }
    }

    /// Where the boxes of lists are: [`Local::boxes`] of slots from `i` on, before their
    /// [`Columns::step`].
    #[inline(always)]
    pub fn place_boxes<L: Lanes>(&mut self, l: L, i: usize) {
        let exits = l.words(eight(&self.exit, i));
        let margin = l.splat_wide(BOX_MARGIN);
        let whole = l.splat_wide(1.0 + 2.0 * BOX_MARGIN);
        for k in 0..3 {
            let near = self.near.reach(l, exits, k, i);
            let far = self.far.reach(l, exits, k, i);
            let [at, pace] = [&self.at[k], &self.pace[k]].map(|c| l.load_wide(eight(c, i)));
            let zero = l.load_wide(eight(&self.zero[k], i));
            let low = l.sub_wide(l.sub_wide(at, near), margin);
            let side = l.add_wide(l.add_wide(near, far), whole);
            let cell = l.mul_wide(side, l.splat_wide(1.0 / BOX_CELLS as f32));
            let width = l.mul_wide(cell, pace);
            // Cells are counted from the lower end, mirrored or not.
            let far_unit = self.far.unit(l, k, i);
            let last = l.mul_wide(width, l.splat_wide((BOX_CELLS - 1) as f32));
            let none = l.splat_wide(0.0);
            let last = l.choose_wide(none, far_unit, none, last);
            let start = l.add_wide(l.mul_add_wide(low, pace, zero), last);
            let [scale, offset] = &mut self.box_near;
            l.store_wide(l.mul_wide(width, self.near.unit(l, k, i)), eight_mut(&mut scale[k], i));
            l.store_wide(start, eight_mut(&mut offset[k], i));
            let [scale, offset] = &mut self.box_far;
            l.store_wide(l.mul_wide(width, far_unit), eight_mut(&mut scale[k], i));
            l.store_wide(l.add_wide(start, width), eight_mut(&mut offset[k], i));
        }
    }

    /// Leaves the exit boxes of slots from `i` on: [`Local::step`] and the numbers of the
    /// voxels it leads to, in `number` if they lie in the grid.
    #[inline(always)]
    pub fn step<L: Lanes>(&mut self, l: L, i: usize) {
        let exits = l.words(eight(&self.exit, i));
        let one = l.splat_wide(1.0);
        let at = each(|k| l.load_wide(eight(&self.at[k], i)));
        // The planes behind the boxes, and when the rays are there.
        let behind = each(|k| l.add_wide(l.add_wide(at[k], one), self.far.reach(l, exits, k, i)));
        let leave = each(|k| {
            let [pace, zero] = [&self.pace[k], &self.zero[k]].map(|c| l.load_wide(eight(c, i)));
            l.mul_add_wide(behind[k], pace, zero)
        });
        let out = l.min_wide(l.min_wide(leave[0], leave[1]), leave[2]);
        let to = each(|k| {
            let [speed, start] = [&self.speed[k], &self.start[k]].map(|c| l.load_wide(eight(c, i)));
            // Off the axis of the exit the position says where, inside the box.
            let low = l.choose_wide(leave[k], out, behind[k], at[k]);
            let high = l.choose_wide(leave[k], out, behind[k], l.sub_wide(behind[k], one));
            let place = l.truncate_wide(l.mul_add_wide(out, speed, start));
            l.min_wide(l.max_wide(place, low), high)
        });
        let place = each(|k| {
            l.store_wide(to[k], eight_mut(&mut self.at[k], i));
            l.abs_wide(l.sub_wide(to[k], l.load_wide(eight(&self.flip[k], i))))
        });
        l.store_wide(out, eight_mut(&mut self.out, i));
        let stop = l.load_wide(eight(&self.stop, i));
        l.store_wide(l.min_wide(out, stop), eight_mut(&mut self.until, i));
        let row = l.mul_add_wide(place[1], l.load_wide(eight(&self.nx, i)), place[0]);
        let (plane, first) = (eight(&self.plane, i), eight(&self.first, i));
        l.numbers(row, place[2], plane, first, eight_mut(&mut self.number, i));
    }

    /// Which slots from `i` on go on where the step led them: a bit each.
    #[inline(always)]
    pub fn go_on<L: Lanes>(&self, l: L, i: usize) -> u32 {
        let out = l.load_wide(eight(&self.out, i));
        // No NaN passes any of this.
        let mut on = l.at_most(out, l.load_wide(eight(&self.stop, i)));
        for k in 0..3 {
            let [at, last] = [&self.at[k], &self.last[k]].map(|c| l.load_wide(eight(c, i)));
            on &= l.at_most(at, last);
        }
        on
    }

    /// [`Columns::go_on`] of one slot.
    #[inline(always)]
    pub fn goes_on(&self, slot: usize) -> bool {
        let inside = (0..3).all(|k| self.at[k][slot] <= self.last[k][slot]);
        (self.out[slot] <= self.stop[slot]) & inside
    }

    /// All have arrived.
    #[inline(always)]
    pub fn arrive(&mut self) {
        self.s = self.out;
    }
}

/// One of each axis.
#[inline(always)]
fn each<T>(f: impl FnMut(usize) -> T) -> [T; 3] {
    let mut f = f;
    [f(0), f(1), f(2)]
}
