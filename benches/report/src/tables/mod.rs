//! The paper's tables, ours beside its own where it has one of the same name.

pub mod costs;
pub mod lengths;
pub mod occupancy;
pub mod oriented;
pub mod performance;
pub mod rendering;
pub mod selected;
pub mod summary;

use crate::sheet::Cell;

/// Whose figures a line has.
pub const OURS: &str = "ours";
pub const PAPER: &str = "paper";

pub fn numbers(values: impl IntoIterator<Item = f64>) -> Vec<Cell> {
    values.into_iter().map(Cell::Number).collect()
}
