//! Tests of the GPU backend, each run on every adapter of the machine.
//!
//! Test names read `adapter/test`. Without an adapter every test reports itself as ignored, with the reason. The
//! variable `SIGHTLINES_REQUIRE` (names separated by commas: `wgpu`, or a part of an adapter's name or driver) makes a
//! missing adapter a failure instead.

mod faults;
mod kernels;
mod order;

use std::process::ExitCode;
use std::sync::{Arc, OnceLock};

use libtest_mimic::{Arguments, Completion, Failed, Trial};
use sightlines_backend::{Linked, Program, Result};
use sightlines_backend_wgpu::{AdapterReport, WgpuBackend, WgpuOptions};

/// A test: it panics or returns an error to fail.
type Test = fn(&WgpuBackend) -> Result<()>;

fn main() -> ExitCode {
    let tests = [order::TESTS, kernels::TESTS, faults::TESTS].concat();
    let adapters = WgpuBackend::adapters(&WgpuOptions::default());
    let required = std::env::var("SIGHTLINES_REQUIRE").unwrap_or_default();
    let required = required.split(',').map(str::trim).filter(|n| !n.is_empty() && *n != "cpu").collect::<Vec<_>>();
    let mut trials = required.iter().map(|name| requirement(name, &adapters)).collect::<Vec<_>>();
    if adapters.is_empty() {
        trials.extend(tests.iter().map(|(name, _)| ignored(format!("none/{name}"), "no adapter: wgpu is not tested")));
    }
    for adapter in adapters {
        trials.extend(on_adapter(&adapter, &tests));
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

/// Fails unless a usable adapter of that name is there.
fn requirement(name: &str, adapters: &[AdapterReport]) -> Trial {
    let matches = |a: &&AdapterReport| {
        let text = format!("{} {}", a.name, a.driver).to_lowercase();
        name == "wgpu" || text.contains(&name.to_lowercase())
    };
    let found = adapters.iter().find(matches).map(|a| a.lacks.clone());
    let name = name.to_owned();
    Trial::test(format!("required/{name}"), move || match found {
        None => Err(format!("no adapter for `{name}`, which is required").into()),
        Some(lacks) if !lacks.is_empty() => Err(format!("`{name}` is not usable: {}", lacks.join("; ")).into()),
        Some(_) => Ok(()),
    })
}

fn on_adapter(adapter: &AdapterReport, tests: &[(&'static str, Test)]) -> Vec<Trial> {
    let shared = Arc::new(OnceLock::new());
    let trial = |&(test, body): &(&'static str, Test)| {
        let (name, shared) = (adapter.name.clone(), Arc::clone(&shared));
        let label = format!("{name}/{test}");
        if !adapter.lacks.is_empty() {
            return ignored(label, &adapter.lacks.join("; "));
        }
        Trial::test(label, move || {
            let backend: &Result<WgpuBackend, String> = shared.get_or_init(|| open(&name));
            body(backend.as_ref().map_err(Failed::from)?).map_err(Failed::from)
        })
    };
    tests.iter().map(trial).collect()
}

fn open(name: &str) -> Result<WgpuBackend, String> {
    let options = WgpuOptions { adapter: Some(name.to_owned()), ..WgpuOptions::default() };
    let backend = WgpuBackend::new(&options).map_err(|e| e.to_string())?;
    assert_eq!(backend.adapter().name, name, "another adapter was opened than the one asked for");
    Ok(backend)
}

fn ignored(name: String, reason: &str) -> Trial {
    let reason = reason.to_owned();
    Trial::ignorable_test(name, move || Ok(Completion::ignored_with(reason)))
}

/// A second device on the adapter of `backend`.
fn reopen(backend: &WgpuBackend, change: impl FnOnce(&mut WgpuOptions)) -> Result<WgpuBackend> {
    let mut options = WgpuOptions { adapter: Some(backend.adapter().name.clone()), ..WgpuOptions::default() };
    change(&mut options);
    WgpuBackend::new(&options)
}

/// A program of one file.
fn program(label: &str, text: &str) -> Result<Arc<Program>> {
    Program::unlinted(label, Linked::single(&format!("{label}.wgsl"), text)?)
}

/// Words of some bytes.
fn words(bytes: &[u8]) -> Vec<u32> {
    bytemuck::pod_collect_to_vec(bytes)
}
