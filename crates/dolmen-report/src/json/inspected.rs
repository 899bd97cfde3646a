//! Results of inspections over the years, as JSON.

use super::change_form::form;
use crate::as_json;
use crate::engineer::damage_words;
use dolmen_project::{DamageKind, Severity};
use dolmen_words::Language;
use dolmen_work::inspected::{Inspected, InspectionOf, WatchedDamage};
use serde_json::Value;

/// Inspections, and each damage; sizes are m.
pub(super) fn inspected(found: &Inspected) -> Value {
    let name = |at: usize| found.inspections.get(at).map(|of| of.survey.clone());
    as_json!({
        "inspections": found.inspections.iter().map(inspection).collect::<Vec<_>>(),
        "damages": found.damages.iter().map(|of| damage(of, &name)).collect::<Vec<_>>(),
        "several_alike": found.several.iter().map(|of| as_json!({
            "part": of.part, "what": words(&of.what), "most": of.most,
        })).collect::<Vec<_>>(),
        "undated": found.undated,
    })
}

fn words(kind: &DamageKind) -> String {
    damage_words(kind).text(Language::English)
}

fn inspection(of: &InspectionOf) -> Value {
    let counts = of.counts.iter().map(|(kind, [slight, moderate, severe, unrated])| {
        as_json!({ "what": words(kind), "slight": slight, "moderate": moderate, "severe": severe, "not_rated": unrated })
    });
    as_json!({ "survey": of.survey, "entries": of.all(), "counts": counts.collect::<Vec<_>>() })
}

fn damage(of: &WatchedDamage, name: &dyn Fn(usize) -> Option<String>) -> Value {
    let slope = of.trend.slope.as_ref();
    let reach = slope.and_then(|slope| slope.reach);
    let rated = of.severities.last().copied().flatten();
    let date = |reading: usize| {
        let read = of.readings.get(reading);
        read.and_then(|read| name(read.inspection))
    };
    as_json!({
        "part": of.part,
        "what": words(&of.what),
        "name": of.name,
        "listed": of.listed.iter().map(|at| name(*at)).collect::<Vec<_>>(),
        "severity": rated.map(Severity::word),
        "is_new": of.is_new(),
        "is_rated_worse": of.is_rated_worse(),
        "is_in_last": of.is_in_last,
        "is_repaired": of.is_repaired,
        "readings": of.readings.iter().map(|read| as_json!({
            "survey": name(read.inspection), "size_m": read.size_m, "sd_m": read.sd_m,
        })).collect::<Vec<_>>(),
        "per_year": slope.map(|slope| slope.per_year),
        "sd_per_year": slope.map(|slope| slope.sd_per_year),
        "p_value": slope.map(|slope| slope.p_value),
        "beyond_chance": of.trend.is_beyond_chance(),
        "seen_from_per_year": slope.map(|slope| slope.seen_from_per_year),
        "changes": of.trend.changes.iter().map(|change| as_json!({
            "form": form(change.form), "date": date(change.from), "date_earliest": date(change.after),
            "date_latest": date(change.before), "size": change.size, "sd": change.sd,
        })).collect::<Vec<_>>(),
        "outliers": of.trend.outliers.iter().map(|outlier| as_json!({
            "survey": date(outlier.at), "expected_m": outlier.expected,
        })).collect::<Vec<_>>(),
        "limit_m": of.limit_m,
        "beyond_limit": of.is_beyond(),
        "years_to_limit": reach.and_then(|reach| reach.years),
        "years_to_limit_earliest": reach.and_then(|reach| reach.years_earliest),
        "years_to_limit_latest": reach.and_then(|reach| reach.years_latest),
    })
}
