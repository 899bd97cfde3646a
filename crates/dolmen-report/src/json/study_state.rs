//! Progress of a study, as JSON.

use crate::as_json;
use dolmen_work::study::Plan;
use serde_json::Value;

/// A finished shard: its result is the journal.
pub fn shard_json(
    plan: &Plan<'_>,
    shard: (usize, usize),
    [runs, missing]: [usize; 2],
    journal: &str,
) -> Value {
    as_json!({
        "study": plan.study.name, "shard": format!("{}/{}", shard.0, shard.1), "runs": runs,
        "scans_missing": missing, "journal": journal,
    })
}

/// The scans that are not done yet, each with its inputs.
pub fn missing_json(plan: &Plan<'_>, runs: usize, missing: &[usize]) -> Value {
    let scans = missing
        .iter()
        .map(|&job| as_json!({ "scan": job + 1, "inputs": plan.scan_words(job) }));
    as_json!({
        "study": plan.study.name, "scans": plan.jobs(), "runs": runs, "missing": scans.collect::<Vec<_>>(),
    })
}
