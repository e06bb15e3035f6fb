//! What every kernel of the registry must keep: names, texts, programs that compile, jobs that a device accepts, and
//! oracles whose answers have the shape of what is read.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use sightlines_backend::{Case, Command, Expected, Groups, Job, Kernel, Size, check};
use sightlines_kernels::{registry, source};

fn every_case(mut test: impl FnMut(&str, &Case)) {
    for kernel in registry() {
        for case in (kernel.cases)() {
            test(&format!("{}/{}", kernel.name, case.name), &case);
        }
    }
}

fn files(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is part of the package");
    entries.map(|entry| entry.expect("readable").file_name().into_string().expect("UTF-8")).collect()
}

#[test]
fn every_folder_is_a_registered_kernel_and_every_shared_text_is_known() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let folders = files(&src).into_iter().filter(|name| src.join(name).is_dir() && name != "shared");
    let folders: HashSet<String> = folders.collect();
    let registered: HashSet<String> = registry().iter().map(|kernel| kernel.name.to_owned()).collect();
    assert_eq!(folders, registered, "folders of kernels/src, and the registry in lib.rs");
    for folder in &folders {
        for file in ["mod.rs", "kernel.wgsl", "oracle.rs", "cases.rs"] {
            assert!(src.join(folder).join(file).is_file(), "{folder} has no {file}");
        }
    }
    for file in files(&src.join("shared")) {
        assert!(source(&format!("shared/{file}")).is_some(), "shared/{file} is not in the table of lib.rs");
    }
    assert_eq!(source("shared/no_such_file.wgsl"), None);
}

#[test]
fn names_are_sorted_unique_and_plain() {
    let plain = |name: &str| !name.is_empty() && name.chars().all(|c| matches!(c, 'a'..='z' | '0'..='9' | '_'));
    assert!(registry().is_sorted_by(|a, b| a.name < b.name), "the registry is sorted and has no name twice");
    for Kernel { name, summary, citation, cases, .. } in registry() {
        assert!(plain(name) && !summary.is_empty() && !citation.is_empty(), "{name}");
        let mut seen = HashSet::new();
        for case in cases() {
            assert!(plain(&case.name), "{name}/{}", case.name);
            assert!(seen.insert(case.name.clone()), "{name}/{} is there twice", case.name);
        }
    }
}

#[test]
fn every_program_compiles_and_is_its_own_variant() {
    let (mut ids, mut labels) = (HashSet::new(), HashSet::new());
    for kernel in registry() {
        let programs = (kernel.programs)().unwrap_or_else(|error| panic!("{}: {error}", kernel.name));
        assert!(!programs.is_empty(), "{} has no program", kernel.name);
        for program in programs {
            assert!(program.label().starts_with(kernel.name), "{}", program.label());
            assert!(ids.insert(program.id().to_owned()), "{} equals another variant", program.label());
            assert!(labels.insert(program.label().to_owned()), "{} is there twice", program.label());
        }
    }
}

#[test]
fn every_case_runs_only_programs_and_entries_that_its_kernel_lists() {
    for kernel in registry() {
        let listed: HashSet<String> =
            (kernel.programs)().expect("they compile").iter().map(|program| program.id().to_owned()).collect();
        let mut unused = listed.clone();
        for case in (kernel.cases)() {
            for program in (case.job)().expect("the job builds").programs {
                assert!(listed.contains(program.id()), "{}/{} runs {}", kernel.name, case.name, program.label());
                unused.remove(program.id());
            }
        }
        assert!(unused.is_empty(), "no case of {} runs {unused:?}", kernel.name);
    }
}

#[test]
fn every_entry_point_is_run_by_a_case() {
    for kernel in registry() {
        let entries = |program: &sightlines_backend::Program| {
            program.entries().iter().map(|entry| entry.name.clone()).collect::<Vec<_>>()
        };
        let mut unused: HashSet<String> =
            (kernel.programs)().expect("they compile").iter().flat_map(|program| entries(program)).collect();
        for case in (kernel.cases)() {
            for recording in (case.job)().expect("the job builds").recordings {
                for command in recording.commands {
                    if let Command::Dispatch(dispatch) = command {
                        unused.remove(&dispatch.entry);
                    }
                }
            }
        }
        assert!(unused.is_empty(), "no case of {} runs {unused:?}", kernel.name);
    }
}

#[test]
fn every_job_is_accepted_and_bounded() {
    every_case(|name, case| {
        let job = (case.job)().unwrap_or_else(|error| panic!("{name}: {error}"));
        check::job(&job).unwrap_or_else(|error| panic!("{name}: {error}"));
        let bytes: u64 = job.buffers.iter().map(|buffer| buffer.size).sum();
        let (most_bytes, most_groups) = match case.size {
            Size::Small => (8 << 20, 1 << 10),
            Size::Real => (256 << 20, 1 << 18),
        };
        assert!(bytes <= most_bytes, "{name} holds {bytes} bytes");
        assert!(groups(&job) <= most_groups, "{name} runs {} workgroups", groups(&job));
        let dispatches = job.recordings.iter().flat_map(|r| &r.commands).filter(|c| matches!(c, Command::Dispatch(_)));
        assert!(dispatches.count() > 0, "{name} runs no kernel");
    });
}

fn groups(job: &Job) -> u64 {
    let commands = job.recordings.iter().flat_map(|recording| &recording.commands);
    let groups = commands.map(|command| match command {
        Command::Dispatch(dispatch) => match dispatch.groups {
            Groups::Direct(groups) => groups.iter().map(|&n| u64::from(n)).product(),
            Groups::Indirect { .. } => 0,
        },
        _ => 0,
    });
    groups.sum()
}

#[test]
fn every_oracle_answers_every_read_and_every_probe_is_in_range() {
    every_case(|name, case| {
        let job = (case.job)().expect("the job builds");
        let expected = (case.expected)(&Vec::new());
        assert_eq!(expected.len(), job.reads.len(), "{name}: answers and reads");
        for (read, expected) in job.reads.iter().zip(&expected) {
            let words = read.size / 4;
            match expected {
                Expected::Whole(answer) => assert_eq!(answer.len() as u64, words, "{name}: words of {}", read.name),
                Expected::Sample { words: sample, .. } => {
                    assert!(!sample.is_empty(), "{name}: an empty sample of {}", read.name);
                    assert!(sample.iter().all(|(word, _)| u64::from(*word) < words), "{name}: {}", read.name);
                }
            }
        }
        assert!(!case.probes.is_empty(), "{name} shows no word");
        assert!(case.probes.is_sorted_by(|a, b| a < b), "{name}: probes are sorted and there once");
        let first = &job.reads[0];
        assert!(case.probes.iter().all(|probe| u64::from(*probe) < first.size / 4), "{name}: probes of {}", first.name);
    });
}

#[test]
fn every_kernel_has_cases_of_both_sizes() {
    for kernel in registry() {
        let cases = (kernel.cases)();
        let of = |size: Size| cases.iter().filter(|case| case.size == size).count();
        assert!(of(Size::Small) >= 4, "{} has {} small cases", kernel.name, of(Size::Small));
        assert!(of(Size::Real) >= 1, "{} has no case of real size", kernel.name);
    }
}
