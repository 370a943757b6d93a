//! The structures by name, each with its default parameters.

use clap::ValueEnum;
use hug::{Options, Structure};

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    Auto,
    Uniform,
    Recursive,
    Hug,
}

impl Kind {
    pub const ALL: [Self; 4] = [Self::Auto, Self::Uniform, Self::Recursive, Self::Hug];

    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Uniform => "uniform",
            Self::Recursive => "recursive",
            Self::Hug => "hug",
        }
    }

    pub fn options(self) -> Options {
        let structure = match self {
            Self::Auto => Structure::Auto,
            Self::Uniform => Structure::Uniform,
            Self::Recursive => Structure::Recursive,
            Self::Hug => Structure::Hug,
        };
        Options { structure, ..Options::default() }
    }
}
