//! The paper's measurements as a report: one page, and its tables as CSV.
//!
//! `args` says what to measure, `measure`, `oriented` and
//! `selected` do, `tables` and `claims` put it beside the paper's
//! figures, `plots` and `pictures` draw it, `page` joins all.

pub mod args;
pub mod claims;
pub mod measure;
pub mod oriented;
pub mod page;
pub mod pictures;
pub mod plots;
pub mod progress;
pub mod run;
pub mod selected;
pub mod sheet;
pub mod tables;
