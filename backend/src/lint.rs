//! Portability lints: what may change an output bit from one device to the next, found before anything runs.
//!
//! WGSL fixes integer arithmetic and leaves f32 free (rounding, fusion, reassociation, flushed subnormals), so kernels
//! decide in integers. f32 may stand in a function whose doc comment says how its error is kept from the output:
//!
//! ```wgsl
//! /// float: guess - the residual below corrects it
//! fn quotient(n: u32, d: u32) -> u32 { … }
//! ```
//!
//! `guess` means that an exact integer residual corrects the value, `filter` that an exact integer predicate decides
//! the doubtful cases. Anything else is allowed by name and with a reason, for one item at a time:
//!
//! ```wgsl
//! /// allow(atomic-result): the claimed slots are sorted before they are read
//! ```
//!
//! Invariant: a mark or allowance without effect is an error, so those that stand are needed. All violations of a
//! program are reported at once.

mod functions;
mod literals;
mod marks;
mod memory;

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

use naga::valid::ModuleInfo;

use crate::error::ErrorKind;
use crate::program::Renderer;
use crate::text::{self, Item};
use crate::{Linked, Result};
use marks::Marks;

/// One portability lint.
#[derive(Debug, PartialEq, Eq)]
pub struct Lint {
    /// Its name, as in `/// allow(name): reason`.
    pub name: &'static str,
    /// What it finds, in one line.
    pub summary: &'static str,
    /// Why that may change an output bit.
    pub why: &'static str,
    /// What to write instead.
    pub remedy: &'static str,
}

/// Every lint, in the order of the documentation.
pub const LINTS: [Lint; 11] = [
    Lint {
        name: "float-arithmetic",
        summary: "f32 arithmetic outside a marked function",
        why: "f32 operations may round either way, fuse, reassociate and flush subnormals",
        remedy: "decide in integers, or mark the function `/// float: guess` or `/// float: filter`",
    },
    Lint {
        name: "inexact-builtin",
        summary: "an f32 operation whose error WGSL bounds loosely or not at all",
        why: "its accuracy is inherited or in ULPs, and devices differ in it",
        remedy: "use an exact integer function, or a table that the host computes",
    },
    Lint {
        name: "float-memory",
        summary: "f32 in storage, uniform or workgroup memory",
        why: "an f32 that crosses memory as f32 may lose its subnormals and the payload of a NaN",
        remedy: "declare u32, and use `bitcast<f32>` where the value is used",
    },
    Lint {
        name: "inexact-literal",
        summary: "a float literal that f32 does not hold exactly",
        why: "either neighbour may be taken, and different uses may differ",
        remedy: "write a dyadic value that f32 holds, such as 0.125 or 4294967040.0",
    },
    Lint {
        name: "folded-float",
        summary: "a float expression that is evaluated at compile time",
        why: "const-expressions are evaluated in another precision than at run time, and each compiler has its own",
        remedy: "write the result as one exact literal",
    },
    Lint {
        name: "signed-division",
        summary: "`/` or `%` on i32",
        why: "drivers have divided negative operands wrongly, and SPIR-V leaves their remainder open",
        remedy: "divide magnitudes as u32 and restore the sign, or shift",
    },
    Lint {
        name: "int-min-literal",
        summary: "the i32 constant -2147483648",
        why: "shading languages have no such literal, and compilers have misread its usual spelling",
        remedy: "use u32, or `bitcast<i32>` of a run-time value",
    },
    Lint {
        name: "atomic-result",
        summary: "a value returned by an atomic operation is used",
        why: "it depends on the order in which invocations run",
        remedy: "make the order by a prefix sum; use only the final value",
    },
    Lint {
        name: "subgroup",
        summary: "a subgroup operation or builtin",
        why: "the size of a subgroup, and who is in it, differ between devices",
        remedy: "use workgroup memory and barriers",
    },
    Lint {
        name: "malformed-mark",
        summary: "a mark or allowance that cannot be read",
        why: "what it is meant to say is not checked",
        remedy: "write `/// float: guess`, `/// float: filter` or `/// allow(lint): reason` above one item",
    },
    Lint {
        name: "stale-mark",
        summary: "a mark or allowance that has no effect",
        why: "allowances are to stay few, and each must be needed",
        remedy: "remove it",
    },
];

