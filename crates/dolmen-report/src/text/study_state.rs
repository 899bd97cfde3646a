//! Progress of a study, as text.

use dolmen_work::study::Plan;

/// Largest number of missing scans listed by name; the others are counted.
const MISSING_SHOWN: usize = 20;

/// A finished shard: its result is the journal.
pub fn shard_text(
    plan: &Plan<'_>,
    shard: (usize, usize),
    [runs, missing]: [usize; 2],
    journal: &str,
) -> String {
    format!(
        "Study \"{}\", shard {} of {}: {runs} runs, {missing} scans missing, in {journal}\n`dolmen study merge` puts the shards together\n",
        plan.study.name, shard.0, shard.1,
    )
}

/// The scans that are not done yet.
pub fn missing_text(plan: &Plan<'_>, runs: usize, missing: &[usize]) -> String {
    let mut text = format!(
        "Study \"{}\": {} of {} scans are done, {runs} runs\n",
        plan.study.name,
        plan.jobs() - missing.len(),
        plan.jobs(),
    );
    for &job in missing.iter().take(MISSING_SHOWN) {
        text += &format!("  missing: {}\n", plan.scan_words(job));
    }
    if missing.len() > MISSING_SHOWN {
        text += &format!("  and {} more\n", missing.len() - MISSING_SHOWN);
    }
    text
}
