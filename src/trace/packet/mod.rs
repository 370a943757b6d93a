//! Rays that come from one point and go much the same way, together.
//!
//! Such rays, those of a camera, lie in a pyramid of four planes with the point as its
//! apex. The pyramid is taken through a grid slab by slab along the axis that all rays
//! follow (Wald et al. 2006, *Ray tracing animated scenes using coherent grid traversal*),
//! or as many slabs at once as it stays in one exit box (`walk`). What is in reach of it
//! is found once for all rays, by boxes (`look`); triangles are then known by the planes
//! through the point and their edges: to sieve a triangle for a ray is to ask on which
//! side of three planes the ray lies (`meet`). What is left is decided exactly, four rays and a
//! triangle at a time, so answers are those of single rays, bit for bit.
//!
//! Where voxels are small beside the pyramid it is halved, down to single rays. Where that
//! happens often rays had better go as others do, so work is counted, and after a packet that
//! took much of it some go apart ([`together::Progress`]).
//!
//! The pyramid is rounded outward. Its error in a grid is that of a few operations in `f64`
//! on coordinates of at most 2^36 voxels, less than 2^-14 of a voxel, and that of the cells,
//! which are rounded to `f32`: at most 2^-13 in a row of 2^11. Footprints are larger than
//! what they are of by 2^-10. Packets that come from farther away are given up.

mod bounds;
mod lines;
mod look;
mod meet;
mod together;
mod walk;

use super::query::Query;
use crate::arena::{Sections, View};
use crate::ray::{NONE, Ray};
use crate::simd::Lanes;
use meet::Due;
pub(super) use meet::largest;
pub(super) use together::{Together, suits};

/// Rays in a packet.
pub(super) const RAYS: usize = 64;

/// Rows of eight are read wherever one may begin.
const ROOM: usize = RAYS + 8;

/// Distances, along an axis, from the rays' origin to the scene's box within which the
/// products of `meet` stay in the range of `f32`.
const RANGE: core::ops::Range<f32> = 1e-12..1e12;

/// How much work a packet is worth, and at which it is given up. Rays apart take some 40
/// times 25 instructions each beside what is the same for both, but wait less for memory.
const ENOUGH: u32 = 28 * RAYS as u32;
const TOO_MUCH: u32 = 4 * ENOUGH;

/// The longest direction along z: a hit whose t rounds to 0 may lie behind the origin by
/// 2^-150 of it, which is then less than the least normal `f32`, and than 2^-10 of any voxel.
const FASTEST: f32 = 1e5;

/// How much the packet's slopes may differ along an axis.
const SPREAD: f32 = 0.25;

/// Triangles that were met lately, by the low bits of their numbers.
const SEEN: usize = 256;

/// Some rays of a packet, one after the other.
#[derive(Clone, Copy)]
struct Part {
    first: usize,
    count: usize,
}

impl Part {
    const ALL: Self = Self { first: 0, count: RAYS };

    fn end(self) -> usize {
        self.first + self.count
    }

    fn halves(self) -> [Self; 2] {
        let count = self.count / 2;
        [Self { count, ..self }, Self { first: self.first + count, count: self.count - count }]
    }
}

/// A triangle that was met, and the rays of which packet that met it, a bit each.
#[derive(Clone, Copy)]
struct Seen {
    number: u32,
    packet: u32,
    rays: u64,
}

impl Seen {
    const NONE: Self = Self { number: 0, packet: 0, rays: 0 };
}

/// What packets use one after the other.
pub(super) struct Tables {
    seen: [Seen; SEEN],
    due: Due,
    /// The number of the packet, from 1 on.
    packet: u32,
    rays: [Ray; RAYS],
}

impl Tables {
    pub const NONE: Self = Self {
        seen: [Seen::NONE; SEEN],
        due: Due::NONE,
        packet: 0,
        rays: [Ray::new([0.0; 3], [0.0; 3]); RAYS],
    };

    /// Whether these rays have not all met a triangle lately, as they now will have.
    #[inline(always)]
    fn is_new(&mut self, number: u32, rays: u64) -> bool {
        let entry = &mut self.seen[number as usize % SEEN];
        let same = entry.number == number && entry.packet == self.packet;
        let before = if same { entry.rays } else { 0 };
        *entry = Seen { number, packet: self.packet, rays: before | rays };
        before & rays != rays
    }
}

/// Rays that share an origin, and what they have found. In what follows z is the axis that
/// they go along, x and y are the two others; distances along z count from the origin,
/// the way the rays go.
pub(super) struct Packet<'a, 't, Q, L> {
    lanes: L,
    sections: Sections<'a>,
    tables: &'t mut Tables,
    queries: [Q; RAYS],
    /// The numbers of the axes x, y and z.
    axes: [usize; 3],
    /// Whether rays descend along z.
    down: bool,
    /// The origin along x, y and z, and the same times the header's `unit`.
    org: [f32; 3],
    place: [f64; 3],
    unit: f64,
    /// The change of x, and of y, with the distance, ray by ray.
    slopes: [[f32; ROOM]; 2],
    /// The change of the distance with t, and the distance at which a ray ends.
    speeds: [f32; ROOM],
    ends: [f32; ROOM],
    /// Rays begin at one t, have the same mask and flags, and skip no triangle.
    plain: bool,
    /// Rays may end sooner than was known.
    nearer: bool,
    /// What has been done, in some 25 instructions.
    work: u32,
    /// The packet is to be given up.
    lost: bool,
}

