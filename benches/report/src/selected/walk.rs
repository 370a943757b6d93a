//! The two kinds of walk.

use hug::Options;
use hug_bench::notation::Notation;

/// How a ray goes on from a voxel. Structures are compared with others of the same walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walk {
    /// One voxel at a time, as in the paper.
    Steps,
    /// By exit boxes.
    Exits,
}

impl Walk {
    pub const ALL: [Self; 2] = [Self::Steps, Self::Exits];

    pub fn text(self) -> &'static str {
        match self {
            Self::Steps => "steps of one voxel",
            Self::Exits => "exit boxes",
        }
    }

    /// In names of files.
    pub fn file(self) -> &'static str {
        match self {
            Self::Steps => "steps",
            Self::Exits => "exits",
        }
    }

    /// `None` for what has exit boxes of itself, and would not be itself without.
    pub fn options(self, notation: Notation, triangles: u64) -> Option<Options> {
        let own = notation.options_for(triangles);
        match self {
            Self::Steps => (!own.exit_boxes).then_some(own),
            Self::Exits => Some(Options { exit_boxes: true, ..own }),
        }
    }
}
