//! What is true about a ray and triangles, by exact arithmetic.
//!
//! A ray O + tD hits a triangle when the exact line pierces the closed triangle (boundary
//! included) and D is not in its plane, so D . ((v1 - v0) x (v2 - v0)) != 0 exactly. All inputs
//! are f32 and taken as they are; t, u and v, with P = (1-u-v) v0 + u v1 + v v2, are rationals,
//! rounded once to f32 (to nearest, ties to even, denormals kept, no negative zero). The hit
//! counts if the rounded t is finite and tmin <= t <= tmax.

mod closest;
mod dyadic;
mod filter;
mod hit;
mod judge;
mod nearest;
mod round;

pub use closest::{Closest, all, closest, occluded};
pub use hit::{ExactHit, hit};
pub use judge::{Claim, Verdict, judge, judge_occluded};
pub use nearest::{Nearest, nearest};
pub use round::{root_to_f32, round_to_f32};

/// The corners v0, v1, v2.
pub type Triangle = [[f32; 3]; 3];
