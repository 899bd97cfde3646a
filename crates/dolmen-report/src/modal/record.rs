//! The section of one record: input and processing, figures, modes, doubts.

use super::decay;
use super::driven;
use super::earthquake_section;
use super::faults::fault_words;
use super::notes::note_words;
use super::seen::{spectrogram_figure, time_figure};
use super::settings::settings;
use super::shapes::{ShapeFigures, shape_figures};
use super::steps::step_words;
use super::tables::{caption, modes_table, shapes_table};
use super::values::seconds;
use crate::document::{Block, Document, Figure};
use crate::figures::{pole_series, singular_series, singular_values, stabilization};
use dolmen::modal::{Method, ModalAnalysis};
use dolmen_words::message::Both;
use dolmen_words::number::fixed;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::surveyed::RecordAnswer;

messages! {
    /// The section of a record.
    pub(crate) enum Record in "modal.record" {
        Ambient { survey: Sentence } => {
            en: "Modes from ambient vibration: {survey}",
            ko: "상시진동 기록의 모드 분석: {survey}",
        },
        Shaken { survey: Sentence } => {
            en: "Record of an earthquake: {survey}",
            ko: "지진 기록: {survey}",
        },
        Traffic { survey: Sentence } => {
            en: "Record with strong shaking: {survey}",
            ko: "강한 진동이 있는 기록: {survey}",
        },
        Decay { survey: Sentence } => {
            en: "Modes from a free decay: {survey}",
            ko: "자유감쇠 기록의 모드 분석: {survey}",
        },
        Driven { survey: Sentence } => {
            en: "Modes above a measured ground: {survey}",
            ko: "지반운동을 입력으로 한 모드 분석: {survey}",
        },
        Read { file: String, channels: Sentence, samples: String, rate: Quantity, time: Quantity, unit: Sentence, used: Vec<String> } => {
            en: "Record {file}: {channels} of {samples} samples at {rate} ({time}), {unit}. Channels used: {used}.",
            ko: "기록 {file}: {channels}, 채널당 표본 {samples}개, {rate}({time}), {unit}. 사용한 채널: {used}.",
        },
        OneChannel => { en: "1 channel", ko: "1채널" },
        Channels { count: usize } => { en: "{count} channels", ko: "{count}채널" },
        Unit { unit: String } => { en: "unit {unit}", ko: "단위 {unit}" },
        NoUnit => {
            en: "unit unknown: amplitudes mean nothing, frequencies and shapes do",
            ko: "단위 미상: 진폭은 의미가 없으나 진동수와 모드형상은 유효",
        },
        Remark { remark: Both } => { en: "The file says: {remark}", ko: "파일의 내용: {remark}" },
        Done => {
            en: "What was done to the record, in this order:",
            ko: "기록의 처리 이력(순서대로):",
        },
        Spectrum => { en: "Singular values of the spectral matrix.", ko: "스펙트럼 행렬의 특이값." },
        SpectrumMeaning => {
            en: "Each peak of the first one that stands above the second is one way of moving; lines mark the modes found.",
            ko: "첫째 특이값이 둘째 위로 솟은 피크가 하나의 운동 형태이며, 선은 찾은 모드이다.",
        },
        Stabilization => { en: "Stabilisation diagram.", ko: "안정화 선도." },
        StabilizationMeaning => {
            en: "A mode of the structure comes back at the same frequency in model after model; noise does not.",
            ko: "구조물의 모드는 모델 차수가 바뀌어도 같은 진동수에서 반복되지만 잡음은 그렇지 않다.",
        },
        NoMode => { en: "No mode was found.", ko: "모드를 찾지 못하였다." },
        Explain { codes: Vec<String> } => {
            en: "«`dolmen explain` says more of: {codes}.»",
            ko: "«자세한 설명은 `dolmen explain`으로 볼 수 있다: {codes}.»",
        },
    }
}

/// The section of a record; `survey` is the name of its survey.
pub(super) fn section<'a>(document: &mut Document<'a>, survey: Sentence, record: &'a RecordAnswer) {
    let analysis = &record.analysis;
    let is_decay = analysis.modes.method == Method::Era;
    document.heading(match (is_decay, &analysis.driven) {
        (true, _) => Record::Decay { survey },
        (false, Some(_)) => Record::Driven { survey },
        (false, None) => match &record.earthquake {
            Some(of) if of.is_one() => Record::Shaken { survey },
            Some(_) => Record::Traffic { survey },
            None => Record::Ambient { survey },
        },
    });
    read(document, record);
    time_figure(document, &record.seen);
    earthquake_section::section(document, record);
    figures(document, analysis);
    spectrogram_figure(document, &record.seen, &analysis.modes);
    match analysis.modes.modes.is_empty() {
        true => document.paragraph(Record::NoMode),
        false => modes(document, analysis),
    }
    document.paragraph(settings(analysis));
    if let Some(of) = &analysis.decay {
        decay::section(document, of);
    }
    if let Some(of) = &analysis.driven {
        driven::section(document, of, analysis);
    }
    for note in &analysis.notes {
        document.note(note_words(note));
    }
    let codes: &[&str] = match (is_decay, &analysis.driven) {
        (true, _) => &["free-decay"],
        (false, Some(_)) => &["block-rows"],
        (false, None) => &["damping-floor", "harmonics", "block-rows"],
    };
    document.note(Record::Explain {
        codes: codes.iter().map(ToString::to_string).collect(),
    });
}

/// The input, its apparent faults, and its processing.
fn read(document: &mut Document<'_>, record: &RecordAnswer) {
    let used = record.analysis.modes.channels.iter();
    document.paragraph(Record::Read {
        file: record.file.clone(),
        channels: match record.channels {
            1 => Record::OneChannel,
            count => Record::Channels { count },
        }
        .into(),
        samples: fixed(record.samples as f64, 0),
        rate: Quantity::new(record.sampling_rate_hz, Unit::si("Hz"), Digits::Trimmed(6)),
        time: seconds(record.samples as f64 / record.sampling_rate_hz),
        unit: match record.unit.as_str() {
            "" => Record::NoUnit,
            unit => Record::Unit {
                unit: unit.to_owned(),
            },
        }
        .into(),
        used: used.map(|channel| channel.name.clone()).collect(),
    });
    for remark in &record.remarks {
        document.note(Record::Remark {
            remark: remark.clone(),
        });
    }
    for fault in &record.faults {
        document.put(Block::Warning(fault_words(fault)));
    }
    let steps = &record.analysis.modes.history;
    if !steps.is_empty() {
        document.paragraph(Record::Done);
        document.put(Block::List(steps.iter().map(step_words).collect()));
    }
}

fn figures<'a>(document: &mut Document<'a>, analysis: &'a ModalAnalysis) {
    let caption = vec![Record::Spectrum.into(), Record::SpectrumMeaning.into()];
    let values = Figure::drawn(caption, |language| singular_values(analysis, language));
    document.charted(values.with_series(|| singular_series(analysis)));
    if !analysis.stabilization.poles.is_empty() {
        let caption = vec![Record::Stabilization.into(), Record::StabilizationMeaning.into()];
        let poles = Figure::drawn(caption, |language| stabilization(analysis, language));
        document.charted(poles.with_series(|| pole_series(analysis)));
    }
}

fn modes<'a>(document: &mut Document<'a>, analysis: &'a ModalAnalysis) {
    let modes = &analysis.modes;
    document.put(Block::Table(modes_table(modes, caption(modes.method))));
    document.put(Block::Table(shapes_table(modes)));
    shape_figures(document, modes, ShapeFigures::Record);
}
