//! The child process of one engine in one thread setting, and the coordinator's side of it.
//!
//! Messages are JSON, one a line. Criterion prints to standard output as well, so a reply begins with `MARK` and
//! all other lines are its report; what is said on standard error goes to a file in the child's folder. Whatever
//! ends a child before its reply fails one measurement and nothing else.

use std::fs::{self, File};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;

use serde::{Deserialize, Serialize};

use crate::clock::Clock;
use crate::engine::{self, Adapter, Engine, Threads};
use crate::error::{Error, Result};
use crate::measure::{self, Prepared, Sampling};
use crate::subject::{Subject, subjects};

/// What a line that is a reply begins with.
const MARK: &str = "@@sightlines ";

/// The file of what a child says on standard error.
const WORDS: &str = "stderr.txt";

/// Longest silence of a child that is asked something.
const PATIENCE: Duration = Duration::from_secs(600);

/// What a child serves.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Setting {
    /// The engine.
    pub engine: Engine,
    /// Its threads.
    pub threads: Threads,
    /// How long criterion measures once.
    pub sampling: Sampling,
    /// Folder of criterion's files.
    pub folder: PathBuf,
}

/// One measurement.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Median time of one repetition.
    pub median_ns: f64,
    /// Hash of the outputs.
    pub digest: u64,
    /// Lane-operations of one repetition, from the interpreter.
    pub lane_ops: Option<u64>,
}

type Reply = std::result::Result<Measured, String>;

/// Serves measurements: the first line of `input` is the [`Setting`], each further one the id of a subject.
pub fn serve(input: impl BufRead, mut out: impl Write) -> Result<()> {
    let mut lines = input.lines();
    let mut next = || lines.next().transpose().map_err(Error::Output);
    let Some(first) = next()? else { return Ok(()) };
    let setting: Setting = parse(&first)?;
    let backend = setting.engine.open(setting.threads);
    let subjects = subjects();
    // Memory of a subject stays on the device while its rounds last.
    let mut prepared: Option<(usize, Prepared<'_>)> = None;
    while let Some(id) = next()? {
        let reply = backend.as_ref().map_err(|e| Error::Worker(e.to_string())).and_then(|backend| {
            let index = find(&subjects, &id)?;
            let kept = prepared.take().filter(|(of, _)| *of == index);
            let (_, prepared) = prepared.insert(match kept {
                Some(kept) => kept,
                None => (index, prepare(&subjects[index], &setting, backend.as_ref())?),
            });
            measure(&subjects[index], &setting, prepared)
        });
        reply_line(&mut out, &reply.map_err(|e| e.to_string()))?;
    }
    Ok(())
}

fn find(subjects: &[Subject], id: &str) -> Result<usize> {
    let index = subjects.iter().position(|subject| subject.to_string() == id);
    index.ok_or_else(|| Error::Worker(format!("no subject is called `{id}`")))
}

fn prepare<'a>(
    subject: &Subject,
    setting: &Setting,
    backend: &'a dyn sightlines_backend::Backend,
) -> Result<Prepared<'a>> {
    let prepared = Prepared::new(backend, &(subject.job)()?)?;
    match subject.first_error(setting.engine.backend(), &prepared.outputs) {
        Some(wrong) => Err(Error::Measurement(wrong)),
        None => Ok(prepared),
    }
}

fn measure(subject: &Subject, setting: &Setting, prepared: &mut Prepared<'_>) -> Result<Measured> {
    let backend = setting.engine.backend();
    let how = (Clock::of(setting.threads), setting.sampling);
    let median_ns = measure::median_ns(subject, backend, prepared, how, &setting.folder)?;
    Ok(Measured { median_ns, digest: prepared.digest(), lane_ops: prepared.lane_ops })
}

fn parse<'a, T: Deserialize<'a>>(line: &'a str) -> Result<T> {
    serde_json::from_str(line).map_err(|e| Error::Worker(format!("not a message: {e}")))
}

fn line(message: &impl Serialize) -> Result<String> {
    serde_json::to_string(message).map_err(|e| Error::Worker(e.to_string()))
}

/// Writes a reply on a line of its own, whatever criterion left unfinished.
fn reply_line(out: &mut impl Write, message: &impl Serialize) -> Result<()> {
    writeln!(out, "\n{MARK}{}", line(message)?)?;
    Ok(out.flush()?)
}

/// The coordinator's side of a child.
pub struct Worker {
    child: Child,
    input: Option<ChildStdin>,
    replies: Receiver<String>,
    words: PathBuf,
}

impl Worker {
    /// Starts a child of `exe` for a setting.
    pub fn start(exe: &Path, setting: &Setting, pin: Option<&str>) -> Result<Self> {
        fs::create_dir_all(&setting.folder).map_err(|e| Error::file(&setting.folder, e))?;
        let mut command = command(exe, setting.threads, pin);
        let words = setting.folder.join(WORDS);
        let words = File::create(&words).map_err(|e| Error::file(&words, e))?;
        command.arg("worker").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(words);
        let mut child = command.spawn().map_err(|e| Error::Worker(format!("{}: {e}", exe.display())))?;
        let (send, replies) = mpsc::channel();
        if let Some(output) = child.stdout.take() {
            std::thread::spawn(move || {
                for line in BufReader::new(output).lines().map_while(std::result::Result::ok) {
                    let Some(reply) = line.strip_prefix(MARK) else { continue };
                    // The coordinator may have given up on this child.
                    let _ = send.send(reply.to_owned());
                }
            });
        }
        let input = child.stdin.take();
        let mut worker = Worker { child, input, replies, words: setting.folder.join(WORDS) };
        worker.tell(&line(setting)?)?;
        Ok(worker)
    }

