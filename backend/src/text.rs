//! A small scanner of WGSL text: tokens and module-scope items, enough for linking, bounding and linting.
//!
//! It knows comments (nested block comments too), words, numbers and punctuation, and nothing of the grammar. What it
//! says about valid WGSL is exact; invalid WGSL it merely cuts into pieces, and the front end says what is wrong.

use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A comment that begins with `///`.
    Doc,
    /// An identifier or keyword.
    Word,
    /// A numeric literal with its suffix.
    Number,
    /// One character of anything else.
    Punct(char),
}

/// A token and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Token {
    pub(crate) kind: Kind,
    pub(crate) range: Range<usize>,
}

/// The tokens of a text; comments other than `///` are left out.
pub(crate) fn tokens(text: &str) -> impl Iterator<Item = Token> {
    let mut at = 0;
    std::iter::from_fn(move || {
        while at < text.len() {
            let start = at;
            let rest = &text[at..];
            let first = rest.chars().next()?;
            let kind = if rest.starts_with("//") {
                at += rest.find(is_line_end).unwrap_or(rest.len());
                if !rest.starts_with("///") {
                    continue;
                }
                Kind::Doc
            } else if rest.starts_with("/*") {
                at += block_comment(rest);
                continue;
            } else if is_word_start(first) {
                at += rest.find(|c| !is_word_part(c)).unwrap_or(rest.len());
                Kind::Word
            } else if first.is_ascii_digit() || (first == '.' && rest[1..].starts_with(|c: char| c.is_ascii_digit())) {
                at += number(rest);
                Kind::Number
            } else {
                at += first.len_utf8();
                if first.is_whitespace() {
                    continue;
                }
                Kind::Punct(first)
            };
            return Some(Token { kind, range: start..at });
        }
        None
    })
}

fn is_word_start(c: char) -> bool {
    c == '_' || c.is_alphabetic()
}

fn is_word_part(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

fn is_line_end(c: char) -> bool {
    matches!(c, '\n' | '\u{b}' | '\u{c}' | '\r' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// Length of a block comment with those nested in it.
fn block_comment(text: &str) -> usize {
    let bytes = text.as_bytes();
    let (mut depth, mut at) = (0_usize, 0);
    while at < bytes.len() {
        match bytes.get(at..at + 2) {
            Some(b"/*") => (depth, at) = (depth + 1, at + 2),
            Some(b"*/") => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
        if depth == 0 {
            break;
        }
    }
    at
}

fn number(text: &str) -> usize {
    let hex = text.starts_with("0x") || text.starts_with("0X");
    let exponent = |c: char| if hex { matches!(c, 'p' | 'P') } else { matches!(c, 'e' | 'E') };
    let mut previous = ' ';
    for (at, c) in text.char_indices() {
        let sign = matches!(c, '+' | '-') && exponent(previous);
        if !(sign || c == '.' || c.is_ascii_alphanumeric()) {
            return at;
        }
        previous = c;
    }
    text.len()
}

/// A declaration at module scope.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Item {
    /// `fn`, `const`, `var`, `struct`, `alias`, `override`, or the linker's own `import` and `require`.
    pub(crate) keyword: Range<usize>,
    /// Its name; empty where there is none.
    pub(crate) name: Range<usize>,
    /// The `///` lines above it, without the slashes.
    pub(crate) docs: Vec<Range<usize>>,
    /// From its first attribute to its closing `}` or `;`.
    pub(crate) range: Range<usize>,
}

const KEYWORDS: [&str; 8] = ["fn", "const", "var", "struct", "alias", "override", "import", "require"];

/// All items of a text, in order.
pub(crate) fn items(text: &str) -> Vec<Item> {
    let mut items = Vec::new();
    let mut open = Open::default();
    let mut depth = 0_u32;
    for token in tokens(text) {
        let word = &text[token.range.clone()];
        match token.kind {
            Kind::Doc => {
                if depth == 0 && open.keyword.is_none() {
                    open.docs.push(token.range.start + 3..token.range.end);
                }
                continue;
            }
            Kind::Punct('(' | '[' | '{') => depth += 1,
            Kind::Punct(')' | ']' | '}') => depth = depth.saturating_sub(1),
            Kind::Word if depth == 0 => open.word(word, &token.range),
            Kind::Punct('<') if depth == 0 => open.angles += 1,
            Kind::Punct('>') if depth == 0 => open.angles = open.angles.saturating_sub(1),
            _ => {}
        }
        open.start.get_or_insert(token.range.start);
        let list = open.keyword.as_ref().is_some_and(|k| &text[k.clone()] == "import");
        let ends = matches!(token.kind, Kind::Punct(';')) || (matches!(token.kind, Kind::Punct('}')) && !list);
        if depth == 0 && ends {
            items.extend(open.close(token.range.end));
            open = Open::default();
        }
    }
    items
}

/// The item being read.
#[derive(Default)]
struct Open {
    docs: Vec<Range<usize>>,
    start: Option<usize>,
    keyword: Option<Range<usize>>,
    name: Option<Range<usize>>,
    angles: u32,
}

impl Open {
    fn word(&mut self, word: &str, range: &Range<usize>) {
        if self.keyword.is_none() {
            self.keyword = KEYWORDS.contains(&word).then(|| range.clone());
            self.angles = 0;
        } else if self.name.is_none() && self.angles == 0 {
            self.name = Some(range.clone());
        }
    }

    fn close(self, end: usize) -> Option<Item> {
        let keyword = self.keyword?;
        let name = self.name.unwrap_or(keyword.end..keyword.end);
        Some(Item { range: self.start.unwrap_or(keyword.start)..end, keyword, name, docs: self.docs })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<&str> {
        tokens(text).map(|t| &text[t.range]).collect()
    }

    #[test]
    fn comments_are_skipped_and_numbers_are_whole() {
        let text = "a /* b /* c */ d */ 1.5e-3f // e\r\n0x1p+4 .5 x.y /// doc\n-2i /*/ open";
        assert_eq!(words(text), ["a", "1.5e-3f", "0x1p+4", ".5", "x", ".", "y", "/// doc", "-", "2i"]);
    }

    #[test]
    fn items_have_names_docs_and_extents() {
        let text = "//! head\n/// one\n/// two\n@group(0) @binding(1) var<storage, read> input: array<u32>;\nconst_assert \
            1 < 2;\nimport package::a::{b, c};\n/// f\n@compute fn main() { const inner = 1; { } }\nstruct S { a: u32 }";
        let items = items(text);
        let names: Vec<_> = items.iter().map(|i| (&text[i.keyword.clone()], &text[i.name.clone()])).collect();
        assert_eq!(names, [("var", "input"), ("import", "package"), ("fn", "main"), ("struct", "S")]);
        let docs: Vec<_> = items[0].docs.iter().map(|d| &text[d.clone()]).collect();
        assert_eq!(docs, [" one", " two"]);
        assert!(text[items[0].range.clone()].starts_with("@group(0)"));
        assert_eq!(&text[items[1].range.clone()], "import package::a::{b, c};");
        assert_eq!(&text[items[2].range.clone()], "@compute fn main() { const inner = 1; { } }");
    }

    #[test]
    fn any_text_is_cut_without_a_panic() {
        for text in ["/*", "é(", "}}}", "fn", "var<", "1.", "\u{2028}//", "import", ";;", "0x", "@"] {
            let _ = (items(text).len(), tokens(text).count());
        }
        assert_eq!(tokens("}é").count(), 2);
    }
}
