//! What the tests, benches and C examples of hug share, written once: scenes after the paper's
//! four kinds, the ray sets of the comparisons, and an arbiter that decides by exact arithmetic.
//!
//! Nothing here depends on hug. Everything generated is the same, bit for bit, on every machine:
//! sums and products are IEEE doubles rounded once to f32, sines and powers come from `libm`.

mod capi;

pub mod arbiter;
pub mod mesh;
pub mod random;
pub mod rays;
pub mod scenes;
pub mod soups;
pub mod view;

pub use mesh::{Bounds, Mesh};
pub use view::View;
