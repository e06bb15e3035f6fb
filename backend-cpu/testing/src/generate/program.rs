//! Whole programs: structures, functions, phases between barriers, buffers.

use std::fmt::Write;

use super::expression::{Scope, Variable};
use super::random::Random;
use super::statement::{Body, Callee, Jumps, Statement};
use super::types::{Scalar, Type, U32};

/// Words of `out` that an invocation owns.
const OUTPUTS: usize = 8;
/// Words of `records` for an invocation: no less than a structure of four members takes.
const RECORD_WORDS: usize = 64;
/// Elements of the shared atomic arrays.
const CELLS: usize = 8;

/// A program as trees of statements under fixed text.
#[derive(Clone)]
pub struct Generated {
    /// Directives and declarations.
    head: String,
    /// Signature and body of each function; the entry point comes last.
    pub(super) functions: Vec<(String, Vec<Statement>)>,
}

impl Generated {
    /// The program as a file of `tests/shaders`, without its expectations.
    pub fn render(&self) -> String {
        let mut text = self.head.clone();
        for (signature, body) in &self.functions {
            let _ = writeln!(text, "\n{signature} {{");
            for statement in body {
                statement.render(1, &mut text);
            }
            text.push_str("}\n");
        }
        text
    }
}

/// The program that `bytes` choose; the same bytes make the same program.
pub fn generate(bytes: &[u8]) -> Generated {
    make(bytes, false)
}

/// A program that may run on for ever, race, and meet barriers in divergent control flow.
pub fn generate_wild(bytes: &[u8]) -> Generated {
    make(bytes, true)
}

fn make(bytes: &[u8], wild: bool) -> Generated {
    let mut random = Random::new(bytes);
    let mut structs: Vec<Vec<Type>> = Vec::new();
    for index in 0..1 + random.below(3) {
        let members = 1 + random.below(4);
        structs.push((0..members).map(|_| Type::any(&mut random, index)).collect());
    }
    // The last structure is that of the buffer `records`.
    let members = 1 + random.below(4);
    structs.push((0..members).map(|_| Type::shareable(&mut random)).collect());
    let mut scope = Scope { random, structs, variables: Vec::new(), shared: Vec::new(), wild };
    let (mut functions, mut callees) = (Vec::new(), Vec::new());
    for index in 0..scope.random.below(4) {
        let (function, callee) = function(&mut scope, index, &callees);
        functions.push(function);
        callees.push(callee);
    }
    let [shape, groups] = launch(&mut scope.random);
    let (entry, cost) = entry(&mut scope, &callees, shape);
    let groups = if cost > 600 { [1, 1, 1] } else { groups };
    functions.push(entry);
    let head = head(&mut scope, shape, groups);
    Generated { head, functions }
}

/// Workgroup size and number of workgroups.
fn launch(random: &mut Random<'_>) -> [[u32; 3]; 2] {
    let shapes =
        [[1, 1, 1], [7, 1, 1], [16, 1, 1], [33, 1, 1], [64, 1, 1], [8, 8, 1], [4, 3, 5], [128, 1, 1], [16, 4, 4]];
    let groups = [[1, 1, 1], [2, 1, 1], [3, 1, 1], [2, 2, 1], [1, 3, 2], [9, 1, 1]];
    let shape = *random.pick(&shapes);
    let group = *random.pick(if shape.iter().product::<u32>() > 64 { &groups[..2] } else { &groups });
    [shape, group]
}

fn base_variables() -> Vec<Variable> {
    let read = |name: &str| Variable { name: name.to_owned(), ty: U32, writable: false };
    let ids = ["local_", "global_"].map(|name| Variable { ty: Type::Vector(3, Scalar::U32), ..read(name) });
    [read("lane"), read("own")].into_iter().chain(ids).collect()
}

fn function(scope: &mut Scope<'_>, index: usize, callees: &[Callee]) -> ((String, Vec<Statement>), Callee) {
    let structs = scope.structs.len();
    let values: Vec<Type> = (0..1 + scope.random.below(3)).map(|_| Type::small(&mut scope.random)).collect();
    let pointer = scope.random.chance(60).then(|| Type::any(&mut scope.random, structs));
    let result = Type::any(&mut scope.random, structs);
    scope.variables = base_variables();
    let mut parameters = Vec::new();
    for (at, ty) in values.iter().enumerate() {
        parameters.push(format!("a{at}: {}", ty.name()));
        if !matches!(ty, Type::Matrix(..)) {
            scope.variables.push(Variable { name: format!("a{at}"), ty: ty.clone(), writable: false });
        }
    }
    if let Some(ty) = &pointer {
        parameters.push(format!("target_: ptr<function, {}>", ty.name()));
        scope.variables.push(Variable { name: "(*target_)".to_owned(), ty: ty.clone(), writable: true });
    }
    scope.variables.push(Variable { name: "hidden".to_owned(), ty: Type::Array(Box::new(U32), 3), writable: true });
    let mut body = Body {
        scope,
        callees,
        result: Some(result.clone()),
        returns: true,
        outputs: None,
        atomics: Vec::new(),
        times: 1,
        cost: 0,
        names: 0,
    };
    let mut statements = vec![Statement::line("let lane = lane_; let own = own_;".to_owned())];
    statements.extend(body.block(2, Jumps::default()));
    let cost = body.cost;
    let value = scope.expression(&result, 3);
    statements.push(Statement::line(format!("return {value};")));
    let name = format!("f{index}");
    let signature = format!("fn {name}({}) -> {}", parameters.join(", "), result.name());
    ((signature, statements), Callee { name, values, pointer, result, cost })
}

