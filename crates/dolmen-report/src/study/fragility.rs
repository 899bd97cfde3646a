//! Fragility curves of a study, and the rates at which states are reached.

use super::hazard;
use super::words::{CONFIDENCE, Words, both, count, fixed, g, of_all, of_case, state, unit_g};
use super::{joints, measures, scatter, sufficiency};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::{AssessError, FragilityFit};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::study::{CombinationFragility, StateFragility, StudyAnswer};
use std::collections::BTreeSet;

/// Number of combinations in the tables; fragility.csv has all.
const SHOWN_MOST: usize = 8;
/// A larger β is not reported: the state is reached within e^±10 of its median. Our choice.
const BETA_SAID: f64 = 10.0;

messages! {
    /// Fragility.
    pub(crate) enum Curves in "study.fragility" {
        Head => { en: "Fragility", ko: "취약도" },
        TooFew(motions: Sentence) => {
            en: "No fragility curves: usable scans of {motions} a combination of inputs, 3 motions or more are needed.",
            ko: "취약도 곡선을 구할 수 없다. 입력 조합당 사용할 수 있는 증분해석이 {motions}뿐이며, 입력지진 3개 이상이 필요하다.",
        },
        Caption => { en: "Fragility curves, lognormal in the peak acceleration of the ground.", ko: "최대지반가속도의 대수정규분포로 나타낸 취약도." },
        CaptionWithRisk => { en: "Fragility and risk, lognormal in the peak acceleration of the ground.", ko: "최대지반가속도의 대수정규분포로 나타낸 취약도와 위험도." },
        Meaning => {
            en: "θ is the peak acceleration of the ground that half of the scans reach the state by (θ_v: their peak velocity), β the scatter of its logarithm, each with its 95 % interval; enough: motions by which θ is known to 10 % (one standard error), not said of fewer than 7, of which β is hardly known, nor where so few samples of the structure were drawn that no number of motions is enough. With samples of uncertain inputs the intervals hold the choice of samples too, where β can be split.",
            ko: "θ는 증분해석의 절반이 해당 상태에 이르는 최대지반가속도(θ_v는 최대지반속도), β는 대수 표준편차이며 각각의 95 % 신뢰구간을 함께 제시한다. 충분한 수: θ의 표준오차가 10 %가 되는 입력지진의 수이며, β를 거의 알 수 없는 7개 미만이거나 구조물의 표본이 너무 적어 입력지진을 늘려도 부족하면 제시하지 않는다. 불확실한 입력값을 추출한 경우 β를 나눌 수 있으면 신뢰구간에 표본의 선택도 포함한다.",
        },
        RiskMeaning => {
            en: "In brackets the annual rate at the ends of both intervals, open where more than half of it would come from shaking weaker than any of the hazard, or where it would exceed one a year; beyond the hazard: the share of a rate that comes from shaking for which no hazard was given.",
            ko: "괄호는 두 신뢰구간의 끝에서의 연간 초과율이며, 절반 넘게 재해도보다 약한 지반운동에서 나오거나 연 1회를 넘으면 상한을 제시하지 않는다. 재해도 범위 밖: 재해도가 주어지지 않은 지반운동에서 나온 초과율의 비율.",
        },
        Reached => { en: "reached", ko: "도달" },
        Theta => { en: "θ", ko: "θ" },
        Interval => { en: "95 %", ko: "95 %" },
        Beta => { en: "β", ko: "β" },
        BetaVelocity => { en: "β of velocity", ko: "β (속도)" },
        Enough => { en: "enough", ko: "충분한 수" },
        Rate => { en: "rate a year", ko: "연간 초과율" },
        Beyond => { en: "beyond the hazard", ko: "재해도 범위 밖" },
        InYears => { en: "in 50 years", ko: "50년 확률" },
        RateBetween { rate: Quantity, least: Quantity, most: Quantity } => {
            en: "{rate} ({least} – {most})",
            ko: "{rate} ({least} – {most})",
        },
        RateFrom { rate: Quantity, least: Quantity } => { en: "{rate} (from {least} on)", ko: "{rate} ({least} 이상)" },
        More(more: usize) => { en: "And {more} more: fragility.csv.", ko: "그 밖의 {more}개 조합은 fragility.csv에 있다." },
        TwoMedians => {
            en: "θ is the median of the fitted curve. The median among the capacities is that of the scans themselves, to a step of the scan: the two differ where capacities are not lognormal, and where fewer than half of the scans reached the state.",
            ko: "θ는 적합한 곡선의 중앙값이다. 한계 지반운동 표의 중앙값은 증분해석 결과 자체의 중앙값으로 증분 간격까지 구하였다. 한계 지반운동이 대수정규분포를 따르지 않거나 도달한 증분해석이 절반 미만이면 둘은 다르다.",
        },
        Records { motions: usize, records: usize } => {
            en: "The {motions} motions are of {records} records: directions and copies of one record count as one motion, in curves, intervals and bands.",
            ko: "입력지진 {motions}개는 기록 {records}개에서 나왔다. 한 기록의 여러 방향과 사본은 곡선, 신뢰구간, 띠에서 입력지진 하나로 센다.",
        },
        OfStanding => {
            en: "Where some fall under their own weight, “reached” counts them; p₀, their share, is the probability without shaking, and θ, β, their intervals and rates are of the scans that stand: P(a) = p₀ + (1 − p₀) Φ(ln(a/θ)/β). The probability in 50 years is of all. No NRML file is written of such a study: its curves begin at 0.",
            ko: "자중으로 붕괴하는 표본이 있으면 ‘도달’에 포함한다. 그 비율 p₀가 지진이 없을 때의 확률이며, θ와 β, 신뢰구간, 연간 초과율은 서 있는 표본의 값이다. P(a) = p₀ + (1 − p₀) Φ(ln(a/θ)/β). 50년 확률은 전체의 값이다. NRML 곡선은 0에서 시작하므로 이러한 연구의 NRML 파일은 쓰지 않는다.",
        },
        OfThoseWithin => {
            en: "Where some lean beyond the allowed drift without any shaking, “reached” counts them for it, and so does p₀; its θ, β, intervals and rate are of the scans that are within it at rest: P(a) = p₀ + (1 − p₀) Φ(ln(a/θ)/β). Its probability in 50 years is of all.",
            ko: "지진 없이 이미 허용 층간변위를 넘게 기울어진 표본이 있으면 그 상태의 ‘도달’과 p₀에 포함한다. 이 상태의 θ와 β, 신뢰구간, 연간 초과율은 정지 상태에서 허용값 이내인 표본의 값이다. P(a) = p₀ + (1 − p₀) Φ(ln(a/θ)/β). 50년 확률은 전체의 값이다.",
        },
        ShareAlone => { en: "p₀", ko: "p₀" },
        Bounds => {
            en: "Where none or all reached a state, or its scatter is below the steps of the scan: what is known with 95 % confidence, and no curve.",
            ko: "도달한 경우가 없거나 모두 도달하였을 때, 또는 산포가 증분 간격보다 작을 때에는 95 % 신뢰수준에서 알 수 있는 범위만 제시하고 곡선은 제시하지 않는다.",
        },
    }
}

