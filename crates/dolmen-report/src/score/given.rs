//! The score of a pagoda with a measured frequency.

use super::words::{Words, range_cell, state_cell, state_name};
use crate::brief_rows::BriefText;
use crate::document::{Block, Cell, Column, Document, Table, TextStyle, document_text, heading_text};
use dolmen::numeric::Interval;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::score::{GIVEN_PEAKS_G, GivenAnswer, GivenState, MODEL_LN_SD};

messages! {
    /// The score with a measured frequency.
    pub(crate) enum Given in "score.given" {
        Head { name: Both, survey: String } => {
            en: "Six-factor score of {name}: given the frequency of survey {survey}",
            ko: "{name}: {survey} 조사의 고유진동수를 반영한 여섯 인자 점수",
        },
        Measured { measured: Quantity, direction: String, computed: Quantity } => {
            en: "Measured {measured} along {direction}; on the joints of the designs this pagoda has {computed}.",
            ko: "{direction} 방향 실측값은 {measured}이고, 학습 조건의 접합면에서 이 석탑의 값은 {computed}이다.",
        },
        Joints { median: Quantity, lower: Quantity, upper: Quantity } => {
            en: "So all its joints together are {median} times as stiff as those of the designs (90 %: {lower} to {upper}).",
            ko: "따라서 접합면 전체의 강성은 학습 조건의 {median}배이다(90 % 구간 {lower}~{upper}).",
        },
        State { state: Both, with: Sentence, without: Sentence, peak: Quantity } => {
            en: "A motion with a peak of {peak} brings it to {state} with a probability of {with}; with the stiffness unknown, {without}.",
            ko: "최대지반가속도 {peak}의 지반운동이 이 석탑을 {state}에 이르게 할 확률은 {with}이다. 강성을 모르면 {without}이다.",
        },
        Capacities => {
            en: "Capacity θ by state, the stiffness of the joints unknown and the frequency given.",
            ko: "상태별 저항능력 θ: 접합면 강성을 모를 때와 고유진동수를 반영한 때.",
        },
        Unknown => { en: "unknown", ko: "강성 미지" },
        Known => { en: "given", ko: "진동수 반영" },
        Probabilities => {
            en: "Probability that one motion with this peak of the ground brings the pagoda to the state, unknown → given.",
            ko: "이 최대지반가속도의 지반운동 하나가 석탑을 해당 상태에 이르게 할 확률: 강성 미지 → 진동수 반영.",
        },
        At(peak: Quantity) => { en: "{peak}", ko: "{peak}" },
        Percent(value: Quantity) => { en: "{value}", ko: "{value}" },
        Below(bound: Quantity) => { en: "< {bound}", ko: "< {bound}" },
        Above(bound: Quantity) => { en: "> {bound}", ko: "> {bound}" },
        Change { without: Sentence, with: Sentence } => { en: "{without} → {with}", ko: "{without} → {with}" },
        Prior { lower: Quantity, upper: Quantity, draws: usize, effective: Quantity, model: Quantity } => {
            en: "Unknown: any stiffness from {lower} to {upper} times that of the designs, its logarithm evenly. Of {draws} draws, {effective} count after the frequency, which the model may miss by {model} beside the error of the measurement. One frequency cannot tell which joint is soft, nor joints from soft ground: all joints are taken to differ by the same factor.",
            ko: "강성 미지: 학습 조건의 {lower}~{upper}배에서 로그 균등 분포. 표본 {draws}개 가운데 진동수 반영 후 유효 개수는 {effective}이다. 계측 오차 외에 모델의 진동수 오차 {model}을(를) 더하였다. 진동수 하나로는 어느 접합면이 무른지, 무른 것이 접합면인지 지반인지 알 수 없으므로 모든 접합면이 같은 비율로 다르다고 본다.",
        },
    }
}

/// Index in [`GIVEN_PEAKS_G`] of the peak in the first lines: 0.2 g.
const TOLD: usize = 1;
/// Probabilities below this, and above 1 minus this, are given as bounds. Our choice.
const FINEST: f64 = 0.01;
/// Index of the state in the first lines: DS3.
const TOLD_STATE: usize = 2;

