//! A ranked portfolio as JSON.

use super::judgement::severe;
use crate::as_json;
use crate::finite::JsonObject;
use crate::rank::not_by_rate;
use dolmen::assess::{Factor, RankedBy};
use dolmen_words::Language;
use dolmen_work::portfolio::{Basis, PortfolioAnswer, known_word, probability_in_years};
use dolmen_work::score::SCORE_STATES;
use serde_json::{Map, Value};

/// The whole ranking.
pub fn rank_json(answer: &PortfolioAnswer) -> Value {
    let rows = answer.rows().map(|(place, entry, _)| {
        let states: Map<String, Value> = entry
            .states
            .iter()
            .zip(SCORE_STATES)
            .map(|(known, name)| {
                let value = known.as_ref().map(|known| {
                    as_json!({
                        "theta_m_s2": known.fragility.theta(), "beta": known.fragility.beta(),
                        "ln_theta_sd": known.ln_theta_sd, "known": known_word(known.known),
                        "falls_by_itself": known.falls_alone,
                    })
                });
                (name.to_owned(), value.unwrap_or(Value::Null))
            })
            .collect();
        let basis = match &entry.basis {
            Basis::Study {
                name,
                variant,
                set,
                scans,
                fell_alone,
            } => as_json!({ "kind": "study", "study": name, "variant": variant, "set": set, "scans": scans, "scans_fell_by_themselves": fell_alone }),
            Basis::Score {
                reasons,
                outside,
                unlike,
            } => {
                let names = Factor::ALL.iter().map(|factor| factor.name());
                let reasons = names.zip(reasons).collect::<JsonObject>().done();
                as_json!({
                    "kind": "score", "reasons_ln": reasons,
                    "outside_training": outside.iter().map(|factor| factor.name()).collect::<Vec<_>>(),
                    "unlike_the_designs": unlike.iter().map(|one| one.to_string()).collect::<Vec<_>>(),
                })
            }
        };
        as_json!({
            "place": place.rank,
            "place_interval_90": [place.rank_interval.lower, place.rank_interval.upper],
            "name": entry.name,
            "severe_damage": entry.severe_damage.iter().map(severe).collect::<Vec<_>>(),
            "basis": basis,
            "states": states,
            "annual_rate": place.annual_rate,
            "probability_in_50_years": place.annual_rate.map(probability_in_years),
            "share_in_worst_tenth": place.worst_tenth,
            "place_by_falls": answer.by_falls.get(place.candidate).copied().flatten(),
        })
    });
    let left_out = answer.left_out.iter();
    as_json!({
        "source": answer.source,
        "state": SCORE_STATES[answer.state],
        "ranked_by": match answer.ranked.by { RankedBy::AnnualRate => "annual_rate", RankedBy::Capacity => "capacity" },
        "not_by_rate": not_by_rate(answer).map(|why| why.text(Language::English)),
        "designs": answer.designs,
        "draws": answer.draws,
        "structures": rows.collect::<Vec<_>>(),
        "columns_left_out": answer.columns_left_out,
        "left_out": left_out.map(|one| as_json!({ "name": one.name, "why": one.why.english })).collect::<Vec<_>>(),
    })
}
