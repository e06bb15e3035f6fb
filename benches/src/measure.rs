//! Preparing a job and timing what the device does in it with criterion: dispatches, clears and copies.
//!
//! Invariant: what is repeated does the same work each time. A job in which the host writes a buffer that an earlier
//! dispatch had bound cannot be repeated without that write, and is refused.

use std::collections::HashSet;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use std::time::Duration;

use criterion::measurement::Measurement;
use criterion::{BenchmarkId, Criterion, Throughput};
use serde::{Deserialize, Serialize};
use sightlines_backend::{Backend, Command, Job, Outputs, Recording, Result as BackendResult, Session, check};

use crate::clock::Clock;
use crate::error::{Error, Result};
use crate::statistics::median;
use crate::subject::Subject;

/// How long criterion measures once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Sampling {
    /// Samples, at least 10.
    pub samples: usize,
    /// Milliseconds of warming up.
    pub warm_up: u64,
    /// Milliseconds to measure for.
    pub measure: u64,
    /// A repetition of at least so many milliseconds is not timed by criterion, which takes ten samples at least, but
    /// directly: [`REPETITIONS`] times, or fewer once the sum reaches twenty times this limit.
    pub long: u64,
}

/// How often a long repetition is timed at most; the median counts.
pub const REPETITIONS: usize = 3;

impl Sampling {
    /// For numbers that are kept.
    pub const FULL: Sampling = Sampling { samples: 10, warm_up: 100, measure: 400, long: 250 };
    /// For a look.
    pub const QUICK: Sampling = Sampling { samples: 10, warm_up: 20, measure: 100, long: 50 };
}

/// A job on a machine: memory filled, and one recording that holds what the device does.
pub struct Prepared<'a> {
    session: Box<dyn Session + 'a>,
    dispatches: Recording,
    /// What the first run gave.
    pub outputs: Outputs,
    /// Lane-operations of one repetition, from the interpreter.
    pub lane_ops: Option<u64>,
}

impl<'a> Prepared<'a> {
    /// Runs the whole job once, keeps its outputs and its memory, then repeats the dispatches once where
    /// lane-operations are counted.
    pub fn new(backend: &'a dyn Backend, job: &Job) -> BackendResult<Self> {
        check::job(job)?;
        let dispatches = dispatches(job)?;
        let mut session = backend.open(&job.programs, &job.buffers)?;
        job.recordings.iter().try_for_each(|recording| session.submit(recording))?;
        let outputs = job.reads.iter().map(|read| session.read(read)).collect::<BackendResult<_>>()?;
        let lane_ops = match session.lane_ops() {
            None => None,
            Some(before) => {
                session.submit(&dispatches)?;
                session.lane_ops().map(|after| after - before)
            }
        };
        Ok(Prepared { session, dispatches, outputs, lane_ops })
    }

    /// Runs all dispatches once, to their end. Instructions are counted while this function runs, so it has to be one.
    #[inline(never)]
    pub fn repeat(&mut self) -> BackendResult<()> {
        self.session.submit(&self.dispatches)
    }

    /// A hash of all outputs, the same in every process of one build.
    pub fn digest(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.outputs.hash(&mut hasher);
        hasher.finish()
    }
}

/// What the device does in a job, as one recording: all but the host's uploads.
fn dispatches(job: &Job) -> BackendResult<Recording> {
    let mut bound = HashSet::new();
    let mut commands = Vec::new();
    for command in job.recordings.iter().flat_map(|recording| &recording.commands) {
        match command {
            Command::Upload { buffer, .. } if bound.contains(buffer) => {
                let label = &job.buffers[buffer.0 as usize].label;
                return Err(sightlines_backend::Error::refused(
                    format!(
                        "work that cannot be repeated alone: the host writes `{label}` after a dispatch that binds it"
                    ),
                    "give each dispatch of a measured case buffers of its own",
                ));
            }
            Command::Upload { .. } => continue,
            Command::Dispatch(dispatch) => bound.extend(dispatch.slots.iter().map(|slot| slot.buffer)),
            Command::Clear { .. } | Command::Copy { .. } => {}
        }
        commands.push(command.clone());
    }
    Ok(Recording { commands })
}

/// Adds one subject on one machine to a criterion run, under the id `kernel/case/backend`.
pub fn benchmark<M: Measurement>(
    criterion: &mut Criterion<M>,
    subject: &Subject,
    backend: &str,
    prepared: &mut Prepared<'_>,
) -> Result<()> {
    let mut failure = None;
    let mut group = criterion.benchmark_group(subject.kernel);
    if let Some(lane_ops) = prepared.lane_ops {
        group.throughput(Throughput::Elements(lane_ops));
    }
    group.bench_function(BenchmarkId::new(&subject.case, backend), |bencher| {
        bencher.iter(|| {
            if failure.is_none() {
                failure = prepared.repeat().err();
            }
        });
    });
    group.finish();
    failure.map_or(Ok(()), |error| Err(error.into()))
}

