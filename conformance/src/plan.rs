//! Which cases run: filters, size and shard over the registry, in the registry's order.

use std::collections::BTreeSet;

use regex::Regex;
use sightlines_backend::{Case, Kernel, Size};

use crate::error::{Error, Result};

/// One case that runs.
pub struct Selected {
    /// The kernel's name.
    pub kernel: String,
    /// The case.
    pub case: Case,
    /// Whether `Case::expected` knows the answer by itself.
    pub has_oracle: bool,
    /// The snapshot that belongs to it.
    pub stored: Stored,
}

/// Where a case's snapshot stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stored {
    /// It has none: a kernel from the command line.
    Never,
    /// In the folder of snapshots.
    File,
    /// In the dump that is replayed.
    Text(String),
}

impl Selected {
    /// `kernel::case`, the name that filters see.
    pub fn name(&self) -> String {
        format!("{}::{}", self.kernel, self.case.name)
    }
}

/// One `--filter`.
#[derive(Clone, Debug)]
pub struct Filter {
    regex: Regex,
    inverted: bool,
}

impl std::str::FromStr for Filter {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (inverted, pattern) = text.strip_prefix('!').map_or((false, text), |rest| (true, rest));
        let regex = Regex::new(pattern).map_err(|e| e.to_string())?;
        Ok(Filter { regex, inverted })
    }
}

/// One of several equal parts of the cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which part, from 1.
    pub index: usize,
    /// How many parts.
    pub count: usize,
}

impl std::str::FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        let shard = parts.map(|(index, count)| Shard { index, count });
        shard.filter(|s| (1..=s.count).contains(&s.index)).ok_or_else(|| "a shard is I/N with 1 ≤ I ≤ N".into())
    }
}

/// What the command line selects.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// Filters over `kernel::case`: any of the plain ones must match, none of the inverted ones may.
    pub filters: Vec<Filter>,
    /// Leaves out cases of real size.
    pub quick: bool,
    /// One part of what is left.
    pub shard: Option<Shard>,
}

impl Selection {
    fn takes(&self, name: &str) -> bool {
        let mut plain = self.filters.iter().filter(|f| !f.inverted).peekable();
        let wanted = plain.peek().is_none() || plain.any(|f| f.regex.is_match(name));
        wanted && !self.filters.iter().any(|f| f.inverted && f.regex.is_match(name))
    }
}

/// The cases of a run, and what is known of those that do not run.
pub struct Plan {
    /// The cases that run.
    pub selected: Vec<Selected>,
    /// Kernel and case of everything in the registry.
    pub known: Vec<(String, String)>,
    /// Cases of real size that `--quick` left out.
    pub left_out: usize,
}

impl Plan {
    /// Selects cases from a registry.
    pub fn new(kernels: &[Kernel], selection: &Selection) -> Result<Self> {
        let mut plan = Plan { selected: Vec::new(), known: Vec::new(), left_out: 0 };
        for kernel in kernels {
            for case in (kernel.cases)() {
                plan.known.push((kernel.name.to_owned(), case.name.clone()));
                let selected =
                    Selected { kernel: kernel.name.to_owned(), case, has_oracle: true, stored: Stored::File };
                if !selection.takes(&selected.name()) {
                    continue;
                }
                if selection.quick && selected.case.size == Size::Real {
                    plan.left_out += 1;
                    continue;
                }
                plan.selected.push(selected);
            }
        }
        if let Some(shard) = selection.shard {
            let mut index = 0..;
            plan.selected.retain(|_| index.next().is_some_and(|i: usize| i % shard.count == shard.index - 1));
        }
        if plan.selected.is_empty() {
            let known = plan.known.len();
            return Err(Error::Nothing(format!("{known} cases are known; see `cargo xtask conformance --list`")));
        }
        Ok(plan)
    }

    /// What is wrong with the names in the registry.
    pub fn bad_names(&self) -> Vec<String> {
        let plain = |name: &str| {
            let rest = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
            name.starts_with(|c: char| c.is_ascii_lowercase() || c.is_ascii_digit()) && name.chars().all(rest)
        };
        let mut seen = BTreeSet::new();
        let mut bad = Vec::new();
        for (kernel, case) in &self.known {
            if !plain(kernel) || !plain(case) {
                bad.push(format!("{kernel}::{case}: names are lower case, digits and `_`"));
            }
            if !seen.insert((kernel, case)) {
                bad.push(format!("{kernel}::{case}: the name is used twice"));
            }
        }
        bad
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sightlines_backend::Job;

    fn case(name: &str, size: Size) -> Case {
        Case::new(name, size, || Ok(Job::new()), |_| Vec::new())
    }

    fn kernels() -> Vec<Kernel> {
        let kernel = |name, cases| Kernel { name, summary: "", citation: "", programs: || Ok(Vec::new()), cases };
        vec![
            kernel("alpha", || vec![case("empty", Size::Small), case("real", Size::Real)]),
            kernel("beta", || vec![case("empty", Size::Small), case("one", Size::Small)]),
        ]
    }

    fn names(filters: &[&str], quick: bool, shard: Option<&str>) -> Vec<String> {
        let selection = Selection {
            filters: filters.iter().map(|f| f.parse().unwrap()).collect(),
            quick,
            shard: shard.map(|s| s.parse().unwrap()),
        };
        Plan::new(&kernels(), &selection).map_or(vec![], |p| p.selected.iter().map(Selected::name).collect())
    }

    #[test]
    fn filters_join_and_inverted_filters_exclude() {
        assert_eq!(names(&[], false, None).len(), 4);
        assert_eq!(names(&["empty", "one"], false, None), ["alpha::empty", "beta::empty", "beta::one"]);
        assert_eq!(names(&["!beta"], false, None), ["alpha::empty", "alpha::real"]);
        assert_eq!(names(&["empty", "!^alpha"], false, None), ["beta::empty"]);
        assert_eq!(names(&["real"], true, None), [""; 0]);
    }

    #[test]
    fn shards_are_a_partition() {
        let mut all: Vec<String> = (1..=3).flat_map(|i| names(&[], false, Some(&format!("{i}/3")))).collect();
        all.sort();
        assert_eq!(all, names(&[], false, None));
        for bad in ["0/2", "3/2", "1", "a/b", "1/0"] {
            assert!(bad.parse::<Shard>().is_err(), "`{bad}` was accepted");
        }
    }

    #[test]
    fn nothing_selected_is_an_error() {
        let selection = Selection { filters: vec!["moon".parse().unwrap()], ..Selection::default() };
        assert!(matches!(Plan::new(&kernels(), &selection), Err(Error::Nothing(_))));
    }

    #[test]
    fn names_that_repeat_or_would_not_be_files_are_found() {
        let mut plan = Plan::new(&kernels(), &Selection::default()).unwrap();
        assert!(plan.bad_names().is_empty());
        plan.known.push(("alpha".into(), "empty".into()));
        plan.known.push(("alpha".into(), "../up".into()));
        assert_eq!(plan.bad_names().len(), 2);
    }
}
