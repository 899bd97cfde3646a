//! The record as used: its channels over time, and the spectrogram of one.

use super::values::seconds;
use crate::document::{Document, Figure, Series};
use crate::figures::{CHANNELS_DRAWN, channels_over_time, spectrogram, unit_of};
use dolmen::modal::Modes;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::record_seen::{RecordSeen, SpectrogramSeen};

messages! {
    /// Captions of a record over time.
    pub(crate) enum Seen in "modal.seen" {
        Channels { used: Quantity } => {
            en: "The channels over time, as used ({used}).",
            ko: "해석에 쓴 채널별 시간이력({used}).",
        },
        ChannelsRead { read: Quantity } => {
            en: "The channels over time, as read ({read}).",
            ko: "읽은 채널별 시간이력({read}).",
        },
        Part { from: Quantity, to: Quantity } => {
            en: "The modes are those of {from} to {to}.",
            ko: "모드는 {from}–{to} 구간에서 구하였다.",
        },
        ChannelsMeaning => {
            en: "Each column reaches from the least to the largest sample of its part of the time, so that a spike is seen.",
            ko: "각 세로선은 그 시간 구간의 최소 표본부터 최대 표본까지이므로 순간적인 튐도 보인다.",
        },
        FirstOf { shown: usize, all: usize } => {
            en: "The first {shown} of {all} channels; the CSV beside the figure holds all.",
            ko: "전체 {all}채널 중 처음 {shown}채널이며, 그림과 함께 저장되는 CSV에는 모든 채널이 있다.",
        },
        Unused { from: Quantity, to: Quantity, whole: Quantity } => {
            en: "Used: {from} to {to} of the {whole} of the file.",
            ko: "파일 전체 {whole} 중 {from}–{to} 구간을 사용하였다.",
        },
        LostElsewhere => {
            en: "What single files lost is told above; their times differ, and it is not drawn.",
            ko: "파일별 누락 구간은 위에 적었으며, 시각이 서로 달라 그림에는 표시하지 않았다.",
        },
        Spectrogram { channel: String } => { en: "Spectrogram of {channel}.", ko: "{channel}의 스펙트로그램." },
        Asked => { en: "The project names this channel.", ko: "프로젝트에서 지정한 채널이다." },
        Strongest => {
            en: "Of the channels this one moves most in the range looked at.",
            ko: "해석 진동수 범위에서 운동이 가장 큰 채널이다.",
        },
        SpectrogramMeaning { resolution: Quantity, segment: Quantity, column: Quantity } => {
            en: "Logarithmic colours: power spectral density in dB, in lines {resolution} wide from segments of {segment}, a column every {column}. Dashed: the modes found. A mode is a band that stays at its place; a machine a sharp line that begins, ends or wanders; a blow an upright stripe.",
            ko: "색은 로그 척도(dB)의 파워 스펙트럼 밀도이며, 진동수 간격 {resolution}, 구간 길이 {segment}, 시간 간격 {column}이다. 파선은 찾은 모드이다. 모드는 제자리를 지키는 띠로, 기계 진동은 나타났다 사라지거나 이동하는 가는 선으로, 충격은 세로 줄무늬로 보인다.",
        },
        From => { en: "from", ko: "시작" },
        Least { channel: String } => { en: "least of {channel}", ko: "{channel} 최소" },
        Most { channel: String } => { en: "largest of {channel}", ko: "{channel} 최대" },
        Line => { en: "frequency", ko: "진동수" },
        At { time: Quantity } => { en: "density at {time}", ko: "{time}의 밀도" },
    }
}

