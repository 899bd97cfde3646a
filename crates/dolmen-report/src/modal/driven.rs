//! Further results from a measured input: the same modes with compliant ground, and the coherence with the input.

use super::tables::nth_of;
use super::values::{fixed, percent, plain};
use crate::document::{Block, Cell, Column, Document, Figure, Series, Table};
use crate::figures::{response_coherence, response_magnitudes};
use dolmen::modal::{Driven, DrivenMode, FrequencyResponses, ModalAnalysis, Mode, OffGround};
use dolmen_words::{Digits, Quantity, Unit, messages};

messages! {
    /// Modes above a measured ground.
    pub(crate) enum Drivens in "modal.driven" {
        Taken { inputs: Vec<String>, lags: usize } => {
            en: "What {inputs} measures is taken as given (observer of {lags} samples). Where it is the motion of a ground or base, the modes are those of the structure on a base that is held there, and what these channels do not measure is not held: on a base that rocks without a sensor for it, the modes are those of the structure that rocks. Where it is a force, of a shaker or a hammer, nothing is held: the modes are those of the structure as it stands.",
            ko: "{inputs}의 계측값을 주어진 입력으로 보았다(관측기 차수 {lags}). 지반이나 기초의 운동이면 모드는 그 위치의 기초가 고정된 구조물의 것이며, 이 채널이 재지 않는 운동은 고정되지 않는다. 기초의 회전을 재는 센서가 없으면 기초가 회전하는 구조물의 모드이다. 가진기나 해머의 힘이면 고정되는 것이 없으며 모드는 서 있는 그대로의 구조물의 것이다.",
        },
        Caption => {
            en: "With the input taken as given, and without regard to it.",
            ko: "입력을 고려한 경우와 고려하지 않은 경우.",
        },
        Meaning => {
            en: "Without it: the mode of like shape that the record has without regard to the input; where that is a ground's motion, structure and ground as one. Follows the input: share of the motion at the frequency of the mode, by coherence; the rest comes from wind, people, traffic and noise.",
            ko: "입력 미고려: 입력을 고려하지 않고 같은 기록에서 찾은, 형상이 닮은 모드. 입력이 지반의 운동이면 구조물과 지반의 연성계이다. 입력을 따르는 비율: 그 모드의 고유진동수에서 입력과 상관된 운동의 비율(기여도 함수)이며 나머지는 바람, 사람, 교통, 잡음이다.",
        },
        Responses { input: String, segments: usize } => {
            en: "Frequency response functions of the channels to {input} (H₁ from {segments} segments).",
            ko: "{input}에 대한 채널별 주파수 응답 함수(구간 {segments}개의 H₁).",
        },
        ResponsesMeaning => {
            en: "Lines mark the modes with the input taken as given, near which the peaks lie. Noise of a channel does not bias H₁; noise of the input makes it smaller.",
            ko: "선은 입력을 고려한 모드이며 피크는 그 근처에 있다. 채널의 잡음은 H₁에 편의를 주지 않고, 입력의 잡음은 H₁을 작게 만든다.",
        },
        Coherence => { en: "Coherence of the channels with the inputs.", ko: "채널별 입력과의 기여도 함수." },
        CoherenceMeaning { segments: usize, chance: Quantity } => {
            en: "1 where all motion of a channel follows the inputs. A channel that follows nothing comes out at {chance} on average, by chance ({segments} segments).",
            ko: "1이면 그 채널의 운동이 모두 입력을 따른다. 입력과 무관한 채널도 우연히 평균 {chance}의 값을 갖는다(구간 {segments}개).",
        },
        FrequencyOfLine => { en: "frequency", ko: "진동수" },
        Modulus { channel: String, input: String } => { en: "|{channel} / {input}|", ko: "|{channel} / {input}| 크기" },
        Phase { channel: String, input: String } => { en: "phase of {channel} / {input}", ko: "{channel} / {input} 위상" },
        CoherenceOf { channel: String } => { en: "coherence of {channel}", ko: "{channel} 기여도 함수" },
        Reversed { input: String, channels: Vec<String>, from: Quantity, to: Quantity, ratio: Quantity } => {
            en: "PROBABLY A SLIP: far below the lowest mode, from {from} to {to}, a structure moves as its ground does, but {channels} move {ratio} times as {input}: is {input} turned round? Reverse its direction in the project file. Frequencies and damping ratios are right; H₁ and a simulation under this ground are not.",
            ko: "입력 오류 의심: 최저차 모드보다 훨씬 낮은 {from}~{to}에서 구조물은 지반과 같이 움직이는데, {channels}의 운동은 {input}의 {ratio}배이다. {input} 센서의 방향이 반대인지 확인하고, 반대이면 프로젝트 파일의 방향을 바꾼다. 고유진동수와 감쇠비는 유효하나 H₁과 이 지반운동을 쓴 해석은 틀린다.",
        },
        Scaled { input: String, channels: Vec<String>, from: Quantity, to: Quantity, ratio: Quantity } => {
            en: "PROBABLY A SLIP: far below the lowest mode, from {from} to {to}, a structure moves as its ground does, but {channels} move {ratio} times as {input}: are the unit and scale of {input} right? Frequencies and damping ratios are; H₁, the peak of the ground and a simulation under it are not.",
            ko: "입력 오류 의심: 최저차 모드보다 훨씬 낮은 {from}~{to}에서 구조물은 지반과 같이 움직이는데, {channels}의 운동은 {input}의 {ratio}배이다. {input}의 단위와 배율(scale)을 확인한다. 고유진동수와 감쇠비는 유효하나 H₁, 지반의 최대값, 이 지반운동을 쓴 해석은 틀린다.",
        },
        OneOff { input: String, channel: String, from: Quantity, to: Quantity, ratio: Quantity } => {
            en: "PROBABLY A SLIP: far below the lowest mode, from {from} to {to}, a structure moves as its ground does, but {channel} moves {ratio} times as {input}, and the others about once: check the direction, unit and scale of {channel}.",
            ko: "입력 오류 의심: 최저차 모드보다 훨씬 낮은 {from}~{to}에서 구조물은 지반과 같이 움직이는데, {channel}의 운동은 {input}의 {ratio}배이고 다른 채널은 약 1배이다. {channel}의 방향, 단위, 배율(scale)을 확인한다.",
        },
        Mode => { en: "Mode", ko: "모드" },
        Held => { en: "input given", ko: "입력 고려" },
        Together => { en: "without it", ko: "입력 미고려" },
        Ratio => { en: "given over without", ko: "고려/미고려 비" },
        Follows => { en: "follows the input", ko: "입력을 따르는 비율" },
    }
}

