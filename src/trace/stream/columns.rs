//! The walks of all rays in flight, turned around: an array for each component, so that
//! as many rays as a wide row has lanes leave their exit boxes together.
//!
//! It is [`super::super::local::Local`] with voxels as `f32`, in which whole numbers up to
//! 2^24 are exact; its error bound holds here too.

use super::super::bounds::Planes;
use super::super::course::{Course, Mirror};
use super::super::local::Local;
use crate::arena::layout::{BOX_CELLS, BOX_MARGIN, GRID, LIST, TAG_SHIFT};
use crate::simd::Lanes;

/// Rays in flight.
pub(super) const SLOTS: usize = 32;
/// Rows of eight are read wherever one may begin.
const ROOM: usize = SLOTS + 8;

/// One of each axis. A closure might not be compiled for the instruction set.
macro_rules! each {
    ($k:ident => $e:expr) => {
        [
            {
                let $k = 0;
                $e
            },
            {
                let $k = 1;
                $e
            },
            {
                let $k = 2;
                $e
            },
        ]
    };
}

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
    columns: [[f32; 3]; 4],
    nx: f32,
    plane: u32,
    first: u32,
    number: u32,
    out: f32,
}

impl Kept {
    pub const NONE: Self =
        Self { columns: [[0.0; 3]; 4], nx: 0.0, plane: 0, first: 0, number: 0, out: 0.0 };
}

/// Where rays are and how they step, by slot.
pub(super) struct Columns {
    /// Voxel, place at s = 0, voxels per s, last voxel.
    at: [Column; 3],
    start: [Column; 3],
    speed: [Column; 3],
    last: [Column; 3],
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
        last: [ZEROS; 3],
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

    /// A ray enters a grid: [`Columns::arrive`] brings it to its first voxel, at s = 0.
    #[inline(always)]
    pub fn enter<L: Lanes>(&mut self, l: L, slot: usize, local: &Local<L>, course: &Course<L>) {
        let (at, last) = (l.to_f32(local.at), l.to_f32(local.last));
        let (at, start) = (l.array_f32(at), l.array_f32(local.start));
        self.put(slot, &[at, start, l.array_f32(local.speed), l.array_f32(last)]);
        self.nx[slot] = local.nx as f32;
        self.plane[slot] = local.plane;
        self.first[slot] = local.first;
        self.number[slot] = local.number(l, course, local.at);
        self.out[slot] = 0.0;
    }

    #[inline(always)]
    fn put<const N: usize>(&mut self, slot: usize, columns: &[[f32; N]; 4]) {
        let all = [&mut self.at, &mut self.start, &mut self.speed, &mut self.last];
        for (to, from) in all.into_iter().zip(columns) {
            for (to, &x) in to.iter_mut().zip(from) {
                to[slot] = x;
            }
        }
    }

