//! The kinds of query: what becomes of a triangle that is met.

use crate::arena::Sections;
use crate::arena::layout::Triangle;
use crate::ray::{Hit, HitRows, NONE, Ray};
use crate::simd::{Kernel, Lanes};
use crate::triangle::{self, Apex, Line, Met, normal};

/// What a walk looks for.
pub(crate) trait Query: Copy {
    /// What is found.
    type Out;
    /// Whether any triangle will do, in whatever order they are met.
    const ANY: bool = false;
    /// What a ray finds that hits nothing.
    fn miss(ray: &Ray) -> Self::Out;
    fn new(ray: &Ray) -> Self;
    /// The largest `t` of interest.
    fn limit(&self) -> f32;
    /// Takes a triangle if the line meets it at `t <= limit`; then `true` ends the
    /// walk. `apex` is the triangle's from the line's origin.
    fn meet_from(
        &mut self,
        line: &Line,
        apex: &Apex,
        triangle: &Triangle,
        number: u32,
    ) -> Option<bool>;
    /// [`Query::meet_from`] for one line.
    #[inline(always)]
    fn meet(&mut self, line: &Line, triangle: &Triangle, number: u32) -> Option<bool> {
        self.meet_from(line, &line.apex(triangle), triangle, number)
    }
    /// [`Query::meet`] in lanes.
    fn meet_in<L: Lanes>(
        &mut self,
        l: L,
        ray: &Ray,
        triangle: &Triangle,
        number: u32,
    ) -> Option<bool>;
    /// Takes a hit of a triangle at `t <= limit`; `true` ends the walk.
    fn take_met(&mut self, met: Met, triangle: &Triangle, number: u32) -> bool;
    /// Takes some hit, if that is all that is wanted.
    fn take_any(&mut self) -> bool {
        Self::ANY
    }
    /// What was found, once all has been met.
    fn found(&self, sections: &Sections<'_>, ray: &Ray) -> Self::Out;
    /// The same, one after the other: what the last one needed may be needed again.
    #[inline(always)]
    fn found_next(&self, sections: &Sections<'_>, ray: &Ray, _: &mut Last) -> Self::Out {
        self.found(sections, ray)
    }
}

/// The triangle that was hit last, and its normal.
pub(crate) struct Last {
    number: u32,
    normal: [f32; 3],
}

impl Last {
    pub const NONE: Self = Self { number: NONE, normal: [0.0; 3] };
}

/// The hit of smallest `t`, ties by lowest geometry, then primitive.
#[derive(Clone, Copy)]
pub(crate) struct Closest {
    /// As far as it is known.
    hit: HitRows,
    number: u32,
    /// Whether the weights are there, and the normal; of a miss they are.
    has_weights: bool,
    has_normal: bool,
}

impl Closest {
    /// Whether a hit comes before that found so far.
    #[inline(always)]
    fn prefers(&self, met: &Met, triangle: &Triangle) -> bool {
        met.t < self.limit() || (triangle.geom, triangle.prim) < self.hit.ids()
    }
}

impl Query for Closest {
    type Out = Hit;

    #[inline(always)]
    fn miss(ray: &Ray) -> Hit {
        HitRows::miss(ray.tmax).hit()
    }

    #[inline(always)]
    fn new(ray: &Ray) -> Self {
        Self { hit: HitRows::miss(ray.tmax), number: NONE, has_weights: true, has_normal: true }
    }

    #[inline(always)]
    fn limit(&self) -> f32 {
        self.hit.t()
    }

    #[inline(always)]
    fn meet_from(
        &mut self,
        line: &Line,
        apex: &Apex,
        triangle: &Triangle,
        number: u32,
    ) -> Option<bool> {
        let met = line.meet(apex, triangle, self.limit())?;
        Some(self.take_met(met, triangle, number))
    }

    #[inline(always)]
    fn meet_in<L: Lanes>(
        &mut self,
        l: L,
        ray: &Ray,
        triangle: &Triangle,
        number: u32,
    ) -> Option<bool> {
        let met = triangle::meet(l, ray, triangle, self.limit())?;
        Some(self.take_met(met, triangle, number))
    }

    #[inline(always)]
    fn take_met(&mut self, met: Met, triangle: &Triangle, number: u32) -> bool {
        if self.prefers(&met, triangle) {
            let (u, v) = met.weights.unwrap_or_default();
            let normal = met.normal.unwrap_or_default();
            *self = Self {
                hit: HitRows::new([met.t, u, v], normal, [triangle.geom, triangle.prim]),
                number,
                has_weights: met.weights.is_some(),
                has_normal: met.normal.is_some(),
            };
        }
        false
    }

    #[inline(always)]
    fn found(&self, sections: &Sections<'_>, ray: &Ray) -> Hit {
        let mut none = Last::NONE;
        self.found_next(sections, ray, &mut none)
    }

