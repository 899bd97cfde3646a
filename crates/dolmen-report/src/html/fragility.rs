//! Fragility and risk of a study in the report.

use super::table::{Cell, table};
use dolmen_words::Language;
use dolmen_words::number::percent;
use dolmen_work::study::{CombinationFragility, JointFragility, StudyAnswer, YEARS};
use maud::{Markup, html};

/// Combinations in the table; all are in fragility.csv.
const SHOWN_MOST: usize = 8;

/// The table of curves and what it rests on; nothing without a curve.
pub(super) fn fragility(answer: &StudyAnswer, language: Language) -> Markup {
    let found = answer.fragilities();
    let has_curve = |one: &&CombinationFragility| one.states.iter().any(|s| s.by_acceleration.is_ok());
    let shown: Vec<&CombinationFragility> = found.iter().filter(has_curve).take(SHOWN_MOST).collect();
    let mut head = vec![
        language.pick("case", "경우").to_owned(),
        language.pick("state", "손상 상태").to_owned(),
        language.pick("reached", "도달").to_owned(),
        "θ (g)".to_owned(),
        "95 %".to_owned(),
        "β".to_owned(),
        "95 %".to_owned(),
        language.pick("β of velocity", "β (속도)").to_owned(),
    ];
    if answer.hazard.is_some() {
        head.push(language.pick("a year", "연간 발생률").to_owned());
        head.push(language.pick("beyond the hazard", "재해도 범위 밖").to_owned());
        head.push(language.pick("in 50 years", "50년 확률").to_owned());
    }
    let in_g = |value: f64| format!("{:.3}", value / answer.gravity_m_s2);
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    for one in &shown {
        for (i, state) in one.states.iter().enumerate() {
            let label = if i == 0 {
                answer.combination_words(one.job)
            } else {
                String::new()
            };
            let mut row = vec![
                Cell::wrapping(label),
                answer.state_words(language)[state.state].into(),
            ];
            match &state.by_acceleration {
                Ok(fit) => {
                    let interval = fit.theta_interval(0.95).ok();
                    row.push(
                        language
                            .pick(
                                format!("{} of {}", fit.reached, fit.observations),
                                format!("{}/{}", fit.reached, fit.observations),
                            )
                            .into(),
                    );
                    row.push(in_g(fit.curve.theta()).into());
                    row.push(
                        interval
                            .map_or(String::new(), |i| {
                                format!("{} – {}", in_g(i.lower), in_g(i.upper))
                            })
                            .into(),
                    );
                    row.push(format!("{:.2}", fit.curve.beta()).into());
                    let scatter = fit.beta_interval(0.95).ok();
                    row.push(
                        scatter
                            .map_or(String::new(), |i| beta_words(i.lower, i.upper))
                            .into(),
                    );
                    row.push(
                        state
                            .by_velocity()
                            .map_or("–".to_owned(), |fit| format!("{:.2}", fit.curve.beta()))
                            .into(),
                    );
                }
                Err(why) => {
                    row.push("–".into());
                    row.push(answer.bound_words(why, language).into());
                    row.extend(["–", "–", "–", "–"].map(Cell::from));
                }
            }
            if let Some(risk) = state.risk {
                let ends = state.rate_interval;
                let ends = ends.map_or(String::new(), |[least, most]| {
                    format!(" ({least:.0e} – {most:.0e})")
                });
                row.push(format!("{:.1e}{ends}", risk.annual_rate).into());
                let beyond = percent(risk.share_below_points + risk.share_above_points, 2);
                row.push(beyond.into());
                row.push(percent(risk.probability_in(YEARS), 2).into());
            }
            row.resize(head.len(), "–".into());
            rows.push(row);
        }
    }
    html! {
        @if !rows.is_empty() {
            (table(language.pick(
                "Fragility and risk. θ is the peak acceleration of the ground that half of the scans reach the state by, β the scatter of its logarithm, each with its 95 % interval; in brackets the annual rate at the ends of both; beyond the hazard: the share of a rate that comes from shaking for which no hazard was given.",
                "취약도와 위험도. θ는 해석의 절반이 해당 상태에 이르는 최대지반가속도, β는 대수 표준편차이며, 각각의 95 % 구간을 함께 제시한다. 괄호는 두 구간의 끝에서의 연간 발생률. 재해도 범위 밖: 주어진 재해도곡선 밖의 지진동에서 나온 발생률의 비율.",
            ), 2, &head, &rows))
            (measures(answer, found, language))
            (joints(answer, &shown, language))
            @for one in &shown {
                @for (mild, severe, at, is_below) in one.crossings() {
                    p { b { (crossing_words(answer, (mild, severe), (at.intensity, is_below), language)) } }
                }
            }
        }
    }
}

