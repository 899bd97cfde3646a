//! The ranking as columns, for CSV: one row per structure, unranked ones last, units in the names.

use super::answer::{LeftOut, PortfolioAnswer, PortfolioEntry};
use super::words::{basis_words, known_word, probability_in_years, reason_words};
use crate::score::SCORE_STATES;
use crate::study::{Column, ColumnValues};
use dolmen::assess::{KnownCapacity, Place};
use dolmen_words::Language;

/// All results, the worst structure first; structures without a rank stand below, with the reason and without numbers.
pub fn ranking_columns(answer: &PortfolioAnswer) -> Vec<Column> {
    let rows: Vec<(&Place, &PortfolioEntry)> =
        answer.rows().map(|(place, entry, _)| (place, entry)).collect();
    let below = &answer.left_out;
    let words =
        |name: &str, of: &dyn Fn(&PortfolioEntry) -> String, left_out: &dyn Fn(&LeftOut) -> String| {
            let ranked = rows.iter().map(|row| of(row.1));
            Column {
                name: name.to_owned(),
                values: ColumnValues::Words(ranked.chain(below.iter().map(left_out)).collect()),
            }
        };
    let numbers = |name: &str, of: &dyn Fn(&Place) -> Option<f64>| {
        let ranked = rows.iter().map(|row| of(row.0));
        Column {
            name: name.to_owned(),
            values: ColumnValues::Numbers(ranked.chain(below.iter().map(|_| None)).collect()),
        }
    };
    let nothing = |_: &LeftOut| String::new();
    let known = |name: String, state: usize, of: fn(&KnownCapacity) -> f64| Column {
        name,
        values: ColumnValues::Numbers(
            rows.iter()
                .map(|row| row.1.states[state].as_ref().map(of))
                .chain(below.iter().map(|_| None))
                .collect(),
        ),
    };
    let mut columns = vec![
        numbers("place", &|place| Some(place.rank as f64)),
        numbers("place_5_percent", &|place| Some(place.rank_interval.lower)),
        numbers("place_95_percent", &|place| Some(place.rank_interval.upper)),
        words("name", &|entry| entry.name.clone(), &|one| one.name.clone()),
        words("without_a_place_because", &|_| String::new(), &|one| {
            one.why.english.clone()
        }),
        words(
            "rests_on",
            &|entry| basis_words(entry, Language::English),
            &nothing,
        ),
        words(
            "what_lowers_it",
            &|entry| reason_words(entry, Language::English),
            &nothing,
        ),
    ];
    for (state, name) in SCORE_STATES.iter().enumerate() {
        columns.extend([
            known(format!("theta_{name}_m_s2"), state, |known| {
                known.fragility.theta()
            }),
            known(format!("beta_{name}"), state, |known| known.fragility.beta()),
            known(format!("ln_theta_sd_{name}"), state, |known| known.ln_theta_sd),
            known(format!("falls_by_itself_{name}"), state, |known| {
                known.falls_alone
            }),
            words(
                &format!("known_{name}"),
                &|entry| {
                    let known = entry.states[state].as_ref();
                    known.map_or(String::new(), |known| known_word(known.known).to_owned())
                },
                &nothing,
            ),
        ]);
    }
    columns.extend([
        numbers("annual_rate", &|place| place.annual_rate),
        numbers("probability_in_50_years", &|place| {
            place.annual_rate.map(probability_in_years)
        }),
        numbers("share_in_worst_tenth", &|place| Some(place.worst_tenth)),
        numbers("place_by_falls", &|place| {
            let falls = answer.by_falls.get(place.candidate).copied().flatten();
            falls.map(|rank| rank as f64)
        }),
        words("severe_damage_left_out", &damaged_words, &nothing),
    ]);
    columns
}

/// The severely damaged parts, each with its survey.
fn damaged_words(entry: &PortfolioEntry) -> String {
    let each = entry.severe_damage.iter();
    let each: Vec<String> = each.map(|one| format!("{} ({})", one.part, one.survey)).collect();
    each.join(", ")
}