/// The channels over time.
pub(super) fn time_figure<'a>(document: &mut Document<'a>, seen: &'a RecordSeen) {
    let time = &seen.time;
    let used = seconds(time.to_s - time.from_s);
    let mut caption: Vec<Sentence> = match seen.part_s {
        None => vec![Seen::Channels { used }.into(), Seen::ChannelsMeaning.into()],
        Some(span_s) => {
            let [from, to] = span_s.map(seconds);
            vec![
                Seen::ChannelsRead { read: used }.into(),
                Seen::Part { from, to }.into(),
                Seen::ChannelsMeaning.into(),
            ]
        }
    };
    if seen.channels.len() > CHANNELS_DRAWN {
        let (shown, all) = (CHANNELS_DRAWN, seen.channels.len());
        caption.push(Seen::FirstOf { shown, all }.into());
    }
    if time.whole_s - (time.to_s - time.from_s) > 0.5 * time.step_s {
        let [from, to, whole] = [time.from_s, time.to_s, time.whole_s].map(seconds);
        caption.push(Seen::Unused { from, to, whole }.into());
    }
    if time.lost_elsewhere {
        caption.push(Seen::LostElsewhere.into());
    }
    let figure = Figure::drawn(caption, move |language| channels_over_time(seen, language));
    document.charted(figure.with_series(move || envelopes(seen)));
}

/// The spectrogram, if the record is long enough.
pub(super) fn spectrogram_figure<'a>(document: &mut Document<'a>, seen: &'a RecordSeen, modes: &'a Modes) {
    let Some(drawn) = &seen.spectrogram else { return };
    let of = &drawn.of;
    let each = of.columns.first().map_or(1, |column| column.segments);
    let caption = vec![
        Seen::Spectrogram {
            channel: seen.channels[drawn.channel].name.clone(),
        }
        .into(),
        match drawn.is_asked {
            true => Seen::Asked,
            false => Seen::Strongest,
        }
        .into(),
        Seen::SpectrogramMeaning {
            resolution: Quantity::new(of.resolution_hz, Unit::si("Hz"), Digits::Significant(3)),
            segment: Quantity::new(2.0 * of.first_s, Unit::si("s"), Digits::Significant(3)),
            column: Quantity::new(of.hop_s * each as f64, Unit::si("s"), Digits::Significant(3)),
        }
        .into(),
    ];
    let figure = Figure::drawn(caption, move |language| spectrogram(seen, drawn, modes, language));
    document.charted(figure.with_series(move || densities(seen, drawn)));
}

/// Smallest and largest sample of every channel in each part of the time.
fn envelopes(seen: &RecordSeen) -> Vec<Series> {
    let time = &seen.time;
    let parts = seen.channels.first().map_or(&[][..], |one| &one.envelope.starts);
    let starts = parts.iter().take(parts.len().saturating_sub(1));
    let from = starts.map(|start| time.from_s + *start as f64 * time.step_s);
    let mut all = vec![Series::numbers(Seen::From, "s", from)];
    for channel in &seen.channels {
        let unit = unit_of(channel.quantity);
        let name = || channel.name.clone();
        let (least, most) = (Seen::Least { channel: name() }, Seen::Most { channel: name() });
        all.push(Series::numbers(
            least,
            unit,
            channel.envelope.least.iter().copied(),
        ));
        all.push(Series::numbers(most, unit, channel.envelope.most.iter().copied()));
    }
    all
}

/// The drawn lines, one column of density per column of the figure.
fn densities(seen: &RecordSeen, drawn: &SpectrogramSeen) -> Vec<Series> {
    let of = &drawn.of;
    let lines = of
        .frequency_hz
        .iter()
        .take_while(|hz| **hz <= drawn.end_hz)
        .count();
    let unit = match unit_of(seen.channels[drawn.channel].quantity) {
        "" => "1/Hz".to_owned(),
        unit => format!("({unit})²/Hz"),
    };
    let shown = of.frequency_hz.iter().take(lines).copied();
    let mut all = vec![Series::numbers(Seen::Line, "Hz", shown)];
    for column in &of.columns {
        let at = Seen::At {
            time: seconds(seen.time.from_s + column.time_s),
        };
        all.push(Series::numbers(
            at,
            &unit,
            column.density.iter().take(lines).copied(),
        ));
    }
    all
}