/// The score of one pagoda with a measured frequency.
pub fn score_given_text(answer: &GivenAnswer, style: TextStyle) -> String {
    let name = &answer.score.name;
    let head = Given::Head {
        name: Both {
            english: name.english().to_owned(),
            korean: name.korean().to_owned(),
        },
        survey: answer.frequency.survey.clone(),
    };
    let head = heading_text(&Sentence::from(head).text(style.language));
    let mut warnings = super::pagoda::severe_damage(&answer.score);
    warnings.extend(super::pagoda::extrapolated_sentences(&answer.score));
    let said = said(answer);
    let tables = [capacities(answer), probabilities(answer)];
    if style.is_full {
        let mut document = Document::default();
        for warning in warnings {
            document.put(Block::Warning(warning));
        }
        document.put(Block::Paragraph(said));
        for table in tables {
            document.put(Block::Table(table));
        }
        document.note(prior(answer));
        return head + &document_text(&document, style);
    }
    let mut brief = BriefText::new(style);
    for warning in warnings {
        brief.block(Block::Warning(warning));
    }
    brief.block(Block::Paragraph(said));
    for table in tables {
        brief.table(&table, table.rows.len());
    }
    head + &brief.finish()
}

fn said(answer: &GivenAnswer) -> Vec<Sentence> {
    let hertz = |value| Quantity::new(value, Unit::si("Hz"), Digits::Significant(3));
    let of = &answer.frequency;
    let [median, lower, upper] = answer.stiffness_ratio.map(|ratio| Quantity::ratio(ratio, 2));
    let mut said: Vec<Sentence> = vec![
        Given::Measured {
            measured: hertz(of.measured_hz),
            direction: of.direction.clone(),
            computed: hertz(of.computed_hz),
        }
        .into(),
        Given::Joints { median, lower, upper }.into(),
    ];
    let told = answer.states.iter().find(|one| one.state == TOLD_STATE);
    said.extend(told.map(|one| {
        Sentence::from(Given::State {
            state: state_name(one.state),
            with: chance(one.probability_given[TOLD]),
            without: chance(one.probability_unknown[TOLD]),
            peak: peak(GIVEN_PEAKS_G[TOLD]),
        })
    }));
    said
}

fn peak(of_g: f64) -> Quantity {
    let unit = Unit {
        symbol: "g".to_owned(),
        factor: 1.0,
    };
    Quantity::new(of_g, unit, Digits::Fixed(1))
}

fn percent(share: f64, digits: Digits) -> Quantity {
    Quantity::new(share, Unit::percent(), digits)
}

/// A probability in whole per cent: finer values were not tested.
fn chance(probability: f64) -> Sentence {
    let whole = |share| percent(share, Digits::Fixed(0));
    let said = match probability {
        p if p < FINEST => Given::Below(whole(FINEST)),
        p if p > 1.0 - FINEST => Given::Above(whole(1.0 - FINEST)),
        p => Given::Percent(whole(p)),
    };
    said.into()
}

fn capacities(answer: &GivenAnswer) -> Table {
    let in_g = Unit {
        symbol: "g".to_owned(),
        factor: 1.0 / answer.score.gravity_m_s2,
    };
    let bare = |m_s2: f64| Quantity::ratio(m_s2 / answer.score.gravity_m_s2, 2);
    let cells = |[median, lower, upper]: [f64; 3]| {
        let median = Quantity::new(median, in_g.clone(), Digits::Significant(2));
        [Cell::number(median), range_cell(&Interval { lower, upper }, bare)]
    };
    let row = |one: &GivenState| {
        let mut row = vec![state_cell(one.state)];
        row.extend(cells(one.unknown_m_s2));
        row.extend(cells(one.given_m_s2));
        row
    };
    Table {
        caption: vec![Given::Capacities.into()],
        columns: vec![
            Column::words(Words::StateHead),
            Column::numbers(Given::Unknown, in_g.clone()),
            Column::numbers(Words::Ninety, Unit::ratio()),
            Column::numbers(Given::Known, in_g.clone()),
            Column::numbers(Words::Ninety, Unit::ratio()),
        ],
        rows: answer.states.iter().map(row).collect(),
    }
}

fn probabilities(answer: &GivenAnswer) -> Table {
    let mut columns = vec![Column::words(Words::StateHead)];
    columns.extend(GIVEN_PEAKS_G.map(|of_g| Column::words(Given::At(peak(of_g)))));
    let row = |one: &GivenState| {
        let mut row = vec![state_cell(one.state)];
        let pairs = one.probability_unknown.iter().zip(&one.probability_given);
        row.extend(pairs.map(|(without, with)| {
            Cell::words(Given::Change {
                without: chance(*without),
                with: chance(*with),
            })
        }));
        row
    };
    Table {
        caption: vec![Given::Probabilities.into()],
        columns,
        rows: answer.states.iter().map(row).collect(),
    }
}

fn prior(answer: &GivenAnswer) -> Given {
    Given::Prior {
        lower: Quantity::ratio(answer.prior_ratio.lower, 2),
        upper: Quantity::ratio(answer.prior_ratio.upper, 2),
        draws: answer.draws,
        effective: Quantity::new(answer.effective_draws, Unit::ratio(), Digits::Fixed(0)),
        model: percent(MODEL_LN_SD, Digits::Fixed(0)),
    }
}
