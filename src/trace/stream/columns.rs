//! The walks of all rays in flight, turned around: an array for each component, so that
//! as many rays as a wide row has lanes leave their exit boxes together (`step`).
//!
//! It is [`super::super::local::Local`] with voxels as `f32`, in which whole numbers up to
//! 2^24 are exact; its error bound holds here too.

use super::super::bounds::Planes;
use super::super::course::Mirror;
use super::super::local::Local;
use crate::simd::Lanes;

/// Rays in flight.
pub(super) const SLOTS: usize = 32;
/// Rows of eight are read wherever one may begin.
const ROOM: usize = SLOTS + 8;

mod step;

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
    /// [`super::super::local::Boxes`] of its voxel, and the end of their range.
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

    /// A ray goes on in other coordinates than before.
    #[inline(always)]
    pub fn turn(&mut self, slot: usize, mirror: &Mirror) {
        for k in 0..3 {
            self.near.mask[k][slot] = mirror.near.mask[k][0];
            self.near.unit[k][slot] = mirror.near.unit[k];
            self.far.mask[k][slot] = mirror.far.mask[k][0];
            self.far.unit[k][slot] = mirror.far.unit[k];
        }
    }

    /// A ray enters a grid: [`Columns::arrive`] brings it to its first voxel, at s = 0.
    #[inline(always)]
    pub fn enter<L: Lanes>(&mut self, l: L, slot: usize, local: &Local<L>) {
        let (at, last) = (l.to_f32(local.at), l.to_f32(local.last));
        let (at, start) = (l.array_f32(at), l.array_f32(local.start));
        self.put(slot, &[at, start, l.array_f32(local.speed), l.array_f32(last)]);
        self.nx[slot] = local.nx as f32;
        self.plane[slot] = local.plane;
        self.first[slot] = local.first;
        self.number[slot] = local.number(l, local.at);
        self.out[slot] = 0.0;
    }

    /// Writes what [`Kept::columns`] keeps.
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

    /// [`Columns::who_go_on`] for one slot.
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

/// What a slot has there, in all lanes.
#[inline(always)]
fn splat<L: Lanes>(l: L, columns: &[Column; 3], slot: usize) -> [L::Wide; 3] {
    each!(k => l.splat_wide(columns[k][slot]))
}
