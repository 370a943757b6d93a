//! What the paper prints, in its own order and units, and the forms that ours is put into to stand
//! beside it.

pub mod lengths;
pub mod rendering;
pub mod structures;
pub mod table;

pub use lengths::{FIGURE_4, Lengths};
pub use structures::{figure_12, figure_14, figure_17};
pub use table::{Other, Row, Sums, Table};
