//! Timing that is fair between contenders: rounds in which each runs once, in an order that
//! rotates, so that no one always follows the same other.

use super::clock::seconds;
use std::time::Duration;

/// Does the first so many items.
pub type Contender<'a> = Box<dyn FnMut(usize) + 'a>;

/// Runs every contender on an eighth of `n` items, then `rounds` times on all of them. Seconds,
/// by contender and round.
pub fn run(
    contenders: &mut [Contender<'_>],
    n: usize,
    rounds: usize,
    clock: fn() -> Duration,
) -> Vec<Vec<f64>> {
    for contender in contenders.iter_mut() {
        contender(n / 8);
    }
    run_warm(contenders, n, rounds, clock)
}

/// [`run`] without the eighth before.
pub fn run_warm(
    contenders: &mut [Contender<'_>],
    n: usize,
    rounds: usize,
    clock: fn() -> Duration,
) -> Vec<Vec<f64>> {
    let count = contenders.len();
    let mut times = vec![Vec::new(); count];
    for round in 0..rounds {
        for i in 0..count {
            let turn = (i + round) % count;
            times[turn].push(seconds(clock, || contenders[turn](n)));
        }
    }
    times
}
