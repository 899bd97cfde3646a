//! Processing of a record before its analysis.

use super::values::{plain, seconds};
use dolmen::signal::{LostSpan, Processing};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Steps of the processing.
    pub(crate) enum Steps in "modal.steps" {
        ReadBare { format: String } => {
            en: "read as {format}; the unit is unknown",
            ko: "{format} 형식으로 읽음; 단위 미상",
        },
        Read { format: String, unit: String } => {
            en: "read as {format} in {unit}",
            ko: "{format} 형식으로 읽음, 단위 {unit}",
        },
        LeftOut { channels: Vec<String> } => { en: "left out: {channels}", ko: "제외한 채널: {channels}" },
        Cut { from: Quantity, to: Quantity } => { en: "cut to {from} to {to}", ko: "{from}부터 {to}까지의 구간만 사용" },
        Detrend { degree: usize } => {
            en: "trend removed, polynomial of degree {degree}",
            ko: "추세 제거, {degree}차 다항식",
        },
        LowPass { corner: Quantity, order: usize } => {
            en: "low-pass at {corner}, Butterworth of order {order}, zero phase",
            ko: "저역통과 {corner}, 버터워스 {order}차, 영위상",
        },
        BandPass { low: Quantity, high: Quantity, order: usize } => {
            en: "band-pass {low} to {high}, Butterworth of order {order}, zero phase",
            ko: "대역통과 {low}–{high}, 버터워스 {order}차, 영위상",
        },
        HighPass { corner: Quantity, order: usize } => {
            en: "high-pass at {corner}, Butterworth of order {order}, zero phase",
            ko: "고역통과 {corner}, 버터워스 {order}차, 영위상",
        },
        Matched { component: String, from: Quantity, to: Quantity, damping: Quantity } => {
            en: "{component} matched to a spectrum by wavelets, {from} to {to}, damping {damping}",
            ko: "{component} 성분을 웨이블릿으로 스펙트럼에 부합시킴, 주기 {from}–{to}, 감쇠비 {damping}",
        },
        Decimate { factor: usize } => {
            en: "decimated by {factor} after an anti-alias filter",
            ko: "앨리어싱 방지 필터 후 1/{factor}(으)로 재표본화",
        },
        Scaled { factor: Quantity } => { en: "multiplied by {factor}", ko: "{factor}배" },
        ChannelScaled { channel: String, factor: Quantity } => {
            en: "{channel} multiplied by {factor}",
            ko: "채널 {channel}: {factor}배",
        },
        Interpolated { channel: String, offset: Quantity } => {
            en: "{channel} interpolated onto the times of the others, {offset} of a step beside its own",
            ko: "채널 {channel}: 표본 간격의 {offset}만큼 어긋난 시각을 보간으로 맞춤",
        },
        Resampled { channel: String, from: Quantity, to: Quantity } => {
            en: "{channel} resampled from {from} to {to} after an anti-alias filter",
            ko: "채널 {channel}: 앨리어싱 방지 필터 후 {from}에서 {to}(으)로 재표본화",
        },
        OffsetsLeft { most: Quantity } => {
            en: "times of the channels differ by up to {most} of a step, left so",
            ko: "채널 간 시각 차이 최대 표본 간격의 {most}, 그대로 둠",
        },
        LongestSpan { gaps: Vec<Sentence>, from: Quantity, to: Quantity, kept: Quantity, whole: Quantity } => {
            en: "samples are lost, {gaps}: only the longest whole span is used, {from} to {to}, {kept} of {whole}",
            ko: "표본 누락 {gaps}: 누락이 없는 가장 긴 구간 {from}–{to}만 사용({whole} 중 {kept})",
        },
        Bridged { gaps: Vec<Sentence> } => {
            en: "samples are lost, {gaps}: what lies on either side is used, each by itself",
            ko: "표본 누락 {gaps}: 누락 앞뒤의 구간을 각각 사용",
        },
        FilledGaps { gaps: Vec<Sentence>, samples: usize, share: Quantity } => {
            en: "lost samples filled in by linear prediction: {samples} ({share}), {gaps}",
            ko: "누락 표본 {samples}개({share})를 선형예측으로 보간 {gaps}",
        },
        Gap { lost: Quantity, at: Quantity } => { en: "{lost} (after {at})", ko: "{lost}({at} 이후)" },
        ChannelGap { lost: Quantity, channel: String, at: Quantity } => {
            en: "{lost} ({channel}, after {at})",
            ko: "{lost}({channel}, {at} 이후)",
        },
        MoreGaps { count: usize } => { en: "{count} more", ko: "그 밖의 {count}곳" },
        CommonTime { before: Quantity, after: Quantity } => {
            en: "cut to the time that all channels share: {before} before and {after} after it are gone",
            ko: "모든 채널에 공통인 시간만 사용: 앞 {before}, 뒤 {after} 제외",
        },
        Tapered { each: Quantity } => {
            en: "tapered by half a cosine, {each} at each end",
            ko: "양 끝 {each}에 반코사인 테이퍼 적용",
        },
        Oriented { azimuth: Quantity } => {
            en: "turned so that x points {azimuth} from north",
            ko: "x가 북에서 {azimuth} 방향을 향하도록 회전",
        },
        Rotated { angle: Quantity } => {
            en: "turned by {angle} from x towards y",
            ko: "x에서 y 방향으로 {angle} 회전",
        },
    }
}