/// Eight from number `i` on.
#[inline(always)]
fn eight<T>(column: &[T; ROOM], i: usize) -> &[T; 8] {
    column[i % RAYS..].first_chunk().expect("there is room for eight more")
}

#[inline(always)]
fn eight_mut<T>(column: &mut [T; ROOM], i: usize) -> &mut [T; 8] {
    column[i % RAYS..].first_chunk_mut().expect("there is room for eight more")
}

/// A distance that a hit at `t` does not exceed.
#[inline(always)]
fn distance(t: f32, speed: f32) -> f32 {
    let x = t * speed;
    x + x * (4.0 * f32::EPSILON) + f32::MIN_POSITIVE
}

impl<'a, 't, Q: Query, L: Lanes> Packet<'a, 't, Q, L> {
    #[inline(always)]
    fn new(l: L, view: &View<'a>, tables: &'t mut Tables) -> Option<Self> {
        let header = view.header();
        let rays = &tables.rays;
        let Ray { org, dir, .. } = rays[0];
        let size = dir.map(f32::abs);
        let z = if size[2] >= size[0] && size[2] >= size[1] {
            2
        } else {
            usize::from(size[1] >= size[0])
        };
        let axes = [(z + 1) % 3, (z + 2) % 3, z];
        let down = dir[z] < 0.0;
        let mut alike = org.iter().all(|x| x.is_finite());
        let Ray { tmin, mask, flags, .. } = rays[0];
        let mut plain = true;
        for ray in rays {
            plain &= (ray.tmin == tmin) & (ray.mask == mask) & (ray.flags == flags);
            plain &= (ray.skip_geom == NONE) & (ray.skip_prim == NONE);
            alike &= (ray.org == org) & (ray.tmin >= 0.0) & (ray.tmin <= ray.tmax);
            alike &= ray.tmin < f32::INFINITY;
        }
        if !alike {
            return None;
        }
        let (mut slopes, mut speeds, mut ends) = ([[0.0; ROOM]; 2], [0.0; ROOM], [0.0; ROOM]);
        let mut bad = 0;
        let zero = l.splat_wide(0.0);
        let mut i = 0;
        while i < RAYS {
            let dirs = l.columns(|k| &rays[(i + k) % RAYS].rows()[1]);
            let [x, y] = [dirs[axes[0]], dirs[axes[1]]];
            let speed = if down { l.sub_wide(zero, dirs[z]) } else { dirs[z] };
            l.store_wide(speed, eight_mut(&mut speeds, i));
            l.store_wide(l.div_wide(x, speed), eight_mut(&mut slopes[0], i));
            l.store_wide(l.div_wide(y, speed), eight_mut(&mut slopes[1], i));
            bad |= l.at_most(speed, zero);
            i += L::WIDE;
        }
        for (i, ray) in rays.iter().enumerate() {
            let [x, y] = [slopes[0][i], slopes[1][i]];
            // No NaN passes.
            let steep = (x.abs() <= 2.0) & (y.abs() <= 2.0) & (speeds[i] <= FASTEST);
            let near = ((x - slopes[0][0]).abs() <= SPREAD) & ((y - slopes[1][0]).abs() <= SPREAD);
            bad |= u32::from(!(steep & near));
            ends[i] = distance(ray.tmax, speeds[i]);
        }
        if bad != 0 {
            return None;
        }
        let far = (0..3).fold(0.0, |far: f32, k| {
            let [below, above] = [org[k] - header.lower[k], header.upper[k] - org[k]];
            far.max(below).max(above)
        });
        if !RANGE.contains(&far) {
            return None;
        }
        let org = axes.map(|k| org[k]);
        tables.packet = tables.packet.wrapping_add(1);
        tables.due = Due::NONE;
        Some(Self {
            lanes: l,
            sections: view.sections(),
            queries: core::array::from_fn(|i| Q::new(&tables.rays[i])),
            tables,
            axes,
            down,
            org,
            place: org.map(|x| f64::from(x) * header.unit),
            unit: header.unit,
            slopes,
            speeds,
            ends,
            plain,
            nearer: false,
            work: 0,
            lost: false,
        })
    }

    #[inline(always)]
    fn run(&mut self) {
        let from =
            self.tables.rays.iter().zip(&self.speeds).fold(f32::INFINITY, |from, (ray, speed)| {
                let x = ray.tmin * speed;
                from.min(x - x * (4.0 * f32::EPSILON) - f32::MIN_POSITIVE)
            });
        self.grid_apart(0, Part::ALL, f64::from(from.max(0.0)));
    }
}