/// Median time of one repetition in nanoseconds: by criterion, whose files go below `folder`, unless it is long.
pub fn median_ns(
    subject: &Subject,
    backend: &str,
    prepared: &mut Prepared<'_>,
    (clock, sampling): (Clock, Sampling),
    folder: &Path,
) -> Result<f64> {
    if let Some(median) = long_ns(prepared, clock, sampling)? {
        return Ok(median);
    }
    let new = folder.join(subject.kernel).join(&subject.case).join(backend).join("new");
    // An estimate of an earlier run must not pass for this one's.
    if new.exists() {
        fs::remove_dir_all(&new).map_err(|e| Error::file(&new, e))?;
    }
    let mut criterion = Criterion::default()
        .with_measurement(clock)
        .output_directory(folder)
        .without_plots()
        .nresamples(2000)
        .sample_size(sampling.samples)
        .warm_up_time(Duration::from_millis(sampling.warm_up))
        .measurement_time(Duration::from_millis(sampling.measure));
    benchmark(&mut criterion, subject, backend, prepared)?;
    let file = new.join("estimates.json");
    let text = fs::read(&file).map_err(|e| Error::file(&file, e))?;
    let estimates: Estimates = serde_json::from_slice(&text)
        .map_err(|e| Error::Measurement(format!("{}: not criterion's estimates: {e}", file.display())))?;
    Ok(estimates.median.point_estimate)
}

/// The median of a few repetitions, where the first is long.
fn long_ns(prepared: &mut Prepared<'_>, clock: Clock, sampling: Sampling) -> Result<Option<f64>> {
    let long = sampling.long as f64 * 1e6;
    let mut times: Vec<f64> = Vec::new();
    while times.len() < REPETITIONS && (times.is_empty() || times.iter().sum::<f64>() < 20.0 * long) {
        let start = clock.start();
        prepared.repeat()?;
        times.push(clock.to_f64(&clock.end(start)));
        if times[0] < long {
            return Ok(None);
        }
    }
    Ok(median(&times))
}

/// The greatest resident memory of this process in bytes, where the system tells.
pub(crate) fn peak_bytes() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse().ok().map(|kib: u64| kib * 1024)
}

/// The part of criterion's `estimates.json` that is used.
#[derive(Deserialize)]
struct Estimates {
    median: Estimate,
}

#[derive(Deserialize)]
struct Estimate {
    point_estimate: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::micro;
    use sightlines_backend_cpu::{Config, CpuBackend};

    #[test]
    fn only_dispatches_are_repeated() {
        let job = micro::ALL[2].job().unwrap();
        assert_eq!(job.recordings[0].commands.len(), 2);
        let recording = dispatches(&job).unwrap();
        assert!(matches!(recording.commands[..], [Command::Dispatch(_)]));
    }

    #[test]
    fn a_job_whose_dispatches_depend_on_a_later_upload_is_refused() {
        let mut job = micro::ALL[2].job().unwrap();
        let table = job.recordings[0].commands[0].clone();
        job.record(table);
        let error = dispatches(&job).unwrap_err().to_string();
        assert!(error.contains("the host writes `table`"), "{error}");
    }

    #[test]
    fn long_repetitions_are_timed_without_criterion_and_short_ones_are_not() {
        let backend = CpuBackend::new(Config::default());
        let mut prepared = Prepared::new(&backend, &micro::ALL[3].job().unwrap()).unwrap();
        let mut time = |long| long_ns(&mut prepared, Clock::Wall, Sampling { long, ..Sampling::QUICK }).unwrap();
        assert!(time(0).is_some_and(|ns| ns > 0.0));
        assert_eq!(time(3_600_000), None);
    }

    #[test]
    fn a_failing_repetition_is_an_error_and_no_time() {
        let backend = CpuBackend::new(Config { fuel: 100, ..Config::default() });
        let job = micro::ALL[0].job().unwrap();
        let mut prepared = Prepared::new(&backend, &job).unwrap();
        prepared.dispatches.commands.iter_mut().for_each(|command| {
            if let Command::Dispatch(dispatch) = command {
                dispatch.slots.clear();
            }
        });
        let subject = crate::subjects().into_iter().find(|s| s.to_string() == "micro/arithmetic").unwrap();
        let folder = std::env::temp_dir().join(format!("sightlines-benches-{}", std::process::id()));
        let result = median_ns(&subject, "cpu", &mut prepared, (Clock::Wall, Sampling::QUICK), &folder);
        assert!(matches!(result, Err(Error::Backend(_))));
        let mut criterion = Criterion::default().without_plots().output_directory(&folder).sample_size(10);
        criterion = criterion.warm_up_time(Duration::from_millis(1)).measurement_time(Duration::from_millis(1));
        assert!(matches!(benchmark(&mut criterion, &subject, "cpu", &mut prepared), Err(Error::Backend(_))));
        fs::remove_dir_all(&folder).unwrap();
    }
}