/// Channels that do not move as their ground far below the lowest mode.
pub(super) fn off_ground(of: &OffGround) -> Drivens {
    let [from, to] = of
        .range_hz
        .map(|hz| Quantity::new(hz, Unit::si("Hz"), Digits::Significant(2)));
    let (input, channels) = (of.input.clone(), of.channels.clone());
    let ratio = Quantity::new(of.ratio, Unit::ratio(), Digits::Significant(3));
    match of.channels.as_slice() {
        [channel] if !of.is_input => Drivens::OneOff {
            input,
            channel: channel.clone(),
            from,
            to,
            ratio,
        },
        // −1 within the gains of two sensors
        _ if (-1.25..-0.8).contains(&of.ratio) => Drivens::Reversed {
            input,
            channels,
            from,
            to,
            ratio,
        },
        _ => Drivens::Scaled {
            input,
            channels,
            from,
            to,
            ratio,
        },
    }
}

/// The fixed parts, and each mode compared with that of structure and ground together.
pub(super) fn section<'a>(document: &mut Document<'a>, driven: &'a Driven, analysis: &'a ModalAnalysis) {
    let modes = &analysis.modes.modes;
    document.paragraph(Drivens::Taken {
        inputs: driven.inputs.clone(),
        lags: driven.lags,
    });
    if driven.modes.is_empty() {
        return;
    }
    document.put(Block::Table(Table {
        caption: vec![Drivens::Caption.into(), Drivens::Meaning.into()],
        columns: vec![
            Column::words(Drivens::Mode),
            Column::numbers(Drivens::Held, Unit::si("Hz")),
            Column::numbers(Drivens::Together, Unit::si("Hz")),
            Column::numbers(Drivens::Ratio, Unit::ratio()),
            Column::numbers(Drivens::Follows, Unit::percent()),
        ],
        rows: driven.modes.iter().zip(modes).enumerate().map(row).collect(),
    }));
    responses(document, driven, analysis);
}

