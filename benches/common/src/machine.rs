//! Where and when figures were taken: no figure is worth anything without.

use std::fs;
use std::thread::available_parallelism;
use std::time::{SystemTime, UNIX_EPOCH};

/// A line of Markdown: library, instruction set, machine, what the program is compiled for, date.
pub fn line() -> String {
    format!(
        "hug {} ({}); {} x {}{}, {} {}; compiled for {}; {}",
        env!("CARGO_PKG_VERSION"),
        hug::isa().name().to_string_lossy(),
        processors(),
        processor().unwrap_or_else(|| "unknown processor".into()),
        memory().map(|gib| format!(", {gib:.0} GiB")).unwrap_or_default(),
        std::env::consts::OS,
        std::env::consts::ARCH,
        compiled_for(),
        today(),
    )
}

/// All of the machine, whichever of them this process may use.
fn processors() -> usize {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let listed = info.lines().filter(|line| line.starts_with("processor")).count();
    if listed > 0 { listed } else { available_parallelism().map_or(1, usize::from) }
}

fn processor() -> Option<String> {
    let info = fs::read_to_string("/proc/cpuinfo").ok()?;
    let model = info.lines().find(|line| line.starts_with("model name"))?;
    Some(model.split_once(':')?.1.trim().to_owned())
}

fn memory() -> Option<f64> {
    let info = fs::read_to_string("/proc/meminfo").ok()?;
    let total = info.lines().find(|line| line.starts_with("MemTotal"))?;
    let kib: f64 = total.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib / f64::from(1 << 20))
}

/// The instruction sets that the compiler could use without asking the processor. The library
/// asks; what does not, such as a peer, is held to these.
fn compiled_for() -> &'static str {
    if cfg!(target_feature = "avx512f") {
        "AVX-512"
    } else if cfg!(all(target_feature = "avx2", target_feature = "fma")) {
        "AVX2 and FMA"
    } else {
        "the target's baseline"
    }
}

/// The date in Greenwich, year first.
fn today() -> String {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    let [year, month, day] = civil((since.as_secs() / 86_400) as i64);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Year, month and day of a number of days since 1970-01-01, none before it. Years begin in March
/// here, so that the leap day is their last.
fn civil(days: i64) -> [i64; 3] {
    let days = days + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * from_march + 2) / 5 + 1;
    let month = if from_march < 10 { from_march + 3 } else { from_march - 9 };
    [era * 400 + year_of_era + i64::from(month <= 2), month, day]
}
