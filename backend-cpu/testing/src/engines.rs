//! The machines that every test runs on: the reference, and the interpreter at each setting that must not show.

use sightlines_backend::Backend;
use sightlines_backend_cpu::{Bounds, Config, CpuBackend, Simd};

use crate::reference::Reference;

/// A named machine.
pub struct Engine {
    /// What tests call it.
    pub name: String,
    /// The machine.
    pub backend: Box<dyn Backend>,
    /// Whether an access out of bounds stops it.
    pub traps: bool,
}

impl Engine {
    fn cpu(name: impl Into<String>, config: Config) -> Self {
        let traps = config.bounds == Bounds::Trap;
        Engine { name: name.into(), backend: Box::new(CpuBackend::new(config)), traps }
    }
}

/// Clamped accesses, and fuel that an endless loop uses up quickly.
fn config() -> Config {
    Config { bounds: Bounds::Clamp, fuel: 1 << 20, ..Config::default() }
}

/// The reference first; then the interpreter at its defaults, counting costs, stopping at accesses out of bounds, at
/// every SIMD level with few lanes, and with other lanes and threads.
pub fn engines() -> Vec<Engine> {
    let mut engines = vec![
        Engine { name: "reference".into(), backend: Box::new(Reference), traps: false },
        Engine::cpu("cpu", config()),
        Engine::cpu("cpu_count", Config { count: true, ..config() }),
        Engine::cpu("cpu_trap", Config { threads: 1, bounds: Bounds::Trap, ..config() }),
    ];
    for simd in Simd::available() {
        let settings = Config { simd: Some(simd), lanes: Some(16), threads: 1, ..config() };
        engines.push(Engine::cpu(format!("cpu_{}_16_lanes", simd.name()), settings));
    }
    engines.push(Engine::cpu("cpu_64_lanes_2_threads", Config { lanes: Some(64), threads: 2, ..config() }));
    engines.push(Engine::cpu("cpu_256_lanes_1_thread", Config { lanes: Some(256), threads: 1, ..config() }));
    engines
}