    #[inline(always)]
    fn found_next(&self, sections: &Sections<'_>, ray: &Ray, last: &mut Last) -> Hit {
        let mut hit = self.hit;
        if !self.has_normal {
            if self.number != last.number {
                *last =
                    Last { number: self.number, normal: normal(sections.triangle(self.number)) };
            }
            hit.set_normal(last.normal);
        }
        if !self.has_weights {
            hit.set_weights(Line::new(ray).weights(sections.triangle(self.number)));
        }
        hit.hit()
    }
}

/// Any hit at all.
#[derive(Clone, Copy)]
pub(crate) struct Any {
    tmax: f32,
    found: bool,
}

impl Query for Any {
    type Out = bool;
    const ANY: bool = true;

    #[inline(always)]
    fn miss(_: &Ray) -> bool {
        false
    }

    #[inline(always)]
    fn new(ray: &Ray) -> Self {
        Self { tmax: ray.tmax, found: false }
    }

    #[inline(always)]
    fn limit(&self) -> f32 {
        self.tmax
    }

    #[inline(always)]
    fn meet_from(&mut self, line: &Line, apex: &Apex, triangle: &Triangle, _: u32) -> Option<bool> {
        self.found = line.pierces(apex, triangle, self.tmax);
        self.found.then_some(true)
    }

    #[inline(always)]
    fn meet_in<L: Lanes>(&mut self, l: L, ray: &Ray, triangle: &Triangle, _: u32) -> Option<bool> {
        self.found = triangle::pierces(l, ray, triangle, self.tmax);
        self.found.then_some(true)
    }

    #[inline(always)]
    fn take_met(&mut self, _: Met, _: &Triangle, _: u32) -> bool {
        self.take_any()
    }

    #[inline(always)]
    fn take_any(&mut self) -> bool {
        self.found = true;
        true
    }

    #[inline(always)]
    fn found(&self, _: &Sections<'_>, _: &Ray) -> bool {
        self.found
    }
}

/// The exact test of a triangle, compiled for an instruction set.
struct Decide<'q, Q> {
    query: &'q mut Q,
    ray: &'q Ray,
    triangle: &'q Triangle,
    number: u32,
}

impl<Q: Query, L: Lanes> Kernel<L> for Decide<'_, Q> {
    type Out = Option<bool>;
    #[inline(always)]
    fn run(self, l: L) -> Option<bool> {
        let Self { query, ray, triangle, number } = self;
        meet_visible(l, query, ray, triangle, number)
    }
}

/// [`Query::meet`], in lanes where these are registers, if the ray may meet the triangle.
#[inline(always)]
pub(super) fn meet_visible<Q: Query, L: Lanes>(
    l: L,
    query: &mut Q,
    ray: &Ray,
    triangle: &Triangle,
    number: u32,
) -> Option<bool> {
    if !visible(ray, triangle) {
        None
    } else if L::REGISTERS {
        query.meet_in(l, ray, triangle, number)
    } else {
        query.meet(&Line::new(ray), triangle, number)
    }
}

/// [`Query::meet`], if the ray may meet the triangle. Apart, so that registers are not spilled where
/// there is nothing to decide, and the library is smaller.
#[inline(always)]
pub(super) fn decide<Q: Query, L: Lanes>(
    l: L,
    query: &mut Q,
    ray: &Ray,
    triangle: &Triangle,
    number: u32,
) -> Option<bool> {
    l.run_apart(Decide { query, ray, triangle, number })
}

/// `x`'s size times a power of two, and more. Fused or not it is the same.
#[inline(always)]
pub(super) fn allowance<L: Lanes>(l: L, x: f32, power: f32, more: f32) -> f32 {
    l.first(l.mul_add::<false>(l.splat_f32(x.abs()), l.splat_f32(power), l.splat_f32(more)))
}

/// A number above which every parameter rounds to more than `limit`, which is
/// not minus infinity: no less than the next `f32`.
#[inline(always)]
pub(super) fn beyond(limit: f32) -> f64 {
    let x = f64::from(limit);
    x + (x.abs() * f64::from(f32::EPSILON) + f64::from(f32::MIN_POSITIVE))
}

/// Whether the ray can hit anything: everything that [`Ray`] lists as a miss
/// is not usable.
#[inline(always)]
pub(super) fn usable<L: Lanes>(l: L, ray: &Ray) -> bool {
    let [org, dir, _] = ray.rows();
    let (org, dir) = (l.load3(org), l.load3(dir));
    let moves = l.equals(dir, l.splat_f32(0.0)) != 7;
    // NaN fails the comparisons. No t is infinite.
    let range =
        (ray.tmin <= ray.tmax) & (ray.tmin < f32::INFINITY) & (ray.tmax > f32::NEG_INFINITY);
    // One branch, not one for each number.
    l.all_finite(org) & l.all_finite(dir) & moves & range
}

/// Whether the ray may meet this triangle: masks share a bit and it is not the
/// one to skip.
#[inline(always)]
pub(super) fn visible(ray: &Ray, triangle: &Triangle) -> bool {
    ray.mask & triangle.mask != 0
        && (triangle.geom != ray.skip_geom || triangle.prim != ray.skip_prim)
}
