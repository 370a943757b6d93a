//! Criterion by CPU time instead of the wall clock.

use super::{clock, machine};
use criterion::Criterion;
use criterion::measurement::{Measurement, ValueFormatter, WallTime};
use std::time::Duration;

/// Criterion as the command line has it, by CPU time; also prints which machine this is.
pub fn criterion(samples: usize, warm_up: Duration, measurement: Duration) -> Criterion<CpuTime> {
    let criterion = Criterion::default()
        .with_measurement(CpuTime)
        .sample_size(samples)
        .nresamples(10_000)
        .warm_up_time(warm_up)
        .measurement_time(measurement)
        .configure_from_args();
    println!("{}", machine::line());
    criterion
}

pub struct CpuTime;

static WALL: WallTime = WallTime;

impl Measurement for CpuTime {
    type Intermediate = Duration;
    type Value = Duration;

    fn start(&self) -> Duration {
        clock::thread()
    }

    fn end(&self, start: Duration) -> Duration {
        clock::thread() - start
    }

    fn add(&self, a: &Duration, b: &Duration) -> Duration {
        *a + *b
    }

    fn zero(&self) -> Duration {
        Duration::ZERO
    }

    fn to_f64(&self, value: &Duration) -> f64 {
        WALL.to_f64(value)
    }

    fn formatter(&self) -> &dyn ValueFormatter {
        WALL.formatter()
    }
}