/// Curves with their basis; the reason if too few motions were run.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let found = answer.fragilities();
    if found.is_empty() {
        return;
    }
    document.subheading(Curves::Head);
    if found.iter().flat_map(|one| &one.states).all(is_too_few) {
        document.paragraph(Curves::TooFew(motions(found)));
        return;
    }
    let shown = &found[..found.len().min(SHOWN_MOST)];
    document.put(Block::Table(table(answer, shown)));
    if found.len() > shown.len() {
        let more = found.len() - shown.len();
        document.note(Curves::More(more));
    }
    if let Some(records) = records(answer) {
        document.note(records);
    }
    if shown
        .iter()
        .flat_map(|one| &one.states)
        .any(|own| own.by_acceleration.is_ok())
    {
        document.note(Curves::TwoMedians);
    }
    if shown.iter().flat_map(|one| &one.states).any(is_bounded) {
        document.note(Curves::Bounds);
    }
    if has_any(shown, |own| own.fell_alone) {
        document.note(Curves::OfStanding);
    }
    if has_any(shown, |own| own.leans_beyond) {
        document.note(Curves::OfThoseWithin);
    }
    scatter::section(document, answer, shown);
    hazard::section(document, answer);
    measures::section(document, answer);
    sufficiency::section(document, answer);
    joints::section(document, answer);
}

/// Number of records behind the motions, if fewer.
fn records(answer: &StudyAnswer) -> Option<Curves> {
    let different: BTreeSet<&usize> = answer.records.iter().collect();
    let (motions, records) = (answer.motions.len(), different.len());
    (records < motions).then_some(Curves::Records { motions, records })
}

fn is_too_few(state: &StateFragility) -> bool {
    matches!(state.by_acceleration, Err(AssessError::TooFewMotions { .. }))
}

fn is_bounded(state: &StateFragility) -> bool {
    matches!(state.by_acceleration, Err(AssessError::NoFragility(_)))
}

/// The largest number of motions behind one state of a combination.
fn motions(found: &[CombinationFragility]) -> Sentence {
    let each = found.iter().flat_map(|one| &one.states).map(|state| {
        let different: BTreeSet<&usize> = state.motions.iter().collect();
        different.len()
    });
    match each.max().unwrap_or(0) {
        1 => Words::OneMotion.into(),
        count => Words::Motions { count }.into(),
    }
}

/// Whether a number of scans is above 0 in some state.
fn has_any(shown: &[CombinationFragility], count: fn(&StateFragility) -> usize) -> bool {
    let mut states = shown.iter().flat_map(|one| &one.states);
    states.any(|own| count(own) > 0)
}