/// Response functions and coherence, line by line.
fn responses<'a>(document: &mut Document<'a>, driven: &'a Driven, analysis: &'a ModalAnalysis) {
    let Some(of) = &driven.responses else { return };
    for (input, name) in driven.inputs.iter().enumerate() {
        let caption = Drivens::Responses {
            input: name.clone(),
            segments: of.segments,
        };
        let caption = vec![caption.into(), Drivens::ResponsesMeaning.into()];
        let figure = Figure::drawn(caption, move |language| {
            response_magnitudes(analysis, (of, input), language)
        });
        document.charted(figure.with_series(move || of_input(of, (input, name))));
    }
    let meaning = Drivens::CoherenceMeaning {
        segments: of.segments,
        chance: fixed(driven.inputs.len() as f64 / of.segments as f64, 2),
    };
    let caption = vec![Drivens::Coherence.into(), meaning.into()];
    let figure = Figure::drawn(caption, move |language| {
        response_coherence(analysis, of, language)
    });
    document.charted(figure.with_series(move || {
        let each = of.outputs.iter().map(|output| {
            let name = Drivens::CoherenceOf {
                channel: output.channel.clone(),
            };
            Series::numbers(name, "", output.coherence.iter().copied())
        });
        std::iter::once(lines(of)).chain(each).collect()
    }));
}

fn lines(of: &FrequencyResponses) -> Series {
    Series::numbers(Drivens::FrequencyOfLine, "Hz", of.frequency_hz.iter().copied())
}

/// Modulus and phase of every channel over an input.
fn of_input(of: &FrequencyResponses, (input, name): (usize, &str)) -> Vec<Series> {
    let mut all = vec![lines(of)];
    for output in &of.outputs {
        let Some(h1) = output.h1.get(input) else { continue };
        let (channel, input) = (output.channel.clone(), name.to_owned());
        let modulus = Drivens::Modulus {
            channel: channel.clone(),
            input: input.clone(),
        };
        all.push(Series::numbers(modulus, "", h1.iter().map(|h| h.norm())));
        let phase = Drivens::Phase { channel, input };
        all.push(Series::numbers(
            phase,
            "°",
            h1.iter().map(|h| h.arg().to_degrees()),
        ));
    }
    all
}

fn row((at, (mode, of)): (usize, (&DrivenMode, &Mode))) -> Vec<Cell> {
    let together = mode.with_base_hz.map(|(hz, sd_si)| Quantity {
        sd_si,
        ..Quantity::new(hz, Unit::si("Hz"), Digits::Significant(5))
    });
    let ratio = mode
        .with_base_hz
        .map(|(hz, _)| plain((mode.frequency_hz / hz * 1e3).round() / 1e3));
    vec![
        nth_of(at, of),
        Cell::number(Quantity::new(
            mode.frequency_hz,
            Unit::si("Hz"),
            Digits::Significant(5),
        )),
        Cell::Number(together),
        Cell::Number(ratio),
        Cell::Number(mode.explained.map(|share| percent(share, 0))),
    ]
}