/// Beyond this a β says nothing: the state is reached within e^±10 of its median. Chosen here.
const BETA_SAID: f64 = 10.0;

fn beta_words(lower: f64, upper: f64) -> String {
    match upper > BETA_SAID {
        true => format!("{lower:.2} – > {BETA_SAID:.0}"),
        false => format!("{lower:.2} – {upper:.2}"),
    }
}

/// β by each measure of the shaking.
fn measures(answer: &StudyAnswer, found: &[CombinationFragility], language: Language) -> Markup {
    let mut head = vec![
        language.pick("state", "손상 상태").to_owned(),
        language.pick("combinations", "입력 조합").to_owned(),
        "PGA".to_owned(),
    ];
    head.extend(answer.measures().iter().map(|measure| measure.words()));
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    for own in answer.compare_measures() {
        let (n, all) = (own.combinations, found.len());
        let words = match all {
            1 => "1".to_owned(),
            _ => language.pick(format!("each of {n} of {all}"), format!("{all}개 중 {n}개 각각")),
        };
        let shown = |beta: &Option<f64>| Cell::from(beta.map_or("–".to_owned(), |beta| format!("{beta:.2}")));
        let mut row: Vec<Cell> = vec![answer.state_words(language)[own.state].into(), words.into()];
        row.extend(own.within.iter().map(shown));
        rows.push(row);
        if all > 1 {
            let words = language.pick(format!("all {all} as one"), format!("{all}개 전체"));
            let mut row: Vec<Cell> = vec!["".into(), words.into()];
            row.extend(own.together.iter().map(shown));
            rows.push(row);
        }
    }
    html! {
        @if !rows.is_empty() {
            (table(language.pick(
                "Scatter β of the capacity by each measure of the shaking: the one with the least tells most.",
                "지진동 세기 척도별 내력의 대수 표준편차 β. 작을수록 내력을 잘 설명한다.",
            ), 2, &head, &rows))
        }
    }
}

/// Joints by what they need for each state.
fn joints(answer: &StudyAnswer, shown: &[&CombinationFragility], language: Language) -> Markup {
    let first = shown.first();
    let is_shown = |joint: &&JointFragility| first.is_some_and(|one| one.combination == joint.combination);
    let joints = answer.joint_fragilities().iter().filter(is_shown);
    let head = [
        language.pick("joint", "접합면"),
        "DS1 (g)",
        "DS2 (g)",
        "DS3 (g)",
        language.pick("gave way", "낙하 시작"),
    ]
    .map(str::to_owned);
    let each = joints.map(|one| {
        let mut row: Vec<Cell> = vec![Cell::wrapping(one.name.clone())];
        let states = one.states.iter();
        row.extend(states.map(|state| Cell::from(state.median_words(answer))));
        row.push(one.gave_way.to_string().into());
        row
    });
    let rows: Vec<Vec<Cell>> = each.collect();
    let case = first.map_or(String::new(), |one| answer.combination_words(one.job));
    let case = if case.is_empty() {
        case
    } else {
        format!(" ({case})")
    };
    let caption = language.pick(
        format!(
            "Joints{case}: the peak acceleration of the ground at which half of the scans bring each to a state, and in how many it gave way at \
             the first fall."
        ),
        format!("접합면별{case}로 해석의 절반이 각 손상 상태에 이르는 최대지반가속도와, 최초 낙하가 시작된 해석의 수."),
    );
    html! {
        @if !rows.is_empty() { (table(&caption, 1, &head, &rows)) }
    }
}

fn crossing_words(
    answer: &StudyAnswer,
    (mild, severe): (usize, usize),
    (intensity, is_below): (f64, bool),
    language: Language,
) -> String {
    let side = match (is_below, language) {
        (true, Language::English) => "below",
        (false, Language::English) => "above",
        (true, _) => "아래",
        (false, _) => "위",
    };
    let (states, g) = (answer.state_words(language), intensity / answer.gravity_m_s2);
    language.pick(
        format!(
            "The curves of {} and {} cross at {g:.3} g: {side} it the worse state is called likelier than the milder one, which cannot be.",
            states[mild], states[severe]
        ),
        format!(
            "{}와 {}의 곡선이 {g:.3} g에서 교차한다. 그 {side}에서는 심한 상태의 확률이 더 크게 나타나므로 사용할 수 없다.",
            states[mild], states[severe]
        ),
    )
}
