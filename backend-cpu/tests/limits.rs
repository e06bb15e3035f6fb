//! Limits: each refuses with a typed error that names the source line, and nothing below it overflows a stack.

use sightlines_backend::{Backend, Error, ErrorKind, Job, Linked, Program, TrapKind};
use sightlines_backend_cpu::{CodeLimits, Config, CpuBackend};

const HEAD: &str = "@group(0) @binding(0) var<storage, read_write> o: array<u32>;\n";

/// Runs `main` on one workgroup and four words; the result is the words, or the error.
fn run(text: &str, config: Config) -> Result<Vec<u8>, Error> {
    run_on(&[0, 1, 2, 3], &format!("{HEAD}{text}"), config)
}

fn run_on(words: &[u32], text: &str, config: Config) -> Result<Vec<u8>, Error> {
    let program = Program::unlinted("limits", Linked::single("limits.wgsl", text)?)?;
    let mut job = Job::new();
    let id = job.program(&program);
    let buffer = job.upload("o", words);
    job.dispatch(id, "main", &[(0, buffer)], [1, 1, 1]);
    job.read("o", buffer);
    Ok(CpuBackend::new(Config { threads: 1, ..config }).run(&job)?.remove(0))
}

fn limits(limits: CodeLimits) -> Config {
    Config { limits, ..Config::default() }
}

fn main_of(body: &str) -> String {
    format!("@compute @workgroup_size(16)\nfn main(@builtin(local_invocation_index) i: u32) {{\n{body}\n}}\n")
}

/// The limit and the line that an error names.
#[track_caller]
fn refused(result: Result<Vec<u8>, Error>, words: &str, wanted: u64) -> u32 {
    let error = result.expect_err("must be refused");
    let ErrorKind::Limit { what, limit, location: Some(at), remedy } = error.kind() else { panic!("{error}") };
    assert!(what.contains(words) && !remedy.is_empty(), "{error}");
    assert_eq!((*limit, at.file.as_str()), (wanted, "limits.wgsl"), "{error}");
    at.line
}

#[test]
fn operations_are_bounded_however_they_arise() {
    let default = u64::from(CodeLimits::default().operations);
    // Calls that double fifty times.
    let mut doubling = "fn f0(x: u32) -> u32 { return x * 3u + o[x & 3u]; }\n".to_owned();
    for n in 1..50 {
        let before = n - 1;
        doubling += &format!("fn f{n}(x: u32) -> u32 {{ return f{before}(x) + f{before}(x + 1u); }}\n");
    }
    let line = refused(run(&(doubling + &main_of("o[0] = f49(i);")), Config::default()), "operations", default);
    assert!((2..=51).contains(&line), "line {line} is none of the functions");
    // Memory as values: initialised, zero, copied, indexed.
    for body in [
        "var a: array<u32, 1000000>;\na[5] = i; o[0] = a[7];",
        "let a = array<u32, 1000000>();\nvar b = a; o[0] = b[7];",
        "var a: array<u32, 60000>;\nvar b = a; b[1] = i; var c = b; c[i] = 1u; o[0] = c[3];",
    ] {
        assert!((4..=5).contains(&refused(run(&main_of(body), Config::default()), "operations", default)), "{body}");
    }
    let few = limits(CodeLimits { operations: 40, ..CodeLimits::default() });
    assert_eq!(refused(run(&main_of(&"o[1] += i;\n".repeat(40)), few), "operations", 40), 8);
    assert!(run(&main_of("o[1] += 1u;"), few).is_ok());
}

/// Nesting that the text does not show: each of `calls` functions nests `ifs` branches on `x` around a call of the
/// next.
fn nested(calls: usize, ifs: usize, x: &str) -> String {
    let mut text = "fn f0(x: u32) { if x == 15u { o[0] = 77u; } }\n".to_owned();
    for n in 1..=calls {
        let open: String = (0..ifs).map(|k| format!("if x != {}u {{ ", 1000 + n * ifs + k)).collect();
        text += &format!("fn f{n}(x: u32) {{ {open} f{}(x); {} }}\n", n - 1, "}".repeat(ifs));
    }
    text + &main_of(&format!("f{calls}({x});"))
}

