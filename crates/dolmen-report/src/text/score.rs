//! The six-factor score as text: of one pagoda, and what the score is worth.

use super::Table;
use dolmen::assess::{EffectVerdict, Factor, FactorEffect};
use dolmen_words::Language::English;
use dolmen_words::number::{fixed, percent, significant, trimmed};
use dolmen_work::portfolio::{factor_words, state_words};
use dolmen_work::score::{ScoreAnswer, ScoreQuality};
use std::fmt::Write as _;

fn shown(factor: Factor, value: f64) -> String {
    let value = if factor == Factor::Taper {
        value.to_degrees()
    } else {
        value
    };
    trimmed(value, 3)
}

/// The score of one pagoda: factors with what they add, capacities with intervals.
pub fn score_text(answer: &ScoreAnswer) -> String {
    let mut out = format!(
        "\nSix-factor score of {}: against {} simulated pagodas\n",
        answer.name.english(),
        answer.designs
    );
    let percents: Vec<String> = answer
        .states
        .iter()
        .map(|one| format!("{}, %", state_words(one.state, English)))
        .collect();
    let mut head = vec!["factor", "value", "trained"];
    head.extend(percents.iter().map(String::as_str));
    let mut table = Table::new(&head, 1);
    for (i, (factor, value)) in Factor::ALL.into_iter().zip(answer.factors.values()).enumerate() {
        let range = answer.trained[i];
        let mut row = vec![
            factor_words(factor, English).to_owned(),
            shown(factor, value),
            format!("{} – {}", shown(factor, range.lower), shown(factor, range.upper)),
        ];
        for one in &answer.states {
            row.push(format!("{:+.0}", 100.0 * (one.score.reasons[i].exp() - 1.0)));
        }
        table.row(row);
    }
    out += &table.text();
    out += "  %: by how much the factor raises or lowers the capacity against the mean of the simulated pagodas\n\n";
    let mut table = Table::new(
        &[
            "state",
            "half of the motions, g",
            "90 %",
            "percentile",
            "90 %",
            "of designs",
        ],
        1,
    );
    for one in &answer.states {
        let g = |value: f64| significant(value / answer.gravity_m_s2, 2);
        let score = &one.score;
        table.row(vec![
            state_words(one.state, English).to_owned(),
            g(score.capacity_m_s2),
            format!("{} – {}", g(one.interval_m_s2.lower), g(one.interval_m_s2.upper)),
            fixed(score.percentile, 0),
            format!(
                "{} – {}",
                fixed(score.percentile_interval.lower, 0),
                fixed(score.percentile_interval.upper, 0)
            ),
            one.designs.to_string(),
        ]);
    }
    out += &table.text();
    out += "  percentile: of the simulated pagodas with a curve for the state, those with a lower capacity, %. A score puts pagodas into order; it is no proof that one stands:\n  friction .6, whole \
            square stones, no damage, joints of K_n 1e9 Pa/m on springs: of one pagoda rigid joints needed 2.6 times the shaking for DS3 and 1.2 times\n  to \
            fall. Where it matters, simulate the pagoda as it is: dolmen study\n";
    for words in &answer.unlike {
        let _ = writeln!(
            out,
            "  EXTRAPOLATED: {words}; the numbers above are those of the designs"
        );
    }
    let outside = answer.states.first().map(|one| one.score.outside.as_slice());
    for one in outside.unwrap_or_default() {
        let _ = writeln!(
            out,
            "  EXTRAPOLATED: {} is {}, trained {} – {}",
            factor_words(one.factor, English),
            shown(one.factor, one.given),
            shown(one.factor, one.trained.lower),
            shown(one.factor, one.trained.upper)
        );
    }
    out
}

/// Weights of the factors, and how well the score orders designs that it has not seen.
pub fn score_quality_text(qualities: &[ScoreQuality], designs: usize) -> String {
    let mut out = format!(
        "\nWeights: Shapley shares of what {designs} simulated pagodas differ by in ln of their capacity, %; 90 % intervals\n"
    );
    let mut head = vec!["factor"];
    for one in qualities {
        head.extend([state_words(one.state, English), "90 %"]);
    }
    let mut table = Table::new(&head, 1);
    for (i, factor) in Factor::ALL.into_iter().enumerate() {
        let mut row = vec![factor_words(factor, English).to_owned()];
        for one in qualities {
            let share = &one.shares.shares[i];
            row.push(percent(share.share, 2));
            row.push(format!(
                "{} – {}",
                percent(share.interval.lower, 2),
                percent(share.interval.upper, 2)
            ));
        }
        table.row(row);
    }
    let mut row = vec!["all, of designs left out".to_owned()];
    for one in qualities {
        row.extend([percent(one.shares.explained, 2), String::new()]);
    }
    table.row(row);
    let mut row = vec!["designs with a curve".to_owned()];
    for one in qualities {
        row.extend([one.designs.to_string(), String::new()]);
    }
    table.row(row);
    out += &table.text();
    if let Some(one) = qualities.first() {
        let _ = writeln!(
            out,
            "  tan α and λ go together (correlation {}): their shares hold what they tell together, half each",
            fixed(one.slenderness_correlation, 2)
        );
        out += &effects_text(qualities);
        let _ = writeln!(
            out,
            "\nOrder of designs that were not seen, in {} parts: Kendall's τ, and share of the worst fifth found",
            one.held_out.parts
        );
    }
    let mut table = Table::new(&["state", "by", "τ", "worst fifth"], 2);
    for one in qualities {
        let held = &one.held_out;
        for (name, ranking) in [
            ("the score", held.score),
            ("equal weights", held.equal_weights),
            ("tan α alone", held.slenderness_angle),
        ] {
            table.row(vec![
                state_words(one.state, English).to_owned(),
                name.to_owned(),
                fixed(ranking.kendall_tau, 2),
                fixed(ranking.worst_fifth_found, 2),
            ]);
        }
    }
    out += &table.text();
    out
}

/// What each factor alone does to the capacity, beside the published direction.
fn effects_text(qualities: &[ScoreQuality]) -> String {
    let mut out = "\nOne factor alone, from its 10 % to its 90 % quantile in the middle design: change of the capacity, %, and the published direction\n"
        .to_owned();
    let mut head = vec!["factor", "from", "to"];
    head.extend(qualities.iter().map(|one| state_words(one.state, English)));
    let mut table = Table::new(&head, 1);
    let count = qualities.iter().map(|one| one.effects.len()).min().unwrap_or(0);
    for i in 0..count {
        let FactorEffect { factor, from, to, .. } = qualities[0].effects[i];
        let mut row = vec![
            factor_words(factor, English).to_owned(),
            shown(factor, from),
            shown(factor, to),
        ];
        for one in qualities {
            let effect = &one.effects[i];
            let verdict = match effect.verdict {
                EffectVerdict::Holds => "holds",
                EffectVerdict::Contradicted => "contradicted",
                EffectVerdict::NotSeen => "not seen",
            };
            row.push(format!("{} {verdict}", percent(effect.ln_change.exp_m1(), 2)));
        }
        table.row(row);
    }
    out += &table.text();
    out += "  λ takes tan α with it. Published for falls under one motion; contradicted: the other way with 90 % confidence, each\n  by itself: of twenty entries without effect two are called seen\n";
    out
}
