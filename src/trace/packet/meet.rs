//! Which triangles which rays of a packet may hit.
//!
//! Seen from the rays' origin, corners A and B span a plane with normal A x (B - A); a ray
//! pierces the triangle only if it is on one side of all three. With e = 2^-24, M the
//! largest coordinate of the corners and m that of the edges, a component of a normal is
//! off by at most `8 e M m` (each factor 1, product 1, difference 1, of products of at most
//! M m), and the product with a direction (x, y, 1), |x| and |y| at most 2 and off by 1, by
//! `76 e M m`. `128 e M m` is used, and for underflow 1e-36 more.
//!
//! The distance at which a ray meets the triangle's plane is A . N over (x, y, 1) . N, N the
//! product of two edges. These are off, likewise, by at most `48 e M m^2` and `76 e m^2`;
//! `128 e` is used for both.

use super::bounds::Bounds;
use super::lines::Lines;
use super::{Packet, Part, RAYS, distance, eight};
use crate::arena::layout::Triangle;
use crate::ray::Ray;
use crate::simd::{Kernel, Lanes};
use crate::trace::query::{Query, decide, visible};
use crate::triangle::{Apex, Line, Met};

/// Bounds of the error of a product, over M m and as it is.
const ERROR: f32 = 128.0 / (1u32 << 24) as f32;
const LEAST: f32 = 1e-36;

/// Triangles to be met.
pub(super) struct Due {
    numbers: [u32; Self::MOST + 8],
    len: usize,
}

impl Due {
    const MOST: usize = 64;
    pub const NONE: Self = Self { numbers: [0; Self::MOST + 8], len: 0 };

    /// Whether there is no room for more now.
    #[inline(always)]
    pub fn push(&mut self, number: u32) -> bool {
        self.numbers[self.len % Self::MOST] = number;
        self.len += 1;
        self.len == Self::MOST
    }
}

/// [`Packet::meet`], compiled for the packet's instruction set.
struct Meet<'w, 'a, 't, Q, L> {
    packet: &'w mut Packet<'a, 't, Q, L>,
    part: Part,
    bounds: Bounds,
}

impl<Q: Query, L: Lanes> Kernel<L> for Meet<'_, '_, '_, Q, L> {
    type Out = ();
    #[inline(always)]
    fn run(self, _: L) {
        self.packet.meet(self.part, self.bounds);
    }
}

/// Some triangles, lane by lane.
struct Few {
    /// Normals, edge by edge, x, y and z of each.
    normals: [[[f32; 8]; 3]; 3],
    /// The error of a product with one of them.
    errors: [f32; 8],
    /// The triangle's own normal, the error of a product with it, and the least product of
    /// it with a corner.
    plane: [[f32; 8]; 3],
    plane_errors: [f32; 8],
    heights: [f32; 8],
    /// The least distance of a corner.
    nearest: [f32; 8],
}

impl Few {
    const NONE: Self = Self {
        normals: [[[0.0; 8]; 3]; 3],
        errors: [0.0; 8],
        plane: [[0.0; 8]; 3],
        plane_errors: [0.0; 8],
        heights: [0.0; 8],
        nearest: [0.0; 8],
    };
}

impl<Q: Query, L: Lanes> Packet<'_, '_, Q, L> {
    /// Meets what is due.
    #[inline(always)]
    pub(super) fn meet_apart(&mut self, part: Part, lines: &Lines) {
        if self.tables.due.len > 0 {
            self.meet_all(part, lines.bounds);
        }
    }

    #[inline(never)]
    fn meet_all(&mut self, part: Part, bounds: Bounds) {
        let lanes = self.lanes;
        lanes.run(Meet { packet: self, part, bounds })
    }

    #[inline(always)]
    fn meet(&mut self, part: Part, bounds: Bounds) {
        let mut few = Few::NONE;
        let len = core::mem::take(&mut self.tables.due.len);
        self.work = self.work.saturating_add(len as u32);
        let end = self.end(part) as f32;
        let mut at = 0;
        while at < len {
            let mut left = self.sieve(&mut few, at, bounds.slopes, end);
            left &= !u32::MAX.checked_shl((len - at) as u32).unwrap_or(0);
            while left != 0 {
                let i = left.trailing_zeros() as usize % 8;
                left &= left - 1;
                self.work += 1 + (part.count / 16) as u32;
                let mut rays = self.sides(&few, i, part) & bounds.rays;
                if rays == 0 {
                    continue;
                }
                let number = self.tables.due.numbers[at + i];
                let triangle = self.sections.triangle(number);
                if self.plain && !visible(&self.tables.rays[0], triangle) {
                    continue;
                }
                let apex = Line::new(&self.tables.rays[0]).apex(triangle);
                while rays != 0 {
                    rays = self.decide_some(rays, &apex, triangle, number);
                }
            }
            at += L::WIDE;
        }
    }

