//! One ray at a time.

use core::marker::PhantomData;

use super::counters::{Count, Counters, Uncounted};
use super::descent::{Boxes, Descent};
use super::profile::Profile;
use super::query::{Any, Closest, Query, meet_visible, usable};
use super::walk::Walk;
use crate::arena::View;
use crate::arena::node::{Node, QuantizedNode};
use crate::ray::{Hit, Ray};
use crate::simd::{AnyKernel, Isa, Lanes, Portable, dispatch, fpenv};

/// Triangles up to which deciding all of them takes less time than to begin a walk.
const FEW: u64 = 4;

/// A query of one ray in a scene that is not empty.
struct Single<'a, Q, C> {
    view: &'a View<'a>,
    ray: &'a Ray,
    query: Q,
    counters: &'a mut C,
}

impl<Q: Query, C: Count> AnyKernel for Single<'_, Q, C> {
    type Out = Q::Out;
    const BEST: Isa = Isa::Avx2;
    #[inline(always)]
    fn run_on<L: Lanes>(self, lanes: L) -> Q::Out {
        if !usable(lanes, self.ray) {
            return Q::miss(self.ray);
        }
        let mut walk = Walk::new(lanes, self.view, self.ray, self.query, self.counters);
        walk.run(self.view.header().occluders());
        walk.query.found(&self.view.sections(), self.ray)
    }

    // Where a better set is nearly always there, what counts nothing may as well count: its own
    // kernels would be a fiftieth of the library.
    #[cfg(any(target_arch = "x86_64", all(target_arch = "aarch64", target_feature = "neon")))]
    fn run_portable(self) -> Q::Out {
        use crate::simd::portably;
        if C::COUNTS {
            return portably(self);
        }
        let Self { view, ray, query, .. } = self;
        let mut nobody = Counters::default();
        portably(Single { view, ray, query, counters: &mut nobody.meter() })
    }
}

/// A query of one ray in a scene of a few triangles.
struct Among<'a, Q> {
    view: &'a View<'a>,
    ray: &'a Ray,
    query: PhantomData<Q>,
}

impl<Q: Query> AnyKernel for Among<'_, Q> {
    type Out = Q::Out;
    const BEST: Isa = Isa::Avx2;
    #[inline(always)]
    fn run_on<L: Lanes>(self, lanes: L) -> Q::Out {
        self.view.among_all::<Q, L>(lanes, self.ray)
    }
}

/// A query of one ray in a scene that has a tree of such nodes.
struct Down<'a, Q, N> {
    view: &'a View<'a>,
    ray: &'a Ray,
    query: PhantomData<(Q, N)>,
}

impl<Q: Query, N: Boxes> AnyKernel for Down<'_, Q, N> {
    type Out = Q::Out;
    const BEST: Isa = Isa::Avx2;
    #[inline(always)]
    fn run_on<L: Lanes>(self, lanes: L) -> Q::Out {
        let Self { view, ray, .. } = self;
        let Some((mut descent, start)) = Descent::<Q, N, L>::new(lanes, view, ray) else {
            return view.walk::<Q>(ray);
        };
        let mut query = Q::new(ray);
        descent.run(&start, view.header().occluders(), &mut query);
        query.found(&view.sections(), ray)
    }

    // As with streams: where another set is nearly always there, this would be but size.
    #[cfg(any(target_arch = "x86_64", all(target_arch = "aarch64", target_feature = "neon")))]
    fn run_portable(self) -> Q::Out {
        self.view.walk::<Q>(self.ray)
    }
}

impl View<'_> {
    /// The closest hit of `ray`, or the record of a miss.
    #[must_use]
    #[inline]
    pub fn intersect(&self, ray: &Ray) -> Hit {
        self.single::<Closest, _>(ray, &mut Uncounted)
    }

    /// [`View::intersect`], adding what it did to `counters`.
    pub fn intersect_counted(&self, ray: &Ray, counters: &mut Counters) -> Hit {
        self.single::<Closest, _>(ray, counters)
    }

    /// Whether `ray` hits anything.
    #[must_use]
    #[inline]
    pub fn occluded(&self, ray: &Ray) -> bool {
        self.single::<Any, _>(ray, &mut Uncounted)
    }

    /// [`View::occluded`], adding what it did to `counters`.
    pub fn occluded_counted(&self, ray: &Ray, counters: &mut Counters) -> bool {
        self.single::<Any, _>(ray, counters)
    }

    /// [`View::intersect`], adding what it did on each level to `profile`.
    pub fn intersect_profiled(&self, ray: &Ray, profile: &mut Profile) -> Hit {
        self.single::<Closest, _>(ray, profile)
    }

    /// [`View::occluded`], adding what it did on each level to `profile`.
    pub fn occluded_profiled(&self, ray: &Ray, profile: &mut Profile) -> bool {
        self.single::<Any, _>(ray, profile)
    }

    #[inline]
    pub(super) fn single<Q: Query, C: Count>(&self, ray: &Ray, counters: &mut C) -> Q::Out {
        if self.header().grids.count == 0 {
            return Q::miss(ray);
        }
        fpenv::with_default(|| {
            if self.header().triangles.count <= FEW && !C::COUNTS {
                return dispatch(Among::<Q> { view: self, ray, query: PhantomData });
            }
            if self.header().nodes.count > 0 && !C::COUNTS {
                return if self.header().quantized == 0 {
                    dispatch(Down::<Q, Node> { view: self, ray, query: PhantomData })
                } else {
                    dispatch(Down::<Q, QuantizedNode> { view: self, ray, query: PhantomData })
                };
            }
            let counters = &mut counters.meter();
            dispatch(Single { view: self, ray, query: Q::new(ray), counters })
        })
    }

    /// A query of a ray that is not for the tree.
    #[cold]
    #[inline(never)]
    fn walk<Q: Query>(&self, ray: &Ray) -> Q::Out {
        dispatch(Single { view: self, ray, query: Q::new(ray), counters: &mut Uncounted })
    }

    /// [`View::intersect`] by testing every triangle: the oracle that the
    /// structures are compared with. Cost: linear in the triangles.
    #[must_use]
    pub fn intersect_brute(&self, ray: &Ray) -> Hit {
        fpenv::with_default(|| self.among_all::<Closest, _>(Portable, ray))
    }

    /// Decides every triangle.
    #[inline(always)]
    fn among_all<Q: Query, L: Lanes>(&self, l: L, ray: &Ray) -> Q::Out {
        if !usable(l, ray) {
            return Q::miss(ray);
        }
        let mut query = Q::new(ray);
        for (number, triangle) in (0..).zip(self.triangles()) {
            if meet_visible(l, &mut query, ray, triangle, number) == Some(true) {
                break;
            }
        }
        query.found(&self.sections(), ray)
    }
}
