//! Triangles without a picture: for tests of what must not go wrong, and for scaling.

mod adversarial;
mod bumpy_sphere;
mod scaling;

pub use adversarial::{empty, lattice, mixed_scales, rescaled, single, slivers, stacked, tangle};
pub use bumpy_sphere::{ClosedMesh, bumpy_sphere};
pub use scaling::{clustered, surface, uniform};
