//! A lane-parallel interpreter of naga IR: compute kernels without a GPU.
//!
//! Four stages, each with a folder or file of its own:
//!
//! 1. **Lowering** (`lower`), once for each pipeline: calls inlined, types split into words, uniformity found, masks
//!    put only where an effect needs them, registers allocated.
//! 2. **Code** ([`code`]): instructions on rows of lanes and on scalars that a whole gang shares; its `Display` is the
//!    disassembly.
//! 3. **Execution** (`exec`): one instruction at a time works on all lanes of a gang of up to 512 invocations, in SIMD
//!    chosen at run time; a barrier costs a check; gangs spread over threads.
//! 4. **Semantics** (`semantics`, [`math`]): what each operation means on one word, for every engine and test.
//!
//! # Start
//!
//! ```
//! use sightlines_backend::{Backend, Job, Linked, Program};
//! use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
//!
//! # fn main() -> sightlines_backend::Result<()> {
//! let text = "@group(0) @binding(0) var<storage, read_write> a: array<u32>;
//!     @compute @workgroup_size(64)
//!     fn main(@builtin(global_invocation_id) id: vec3u) { a[id.x] = a[id.x] * a[id.x]; }";
//! let program = Program::unlinted("squares", Linked::single("squares.wgsl", text)?)?;
//! let mut job = Job::new();
//! let squares = job.program(&program);
//! let a = job.upload("a", &(0..64u32).collect::<Vec<_>>());
//! job.dispatch(squares, "main", &[(0, a)], [1, 1, 1]);
//! job.read("a", a);
//! let cpu = CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() });
//! let outputs = cpu.run(&job)?;
//! assert_eq!(outputs[0][36..40], 81u32.to_le_bytes());
//! # Ok(())
//! # }
//! ```
//!
//! # What it promises
//!
//! * Integers and memory behave as WGSL says, in full; f32 is IEEE binary32 in source order, unfused, subnormals kept;
//!   transcendentals are pinned in [`math`]. The same bits on every host, SIMD level, lane count and number of threads.
//! * Every access is in range: clamped ([`Bounds::Clamp`]) or a trap that names line, index and length
//!   ([`Bounds::Trap`]).
//! * Loops end: each gang has fuel, and running out of it is a typed error.
//!
//! # Invariant
//!
//! A naga expression is visible only in its own block and the blocks inside it, so lanes that are not active may
//! compute anything. Only stores, atomics, sets of variables that others can observe, and exits consult the mask.

pub mod code;
mod exec;
mod lower;
pub mod math;
mod semantics;
mod session;

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use fearless_simd::Level;
use sightlines_backend::{Backend, BackendInfo, BufferDesc, Program, Result, Session};

pub use code::Code;

/// What happens to an access past the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bounds {
    /// The index is clamped to the last element, as naga's `Restrict` policy does.
    Clamp,
    /// The run stops with the source line, the index and the length.
    Trap,
}

/// A SIMD level. All levels give the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Simd {
    /// The least that this architecture has: SSE2 or NEON.
    Baseline,
    /// SSE4.2.
    Sse42,
    /// AVX2 and FMA.
    Avx2,
    /// AVX-512 as Ice Lake has it.
    Avx512,
}

impl Simd {
    /// The levels that this machine has, slowest first.
    pub fn available() -> Vec<Simd> {
        [Simd::Baseline, Simd::Sse42, Simd::Avx2, Simd::Avx512].into_iter().filter(|s| s.level().is_some()).collect()
    }

    /// The name that reports use.
    pub fn name(self) -> &'static str {
        match self {
            Simd::Baseline if cfg!(target_arch = "aarch64") => "neon",
            Simd::Baseline if cfg!(any(target_arch = "x86", target_arch = "x86_64")) => "sse2",
            Simd::Baseline => "baseline",
            Simd::Sse42 => "sse4.2",
            Simd::Avx2 => "avx2",
            Simd::Avx512 => "avx512",
        }
    }

    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    fn level(self) -> Option<Level> {
        let here = Level::new();
        match self {
            Simd::Baseline => Some(Level::baseline()),
            Simd::Sse42 => here.as_sse4_2().map(Level::Sse4_2),
            Simd::Avx2 => here.as_avx2().map(Level::Avx2),
            Simd::Avx512 => here.as_avx512().map(Level::Avx512),
        }
    }

    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    fn level(self) -> Option<Level> {
        (self == Simd::Baseline).then(Level::new)
    }
}

/// Bounds on what an entry point may become. The defaults suit any kernel that a person wrote; what exceeds one is
/// refused with its source line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CodeLimits {
    /// Operations after calls are inlined and types are split into words; 2^18. The time of lowering is at worst
    /// quadratic in it.
    pub operations: u32,
    /// Levels of control flow and calls after inlining; 512. Each case of a `switch` is a level.
    pub depth: u32,
    /// Bytes of private memory of one invocation: its variables that are indexed at run time; 256 KiB.
    pub private: u32,
}

