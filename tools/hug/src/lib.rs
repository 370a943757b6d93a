//! hug for people who only want to look: each command is a module, `args` says what they take,
//! `input` where scenes come from.

pub mod args;
pub mod build;
pub mod compare;
pub mod count;
pub mod file;
pub mod info;
pub mod input;
pub mod progress;
pub mod render;
pub mod report;
