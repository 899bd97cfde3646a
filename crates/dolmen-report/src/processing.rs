//! Processing of a record or a motion, step by step.

use dolmen::signal::{LostSpan, Processing};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// Digits of values from a user, and of times.
const DIGITS: usize = 6;

messages! {
    /// A step; no full stop.
    pub(crate) enum Step in "processing" {
        ReadWithoutUnit(format: String) => {
            en: "read from {format}, unit not given",
            ko: "{format} 파일, 단위 없음",
        },
        Read { format: String, unit: String } => { en: "read from {format}, unit {unit}", ko: "{format} 파일, 단위 {unit}" },
        LeftOut(channels: Vec<String>) => { en: "left out {channels}", ko: "제외한 채널 {channels}" },
        Cut { from: Quantity, to: Quantity } => { en: "cut to {from} … {to}", ko: "{from}–{to} 구간" },
        Mean => { en: "mean removed", ko: "평균 제거" },
        Line => { en: "straight line removed", ko: "선형 추세 제거" },
        Polynomial(degree: usize) => {
            en: "polynomial of degree {degree} removed",
            ko: "{degree}차 다항식 추세 제거",
        },
        LowPass { corner: Quantity, order: usize } => {
            en: "low-pass {corner}, Butterworth of order {order}, zero phase",
            ko: "저역 통과 {corner}, {order}차 버터워스, 영위상",
        },
        BandPass { low: Quantity, high: Quantity, order: usize } => {
            en: "band-pass {low} to {high}, Butterworth of order {order}, zero phase",
            ko: "대역 통과 {low}–{high}, {order}차 버터워스, 영위상",
        },
        HighPass { corner: Quantity, order: usize } => {
            en: "high-pass {corner}, Butterworth of order {order}, zero phase",
            ko: "고역 통과 {corner}, {order}차 버터워스, 영위상",
        },
        Matched { component: String, least: Quantity, most: Quantity, damping: Quantity } => {
            en: "{component} matched to a spectrum by wavelets, {least} to {most}, damping {damping}",
            ko: "{component} 성분을 웨이블릿으로 응답스펙트럼에 부합, 주기 {least}–{most}, 감쇠비 {damping}",
        },
        Scaled(factor: Quantity) => { en: "scaled by {factor}", ko: "{factor}배" },
        Tapered(each_end: Quantity) => {
            en: "tapered by half a cosine, {each_end} at each end",
            ko: "양 끝 {each_end} 반코사인 테이퍼",
        },
        Rotated(angle: Quantity) => { en: "turned by {angle}° from x towards y", ko: "x에서 y로 {angle}° 회전" },
        Oriented(azimuth: Quantity) => {
            en: "turned so that x points {azimuth}° from north",
            ko: "x가 북에서 {azimuth}° 방향을 향하도록 회전",
        },
        Decimated(factor: usize) => { en: "decimated by {factor}", ko: "1/{factor} 재표본화" },
        ChannelScaled { channel: String, factor: Quantity } => {
            en: "{channel} scaled by {factor}",
            ko: "채널 {channel} {factor}배",
        },
        Interpolated { channel: String, offset: Quantity } => {
            en: "{channel} interpolated: its samples lay {offset} of a step beside the times of the others",
            ko: "채널 {channel} 보간: 표본 시각이 다른 채널과 표본 간격의 {offset}만큼 어긋남",
        },
        Resampled { channel: String, from: Quantity, to: Quantity } => {
            en: "{channel} resampled from {from} to {to}, anti-alias filtered",
            ko: "채널 {channel} 재표본화 {from}에서 {to}(앨리어싱 방지 필터 적용)",
        },
        OffsetsLeft(most: Quantity) => {
            en: "times of the channels differ by up to {most} of a step, left so",
            ko: "채널 간 시각 차이 최대 표본 간격의 {most}, 그대로 둠",
        },
        LongestSpan { gaps: Sentence, from: Quantity, to: Quantity, kept: Quantity, whole: Quantity } => {
            en: "samples are lost: {gaps}; only the longest whole span is used, {from} to {to}: {kept} of {whole}",
            ko: "표본 누락 {gaps}; 누락이 없는 가장 긴 구간 {from}–{to}만 사용({whole} 중 {kept})",
        },
        Bridged(gaps: Sentence) => {
            en: "samples are lost: {gaps}; what lies on either side is used, each by itself",
            ko: "표본 누락 {gaps}; 누락 앞뒤의 구간을 각각 사용",
        },
        FilledGaps { gaps: Sentence, samples: usize, share: Quantity } => {
            en: "lost samples filled in by linear prediction: {samples} ({share}), {gaps}",
            ko: "누락 표본 {samples}개({share})를 선형예측으로 보간: {gaps}",
        },
        Gaps(gaps: Vec<Sentence>) => { en: "{gaps}", ko: "{gaps}" },
        GapsAndMore { gaps: Vec<Sentence>, more: usize } => { en: "{gaps} and {more} more", ko: "{gaps} 외 {more}곳" },
        Gap { lost: Quantity, at: Quantity } => { en: "{lost} after {at}", ko: "{at} 이후 {lost}" },
        GapOf { lost: Quantity, at: Quantity, channel: String } => {
            en: "{lost} after {at} ({channel})",
            ko: "{at} 이후 {lost}({channel})",
        },
        CommonTime { before: Quantity, after: Quantity } => {
            en: "cut to the time that all channels share: {before} before it and {after} after it are gone",
            ko: "모든 채널에 공통인 시간만 사용: 앞 {before}, 뒤 {after} 제외",
        },
    }
}

