//! Measured modes compared with those of the model, by their shapes at the sensors.

use super::values::{fixed, percent};
use crate::document::{Block, Cell, Column, Document, Figure, Series, Table};
use crate::figures::model_likeness;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::model_modes::{
    BesideModel, FREQUENCY_RATIO_DOUBTED, ModelMode, ModelModes, SAME_FROM, WhichMode,
};

messages! {
    /// Measured modes and the model.
    pub(crate) enum Beside in "modal.model" {
        Head { survey: String } => {
            en: "Measured modes beside those of the model: {survey}",
            ko: "계측 모드와 모델 모드의 비교: {survey}",
        },
        Caption => { en: "Which mode of the model each measured mode is.", ko: "계측 모드별 모델 모드." },
        Meaning { least: Quantity, channels: usize } => {
            en: "By the shapes at {channels} channels: MAC {least} or more with one mode of the model alone. Modes of the model within 1 % of one frequency are taken together. The judgement rests on the lowest frequency along each axis; a mode more than 10 % and three standard deviations off leaves the model in doubt.",
            ko: "{channels}채널에서의 형상이 기준이며, 모델 모드 하나와만 MAC {least} 이상이면 그 모드로 본다. 진동수 차이가 1 % 이내인 모델 모드는 하나로 묶었다. 판정에는 축별 최저 고유진동수를 쓰며, 10 %와 표준편차의 3배를 넘게 차이 나는 모드가 있으면 모델을 ‘확인 필요’로 본다.",
        },
        Mode => { en: "Measured", ko: "계측" },
        Frequency => { en: "frequency", ko: "진동수" },
        Model => { en: "mode of the model", ko: "모델 모드" },
        OfModel => { en: "frequency of the model", ko: "모델 진동수" },
        Off => { en: "measured over model − 1", ko: "계측/모델 − 1" },
        Assurance => { en: "MAC", ko: "유사도(MAC)" },
        Number { number: usize } => { en: "{number}", ko: "{number}" },
        Pair { first: usize, last: usize } => { en: "{first} to {last}, of one frequency", ko: "{first}–{last}(같은 진동수)" },
        Alike { modes: Vec<Sentence> } => { en: "not told: {modes} look alike here", ko: "판별 불가: {modes}이(가) 서로 비슷함" },
        NoneAlike { best: Sentence } => { en: "none; most alike is {best}", ko: "없음. 가장 비슷한 것은 {best}" },
        None => { en: "none", ko: "없음" },
        Figure => { en: "MAC of measured modes with those of the model.", ko: "계측 모드와 모델 모드의 MAC." },
        FigureMeaning => {
            en: "A frame marks the mode of the model that a measured one is. A row without one dark cell is a mode that the model does not have, or that these sensors cannot tell.",
            ko: "테두리는 계측 모드에 해당하는 모델 모드이다. 짙은 칸이 하나도 없는 행은 모델에 없거나 이 센서로는 판별할 수 없는 모드이다.",
        },
        LeftOut { channels: Vec<String> } => {
            en: "Not compared, as the model has nothing at their place or their place or direction is not given: {channels}.",
            ko: "위치나 방향이 없거나 그 위치에 모델의 부재가 없어 비교하지 않은 채널: {channels}.",
        },
        FarOff { modes: Vec<Sentence>, times: Quantity } => {
            en: "Doubtful: measured mode {modes} looks like a mode of the model whose frequency is more than {times} times as high or as low. Either the model is not this structure, or these channels do not tell its modes apart; more sensors, or better places« (`dolmen sensors`)», decide it.",
            ko: "의심되는 결과: 계측 모드 {modes}은(는) 형상이 비슷한 모델 모드와 진동수가 {times}배 넘게 다르다. 모델이 이 구조물과 다르거나, 이 채널들로는 모델 모드를 판별할 수 없다. 센서를 늘리거나 더 좋은 위치«(`dolmen sensors`)»에 두어 가린다.",
        },
        WithoutDampers { dampers: Vec<String> } => {
            en: "The modes of the model are those of the structure without its dampers ({dampers}): near the frequency of one that is tuned, two modes of like shape are measured where the model has one.",
            ko: "모델 모드는 감쇠기({dampers})를 뺀 구조물의 것이다. 동조한 감쇠기의 진동수 부근에서는 모델의 모드 하나가 형상이 비슷한 두 모드로 계측된다.",
        },
        OfMode { number: usize } => { en: "MAC with mode {number} of the model", ko: "모델 모드 {number}와의 MAC" },
    }
}

