//! Facts about functions that building needs before it starts: which variables are indexed at run time, who returns
//! early.

use std::collections::{HashMap, HashSet};

use naga::{Block, Expression, Function, GlobalVariable, Handle, LocalVariable, Module, Statement};

/// Which variables must live in memory that can be indexed at run time.
pub(super) struct Scan {
    locals: HashMap<*const Function, HashSet<Handle<LocalVariable>>>,
    arguments: HashMap<Handle<Function>, HashSet<u32>>,
    privates: HashSet<Handle<GlobalVariable>>,
}

enum Origin {
    Local(Handle<LocalVariable>),
    Argument(u32),
    Global(Handle<GlobalVariable>),
}

impl Scan {
    pub(super) fn new(module: &Module) -> Self {
        let mut scan = Scan { locals: HashMap::new(), arguments: HashMap::new(), privates: HashSet::new() };
        for (handle, function) in module.functions.iter() {
            let arguments = scan.function(function);
            scan.arguments.insert(handle, arguments);
        }
        for entry in &module.entry_points {
            scan.function(&entry.function);
        }
        scan
    }

    pub(super) fn dynamic_locals(&self, function: &Function) -> HashSet<Handle<LocalVariable>> {
        self.locals.get(&std::ptr::from_ref(function)).cloned().unwrap_or_default()
    }

    pub(super) fn private_is_dynamic(&self, handle: Handle<GlobalVariable>) -> bool {
        self.privates.contains(&handle)
    }

    /// Scans one function, callees before callers; the result is its arguments that are indexed at run time.
    fn function(&mut self, function: &Function) -> HashSet<u32> {
        let mut origins = Vec::new();
        for (_, expression) in function.expressions.iter() {
            if let Expression::Access { base, index } = expression
                && !matches!(function.expressions[*index], Expression::Literal(_))
            {
                origins.extend(origin(function, *base));
            }
        }
        self.calls(function, &function.body, &mut origins);
        let mut locals = HashSet::new();
        let mut arguments = HashSet::new();
        for found in origins {
            match found {
                Origin::Local(local) => drop(locals.insert(local)),
                Origin::Argument(index) => drop(arguments.insert(index)),
                Origin::Global(global) => drop(self.privates.insert(global)),
            }
        }
        self.locals.insert(std::ptr::from_ref(function), locals);
        arguments
    }

    fn calls(&self, function: &Function, block: &Block, origins: &mut Vec<Origin>) {
        for statement in block {
            if let Statement::Call { function: callee, arguments, .. } = statement
                && let Some(dynamic) = self.arguments.get(callee)
            {
                for (index, argument) in arguments.iter().enumerate() {
                    if dynamic.contains(&(index as u32)) {
                        origins.extend(origin(function, *argument));
                    }
                }
            }
            for_each_block(statement, &mut |inner| self.calls(function, inner, origins));
        }
    }
}

fn origin(function: &Function, mut expression: Handle<Expression>) -> Option<Origin> {
    loop {
        match function.expressions[expression] {
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => expression = base,
            Expression::LocalVariable(local) => return Some(Origin::Local(local)),
            Expression::FunctionArgument(index) => return Some(Origin::Argument(index)),
            Expression::GlobalVariable(global) => return Some(Origin::Global(global)),
            _ => return None,
        }
    }
}

/// Calls `f` with each block directly inside a statement.
pub(super) fn for_each_block<'a>(statement: &'a Statement, f: &mut dyn FnMut(&'a Block)) {
    match statement {
        Statement::Block(block) => f(block),
        Statement::If { accept, reject, .. } => {
            f(accept);
            f(reject);
        }
        Statement::Switch { cases, .. } => cases.iter().for_each(|case| f(&case.body)),
        Statement::Loop { body, continuing, .. } => {
            f(body);
            f(continuing);
        }
        _ => {}
    }
}

fn has(block: &Block, test: &dyn Fn(&Statement) -> bool, enter: &dyn Fn(&Statement) -> bool) -> bool {
    block.iter().any(|statement| {
        let mut found = test(statement);
        if enter(statement) {
            for_each_block(statement, &mut |inner| found |= has(inner, test, enter));
        }
        found
    })
}

/// Whether a function returns anywhere but at its very end.
pub(super) fn returns_early(body: &Block) -> bool {
    let is_return = |s: &Statement| matches!(s, Statement::Return { .. });
    let Some((last, rest)) = body.split_last() else { return false };
    let rest = rest.iter().any(|statement| {
        let mut found = is_return(statement);
        for_each_block(statement, &mut |inner| found |= has(inner, &is_return, &|_| true));
        found
    });
    rest || match last {
        Statement::Return { .. } => false,
        Statement::Block(block) => returns_early(block),
        other => {
            let mut found = false;
            for_each_block(other, &mut |inner| found |= has(inner, &is_return, &|_| true));
            found
        }
    }
}

/// How many statements at the beginning of a body hold no return.
pub(super) fn before_return(body: &Block) -> usize {
    let is_return = |s: &Statement| matches!(s, Statement::Return { .. });
    let returns = |statement: &Statement| {
        let mut found = is_return(statement);
        for_each_block(statement, &mut |inner| found |= has(inner, &is_return, &|_| true));
        found
    };
    body.iter().position(returns).unwrap_or(body.len())
}

/// Whether a switch case breaks anywhere but at its very end.
pub(super) fn breaks_early(body: &[Statement]) -> bool {
    let is_break = |s: &Statement| matches!(s, Statement::Break);
    let enter = |s: &Statement| !matches!(s, Statement::Loop { .. } | Statement::Switch { .. });
    body.iter().any(|statement| {
        let mut found = is_break(statement);
        if enter(statement) {
            for_each_block(statement, &mut |inner| found |= has(inner, &is_break, &enter));
        }
        found
    })
}

/// Statements up to the `if … {} else { break }` that begins each round of a loop whose rounds are otherwise straight:
/// nothing else leaves, nothing repeats and nothing is called. `None` for every other loop.
pub(super) fn straight_loop(body: &Block, continuing: &Block) -> Option<usize> {
    let header = body.iter().position(|statement| !matches!(statement, Statement::Emit(_)))?;
    let Statement::If { accept, reject, .. } = &body[header] else { return None };
    let breaks = matches!(reject[..], [Statement::Break]);
    let is_parting = |s: &Statement| {
        use Statement::{Break, Call, Continue, Kill, Loop, Return, Switch};
        matches!(s, Break | Call { .. } | Continue | Kill | Loop { .. } | Return { .. } | Switch { .. })
    };
    let rest = body[header + 1..].iter().chain(continuing.iter());
    let parts = rest.into_iter().any(|statement| {
        let mut found = is_parting(statement);
        for_each_block(statement, &mut |inner| found |= has(inner, &is_parting, &|_| true));
        found
    });
    (accept.is_empty() && breaks && !parts).then_some(header)
}