/// A switch of so many cases on `x`.
fn switch(cases: usize, x: &str) -> String {
    let cases: String = (0..cases).map(|k| format!("case {}u: {{ o[0] = {k}u; }}\n", k * 3)).collect();
    main_of(&format!("switch {x} {{ {cases} default: {{}} }}"))
}

#[test]
fn nesting_is_bounded_and_what_is_allowed_runs() {
    const UNIFORM: &str = "o[3] + 12u";
    let default = u64::from(CodeLimits::default().depth);
    let deep = limits(CodeLimits { depth: 2000, ..CodeLimits::default() });
    for text in [nested(10, 100, UNIFORM), nested(600, 0, "i"), switch(2_000, "i")] {
        refused(run(&text, Config::default()), "levels", default);
    }
    for (text, word) in [(nested(4, 110, UNIFORM), 77u32), (nested(2, 110, "i"), 77), (switch(400, UNIFORM), 5)] {
        let words = run(&text, Config::default()).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(words[..4], word.to_le_bytes());
    }
    let words = run(&nested(12, 120, UNIFORM), deep).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(words[..4], 77u32.to_le_bytes());
    // Masks are numbered in a byte.
    refused(run(&switch(400, "i"), Config::default()), "places at once", 256);
}

#[test]
fn private_memory_is_bounded() {
    let default = CodeLimits::default().private;
    let body = |words: u32| main_of(&format!("var a: array<u32, {words}>;\na[i] = 5u; o[0] = a[o[1]];"));
    assert_eq!(refused(run(&body(default / 4 + 1), Config::default()), "private memory", default.into()), 4);
    assert!(run(&body(default / 4), Config::default()).is_ok());
    let global = format!("var<private> a: array<u32, 200>;\n{}", main_of("a[i] = 5u; o[0] = a[o[1]];"));
    let small = limits(CodeLimits { private: 796, ..CodeLimits::default() });
    assert_eq!(refused(run(&global, small), "private memory", 796), 2);
}

#[test]
fn registers_are_bounded() {
    let text = |words: usize| {
        let head = format!("@group(0) @binding(0) var<storage, read_write> o: array<u32, {words}>;\n");
        run_on(&vec![7; words], &(head + &main_of("let all = o;\no[i] = 1u;\no = all;")), Config::default())
    };
    assert_eq!(refused(text(40_000), "alive", 0x7fff), 4);
    assert_eq!(text(30_000).unwrap_or_else(|e| panic!("{e}")), 7u32.to_le_bytes().repeat(30_000));
}

#[test]
fn gangs_count_as_memory() {
    let config = Config { memory: 1 << 14, ..Config::default() };
    let private = "var a: array<u32, 1024>;\na[i] = 5u; o[0] = a[o[1]];";
    let error = run(&main_of(private), config).expect_err("16 lanes of 4 KiB");
    let ErrorKind::Trap(trap) = error.kind() else { panic!("{error}") };
    let TrapKind::OutOfMemory { wanted, limit } = trap.kind else { panic!("{error}") };
    assert!(limit == 1 << 14 && wanted > 16 * 4096 && wanted < 20 * 4096, "{error}");
    assert!(run(&main_of("o[0] = o[1];"), config).is_ok());
}

