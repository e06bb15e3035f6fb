//! The child process: opens one machine, then runs job files until its input ends.
//!
//! A driver's crash ends this process and nothing else. A panic is caught and reported; an endless run is killed from
//! outside.

use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use serde_bytes::ByteBuf;
use sightlines_backend::{Backend, Counts, Job, Outputs, check};

use crate::fault::Injection;
use crate::machine::{Setting, Wanted};
use crate::protocol::{self, Failure, FailureKind, Pass, Reply};

/// Serves jobs over standard input and output.
pub fn serve(wanted: &Wanted, injection: Option<&Injection>) -> io::Result<()> {
    let (mut input, mut output) = (io::stdin().lock(), io::stdout().lock());
    let settings = match guarded(|| wanted.open().map_err(|e| Failure::from(&e))) {
        Ok(settings) => settings,
        Err(failure) => return protocol::send(&mut output, &Reply::Failed(failure)),
    };
    protocol::send(&mut output, &Reply::Ready)?;
    while let Some(bytes) = protocol::read_frame(&mut input)? {
        let reply = match guarded(|| run(&settings, &bytes, injection)) {
            Ok(passes) => Reply::Ran(passes),
            Err(failure) => Reply::Failed(failure),
        };
        protocol::send(&mut output, &reply)?;
    }
    Ok(())
}

fn guarded<T>(work: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|payload| {
        let said = payload.downcast_ref::<String>().cloned();
        let said = said.or_else(|| payload.downcast_ref::<&str>().map(|s| (*s).to_owned()));
        Err(Failure::new(FailureKind::Crash, format!("panic: {}", said.unwrap_or_default())))
    })
}

fn run(settings: &[Setting], bytes: &[u8], injection: Option<&Injection>) -> Result<Vec<Pass>, Failure> {
    let job = Job::from_bytes(bytes).map_err(|e| Failure::from(&e))?;
    if let Some(injection) = injection {
        injection.before();
    }
    settings.iter().map(|setting| run_pass(setting, &job, injection)).collect()
}

fn run_pass((setting, backend): &Setting, job: &Job, injection: Option<&Injection>) -> Result<Pass, Failure> {
    let start = Instant::now();
    let (outputs, counts) = run_counted(backend.as_ref(), job).map_err(|e| Failure::from(&e))?;
    let mut pass = Pass {
        setting: setting.clone(),
        identity: backend.info().into(),
        outputs: outputs.into_iter().map(ByteBuf::from).collect(),
        costs: counts.map(Into::into),
        nanos: start.elapsed().as_nanos() as u64,
    };
    if let Some(injection) = injection {
        injection.after(&mut pass);
    }
    Ok(pass)
}

/// [`Backend::run`], and the costs of the session.
pub fn run_counted(backend: &dyn Backend, job: &Job) -> sightlines_backend::Result<(Outputs, Option<Counts>)> {
    check::job(job)?;
    let mut session = backend.open(&job.programs, &job.buffers)?;
    for recording in &job.recordings {
        session.submit(recording)?;
    }
    let outputs = job.reads.iter().map(|read| session.read(read)).collect::<Result<_, _>>()?;
    Ok((outputs, session.counts()))
}
