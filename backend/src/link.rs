//! Links WGSL files into one text, with a map back to every author's line.
//!
//! Three lines that are not WGSL's stand before all other items of a file:
//!
//! * `import package::shared::exact::umul_wide;` or `import package::shared::exact::{umul_wide, add64};` includes
//!   `shared/exact.wgsl`. The syntax is WESL's, the semantics are smaller: a file is included whole, once, before its
//!   importer, and nothing is renamed, so there is no `as`. Named items must exist.
//! * `require table: array<u32>;` in a shared file says that it uses a module-scope `var`, `const` or `override` of
//!   that name, which some file of the program must declare. The type is for the reader; the front end checks uses.
//!
//! A [`Define`] replaces the initialiser of a module-scope `const` by a literal, which makes a variant of the program.
//!
//! Invariant: imports and requirements become blanks of equal length, so each byte of the linked text is a byte of
//! some file at the same line; columns may move only behind a defined value.

use std::collections::HashSet;
use std::ops::Range;

use naga::Span;
use serde::{Deserialize, Serialize};

use crate::error::{ErrorKind, Location};
use crate::program::diagnose;
use crate::text::{self, Item, Kind};
use crate::{Error, Result};

/// Where files come from: package path (`shared/exact.wgsl`) to text.
pub type Sources = dyn Fn(&str) -> Option<String>;

/// A value that replaces the initialiser of a module-scope `const`, making a variant of the program.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Define {
    /// Name of the `const`.
    pub name: String,
    /// Its value: one WGSL literal.
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
        for (index, define) in defines.iter().enumerate() {
            check_define(define, &defines[..index])?;
        }
        let linked = Linked { text: String::new(), files: Vec::new() };
        let (used, done) = (HashSet::new(), HashSet::new());
        let mut linker = Linker { sources, defines, linked, used, done, open: Vec::new(), required: Vec::new() };
        linker.file(root, None)?;
        linker.requirements(root)?;
        if let Some(define) = defines.iter().find(|d| !linker.used.contains(&d.name)) {
            let message = format!("no module-scope `const {}` to define in {root} or its imports", define.name);
            return Err(error(&message));
        }
        Ok(linker.linked)
    }

    /// A single file without imports.
    pub fn single(path: &str, text: &str) -> Result<Self> {
        let (path, text) = (path.to_owned(), text.to_owned());
        Self::link(&path.clone(), &move |p| (p == path).then(|| text.clone()), &[])
    }

    /// The author's place of a byte of the linked text.
    pub fn locate(&self, byte: usize) -> Option<Location> {
        let file = &self.files[self.file_at(byte)?];
        let before = self.text.get(file.start as usize..byte)?;
        let line = before.bytes().filter(|&b| b == b'\n').count() as u32 + 1;
        let column = (before.len() - before.rfind('\n').map_or(0, |i| i + 1)) as u32 + 1;
        Some(Location { file: file.path.clone(), line, column })
    }

    /// Index of the file that a byte of the linked text belongs to; the end of the text belongs to the last.
    pub(crate) fn file_at(&self, byte: usize) -> Option<usize> {
        let found = self.files.iter().position(|f| (f.start as usize..f.end as usize).contains(&byte));
        found.or_else(|| self.files.len().checked_sub(1).filter(|_| byte == self.text.len()))
    }

    /// Whether the files divide the text, which holds after linking but not of any bytes that claim to be a `Linked`.
    pub(crate) fn is_consistent(&self) -> bool {
        let mut at = 0;
        let divide = self.files.iter().all(|file| {
            let follows = file.start == at && file.end >= file.start;
            at = file.end;
            follows && self.text.is_char_boundary(at as usize)
        });
        divide && at as usize == self.text.len()
    }
}

struct Linker<'a> {
    sources: &'a Sources,
    defines: &'a [Define],
    linked: Linked,
    used: HashSet<String>,
    done: HashSet<String>,
    open: Vec<String>,
    required: Vec<(String, Location)>,
}

