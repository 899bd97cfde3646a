//! A ranked portfolio as text.

use super::Table;
use dolmen::assess::{KnownCapacity, Place, RankedBy};
use dolmen_words::Language::English;
use dolmen_words::number::{fixed, percent, significant};
use dolmen_work::portfolio::{
    PortfolioAnswer, PortfolioEntry, basis_words, capacity_words, count_words, falls_first, hazards_replaced,
    misjudged, probability_in_years, reason_words, state_words, without_hazard,
};
use std::fmt::Write as _;

/// Rows that are printed; all of them are in ranking.csv.
const ROWS_MOST: usize = 40;
/// Structures that falls alone would put far further back, that are named.
const MISJUDGED_SHOWN: usize = 10;
/// Structures without a place that are named.
const LEFT_OUT_SHOWN: usize = 20;

/// The order with its intervals, what it rests on, and what has no place.
pub fn rank_text(answer: &PortfolioAnswer) -> String {
    let has_rate = answer.ranked.by == RankedBy::AnnualRate;
    let by = if has_rate {
        "annual rate"
    } else {
        "peak of the ground that half of the motions need"
    };
    let state = state_words(answer.state, English);
    let count = answer.ranked.places.len();
    let below = match answer.left_out.is_empty() {
        true => "",
        false => "; those without a place stand below, and may be the worst",
    };
    let mut out = format!(
        "\n{} by the {by} of {state}, the worst first; 90 % of the places{below}\n",
        count_words(answer, English)
    );
    let theta = format!("{state}, g");
    let mut heads = vec![
        "name",
        "rests on",
        "what lowers it",
        "place",
        "90 %",
        theta.as_str(),
    ];
    if has_rate {
        heads.extend(["a year", "in 50 years"]);
    }
    heads.extend(["worst tenth", "by falls alone"]);
    let mut table = Table::new(&heads, 3);
    for (place, entry, capacity) in answer.rows().take(ROWS_MOST) {
        table.row(row(answer, place, entry, capacity));
    }
    out += &table.text();
    if count > ROWS_MOST {
        let _ = writeln!(out, "  and {} more, in ranking.csv (-o DIR)", count - ROWS_MOST);
    }
    out += "  worst tenth: in how many of the draws of what is not known it is among the worst tenth\n";
    if let Some(line) = without_hazard(answer, English) {
        let _ = writeln!(out, "  NOT BY RATE: {line}");
    }
    if let Some(line) = hazards_replaced(answer, English) {
        let _ = writeln!(out, "  {line}");
    }
    for (lines, others) in [
        (
            misjudged(answer, English),
            "that falls alone would put far further back",
        ),
        (
            falls_first(answer, English),
            "that fall far earlier than they are damaged",
        ),
    ] {
        for line in lines.iter().take(MISJUDGED_SHOWN) {
            let _ = writeln!(out, "  {line}");
        }
        if lines.len() > MISJUDGED_SHOWN {
            let more = lines.len() - MISJUDGED_SHOWN;
            let _ = writeln!(out, "  and {more} more {others}: place_by_falls in ranking.csv");
        }
    }
    if !answer.left_out.is_empty() {
        let _ = writeln!(
            out,
            "\nWithout a place, look at these yourself: {}",
            answer.left_out.len()
        );
        for one in answer.left_out.iter().take(LEFT_OUT_SHOWN) {
            let _ = writeln!(out, "  {}: {}", one.name, one.why);
        }
        if answer.left_out.len() > LEFT_OUT_SHOWN {
            let _ = writeln!(
                out,
                "  and {} more, in ranking.csv and ranking.json",
                answer.left_out.len() - LEFT_OUT_SHOWN
            );
        }
    }
    out
}

fn row(
    answer: &PortfolioAnswer,
    place: &Place,
    entry: &PortfolioEntry,
    capacity: &KnownCapacity,
) -> Vec<String> {
    let mut cells = vec![
        entry.name.clone(),
        basis_words(entry, English),
        reason_words(entry, English),
        place.rank.to_string(),
        format!(
            "{} – {}",
            fixed(place.rank_interval.lower, 0),
            fixed(place.rank_interval.upper, 0)
        ),
        capacity_words(capacity, answer.gravity_m_s2),
    ];
    if answer.ranked.by == RankedBy::AnnualRate {
        let rate = place.annual_rate.unwrap_or(f64::NAN);
        cells.push(significant(rate, 2));
        cells.push(percent(probability_in_years(rate), 2));
    }
    cells.push(percent(place.worst_tenth, 2));
    let falls = answer.by_falls.get(place.candidate).copied().flatten();
    cells.push(falls.map_or("–".to_owned(), |rank| rank.to_string()));
    cells
}