    /// Looks up triangles, from number `at` of those due: a bit for each that is in reach.
    #[inline(always)]
    fn sieve(&self, few: &mut Few, at: usize, slopes: [[f32; 2]; 2], end: f32) -> u32 {
        let l = self.lanes;
        let rows = l.thrice(self.tables.due.numbers[at..].first_chunk::<8>().map_or(&[], |a| a));
        let [x, y, z] = [0, 1, 2].map(|k| self.sections.axis(self.axes[k]));
        let xs = l.columns(|i| x.row(rows[i]));
        let ys = l.columns(|i| y.row(rows[i]));
        let zs = l.columns(|i| z.row(rows[i]));
        let org = [l.splat_wide(self.org[0]), l.splat_wide(self.org[1]), l.splat_wide(self.org[2])];
        let a = each!(k => l.sub_wide(xs[k], org[0]));
        let b = each!(k => l.sub_wide(ys[k], org[1]));
        let c = if self.down {
            each!(k => l.sub_wide(org[2], zs[k]))
        } else {
            each!(k => l.sub_wide(zs[k], org[2]))
        };
        // Edges, not from corners that were rounded.
        let next = each!(k => [
            l.sub_wide(xs[(k + 1) % 3], xs[k]),
            l.sub_wide(ys[(k + 1) % 3], ys[k]),
            if self.down {
                l.sub_wide(zs[k], zs[(k + 1) % 3])
            } else {
                l.sub_wide(zs[(k + 1) % 3], zs[k])
            },
        ]);
        let far_off = highest(l, each!(k => largest(l, [a[k], b[k], c[k]])));
        let size = highest(l, each!(k => largest(l, next[k])));
        let error =
            l.mul_add_wide(l.mul_wide(far_off, l.splat_wide(ERROR)), size, l.splat_wide(LEAST));
        let minus = l.sub_wide(l.splat_wide(0.0), error);
        let (mut all_up, mut all_down) = (u32::MAX, u32::MAX);
        for (edge, normal) in few.normals.iter_mut().enumerate() {
            let [x, y, z] = next[edge];
            let n = [
                l.cross_wide(b[edge], z, c[edge], y),
                l.cross_wide(c[edge], x, a[edge], z),
                l.cross_wide(a[edge], y, b[edge], x),
            ];
            l.store_wide(n[0], &mut normal[0]);
            l.store_wide(n[1], &mut normal[1]);
            l.store_wide(n[2], &mut normal[2]);
            let (mut most, mut least) = (n[2], n[2]);
            for k in 0..2 {
                let low = l.mul_wide(n[k], l.splat_wide(slopes[k][0]));
                let high = l.mul_wide(n[k], l.splat_wide(slopes[k][1]));
                most = l.add_wide(most, l.max_wide(low, high));
                least = l.add_wide(least, l.min_wide(low, high));
            }
            all_up &= l.at_most(minus, most);
            all_down &= l.at_most(least, error);
        }
        let [one, _, other] = next;
        let plane = [
            l.cross_wide(one[1], other[2], one[2], other[1]),
            l.cross_wide(one[2], other[0], one[0], other[2]),
            l.cross_wide(one[0], other[1], one[1], other[0]),
        ];
        let height = l.mul_add_wide(a[0], plane[0], l.mul_wide(b[0], plane[1]));
        let height = l.abs_wide(l.mul_add_wide(c[0], plane[2], height));
        let area = l.mul_wide(size, l.mul_wide(size, l.splat_wide(ERROR)));
        l.store_wide(plane[0], &mut few.plane[0]);
        l.store_wide(plane[1], &mut few.plane[1]);
        l.store_wide(plane[2], &mut few.plane[2]);
        l.store_wide(l.add_wide(area, l.splat_wide(LEAST)), &mut few.plane_errors);
        let height_error = l.mul_add_wide(area, far_off, l.splat_wide(LEAST));
        l.store_wide(l.sub_wide(height, height_error), &mut few.heights);
        let near = l.min_wide(l.min_wide(c[0], c[1]), c[2]);
        let far = l.max_wide(l.max_wide(c[0], c[1]), c[2]);
        l.store_wide(error, &mut few.errors);
        l.store_wide(near, &mut few.nearest);
        let ahead =
            l.at_most(near, l.splat_wide(end)) & l.at_most(l.splat_wide(-f32::MIN_POSITIVE), far);
        (all_up | all_down) & ahead
    }

