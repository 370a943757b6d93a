//! What all command lines have in common.

use std::process::ExitCode;

/// What `cargo bench` hands to every program.
#[derive(clap::Args)]
pub struct Cargo {
    #[arg(long = "bench", hide = true)]
    bench: bool,
}

/// The end of a program: its error on standard error.
pub fn finish(result: Result<(), String>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(what) => {
            eprintln!("{what}");
            ExitCode::FAILURE
        }
    }
}
