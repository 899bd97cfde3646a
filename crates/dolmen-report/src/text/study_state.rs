//! How far a study is, as text.

use dolmen_work::study::Plan;

/// Most missing scans that the text names; it counts the others.
const MISSING_SHOWN: usize = 20;

/// A shard that ended: its journal is its result.
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

/// Which scans are not done yet.
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
