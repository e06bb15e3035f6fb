//! Links WGSL files by `import package::…` lines into one text, with a map back to every author's line.
//!
//! The syntax is WESL's (`import package::shared::exact::umul_wide;` or `…::{umul_wide, add64};`), the semantics are
//! smaller: a file is included whole, once, before its importer, and nothing is renamed. So every byte of the linked
//! text is a byte of some file (import lines become comments of equal length), and positions map one to one.

use std::collections::HashSet;

use serde::{Deserialize, Serialize};

use crate::error::{ErrorKind, Location};
use crate::{Error, Result};

/// Where files come from: package path (`shared/exact.wgsl`) to text.
pub type Sources = dyn Fn(&str) -> Option<String>;

/// A value that replaces the initialiser of a module-scope `const`, making a variant of the program.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Define {
    /// Name of the `const`.
    pub name: String,
    /// WGSL text of its value.
    pub value: String,
}

impl Define {
    /// A definition.
    pub fn new(name: impl Into<String>, value: impl ToString) -> Self {
        Define { name: name.into(), value: value.to_string() }
    }
}

/// One linked file and the bytes of the linked text that are its own.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct File {
    /// Path as the author knows it.
    pub path: String,
    /// First byte in the linked text.
    pub start: u32,
    /// One past its last byte.
    pub end: u32,
}

/// Text ready for the front end, and where each part of it came from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Linked {
    /// The text.
    pub text: String,
    /// Its files, in order.
    pub files: Vec<File>,
}

impl Linked {
    /// Links `root` with everything it imports, then applies `defines`.
    pub fn link(root: &str, sources: &Sources, defines: &[Define]) -> Result<Self> {
        let mut linker = Linker { sources, defines, used: HashSet::new(), done: HashSet::new(), open: Vec::new() };
        let mut linked = Linked { text: String::new(), files: Vec::new() };
        linker.file(root, None, &mut linked)?;
        if let Some(define) = defines.iter().find(|d| !linker.used.contains(&d.name)) {
            let message = format!("no module-scope `const {}` to define in {root} or its imports", define.name);
            return Err(error(&message, None));
        }
        Ok(linked)
    }

    /// A single file without imports.
    pub fn single(path: &str, text: &str) -> Result<Self> {
        let (path, text) = (path.to_owned(), text.to_owned());
        Self::link(&path.clone(), &move |p| (p == path).then(|| text.clone()), &[])
    }

    /// The author's place of a byte of the linked text.
    pub fn locate(&self, byte: usize) -> Option<Location> {
        let file = self.files.iter().find(|f| (f.start as usize..=f.end as usize).contains(&byte))?;
        let before = self.text.get(file.start as usize..byte)?;
        let line = before.bytes().filter(|&b| b == b'\n').count() as u32 + 1;
        let column = (before.len() - before.rfind('\n').map_or(0, |i| i + 1)) as u32 + 1;
        Some(Location { file: file.path.clone(), line, column })
    }
}

struct Linker<'a> {
    sources: &'a Sources,
    defines: &'a [Define],
    used: HashSet<String>,
    done: HashSet<String>,
    open: Vec<String>,
}

impl Linker<'_> {
    fn file(&mut self, path: &str, from: Option<Location>, out: &mut Linked) -> Result<()> {
        if self.done.contains(path) {
            return Ok(());
        }
        if self.open.iter().any(|p| p == path) {
            return Err(error(&format!("import cycle: {} -> {path}", self.open.join(" -> ")), from));
        }
        let text = (self.sources)(path).ok_or_else(|| error(&format!("no file `{path}` in this package"), from))?;
        self.open.push(path.to_owned());
        let mut body = String::with_capacity(text.len());
        for (index, line) in text.split_inclusive('\n').enumerate() {
            if line.trim_start().starts_with("import ") {
                let at = Location { file: path.into(), line: index as u32 + 1, column: 1 };
                self.import(line, at, out)?;
                body.push_str("//");
                body.push_str(line.trim_start_matches(' ').get(2..).unwrap_or("\n"));
            } else {
                self.line(line, &mut body);
            }
        }
        if !body.ends_with('\n') {
            body.push('\n');
        }
        let start = out.text.len() as u32;
        out.text.push_str(&body);
        out.files.push(File { path: path.to_owned(), start, end: out.text.len() as u32 });
        self.open.pop();
        self.done.insert(path.to_owned());
        Ok(())
    }

    fn import(&mut self, line: &str, at: Location, out: &mut Linked) -> Result<()> {
        let malformed =
            || error("an import reads `import package::folder::file::item;` or `…::{a, b};`", Some(at.clone()));
        let body =
            line.trim().strip_prefix("import package::").and_then(|l| l.strip_suffix(';')).ok_or_else(malformed)?;
        let (module, items) = body.rsplit_once("::").ok_or_else(malformed)?;
        let path = format!("{}.wgsl", module.replace("::", "/"));
        let text = (self.sources)(&path)
            .ok_or_else(|| error(&format!("no file `{path}` in this package"), Some(at.clone())))?;
        for item in items.trim_start_matches('{').trim_end_matches('}').split(',').map(str::trim) {
            if !declares(&text, item) {
                return Err(error(&format!("`{path}` declares no `{item}`"), Some(at)));
            }
        }
        self.file(&path, Some(at), out)
    }

    /// Copies a line, with the value of a defined `const` replaced.
    fn line(&mut self, line: &str, body: &mut String) {
        let name = line.strip_prefix("const ").map(|l| l.split([':', '=', ' ']).next().unwrap_or(""));
        let define = name.and_then(|n| self.defines.iter().find(|d| d.name == n));
        match (define, line.split_once('='), line.find(';')) {
            (Some(define), Some((head, _)), Some(end)) => {
                self.used.insert(define.name.clone());
                body.push_str(head);
                body.push_str("= ");
                body.push_str(&define.value);
                body.push_str(&line[end..]);
            }
            _ => body.push_str(line),
        }
    }
}

fn declares(text: &str, item: &str) -> bool {
    let word =
        |rest: &str| rest.strip_prefix(item).is_some_and(|r| !r.starts_with(|c: char| c.is_alphanumeric() || c == '_'));
    text.lines().any(|line| {
        ["fn ", "const ", "struct ", "alias ", "override "].iter().any(|k| line.strip_prefix(k).is_some_and(word))
    })
}

fn error(message: &str, location: Option<Location>) -> Error {
    let rendered = match &location {
        Some(at) => format!("error: {message}\n  --> {at}\n"),
        None => format!("error: {message}\n"),
    };
    ErrorKind::Wgsl { stage: "link", location, rendered }.into()
}
