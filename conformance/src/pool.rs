//! The parent's side of a worker: start, ask, wait with a limit, kill, start again.

use std::collections::VecDeque;
use std::io::{self, Read};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use crate::fault::Injection;
use crate::machine::Machine;
use crate::protocol::{self, Failure, FailureKind, Pass, Reply};

const KEPT_STDERR: usize = 2048;

/// Runs jobs on one machine in a child process that is replaced whenever it dies.
pub struct Worker {
    exe: PathBuf,
    machine: Machine,
    injection: Option<Injection>,
    running: Option<Running>,
}

struct Running {
    child: Child,
    input: ChildStdin,
    replies: Receiver<io::Result<Option<Reply>>>,
    said: Arc<Mutex<VecDeque<u8>>>,
}

impl Worker {
    /// A worker of a machine; its process is started by the first job.
    pub fn new(exe: PathBuf, machine: Machine, injection: Option<Injection>) -> Self {
        let injection = injection.filter(|i| i.befalls(&machine.name));
        Worker { exe, machine, injection, running: None }
    }

    /// The machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// Runs a job file. After a crash or a timeout the next call starts a new process.
    pub fn run(&mut self, job: &[u8], limit: Duration) -> Result<Vec<Pass>, Failure> {
        let mut running = match self.running.take() {
            Some(running) => running,
            None => self.start(limit)?,
        };
        if protocol::write_frame(&mut running.input, job).is_err() {
            return Err(running.died());
        }
        match running.wait(limit)? {
            (Reply::Ran(passes), running) => {
                self.running = Some(running);
                Ok(passes)
            }
            (Reply::Failed(failure), running) => {
                // A device that failed once may be lost: the next case gets a new process.
                self.running = (failure.kind == FailureKind::Trap).then_some(running);
                Err(failure)
            }
            (Reply::Ready, _) => Err(Failure::new(FailureKind::Error, "the worker answered out of turn")),
        }
    }

    fn start(&self, limit: Duration) -> Result<Running, Failure> {
        let mut command = Command::new(&self.exe);
        command.arg("worker").args(self.machine.wanted.arguments());
        if let Some(injection) = &self.injection {
            command.arg("--inject").arg(injection.to_string());
        }
        let running = Running::spawn(command)
            .map_err(|e| Failure::new(FailureKind::Error, format!("{}: {e}", self.exe.display())))?;
        match running.wait(limit)? {
            (Reply::Ready, running) => Ok(running),
            (Reply::Failed(failure), _) => Err(failure),
            (Reply::Ran(_), _) => Err(Failure::new(FailureKind::Error, "the worker answered out of turn")),
        }
    }
}

impl Running {
    fn spawn(mut command: Command) -> io::Result<Self> {
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
        let missing = || io::Error::other("a pipe to the worker is missing");
        let input = child.stdin.take().ok_or_else(missing)?;
        let mut output = child.stdout.take().ok_or_else(missing)?;
        let mut errors = child.stderr.take().ok_or_else(missing)?;
        let (sender, replies) = channel();
        thread::spawn(move || {
            loop {
                let reply = protocol::receive::<Reply>(&mut output);
                let last = !matches!(reply, Ok(Some(_)));
                if sender.send(reply).is_err() || last {
                    return;
                }
            }
        });
        let said = Arc::new(Mutex::new(VecDeque::new()));
        let kept = Arc::clone(&said);
        thread::spawn(move || {
            let mut chunk = [0; 512];
            while let Ok(n @ 1..) = errors.read(&mut chunk) {
                let Ok(mut kept) = kept.lock() else { return };
                kept.extend(&chunk[..n]);
                let excess = kept.len().saturating_sub(KEPT_STDERR);
                kept.drain(..excess);
            }
        });
        Ok(Running { child, input, replies, said })
    }

    fn wait(mut self, limit: Duration) -> Result<(Reply, Self), Failure> {
        match self.replies.recv_timeout(limit) {
            Ok(Ok(Some(reply))) => Ok((reply, self)),
            Ok(_) | Err(RecvTimeoutError::Disconnected) => Err(self.died()),
            Err(RecvTimeoutError::Timeout) => {
                self.end();
                Err(Failure::new(
                    FailureKind::Timeout,
                    format!("no answer within {} s; the worker was killed", limit.as_secs()),
                ))
            }
        }
    }

    fn died(&mut self) -> Failure {
        let status = self.end();
        let said = self.said.lock().map(|s| s.iter().copied().collect::<Vec<u8>>()).unwrap_or_default();
        let said = String::from_utf8_lossy(&said);
        let said = said.trim();
        let said = if said.is_empty() { String::new() } else { format!("; it said: {said}") };
        Failure::new(FailureKind::Crash, format!("the worker died: {status}{said}"))
    }

    /// Kills the process if it still runs. A process that has closed its output is given a moment to end by itself, so
    /// that its own status is the one reported.
    fn end(&mut self) -> String {
        for _ in 0..50 {
            match self.child.try_wait() {
                Ok(Some(status)) => return status.to_string(),
                Ok(None) => thread::sleep(Duration::from_millis(2)),
                Err(e) => return e.to_string(),
            }
        }
        let _ = self.child.kill();
        self.child.wait().map_or_else(|e| e.to_string(), |status| status.to_string())
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
