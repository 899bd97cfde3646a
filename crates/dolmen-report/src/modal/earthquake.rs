//! A record that holds an earthquake: what was measured, and the structure before, in and after it.

use super::values::{hertz, seconds};
use crate::document::{Block, Cell, Column, Document, Figure, Finding, Series, Table, Tone};
use crate::figures::{frequency_through, spectra_of_channels};
use dolmen::modal::{During, LastingChange, Part, StrongChannel, StrongMotion};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::surveyed::{Earthquake, ModesOf, RecordAnswer};

messages! {
    /// An earthquake in a record.
    pub(crate) enum Quake in "modal.earthquake" {
        Holds { from: Quantity, to: Quantity, strong: Quantity, over: Quantity, peak: Sentence } => {
            en: "EARTHQUAKE: the record holds one, {from} to {to} after its first sample, strong for {strong}, {over} times the noise{peak}.",
            ko: "지진: 기록의 첫 표본부터 {from}–{to} 구간에 지진이 있다. 강진 지속시간 {strong}, 잡음의 {over}배{peak}.",
        },
        Peak { peak: Quantity, channel: String, at: Quantity } => {
            en: "; largest acceleration {peak} at {channel}, after {at}",
            ko: ". 최대가속도는 {channel}에서 {at}에 {peak}",
        },
        NoPeak => { en: "", ko: "" },
        Three { before: Sentence, during: Sentence, after: Sentence } => {
            en: "Lowest frequency before it: {before}; in it: {during}; after it: {after}.",
            ko: "최저차 고유진동수: 지진 전 {before}, 지진 중 {during}, 지진 후 {after}.",
        },
        Hertz { frequency: Quantity } => { en: "{frequency}", ko: "{frequency}" },
        NotKnown => { en: "not known", ko: "알 수 없음" },
        TooShort { time: Quantity } => { en: "not known ({time} of the record, or no mode in it)", ko: "알 수 없음(해당 구간 {time}, 또는 모드 없음)" },
        Lasts { frequency: Quantity, by: Quantity, half: Quantity } => {
            en: "LASTING CHANGE: {frequency} changed by {by} ± {half} (95 %) from before to after, beyond chance. Look at the structure.",
            ko: "잔류 변화: {frequency} 모드가 지진 전후에 {by} ± {half}(95 %) 변하였으며 유의하다. 구조물을 점검한다.",
        },
        NothingLasts { frequency: Quantity, by: Quantity, half: Quantity } => {
            en: "No lasting change beyond chance: {frequency} by {by} ± {half} (95 %) from before to after. That is no proof that nothing was damaged.",
            ko: "유의한 잔류 변화는 없다. {frequency} 모드의 지진 전후 변화는 {by} ± {half}(95 %)이다. 손상이 없다는 증명은 아니다.",
        },
        CannotTell => {
            en: "Whether the earthquake changed the structure cannot be told from this record: modes before and after it are needed, 40 s of each at least.",
            ko: "이 기록으로는 지진이 구조물을 변화시켰는지 알 수 없다. 지진 전과 후에 각각 40 s 이상의 기록과 모드가 필요하다.",
        },
        OfAfter { from: Quantity, to: Quantity } => {
            en: "The modes below are those of the record after the earthquake, {from} to {to}.",
            ko: "아래의 모드는 지진 이후 구간({from}–{to})의 것이다.",
        },
        OfBefore { from: Quantity, to: Quantity } => {
            en: "The modes below are those of the record BEFORE the earthquake, {from} to {to}: what follows it is too short.",
            ko: "아래의 모드는 지진 이전 구간({from}–{to})의 것이다. 지진 이후 구간이 너무 짧다.",
        },
        OfWhole => {
            en: "The modes below are those of the whole record, most of all of the structure in the earthquake: no ambient survey, and not to be compared with one.",
            ko: "아래의 모드는 기록 전체의 것으로 주로 지진 중의 구조물을 나타낸다. 상시진동 조사가 아니므로 상시진동 조사와 비교할 수 없다.",
        },
        NoTilt => {
            en: "A lasting tilt or displacement is not given: integrating an accelerometer twice makes one of any offset. Read a tilt sensor, or survey the tilt again.",
            ko: "잔류 기울기나 변위는 제시하지 않는다. 가속도계를 두 번 적분하면 작은 영점 오차도 변위로 나타난다. 경사계를 읽거나 기울기를 다시 측량한다.",
        },
        NotOne => {
            en: "Where this is no earthquake (a blast, a crowd, blows of a hammer), say earthquake = \"none\" in records.modal.",
            ko: "지진이 아니면(발파, 군중, 해머 타격) records.modal에 earthquake = \"none\"을 적는다.",
        },
        Softer => {
            en: "Frequencies fall with the strength of motion in stone and timber, and come back with it: the one in the earthquake says nothing of damage. The part after it begins where the motion has sunk to twice the noise.",
            ko: "석조와 목조에서는 진동이 강할수록 고유진동수가 낮아졌다가 진동이 줄면 되돌아오므로, 지진 중의 값은 손상을 뜻하지 않는다. 지진 이후 구간은 진동이 잡음의 2배로 줄어든 때부터이다.",
        },
        ByInputs { inputs: Vec<String> } => {
            en: "In the earthquake: with {inputs} taken as given, the linear structure that moves most alike.",
            ko: "지진 중: {inputs}을(를) 주어진 입력으로 볼 때 가장 비슷하게 움직이는 선형 구조물.",
        },
        ByTrack { windows: usize, lowest: Quantity, at: Quantity } => {
            en: "In the earthquake: the lowest mode followed along its shape in {windows} windows; lowest {lowest}, after {at}. The colour of the shaking moves it as well; a measured ground, marked in inputs, tells more.",
            ko: "지진 중: 최저차 모드를 그 형상 방향으로 {windows}개 시간창에서 추적하였다. 최저 {lowest}({at}). 지진의 진동수 특성에도 영향을 받으며, 지반을 계측하여 inputs에 적으면 더 정확하다.",
        },
        Measured => { en: "What each channel measured in the earthquake.", ko: "지진 중 채널별 계측값." },
        Band { low: Quantity, high: Quantity } => {
            en: "Velocity: integrated once, between {low} and {high} alone.",
            ko: "속도: {low}–{high} 대역에서 한 번 적분한 값.",
        },
        Through => { en: "The lowest frequency before, in and after the earthquake.", ko: "지진 전·중·후의 최저차 고유진동수." },
        ThroughMeaning => { en: "Bars: 95 % intervals. Grey: the strong phase, 5 to 95 % of the energy.", ko: "막대: 95 % 신뢰구간. 회색: 강진 구간(에너지의 5–95 %)." },
        Spectra => { en: "Response spectra of the channels, 5 % of damping.", ko: "채널별 응답 스펙트럼(감쇠비 5 %)." },
        SpectraMeaning => {
            en: "What an oscillator that stands where the sensor stands would feel: on the ground the earthquake, above it what the structure made of it.",
            ko: "센서 위치에 놓인 단자유도계의 응답이다. 지반의 센서는 지진을, 그 위의 센서는 구조물이 증폭한 운동을 나타낸다.",
        },
        Changes => { en: "Modes before and after the earthquake.", ko: "지진 전후의 모드." },
        Named { name: String } => { en: "{name}", ko: "{name}" },
        Channel => { en: "Channel", ko: "채널" },
        PeakOf => { en: "peak acceleration", ko: "최대가속도" },
        At => { en: "at", ko: "시각" },
        PeakVelocity => { en: "peak velocity", ko: "최대속도" },
        Arias => { en: "Arias intensity", ko: "아리아스 강도" },
        Noise => { en: "RMS before", ko: "지진 전 RMS" },
        Before => { en: "before", ko: "지진 전" },
        After => { en: "after", ko: "지진 후" },
        Change => { en: "change", ko: "변화" },
        Half => { en: "± (95 %)", ko: "±(95 %)" },
        Period => { en: "period", ko: "주기" },
        AccelerationOf { channel: String } => { en: "pseudo-acceleration at {channel}", ko: "{channel} 의사 가속도" },
    }
}

