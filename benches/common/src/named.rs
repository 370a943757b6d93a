//! Settings of programs whose command line is Criterion's.

use std::env;

/// The scenes that `HUG_BENCH_SCENES` names, or those of `default`.
pub fn scenes(
    default: impl FnOnce() -> Result<Vec<String>, String>,
) -> Result<Vec<String>, String> {
    match env::var("HUG_BENCH_SCENES") {
        Ok(names) if !names.is_empty() => Ok(names.split(',').map(str::to_owned).collect()),
        _ => default(),
    }
}

/// The pixels along each side that `HUG_BENCH_SIZE` asks for, or `default`.
pub fn size(default: u32) -> Result<u32, String> {
    let Ok(text) = env::var("HUG_BENCH_SIZE") else { return Ok(default) };
    let size = text.parse().ok().filter(|n| (1..=4096).contains(n));
    size.ok_or_else(|| format!("HUG_BENCH_SIZE: {text}: not a number from 1 to 4096"))
}
