//! Two cases a function: all pairs of its table of edges, and ten million inputs of many shapes.

use rayon::prelude::*;
use sightlines_backend::{Case, Expected, Job, Size};

use super::{BLOCK, Function, Volume, WORDS, compile, functions, record};

/// Blocks of the large case: 10,485,760 inputs.
const BLOCKS: u32 = 2560;

pub(super) fn all() -> Vec<Case> {
    functions().flat_map(|function| [edges(function), many(function)]).collect()
}

fn case(
    function: &'static Function,
    name: &str,
    size: Size,
    volume: Volume,
    answer: fn(&Function) -> Vec<u32>,
) -> Case {
    let job = move || {
        let program = compile(function.part, &crate::source)?;
        let mut job = Job::new();
        let output = record(&mut job, &program, function, volume);
        job.read("output", output.id());
        Ok(job)
    };
    let expected = move |_: &_| vec![Expected::Whole(answer(function))];
    Case::new(format!("{}_{name}", function.name), size, job, expected)
}

fn edges(function: &'static Function) -> Case {
    let middle = WORDS * (BLOCK / 2 + 33);
    case(function, "edges", Size::Small, Volume::Edges, Function::whole).probes([0, 1, 2, 3, middle, middle + 1])
}

fn many(function: &'static Function) -> Case {
    let answer = |function: &Function| (0..BLOCKS).into_par_iter().map(|block| function.digest(block)).collect();
    case(function, "many", Size::Real, Volume::Blocks(BLOCKS), answer).probes([0, 1, BLOCKS - 1])
}
