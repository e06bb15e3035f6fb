//! Any text through every stage before a run. A panic of the front end is caught there and becomes a typed error, so it
//! does not end the fuzzer; any other panic does.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sightlines_testing::fuzz;

fuzz_target!(init: fuzz::keep_caught_panics(), |bytes: &[u8]| fuzz::translate(bytes));