fn trimmed(value: f64, unit: &str) -> Quantity {
    Quantity::new(value, Unit::si(unit), Digits::Trimmed(DIGITS))
}

/// One processing step of a motion or record.
pub(crate) fn step(of: &Processing) -> Sentence {
    let said = match of {
        Processing::Read { format, unit } if unit.is_empty() => Step::ReadWithoutUnit(format.clone()),
        Processing::Read { format, unit } => Step::Read {
            format: format.clone(),
            unit: unit.clone(),
        },
        Processing::LeftOut { channels } => Step::LeftOut(channels.clone()),
        Processing::Cut { from_s, to_s } => Step::Cut {
            from: trimmed(*from_s, "s"),
            to: trimmed(*to_s, "s"),
        },
        Processing::Detrend { degree: 0 } => Step::Mean,
        Processing::Detrend { degree: 1 } => Step::Line,
        Processing::Detrend { degree } => Step::Polynomial(*degree),
        Processing::LowPass { corner_hz, order } => Step::LowPass {
            corner: trimmed(*corner_hz, "Hz"),
            order: *order,
        },
        Processing::BandPass {
            low_hz,
            high_hz,
            order,
        } => Step::BandPass {
            low: trimmed(*low_hz, "Hz"),
            high: trimmed(*high_hz, "Hz"),
            order: *order,
        },
        Processing::HighPass { corner_hz, order } => Step::HighPass {
            corner: trimmed(*corner_hz, "Hz"),
            order: *order,
        },
        Processing::Matched {
            component,
            damping_ratio,
            period_least_s,
            period_most_s,
        } => Step::Matched {
            component: (*component).to_owned(),
            least: trimmed(*period_least_s, "s"),
            most: trimmed(*period_most_s, "s"),
            damping: Quantity::new(*damping_ratio, Unit::percent(), Digits::Trimmed(DIGITS)),
        },
        Processing::Scaled { factor } => Step::Scaled(trimmed(*factor, "")),
        Processing::Tapered { each_end_s } => Step::Tapered(trimmed(*each_end_s, "s")),
        Processing::Rotated { angle_rad } => Step::Rotated(trimmed(angle_rad.to_degrees(), "")),
        Processing::Oriented { x_azimuth_deg } => Step::Oriented(trimmed(*x_azimuth_deg, "")),
        Processing::Decimate { factor } => Step::Decimated(*factor),
        Processing::ChannelScaled { channel, factor } => Step::ChannelScaled {
            channel: channel.clone(),
            factor: trimmed(*factor, ""),
        },
        Processing::Interpolated {
            channel,
            offset_steps,
        } => Step::Interpolated {
            channel: channel.clone(),
            offset: trimmed(*offset_steps, ""),
        },
        Processing::Resampled {
            channel,
            from_hz,
            to_hz,
        } => Step::Resampled {
            channel: channel.clone(),
            from: trimmed(*from_hz, "Hz"),
            to: trimmed(*to_hz, "Hz"),
        },
        Processing::OffsetsLeft { most_steps } => Step::OffsetsLeft(trimmed(*most_steps, "")),
        Processing::LongestSpan {
            from_s,
            to_s,
            whole_s,
            gaps,
        } => Step::LongestSpan {
            gaps: lost(gaps).into(),
            from: trimmed(*from_s, "s"),
            to: trimmed(*to_s, "s"),
            kept: trimmed(to_s - from_s, "s"),
            whole: trimmed(*whole_s, "s"),
        },
        Processing::Bridged { gaps } => Step::Bridged(lost(gaps).into()),
        Processing::FilledGaps { gaps, samples, share } => Step::FilledGaps {
            gaps: lost(gaps).into(),
            samples: *samples,
            share: trimmed(100.0 * share, "%"),
        },
        Processing::CommonTime { before_s, after_s } => Step::CommonTime {
            before: trimmed(*before_s, "s"),
            after: trimmed(*after_s, "s"),
        },
    };
    said.into()
}

/// The first gaps, and how many more there are.
fn lost(all: &[LostSpan]) -> Step {
    let gaps = all
        .iter()
        .take(LostSpan::NAMED_MOST)
        .map(|gap| gap_words(gap).into());
    let gaps = gaps.collect();
    match all.len().saturating_sub(LostSpan::NAMED_MOST) {
        0 => Step::Gaps(gaps),
        more => Step::GapsAndMore { gaps, more },
    }
}

fn gap_words(gap: &LostSpan) -> Step {
    let (lost, at) = (trimmed(gap.lost_s, "s"), trimmed(gap.at_s, "s"));
    match &gap.channel {
        None => Step::Gap { lost, at },
        Some(channel) => Step::GapOf {
            lost,
            at,
            channel: channel.clone(),
        },
    }
}