/// Half of the width of an interval that holds 95 %, in standard deviations.
const HALF_95: f64 = 1.96;

fn time(at_s: f64) -> Quantity {
    seconds((at_s * 10.0).round() / 10.0)
}

fn share(of: f64) -> Quantity {
    Quantity::new(of, Unit::percent(), Digits::Significant(2))
}

fn with_sd(frequency_hz: f64, sd_si: Option<f64>) -> Sentence {
    let frequency = Quantity {
        sd_si,
        ..Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Significant(4))
    };
    Quake::Hertz { frequency }.into()
}

fn acceleration(of: f64) -> Quantity {
    Quantity::new(of, Unit::si("m/s²"), Digits::Significant(3))
}

/// What leads: that there is one, the lowest frequency through it, what lasts, and of which part the modes are.
pub(super) fn findings(of: &Earthquake) -> Vec<Finding> {
    let shaking = &of.found.shaking;
    let peak = of.found.strongest().and_then(|channel| {
        Some(Quake::Peak {
            peak: acceleration(channel.peak_acceleration_m_s2?),
            channel: channel.name.clone(),
            at: time(channel.peak_at_s),
        })
    });
    let holds = Quake::Holds {
        from: time(shaking.arrival_s),
        to: time(shaking.end_s),
        strong: time(shaking.strong_to_s - shaking.strong_from_s),
        over: Quantity::ratio(shaking.over_noise, 2),
        peak: peak.unwrap_or(Quake::NoPeak).into(),
    };
    let mut all = vec![Finding::key(Tone::Warn, holds).with_code("earthquake")];
    all.push(Finding::key(Tone::Plain, three(&of.found)));
    all.push(lasting(&of.found));
    let span = |part: &Part| part.span_s.map(time);
    let ([from, to], [first, last]) = (span(&of.found.after), span(&of.found.before));
    all.push(match of.modes_of {
        ModesOf::After => Finding::key(Tone::Plain, Quake::OfAfter { from, to }),
        ModesOf::Before => Finding::key(
            Tone::Warn,
            Quake::OfBefore {
                from: first,
                to: last,
            },
        ),
        ModesOf::Whole => Finding::key(Tone::Warn, Quake::OfWhole),
    });
    all.push(Finding::new(Tone::Plain, Quake::NotOne));
    all
}

