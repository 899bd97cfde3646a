//! Fragility and risk of a study, as text.

use super::Table;
use dolmen::assess::AssessError;
use dolmen_project::HazardSource;
use dolmen_words::Language;
use dolmen_words::number::{percent, significant};
use dolmen_work::study::{CombinationFragility, JointFragility, StateFragility, StudyAnswer, YEARS};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Combinations that are printed; more are in fragility.csv.
const PRINTED_MOST: usize = 6;
/// Combinations whose joints are printed; more are in joints.csv.
const JOINTS_OF_MOST: usize = 2;
/// Confidence of intervals.
const CONFIDENCE: f64 = 0.95;
/// Share of a rate from beyond the points of the hazard that is said. Chosen here.
const BEYOND_SAID: f64 = 0.1;

/// The curves of a study, the first combinations of many; nothing without a scan.
///
/// # Errors
/// None for curves as they are fitted.
pub(super) fn fragility_text(answer: &StudyAnswer) -> Result<String, AssessError> {
    let found = answer.fragilities();
    let few = |one: &CombinationFragility| one.states.iter().all(|s| is_too_few(&s.by_acceleration));
    if found.is_empty() {
        return Ok(String::new());
    }
    if found.iter().all(few) {
        let motions = found.iter().flat_map(|one| &one.states).map(|state| {
            let different: BTreeSet<&usize> = state.motions.iter().collect();
            different.len()
        });
        let most = motions.max().unwrap_or(0);
        return Ok(format!(
            "\nNo fragility curves: usable scans of {most} motion{} a combination of inputs, 3 motions or more are needed\n",
            if most == 1 { "" } else { "s" }
        ));
    }
    let mut out = String::from(
        "\nFragility: lognormal in the peak of the ground; θ is reached by half of the scans, β is the scatter of ln; 95 % intervals\n",
    );
    out += &curves(answer, found)?;
    out += &scatter(answer, found)?;
    out += &notes(answer, found);
    out += &measures(answer, found);
    out += &joints(answer, found);
    Ok(out)
}

/// What β is made of, of the combinations that are printed.
fn scatter(answer: &StudyAnswer, found: &[CombinationFragility]) -> Result<String, AssessError> {
    let mut out = String::new();
    for one in found.iter().take(PRINTED_MOST) {
        for state in &one.states {
            let Some(split) = &state.scatter else { continue };
            let interval = split.of_inputs_interval(CONFIDENCE)?;
            let _ = writeln!(
                out,
                "  β of {}{}: {:.2} from motion to motion, {:.2} ({:.2} to {:.2}) from what is not known of the structure{}",
                answer.kind.states()[state.state],
                words_of(answer, one),
                split.of_motions,
                split.of_inputs,
                interval.lower,
                interval.upper,
                match split.without_curve {
                    0 => String::new(),
                    n => format!("; {n} of {} samples have no curve", n + split.samples),
                }
            );
        }
    }
    let is_open = |state: &StateFragility| state.scatter.is_none() && state.by_acceleration.is_ok();
    let mut shown = found.iter().take(PRINTED_MOST).flat_map(|one| &one.states);
    if answer.study.samples.is_some_and(|samples| samples > 1) && shown.any(is_open) {
        out += "  where β is not split: fewer than three samples have a curve of their own, or more than a tenth of them have none\n";
    }
    Ok(out)
}

/// The inputs of a combination in brackets; nothing if there is only one.
fn words_of(answer: &StudyAnswer, one: &CombinationFragility) -> String {
    match answer.combination_words(one.job) {
        words if words.is_empty() => words,
        words => format!(" ({words})"),
    }
}

