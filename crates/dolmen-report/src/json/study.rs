//! A study, as JSON.

use super::damage::damage;
use super::fragility::{fragilities_json, joints_json, measures_json, sufficiency_json};
use crate::as_json;
use crate::finite::JsonObject;
use dolmen::assess::{AssessError, Direction, Reached};
use dolmen_work::simulation::SPEED_AT_REST_M_S;
use dolmen_work::study::{RunMeasures, StudyAnswer};
use serde_json::Value;

/// A study without its single runs.
///
/// # Errors
/// As [`StudyAnswer::trends`].
pub fn study_json(answer: &StudyAnswer) -> Result<Value, AssessError> {
    let study = &answer.study;
    let outcomes = answer.outcomes().into_iter();
    let outcomes = outcomes
        .map(|(outcome, count)| (outcome.word(), count))
        .collect::<JsonObject>()
        .done();
    let refusals = answer
        .refusals()
        .into_iter()
        .map(|(why, count)| as_json!({ "why": why.english, "count": count }));
    let inputs = answer.inputs.iter().map(|input| {
        as_json!({ "path": input.path, "column": input.column, "unit": input.unit, "drawn": input.is_drawn })
    });
    Ok(as_json!({
        "file": answer.file,
        "name": { "en": answer.name.en, "ko": answer.name.ko },
        "study": study.name,
        "kind": answer.kind.word(),
        "version": answer.version,
        "law": answer.law(),
        "contact_points_a_joint": answer.law().map(|_| study.points),
        "rest_s": answer.rest_s(),
        "halvings": study.refine,
        "damage": answer.law().map(|_| as_json!({
            "slip_begun_m": study.damage.slip_begun_m, "offset_ratio": study.damage.offset_ratio, "offset_m": study.damage.offset_m,
            "severe_offset_ratio": study.damage.severe_offset_ratio, "severe_rocking_ratio": study.damage.severe_rocking_ratio,
        })),
        "damage_in_model": answer.model_damage.iter().map(|of| damage(&of.damage)).collect::<Vec<_>>(),
        "noise_seed": study.artificial.map(|made| made.seed),
        "notes": answer.notes.iter().map(|note| &note.english).collect::<Vec<_>>(),
        "left_out_of_runs": answer.left_out_of_runs.iter().map(|said| &said.english).collect::<Vec<_>>(),
        "undamped": answer.is_undamped,
        "after": after(answer),
        "copies": answer.copies.iter().map(|copy| as_json!({ "motion": copy.motion, "of": copy.of })).collect::<Vec<_>>(),
        "inputs": inputs.collect::<Vec<_>>(),
        "cases": answer.cases.len(),
        "samples": study.samples,
        "seed": study.seed,
        "motions": answer.motions,
        "directions_deg": study.turns_rad.iter().map(|turn| turn.to_degrees()).collect::<Vec<_>>(),
        "scans": answer.jobs(),
        "scans_missing": answer.missing.len(),
        "scans_left_out": left_out(answer),
        "allowed_drift": answer.allowed_drift().map(|of| as_json!({
            "limit": of.limit, "lean": of.lean, "before": of.before, "scans": of.scans, "beyond": of.beyond,
            "beyond_at_rest": of.at_rest, "least_m_s2": of.least_m_s2,
        })),
        "crushed_tenons": answer.crushed_tenons().map(|of| as_json!({
            "scans": of.scans, "crushed": of.crushed, "least_m_s2": of.least_m_s2, "depth_most_m": of.depth_m,
        })),
        "runs": answer.runs.len(),
        "outcomes": outcomes,
        "runs_beyond_room": answer.beyond_room().map_or(0, |(beyond, ..)| beyond),
        "refused": refusals.collect::<Vec<_>>(),
        "levels": levels(answer),
        "trends": trends(answer)?,
        "spectral_damping_ratio": study.spectral_damping_ratio,
        "fragility": fragilities_json(answer)?,
        "measures": measures_json(answer),
        "sufficiency": sufficiency_json(answer),
        "joints": joints_json(answer)?,
        "hazard": hazard(answer),
    }))
}

