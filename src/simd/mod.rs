//! What depends on the processor: instruction sets behind one trait, the choice
//! between them at run time, the floating-point environment, the size of pages, and memory
//! that is not cleared before it is used.
//!
//! The algorithms are written once, over [`Lanes`]; each instruction set is a
//! thin shell. No result depends on which one runs: lanes steer the walk,
//! which is conservative, sieve triangles, whose hits `triangle` decides, and in a build compute what
//! is rounded alike everywhere.

#[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
mod aarch64;
mod fetch;
pub(crate) mod fpenv;
mod isa;
mod lanes;
#[cfg(feature = "alloc")]
mod pages;
mod pair;
mod portable;
mod shelf;
mod stack;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use fetch::fetch;
#[cfg(any(target_arch = "x86_64", all(target_arch = "aarch64", target_feature = "neon")))]
pub(crate) use isa::portably;
pub(crate) use isa::{AnyKernel, dispatch};
pub use isa::{Isa, force_isa, isa};
pub(crate) use lanes::{Kernel, Lanes, RayColumns};
#[cfg(feature = "alloc")]
pub(crate) use pages::ask_for_large;
pub(crate) use pair::Pair;
pub(crate) use portable::Portable;
pub(crate) use shelf::Shelf;
pub(crate) use stack::{Room, Stack};
