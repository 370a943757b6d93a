//! The arena: one flat block that holds a built scene.
//!
//! `layout` says what its bytes mean (`node`: those of the tree of boxes), `check` decides
//! whether untrusted bytes are an arena (`tree`: whether nodes are a tree), `view` reads one,
//! `block` owns the memory of one.

#[cfg(feature = "alloc")]
pub(crate) mod block;
mod check;
pub(crate) mod layout;
pub(crate) mod node;
mod tree;
mod view;

#[cfg(feature = "capi")]
pub use check::check_header;
#[cfg(feature = "capi")]
pub use layout::ALIGN;
pub use view::View;
pub(crate) use view::{Axis, Bounds, Order, Sections};
