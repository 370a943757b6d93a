//! Settings of programs whose command line is Criterion's.

use super::paper::rendering::FIGURE_10_TOP;
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

/// The configurations that `HUG_BENCH_CONFIGS` names, in the paper's notation: those of its figure
/// 10 unless it does.
pub fn configurations() -> Result<Vec<String>, String> {
    let named = env::var("HUG_BENCH_CONFIGS").unwrap_or_default();
    if !named.is_empty() {
        return Ok(named.split(',').map(str::to_owned).collect());
    }
    let kitchen = ["kit.g28", "kit.r50", "kit.r500", "kit.u.f3.sqrt2", "kit.u.f2.sqrt2"];
    let office = FIGURE_10_TOP.iter().map(|costs| costs.name);
    Ok(kitchen.into_iter().chain(office).map(str::to_owned).collect())
}

/// The pixels along each side that `HUG_BENCH_SIZE` asks for, or `default`.
pub fn size(default: u32) -> Result<u32, String> {
    let Ok(text) = env::var("HUG_BENCH_SIZE") else { return Ok(default) };
    let size = text.parse().ok().filter(|n| (1..=4096).contains(n));
    size.ok_or_else(|| format!("HUG_BENCH_SIZE: {text}: not a number from 1 to 4096"))
}
