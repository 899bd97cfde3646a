//! Modes, changes and alarms of a history as tables.

use super::chance::chance;
use super::numbers::{HALF_95, hertz, percent, plain};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::monitoring::{AlarmKind, ChangeForm, WatchedMode};
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::watched::WatchAnswer;

messages! {
    /// Tables of a history.
    pub(crate) enum Listed in "watch.tables" {
        Modes { surveys: usize, average: Quantity } => {
            en: "Modes that were followed, of {surveys} surveys. The disturbance is what is left beside noise and weather; a lasting step of “seen from” halfway is found with 80 % probability. An alarm is confirmed by a moving average beyond {average} of its standard deviations, or by three of five surveys more than 3 standard deviations off their prediction.",
            ko: "조사 {surveys}회에서 추적한 모드. 잔차 표준편차는 측정 잡음과 기온 영향을 뺀 나머지이며, 검출 한계는 중간 시점의 급변이 80 %의 확률로 검출되는 크기이다. 이동평균이 그 표준편차의 {average}배를 넘거나 최근 5회 중 3회의 예측 오차가 표준편차의 ±3배를 넘으면 경보가 확정된다.",
        },
        Mode => { en: "Mode", ko: "모드" },
        NumberAccepted { number: usize, surveys: usize } => {
            en: "{number} (accepted in {surveys})",
            ko: "{number}(채택 {surveys}회)",
        },
        Number { number: usize } => { en: "{number}", ko: "{number}" },
        Frequency => { en: "frequency", ko: "고유진동수" },
        FoundIn => { en: "found in", ko: "확인된 조사" },
        PerC => { en: "per °C", ko: "1 °C당" },
        Disturbance => { en: "disturbance", ko: "잔차 표준편차" },
        Correlation => { en: "correlation", ko: "잔차 자기상관" },
        SeenFrom => { en: "seen from", ko: "검출 한계" },
        Outliers => { en: "alone", ko: "이상값 수" },
        NotJudged => { en: "not judged", ko: "판정 제외" },
        Changes => {
            en: "Lasting changes, beside works. The date lies between the two surveys with 95 % probability; p is that of so strong a change in any mode by chance.",
            ko: "보수 이외의 지속적인 변화. 시점은 95 % 확률로 두 조사 사이에 있으며, p는 우연만으로 어느 한 모드에서든 이만한 변화가 나타날 확률이다.",
        },
        Form => { en: "form", ko: "형태" },
        Step => { en: "step", ko: "급변" },
        Slope => { en: "drift", ko: "점진 변화" },
        After => { en: "after", ko: "시작(이후)" },
        Before => { en: "not after", ko: "끝(이전)" },
        Chance => { en: "p", ko: "p" },
        Change => { en: "change", ko: "변화" },
        Half => { en: "± 95 %", ko: "± 95 %" },
        Alarms => { en: "Confirmed alarms.", ko: "확정된 경보." },
        AlarmsMeaning => {
            en: "Values and limits in standard deviations of the mode.",
            ko: "값과 한계는 그 모드의 표준편차 단위이다.",
        },
        Confirmed => { en: "confirmed", ko: "확정" },
        Since => { en: "since", ko: "시작" },
        By => { en: "by", ko: "근거" },
        Average => { en: "moving average", ko: "이동평균" },
        ThreeOfFive => { en: "three of five", ko: "5회 중 3회" },
        Answered => { en: "inspected or mended since", ko: "이후 점검·보수" },
        Yes => { en: "yes", ko: "있음" },
        No => { en: "no", ko: "없음" },
        Value => { en: "value", ko: "값" },
        Limit => { en: "limit", ko: "한계" },
        Text { text: String } => { en: "{text}", ko: "{text}" },
    }
}

/// The nonempty tables.
pub(super) fn put(document: &mut Document<'_>, answer: &WatchAnswer) {
    for table in [modes(answer), changes(answer), alarms(answer)] {
        if !table.rows.is_empty() {
            document.put(Block::Table(table));
        }
    }
}

fn words(text: String) -> Cell {
    Cell::words(Listed::Text { text })
}

fn survey(answer: &WatchAnswer, survey: usize) -> Cell {
    words(
        answer
            .surveys
            .get(survey)
            .map_or_else(String::new, |survey| survey.name.clone()),
    )
}

