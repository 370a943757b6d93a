//! Queries: one walk for all structures and all kinds of query, and a descent through the tree
//! of boxes, where there is one, for rays on their own or not alike.
//!
//! `walk` goes through grids, `course` prepares a ray for all
//! of them, `local` for one, `rebase` does so for rays from very far away, `sieve`
//! rejects triangles cheaply, `query` says what is looked for, `counters` and
//! `profile` what is counted, `budget` ends a walk early, `work` bounds what one can do.
//! `descent` is the way through the tree, `flock` that of many rays. `all` and `filter` are walks
//! with other ends, `alone` is about one triangle.

mod all;
mod alone;
mod bounds;
mod budget;
mod counters;
mod course;
mod decided;
mod descent;
mod filter;
mod flock;
mod local;
mod nearest;
mod packet;
mod profile;
mod query;
mod rebase;
mod sieve;
mod single;
mod stream;
mod turned;
mod walk;
mod work;

pub use all::{Found, Hits};
pub use alone::intersect_triangle;
pub use budget::Truncated;
pub use counters::Counters;
#[cfg(feature = "capi")]
pub(crate) use counters::{Count, Uncounted};
#[cfg(feature = "capi")]
pub(crate) use filter::Flags;
pub use profile::{Calls, Profile};
#[cfg(feature = "capi")]
pub(crate) use stream::Port;
#[cfg(feature = "replay")]
pub use walk::replay;
