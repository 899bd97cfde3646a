//! The score of one pagoda.

use super::words::{Words, factor_cell, factor_name, factor_value, range_cell, state_cell, state_column};
use crate::brief_rows::BriefText;
use crate::document::{Block, Cell, Column, Document, Table, TextStyle, document_text, heading_text};
use crate::engineer::damage_words;
use dolmen::assess::Factor;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::portfolio::unlike_words;
use dolmen_work::score::{ScoreAnswer, StateScore};

messages! {
    /// The score of a pagoda.
    pub(crate) enum Pagoda in "score.pagoda" {
        Head { name: Both, designs: usize } => {
            en: "Six-factor score of {name}: against {designs} simulated pagodas",
            ko: "{name}: 여섯 인자로 시뮬레이션한 석탑 {designs}기와 비교",
        },
        Factors => {
            en: "Factors, and by how much each raises or lowers the capacity of a state against the mean of the simulated pagodas.",
            ko: "인자별 값과, 시뮬레이션한 석탑의 평균에 대하여 각 상태의 저항능력을 높이거나 낮추는 비율.",
        },
        Value => { en: "value", ko: "값" },
        Trained => { en: "trained", ko: "학습 범위" },
        Capacities => { en: "Capacity and order by state.", ko: "상태별 저항능력과 순위." },
        CapacityMeaning => {
            en: "The capacity is the peak of the ground at which half of the motions bring the pagoda to the state; the percentile is the share of the simulated pagodas with a curve for the state that have less.",
            ko: "저항능력은 지반운동의 절반이 석탑을 해당 상태에 이르게 하는 최대지반가속도이고, 백분위는 그 상태의 취약도 곡선이 있는 석탑 가운데 저항능력이 더 낮은 비율이다.",
        },
        Capacity => { en: "capacity", ko: "저항능력" },
        Percentile => { en: "percentile", ko: "백분위" },
        Designs => { en: "of designs", ko: "비교 대상 수" },
        NoProof => {
            en: "A score puts pagodas into order; it is no proof that one stands. Where it matters, simulate the pagoda as it is: `dolmen study`.",
            ko: "점수는 석탑의 우선순위를 정하는 데 쓸 뿐, 안전성을 보증하지 않는다. 중요한 석탑은 실제 조건으로 시뮬레이션한다: `dolmen study`.",
        },
        Conditions { friction: Quantity, stiffness: Quantity, damaged: Quantity, falls: Quantity } => {
            en: "It holds for friction {friction}, whole square stones without damage, and joints of K_n {stiffness} on springs: of one pagoda, rigid joints needed {damaged} times the shaking for DS3 and {falls} times to fall.",
            ko: "마찰계수 {friction}, 손상이 없고 통돌로 된 정사각형 평면의 석탑, 수직강성 K_n {stiffness}인 접합면을 전제한다. 한 석탑에서 강체 접합면은 DS3에 {damaged}배, 낙하·전도에 {falls}배의 지반운동이 필요하였다.",
        },
        Extrapolated(how: Sentence) => {
            en: "EXTRAPOLATED: {how}; the numbers are those of the designs.",
            ko: "학습 범위 밖: {how}. 위 값은 학습한 석탑의 조건에 대한 것이다.",
        },
        ExtrapolatedAll(how: Vec<Sentence>) => {
            en: "EXTRAPOLATED: {how}; the numbers are those of the designs.",
            ko: "학습 범위 밖: {how}. 아래 값은 학습한 석탑의 조건에 대한 것이다.",
        },
        SevereDamage { survey: String, found: Vec<Sentence> } => {
            en: "DAMAGE LEFT OUT: survey {survey} found severe damage: {found}. The numbers are those of the undamaged pagoda; look at this one first.",
            ko: "손상 미반영: {survey} 조사에서 심한 손상이 확인되었다: {found}. 아래 값은 손상이 없는 석탑의 것이므로 이 석탑을 먼저 점검해야 한다.",
        },
        Damaged { part: String, what: Sentence } => { en: "{what} of “{part}”", ko: "‘{part}’ {what}" },
        Unlike(words: Both) => { en: "{words}", ko: "{words}" },
        Outside { factor: Both, given: Quantity, lower: Quantity, upper: Quantity } => {
            en: "{factor} is {given}, trained {lower} – {upper}",
            ko: "{factor} {given}(학습 범위 {lower} – {upper})",
        },
    }
}

/// The score of one pagoda: factors with their contributions, capacities with intervals.
pub fn score_text(answer: &ScoreAnswer, style: TextStyle) -> String {
    let head = Pagoda::Head {
        name: Both {
            english: answer.name.english().to_owned(),
            korean: answer.name.korean().to_owned(),
        },
        designs: answer.designs,
    };
    let head = heading_text(&Sentence::from(head).text(style.language));
    match style.is_full {
        true => head + &document_text(&sections(answer), style),
        false => head + &brief(answer, style),
    }
}

fn sections(answer: &ScoreAnswer) -> Document<'static> {
    let mut document = Document::default();
    document
        .blocks
        .extend(severe_damage(answer).into_iter().map(Block::Warning));
    document.put(Block::Table(factors(answer)));
    document.put(Block::Table(capacities(answer)));
    document.note(Pagoda::NoProof);
    document.note(conditions());
    for how in extrapolated_sentences(answer) {
        document.put(Block::Warning(how));
    }
    document
}