#[test]
fn long_texts_lower_in_time() {
    // Many variables known over many blocks, many of them used late: each has been quadratic.
    let blocks = "if i == 3u { o[0] = 1u; }\n".repeat(4000);
    let body =
        format!("var a: array<u32, 20000>;\na[0] = i;\n{blocks}if i > 2u {{ var b = a; o[1] = b[77]; }}\n{blocks}");
    assert!(run(&main_of(&body), Config::default()).is_ok());
    let long = "x = x * 5u + o[i & 3u];\n".repeat(10_000);
    assert!(
        run(&main_of(&format!("var x = i;\nfor (var k = 0u; k < 2u; k++) {{\n{long}}}\no[0] = x;")), Config::default())
            .is_ok()
    );
    let loops = "for (var k = 0u; k < 1u; k++) { ".repeat(100) + "o[0] += i;" + &"}".repeat(100);
    assert!(run(&main_of(&loops), Config::default()).is_ok());
}

/// The most turns of loops of an invocation of `main`, on one thread or two.
fn turns(body: &str, threads: usize, count: bool) -> Option<u64> {
    let text = format!("{HEAD}{}", main_of(body));
    let program = Program::unlinted("turns", Linked::single("turns.wgsl", &text).unwrap()).unwrap();
    let mut job = Job::new();
    let id = job.program(&program);
    let buffer = job.upload("o", &[0; 64]);
    job.dispatch(id, "main", &[(0, buffer)], [40, 3, 1]);
    let backend = CpuBackend::new(Config { threads, count, ..Config::default() });
    let mut session = backend.open(&job.programs, &job.buffers).unwrap();
    job.recordings.iter().for_each(|recording| session.submit(recording).unwrap());
    session.counts().map(|counts| counts.turns)
}

#[test]
fn turns_of_loops_are_those_of_the_longest_invocation() {
    let halvings = |i: u64| {
        let mut n = i * 100;
        let rounds = std::iter::from_fn(|| {
            n /= 2;
            (n >= 10).then_some(())
        });
        rounds.count() as u64 + 1
    };
    // A loop of n rounds turns n + 1 times: the last turn finds its end.
    let cases: [(&str, &dyn Fn(u64) -> u64); 6] = [
        ("o[i] = i;", &|_| 0),
        ("for (var k = 0u; k < 5u; k++) { o[i] += k; }", &|_| 6),
        ("for (var k = 0u; k < i; k++) { o[i] += k; }", &|i| i + 1),
        ("for (var k = 0u; k < i; k++) { for (var m = i; m < 15u; m++) { o[i] += m; } }", &|i| {
            i + 1 + i * (15 - i + 1)
        }),
        ("var n = i * 100u; loop { n /= 2u; if n < 10u { break; } if n > 90u { continue; } o[i] += n; }", &halvings),
        ("for (var k = 0u; k < 300u; k++) { if k == i + 200u { return; } o[i] += k; }", &|i| i + 201),
    ];
    for (body, of) in cases {
        for threads in [1, 2] {
            assert_eq!(turns(body, threads, true), (0..16).map(of).max(), "{body}");
        }
    }
    assert_eq!(turns("o[i] = i;", 1, false), None);
}

#[test]
fn deep_nests_of_short_loops_stay_within_the_limit_of_operations() {
    let nest = |depth: usize, rounds: u32| {
        let open: String = (0..depth).map(|n| format!("for (var k{n} = 0u; k{n} < {rounds}u; k{n}++) {{ ")).collect();
        main_of(&format!("{open} o[i & 3u] += k0; {}", "}".repeat(depth)))
    };
    // Written out these would be 60^8 and 4^20 statements.
    for (depth, rounds) in [(8, 60), (20, 4)] {
        let program =
            Program::unlinted("nest", Linked::single("nest.wgsl", &format!("{HEAD}{}", nest(depth, rounds))).unwrap());
        let code = CpuBackend::lowered(&program.unwrap(), "main", &[]).unwrap();
        assert!(code.instructions() < 10_000, "{} instructions of {depth} loops", code.instructions());
    }
    let few = limits(CodeLimits { operations: 100, ..CodeLimits::default() });
    assert!(run(&nest(2, 2), Config::default()).is_ok());
    refused(run(&nest(3, 60), few), "operations", 100);
}