fn table(answer: &StudyAnswer, shown: &[CombinationFragility]) -> Table {
    let (has_risk, has_alone) = (
        answer.hazard.is_some(),
        has_any(shown, StateFragility::without_shaking),
    );
    let in_g = unit_g(answer);
    let plain = |head: Curves| Column::numbers(head, Unit::ratio());
    let mut columns = vec![
        Column::words(Words::State),
        plain(Curves::Reached),
        Column::numbers(Curves::Theta, in_g.clone()),
        Column::numbers(Curves::Interval, in_g),
        plain(Curves::Beta),
        plain(Curves::Interval),
        Column::numbers(Sentence::of_symbol("θ_v"), Unit::si("m/s")),
        plain(Curves::BetaVelocity),
        plain(Curves::Enough),
    ];
    if has_alone {
        columns.insert(2, Column::numbers(Curves::ShareAlone, Unit::percent()));
    }
    let mut caption = vec![Curves::Caption.into(), Curves::Meaning.into()];
    if has_risk {
        columns.push(Column::numbers(Curves::Rate, thousandths()));
        let percent = |head: Curves| Column::numbers(head, Unit::percent());
        columns.extend([percent(Curves::Beyond), percent(Curves::InYears)]);
        caption[0] = Curves::CaptionWithRisk.into();
        caption.push(Curves::RiskMeaning.into());
    }
    let mut rows = Vec::new();
    for one in shown {
        for own in &one.states {
            let state = of_case(answer, state(answer, own.state), one.job);
            let mut row = vec![Cell::words(state)];
            row.extend(curve(answer, own));
            if has_alone {
                row.insert(2, Cell::number(Quantity::percent(own.share_alone(), 2)));
            }
            row.extend(risk(own).into_iter().filter(|_| has_risk));
            rows.push(row);
        }
    }
    Table {
        caption,
        columns,
        rows,
    }
}

/// The columns from "reached" to "enough".
fn curve(answer: &StudyAnswer, own: &StateFragility) -> Vec<Cell> {
    let mut cells = vec![of_all(own.reached(), own.scans())];
    match &own.by_acceleration {
        Ok(fit) => cells.extend(fitted(answer, fit)),
        Err(why) => {
            cells.push(Cell::words(both(|language| answer.bound_words(why, language))));
            cells.extend([Cell::Number(None), Cell::Number(None), Cell::Number(None)]);
        }
    }
    let velocity = own.by_velocity();
    let median =
        velocity.map(|fit| Quantity::new(fit.curve.theta(), Unit::si("m/s"), Digits::Significant(3)));
    cells.push(Cell::Number(median));
    cells.push(Cell::Number(velocity.map(|fit| fixed(fit.curve.beta(), 2))));
    cells.push(own.motions_enough().map_or(Cell::Number(None), count));
    cells
}

fn fitted(answer: &StudyAnswer, fit: &FragilityFit) -> [Cell; 4] {
    let theta = fit
        .theta_interval(CONFIDENCE)
        .ok()
        .map(|interval| Words::Interval {
            lower: bare(g(answer, interval.lower)),
            upper: bare(g(answer, interval.upper)),
        });
    let beta = fit.beta_interval(CONFIDENCE).ok().map(|interval| {
        let lower = fixed(interval.lower, 2);
        match interval.upper > BETA_SAID {
            true => Words::OpenInterval {
                lower,
                upper: fixed(BETA_SAID, 0),
            },
            false => Words::Interval {
                lower,
                upper: fixed(interval.upper, 2),
            },
        }
    });
    let interval = |words: Option<Words>| words.map_or(Cell::Number(None), Cell::words);
    [
        Cell::number(g(answer, fit.curve.theta())),
        interval(theta),
        Cell::number(fixed(fit.curve.beta(), 2)),
        interval(beta),
    ]
}

/// Unit of annual rates, which are small.
fn thousandths() -> Unit {
    Unit {
        symbol: "10⁻³".to_owned(),
        factor: 1e3,
    }
}

/// A quantity without its unit, which is in the column name.
fn bare(mut quantity: Quantity) -> Quantity {
    quantity.unit.symbol.clear();
    quantity
}

/// The annual rate, its part from beyond the hazard, and the probability in 50 years.
fn risk(own: &StateFragility) -> [Cell; 3] {
    let Some(risk) = own.risk else {
        return [Cell::Number(None), Cell::Number(None), Cell::Number(None)];
    };
    let rated = |rate: f64, digits| Quantity::new(rate, thousandths(), Digits::Significant(digits));
    let rate = rated(risk.annual_rate, 2);
    let end = |value: f64| bare(rated(value, 2));
    let rate = match own.rate_interval {
        None => Cell::number(rate),
        Some([least, most]) if most.is_finite() => Cell::words(Curves::RateBetween {
            rate: bare(rate),
            least: end(least),
            most: end(most),
        }),
        Some([least, _]) => Cell::words(Curves::RateFrom {
            rate: bare(rate),
            least: end(least),
        }),
    };
    let beyond = Quantity::percent(risk.share_below_points + risk.share_above_points, 2);
    let in_years = own.probability_in_years();
    [
        rate,
        Cell::number(beyond),
        Cell::Number(in_years.map(|share| Quantity::percent(share, 2))),
    ]
}
