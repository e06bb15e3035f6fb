//! Random statements as a tree, so that a failing program can lose them one by one.

use super::expression::{Scope, Variable};
use super::types::{BOOL, F32, I32, Scalar, Type, U32};

/// A statement: text around blocks. `heads[i]` stands before `blocks[i]`, `tail` after the last.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Statement {
    pub heads: Vec<String>,
    pub blocks: Vec<Vec<Statement>>,
    pub tail: String,
}

impl Statement {
    pub(crate) fn line(text: String) -> Self {
        Statement { heads: Vec::new(), blocks: Vec::new(), tail: text }
    }

    fn block(head: String, body: Vec<Statement>) -> Self {
        Statement { heads: vec![head], blocks: vec![body], tail: "}".to_owned() }
    }

    pub(crate) fn render(&self, indent: usize, out: &mut String) {
        let pad = "    ".repeat(indent);
        for (head, block) in self.heads.iter().zip(&self.blocks) {
            out.push_str(&format!("{pad}{head}\n"));
            for statement in block {
                statement.render(indent + 1, out);
            }
        }
        out.push_str(&format!("{pad}{}\n", self.tail));
    }
}

/// A function that may be called.
#[derive(Clone)]
pub(crate) struct Callee {
    pub name: String,
    pub values: Vec<Type>,
    /// What it takes a pointer to, if anything.
    pub pointer: Option<Type>,
    pub result: Type,
    pub cost: u64,
}

/// Where statements are being made.
pub(crate) struct Body<'a, 'r> {
    pub scope: &'a mut Scope<'r>,
    pub callees: &'a [Callee],
    /// Type to return; none in the entry point.
    pub result: Option<Type>,
    /// Whether returns are allowed here.
    pub returns: bool,
    /// Words of `out` that each invocation owns; none in a function.
    pub outputs: Option<usize>,
    pub atomics: Vec<String>,
    /// How often the present block runs, at most.
    pub times: u64,
    pub cost: u64,
    pub names: usize,
}

/// Which jumps are legal.
#[derive(Clone, Copy, Default)]
pub(crate) struct Jumps {
    pub breaks: bool,
    pub continues: bool,
}

/// Most that one function may cost.
const LIMIT: u64 = 700;

impl Body<'_, '_> {
    pub(crate) fn fresh(&mut self, prefix: &str) -> String {
        self.names += 1;
        format!("{prefix}{}", self.names)
    }

    pub(crate) fn block(&mut self, depth: usize, jumps: Jumps) -> Vec<Statement> {
        let outer = self.scope.variables.len();
        let count = 1 + self.scope.random.below(if depth > 2 { 6 } else { 4 });
        let mut statements = Vec::new();
        for _ in 0..count {
            self.cost += self.times;
            statements.extend(self.statement(depth, jumps));
        }
        statements.extend(self.jump(jumps));
        self.scope.variables.truncate(outer);
        statements
    }

    fn condition(&mut self) -> String {
        self.scope.expression(&BOOL, 3)
    }

    /// A jump at the end of a block, seldom; in front of it a condition, or not.
    fn jump(&mut self, jumps: Jumps) -> Option<Statement> {
        let mut choices = Vec::new();
        if jumps.breaks {
            choices.push("break;".to_owned());
        }
        if jumps.continues {
            choices.push("continue;".to_owned());
        }
        if self.returns && self.scope.random.chance(25) {
            let value = self.result.clone().map(|ty| self.scope.expression(&ty, 2));
            choices.push(value.map_or("return;".to_owned(), |v| format!("return {v};")));
        }
        if choices.is_empty() || !self.scope.random.chance(30) {
            return None;
        }
        let jump = self.scope.random.pick(&choices).clone();
        if self.scope.random.chance(30) {
            return Some(Statement::line(jump));
        }
        let condition = self.condition();
        Some(Statement::block(format!("if {condition} {{"), vec![Statement::line(jump)]))
    }

    fn statement(&mut self, depth: usize, jumps: Jumps) -> Vec<Statement> {
        let compound = depth > 0 && self.cost < LIMIT;
        match self.scope.random.below(20) {
            0..=2 if compound => vec![self.branch(depth - 1, jumps)],
            3 if compound => vec![self.switch(depth - 1, jumps)],
            4 | 5 if compound && self.times < 100 => self.repeat(depth - 1),
            6 if compound => {
                let body = self.block(depth - 1, jumps);
                vec![Statement::block("{".to_owned(), body)]
            }
            7 | 8 => self.call(),
            13 if self.scope.wild && self.outputs.is_some() => vec![self.reckless()],
            9 | 10 => vec![self.declare()],
            11 if self.outputs.is_some() => vec![self.output()],
            12 if !self.atomics.is_empty() => vec![self.atomic()],
            13 => self.alias(),
            14 => self.jump(jumps).into_iter().collect(),
            _ => vec![self.assign()],
        }
    }

