//! Findings on whether the columns of a frame move as one in its modes.

use crate::document::{Cell, Column, Document, Finding, Table, Tone};
use dolmen::structure::{ColumnOrdinate, ColumnsMove, ColumnsOfLevel};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::surveyed::SurveyAnswer;

messages! {
    /// Columns that move as one, or do not.
    pub(crate) enum Columns in "identification.columns" {
        Apart { survey: String, direction: String, frequency: Quantity, height: Quantity, column: Sentence } => {
            en: "Survey {survey}: the columns do not move as one. In the mode at {frequency} ({direction}), at {height}, {column}. Look at its foot, its tenons and its sensor: one stiffness for the whole storey takes all columns together.",
            ko: "{survey} 조사: 기둥들이 일체로 거동하지 않는다. {frequency} 모드({direction} 방향)에서 높이 {height}의 {column}. 그 기둥의 초석, 장부와 센서를 확인해야 한다. 층강성 하나로 나타내는 것은 모든 기둥이 함께 움직이는 것을 전제로 한다.",
        },
        ByItself { channel: String, times: Quantity, behind: Quantity } => {
            en: "{channel} moves by itself: {times} times as far as the others, its phase {behind} off",
            ko: "{channel}이(가) 따로 움직이며 진폭은 나머지의 {times}배, 위상차는 {behind}이다",
        },
        OneOf(channels: Vec<String>) => {
            en: "one of these moves by itself, and the sensors do not tell which: {channels}",
            ko: "다음 중 하나가 따로 움직이며 이 센서들로는 구별되지 않는다: {channels}",
        },
        Several(channels: Vec<String>) => {
            en: "several of these move each by itself: {channels}",
            ko: "다음 중 여럿이 따로 움직인다: {channels}",
        },
        Head => { en: "Do the columns move as one", ko: "기둥의 일체 거동" },
        Caption(survey: String) => {
            en: "Sensors side by side on one level, survey {survey}: amplitude over, and phase from, the mean of the others.",
            ko: "{survey} 조사에서 같은 높이에 나란히 놓인 센서의 나머지 평균에 대한 진폭비와 위상차.",
        },
        Meaning => {
            en: "Deviations hold 2 % for the calibration of each sensor. A level is called apart where chance would do that in less than one survey of a hundred.",
            ko: "표준편차에는 센서 교정 오차 2 %가 들어 있다. 우연히 그럴 가능성이 조사 100건 중 1건 미만일 때 일체가 아니라고 판정한다.",
        },
        Direction => { en: "Direction", ko: "방향" },
        Level => { en: "Level", ko: "높이" },
        Mode => { en: "Mode", ko: "모드" },
        Sensor => { en: "Sensor", ko: "센서" },
        Amplitude => { en: "amplitude", ko: "진폭비" },
        Phase => { en: "phase", ko: "위상차" },
        Moves => { en: "it moves", ko: "거동" },
        Plain(text: String) => { en: "{text}", ko: "{text}" },
        AsOne => { en: "moves as one", ko: "일체 거동" },
        Turning => { en: "sways and turns as a floor", ko: "바닥으로서 병진·비틀림" },
        TwoDiffer => { en: "two differ: turns, or one apart", ko: "두 점이 다름: 비틀림 또는 개별 거동" },
        IsApart => { en: "apart", ko: "따로 움직임" },
        MayBeApart => { en: "one of these apart", ko: "이들 중 하나가 따로 움직임" },
        WithTheRest => { en: "with the rest", ko: "나머지와 함께" },
        NotAsOne => { en: "not as one", ko: "일체 아님" },
    }
}

