//! The C ABI: thin exported functions over the library (design: one prefix,
//! statuses, frozen records; include/hug.h is generated from here).
//!
//! # Safety
//! All `unsafe` of this module rests on what the header asks of C callers:
//! pointers that are not NULL point to as much readable (or writable) memory
//! as their counts say. What can be checked without touching memory (NULL,
//! alignment, overlap, overflow, ranges) is checked and gives a status.

// The comments are C documentation: brackets are subscripts there.
#![allow(rustdoc::broken_intra_doc_links, rustdoc::invalid_html_tags)]

mod advise;
mod all;
mod budget;
mod build;
mod callbacks;
mod desc;
mod distribution;
mod fault;
mod filter;
mod guard;
mod memory;
mod nearest;
mod options;
mod profile;
mod query;
mod rebuild;
mod sized;
mod soa_types;
mod stat_types;
mod stats;
mod stream;
mod stream_soa;
pub mod types;

pub use advise::*;
pub use all::*;
pub use budget::*;
pub use build::*;
pub use distribution::*;
pub use fault::*;
pub use filter::*;
pub use nearest::*;
pub use profile::*;
pub use query::*;
pub use rebuild::*;
pub use stats::*;
pub use stream::*;
pub use stream_soa::*;