    fn assign(&mut self) -> Statement {
        let Some((place, ty)) = self.scope.target() else { return self.declare() };
        let random = &mut self.scope.random;
        let text = match &ty {
            Type::Scalar(Scalar::I32 | Scalar::U32) if random.chance(15) => {
                format!("{place}{};", if random.chance(50) { "++" } else { "--" })
            }
            Type::Scalar(Scalar::I32 | Scalar::U32) | Type::Vector(_, Scalar::I32 | Scalar::U32)
                if random.chance(40) =>
            {
                let op = *random.pick(&["+=", "-=", "*=", "^=", "|=", "&=", "/=", "%="]);
                format!("{place} {op} {};", self.scope.expression(&ty, 2))
            }
            Type::Scalar(Scalar::F32) | Type::Vector(_, Scalar::F32) if random.chance(40) => {
                let op = *random.pick(&["+=", "-=", "*=", "/="]);
                format!("{place} {op} {};", self.scope.expression(&ty, 2))
            }
            _ => format!("{place} = {};", self.scope.expression(&ty, 4)),
        };
        Statement::line(text)
    }

    fn declare(&mut self) -> Statement {
        let structs = self.scope.structs.len();
        let ty = Type::any(&mut self.scope.random, structs);
        let name = self.fresh("v");
        let variable = self.scope.random.chance(60);
        let text = match (variable, self.scope.random.chance(40)) {
            (true, true) => format!("var {name}: {};", ty.name()),
            (true, false) => format!("var {name} = {};", self.scope.expression(&ty, 3)),
            (false, _) => format!("let {name} = {};", self.scope.expression(&ty, 3)),
        };
        // A value cannot be indexed by a computed index if it holds a matrix.
        let readable = variable || matches!(ty, Type::Scalar(_) | Type::Vector(..));
        if readable {
            self.scope.variables.push(Variable { name, ty, writable: variable });
        }
        Statement::line(text)
    }

    fn output(&mut self) -> Statement {
        let words = self.outputs.unwrap_or(1);
        let index = self.scope.expression(&U32, 2);
        let ty = Type::Scalar(*self.scope.random.pick(&[Scalar::U32, Scalar::I32, Scalar::F32]));
        let value = self.scope.expression(&ty, 4);
        let value = if ty == F32 { format!("bits({value})") } else { format!("u32({value})") };
        let op = *self.scope.random.pick(&["=", "=", "+=", "^="]);
        Statement::line(format!("out[own * {words}u + ({index}) % {words}u] {op} {value};"))
    }

    /// What only a wild program does: a race, or a barrier that not all may reach.
    fn reckless(&mut self) -> Statement {
        let (index, value) = (self.scope.expression(&U32, 2), self.scope.expression(&U32, 2));
        Statement::line(match self.scope.random.below(5) {
            0 => format!("if (out[{index}] ^ {}u) % 3u == 0u {{ workgroupBarrier(); }}", self.scope.random.below(3)),
            1 => format!("ring[{index}] ^= {value};"),
            2 => format!("pond[{index}] = {value};"),
            3 => format!("out[{index}] = out[{value}];"),
            _ => format!("hidden[1] = atomicAdd(&tally[{index}], {value});"),
        })
    }

    /// One of the operations that the phase allows, its operand filled in for `$`.
    fn atomic(&mut self) -> Statement {
        let pattern = self.scope.random.pick(&self.atomics.clone()).clone();
        let (index, value) = (self.scope.expression(&U32, 2), self.scope.expression(&U32, 2));
        Statement::line(pattern.replace("$i", &index).replace("$v", &value))
    }

    /// A pointer to a place, whose index must not be evaluated again.
    fn alias(&mut self) -> Vec<Statement> {
        let own = |v: &Variable| v.writable && v.name.starts_with('v');
        let candidates: Vec<Variable> = self.scope.variables.iter().filter(|v| own(v)).cloned().collect();
        let arrays: Vec<&Variable> = candidates.iter().filter(|v| matches!(v.ty, Type::Array(..))).collect();
        if arrays.is_empty() {
            return vec![self.assign()];
        }
        let array = (*self.scope.random.pick(&arrays)).clone();
        let Type::Array(element, _) = array.ty else { return vec![] };
        let name = self.fresh("p");
        let ty = if self.scope.random.chance(50) { U32 } else { I32 };
        let index = self.scope.expression(&ty, 2);
        let pointer = Statement::line(format!("let {name} = &{}[{index}];", array.name));
        let between = self.assign();
        let value = self.scope.expression(&element, 3);
        vec![pointer, between, Statement::line(format!("*{name} = {value};"))]
    }

    fn branch(&mut self, depth: usize, jumps: Jumps) -> Statement {
        let mut heads = vec![format!("if {} {{", self.condition())];
        let mut blocks = vec![self.block(depth, jumps)];
        if self.scope.random.chance(25) {
            heads.push(format!("}} else if {} {{", self.condition()));
            blocks.push(self.block(depth, jumps));
        }
        if self.scope.random.chance(50) {
            heads.push("} else {".to_owned());
            blocks.push(self.block(depth, jumps));
        }
        Statement { heads, blocks, tail: "}".to_owned() }
    }