/// How workgroup memory may be used until the next barrier.
fn phase(scope: &mut Scope<'_>, width: u32, atomics: &mut Vec<String>) -> Vec<Variable> {
    scope.shared.clear();
    atomics.clear();
    let mut own = Vec::new();
    for name in ["ring", "pond"] {
        if scope.random.chance(50) {
            let variable = |place: String| Variable { name: place, ty: U32, writable: true };
            own.push(variable(format!("{name}[lane]")));
        } else {
            scope.shared.push(match (name, scope.random.below(3)) {
                ("ring", 0) => "ring[lane + 1u]",
                ("ring", 1) => "ring[input[lane]]",
                ("ring", _) => "ring[params[1].y % 5u]",
                (_, 0) => "pond[(lane + 3u) / 2u]",
                (_, 1) => "pond[params[0].x]",
                _ => "pond[0]",
            });
        }
    }
    if scope.random.chance(50) {
        let fun = *scope.random.pick(&[
            "atomicAdd",
            "atomicSub",
            "atomicAnd",
            "atomicOr",
            "atomicXor",
            "atomicMin",
            "atomicMax",
        ]);
        atomics.push(format!("{fun}(&tally[($i) % {width}u], $v);"));
    } else {
        scope.shared.push("atomicLoad(&tally[lane / 2u])");
    }
    own
}

fn entry(scope: &mut Scope<'_>, callees: &[Callee], shape: [u32; 3]) -> ((String, Vec<Statement>), u64) {
    let width = shape.iter().product::<u32>();
    scope.variables = base_variables();
    scope.variables.push(Variable { name: "hidden".to_owned(), ty: Type::Array(Box::new(U32), 3), writable: true });
    let record = Type::Struct(scope.structs.len() - 1);
    scope.variables.push(Variable { name: "records[own]".to_owned(), ty: record, writable: true });
    let mut statements = vec![Statement::line(
        "lane_ = lane; local_ = local; global_ = global; own_ = (group.x + groups.x * (group.y + groups.y * group.z)) * WIDTH + lane; let own = own_;"
            .to_owned(),
    )];
    for at in 0..2 + scope.random.below(5) {
        let ty = Type::any(&mut scope.random, scope.structs.len());
        let name = format!("v_{at}");
        let value = scope.expression(&ty, 2);
        let initialised = scope.random.chance(50);
        statements.push(Statement::line(match initialised {
            true => format!("var {name} = {value};"),
            false => format!("var {name}: {};", ty.name()),
        }));
        scope.variables.push(Variable { name, ty, writable: true });
    }
    let lasting = scope.variables.len();
    let fun = *scope.random.pick(&["atomicAdd", "atomicXor", "atomicOr", "atomicMax"]);
    let signed = *scope.random.pick(&["atomicSub", "atomicMin", "atomicAnd", "atomicMax"]);
    let global = [
        format!("{fun}(&cells[($i) % {CELLS}u], $v);"),
        format!("{signed}(&signed_cells[($i) % {CELLS}u], bitcast<i32>($v));"),
        "hidden[0] = atomicAdd(&mine[own], $v) ^ ($i);".to_owned(),
        "hidden[1] += u32(atomicCompareExchangeWeak(&mine[own], ($i) % 3u, $v).exchanged);".to_owned(),
        "hidden[2] = atomicMax(&mine[own], $v) + atomicExchange(&mine[own], $i);".to_owned(),
        "atomicStore(&mine[own], $v);".to_owned(),
        "hidden[1] ^= atomicLoad(&mine[own]);".to_owned(),
    ];
    let phases = 1 + scope.random.below(4);
    let (mut cost, mut names) = (0, 0);
    for at in 0..phases {
        let mut atomics = Vec::new();
        let own = phase(scope, width, &mut atomics);
        let mut now = own.clone();
        scope.variables.append(&mut now);
        atomics.extend(global.iter().cloned());
        let last = at + 1 == phases;
        let (times, outputs) = (1, Some(OUTPUTS));
        let mut body =
            Body { scope: &mut *scope, callees, result: None, returns: last, outputs, atomics, times, cost: 0, names };
        let made = body.block(3, Jumps::default());
        (cost, names) = (cost + body.cost, body.names);
        scope.variables.truncate(lasting);
        let looped = !last && scope.random.chance(30);
        if looped {
            let turns = 1 + scope.random.below(3);
            let mut inner = made;
            inner.push(Statement::line("workgroupBarrier();".to_owned()));
            let head = format!("for (var t{at} = 0u; t{at} < params[2].x % 3u + {turns}u; t{at}++) {{");
            statements.push(Statement { heads: vec![head], blocks: vec![inner], tail: "}".to_owned() });
        } else {
            statements.push(Statement { heads: vec!["{".into()], blocks: vec![made], tail: "}".into() });
        }
        if !last {
            statements.push(Statement::line("workgroupBarrier();".to_owned()));
            if scope.random.chance(30) {
                let index = scope.random.below(width as usize);
                let load = *scope.random.pick(&[
                    "hidden[2] ^= workgroupUniformLoad(&ring[$]);",
                    "hidden[2] ^= workgroupUniformLoad(&tally[$]);",
                    "storageBarrier(); hidden[2] += pond[$]; workgroupBarrier();",
                ]);
                statements.push(Statement::line(load.replace('$', &index.to_string())));
            }
        }
    }
    scope.shared.clear();
    for at in 0..OUTPUTS {
        let ty = Type::Scalar(*scope.random.pick(&[Scalar::U32, Scalar::I32, Scalar::F32, Scalar::Bool]));
        let value = scope.expression(&ty, 2);
        let word = if ty == Type::Scalar(Scalar::F32) { format!("bits({value})") } else { format!("u32({value})") };
        statements.push(Statement::line(format!("out[own * {OUTPUTS}u + {at}u] ^= {word};")));
    }
    let signature = format!(
        "@compute @workgroup_size({}, {}, {})\nfn main(\n    @builtin(local_invocation_index) lane: u32,\n    \
         @builtin(local_invocation_id) local: vec3<u32>,\n    @builtin(global_invocation_id) global: vec3<u32>,\n    \
         @builtin(workgroup_id) group: vec3<u32>,\n    @builtin(num_workgroups) groups: vec3<u32>,\n)",
        shape[0], shape[1], shape[2]
    );
    ((signature, statements), cost)
}