impl Default for CodeLimits {
    fn default() -> Self {
        CodeLimits { operations: 1 << 18, depth: 512, private: 256 << 10 }
    }
}

/// How the interpreter runs. Nothing here changes a result, except what a trap or a limit ends.
#[derive(Clone, Copy, Debug)]
pub struct Config {
    /// Threads that run kernels; 0 means all cores.
    pub threads: usize,
    /// SIMD level; `None` means the best that the machine has.
    pub simd: Option<Simd>,
    /// What happens to an access past the end.
    pub bounds: Bounds,
    /// Loop iterations (back-edges) that one gang may take in one dispatch.
    pub fuel: u64,
    /// Lanes of a gang of merged workgroups; `None` lets the register count decide. Workgroups are never split.
    pub lanes: Option<u32>,
    /// Count semantic costs ([`Session::counts`]), and turns of loops.
    pub count: bool,
    /// Bytes that a session may allocate: its buffers, and the registers and memories of the gangs that run at once.
    pub memory: u64,
    /// Bounds on what an entry point may become.
    pub limits: CodeLimits,
}

impl Default for Config {
    fn default() -> Self {
        Config {
            threads: 0,
            simd: None,
            bounds: Bounds::Clamp,
            fuel: 1 << 30,
            lanes: None,
            count: false,
            memory: 8 << 30,
            limits: CodeLimits::default(),
        }
    }
}

/// Instructions that the cache of an interpreter holds; one that is full starts anew. About 64 MiB.
const CACHED_INSTRUCTIONS: usize = 1 << 22;

type CodeKey = (String, String, Vec<(String, u64)>);

/// The interpreter as a [`Backend`].
pub struct CpuBackend {
    config: Config,
    simd: Simd,
    level: Level,
    /// `None` on one thread: buffers are then plain memory.
    pool: Option<rayon::ThreadPool>,
    codes: Mutex<HashMap<CodeKey, Arc<Code>>>,
}

impl CpuBackend {
    /// An interpreter. A SIMD level that the machine lacks falls back to the best below it; [`Backend::info`] tells.
    pub fn new(config: Config) -> Self {
        let available = Simd::available();
        let wanted = config.simd.unwrap_or(Simd::Avx512);
        let order = [Simd::Baseline, Simd::Sse42, Simd::Avx2, Simd::Avx512];
        let rank = |s: Simd| order.iter().position(|o| *o == s);
        let simd = available.into_iter().rfind(|s| rank(*s) <= rank(wanted)).unwrap_or(Simd::Baseline);
        let threads = match config.threads {
            0 => std::thread::available_parallelism().map_or(1, usize::from),
            threads => threads,
        };
        // A machine that refuses threads still runs kernels, on this one.
        let pool = if threads > 1 { rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok() } else { None };
        let level = simd.level().unwrap_or(Level::baseline());
        CpuBackend { config, simd, level, pool, codes: Mutex::new(HashMap::new()) }
    }

    /// The level that runs.
    pub fn simd(&self) -> Simd {
        self.simd
    }

    /// Register code of an entry point: its `Display` is the disassembly.
    pub fn lowered(program: &Program, entry: &str, overrides: &[(String, f64)]) -> Result<Code> {
        lower::lower(program, entry, overrides, lower::Options { count: false, limits: CodeLimits::default() })
    }

    fn code(&self, program: &Program, entry: &str, overrides: &[(String, f64)]) -> Result<Arc<Code>> {
        let values = overrides.iter().map(|(name, value)| (name.clone(), value.to_bits())).collect();
        let key = (program.id().to_owned(), entry.to_owned(), values);
        let mut codes = self.codes.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(code) = codes.get(&key) {
            return Ok(Arc::clone(code));
        }
        let options = lower::Options { count: self.config.count, limits: self.config.limits };
        let code = Arc::new(lower::lower(program, entry, overrides, options)?);
        if codes.values().map(|code| code.insts.len()).sum::<usize>() + code.insts.len() > CACHED_INSTRUCTIONS {
            codes.clear();
        }
        codes.insert(key, Arc::clone(&code));
        Ok(code)
    }
}

impl Backend for CpuBackend {
    fn info(&self) -> BackendInfo {
        BackendInfo {
            backend: "cpu",
            adapter: format!("interpreter ({})", self.simd.name()),
            driver: format!("sightlines {}", env!("CARGO_PKG_VERSION")),
            threads: Some(self.pool.as_ref().map_or(1, rayon::ThreadPool::current_num_threads)),
        }
    }

    fn open(&self, programs: &[Arc<Program>], buffers: &[BufferDesc]) -> Result<Box<dyn Session + '_>> {
        Ok(Box::new(session::CpuSession::open(self, programs, buffers)?))
    }
}