    /// A bit for each ray that may pierce triangle `i`, of the rows that a part is in.
    #[inline(always)]
    fn sides(&self, few: &Few, i: usize, part: Part) -> u64 {
        let l = self.lanes;
        let n = each!(e => each!(k => l.splat_wide(few.normals[e][k][i])));
        let error = l.splat_wide(few.errors[i]);
        let minus = l.splat_wide(-few.errors[i]);
        let plane = each!(k => l.splat_wide(few.plane[k][i]));
        let plane_error = l.splat_wide(few.plane_errors[i]);
        let height = l.splat_wide(few.heights[i]);
        let nearest = l.splat_wide(few.nearest[i]);
        let mut rays = 0u64;
        let mut ray = part.first - part.first % L::WIDE;
        while ray < part.end() {
            let x = l.load_wide(eight(&self.slopes[0], ray));
            let y = l.load_wide(eight(&self.slopes[1], ray));
            let side = each!(e => l.mul_add_wide(x, n[e][0], l.mul_add_wide(y, n[e][1], n[e][2])));
            let least = l.min_wide(l.min_wide(side[0], side[1]), side[2]);
            let most = l.max_wide(l.max_wide(side[0], side[1]), side[2]);
            // The distance is the height over this.
            let slope = l.mul_add_wide(x, plane[0], l.mul_add_wide(y, plane[1], plane[2]));
            let slope = l.add_wide(l.abs_wide(slope), plane_error);
            let end = l.load_wide(eight(&self.ends, ray));
            let ahead = l.at_most(height, l.mul_wide(end, slope)) & l.at_most(nearest, end);
            let inside = l.at_most(minus, least) | l.at_most(most, error);
            rays |= u64::from(inside & ahead) << ray;
            ray += L::WIDE;
        }
        rays
    }

    /// The exact test of a triangle and the first few of these rays, a bit each; returns the rest.
    #[inline(always)]
    fn decide_some(&mut self, rays: u64, apex: &Apex, triangle: &Triangle, number: u32) -> u64 {
        let mut some = [rays.trailing_zeros() as usize % RAYS; 4];
        let mut left = rays & (rays - 1);
        let mut unsure = 1;
        if L::REGISTERS && self.plain {
            let mut count = 1;
            while count < 4 && left != 0 {
                some[count] = left.trailing_zeros() as usize % RAYS;
                left &= left - 1;
                count += 1;
            }
            unsure = self.decide_four(&some, apex, triangle, number) & ((1 << count) - 1);
        }
        while unsure != 0 {
            let ray = some[unsure.trailing_zeros() as usize % 4];
            unsure &= unsure - 1;
            let (record, query) = (&self.tables.rays[ray], &mut self.queries[ray]);
            let met = if L::REGISTERS {
                decide(self.lanes, query, record, triangle, number)
            } else if visible(record, triangle) {
                query.meet_from(&Line::new(record), apex, triangle, number)
            } else {
                None
            };
            if let Some(enough) = met {
                self.met(ray, enough);
            }
        }
        left
    }

    /// The exact test of a triangle that they see and four rays, any of them more than once; a bit
    /// for each that is not certain.
    #[inline(always)]
    fn decide_four(
        &mut self,
        some: &[usize; 4],
        apex: &Apex,
        triangle: &Triangle,
        number: u32,
    ) -> u32 {
        let l = self.lanes;
        let rows = some.map(|ray| self.tables.rays[ray % RAYS].dir);
        let dir =
            each!(k => l.widen(l.load_f32(&[rows[0][k], rows[1][k], rows[2][k], rows[3][k]])));
        let four = apex.four(l, dir);
        let Ray { tmin, flags, .. } = self.tables.rays[0];
        let t = l.widen(four.t);
        let early = l.above_f64(l.splat_f64(f64::from(tmin)), t);
        let finite = l.above_f64(l.splat_f64(f64::INFINITY), t);
        let culled = if flags & Ray::CULL_FRONT != 0 { four.front } else { 0 }
            | if flags & Ray::CULL_BACK != 0 { !four.front } else { 0 };
        let mut hits = four.inside & finite & !early & !culled;
        let (t, u, v) = (l.array_f32(four.t), l.array_f32(four.u), l.array_f32(four.v));
        while hits != 0 {
            let i = hits.trailing_zeros() as usize % 4;
            hits &= hits - 1;
            let (ray, t) = (some[i] % RAYS, t[i]);
            let query = &mut self.queries[ray];
            if t <= query.limit() {
                let weights = (four.weighed >> i & 1 != 0).then_some((u[i], v[i]));
                let enough = query.take_met(Met { t, weights, normal: None }, triangle, number);
                self.met(ray, enough);
            }
        }
        !four.inside & !four.outside
    }

    /// What follows from a hit.
    #[inline(always)]
    fn met(&mut self, ray: usize, enough: bool) {
        let limit = self.queries[ray].limit();
        self.ends[ray] = if enough { -1.0 } else { distance(limit, self.speeds[ray]) };
        self.nearer = true;
    }
}

#[inline(always)]
fn highest<L: Lanes>(l: L, [a, b, c]: [L::Wide; 3]) -> L::Wide {
    l.max_wide(l.max_wide(a, b), c)
}

/// The largest size of a coordinate.
#[inline(always)]
pub(in crate::trace) fn largest<L: Lanes>(l: L, [a, b, c]: [L::Wide; 3]) -> L::Wide {
    highest(l, [l.abs_wide(a), l.abs_wide(b), l.abs_wide(c)])
}
