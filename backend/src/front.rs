//! The front end behind bounds: no text, however made, overflows a stack, runs on for ever or panics its caller.
//!
//! naga's parser, lowering and validator recurse, and so does every consumer of a module: chains of operators and of
//! `else if` cost a level each link, and a stack overflow ends the process. So text is bounded in size and in depth
//! before naga sees it, naga runs on a thread of its own with a large stack, a panic there becomes an error, and so
//! does a text that takes too long (lowering is quadratic in the length of a function).
//!
//! Measured with naga 30.0.1 in release builds: lowering needs 1 to 2 KiB of stack a level, and the SPIR-V and WGSL
//! writers stand 2,000 levels on a thread of 2 MiB, Rust's default. Half of that is the bound. naga's own limits are
//! 127 nested braces and 200 levels of parser recursion.

use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::error::ErrorKind;
use crate::program::diagnose;
use crate::text::{self, Kind};
use crate::{Linked, Result, lint};

/// Bounds on the text of a program. The defaults suit any kernel that a person wrote.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CompileLimits {
    /// Bytes of linked text; 4 MiB.
    pub bytes: usize,
    /// Levels of nesting: two for each open bracket, one for each operator, access or `else if` that chains within;
    /// 1,000.
    pub depth: u32,
    /// Bytes of stack of the thread that runs the front end; 256 MiB, of which it touches what it needs.
    pub stack: usize,
    /// Time for the front end; 60 s. A thread that exceeds it is left behind to finish by itself.
    pub time: Duration,
}

impl Default for CompileLimits {
    fn default() -> Self {
        CompileLimits { bytes: 4 << 20, depth: 1000, stack: 256 << 20, time: Duration::from_secs(60) }
    }
}

/// Parses, validates and, where asked, lints linked text within `limits`.
pub(crate) fn compile(linked: &Linked, lint: bool, limits: &CompileLimits) -> Result<(naga::Module, ModuleInfo)> {
    if !linked.is_consistent() {
        return Err(refuse("the files of the linked text do not divide it", None).into());
    }
    if linked.text.len() > limits.bytes {
        let message = format!("the linked text has {} bytes, the limit is {}", linked.text.len(), limits.bytes);
        return Err(refuse(&message, None).into());
    }
    if let Some(byte) = too_deep(&linked.text, limits.depth) {
        let message = format!("nested deeper than the limit of {} levels", limits.depth);
        let at = naga::Span::new(byte as u32, byte as u32 + 1);
        return Err(diagnose(linked, "parse", &message, &[(at, "split this up".into())], Vec::new()).into());
    }
    let linked = linked.clone();
    guarded(limits, move || {
        let (module, info) = parse(&linked)?;
        if lint {
            lint::check(&module, &info, &linked)?;
        }
        Ok((module, info))
    })
}

/// Runs `work` on a thread with the stack of `limits`, catching its panics and its delay.
fn guarded<T: Send + 'static>(limits: &CompileLimits, work: impl FnOnce() -> Result<T> + Send + 'static) -> Result<T> {
    let (sender, receiver) = mpsc::channel();
    let send = move || drop(sender.send(work()));
    let thread = thread::Builder::new().name("wgsl front end".into()).stack_size(limits.stack).spawn(send);
    let thread = thread.map_err(|e| refuse(&format!("no thread of {} bytes of stack: {e}", limits.stack), None))?;
    match receiver.recv_timeout(limits.time) {
        Ok(result) => result,
        Err(RecvTimeoutError::Timeout) => {
            let message = format!("the front end did not finish within {} s", limits.time.as_secs_f32());
            Err(refuse(&message, Some("lowering is quadratic in the length of a function: split long functions"))
                .into())
        }
        Err(RecvTimeoutError::Disconnected) => {
            let panic = thread.join().err();
            let words = panic.as_ref().and_then(|p| {
                p.downcast_ref::<String>().map(String::as_str).or_else(|| p.downcast_ref::<&str>().copied())
            });
            let message = format!("the front end panicked: {}", words.unwrap_or("without a message"));
            Err(refuse(&message, Some("this is a defect of the front end; the kernel may be written another way"))
                .into())
        }
    }
}

fn parse(linked: &Linked) -> Result<(naga::Module, ModuleInfo)> {
    let module = naga::front::wgsl::parse_str(&linked.text).map_err(|e| {
        let labels = e.labels().map(|(span, text)| (span, text.to_owned())).collect::<Vec<_>>();
        let notes = e.notes().map(str::to_owned).collect();
        diagnose(linked, "parse", e.message(), &labels, notes)
    })?;
    // Every WebGPU device has the functions that round to f16 within f32; naga counts them as a capability.
    let capabilities = Capabilities::SHADER_FLOAT16_IN_FLOAT32;
    let info = Validator::new(ValidationFlags::all(), capabilities).validate(&module).map_err(|e| {
        let labels = e.spans().cloned().collect::<Vec<_>>();
        let mut notes = Vec::new();
        let mut source = std::error::Error::source(e.as_inner());
        while let Some(next) = source {
            notes.push(next.to_string());
            source = next.source();
        }
        diagnose(linked, "validate", &e.as_inner().to_string(), &labels, notes)
    })?;
    Ok((module, info))
}