/// β by each measure of the shaking.
fn measures(answer: &StudyAnswer, found: &[CombinationFragility]) -> String {
    let compared = answer.compare_measures();
    let measures = answer.measures();
    if compared.is_empty() {
        return String::new();
    }
    let names: Vec<String> = measures.iter().map(|measure| measure.words()).collect();
    let mut heads = vec!["state", "combinations", "PGA"];
    heads.extend(names.iter().map(String::as_str));
    let mut table = Table::new(&heads, 2);
    for row in compared {
        let shown = |beta: &Option<f64>| beta.map_or("–".to_owned(), |beta| format!("{beta:.2}"));
        let own = row.within.iter().map(shown);
        let state = answer.kind.states()[row.state].to_owned();
        let count = match (row.combinations, found.len()) {
            (1, 1) => "1".to_owned(),
            (n, all) => format!("each of {n} of {all}"),
        };
        table.row([state, count].into_iter().chain(own).collect());
        if found.len() > 1 {
            let own = row.together.iter().map(shown);
            let count = format!("all {} as one", found.len());
            table.row([String::new(), count].into_iter().chain(own).collect());
        }
    }
    format!(
        "\nMeasures of the shaking: scatter β of the capacity by each; the one with the least tells most;\n–: no curve, as where it is below the steps of the scan\n{}",
        table.text()
    )
}

/// Joints by what they need for each state, of the first combinations.
fn joints(answer: &StudyAnswer, found: &[CombinationFragility]) -> String {
    let shown = &found[..found.len().min(JOINTS_OF_MOST)];
    let is_shown = |joint: &&JointFragility| shown.iter().any(|one| one.combination == joint.combination);
    let joints: Vec<&JointFragility> = answer.joint_fragilities().iter().filter(is_shown).collect();
    if joints.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["case", "joint", "DS1, g", "DS2, g", "DS3, g", "gave way"], 2);
    let mut last = usize::MAX;
    for one in joints {
        let case = match one.combination == last {
            true => String::new(),
            false => answer.combination_words(one.job),
        };
        last = one.combination;
        let mut row = vec![case, one.name.clone()];
        let states = one.states.iter();
        row.extend(states.map(|state| state.median_words(answer)));
        row.push(one.gave_way.to_string());
        table.row(row);
    }
    let mut out = format!(
        "\nJoints: peak of the ground at which half of the scans bring each to a state; in how many it gave way at the first fall;\nfrom – to where a stone fell elsewhere first, or too little is known for a curve\n{}",
        table.text()
    );
    if found.len() > shown.len() {
        let _ = writeln!(
            out,
            "  and of {} more combinations: joints.csv",
            found.len() - shown.len()
        );
    }
    out
}

fn is_too_few<T>(fit: &Result<T, AssessError>) -> bool {
    matches!(fit, Err(AssessError::TooFewMotions { .. }))
}

fn curves(answer: &StudyAnswer, found: &[CombinationFragility]) -> Result<String, AssessError> {
    let has_risk = answer.hazard.is_some();
    let mut heads = vec![
        "case",
        "state",
        "reached",
        "θ, g",
        "95 %",
        "β",
        "95 %",
        "θ, m/s",
        "β of velocity",
        "enough",
    ];
    if has_risk {
        heads.extend(["a year", "in 50 years"]);
    }
    let mut table = Table::new(&heads, 2);
    let in_g = |value: f64| format!("{:.3}", value / answer.gravity_m_s2);
    for one in found.iter().take(PRINTED_MOST) {
        for (i, state) in one.states.iter().enumerate() {
            let label = if i == 0 {
                answer.combination_words(one.job)
            } else {
                String::new()
            };
            let mut cells = vec![
                label,
                answer.kind.states()[state.state].to_owned(),
                format!("{} of {}", state.reached(), state.observations.len()),
            ];
            match &state.by_acceleration {
                Ok(fit) => {
                    let (theta, beta) = (fit.theta_interval(CONFIDENCE)?, fit.beta_interval(CONFIDENCE)?);
                    cells.extend([
                        in_g(fit.curve.theta()),
                        format!("{} to {}", in_g(theta.lower), in_g(theta.upper)),
                        format!("{:.2}", fit.curve.beta()),
                        format!("{:.2} to {:.2}", beta.lower, beta.upper),
                    ]);
                }
                Err(why) => {
                    cells.push(answer.bound_words(why, Language::English));
                    cells.resize(7, "–".to_owned());
                }
            }
            match state.by_velocity() {
                Some(fit) => cells.extend([
                    significant(fit.curve.theta(), 3),
                    format!("{:.2}", fit.curve.beta()),
                ]),
                None => cells.extend(["–".to_owned(), "–".to_owned()]),
            }
            cells.push(state.motions_enough().map_or("–".to_owned(), |n| n.to_string()));
            if let Some(risk) = state.risk {
                let ends = state.rate_interval;
                let ends = ends.map_or(String::new(), |[least, most]| {
                    format!(" ({least:.0e} to {most:.0e})")
                });
                cells.extend([
                    format!("{:.1e}{ends}", risk.annual_rate),
                    percent(risk.probability_in(YEARS), 2),
                ]);
            }
            cells.resize(heads.len(), "–".to_owned());
            table.row(cells);
        }
    }
    let mut out = table.text();
    if found.len() > PRINTED_MOST {
        let _ = writeln!(out, "  and {} more: fragility.csv", found.len() - PRINTED_MOST);
    }
    out += "  \"enough\": motions by which θ is known to 10 % (one standard error); not said of fewer than 7, of which β is hardly known\n";
    if has_risk {
        out += "  a year, in brackets: at the ends of the intervals of θ and β\n";
    }
    Ok(out)
}

