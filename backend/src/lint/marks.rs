//! Marks and allowances: the doc-comment lines that say why an item may do what a lint forbids.

use std::ops::Range;

use super::{Violation, lint};
use crate::text::Item;

/// The marks above one item, and which of them have had an effect.
#[derive(Debug, Default)]
pub(super) struct Marks {
    float: Option<Range<usize>>,
    uses_float: bool,
    allowances: Vec<Allowance>,
    malformed: Vec<Violation>,
}

#[derive(Debug)]
struct Allowance {
    lint: &'static str,
    range: Range<usize>,
    used: bool,
}

/// Lints that speak of marks themselves.
const UNALLOWABLE: [&str; 2] = ["malformed-mark", "stale-mark"];

impl Marks {
    /// Reads the doc lines of an item.
    pub(super) fn read(text: &str, item: &Item) -> Self {
        let mut marks = Marks::default();
        let is_function = &text[item.keyword.clone()] == "fn";
        for line in &item.docs {
            let words = text[line.clone()].trim_start();
            let start = line.end - words.len();
            let range = start..start + words.trim_end().len();
            let result = if let Some(kind) = words.strip_prefix("float:") {
                marks.float(kind.trim(), is_function, &range)
            } else if let Some(rest) = words.strip_prefix("allow(") {
                marks.allow(rest.trim_end(), &range)
            } else {
                Ok(())
            };
            if let Err(label) = result {
                marks.malformed.push(Violation { lint: "malformed-mark", range, label });
            }
        }
        marks
    }

    fn float(&mut self, kind: &str, is_function: bool, range: &Range<usize>) -> Result<(), String> {
        let kind = kind.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        if !matches!(kind, "guess" | "filter") {
            return Err(format!("`{kind}` is no kind of float function"));
        }
        if !is_function {
            return Err("only a function is marked".into());
        }
        if self.float.replace(range.clone()).is_some() {
            return Err("marked twice".into());
        }
        Ok(())
    }

    fn allow(&mut self, rest: &str, range: &Range<usize>) -> Result<(), String> {
        let (name, reason) = rest.split_once(')').ok_or("no `)`")?;
        if reason.strip_prefix(':').is_none_or(|r| r.trim().is_empty()) {
            return Err("an allowance needs `: reason`".into());
        }
        let lint = lint(name.trim()).ok_or_else(|| format!("there is no lint `{}`", name.trim()))?.name;
        if UNALLOWABLE.contains(&lint) {
            return Err(format!("`{lint}` cannot be allowed"));
        }
        self.allowances.push(Allowance { lint, range: range.clone(), used: false });
        Ok(())
    }

    /// Notes that the item computes with f32, and says whether a mark permits that.
    pub(super) fn float_is_marked(&mut self) -> bool {
        self.uses_float = true;
        self.float.is_some()
    }

    /// Whether an allowance covers a violation of `lint`; it counts as used.
    pub(super) fn allows(&mut self, lint: &str) -> bool {
        let allowance = self.allowances.iter_mut().find(|a| a.lint == lint);
        allowance.map(|a| a.used = true).is_some()
    }

    /// What is wrong with the marks themselves.
    pub(super) fn finish(self, found: &mut Vec<Violation>) {
        found.extend(self.malformed);
        let unused = self.allowances.into_iter().filter(|a| !a.used);
        let stale = |range, label: String| Violation { lint: "stale-mark", range, label };
        found.extend(unused.map(|a| stale(a.range, format!("nothing here is a case of `{}`", a.lint))));
        let float = self.float.filter(|_| !self.uses_float);
        found.extend(float.map(|range| stale(range, "no f32 arithmetic here".into())));
    }
}