    /// What a ray needs to go on later where its step led.
    #[inline(always)]
    pub fn keep(&self, slot: usize) -> Kept {
        let all = [&self.at, &self.start, &self.speed, &self.last];
        Kept {
            columns: all.map(|c| each!(k => c[k][slot])),
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
    pub fn planes<L: Lanes>(&self, l: L, slot: usize, mirror: &'static Mirror) -> Planes<L> {
        let [near, far] = [&self.box_near, &self.box_far];
        Planes {
            near: [splat(l, &near[0], slot), splat(l, &near[1], slot)],
            far: [splat(l, &far[0], slot), splat(l, &far[1], slot)],
            range: [l.splat_wide(self.s[slot]), l.splat_wide(self.until[slot])],
            mirror,
        }
    }

    /// What slots from `i` on need for a step and for placing boxes, along axis `k`.
    #[inline(always)]
    fn axis<L: Lanes>(&self, l: L, exits: L::Words, k: usize, i: usize) -> Axis<L> {
        let at = l.load_wide(eight(&self.at[k], i));
        let start = l.load_wide(eight(&self.start[k], i));
        let speed = l.load_wide(eight(&self.speed[k], i));
        let pace = l.div_wide(l.splat_wide(1.0), speed);
        let zero = l.sub_wide(l.splat_wide(0.0), l.mul_wide(start, pace));
        let far = self.far.reach(l, exits, k, i);
        Axis { at, start, speed, pace, zero, far }
    }

    /// Where the boxes of lists are: [`Local::boxes`] of slots from `i` on.
    #[inline(always)]
    fn place_boxes<L: Lanes>(&mut self, l: L, exits: L::Words, axes: &[Axis<L>; 3], i: usize) {
        let margin = l.splat_wide(BOX_MARGIN);
        let whole = l.splat_wide(1.0 + 2.0 * BOX_MARGIN);
        let none = l.splat_wide(0.0);
        for (k, &Axis { at, pace, zero, far, .. }) in axes.iter().enumerate() {
            let near = self.near.reach(l, exits, k, i);
            let low = l.sub_wide(l.sub_wide(at, near), margin);
            let side = l.add_wide(l.add_wide(near, far), whole);
            let cell = l.mul_wide(side, l.splat_wide(1.0 / BOX_CELLS as f32));
            let width = l.mul_wide(cell, pace);
            // Cells are counted from the lower end, mirrored or not.
            let far_unit = self.far.unit(l, k, i);
            let last = l.mul_wide(width, l.splat_wide((BOX_CELLS - 1) as f32));
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
    /// voxels it leads to, in `number` if they lie in the grid. `lists`: places the boxes of
    /// lists too.
    #[inline(always)]
    pub fn step<L: Lanes>(&mut self, l: L, i: usize, lists: bool) {
        let exits = l.words(eight(&self.exit, i));
        let axes = each!(k => self.axis(l, exits, k, i));
        if lists {
            self.place_boxes(l, exits, &axes, i);
        }
        let (none, one) = (l.splat_wide(0.0), l.splat_wide(1.0));
        // The planes behind the boxes, and when the rays are there.
        let behind = each!(k => l.add_wide(l.add_wide(axes[k].at, one), axes[k].far));
        let leave = each!(k => l.mul_add_wide(behind[k], axes[k].pace, axes[k].zero));
        let out = l.min_wide(l.min_wide(leave[0], leave[1]), leave[2]);
        let place = each!(k => {
            let Axis { at, start, speed, .. } = axes[k];
            // Off the axis of the exit the position says where, inside the box.
            let low = l.choose_wide(leave[k], out, behind[k], at);
            let high = l.choose_wide(leave[k], out, behind[k], l.sub_wide(behind[k], one));
            let place = l.truncate_wide(l.mul_add_wide(out, speed, start));
            let to = l.min_wide(l.max_wide(place, low), high);
            l.store_wide(to, eight_mut(&mut self.at[k], i));
            let last = l.load_wide(eight(&self.last[k], i));
            let flip = l.choose_wide(none, self.far.unit(l, k, i), none, last);
            l.abs_wide(l.sub_wide(to, flip))
        });
        l.store_wide(out, eight_mut(&mut self.out, i));
        let stop = l.load_wide(eight(&self.stop, i));
        l.store_wide(l.min_wide(out, stop), eight_mut(&mut self.until, i));
        let row = l.mul_add_wide(place[1], l.load_wide(eight(&self.nx, i)), place[0]);
        let (plane, first) = (eight(&self.plane, i), eight(&self.first, i));
        l.numbers(row, place[2], plane, first, eight_mut(&mut self.number, i));
    }

    /// Slots whose words in `exit` are those of lists, and of grids, from `i` on.
    #[inline(always)]
    pub fn tags<L: Lanes>(&self, l: L, i: usize) -> [u32; 2] {
        const { assert!(LIST == 1 && GRID == 2 && TAG_SHIFT == 30) };
        let [grids, lists] = l.tops(l.words(eight(&self.exit, i)));
        [lists, grids]
    }

    /// Which slots from `i` on go on where the step led them: a bit each.
    #[inline(always)]
    pub fn go_on<L: Lanes>(&self, l: L, i: usize) -> u32 {
        let out = l.load_wide(eight(&self.out, i));
        // No NaN passes any of this.
        let mut on = l.at_most(out, l.load_wide(eight(&self.stop, i)));
        for k in 0..3 {
            let last = l.load_wide(eight(&self.last[k], i));
            on &= l.at_most(l.load_wide(eight(&self.at[k], i)), last);
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

/// Voxels, places at s = 0, voxels per s and its reciprocal, s of plane 0, how far exit
/// boxes reach.
#[derive(Clone, Copy)]
struct Axis<L: Lanes> {
    at: L::Wide,
    start: L::Wide,
    speed: L::Wide,
    pace: L::Wide,
    zero: L::Wide,
    far: L::Wide,
}

/// What a slot has there, in all lanes.
#[inline(always)]
fn splat<L: Lanes>(l: L, columns: &[Column; 3], slot: usize) -> [L::Wide; 3] {
    each!(k => l.splat_wide(columns[k][slot]))
}