fn modes(answer: &WatchAnswer) -> Table {
    let percents = |head: Listed| Column::numbers(head, Unit::percent());
    let counts = |head: Listed| Column::numbers(head, Unit::ratio());
    let caption = Listed::Modes {
        surveys: answer.surveys.len(),
        average: plain(answer.watched.average_limit, 2),
    };
    Table {
        caption: vec![caption.into()],
        columns: vec![
            Column::words(Listed::Mode),
            Column::numbers(Listed::Frequency, Unit::si("Hz")),
            counts(Listed::FoundIn),
            percents(Listed::PerC),
            percents(Listed::Disturbance),
            counts(Listed::Correlation),
            percents(Listed::SeenFrom),
            counts(Listed::Outliers),
            counts(Listed::NotJudged),
        ],
        rows: answer
            .watched
            .modes
            .iter()
            .enumerate()
            .map(|of| mode(answer, of))
            .collect(),
    }
}

fn mode(answer: &WatchAnswer, (i, mode): (usize, &WatchedMode)) -> Vec<Cell> {
    let (number, surveys) = (i + 1, answer.accepted_in(&mode.track));
    let weather = mode.weather.as_ref();
    let count = |count: usize| Cell::number(plain(count as f64, 0));
    let not_judged = mode.judged.judged.iter().filter(|judged| judged.score.is_err());
    vec![
        Cell::words(match surveys {
            0 => Listed::Number { number },
            _ => Listed::NumberAccepted { number, surveys },
        }),
        Cell::number(hertz(mode.track.frequency_hz)),
        count(mode.track.found() - surveys),
        Cell::Number(weather.and_then(|weather| Some(percent(weather.per_c?.0, 3)))),
        Cell::Number(weather.map(|weather| percent(weather.disturbance.sd, 2))),
        Cell::Number(weather.map(|weather| plain(weather.disturbance.correlation, 2))),
        Cell::Number(mode.seen_from_ratio.map(|least| percent(least, 2))),
        count(mode.outliers.len()),
        count(not_judged.count()),
    ]
}

fn changes(answer: &WatchAnswer) -> Table {
    let mut rows = Vec::new();
    for mode in &answer.watched.modes {
        for change in &mode.changes {
            rows.push(vec![
                words(frequency(mode)),
                Cell::words(match change.form {
                    ChangeForm::Step => Listed::Step,
                    ChangeForm::Slope => Listed::Slope,
                }),
                survey(answer, change.after),
                survey(answer, change.before),
                Cell::words(chance(change.p_value)),
                Cell::Bad(percent(change.ratio, 2)),
                Cell::number(percent(HALF_95 * change.sd, 2)),
            ]);
        }
    }
    Table {
        caption: vec![Listed::Changes.into()],
        columns: vec![
            Column::words(Listed::Mode),
            Column::words(Listed::Form),
            Column::words(Listed::After),
            Column::words(Listed::Before),
            Column::words(Listed::Chance),
            Column::numbers(Listed::Change, Unit::percent()),
            Column::numbers(Listed::Half, Unit::percent()),
        ],
        rows,
    }
}

fn frequency(mode: &WatchedMode) -> String {
    let quantity: Quantity = hertz(mode.track.frequency_hz);
    quantity.text()
}

fn alarms(answer: &WatchAnswer) -> Table {
    let rows = answer.watched.alarms.iter().map(|found| {
        let mode = answer
            .watched
            .modes
            .get(found.mode)
            .map_or_else(String::new, frequency);
        let answered: Sentence = match found.is_answered {
            true => Listed::Yes.into(),
            false => Listed::No.into(),
        };
        vec![
            words(mode),
            survey(answer, found.alarm.survey),
            survey(answer, found.alarm.since),
            Cell::words(match found.alarm.kind {
                AlarmKind::Average => Listed::Average,
                AlarmKind::ThreeOfFive => Listed::ThreeOfFive,
            }),
            match found.is_answered {
                true => Cell::words(answered),
                false => Cell::BadWords(answered),
            },
            Cell::number(plain(found.alarm.value, 2)),
            Cell::number(plain(found.alarm.limit, 2)),
        ]
    });
    Table {
        caption: vec![Listed::Alarms.into(), Listed::AlarmsMeaning.into()],
        columns: vec![
            Column::words(Listed::Mode),
            Column::words(Listed::Confirmed),
            Column::words(Listed::Since),
            Column::words(Listed::By),
            Column::words(Listed::Answered),
            Column::numbers(Listed::Value, Unit::ratio()),
            Column::numbers(Listed::Limit, Unit::ratio()),
        ],
        rows: rows.collect(),
    }
}