fn notes(answer: &StudyAnswer, found: &[CombinationFragility]) -> String {
    let mut out = String::new();
    let has_bound = |one: &CombinationFragility| {
        one.states
            .iter()
            .any(|state| matches!(state.by_acceleration, Err(AssessError::NoFragility(_))))
    };
    if found.iter().take(PRINTED_MOST).any(has_bound) {
        out += "  where none or all reached a state, or its scatter is below the steps: what is known with 95 % confidence, and no curve\n";
    }
    let states = answer.kind.states();
    for one in found.iter().take(PRINTED_MOST) {
        for (mild, severe, at, is_below) in one.crossings() {
            let _ = writeln!(
                out,
                "  WARNING: the curves of {} and {} cross at {:.3} g, where both have {:.2}: {} it the worse state is called likelier{}",
                states[mild],
                states[severe],
                at.intensity / answer.gravity_m_s2,
                at.probability,
                if is_below { "below" } else { "above" },
                words_of(answer, one)
            );
        }
    }
    if let Some(hazard) = &answer.hazard {
        let points = hazard.curve.points();
        let words = match hazard.source {
            HazardSource::Kds17 => "the return periods of KDS 17 10 00, 50 to 2400 years, soil included",
            HazardSource::File => {
                "the hazard of the file, its peaks taken as those at the surface (no soil factor is applied)"
            }
        };
        let ends =
            [points.first(), points.last()].map(|point| point.map_or(0.0, |p| p[0] / answer.gravity_m_s2));
        let _ = match hazard.curve.exponent() {
            Some(k) => writeln!(
                out,
                "  a year, in 50 years: by {words}, a power law with k = {}",
                significant(k, 3)
            ),
            None => writeln!(
                out,
                "  a year, in 50 years: by {words}, {:.3} to {:.3} g",
                ends[0], ends[1]
            ),
        };
        let beyond = (0..states.len()).filter_map(|state| {
            let of_state = found
                .iter()
                .flat_map(|one| &one.states)
                .filter(|own| own.state == state);
            let shares = of_state.filter_map(|own| own.risk);
            let shares = shares.map(|risk| risk.share_below_points + risk.share_above_points);
            let most = shares.fold(0.0, f64::max);
            (most > BEYOND_SAID).then(|| format!("{} of the rate of {}", percent(most, 2), states[state]))
        });
        let beyond: Vec<String> = beyond.collect();
        if !beyond.is_empty() {
            let _ = writeln!(
                out,
                "  EXTRAPOLATED: shaking beyond these peaks, where the slope of the ends goes on and nobody gave it, makes {}",
                beyond.join(", ")
            );
        }
    }
    out
}