/// Table and figure.
pub(super) fn section<'a>(document: &mut Document<'a>, survey: &str, model: &'a ModelModes) {
    document.heading(Beside::Head {
        survey: survey.to_owned(),
    });
    let meaning = Beside::Meaning {
        least: fixed(SAME_FROM, 1),
        channels: model.channels,
    };
    let rows = model.measured.iter().enumerate();
    document.put(Block::Table(Table {
        caption: vec![Beside::Caption.into(), meaning.into()],
        columns: vec![
            Column::words(Beside::Mode),
            Column::words(Beside::Model),
            Column::numbers(Beside::Frequency, Unit::si("Hz")),
            Column::numbers(Beside::OfModel, Unit::si("Hz")),
            Column::numbers(Beside::Off, Unit::percent()),
            Column::numbers(Beside::Assurance, Unit::ratio()),
        ],
        rows: rows.map(|(at, of)| row(model, at, of)).collect(),
    }));
    let caption = vec![Beside::Figure.into(), Beside::FigureMeaning.into()];
    let figure = Figure::drawn(caption, move |language| model_likeness(model, language));
    document.charted(figure.with_series(move || {
        let measured = model.measured.iter().map(|of| of.frequency_hz);
        let mut all = vec![Series::numbers(Beside::Frequency, "Hz", measured)];
        for (at, of) in model.of_model.iter().enumerate() {
            let name = Beside::OfMode { number: of.first + 1 };
            all.push(Series::numbers(
                name,
                "",
                model.measured.iter().map(|m| m.assurance[at]),
            ));
        }
        all
    }));
    let far = model.far_off();
    if !far.is_empty() {
        let modes = far.iter().map(|at| Beside::Number { number: at + 1 }.into());
        document.put(Block::Warning(
            Beside::FarOff {
                modes: modes.collect(),
                times: fixed(FREQUENCY_RATIO_DOUBTED, 1),
            }
            .into(),
        ));
    }
    if !model.without_dampers.is_empty() {
        let dampers = model.without_dampers.clone();
        document.put(Block::Warning(Beside::WithoutDampers { dampers }.into()));
    }
    if !model.left_out.is_empty() {
        document.note(Beside::LeftOut {
            channels: model.left_out.clone(),
        });
    }
}

fn row(model: &ModelModes, at: usize, of: &BesideModel) -> Vec<Cell> {
    let hertz = |hz: f64| Cell::number(Quantity::new(hz, Unit::si("Hz"), Digits::Significant(4)));
    let named = |place: usize| numbered(&model.of_model[place]);
    let (words, known): (Sentence, Option<usize>) = match &of.is {
        WhichMode::One(place) => (named(*place), Some(*place)),
        WhichMode::Several(places) => {
            let modes = places.iter().map(|place| named(*place)).collect();
            (Beside::Alike { modes }.into(), None)
        }
        WhichMode::None(Some(best)) => (Beside::NoneAlike { best: named(*best) }.into(), None),
        WhichMode::None(None) => (Beside::None.into(), None),
    };
    let most = of.assurance.iter().copied().fold(0.0, f64::max);
    let hz = known.map(|place| model.of_model[place].frequency_hz);
    vec![
        Cell::words(Beside::Number { number: at + 1 }),
        Cell::words(words),
        hertz(of.frequency_hz),
        hz.map_or(Cell::Number(None), hertz),
        Cell::Number(hz.map(|hz| percent(of.frequency_hz / hz - 1.0, 1))),
        Cell::number(fixed(most, 2)),
    ]
}

fn numbered(of: &ModelMode) -> Sentence {
    let first = of.first + 1;
    match of.count {
        1 => Beside::Number { number: first }.into(),
        count => Beside::Pair {
            first,
            last: of.first + count,
        }
        .into(),
    }
}