    fn tell(&mut self, line: &str) -> Result<()> {
        let Some(input) = &mut self.input else { return Err(Error::Worker("its input is closed".into())) };
        writeln!(input, "{line}").and_then(|()| input.flush()).map_err(|e| Error::Worker(format!("it is gone: {e}")))
    }

    /// Measures one subject.
    pub fn measure(&mut self, subject: &Subject) -> Result<Measured> {
        self.tell(&subject.to_string())?;
        let reply = self.replies.recv_timeout(PATIENCE).map_err(|e| match e {
            mpsc::RecvTimeoutError::Timeout => Error::Worker(format!("no answer within {} s", PATIENCE.as_secs())),
            mpsc::RecvTimeoutError::Disconnected => Error::Worker(match self.child.wait() {
                Ok(status) => format!("it ended with {status}; see {}", self.words.display()),
                Err(e) => format!("it ended: {e}; see {}", self.words.display()),
            }),
        })?;
        parse::<Reply>(&reply)?.map_err(Error::Measurement)
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // Without input an idle child ends by itself; one that hangs does not. Both may be gone already.
        self.input = None;
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Writes the adapters for [`discover`].
pub fn list_adapters(mut out: impl Write) -> Result<()> {
    reply_line(&mut out, &engine::adapters_here())
}

/// A child of `exe` with so many threads; one on one thread stays on the core `pin`, where there is one.
pub(crate) fn command(exe: &Path, threads: Threads, pin: Option<&str>) -> Command {
    let mut command = match pin {
        Some(core) if threads == Threads::One => {
            let mut taskset = Command::new("taskset");
            taskset.args(["-c", core]).arg(exe);
            taskset
        }
        _ => Command::new(exe),
    };
    match threads {
        Threads::One => command.env("LP_NUM_THREADS", "1"),
        Threads::All => command.env_remove("LP_NUM_THREADS"),
    };
    command
}

/// Lists adapters in a child process, so that a driver that crashes while it loads cannot end the run.
pub fn discover(exe: &Path) -> Result<Vec<Adapter>> {
    let output = Command::new(exe).arg("adapters").stdin(Stdio::null()).output();
    let output = output.map_err(|e| Error::Worker(format!("{}: {e}", exe.display())))?;
    let text = String::from_utf8_lossy(&output.stdout);
    match text.lines().find_map(|line| line.strip_prefix(MARK)) {
        Some(list) if output.status.success() => parse(list),
        _ => {
            let said = String::from_utf8_lossy(&output.stderr);
            Err(Error::Worker(format!("the search for adapters ended with {}: {}", output.status, said.trim())))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setting(name: &str) -> Setting {
        let folder = std::env::temp_dir().join(format!("sightlines-worker-{name}-{}", std::process::id()));
        let engine = engine::interpreters(&[]).unwrap().remove(0);
        Setting { engine, threads: Threads::All, sampling: Sampling::QUICK, folder }
    }

    /// The replies to some lines of input, and what else was written.
    fn served(setting: &Setting, ids: &[&str]) -> Vec<Reply> {
        let input = [&[line(setting).unwrap().as_str()], ids].concat().join("\n");
        let mut out = Vec::new();
        serve(input.as_bytes(), &mut out).unwrap();
        let out = String::from_utf8(out).unwrap();
        out.lines().filter_map(|line| line.strip_prefix(MARK)).map(|reply| parse(reply).unwrap()).collect()
    }

    #[test]
    fn a_child_measures_what_it_is_asked_and_says_what_it_does_not_know() {
        let setting = setting("serve");
        let replies = served(&setting, &["micro/reduction", "micro/none", "micro/reduction"]);
        let [Ok(first), Err(unknown), Ok(last)] = &replies[..] else { panic!("{replies:?}") };
        assert!(first.median_ns > 0.0 && first.lane_ops > Some(0));
        assert_eq!((first.digest, first.lane_ops), (last.digest, last.lane_ops));
        assert!(unknown.contains("no subject is called `micro/none`"));
        fs::remove_dir_all(&setting.folder).unwrap();
    }

    #[test]
    fn an_engine_that_cannot_be_opened_answers_with_its_reason() {
        let mut setting = setting("absent");
        let (name, driver) = ("no such adapter".into(), String::new());
        setting.engine = Engine::Wgpu(Adapter { name, driver, api: "vulkan".into(), lacks: Vec::new() });
        let replies = served(&setting, &["micro/reduction"]);
        assert!(matches!(&replies[..], [Err(reason)] if reason.contains("no such adapter")), "{replies:?}");
    }

    #[cfg(unix)]
    #[test]
    fn a_child_that_dies_is_an_error() {
        let setting = setting("dies");
        let subject = subjects().remove(0);
        let result = Worker::start(Path::new("false"), &setting, None).and_then(|mut worker| worker.measure(&subject));
        assert!(matches!(result, Err(Error::Worker(_))));
        assert!(Worker::start(Path::new("/nonexistent/program"), &setting, None).is_err());
        fs::remove_dir_all(&setting.folder).unwrap();
    }
}
