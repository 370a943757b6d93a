//! Exact, watertight ray intersection in bucket-like space partitioning
//! structures, after Cazals & Puech, *Bucket-like Space Partitioning Data
//! Structures with Applications to Ray-Tracing* (1997).
//!
//! A triangle soup becomes one flat block, the [arena](View), that holds a
//! uniform grid, a recursive grid or a hierarchy of uniform grids. Queries on
//! it never allocate, lock or call the operating system, and their results are
//! those of real arithmetic, rounded once: all structures agree bit for bit.
//!
//! ```
//! let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! let mesh = hug::Geometry::from_mesh(&vertices, &[[0, 1, 2]]);
//! let scene = hug::Scene::build(&[mesh], &hug::Options::default())?;
//! let hit = scene.view().intersect(&hug::Ray::new([0.2, 0.3, 1.0], [0.0, 0.0, -1.0]));
//! assert_eq!((hit.t, hit.u, hit.v, hit.prim), (1.0, 0.2, 0.3, 0));
//! # Ok::<(), hug::Error>(())
//! ```
//!
//! Data flows one way: soup ([`Geometry`]), build passes ([`build`]), arena,
//! walk, hit.
#![no_std]
#![deny(missing_docs, unsafe_op_in_unsafe_fn)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(any(feature = "std", test))]
extern crate std;

/// One of each axis, corner or edge. A closure might not be compiled for the instruction set.
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

mod aabb;
mod advice;
mod arena;
pub mod build;
#[cfg(feature = "alloc")]
mod builder;
#[cfg(feature = "capi")]
#[allow(missing_docs)]
pub mod capi;
mod error;
mod exact;
mod geometry;
mod math;
mod options;
mod point;
mod probe;
mod ray;
#[cfg(feature = "alloc")]
mod scene;
mod simd;
mod stats;
mod trace;
mod triangle;

pub use advice::{Advice, Reason};
pub use arena::View;
#[cfg(feature = "alloc")]
pub use builder::Builder;
pub use error::Error;
pub use geometry::{Geometry, Indices, MAX_TRIANGLES};
pub use options::{
    Clustering, Delta, Filter, Gridding, Hierarchy, MAX_LEVELS, Options, Orientation, Quality,
    Structure,
};
pub use probe::{Nearest, Probe};
pub use ray::{Hit, NONE, Ray};
#[cfg(feature = "alloc")]
pub use scene::Scene;
pub use simd::{Isa, force_isa, isa};
pub use stats::{
    GridFrame, GridShape, Lengths, Level, Moments, Occupancy, Shares, Stats, cumulated,
};
#[cfg(feature = "replay")]
#[doc(hidden)]
pub use trace::replay;
pub use trace::{Calls, Counters, Found, Hits, Profile, Truncated, intersect_triangle};

/// Any number of threads may query one scene: without this it does not compile.
const _: () = {
    const fn shared<T: Send + Sync>() {}
    shared::<View<'static>>();
    shared::<Geometry<'static>>();
    #[cfg(feature = "alloc")]
    shared::<Scene>();
};

#[cfg(feature = "panic-handler")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