/// Differences from the designs, the capacities, and as many factors as fit.
fn brief(answer: &ScoreAnswer, style: TextStyle) -> String {
    let mut brief = BriefText::new(style);
    for damage in severe_damage(answer) {
        brief.block(Block::Warning(damage));
    }
    let how = extrapolated(answer);
    if !how.is_empty() {
        brief.block(Block::Warning(Pagoda::ExtrapolatedAll(how).into()));
    }
    let capacities = capacities(answer);
    brief.table(&capacities, capacities.rows.len());
    brief.block(Block::Note(Pagoda::NoProof.into()));
    let factors = factors(answer);
    brief.table(&factors, 0);
    brief.finish()
}

/// Common properties of the built-in designs, and the effect of another joint law on one of them.
pub(super) fn conditions() -> Pagoda {
    let trimmed = |value| Quantity::new(value, Unit::ratio(), Digits::Trimmed(3));
    Pagoda::Conditions {
        friction: trimmed(0.6),
        stiffness: Quantity::engineering(1e9, "Pa/m", 1),
        damaged: trimmed(2.6),
        falls: trimmed(1.2),
    }
}

fn factors(answer: &ScoreAnswer) -> Table {
    let mut columns = vec![
        Column::words(Words::FactorHead),
        Column::numbers(Pagoda::Value, Unit::ratio()),
        Column::numbers(Pagoda::Trained, Unit::ratio()),
    ];
    let states = answer.states.iter();
    columns.extend(states.map(|one| state_column(one.state, Unit::percent())));
    let row = |(at, (factor, value)): (usize, (Factor, f64))| {
        let mut cells = vec![
            factor_cell(factor),
            Cell::number(factor_value(factor, value)),
            range_cell(&answer.trained[at], |end| factor_value(factor, end)),
        ];
        cells.extend(answer.states.iter().map(|one| {
            let share = one.score.reasons[at].exp_m1();
            Cell::number(Quantity::new(share, Unit::percent(), Digits::Fixed(0)))
        }));
        cells
    };
    let values = Factor::ALL.into_iter().zip(answer.factors.values());
    Table {
        caption: vec![Pagoda::Factors.into()],
        columns,
        rows: values.enumerate().map(row).collect(),
    }
}

fn capacities(answer: &ScoreAnswer) -> Table {
    let in_g = Unit {
        symbol: "g".to_owned(),
        factor: 1.0 / answer.gravity_m_s2,
    };
    let row = |one: &StateScore| {
        let capacity = |m_s2: f64| Quantity::new(m_s2, in_g.clone(), Digits::Significant(2));
        let bare = |m_s2: f64| Quantity::ratio(m_s2 / answer.gravity_m_s2, 2);
        let whole = |value: f64| Quantity::new(value, Unit::ratio(), Digits::Fixed(0));
        vec![
            state_cell(one.state),
            Cell::number(capacity(one.score.capacity_m_s2)),
            range_cell(&one.interval_m_s2, bare),
            Cell::number(whole(one.score.percentile)),
            range_cell(&one.score.percentile_interval, whole),
            Cell::number(whole(one.designs as f64)),
        ]
    };
    Table {
        caption: vec![Pagoda::Capacities.into(), Pagoda::CapacityMeaning.into()],
        columns: vec![
            Column::words(Words::StateHead),
            Column::numbers(Pagoda::Capacity, in_g.clone()),
            Column::numbers(Words::Ninety, Unit::ratio()),
            Column::numbers(Pagoda::Percentile, Unit::si("%")),
            Column::numbers(Words::Ninety, Unit::ratio()),
            Column::numbers(Pagoda::Designs, Unit::ratio()),
        ],
        rows: answer.states.iter().map(row).collect(),
    }
}

/// Severe damage that the score does not know, by survey.
pub(super) fn severe_damage(answer: &ScoreAnswer) -> Vec<Sentence> {
    let of_surveys = answer.severe_damage.chunk_by(|a, b| a.survey == b.survey);
    let each = of_surveys.filter_map(|of_survey| {
        let survey = of_survey.first()?.survey.clone();
        let found = of_survey.iter().map(|one| {
            let (part, what) = (one.part.clone(), damage_words(&one.what));
            Pagoda::Damaged { part, what }.into()
        });
        let found = found.collect();
        Some(Pagoda::SevereDamage { survey, found }.into())
    });
    each.collect()
}

/// The same as warnings.
pub(super) fn extrapolated_sentences(answer: &ScoreAnswer) -> Vec<Sentence> {
    let each = extrapolated(answer).into_iter();
    each.map(|how| Pagoda::Extrapolated(how).into()).collect()
}

/// Differences of the pagoda from the designs.
fn extrapolated(answer: &ScoreAnswer) -> Vec<Sentence> {
    let unlike = answer
        .unlike
        .iter()
        .map(|one| Pagoda::Unlike(Both::of(|language| unlike_words(one, language))));
    let outside = answer.states.first().map(|one| one.score.outside.as_slice());
    let outside = outside.unwrap_or_default().iter().map(|one| Pagoda::Outside {
        factor: factor_name(one.factor),
        given: factor_value(one.factor, one.given),
        lower: factor_value(one.factor, one.trained.lower),
        upper: factor_value(one.factor, one.trained.upper),
    });
    unlike.chain(outside).map(Sentence::from).collect()
}
