//! A generated program on the scalar evaluator and on the interpreter: every word of every buffer agrees.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sightlines_testing::fuzz;

fuzz_target!(init: fuzz::keep_caught_panics(), |bytes: &[u8]| fuzz::differential(bytes));
