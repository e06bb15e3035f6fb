//! What every kernel of the registry must keep: names, texts, programs that compile, jobs that a device accepts, and
//! oracles whose answers have the shape of what is read.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use sightlines_backend::{Case, Command, Dispatch, Expected, Groups, Job, Kernel, Size, check};
use sightlines_kernels::{registry, source};

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
fn every_case_is_sound_and_together_they_run_every_program_and_entry_point() {
    // A kernel may be composed with others: their programs are listed where they belong.
    let all: Vec<_> = registry().iter().flat_map(|kernel| (kernel.programs)().expect("they compile")).collect();
    let known: HashSet<&str> = all.iter().map(|program| program.id()).collect();
    for kernel in registry() {
        let programs = (kernel.programs)().expect("they compile");
        let listed: HashSet<&str> = programs.iter().map(|program| program.id()).collect();
        let mut programs_left = listed.clone();
        let mut entries_left: HashSet<&str> =
            programs.iter().flat_map(|program| program.entries()).map(|entry| entry.name.as_str()).collect();
        for case in (kernel.cases)() {
            let name = format!("{}/{}", kernel.name, case.name);
            let job = (case.job)().unwrap_or_else(|error| panic!("{name}: {error}"));
            check::job(&job).unwrap_or_else(|error| panic!("{name}: {error}"));
            bounded(&name, &case, &job);
            answered(&name, &case, &job);
            for program in &job.programs {
                assert!(known.contains(program.id()), "{name} runs {}, which is not listed", program.label());
                programs_left.remove(program.id());
            }
            let own = |d: &&Dispatch| listed.contains(job.programs[d.program.0 as usize].id());
            for dispatch in dispatches(&job).filter(own) {
                entries_left.remove(dispatch.entry.as_str());
            }
        }
        assert!(programs_left.is_empty(), "no case of {} runs {programs_left:?}", kernel.name);
        assert!(entries_left.is_empty(), "no case of {} runs {entries_left:?}", kernel.name);
    }
}

fn dispatches(job: &Job) -> impl Iterator<Item = &Dispatch> {
    job.recordings.iter().flat_map(|recording| &recording.commands).filter_map(|command| match command {
        Command::Dispatch(dispatch) => Some(dispatch),
        _ => None,
    })
}

/// Some work, and not too much of it.
fn bounded(name: &str, case: &Case, job: &Job) {
    let (most_bytes, most_groups) = match case.size {
        Size::Small => (8 << 20, 1 << 10),
        Size::Real => (256 << 20, 1 << 18),
    };
    let bytes: u64 = job.buffers.iter().map(|buffer| buffer.size).sum();
    let groups = dispatches(job).map(|dispatch| match dispatch.groups {
        Groups::Direct(groups) => groups.iter().map(|&n| u64::from(n)).product(),
        Groups::Indirect { .. } => 0,
    });
    let groups: u64 = groups.sum();
    assert!(bytes <= most_bytes, "{name} holds {bytes} bytes");
    assert!((1..=most_groups).contains(&groups), "{name} runs {groups} workgroups");
    assert!(job.recordings.iter().all(|recording| !recording.commands.is_empty()), "{name} has an empty recording");
}

/// An answer for every word that is read, and probes that show words of the first output.
fn answered(name: &str, case: &Case, job: &Job) {
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
    let words = job.reads[0].size / 4;
    assert!(case.probes.iter().all(|probe| u64::from(*probe) < words), "{name}: probes past {words} words");
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