/// Columns that move differently: for each direction and level, the mode in which this is clearest.
pub(super) fn findings(survey: &SurveyAnswer) -> Vec<Finding> {
    let mut found: Vec<(&'static str, &ColumnsOfLevel)> = Vec::new();
    for (direction, level) in levels(survey) {
        let ColumnsMove::Apart { .. } = &level.moves else {
            continue;
        };
        match found
            .iter_mut()
            .find(|(known, of)| *known == direction && of.height_m == level.height_m)
        {
            Some((_, known)) if clearness(level) > clearness(known) => *known = level,
            Some(_) => {}
            None => found.push((direction, level)),
        }
    }
    let each = found.into_iter().map(|(direction, level)| {
        let said = Columns::Apart {
            survey: survey.name.clone(),
            direction: direction.to_owned(),
            frequency: Quantity::new(level.frequency_hz, Unit::si("Hz"), Digits::Fixed(3)),
            height: height(level),
            column: which(level).into(),
        };
        Finding::key(Tone::Warn, said).with_code("columns-apart")
    });
    each.collect()
}

/// Whether there is a result.
pub(super) fn is_seen(survey: &SurveyAnswer) -> bool {
    !survey.columns.is_empty()
}

/// The table of all levels and modes.
pub(super) fn section(document: &mut Document<'_>, survey: &SurveyAnswer) {
    if !is_seen(survey) {
        return;
    }
    document.subheading(Columns::Head);
    let row = |direction: &'static str, level: &ColumnsOfLevel, at: usize| {
        let column = &level.columns[at];
        let plain = |text: &str| Cell::words(Columns::Plain(text.to_owned()));
        vec![
            plain(direction),
            Cell::number(height(level)),
            Cell::number(Quantity::new(
                level.frequency_hz,
                Unit::si("Hz"),
                Digits::Fixed(3),
            )),
            plain(&column.channel),
            Cell::number(amplitude(column)),
            Cell::number(phase(column)),
            Cell::words(match &level.moves {
                ColumnsMove::AsOne => Columns::AsOne,
                ColumnsMove::Turning => Columns::Turning,
                ColumnsMove::TwoDiffer => Columns::TwoDiffer,
                ColumnsMove::Apart { any_of } => match (any_of.as_slice(), any_of.contains(&at)) {
                    ([], _) => Columns::NotAsOne,
                    ([_], true) => Columns::IsApart,
                    (_, true) => Columns::MayBeApart,
                    (_, false) => Columns::WithTheRest,
                },
            }),
        ]
    };
    let rows = levels(survey)
        .flat_map(|(direction, level)| (0..level.columns.len()).map(move |at| row(direction, level, at)));
    document.put(crate::document::Block::Table(Table {
        caption: vec![
            Columns::Caption(survey.name.clone()).into(),
            Columns::Meaning.into(),
        ],
        rows: rows.collect(),
        columns: vec![
            Column::words(Columns::Direction),
            Column::numbers(Columns::Level, Unit::si("m")),
            Column::numbers(Columns::Mode, Unit::si("Hz")),
            Column::words(Columns::Sensor),
            Column::numbers(Columns::Amplitude, Unit::ratio()),
            Column::numbers(Columns::Phase, Unit::si("°")),
            Column::words(Columns::Moves),
        ],
    }));
}

fn levels(survey: &SurveyAnswer) -> impl Iterator<Item = (&'static str, &ColumnsOfLevel)> {
    let each = survey.columns.iter();
    each.flat_map(|of| of.levels.iter().map(move |level| (of.direction, level)))
}

/// The largest difference from the others, in its standard deviations.
fn clearness(level: &ColumnsOfLevel) -> f64 {
    let each = level.columns.iter();
    each.map(|of| (of.of_others - 1.0).norm() / of.of_others_sd)
        .fold(0.0, f64::max)
}

fn which(level: &ColumnsOfLevel) -> Columns {
    let all = || level.columns.iter().map(|of| of.channel.clone()).collect();
    match &level.moves {
        ColumnsMove::Apart { any_of } => match any_of.as_slice() {
            [] => Columns::Several(all()),
            [one] => {
                let column = &level.columns[*one];
                Columns::ByItself {
                    channel: column.channel.clone(),
                    times: amplitude(column),
                    behind: phase(column),
                }
            }
            several => Columns::OneOf(
                several
                    .iter()
                    .map(|at| level.columns[*at].channel.clone())
                    .collect(),
            ),
        },
        _ => Columns::Several(all()),
    }
}

fn height(level: &ColumnsOfLevel) -> Quantity {
    Quantity::new(level.height_m, Unit::si("m"), Digits::Fixed(2))
}

fn amplitude(column: &ColumnOrdinate) -> Quantity {
    Quantity {
        sd_si: Some(column.of_others_sd),
        ..Quantity::new(column.of_others.norm(), Unit::ratio(), Digits::Significant(3))
    }
}

fn phase(column: &ColumnOrdinate) -> Quantity {
    let sd = (column.of_others_sd / column.of_others.norm()).min(std::f64::consts::PI);
    Quantity {
        sd_si: Some(sd.to_degrees()),
        ..Quantity::new(
            column.of_others.arg().to_degrees(),
            Unit::si("°"),
            Digits::Fixed(1),
        )
    }
}
