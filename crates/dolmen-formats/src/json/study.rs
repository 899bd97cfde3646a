//! A study, as JSON.

use crate::study::{StudyAnswer, quantile_of_capacities};
use dolmen::assess::{AssessError, Direction};
use serde_json::{Map, Value, json};

/// Everything of a study but its single runs.
///
/// # Errors
/// As [`StudyAnswer::trends`].
pub fn study_json(answer: &StudyAnswer) -> Result<Value, AssessError> {
    let study = &answer.study;
    let outcomes: Map<String, Value> = answer
        .outcomes()
        .into_iter()
        .map(|(outcome, count)| (outcome.word().to_owned(), json!(count)))
        .collect();
    let refusals = answer
        .refusals()
        .into_iter()
        .map(|(why, count)| json!({ "why": why, "count": count }));
    let inputs = answer.inputs.iter().map(|input| {
        json!({ "path": input.path, "column": input.column, "unit": input.unit, "drawn": input.is_drawn })
    });
    Ok(json!({
        "file": answer.file,
        "name": { "en": answer.name.en, "ko": answer.name.ko },
        "study": study.name,
        "kind": answer.kind.word(),
        "inputs": inputs.collect::<Vec<_>>(),
        "cases": answer.cases.len(),
        "samples": study.samples,
        "seed": study.seed,
        "motions": answer.motions,
        "directions_deg": study.turns_rad.iter().map(|turn| turn.to_degrees()).collect::<Vec<_>>(),
        "scans": answer.jobs(),
        "scans_missing": answer.missing.len(),
        "runs": answer.runs.len(),
        "outcomes": outcomes,
        "refused": refusals.collect::<Vec<_>>(),
        "levels": levels(answer),
        "trends": trends(answer)?,
    }))
}

/// An acceleration, `null` beyond the scan.
fn acceleration(value_m_s2: f64) -> Value {
    if value_m_s2.is_finite() {
        json!(value_m_s2)
    } else {
        Value::Null
    }
}

fn levels(answer: &StudyAnswer) -> Vec<Value> {
    let each = answer.levels().into_iter().map(|row| {
        let quantile = |probability| acceleration(quantile_of_capacities(&row.first_fall_m_s2, probability));
        let [ds1, ds2, ds3] = row.median_states_m_s2.map(acceleration);
        json!({
            "input": row.input.map(|input| answer.inputs[input].path.clone()),
            "text": row.text,
            "value": row.value,
            "scans": row.first_fall_m_s2.len(),
            "first_fall_q05_m_s2": quantile(0.05),
            "first_fall_median_m_s2": quantile(0.5),
            "first_fall_q95_m_s2": quantile(0.95),
            "not_fallen": row.first_fall_m_s2.iter().filter(|value| value.is_infinite()).count(),
            "median_ds1_m_s2": ds1, "median_ds2_m_s2": ds2, "median_ds3_m_s2": ds3,
            "survived_above": row.survived_above,
        })
    });
    each.collect()
}

fn trends(answer: &StudyAnswer) -> Result<Vec<Value>, AssessError> {
    let word = |direction| match direction {
        Direction::Rising => "rising",
        Direction::Falling => "falling",
    };
    let each = answer.trends()?.into_iter().map(|trend| {
        let tau = trend.of_medians;
        let expected = trend.expected.as_ref();
        json!({
            "input": answer.inputs[trend.input].path,
            "tau": tau.tau,
            "tau_by_chance": tau.tau_by_chance,
            "pairs": tau.pairs,
            "concordant": tau.concordant,
            "discordant": tau.discordant,
            "tau_of_each": trend.of_each,
            "expected": expected.map(|(expected, _)| word(expected.direction)),
            "verdict": expected.map(|(_, verdict)| verdict.word()),
            "source": expected.and_then(|(expected, _)| expected.source.clone()),
        })
    });
    Ok(each.collect())
}