impl Linker<'_> {
    fn file(&mut self, path: &str, from: Option<&Location>) -> Result<()> {
        if self.done.contains(path) {
            return Ok(());
        }
        if let Some(first) = self.open.iter().position(|p| p == path) {
            let cycle = self.open[first..].join(" -> ");
            return Err(self.error(&format!("import cycle: {cycle} -> {path}"), from));
        }
        if self.open.len() >= MAX_NESTED_IMPORTS {
            return Err(self.error(&format!("imports nest deeper than {MAX_NESTED_IMPORTS} files"), from));
        }
        let source = self.source(path, from)?;
        let items = text::items(&source);
        self.open.push(path.to_owned());
        let mut body = source.clone();
        let mut edits = Vec::new();
        let mut header = true;
        for item in &items {
            let at = || place(path, &source, item.range.start);
            let keyword = &source[item.keyword.clone()];
            let ours = matches!(keyword, "import" | "require");
            if ours && !header {
                let message = format!("`{keyword}` stands after another item; move it to the top");
                return Err(self.error(&message, Some(&at())));
            }
            match keyword {
                "import" => self.import(&source[item.range.clone()], &at())?,
                "require" => self.require(&source, item, &at())?,
                "const" => edits.extend(self.define(&source, item)?),
                _ => {}
            }
            header = ours;
            if ours {
                let blank = |c: char| if c == '\n' || c == '\r' { c.to_string() } else { " ".repeat(c.len_utf8()) };
                edits.push((item.range.clone(), source[item.range.clone()].chars().map(blank).collect()));
            }
        }
        for (range, text) in edits.into_iter().rev() {
            body.replace_range(range, &text);
        }
        self.append(path, &body, from)?;
        self.open.pop();
        self.done.insert(path.to_owned());
        Ok(())
    }

    fn append(&mut self, path: &str, body: &str, from: Option<&Location>) -> Result<()> {
        // Files stand on lines of their own; the last one ends where its author ended it.
        if let Some(before) = self.linked.files.last_mut().filter(|_| !self.linked.text.ends_with('\n')) {
            self.linked.text.push('\n');
            before.end += 1;
        }
        let start = self.linked.text.len();
        self.linked.text.push_str(body);
        let bounds = u32::try_from(start).ok().zip(u32::try_from(self.linked.text.len()).ok());
        let (start, end) = bounds.ok_or_else(|| self.error("the linked text is longer than 4 GiB", from))?;
        self.linked.files.push(File { path: path.to_owned(), start, end });
        Ok(())
    }

    fn source(&self, path: &str, from: Option<&Location>) -> Result<String> {
        (self.sources)(path).ok_or_else(|| self.error(&format!("no file `{path}` in this package"), from))
    }

    /// A message about the line of a file, with that line shown.
    fn error(&self, message: &str, location: Option<&Location>) -> Error {
        let Some(at) = location else { return error(message) };
        let text = (self.sources)(&at.file).unwrap_or_default();
        let line: usize = text.split_inclusive('\n').take(at.line as usize - 1).map(str::len).sum();
        let start = line + at.column as usize - 1;
        let length = text.get(start..).and_then(|rest| rest.lines().next()).map_or(0, str::len);
        let span = Span::new(start as u32, (start + length) as u32);
        let file = File { path: at.file.clone(), start: 0, end: text.len() as u32 };
        let shown = Linked { text, files: vec![file] };
        diagnose(&shown, "link", message, &[(span, String::new())], Vec::new()).into()
    }

    fn import(&mut self, line: &str, at: &Location) -> Result<()> {
        let words: Vec<&str> = text::tokens(line).map(|t| &line[t.range]).collect();
        if words.contains(&"as") {
            return Err(self.error("an import cannot rename: `as` is not supported, use the item's own name", Some(at)));
        }
        let (folders, names) = parse_import(&words).ok_or_else(|| {
            self.error("an import reads `import package::folder::file::item;` or `…::{a, b};`", Some(at))
        })?;
        let path = format!("{}.wgsl", folders.join("/"));
        let source = self.source(&path, Some(at))?;
        let declared = text::items(&source);
        for name in names {
            if !declared.iter().any(|i| &source[i.name.clone()] == name && !is_linkers(&source, i)) {
                return Err(self.error(&format!("`{path}` declares no `{name}`"), Some(at)));
            }
        }
        self.file(&path, Some(at))
    }

    fn require(&mut self, source: &str, item: &Item, at: &Location) -> Result<()> {
        let typed = source[item.name.end..item.range.end].trim_start().starts_with(':');
        if item.name.is_empty() || !typed {
            return Err(self.error("a requirement reads `require name: type;`", Some(at)));
        }
        self.required.push((source[item.name.clone()].to_owned(), at.clone()));
        Ok(())
    }

    fn requirements(&self, root: &str) -> Result<()> {
        let text = &self.linked.text;
        let items = text::items(text);
        let global = |i: &Item| matches!(&text[i.keyword.clone()], "var" | "const" | "override");
        for (name, at) in &self.required {
            if !items.iter().any(|i| global(i) && &text[i.name.clone()] == name) {
                let (file, line) = (&at.file, at.line);
                let message =
                    format!("`{root}` must declare a module-scope `{name}`: {file} requires it (line {line})");
                return Err(self.error(&message, Some(at)));
            }
        }
        Ok(())
    }

    /// The edit that gives a `const` its defined value.
    fn define(&mut self, source: &str, item: &Item) -> Result<Option<(Range<usize>, String)>> {
        let Some(define) = self.defines.iter().find(|d| d.name == source[item.name.clone()]) else { return Ok(None) };
        let declared = &source[item.name.end..item.range.end];
        let equals = text::tokens(declared).find(|t| t.kind == Kind::Punct('=')).map(|t| item.name.end + t.range.end);
        let Some(range) = equals.map(|start| start..item.range.end - 1) else { return Ok(None) };
        if source[range.clone()].contains(['\n', '\r']) {
            let message = format!("the initialiser of `const {}` spans lines; a defined const needs one", define.name);
            let path = self.open.last().map(String::as_str).unwrap_or_default();
            return Err(self.error(&message, Some(&place(path, source, item.range.start))));
        }
        self.used.insert(define.name.clone());
        Ok(Some((range, format!(" {}", define.value))))
    }
}