/// The lowest mode that was found before, in it and after: of those found both before and after the lowest.
fn three(found: &StrongMotion) -> Quake {
    let lowest = |part: &Part| {
        let mode = part.analysis.as_ref().and_then(|of| of.modes.modes.first());
        mode.map(|mode| with_sd(mode.frequency_hz, mode.frequency_sd_hz))
    };
    let short = |part: &Part| {
        let time = time(part.span_s[1] - part.span_s[0]);
        Quake::TooShort { time }.into()
    };
    let (before, after) = match found.changes.first() {
        Some(change) => (
            Some(with_sd(change.before_hz, change.before_sd_hz)),
            Some(with_sd(change.after_hz, change.after_sd_hz)),
        ),
        None => (lowest(&found.before), lowest(&found.after)),
    };
    let during = match &found.during {
        During::Driven { modes, .. } => modes
            .first()
            .map(|mode| with_sd(mode.frequency_hz, mode.frequency_sd_hz)),
        During::Tracked(of) => Some(with_sd(of.frequency_hz, Some(of.frequency_sd_hz))),
        During::Unknown => None,
    };
    Quake::Three {
        before: before.unwrap_or_else(|| short(&found.before)),
        during: during.unwrap_or_else(|| Quake::NotKnown.into()),
        after: after.unwrap_or_else(|| short(&found.after)),
    }
}

fn lasting(found: &StrongMotion) -> Finding {
    let parts = |of: &LastingChange| {
        let half = of.ratio_sd.map_or(f64::NAN, |sd| HALF_95 * sd);
        [hertz(of.before_hz), share(of.ratio), share(half)]
    };
    if let Some([frequency, by, half]) = found.lasting().map(parts) {
        return Finding::key(Tone::Bad, Quake::Lasts { frequency, by, half });
    }
    match found.changes.iter().find(|of| of.ratio_sd.is_some()).map(parts) {
        Some([frequency, by, half]) => Finding::key(Tone::Plain, Quake::NothingLasts { frequency, by, half }),
        None => Finding::key(Tone::Unknown, Quake::CannotTell),
    }
}

