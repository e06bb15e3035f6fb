//! What time is taken: of the clock on the wall, or of the processor.
//!
//! A child on one core whose work is never parallel uses as much CPU time as it would take alone on the machine. That
//! holds on a busy machine too, where wall time measures the neighbours.

use std::time::{Duration, Instant};

use cpu_time::ProcessTime;
use criterion::measurement::{Measurement, ValueFormatter, WallTime};
use serde::{Deserialize, Serialize};

use crate::engine::Threads;

/// A clock of criterion's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Clock {
    /// Time that passed.
    Wall,
    /// CPU time of this process, all its threads together.
    Cpu,
}

impl Clock {
    /// The clock of a thread setting. Windows counts CPU time in ticks too long for a kernel.
    pub fn of(threads: Threads) -> Self {
        if threads == Threads::One && cfg!(unix) { Clock::Cpu } else { Clock::Wall }
    }

    /// The name that reports use.
    pub fn name(self) -> &'static str {
        match self {
            Clock::Wall => "wall time",
            Clock::Cpu => "CPU time",
        }
    }
}

/// Where a [`Clock`] stood.
pub struct Start {
    wall: Instant,
    cpu: Option<ProcessTime>,
}

impl Measurement for Clock {
    type Intermediate = Start;
    type Value = Duration;

    fn start(&self) -> Start {
        Start { wall: Instant::now(), cpu: (*self == Clock::Cpu).then(ProcessTime::now) }
    }

    fn end(&self, start: Start) -> Duration {
        start.cpu.map_or_else(|| start.wall.elapsed(), |cpu| cpu.elapsed())
    }

    fn add(&self, a: &Duration, b: &Duration) -> Duration {
        *a + *b
    }

    fn zero(&self) -> Duration {
        Duration::ZERO
    }

    fn to_f64(&self, value: &Duration) -> f64 {
        WallTime.to_f64(value)
    }

    fn formatter(&self) -> &dyn ValueFormatter {
        WallTime.formatter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sleep_costs_wall_time_alone() {
        let sleep = |clock: Clock| {
            let start = clock.start();
            std::thread::sleep(Duration::from_millis(400));
            clock.end(start)
        };
        assert!(sleep(Clock::Wall) >= Duration::from_millis(400));
        // Other tests of this process may work meanwhile, on few cores and not all the time.
        let clock = Clock::of(Threads::One);
        assert_eq!(clock == Clock::Cpu, cfg!(unix));
        assert_eq!(Clock::of(Threads::All), Clock::Wall);
    }

    #[test]
    fn work_costs_cpu_time() {
        let start = Clock::Cpu.start();
        let began = Instant::now();
        while began.elapsed() < Duration::from_millis(300) {
            std::hint::black_box(libm::exp(1.0));
        }
        assert!(Clock::Cpu.end(start) > Duration::from_millis(1));
    }
}
