//! ARCHITECTURE.md walks a kernel through lowering and execution: the code it shows is the code that runs.

use sightlines_backend::{Linked, Program};
use sightlines_backend_cpu::CpuBackend;

const PAGE: &str = include_str!("../../ARCHITECTURE.md");

/// The first block of that language behind the section's head.
fn block(language: &str) -> &'static str {
    let section = PAGE.split("## One kernel, both stages").nth(1).expect("ARCHITECTURE.md has the section");
    let open = format!("```{language}\n");
    let from = section.split(&open).nth(1).unwrap_or_else(|| panic!("the section has a block of {language}"));
    from.split("```").next().expect("a block ends")
}

#[test]
fn the_page_shows_the_code_that_the_kernel_becomes() {
    let linked = Linked::single("halvings.wgsl", block("wgsl")).expect("the kernel is text");
    let program = Program::unlinted("halvings", linked).expect("the kernel is valid");
    let code = CpuBackend::lowered(&program, "main", &[]).expect("the kernel can be lowered").to_string();
    assert!(block("text") == code, "ARCHITECTURE.md shows other code than the kernel becomes now, which is:\n{code}");
}