fn head(scope: &mut Scope<'_>, shape: [u32; 3], groups: [u32; 3]) -> String {
    let width = shape.iter().product::<u32>();
    let invocations = width * groups.iter().product::<u32>();
    let mut words = |n: usize| (0..n).map(|_| scope.random.word().to_string()).collect::<Vec<_>>().join(" ");
    let record = scope.structs.len() - 1;
    let (input, params, cells) = (words(64), words(16), words(CELLS));
    let mut head = format!(
        "//! buffer 0: u32 {input}\n\
         //! buffer 1: u32 {params}\n\
         //! buffer 2: zero {}\n\
         //! buffer 3: u32 {cells}\n\
         //! buffer 4: u32 {cells}\n\
         //! buffer 5: zero {invocations}\n\
         //! buffer 6: zero {}\n\
         //! dispatch: main {} {} {}\n\n\
         const WIDTH = {width}u;\n\
         @group(0) @binding(0) var<storage, read> input: array<u32>;\n\
         @group(0) @binding(1) var<uniform> params: array<vec4<u32>, 4>;\n\
         @group(0) @binding(2) var<storage, read_write> out: array<u32>;\n\
         @group(0) @binding(3) var<storage, read_write> cells: array<atomic<u32>, {CELLS}>;\n\
         @group(0) @binding(4) var<storage, read_write> signed_cells: array<atomic<i32>, {CELLS}>;\n\
         @group(0) @binding(5) var<storage, read_write> mine: array<atomic<u32>>;\n\
         @group(0) @binding(6) var<storage, read_write> records: array<S{record}>;\n\
         var<workgroup> ring: array<u32, {width}>;\n\
         var<workgroup> pond: array<u32, {width}>;\n\
         var<workgroup> tally: array<atomic<u32>, {width}>;\n\
         var<private> lane_: u32;\n\
         var<private> own_: u32;\n\
         var<private> local_: vec3<u32>;\n\
         var<private> global_: vec3<u32>;\n\
         var<private> hidden: array<u32, 3>;\n\n\
         fn bits(x: f32) -> u32 {{ return select(bitcast<u32>(x), 0x7fc00000u, x != x); }}\n",
        invocations as usize * OUTPUTS,
        invocations as usize * RECORD_WORDS,
        groups[0],
        groups[1],
        groups[2],
    );
    for (index, members) in scope.structs.iter().enumerate() {
        let members: Vec<String> = members.iter().enumerate().map(|(i, m)| format!("m{i}: {}", m.name())).collect();
        let _ = write!(head, "\nstruct S{index} {{ {} }}\n", members.join(", "));
    }
    head
}
