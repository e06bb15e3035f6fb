//! The report as JUnit XML: a suite for each kernel, a test `case[machine]` for each result.

use std::time::Duration;

use quick_junit::{NonSuccessKind, Report as Document, SerializeError, TestCase, TestCaseStatus, TestSuite};

use crate::report::text::describe;
use crate::result::{CaseResult, Report, Status};

/// The report as XML text.
pub fn render(report: &Report) -> Result<String, SerializeError> {
    let mut document = Document::new("sightlines conformance");
    for kernel in report.results.chunk_by(|a, b| a.kernel == b.kernel) {
        let mut suite = TestSuite::new(&kernel[0].kernel);
        suite.add_test_cases(kernel.iter().map(case));
        document.add_test_suite(suite);
    }
    let mut suite = TestSuite::new("suite");
    for check in &report.suite {
        let status = status(check.status, &check.message, &check.message);
        suite.add_test_case(TestCase::new(check.name.as_str(), status));
    }
    document.add_test_suite(suite);
    document.to_string()
}

fn case(result: &CaseResult) -> TestCase {
    let name = format!("{}[{}]", result.case, result.machine);
    let mut case = TestCase::new(name, status(result.status, &result.message, &describe(result, "")));
    case.set_classname(result.kernel.as_str());
    case.set_time(Duration::from_nanos(result.timings.iter().map(|t| t.nanos).sum()));
    case
}

fn status(status: Status, message: &str, description: &str) -> TestCaseStatus {
    let mut told = match status {
        Status::Pass | Status::ExpectedFail => return TestCaseStatus::success(),
        Status::Skip => TestCaseStatus::skipped(),
        Status::Fail | Status::UnexpectedPass => TestCaseStatus::non_success(NonSuccessKind::Failure),
        Status::Trap | Status::Timeout => TestCaseStatus::non_success(NonSuccessKind::Error),
    };
    told.set_message(message);
    if status != Status::Skip {
        told.set_type(status.name()).set_description(description);
    }
    told
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_status_has_its_element() {
        let results = Status::ALL.map(|s| CaseResult::new("scan", s.name(), "cpu", s, "the <reason>")).into();
        let xml = render(&Report { results, ..Report::default() }).unwrap();
        assert!(xml.contains(r#"tests="7" skipped="1" failures="2" errors="2""#), "{xml}");
        assert_eq!(xml.matches("<skipped message=\"the &lt;reason&gt;\"").count(), 1, "{xml}");
        assert!(xml.contains(r#"<testcase name="trap[cpu]" classname="scan""#), "{xml}");
    }
}