pub(super) fn step_words(step: &Processing) -> Sentence {
    let hertz = |hz: f64| Quantity::new(hz, Unit::si("Hz"), Digits::Trimmed(6));
    match step.clone() {
        Processing::Read { format, unit } if unit.is_empty() => Steps::ReadBare { format },
        Processing::Read { format, unit } => Steps::Read { format, unit },
        Processing::LeftOut { channels } => Steps::LeftOut { channels },
        Processing::Cut { from_s, to_s } => Steps::Cut {
            from: seconds(from_s),
            to: seconds(to_s),
        },
        Processing::Detrend { degree } => Steps::Detrend { degree },
        Processing::LowPass { corner_hz, order } => Steps::LowPass {
            corner: hertz(corner_hz),
            order,
        },
        Processing::BandPass {
            low_hz,
            high_hz,
            order,
        } => Steps::BandPass {
            low: hertz(low_hz),
            high: hertz(high_hz),
            order,
        },
        Processing::HighPass { corner_hz, order } => Steps::HighPass {
            corner: hertz(corner_hz),
            order,
        },
        Processing::Matched {
            component,
            damping_ratio,
            period_least_s,
            period_most_s,
        } => Steps::Matched {
            component: component.to_owned(),
            from: seconds(period_least_s),
            to: seconds(period_most_s),
            damping: Quantity::new(damping_ratio, Unit::percent(), Digits::Trimmed(3)),
        },
        Processing::Decimate { factor } => Steps::Decimate { factor },
        Processing::Scaled { factor } => Steps::Scaled {
            factor: plain(factor),
        },
        Processing::ChannelScaled { channel, factor } => Steps::ChannelScaled {
            channel,
            factor: plain(factor),
        },
        Processing::Interpolated {
            channel,
            offset_steps,
        } => Steps::Interpolated {
            channel,
            offset: plain(offset_steps),
        },
        Processing::Resampled {
            channel,
            from_hz,
            to_hz,
        } => Steps::Resampled {
            channel,
            from: hertz(from_hz),
            to: hertz(to_hz),
        },
        Processing::OffsetsLeft { most_steps } => Steps::OffsetsLeft {
            most: plain(most_steps),
        },
        Processing::LongestSpan {
            from_s,
            to_s,
            whole_s,
            gaps,
        } => Steps::LongestSpan {
            gaps: gaps_words(&gaps),
            from: seconds(from_s),
            to: seconds(to_s),
            kept: seconds(to_s - from_s),
            whole: seconds(whole_s),
        },
        Processing::Bridged { gaps } => Steps::Bridged {
            gaps: gaps_words(&gaps),
        },
        Processing::FilledGaps { gaps, samples, share } => Steps::FilledGaps {
            gaps: gaps_words(&gaps),
            samples,
            share: Quantity::new(100.0 * share, Unit::si("%"), Digits::Significant(2)),
        },
        Processing::CommonTime { before_s, after_s } => Steps::CommonTime {
            before: seconds(before_s),
            after: seconds(after_s),
        },
        Processing::Tapered { each_end_s } => Steps::Tapered {
            each: seconds(each_end_s),
        },
        Processing::Oriented { x_azimuth_deg } => Steps::Oriented {
            azimuth: Quantity::new(x_azimuth_deg, Unit::si("°"), Digits::Trimmed(6)),
        },
        Processing::Rotated { angle_rad } => Steps::Rotated {
            angle: Quantity::new(angle_rad.to_degrees(), Unit::si("°"), Digits::Trimmed(6)),
        },
    }
    .into()
}

/// The first gaps, and how many more there are.
fn gaps_words(gaps: &[LostSpan]) -> Vec<Sentence> {
    let one = |gap: &LostSpan| {
        let (lost, at) = (seconds(gap.lost_s), seconds(gap.at_s));
        match gap.channel.clone() {
            None => Steps::Gap { lost, at },
            Some(channel) => Steps::ChannelGap { lost, channel, at },
        }
        .into()
    };
    let mut said: Vec<Sentence> = gaps.iter().take(LostSpan::NAMED_MOST).map(one).collect();
    let count = gaps.len().saturating_sub(LostSpan::NAMED_MOST);
    if count > 0 {
        said.push(Steps::MoreGaps { count }.into());
    }
    said
}