/// A lint by its name.
pub fn lint(name: &str) -> Option<&'static Lint> {
    LINTS.iter().find(|l| l.name == name)
}

/// Something that a lint found.
#[derive(Debug)]
struct Violation {
    lint: &'static str,
    range: Range<usize>,
    label: String,
}

/// Checks every item of a program against every lint.
pub fn check(module: &naga::Module, info: &ModuleInfo, linked: &Linked) -> Result<()> {
    let source = Source::new(&linked.text);
    let mut marks: Vec<Marks> = source.items.iter().map(|item| Marks::read(source.text, item)).collect();
    let mut found = Vec::new();
    functions::check(module, info, &source, &mut marks, &mut found);
    memory::check(module, &mut found);
    literals::check(module, &source, &mut found);
    found.retain(|violation| {
        let item = source.item_at(violation.range.start);
        !item.is_some_and(|index| marks[index].allows(violation.lint))
    });
    for marks in marks {
        marks.finish(&mut found);
    }
    if found.is_empty() { Ok(()) } else { Err(report(linked, &source, found).into()) }
}

/// The linked text and its items.
struct Source<'a> {
    text: &'a str,
    items: Vec<Item>,
    names: HashMap<&'a str, usize>,
}

impl<'a> Source<'a> {
    fn new(text: &'a str) -> Self {
        let items = text::items(text);
        let names = items.iter().enumerate().map(|(index, item)| (&text[item.name.clone()], index)).collect();
        Source { text, items, names }
    }

    /// Index of the item that a byte belongs to.
    fn item_at(&self, byte: usize) -> Option<usize> {
        let index = self.items.partition_point(|i| i.range.end <= byte);
        self.items.get(index).filter(|i| i.range.contains(&byte)).map(|_| index)
    }

    /// Index of the item of that keyword and name.
    fn named(&self, keyword: &str, name: &str) -> Option<usize> {
        self.names.get(name).copied().filter(|&index| &self.text[self.items[index].keyword.clone()] == keyword)
    }
}

/// Labels of one diagnostic that are shown; the rest are counted.
const MAX_LABELS: usize = 8;

/// One diagnostic for each lint and item, in the order of the text.
fn report(linked: &Linked, source: &Source<'_>, mut found: Vec<Violation>) -> ErrorKind {
    found.sort_by_key(|v| (v.range.start, v.range.end, v.lint));
    found.dedup_by(|a, b| a.lint == b.lint && a.range == b.range);
    let location = found.first().and_then(|v| linked.locate(v.range.start));
    let mut groups: BTreeMap<(usize, &str), Vec<Violation>> = BTreeMap::new();
    for violation in found {
        let item = source.item_at(violation.range.start).unwrap_or(source.items.len());
        groups.entry((item, violation.lint)).or_default().push(violation);
    }
    let renderer = Renderer::new(linked);
    let mut rendered = String::new();
    for ((_, name), violations) in groups {
        let Some(lint) = lint(name) else { continue };
        let label = |v: &Violation| (naga::Span::new(v.range.start as u32, v.range.end as u32), v.label.clone());
        let labels: Vec<_> = violations.iter().take(MAX_LABELS).map(label).collect();
        let mut notes = vec![format!("why: {}", lint.why), format!("remedy: {}", lint.remedy)];
        if violations.len() > MAX_LABELS {
            notes.push(format!("and {} more in the same item", violations.len() - MAX_LABELS));
        }
        rendered.push_str(&renderer.render(&format!("{name}: {}", lint.summary), &labels, notes));
        rendered.push('\n');
    }
    ErrorKind::Wgsl { stage: "lint", location, rendered }
}