/// The hazard at the site; `None` if unknown.
fn hazard(answer: &StudyAnswer) -> Option<Vec<Value>> {
    let points = answer.hazard.as_ref()?.curve.points().iter();
    let point = |[peak, rate]: &[f64; 2]| as_json!({ "peak_acceleration_m_s2": peak, "annual_rate": rate });
    Some(points.map(point).collect())
}

/// The earlier motion, and the state of each case after it; `null` without one.
fn after(answer: &StudyAnswer) -> Value {
    let Some(after) = &answer.study.after else {
        return Value::Null;
    };
    let number = |value: f64| value.is_finite().then_some(value);
    let each = answer.before.iter().map(|of| {
        as_json!({
            "case": of.case + 1,
            "peak_ground_acceleration_m_s2": number(of.peak_m_s2),
            "outcome": of.outcome.word(),
            "damage_state": of.damage_state,
            "joint_states": of.joint_states,
            "at_s": number(of.at_s),
            "part": of.part,
            "still_s": number(of.still_s),
            "speed_at_rest_m_s": number(of.speed_m_s),
            "why": of.why.english,
            "measures": RunMeasures::names(answer.kind).iter()
                .map(|name| (*name, of.measures.named(name).and_then(number))).collect::<JsonObject>().done(),
        })
    });
    as_json!({
        "motion": after.motion,
        "speed_at_rest_most_m_s": SPEED_AT_REST_M_S,
        "states": each.collect::<Vec<_>>(),
    })
}

/// Scans left out of quantiles and trends.
fn left_out(answer: &StudyAnswer) -> Vec<Value> {
    let scans = answer.capacities().into_iter();
    let each = scans.filter(|scan| !scan.verdict.is_usable()).map(|scan| {
        as_json!({
            "scan": scan.job + 1,
            "verdict": scan.verdict.word(),
            "survived_m_s2": scan.survived_m_s2(),
            "fell_m_s2": scan.fell_m_s2(),
        })
    });
    each.collect()
}

fn levels(answer: &StudyAnswer) -> Vec<Value> {
    let each = answer.levels().into_iter().map(|row| {
        // `null` if only known to be larger; the second key gives the largest tried value
        let mut object = JsonObject::default();
        object.append(as_json!({
            "input": row.input.map(|input| answer.inputs[input].path.clone()),
            "text": row.text,
            "value": row.value,
            "scans": row.scans.len(),
            "scans_usable": row.usable(),
            "fell": row.fell(),
            "fell_by_themselves": row.fell_alone(),
            "not_fallen": row.usable() - row.fell(),
            "first_fall_least_m_s2": row.least_m_s2().filter(|least| least.is_reached()).map(Reached::value),
            "survived_above": row.survived_above(),
        }));
        for (name, state, probability) in [
            ("first_fall_q05", 3, 0.05),
            ("first_fall_median", 3, 0.5),
            ("first_fall_q95", 3, 0.95),
            ("median_ds1", 0, 0.5),
            ("median_ds2", 1, 0.5),
            ("median_ds3", 2, 0.5),
        ] {
            let found = row.quantile_m_s2(state, probability);
            let at = found.filter(|found| found.is_reached()).map(Reached::value);
            let above = found.filter(|found| !found.is_reached()).map(Reached::value);
            object.put(&format!("{name}_m_s2"), &at);
            object.put(&format!("{name}_above_m_s2"), &above);
        }
        object.done()
    });
    each.collect()
}

fn trends(answer: &StudyAnswer) -> Result<Vec<Value>, AssessError> {
    let word = |direction| match direction {
        Direction::Rising => "rising",
        Direction::Falling => "falling",
    };
    let each = answer.trends()?.into_iter().map(|trend| {
        let tau = trend.of_pairs;
        let expected = trend.expected.as_ref();
        as_json!({
            "input": answer.inputs[trend.input].path,
            "tau": tau.tau,
            "tau_by_chance": tau.tau_by_chance,
            "rises_by_chance": tau.rises_by_chance,
            "falls_by_chance": tau.falls_by_chance,
            "pairs": tau.pairs,
            "motions": tau.units,
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
