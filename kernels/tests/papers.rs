//! `docs/papers.md` names every capability once, and only kernels that exist.

use sightlines_kernels::registry;

const COUNTS: [(&str, u32); 4] = [("V", 39), ("O", 23), ("L", 19), ("G", 29)];

/// The cells of every row that begins with an id.
fn rows() -> Vec<[&'static str; 3]> {
    let cells = |line: &'static str| -> Option<[&str; 3]> {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        <[&str; 3]>::try_from(cells).ok().filter(|[id, ..]| *id != "id" && !id.starts_with('-'))
    };
    include_str!("../../docs/papers.md").lines().filter_map(cells).collect()
}

#[test]
fn every_capability_has_its_row_and_no_other_has_one() {
    let wanted: Vec<String> = COUNTS.iter().flat_map(|(k, n)| (1..=*n).map(move |i| format!("{k}{i}"))).collect();
    let found: Vec<&str> = rows().iter().map(|[id, ..]| *id).collect();
    assert_eq!(found, wanted);
}

#[test]
fn rows_say_where_and_name_kernels_that_exist() {
    let known: Vec<&str> = registry().iter().map(|kernel| kernel.name).collect();
    for [id, what, shown] in rows() {
        assert!(!what.is_empty() && !shown.is_empty(), "{id} is empty");
        let named: Vec<&str> = shown.split('`').skip(1).step_by(2).collect();
        assert!(!named.is_empty() || shown == "planned", "{id} is neither planned nor shown: {shown}");
        for name in named.iter().filter(|n| n.chars().all(|c| c.is_ascii_lowercase() || c == '_')) {
            let is_case = registry().iter().any(|k| (k.cases)().iter().any(|case| case.name == *name));
            assert!(known.contains(name) || is_case, "{id} names `{name}`, which is no kernel and no case");
        }
    }
}