fn refuse(message: &str, note: Option<&str>) -> ErrorKind {
    let note = note.map_or_else(String::new, |n| format!("  = {n}\n"));
    ErrorKind::Wgsl { stage: "parse", location: None, rendered: format!("error: {message}\n{note}") }
}

/// Levels open at one bracket.
#[derive(Clone, Copy, Default)]
struct Level {
    /// Operators, accesses and calls since the last separator.
    chain: u32,
    /// `else`s since the last `if` that began a statement.
    branches: u32,
}

/// The first byte that stands deeper than `limit`, counted so that it is never less than naga's recursion there.
fn too_deep(text: &str, limit: u32) -> Option<usize> {
    let mut levels = vec![Level::default()];
    let mut depth = 0_u32;
    let mut after_else = false;
    for token in text::tokens(text) {
        let nested = levels.len() > 1;
        let top = levels.last_mut()?;
        let word = &text[token.range.clone()];
        match token.kind {
            Kind::Punct('(' | '[' | '{') => {
                top.chain += 1;
                depth += 2;
                levels.push(Level::default());
            }
            Kind::Punct(')' | ']' | '}') if nested => {
                depth -= top.chain + top.branches + 1;
                levels.pop();
                if word == "}" {
                    depth -= restart(&mut levels);
                }
            }
            Kind::Punct(';' | ',') => depth -= restart(&mut levels),
            Kind::Punct(_) => {
                top.chain += 1;
                depth += 1;
            }
            Kind::Word if word == "else" => {
                top.branches += 1;
                depth += 1;
            }
            Kind::Word if word == "if" && !after_else => {
                depth -= top.branches;
                top.branches = 0;
            }
            _ => {}
        }
        after_else = word == "else";
        if depth > limit {
            return Some(token.range.start);
        }
    }
    None
}

/// Ends the chain of the innermost bracket and says how many levels that frees.
fn restart(levels: &mut [Level]) -> u32 {
    levels.last_mut().map_or(0, |top| std::mem::take(&mut top.chain))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn main(body: &str) -> Linked {
        let text = format!(
            "@group(0) @binding(0) var<storage, read_write> o: array<u32>;\n@compute @workgroup_size(1) fn main() {{\n{body}\n}}"
        );
        Linked::single("deep.wgsl", &text).expect("links")
    }

    fn error(body: &str, limits: &CompileLimits) -> String {
        compile(&main(body), true, limits).map(|_| ()).expect_err("must be refused").to_string()
    }

    /// Shapes of text that nest `n` levels.
    fn deep(n: usize) -> [(&'static str, String); 7] {
        [
            ("operators", format!("o[0] = 1u{};", " + o[1]".repeat(n))),
            ("unary operators", format!("o[0] = {}o[1];", "~".repeat(n))),
            ("parentheses", format!("o[0] = {}1u{};", "(".repeat(n), ")".repeat(n))),
            ("calls", format!("o[0] = {}1u{};", "min(".repeat(n), ", 2u)".repeat(n))),
            ("accesses", format!("var v = vec2<u32>(1u); o[0] = v{}.x;", ".xy".repeat(n))),
            ("else if", format!("if o[0] == 0u {{ }} {} else {{ }}", "else if o[1] == 2u { } ".repeat(n))),
            ("braces", format!("{}{}", "{".repeat(n), "}".repeat(n))),
        ]
    }

    #[test]
    fn deep_text_is_refused_with_its_line() {
        for (name, body) in deep(100_000) {
            let text = error(&body, &CompileLimits::default());
            assert!(text.contains("deeper than the limit of 1000") && text.contains("deep.wgsl:3:"), "{name}: {text}");
        }
    }

    #[test]
    fn text_within_the_bound_never_overflows_a_stack() {
        for (name, body) in deep(490) {
            if let Err(e) = compile(&main(&body), true, &CompileLimits::default()) {
                assert!(["parentheses", "calls", "braces"].contains(&name), "{name}: {e}");
            }
        }
    }

    #[test]
    fn long_text_is_not_deep() {
        let body = "if o[0] == 1u { o[1] = o[2] + 1u; } else if o[0] == 2u { o[1] = (o[3] & 2u) << 1u; }\n".repeat(400);
        let linked = main(&body);
        assert_eq!(too_deep(&linked.text, 40), None);
        assert!(compile(&linked, true, &CompileLimits::default()).is_ok());
    }

    #[test]
    fn size_and_time_are_limits() {
        let bytes = CompileLimits { bytes: 64, ..CompileLimits::default() };
        assert!(error("", &bytes).contains("bytes, the limit is 64"));
        let time = CompileLimits { time: Duration::ZERO, ..CompileLimits::default() };
        assert!(error(&"o[0] = o[1];".repeat(2000), &time).contains("did not finish within 0 s"));
    }

    #[test]
    fn a_panic_is_an_error() {
        let work = || -> Result<()> { std::panic::resume_unwind(Box::new("arena index".to_owned())) };
        let text = guarded(&CompileLimits::default(), work).expect_err("panicked").to_string();
        assert!(text.contains("the front end panicked: arena index"), "{text}");
    }

    #[test]
    fn files_that_do_not_divide_the_text_are_refused() {
        let mut linked = main("");
        linked.files[0].end -= 1;
        let text = compile(&linked, true, &CompileLimits::default()).map(|_| ()).expect_err("inconsistent").to_string();
        assert!(text.contains("do not divide"), "{text}");
    }
}