const MAX_NESTED_IMPORTS: usize = 64;

/// `import package :: a :: b :: item ;` or `… :: { a , b } ;` as folders and items.
fn parse_import<'a>(words: &[&'a str]) -> Option<(Vec<&'a str>, Vec<&'a str>)> {
    let ["import", "package", ":", ":", path @ .., ";"] = words else { return None };
    let is_name = |w: &&str| w.starts_with(|c: char| c == '_' || c.is_alphabetic());
    let (modules, items) = match path.iter().position(|&w| w == "{") {
        Some(brace) => {
            let list = path.last().filter(|&&w| w == "}").map(|_| &path[brace + 1..path.len() - 1])?;
            let list = list.strip_suffix(&[","]).unwrap_or(list);
            let names: Vec<&str> = list.iter().step_by(2).copied().collect();
            let commas = list.iter().skip(1).step_by(2).all(|&w| w == ",");
            if !commas || list.len() % 2 == 0 {
                return None;
            }
            (&path[..brace], names)
        }
        None => (&path[..path.len().checked_sub(1)?], vec![*path.last()?]),
    };
    let folders: Vec<&str> = modules.chunks(3).map(|c| c[0]).collect();
    let separated = modules.chunks(3).all(|c| matches!(c, [_, ":", ":"]));
    let named = folders.iter().chain(&items).all(is_name);
    (separated && named && !folders.is_empty()).then_some((folders, items))
}

fn is_linkers(source: &str, item: &Item) -> bool {
    matches!(&source[item.keyword.clone()], "import" | "require")
}

/// A definition's value is one literal, and no name is defined twice.
fn check_define(define: &Define, before: &[Define]) -> Result<()> {
    let value = define.value.trim();
    let digits = value.strip_prefix('-').unwrap_or(value);
    let mut tokens = text::tokens(digits);
    let number = matches!((tokens.next(), tokens.next()), (Some(t), None) if t.kind == Kind::Number && t.range.len() == digits.len());
    if !number && !matches!(value, "true" | "false") {
        let message = format!("`{}` defines `const {}`; the value must be one literal", define.value, define.name);
        return Err(error(&message));
    }
    if before.iter().any(|d| d.name == define.name) {
        return Err(error(&format!("`const {}` is defined twice", define.name)));
    }
    Ok(())
}

fn place(path: &str, source: &str, byte: usize) -> Location {
    let before = &source[..byte];
    let line = before.bytes().filter(|&b| b == b'\n').count() as u32 + 1;
    let column = (before.len() - before.rfind('\n').map_or(0, |i| i + 1)) as u32 + 1;
    Location { file: path.to_owned(), line, column }
}

fn error(message: &str) -> Error {
    ErrorKind::Wgsl { stage: "link", location: None, rendered: format!("error: {message}\n") }.into()
}
