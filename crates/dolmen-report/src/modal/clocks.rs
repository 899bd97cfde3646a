//! Channels whose clocks drift or are late.

use super::values::fixed;
use dolmen::modal::LateClock;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Clocks of channels.
    pub(crate) enum Clocks in "modal.clocks" {
        Drift { each: Vec<Sentence>, frequency: Quantity, turn: Quantity } => {
            en: "Clocks run apart: {each} against the other channels (± standard deviation), which turns the phase at {frequency} by {turn} along the record; frequencies and damping stay, and these channels are left out of the shapes«; give the station of each the rate in brackets as its sampling_rate, and they are in them».",
            ko: "기록계의 시계가 다른 채널과 다르게 간다: {each}(± 표준편차). {frequency}에서 기록 중 위상이 {turn} 돌아간다. 진동수와 감쇠비는 유효하나 이 채널은 모드형상에서 제외하였다.« 해당 측점에 괄호 안의 샘플링 주파수(sampling_rate)를 주면 포함된다.»",
        },
        EitherDrift { each: Vec<Sentence>, others: Vec<String>, frequency: Quantity, turn: Quantity } => {
            en: "Two clocks run apart: either {each}, or {others} as much the other way (± standard deviation), which turns the phase at {frequency} by {turn} along the record. No more channels agree with one than with the other, so the phases cannot tell which is wrong; frequencies and damping stay, and the former are left out of the shapes. Compare the clocks of the recorders«; if the former are wrong, give their stations the rate in brackets as sampling_rate, otherwise give the others a rate that differs as much the other way».",
            ko: "두 시계가 서로 다르게 간다: {each}, 아니면 {others}이(가) 반대로 그만큼 다르게 간다(± 표준편차). {frequency}에서 기록 중 위상이 {turn} 돌아간다. 어느 한쪽과 맞는 채널이 더 많지 않아 위상으로는 어느 쪽이 틀렸는지 알 수 없다. 진동수와 감쇠비는 유효하며 앞의 채널은 모드형상에서 제외하였다.« 기록계의 시계를 비교하여, 앞의 채널이 틀렸으면 해당 측점에 괄호 안의 샘플링 주파수(sampling_rate)를 주고, 아니면 다른 채널의 측점에 반대로 그만큼 다른 값을 준다.»",
        },
        Drifting { channel: String, drift: Quantity, rate: Quantity } => {
            en: "\"{channel}\" by {drift} ({rate})",
            ko: "\"{channel}\" {drift}({rate})",
        },
        Late { each: Vec<Sentence> } => {
            en: "Clocks are off: {each}, against the other channels (± standard deviation): their phases grow with the frequency of the mode as a delay's do; frequencies and damping stay, and these channels are left out of the shapes; add the delay to the begins of the station of each, or subtract it where the clock is early (a channel among others of one file: as a station of its own), and they are in them. Where another channel of the same place agrees with the rest, the clock is right, and the filter of the channel delays it.",
            ko: "기록계의 시계가 일정하게 어긋나 있다: {each}(± 표준편차). 위상이 지연처럼 진동수에 비례하여 커진다. 진동수와 감쇠비는 유효하나 이 채널은 모드형상에서 제외하였다. 해당 측점(stations)의 begins에 늦은 만큼 더하거나 빠른 만큼 빼면 포함된다. 한 파일의 다른 채널과 함께 있으면 별도의 측점으로 나눈다. 같은 위치의 다른 채널이 나머지와 맞으면 시계가 아니라 그 채널의 필터가 지연시킨 것이다.",
        },
        EitherLate { each: Vec<Sentence>, others: Vec<String> } => {
            en: "Two clocks differ: either {each}, or {others} as much the other way (± standard deviation). As many channels agree with one as with the other, so the phases cannot tell which is wrong; frequencies and damping stay, and the shapes were found with the delay taken off. Compare the clocks of the recorders, and add the delay to the begins of the station that is late.",
            ko: "두 시계가 서로 다르다: {each}, 아니면 {others}이(가) 반대로 그만큼 어긋났다(± 표준편차). 서로 맞는 채널의 수가 같아 위상으로는 어느 쪽이 틀렸는지 알 수 없다. 진동수와 감쇠비는 유효하며, 모드형상은 지연을 보정하여 구하였다. 기록계의 시계를 비교하여 늦은 측점의 begins에 지연을 더한다.",
        },
        LateBy { channel: String, delay: Quantity, modes: usize } => {
            en: "\"{channel}\" late by {delay} (modes that tell it: {modes})",
            ko: "\"{channel}\" {delay} 늦음(모드 {modes}개)",
        },
        EarlyBy { channel: String, lead: Quantity, modes: usize } => {
            en: "\"{channel}\" early by {lead} (modes that tell it: {modes})",
            ko: "\"{channel}\" {lead} 빠름(모드 {modes}개)",
        },
        LateByOr { channel: String, delay: Quantity, modes: usize, or: Quantity } => {
            en: "\"{channel}\" late by {delay} (modes that tell it: {modes}; a delay of {or} would explain them too)",
            ko: "\"{channel}\" {delay} 늦음(모드 {modes}개, 지연 {or}로도 설명됨)",
        },
        EarlyByOr { channel: String, lead: Quantity, modes: usize, or: Quantity } => {
            en: "\"{channel}\" early by {lead} (modes that tell it: {modes}; a lead of {or} would explain them too)",
            ko: "\"{channel}\" {lead} 빠름(모드 {modes}개, {or} 빠름으로도 설명됨)",
        },
    }
}

/// Each channel whose clock drifts.
pub(super) fn drifting(all: &[(String, [f64; 2])], sampling_rate_hz: f64) -> Vec<Sentence> {
    let one = |(channel, [ppm, sd]): &(String, [f64; 2])| {
        let rate_hz = sampling_rate_hz * (1.0 + 1e-6 * ppm);
        Clocks::Drifting {
            channel: channel.clone(),
            drift: Quantity {
                sd_si: Some(*sd),
                unit: Unit::si("ppm"),
                ..fixed(*ppm, 1)
            },
            rate: Quantity::new(rate_hz, Unit::si("Hz"), Digits::Fixed(5)),
        }
        .into()
    };
    all.iter().map(one).collect()
}

/// Each channel whose clock is late.
pub(super) fn late(all: &[LateClock]) -> Vec<Sentence> {
    let seconds = |time_s: f64| Quantity::new(time_s, Unit::si("s"), Digits::Fixed(4));
    let one = |clock: &LateClock| {
        let (channel, modes) = (clock.channel.clone(), clock.modes);
        let delay = Quantity {
            sd_si: Some(clock.sd_s),
            ..seconds(clock.delay_s.abs())
        };
        match (clock.delay_s < 0.0, clock.or_s) {
            (false, None) => Clocks::LateBy {
                channel,
                delay,
                modes,
            },
            (false, Some(or_s)) => Clocks::LateByOr {
                channel,
                delay,
                modes,
                or: seconds(or_s),
            },
            (true, None) => Clocks::EarlyBy {
                channel,
                lead: delay,
                modes,
            },
            (true, Some(or_s)) => Clocks::EarlyByOr {
                channel,
                lead: delay,
                modes,
                or: seconds(-or_s),
            },
        }
        .into()
    };
    all.iter().map(one).collect()
}
