//! The conformance suite: every case of every kernel, on every backend present, compared bit for bit.
//!
//! A verdict is the first check that does not agree, in this order: the oracle; the interpreter with one thread and
//! with all; every machine; the stored snapshot. What the modules are for:
//!
//! * [`plan`] selects cases, [`machine`] finds machines without loading a driver into this process;
//! * [`worker`] is the child process that runs jobs on one machine, [`pool`] its parent's side, [`protocol`] what
//!   passes between them: a driver's crash or a run without end is the status of one case;
//! * [`run`] judges one case, [`suite`] runs them all; [`diff`] makes the tables, [`snapshot`] and [`costs`] the
//!   snapshots, [`bless`] writes them, [`expect`] holds the failures that are known;
//! * [`dump`] and [`replay`] turn a failure into one file and back, [`custom`] runs anyone's kernel;
//! * [`report`] writes text, JSON and JUnit; [`inspect`] and [`doctor`] show the registry and the machine;
//! * [`fault`] makes the deliberate faults by which the tests show that all this catches them.
//!
//! Invariant: nothing passes in silence. What did not run is a skip with its reason, and no case is an error too.

pub mod bless;
pub mod cli;
pub mod command;
pub mod costs;
pub mod custom;
pub mod diff;
pub mod doctor;
pub mod dump;
pub mod error;
pub mod expect;
pub mod fault;
pub mod files;
pub mod inspect;
pub mod machine;
pub mod plan;
pub mod pool;
pub mod protocol;
pub mod replay;
pub mod report;
pub mod result;
pub mod run;
pub mod snapshot;
pub mod suite;
pub mod worker;