/// The section of a record that holds one.
pub(super) fn section<'a>(document: &mut Document<'a>, record: &'a RecordAnswer) {
    let Some(of) = &record.earthquake else { return };
    let found = &of.found;
    for finding in findings(of) {
        document.paragraph(finding.sentence);
    }
    document.put(Block::Table(channels(found)));
    if found.channels.iter().any(|of| !of.spectrum.is_empty()) {
        let caption = vec![Quake::Spectra.into(), Quake::SpectraMeaning.into()];
        let figure = Figure::new(caption, move |language| {
            spectra_of_channels(&found.channels, language)
        });
        document.charted(figure.with_series(move || spectra(&found.channels)));
    }
    match &found.during {
        During::Driven { inputs, .. } => document.paragraph(Quake::ByInputs {
            inputs: inputs.clone(),
        }),
        During::Tracked(track) => document.paragraph(Quake::ByTrack {
            windows: track.points.len(),
            lowest: hertz(track.lowest.frequency_hz),
            at: time(track.lowest.at_s),
        }),
        During::Unknown => {}
    }
    let caption = vec![Quake::Through.into(), Quake::ThroughMeaning.into()];
    document.figure(caption, move |language| frequency_through(found, language));
    if !found.changes.is_empty() {
        document.put(Block::Table(changes(&found.changes)));
    }
    document.note(Quake::Softer);
    document.note(Quake::NoTilt);
}

fn channels(found: &StrongMotion) -> Table {
    let band = found.channels.iter().find_map(|of| of.velocity_band_hz);
    let band = band.map(|[low, high]| Quake::Band {
        low: hertz(low),
        high: hertz(high),
    });
    let row = |of: &StrongChannel| {
        let number = |value: Option<f64>, unit: &str| {
            Cell::Number(value.map(|value| Quantity::new(value, Unit::si(unit), Digits::Significant(3))))
        };
        let is_acceleration = of.peak_acceleration_m_s2.is_some();
        vec![
            Cell::words(Quake::Named {
                name: of.name.clone(),
            }),
            number(of.peak_acceleration_m_s2, "m/s²"),
            Cell::Number(Some(time(of.peak_at_s))),
            number(of.peak_velocity_m_s, "m/s"),
            number(of.arias_intensity_m_s, "m/s"),
            number(is_acceleration.then_some(of.noise), "m/s²"),
        ]
    };
    Table {
        caption: std::iter::once(Quake::Measured)
            .chain(band)
            .map(Sentence::from)
            .collect(),
        columns: vec![
            Column::words(Quake::Channel),
            Column::numbers(Quake::PeakOf, Unit::si("m/s²")),
            Column::numbers(Quake::At, Unit::si("s")),
            Column::numbers(Quake::PeakVelocity, Unit::si("m/s")),
            Column::numbers(Quake::Arias, Unit::si("m/s")),
            Column::numbers(Quake::Noise, Unit::si("m/s²")),
        ],
        rows: found.channels.iter().map(row).collect(),
    }
}

fn changes(all: &[LastingChange]) -> Table {
    let frequency = |hz: f64, sd_si: Option<f64>| {
        Cell::Number(Some(Quantity {
            sd_si,
            ..Quantity::new(hz, Unit::si("Hz"), Digits::Significant(5))
        }))
    };
    let row = |of: &LastingChange| {
        vec![
            frequency(of.before_hz, of.before_sd_hz),
            frequency(of.after_hz, of.after_sd_hz),
            Cell::Number(Some(share(of.ratio))),
            Cell::Number(of.ratio_sd.map(|sd| share(HALF_95 * sd))),
        ]
    };
    Table {
        caption: vec![Quake::Changes.into()],
        columns: vec![
            Column::numbers(Quake::Before, Unit::si("Hz")),
            Column::numbers(Quake::After, Unit::si("Hz")),
            Column::numbers(Quake::Change, Unit::percent()),
            Column::numbers(Quake::Half, Unit::percent()),
        ],
        rows: all.iter().map(row).collect(),
    }
}

/// Response spectra over period, a column a channel.
fn spectra(channels: &[StrongChannel]) -> Vec<Series> {
    let with = || channels.iter().filter(|of| !of.spectrum.is_empty());
    let periods = with().next().map(|of| &of.spectrum);
    let periods = periods.into_iter().flatten().map(|of| of.period_s);
    let each = with().map(|of| {
        let name = Quake::AccelerationOf {
            channel: of.name.clone(),
        };
        let all = of.spectrum.iter().map(|of| of.pseudo_acceleration_m_s2());
        Series::numbers(name, "m/s²", all)
    });
    std::iter::once(Series::numbers(Quake::Period, "s", periods))
        .chain(each)
        .collect()
}
