//! Measures the backends against each other: every kernel at its real size, and four micro-kernels that each lay one
//! cost bare.
//!
//! # What is measured
//!
//! The *dispatches* of a case, and nothing else: programs compiled, memory resident on the device, inputs uploaded.
//! [`Prepared`] runs the whole job once, then repeats one recording that holds all its dispatches in order;
//! criterion times that submission until the device has finished it, except that a long one is timed directly
//! ([`Sampling`]). Uploads and read-backs are outside. Outputs of the first run are hashed, and engines that differ
//! are a failure: a wrong answer has no speed.
//!
//! # How engines are compared
//!
//! An engine (the interpreter at one SIMD level, or one adapter) in one thread setting is one child process. On one
//! thread it is pinned to one core with `taskset`, `LP_NUM_THREADS=1` is set for lavapipe, and the interpreter has
//! one thread; what is timed is the CPU time of the child's process ([`Clock`]), so that other work on the machine
//! does not count. On all cores nothing is pinned and wall time is taken. For each subject the rounds alternate
//! between engines, forward and backward in turn. A row's time is the median of its rounds' medians;
//! `ratio_to_lavapipe` is the median of the *rounds'* ratios, interpreter over lavapipe, so that a load which both
//! engines of a round suffer cancels.
//!
//! `lane_ops` is the interpreter's work for one repetition: for each vector instruction it executes, the lanes of
//! the 16-lane chunks that the instruction works on ([`Session::lane_ops`](sightlines_backend::Session::lane_ops)).
//! It is counted, not timed, and does not depend on SIMD level; on threads only where atomics give places in an order
//! that is not fixed, which `vertex_visibility` does with less than one in 100,000 of its work. Rows of other engines
//! carry the same number, so that `ns_per_lane_op` compares time for the same work. [`instructions`] counts what the
//! processor executes for it.

pub mod ambient;
pub mod baseline;
mod children;
pub mod cli;
pub mod clock;
pub mod embree;
pub mod engine;
pub mod error;
mod html;
pub mod instructions;
pub mod measure;
pub mod micro;
pub mod queries;
pub mod report;
pub mod run;
pub mod shadows;
mod statistics;
pub mod subject;
mod table;
pub mod worker;

pub use clock::Clock;
pub use engine::{Engine, Threads};
pub use error::{Error, Result};
pub use measure::{Prepared, Sampling};
pub use report::{Report, Row};
pub use subject::{Subject, subjects};
