//! CPU time, which other programs on the machine disturb less than the wall clock; where the
//! system has none, the wall clock.

use std::time::Duration;

/// Of this thread: for queries.
#[cfg(unix)]
pub fn thread() -> Duration {
    read(rustix::time::ClockId::ThreadCPUTime)
}

/// Of all threads of the process: for builds.
#[cfg(unix)]
pub fn process() -> Duration {
    read(rustix::time::ClockId::ProcessCPUTime)
}

#[cfg(unix)]
fn read(clock: rustix::time::ClockId) -> Duration {
    let now = rustix::time::clock_gettime(clock);
    Duration::new(now.tv_sec as u64, now.tv_nsec as u32)
}

#[cfg(not(unix))]
pub use self::wall as thread;
#[cfg(not(unix))]
pub use self::wall as process;

#[cfg(not(unix))]
pub fn wall() -> Duration {
    static START: std::sync::LazyLock<std::time::Instant> =
        std::sync::LazyLock::new(std::time::Instant::now);
    START.elapsed()
}

/// Seconds that `work` takes by `clock`.
pub fn seconds(clock: fn() -> Duration, work: impl FnOnce()) -> f64 {
    let start = clock();
    work();
    (clock() - start).as_secs_f64()
}
