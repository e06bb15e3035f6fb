//! Deliberate faults, by which the tests show that the suite catches what it is there to catch.
//!
//! `--inject FAULT[@MACHINE]` is hidden from `--help` and documented in `docs/testing.md`. A fault changes one bit, one
//! identity or one process, on the machines whose name begins with `MACHINE`; nothing else in the suite knows of it. A
//! report made with a fault says so, and nothing can be blessed with one.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;
use std::time::Duration;

use sightlines_backend::{Expected, Job, Linked, Program};

use crate::protocol::Pass;

/// What is made wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// One bit of the linked WGSL of the first program.
    Wgsl {
        /// Byte of the linked text.
        byte: usize,
        /// Bit of that byte.
        bit: u8,
    },
    /// One bit of the oracle's answer.
    Oracle,
    /// One bit of a stored snapshot's first word.
    Snapshot,
    /// One bit of the machine's first output.
    Output,
    /// The adapter that the machine says it is.
    Adapter,
    /// The worker aborts while it runs the job.
    Crash,
    /// The worker never answers.
    Hang,
}

/// A fault and the machines it befalls.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Injection {
    /// The fault.
    pub fault: Fault,
    /// Beginning of the names of the machines; every machine where it is empty.
    pub machine: String,
}

impl FromStr for Injection {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (fault, machine) = text.split_once('@').unwrap_or((text, ""));
        let mut parts = fault.split(':');
        let fault = match (parts.next().unwrap_or(""), parts.next(), parts.next()) {
            ("wgsl", Some(byte), Some(bit)) => Fault::Wgsl {
                byte: byte.parse().map_err(|_| format!("`{byte}` is not a byte offset"))?,
                bit: bit.parse().ok().filter(|b| *b < 8).ok_or_else(|| format!("`{bit}` is not a bit of a byte"))?,
            },
            ("oracle", None, None) => Fault::Oracle,
            ("snapshot", None, None) => Fault::Snapshot,
            ("output", None, None) => Fault::Output,
            ("adapter", None, None) => Fault::Adapter,
            ("crash", None, None) => Fault::Crash,
            ("hang", None, None) => Fault::Hang,
            _ => return Err("wgsl:BYTE:BIT, oracle, snapshot, output, adapter, crash or hang".into()),
        };
        Ok(Injection { fault, machine: machine.to_owned() })
    }
}

impl fmt::Display for Injection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.fault {
            Fault::Wgsl { byte, bit } => write!(f, "wgsl:{byte}:{bit}")?,
            Fault::Oracle => f.write_str("oracle")?,
            Fault::Snapshot => f.write_str("snapshot")?,
            Fault::Output => f.write_str("output")?,
            Fault::Adapter => f.write_str("adapter")?,
            Fault::Crash => f.write_str("crash")?,
            Fault::Hang => f.write_str("hang")?,
        }
        if self.machine.is_empty() { Ok(()) } else { write!(f, "@{}", self.machine) }
    }
}

impl Injection {
    /// Whether a machine of this name is meant.
    pub fn befalls(&self, machine: &str) -> bool {
        machine.starts_with(&self.machine)
    }

    /// Whether a replay needs the fault again: whatever is not already in the dumped job.
    pub fn outlives_the_dump(&self) -> bool {
        matches!(self.fault, Fault::Output | Fault::Adapter | Fault::Crash | Fault::Hang)
    }

    /// Flips the bit of the WGSL in a job.
    pub fn job(&self, job: &mut Job) -> sightlines_backend::Result<()> {
        let (Fault::Wgsl { byte, bit }, Some(program)) = (self.fault, job.programs.first()) else { return Ok(()) };
        let mut text = program.linked().text.clone().into_bytes();
        if let Some(b) = text.get_mut(byte) {
            *b ^= 1 << bit;
        }
        let linked =
            Linked { text: String::from_utf8_lossy(&text).into_owned(), files: program.linked().files.clone() };
        let broken: Arc<Program> = Program::unlinted(program.label(), linked)?;
        job.programs[0] = broken;
        Ok(())
    }

    /// Flips a bit in the middle of the oracle's first answer that says anything.
    pub fn oracle(&self, expected: &mut [Expected]) {
        if self.fault != Fault::Oracle {
            return;
        }
        let word = expected.iter_mut().find_map(|e| match e {
            Expected::Whole(words) => {
                let middle = words.len() / 2;
                words.get_mut(middle)
            }
            Expected::Sample { words, .. } => {
                let middle = words.len() / 2;
                words.get_mut(middle).map(|(_, word)| word)
            }
        });
        if let Some(word) = word {
            *word ^= 1;
        }
    }

    /// Flips a bit of the first word that a stored snapshot shows.
    pub fn snapshot(&self, stored: &mut String) {
        let Some(at) = stored.find("] 0x").filter(|_| self.fault == Fault::Snapshot) else { return };
        let last = at + "] 0x".len() + 7;
        let digit = stored.as_bytes().get(last).and_then(|b| char::from(*b).to_digit(16));
        if let Some(flipped) = digit.and_then(|d| char::from_digit(d ^ 1, 16)) {
            stored.replace_range(last..=last, flipped.encode_utf8(&mut [0; 4]));
        }
    }

    /// What happens in the worker before a job runs.
    pub fn before(&self) {
        match self.fault {
            Fault::Crash => std::process::abort(),
            Fault::Hang => loop {
                std::thread::sleep(Duration::from_secs(3600));
            },
            _ => {}
        }
    }

    /// What happens in the worker to a pass that ran.
    pub fn after(&self, pass: &mut Pass) {
        match self.fault {
            Fault::Output => {
                if let Some(output) = pass.outputs.iter_mut().find(|o| !o.is_empty()) {
                    let word = output.len() / 4 / 2 * 4;
                    output[word] ^= 1;
                }
            }
            Fault::Adapter => pass.identity.adapter = format!("not {}", pass.identity.adapter),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn injections_read_as_they_print() {
        for text in ["wgsl:120:3@cpu", "oracle", "snapshot", "output@wgpu:llvm", "adapter", "crash@cpu", "hang"] {
            assert_eq!(text.parse::<Injection>().unwrap().to_string(), text);
        }
        for bad in ["", "wgsl", "wgsl:1", "wgsl:x:1", "wgsl:1:8", "output:1", "moon"] {
            assert!(bad.parse::<Injection>().is_err(), "`{bad}` was accepted");
        }
    }

    #[test]
    fn a_snapshot_fault_flips_exactly_one_bit() {
        let text = "output masks\n  [0] 0x0000002a\n  [1] 0x0000002b\n";
        let mut stored = text.to_owned();
        "snapshot".parse::<Injection>().unwrap().snapshot(&mut stored);
        assert_eq!(stored, text.replace("2a", "2b"));
    }
}
