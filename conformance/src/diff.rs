//! Differences between words, as a small table: where, what was expected, what came.
//!
//! Bytes are compared first; words are only looked at where bytes differ. The table shows the first rows of each
//! comparison and counts the rest.

use serde::{Deserialize, Serialize};
use sightlines_backend::{Expected, Read};

/// Rows that a table shows.
pub const SHOWN: usize = 10;

/// One word that differs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Row {
    /// Name of the output.
    pub buffer: String,
    /// Index of the word, or what stands in place of one.
    pub index: String,
    /// The expected word.
    pub expected: String,
    /// The word that came.
    pub got: String,
    /// Both as f32, where both look like numbers that a person would write.
    pub floats: Option<String>,
}

/// The first rows and the number of all.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Table {
    /// First rows.
    pub rows: Vec<Row>,
    /// Number of all differences.
    pub total: u64,
}

impl Row {
    /// A row about one word.
    pub fn word(buffer: &str, index: u64, expected: u32, got: u32) -> Self {
        let (e, g) = (f32::from_bits(expected), f32::from_bits(got));
        let natural = |v: f32| v == 0.0 || (1e-6..1e9).contains(&v.abs());
        let floats = (natural(e) && natural(g) && (e != 0.0 || g != 0.0)).then(|| format!("{e} | {g}"));
        let hex = |w: u32| format!("{w:#010x}");
        Row { buffer: buffer.into(), index: index.to_string(), expected: hex(expected), got: hex(got), floats }
    }

    /// A row about something that is not a word.
    pub fn text(buffer: &str, index: &str, expected: impl Into<String>, got: impl Into<String>) -> Self {
        Row { buffer: buffer.into(), index: index.into(), expected: expected.into(), got: got.into(), floats: None }
    }
}

impl Table {
    /// A table of one row.
    pub fn one(row: Row) -> Self {
        Table { rows: vec![row], total: 1 }
    }

    /// Adds a row; only the first ones are kept.
    pub fn push(&mut self, row: impl FnOnce() -> Row) {
        self.total += 1;
        if self.rows.len() < SHOWN {
            self.rows.push(row());
        }
    }

    /// The table, if it has rows.
    pub fn some(self) -> Option<Self> {
        (self.total > 0).then_some(self)
    }

    /// Lines of the table under the names of the case and of the machine.
    pub fn render(&self, kernel: &str, case: &str, machine: &str) -> String {
        let head = ["kernel", "case", "backend", "buffer", "index", "expected", "got", "as f32"].map(str::to_owned);
        let mut lines = vec![head];
        for row in &self.rows {
            let floats = row.floats.clone().unwrap_or_default();
            let named = [kernel, case, machine, &row.buffer, &row.index, &row.expected, &row.got, &floats];
            lines.push(named.map(str::to_owned));
        }
        let columns = if self.rows.iter().any(|r| r.floats.is_some()) { 8 } else { 7 };
        let mut text = String::new();
        for line in &lines {
            let cells = (0..columns).map(|c| {
                let width = lines.iter().map(|l| l[c].chars().count()).max().unwrap_or(0);
                format!("{:width$}", line[c])
            });
            text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
            text.push('\n');
        }
        if self.total > self.rows.len() as u64 {
            text.push_str(&format!("… {} more\n", self.total - self.rows.len() as u64));
        }
        text
    }
}

/// Words of an output; a tail that is not a whole word is a word with zeros above.
pub fn words(bytes: &[u8]) -> impl ExactSizeIterator<Item = u32> + '_ {
    bytes.chunks(4).map(|chunk| {
        let mut word = [0; 4];
        word[..chunk.len()].copy_from_slice(chunk);
        u32::from_le_bytes(word)
    })
}

/// The word at an index.
pub fn word_at(bytes: &[u8], index: u64) -> Option<u32> {
    let start = usize::try_from(index).ok()?.checked_mul(4)?;
    words(bytes.get(start..)?).next()
}

/// Every word that differs between two runs of one job.
pub fn outputs<E: AsRef<[u8]>, G: AsRef<[u8]>>(reads: &[Read], expected: &[E], got: &[G]) -> Option<Table> {
    let mut table = Table::default();
    for (index, read) in reads.iter().enumerate() {
        let expected = expected.get(index).map_or(&[][..], AsRef::as_ref);
        let got = got.get(index).map_or(&[][..], AsRef::as_ref);
        if expected == got {
            continue;
        }
        sizes(&mut table, read, expected.len(), got.len());
        for (i, (e, g)) in words(expected).zip(words(got)).enumerate().filter(|(_, (e, g))| e != g) {
            table.push(|| Row::word(&read.name, i as u64, e, g));
        }
    }
    table.some()
}

