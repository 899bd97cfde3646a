//! Whether measures of shaking are sufficient, or capacities by them also depend on the earthquake.

use super::words::{Words, count, state};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::Sufficiency;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::study::{MeasureSufficiency, Predictor, StudyAnswer};
use dolmen_work::told_both;

messages! {
    /// Sufficiency.
    pub(crate) enum Sufficient in "study.sufficiency" {
        Caption => {
            en: "Sufficiency of each measure: what ln of the capacity by it changes over a unit of the earthquake's property, with the probability p that such a slope comes of chance.",
            ko: "지반운동 세기 척도의 충분성: 지진 특성 한 단위에 대한 내력(로그값)의 변화와, 그런 기울기가 우연히 나타날 확률 p.",
        },
        Meaning => {
            en: "A small p (below 0.05) speaks against the measure: capacities by it depend on the earthquake besides. A large one proves nothing: few motions hide a slope.",
            ko: "p가 작으면(0.05 미만) 그 척도에 의한 내력은 지진 특성에도 좌우되므로 충분하지 않다. p가 크더라도 충분함이 증명되지는 않는다. 지반운동이 적으면 기울기가 드러나지 않는다.",
        },
        DurationInstead => {
            en: "No motion of the file says its magnitude or «distance_km|distance»: the duration (5 to 95 % of the Arias intensity) stands in their place.",
            ko: "파일의 지반운동에 «magnitude나 distance_km|규모나 거리»가 없어 지속시간(Arias 강도의 5–95 %)을 대신 쓴다.",
        },
        Against => { en: "against", ko: "지진 특성" },
        Magnitude => { en: "magnitude", ko: "규모" },
        Distance => { en: "ln of the distance", ko: "거리(로그값)" },
        Duration => { en: "ln of the duration", ko: "지속시간(로그값)" },
        Motions => { en: "motions", ko: "입력지진" },
        Slope { slope: Quantity, chance: Sentence } => { en: "{slope} ({chance})", ko: "{slope}({chance})" },
        Chance(chance: Quantity) => { en: "p {chance}", ko: "p {chance}" },
        LittleChance(chance: Quantity) => { en: "p < {chance}", ko: "p < {chance}" },
        NotTold { state: Sentence, predictor: Sentence, why: Both } => {
            en: "{state} against {predictor}, not told: {why}.",
            ko: "{state}, {predictor}: 제시하지 않음. {why}.",
        },
    }
}

/// Smallest p printed as a number.
const CHANCE_LEAST: f64 = 0.001;

/// The table, and why a state is not in it.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let all = answer.sufficiencies();
    if all.is_empty() {
        return;
    }
    let rows: Vec<Vec<Cell>> = all.iter().filter_map(|own| row(answer, own)).collect();
    let duration = all.iter().any(|own| own.predictor == Predictor::Duration);
    if !rows.is_empty() {
        let names = answer.measures().into_iter().map(|measure| measure.words());
        let names = std::iter::once("PGA".to_owned()).chain(names);
        let mut columns = vec![
            Column::words(Words::State),
            Column::words(Sufficient::Against),
            Column::numbers(Sufficient::Motions, Unit::ratio()),
        ];
        columns.extend(names.map(|name| Column::numbers(Sentence::of_symbol(&name), Unit::ratio())));
        let mut caption = vec![Sufficient::Caption.into(), Sufficient::Meaning.into()];
        caption.extend(duration.then(|| Sufficient::DurationInstead.into()));
        document.put(Block::Table(Table {
            caption,
            columns,
            rows,
        }));
    }
    for own in &all {
        if let Err(why) = &own.by_measure {
            document.note(Sufficient::NotTold {
                state: state(answer, own.state),
                predictor: predictor(own.predictor).into(),
                why: told_both(why),
            });
        }
    }
}

fn row(answer: &StudyAnswer, own: &MeasureSufficiency) -> Option<Vec<Cell>> {
    let by_measure = own.by_measure.as_ref().ok()?;
    let motions = by_measure.first()?.motions;
    let mut cells = vec![
        Cell::words(state(answer, own.state)),
        Cell::words(predictor(own.predictor)),
        count(motions),
    ];
    cells.extend(by_measure.iter().map(|of| Cell::words(slope(of))));
    Some(cells)
}

fn slope(of: &Sufficiency) -> Sufficient {
    let number = |value, digits| Quantity::new(value, Unit::ratio(), Digits::Significant(digits));
    let chance = match of.p_value < CHANCE_LEAST {
        true => Sufficient::LittleChance(number(CHANCE_LEAST, 1)),
        false => Sufficient::Chance(number(of.p_value, 2)),
    };
    Sufficient::Slope {
        slope: number(of.slope, 2),
        chance: chance.into(),
    }
}

fn predictor(of: Predictor) -> Sufficient {
    match of {
        Predictor::Magnitude => Sufficient::Magnitude,
        Predictor::Distance => Sufficient::Distance,
        Predictor::Duration => Sufficient::Duration,
    }
}
