//! The report as one JSON object with a `schema` number, which grows when a field changes its meaning or goes.

use serde::Serialize;
use sightlines_backend::CONTRACT_VERSION;

use crate::result::Report;

/// Version of the object's shape.
pub const SCHEMA: u32 = 1;

#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    contract: u32,
    passed: usize,
    failed: usize,
    skipped: usize,
    #[serde(flatten)]
    report: &'a Report,
}

/// The report as JSON text.
pub fn render(report: &Report) -> serde_json::Result<String> {
    let (passed, failed, skipped) = report.totals();
    let document = Document { schema: SCHEMA, contract: CONTRACT_VERSION, passed, failed, skipped, report };
    serde_json::to_string_pretty(&document).map(|text| text + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::result::{CaseResult, Status};

    #[test]
    fn the_object_has_a_schema_and_totals() {
        let results = vec![CaseResult::new("scan", "one", "cpu", Status::UnexpectedPass, "why")];
        let text = render(&Report { results, ..Report::default() }).unwrap();
        let value: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!((&value["schema"], &value["failed"]), (&1.into(), &1.into()));
        assert_eq!(value["results"][0]["status"], "unexpected-pass");
        assert_eq!(value["results"][0]["message"], "why");
    }
}