fn sizes(table: &mut Table, read: &Read, expected: usize, got: usize) {
    if expected != got {
        table.push(|| Row::text(&read.name, "size", format!("{expected} bytes"), format!("{got} bytes")));
    }
}

/// Every word by which a run differs from what the oracle says.
pub fn oracle<G: AsRef<[u8]>>(reads: &[Read], expected: &[Expected], got: &[G]) -> Option<Table> {
    let mut table = Table::default();
    if expected.len() != reads.len() {
        let (wanted, answers) = (format!("{} answers", reads.len()), format!("{} answers", expected.len()));
        return Some(Table::one(Row::text("(oracle)", "-", wanted, answers)));
    }
    for ((read, expected), got) in reads.iter().zip(expected).zip(got) {
        let got = got.as_ref();
        match expected {
            Expected::Whole(expected) => {
                sizes(&mut table, read, expected.len() * 4, got.len());
                for (i, (&e, g)) in expected.iter().zip(words(got)).enumerate().filter(|(_, (e, g))| *e != g) {
                    table.push(|| Row::word(&read.name, i as u64, e, g));
                }
            }
            Expected::Sample { words, .. } => {
                if words.is_empty() && !got.is_empty() {
                    table.push(|| Row::text(&read.name, "-", "a sample of words", "an empty sample"));
                }
                for &(i, e) in words {
                    match word_at(got, u64::from(i)) {
                        Some(g) if g == e => {}
                        Some(g) => table.push(|| Row::word(&read.name, u64::from(i), e, g)),
                        None => {
                            table.push(|| Row::text(&read.name, &i.to_string(), format!("{e:#010x}"), "past the end"))
                        }
                    }
                }
            }
        }
    }
    table.some()
}

#[cfg(test)]
mod tests {
    use super::*;
    use sightlines_backend::BufferId;

    fn read(name: &str, size: u64) -> Read {
        Read { name: name.into(), buffer: BufferId(0), offset: 0, size }
    }

    fn bytes(words: &[u32]) -> Vec<u8> {
        words.iter().flat_map(|w| w.to_le_bytes()).collect()
    }

    #[test]
    fn equal_outputs_have_no_table() {
        let data = [bytes(&[1, 2, 3])];
        assert_eq!(outputs(&[read("a", 12)], &data, &data), None);
        assert_eq!(oracle(&[read("a", 12)], &[Expected::Whole(vec![1, 2, 3])], &data), None);
    }

    #[test]
    fn the_table_names_buffer_index_and_both_words_and_counts_the_rest() {
        let expected = bytes(&(0..40).collect::<Vec<u32>>());
        let got = bytes(&(0..40).map(|i| if i >= 20 { i ^ 1 } else { i }).collect::<Vec<u32>>());
        let table = outputs(&[read("masks", 160)], &[expected], &[got]).unwrap();
        assert_eq!((table.total, table.rows.len()), (20, SHOWN));
        assert_eq!(table.rows[0], Row::word("masks", 20, 20, 21));
        let text = table.render("popcount", "full", "cpu");
        assert!(text.contains("popcount  full  cpu      masks   20     0x00000014  0x00000015"), "{text}");
        assert!(text.ends_with("… 10 more\n"), "{text}");
    }

    #[test]
    fn an_oracle_that_says_nothing_or_too_little_is_a_difference() {
        let (reads, data) = ([read("a", 8)], [bytes(&[1, 2])]);
        let sample = |words: Vec<(u32, u32)>| Expected::Sample { words, seed: 0 };
        assert!(oracle(&reads, &[], &data).is_some());
        assert!(oracle(&reads, &[sample(vec![])], &data).is_some());
        assert!(oracle(&reads, &[sample(vec![(2, 0)])], &data).is_some());
        assert!(oracle(&reads, &[Expected::Whole(vec![1])], &data).is_some());
        assert!(oracle(&reads, &[sample(vec![(1, 2)])], &data).is_none());
    }

    #[test]
    fn floats_are_shown_only_where_they_help() {
        assert_eq!(Row::word("a", 0, 1.5f32.to_bits(), 2.5f32.to_bits()).floats.as_deref(), Some("1.5 | 2.5"));
        assert_eq!(Row::word("a", 0, 7, 8).floats, None);
    }
}
