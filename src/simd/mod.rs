//! What depends on the processor.

pub(crate) mod fpenv;
