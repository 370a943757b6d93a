//! What the fuzz targets do with bytes, without a fuzzer: `tests/corpus.rs` runs it on
//! the inputs that are checked in.

mod arena;
mod block;
mod calls;
mod descriptors;
mod input;
mod open;
mod soup;
mod trace;

pub use descriptors::descriptors;
pub use open::open;
pub use trace::trace;
