//! A generated program within limits of fuel and memory: the same end and the same buffers on every SIMD level.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sightlines_testing::fuzz;

fuzz_target!(|bytes: &[u8]| drop(fuzz::execute(bytes)));