    fn switch(&mut self, depth: usize, jumps: Jumps) -> Statement {
        let signed = self.scope.random.chance(50);
        let (ty, suffix) = if signed { (I32, "") } else { (U32, "u") };
        let modulus = 3 + self.scope.random.below(4);
        let selector = self.scope.expression(&ty, 3);
        let mut heads = vec![format!("switch ({selector}) % {modulus}{suffix} {{")];
        let mut blocks = vec![Vec::new()];
        let jumps = Jumps { breaks: true, ..jumps };
        let default = self.scope.random.below(3);
        let mut value = if signed { 1 - modulus as i64 } else { 0 };
        for case in 0..3 {
            let mut values = vec![format!("{value}{suffix}")];
            value += 1 + self.scope.random.below(2) as i64;
            if self.scope.random.chance(40) {
                values.push(format!("{value}{suffix}"));
                value += 1;
            }
            let close = if case == 0 { "" } else { "} " };
            if case == default {
                values.push("default".to_owned());
            }
            heads.push(format!("{close}case {}: {{", values.join(", ")));
            blocks.push(self.block(depth, jumps));
        }
        Statement { heads, blocks, tail: "} }".to_owned() }
    }

    /// A loop of one of WGSL's forms, bounded by a counter of its own.
    fn repeat(&mut self, depth: usize) -> Vec<Statement> {
        let counter = self.fresh("k");
        let trips = 1 + self.scope.random.below(6) as u64;
        let bound = if self.scope.random.chance(50) {
            format!("{trips}u")
        } else {
            format!("({}) % {}u", self.scope.expression(&U32, 2), trips + 1)
        };
        self.times *= trips;
        let jumps = Jumps { breaks: true, continues: true };
        if self.scope.wild && self.scope.random.chance(25) {
            let body = self.block(depth, jumps);
            self.times /= trips;
            return vec![Statement::block(format!("while {} {{", self.condition()), body)];
        }
        self.scope.variables.push(Variable { name: counter.clone(), ty: U32, writable: false });
        let statements = match self.scope.random.below(4) {
            0 | 1 => {
                let body = self.block(depth, jumps);
                vec![Statement::block(format!("for (var {counter} = 0u; {counter} < {bound}; {counter}++) {{"), body)]
            }
            2 => {
                let mut body = self.block(depth, jumps);
                body.insert(0, Statement::line(format!("{counter}++;")));
                let start = Statement::line(format!("var {counter} = 0u;"));
                vec![start, Statement::block(format!("while {counter} < {bound} {{"), body)]
            }
            _ => self.full_loop(&counter, &bound, depth, jumps),
        };
        self.times /= trips;
        self.scope.variables.pop();
        statements
    }

    /// `loop` with a continuing block and perhaps `break if`.
    fn full_loop(&mut self, counter: &str, bound: &str, depth: usize, jumps: Jumps) -> Vec<Statement> {
        let body = self.block(depth, jumps);
        let returns = std::mem::replace(&mut self.returns, false);
        let mut continuing = self.block(0, Jumps::default());
        self.returns = returns;
        continuing.insert(0, Statement::line(format!("{counter}++;")));
        let condition = if self.scope.random.chance(50) { self.condition() } else { "false".to_owned() };
        continuing.push(Statement::line(format!("break if ({counter} >= {bound}) || {condition};")));
        vec![
            Statement::line(format!("var {counter} = 0u;")),
            Statement {
                heads: vec!["loop {".to_owned(), "    continuing {".to_owned()],
                blocks: vec![body, continuing],
                tail: "} }".to_owned(),
            },
        ]
    }

    fn call(&mut self) -> Vec<Statement> {
        let affordable = |c: &&Callee| (c.cost + 1) * self.times + self.cost < 2 * LIMIT;
        let affordable: Vec<Callee> = self.callees.iter().filter(affordable).cloned().collect();
        if affordable.is_empty() {
            return vec![self.assign()];
        }
        let callee = self.scope.random.pick(&affordable).clone();
        let mut statements = Vec::new();
        let mut arguments: Vec<String> = callee.values.iter().map(|ty| self.scope.expression(ty, 3)).collect();
        if let Some(ty) = &callee.pointer {
            let own = |v: &Variable| v.writable && v.name.starts_with('v') && v.ty == *ty;
            let known: Vec<String> = self.scope.variables.iter().filter(|v| own(v)).map(|v| v.name.clone()).collect();
            let name = if known.is_empty() {
                let name = self.fresh("v");
                statements.push(Statement::line(format!("var {name} = {};", self.scope.expression(ty, 2))));
                self.scope.variables.push(Variable { name: name.clone(), ty: ty.clone(), writable: true });
                name
            } else {
                self.scope.random.pick(&known).clone()
            };
            arguments.push(format!("&{name}"));
        }
        self.cost += callee.cost * self.times;
        let call = format!("{}({})", callee.name, arguments.join(", "));
        let place = self.scope.place(&callee.result, true, 1);
        statements.push(Statement::line(match place {
            Some(place) => format!("{place} = {call};"),
            None => format!("_ = {call};"),
        }));
        statements
    }
}
