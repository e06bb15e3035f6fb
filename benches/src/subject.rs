//! What is measured: the real-size cases of every kernel, then the micro-kernels, in one fixed order.

use std::fmt;

use sightlines_backend::kernel::MakeJob;
use sightlines_backend::{Outputs, Size};
use sightlines_kernels::registry;

use crate::micro;

/// Kernel name that the micro-kernels go by.
pub const MICRO: &str = "micro";

/// One piece of work to measure.
pub struct Subject {
    /// Name of the kernel, or [`MICRO`].
    pub kernel: &'static str,
    /// Name of the case.
    pub case: String,
    /// The work.
    pub job: MakeJob,
    native: Option<fn() -> Vec<u32>>,
    portable: bool,
}

/// `kernel/case`.
impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.kernel, self.case)
    }
}

impl Subject {
    /// Whether every machine must give the same bits.
    pub fn is_portable(&self) -> bool {
        self.portable
    }

    /// The first output word that differs from the native computation, where there is one and it binds `backend`.
    pub fn first_error(&self, backend: &str, outputs: &Outputs) -> Option<String> {
        let native = self.native.filter(|_| self.portable || backend == "cpu")?();
        let given: Vec<u32> = outputs.iter().flat_map(|bytes| words(bytes)).collect();
        if given.len() != native.len() {
            return Some(format!("{self}: {} words instead of {}", given.len(), native.len()));
        }
        let at = (0..native.len()).find(|&i| given[i] != native[i])?;
        Some(format!("{self}: word {at} is {:#010x} instead of {:#010x}", given[at], native[at]))
    }
}

fn words(bytes: &[u8]) -> impl Iterator<Item = u32> {
    bytes.as_chunks().0.iter().map(|word| u32::from_le_bytes(*word))
}

/// Every subject: kernels by name, their cases in order, micro-kernels last.
pub fn subjects() -> Vec<Subject> {
    let mut subjects = Vec::new();
    for kernel in registry() {
        let real = (kernel.cases)().into_iter().filter(|case| case.size == Size::Real);
        subjects.extend(real.map(|case| Subject {
            kernel: kernel.name,
            case: case.name,
            job: case.job,
            native: None,
            portable: true,
        }));
    }
    subjects.extend(micro::ALL.iter().map(|micro| Subject {
        kernel: MICRO,
        case: micro.name.to_owned(),
        job: Box::new(|| micro.job()),
        native: Some(micro.native),
        portable: micro.portable,
    }));
    subjects
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kernel_has_a_subject_and_ids_are_unique() {
        let ids: Vec<String> = subjects().iter().map(Subject::to_string).collect();
        for kernel in registry() {
            assert!(
                ids.iter().any(|id| id.starts_with(&format!("{}/", kernel.name))),
                "{} is not measured",
                kernel.name
            );
        }
        for (i, id) in ids.iter().enumerate() {
            assert!(!ids[..i].contains(id), "{id} twice");
        }
    }

    #[test]
    fn a_wrong_word_is_found() {
        let subjects = subjects();
        let micro = subjects.iter().find(|s| s.to_string() == "micro/mandelbrot").unwrap();
        let mut right: Vec<u8> = micro.native.unwrap()().iter().flat_map(|word| word.to_le_bytes()).collect();
        assert_eq!(micro.first_error("cpu", &vec![right.clone()]), None);
        right[4 * 9] ^= 1;
        assert!(micro.first_error("cpu", &vec![right.clone()]).unwrap().contains("word 9 is"));
        assert_eq!(micro.first_error("wgpu", &vec![right.clone()]), None, "drivers may rewrite its f32");
        right.truncate(4);
        assert!(micro.first_error("cpu", &vec![right]).unwrap().contains("1 words instead of 65536"));
    }
}
