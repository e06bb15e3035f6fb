//! Linking: what is an import and what only looks like one, the map back to the author's line, defines, requirements.

use std::collections::HashMap;

use sightlines_backend::{Define, ErrorKind, Linked, Location, Program};

fn link(files: &[(&str, &str)], defines: &[Define]) -> Result<Linked, sightlines_backend::Error> {
    let files: HashMap<String, String> = files.iter().map(|&(p, t)| (p.to_owned(), t.to_owned())).collect();
    Linked::link("main.wgsl", &move |path| files.get(path).cloned(), defines)
}

#[track_caller]
fn text(files: &[(&str, &str)]) -> String {
    link(files, &[]).unwrap_or_else(|e| panic!("{e}")).text
}

/// The message and place of a refusal.
#[track_caller]
fn refused(files: &[(&str, &str)], defines: &[Define]) -> (String, Option<Location>) {
    let error = link(files, defines).expect_err("must be refused");
    match error.kind() {
        ErrorKind::Wgsl { stage: "link", location, rendered } => (rendered.clone(), location.clone()),
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn says(files: &[(&str, &str)], expected: &str, line: u32) {
    let (message, at) = refused(files, &[]);
    assert!(message.contains(expected), "`{expected}` is not in\n{message}");
    assert_eq!(at.map(|l| l.line), Some(line), "{message}");
}

const AB: (&str, &str) =
    ("shared/ab.wgsl", "fn a() {}\nfn b() {}\nconst C = 1;\nstruct S { x: u32 }\nalias T = u32;\n");

#[test]
fn imports_become_blanks_of_equal_length() {
    let main = "// head\nimport package::shared::ab::{a, b,\n  C}; // why\nfn main() {}\n";
    let linked = text(&[("main.wgsl", main), AB]);
    let (first, second) = ("import package::shared::ab::{a, b,".len(), "  C};".len());
    let blank = format!("// head\n{:first$}\n{:second$} // why\nfn main() {{}}\n", "", "");
    assert_eq!(linked, format!("{}{blank}", AB.1));
}

#[test]
fn single_items_lists_and_every_kind_of_item() {
    for import in ["a", "b", "C", "S", "T", "{a}", "{a, b}", "{ S , T, }"] {
        let main = format!("import package::shared::ab::{import};\nfn main() {{}}\n");
        assert!(text(&[("main.wgsl", &main), AB]).starts_with(AB.1), "{import}");
    }
}

#[test]
fn a_file_is_included_once_before_its_importers() {
    let one = ("one.wgsl", "import package::shared::ab::a;\nfn one() { a(); }\n");
    let two = ("two.wgsl", "import package::shared::ab::b;\nimport package::one::one;\nfn two() { one(); b(); }\n");
    let main = ("main.wgsl", "import package::one::one;\nimport package::two::two;\nfn main() { one(); two(); }\n");
    let linked = link(&[main, one, two, AB], &[]).expect("links");
    let paths: Vec<_> = linked.files.iter().map(|f| f.path.as_str()).collect();
    assert_eq!(paths, ["shared/ab.wgsl", "one.wgsl", "two.wgsl", "main.wgsl"]);
}

#[test]
fn what_only_looks_like_an_import_is_text() {
    let main = "/* import package::no::a;\n/* import package::no::b; */\nimport package::no::c; */\n\
                // import package::no::d;\nfn main() {\n  let important = 1; // import package::no::e;\n}\n";
    assert_eq!(text(&[("main.wgsl", main)]), main);
}

#[test]
fn line_ends_are_kept_and_files_stand_on_lines_of_their_own() {
    let main = "import package::shared::ab::a;\r\nfn main() {}";
    let open = (AB.0, AB.1.trim_end());
    let linked = link(&[("main.wgsl", main), open], &[]).expect("links");
    assert!(linked.text.starts_with(AB.1) && linked.text.ends_with(" \r\nfn main() {}"), "{:?}", linked.text);
    let byte = linked.text.find("main").expect("main");
    assert_eq!(linked.locate(byte), Some(Location { file: "main.wgsl".into(), line: 2, column: 4 }));
    // The end of the text is on a line that the author wrote.
    assert_eq!(linked.locate(linked.text.len()).map(|l| l.line), Some(2));
    assert_eq!(linked.locate(linked.text.len() + 1), None);
    let first = linked.locate(AB.1.len()).expect("first byte of main");
    assert_eq!((first.file.as_str(), first.line, first.column), ("main.wgsl", 1, 1));
}

#[test]
fn malformed_imports_are_refused_at_their_line() {
    let reads = "an import reads `import package::folder::file::item;`";
    for import in
        ["ab::a", "package::a", "package::shared::ab::*", "package::shared::ab", "package::{a::b}", "super::x::y"]
    {
        let expected = if import == "package::shared::ab" { "no file `shared.wgsl`" } else { reads };
        says(&[("main.wgsl", &format!("\nimport {import};\n")), AB], expected, 2);
    }
    for import in ["package::shared::ab::{}", "package::shared::ab::{a b}", "package::shared::ab::{a,,b}"] {
        says(&[("main.wgsl", &format!("import {import};\n")), AB], reads, 1);
    }
}

#[test]
fn renaming_is_refused() {
    says(&[("main.wgsl", "import package::shared::ab::a as b;"), AB], "an import cannot rename: `as`", 1);
}

#[test]
fn imports_stand_at_the_top() {
    let main = "const X = 1;\nimport package::shared::ab::a;\n";
    says(&[("main.wgsl", main), AB], "`import` stands after another item; move it to the top", 2);
}

#[test]
fn unknown_files_and_items_are_named() {
    says(&[("main.wgsl", "\n\nimport package::no::a;\n")], "no file `no.wgsl` in this package", 3);
    says(&[("main.wgsl", "import package::shared::ab::{a, z};\n"), AB], "`shared/ab.wgsl` declares no `z`", 1);
    let (message, at) = refused(&[], &[]);
    assert!(message.contains("no file `main.wgsl`") && at.is_none(), "{message}");
}

#[test]
fn names_inside_functions_and_comments_are_not_items() {
    let inner = ("in.wgsl", "// fn c() {}\nfn f() { const d = 1; }\n/* struct e {} */\n");
    for name in ["c", "d", "e"] {
        says(&[("main.wgsl", &format!("import package::in::{name};")), inner], "declares no", 1);
    }
}

#[test]
fn cycles_are_drawn() {
    let a = ("a.wgsl", "import package::b::b;\nfn a() {}\n");
    let b = ("b.wgsl", "// b\nimport package::a::a;\nfn b() {}\n");
    says(&[("main.wgsl", "import package::a::a;\n"), a, b], "import cycle: a.wgsl -> b.wgsl -> a.wgsl", 2);
    says(&[("main.wgsl", "import package::main::f;\nfn f() {}\n")], "import cycle: main.wgsl -> main.wgsl", 1);
}

#[test]
fn endless_chains_of_files_are_refused() {
    let chain = |path: &str| {
        let n: u32 = path.trim_end_matches(".wgsl").trim_start_matches('f').parse().unwrap_or(0);
        Some(format!("import package::f{}::x;\nfn x() {{}}\n", n + 1))
    };
    let error = Linked::link("f0.wgsl", &chain, &[]).expect_err("endless");
    assert!(error.to_string().contains("imports nest deeper than 64 files"), "{error}");
}

#[test]
fn defines_replace_the_initialiser_of_a_const() {
    let main = "const SIZE: u32 = 64u; // words\nconst FLAG = true;\nfn main() { const SIZE = 3; }\n";
    let defines = [Define::new("SIZE", "128u"), Define::new("FLAG", false)];
    let linked = link(&[("main.wgsl", main)], &defines).expect("links");
    assert_eq!(linked.text, "const SIZE: u32 = 128u; // words\nconst FLAG = false;\nfn main() { const SIZE = 3; }\n");
    let imported = link(&[("main.wgsl", "import package::shared::ab::C;\n"), AB], &[Define::new("C", -2)]);
    assert!(imported.expect("links").text.contains("const C = -2;\n"));
}

#[test]
fn bad_defines_are_refused() {
    let main = ("main.wgsl", "const A = 1;\nconst B =\n  2;\nfn F() {}\n");
    let cases = [
        (vec![Define::new("Z", 1)], "no module-scope `const Z` to define in main.wgsl or its imports"),
        (vec![Define::new("F", 1)], "no module-scope `const F`"),
        (vec![Define::new("B", 1)], "the initialiser of `const B` spans lines"),
        (vec![Define::new("A", "1 + 1")], "`1 + 1` defines `const A`; the value must be one literal"),
        (vec![Define::new("A", "1; const X = 2")], "must be one literal"),
        (vec![Define::new("A", "1 // x")], "must be one literal"),
        (vec![Define::new("A", "x")], "must be one literal"),
        (vec![Define::new("A", "")], "must be one literal"),
        (vec![Define::new("A", 1), Define::new("A", 2)], "`const A` is defined twice"),
    ];
    for (defines, expected) in cases {
        let (message, _) = refused(&[main], &defines);
        assert!(message.contains(expected), "`{expected}` is not in\n{message}");
    }
}

const TABLE: (&str, &str) =
    ("shared/table.wgsl", "// t\nrequire table: array<u32>;\nfn at(i: u32) -> u32 { return table[i]; }\n");

#[test]
fn requirements_are_met_by_a_global_of_the_program() {
    let import = "import package::shared::table::at;\n";
    let declaration = "@group(0) @binding(0) var<storage, read> table: array<u32>;\n";
    let linked = text(&[("main.wgsl", &format!("{import}{declaration}")), TABLE]);
    let blank = "require table: array<u32>;".len();
    assert!(linked.starts_with(&format!("// t\n{:blank$}\nfn at", "")), "{linked}");
    text(&[("main.wgsl", &format!("{import}const table = array<u32, 1>(1);\n")), TABLE]);
}

#[test]
fn missing_requirements_name_both_files() {
    for main in ["import package::shared::table::at;\n", "import package::shared::table::at;\nfn table() {}\n"] {
        says(
            &[("main.wgsl", main), TABLE],
            "`main.wgsl` must declare a module-scope `table`: shared/table.wgsl requires it (line 2)",
            2,
        );
    }
    says(&[("main.wgsl", "require table;\n")], "a requirement reads `require name: type;`", 1);
    says(&[("main.wgsl", "fn f() {}\nrequire t: u32;\n")], "`require` stands after another item", 2);
}

#[test]
fn errors_name_the_imported_file_and_its_line() {
    let shared = ("shared/bad.wgsl", "fn good() -> u32 {\n    return 1u;\n}\nfn bad() -> u32 {\n    return 1.5;\n}\n");
    let main = "import package::shared::bad::bad;\n@compute @workgroup_size(1) fn main() { _ = bad(); }\n";
    let files = [("main.wgsl", main), shared];
    let sources = move |path: &str| files.iter().find(|(p, _)| *p == path).map(|(_, t)| (*t).to_owned());
    let error = Program::new("bad", "main.wgsl", &sources, &[]).expect_err("type error");
    let ErrorKind::Wgsl { location: Some(at), rendered, .. } = error.kind() else { panic!("{error:?}") };
    assert_eq!((at.file.as_str(), at.line), ("shared/bad.wgsl", 5), "{rendered}");
    assert!(rendered.contains("shared/bad.wgsl:5:"), "{rendered}");
}

#[test]
fn link_errors_show_the_line() {
    let (message, _) = refused(&[("main.wgsl", "// head\n  import package::no::a; // why\n")], &[]);
    let expected = "error: no file `no.wgsl` in this package
  ┌─ main.wgsl:2:3
  │
2 │   import package::no::a; // why
  │   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
";
    assert_eq!(message.trim_end(), expected.trim_end());
}
