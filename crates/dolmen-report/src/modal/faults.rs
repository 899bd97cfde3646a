//! Apparent faults of a channel.

use super::values::{fixed, percent, plain, seconds};
use dolmen::signal::ChannelFault;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Faults of channels.
    pub(crate) enum Faults in "modal.faults" {
        Constant { channel: String, value: Quantity } => {
            en: "Channel \"{channel}\" is dead: every sample is {value}; leave it out, and look at its cable.",
            ko: "채널 \"{channel}\": 신호 없음. 모든 표본이 {value}이다. 제외하고 케이블을 점검해야 한다.",
        },
        Faint { channel: String, deviation: Quantity, typical: Quantity } => {
            en: "Channel \"{channel}\" is dead or in another unit: its standard deviation is {deviation}, the median of its kind is {typical}; leave it out, or correct its unit.",
            ko: "채널 \"{channel}\": 신호가 없거나 단위가 다르다. 표준편차가 {deviation}이나 같은 종류 채널의 중앙값은 {typical}이다. 제외하거나 단위를 바로잡아야 한다.",
        },
        Stuck { channel: String, value: Quantity, from: Quantity, to: Quantity } => {
            en: "Channel \"{channel}\" stands at exactly {value} from {from} to {to} while it moves at other times: a cable that came off, or a pause; cut the record there, or leave the channel out.",
            ko: "채널 \"{channel}\": {from}부터 {to}까지 값이 {value}에 멈춰 있다. 케이블 이탈이나 기록 중단이므로 그 구간을 잘라 내거나 채널을 제외해야 한다.",
        },
        Faded { channel: String, factor: Quantity, from: Quantity, to: Quantity } => {
            en: "Channel \"{channel}\" changes its strength against the others {factor}-fold during the record, least from {from} to {to}: a loose contact; cut the record there, or leave the channel out.",
            ko: "채널 \"{channel}\": 다른 채널에 대한 세기가 기록 중 {factor}배 변한다({from}부터 {to}까지 최소). 접촉 불량이므로 그 구간을 잘라 내거나 채널을 제외해야 한다.",
        },
        Loose { channel: String, factor: Quantity, times: usize, share: Quantity, first: Quantity } => {
            en: "Channel \"{channel}\": its fast motion grows {factor}-fold and falls back, {times} times, in {share} of the record together, first at {first}, and no other channel does so: a loose sensor or cable; look at it.",
            ko: "채널 \"{channel}\": 빠른 성분이 {factor}배 커졌다가 되돌아가기를 {times}회 반복한다(기록의 {share}, 첫 시각 {first}). 다른 채널에는 그런 변화가 없다. 센서 고정이나 케이블 접촉이 불량하므로 점검해야 한다.",
        },
        Alike { channel: String, other: String, correlation: Quantity } => {
            en: "Channels \"{channel}\" and \"{other}\" are almost one signal (correlation of their steps {correlation}): one cable on two inputs, or two sensors at one place.",
            ko: "채널 \"{channel}\"와(과) \"{other}\"의 신호가 거의 같다(증분의 상관계수 {correlation}). 한 케이블이 두 입력에 연결되었거나 두 센서가 같은 위치에 있다.",
        },
        Drifts { channel: String, rise: Quantity } => {
            en: "Channel \"{channel}\" drifts by {rise} times its motion over the record, and low modes and dampings come out wrong: take the line off first«; detrend_degree = 1 does so».",
            ko: "채널 \"{channel}\": 기록 전체에 걸친 표류가 운동의 {rise}배이다. 먼저 직선 추세를 제거해야 하며«(detrend_degree = 1)», 그렇지 않으면 낮은 모드와 감쇠비가 틀리게 된다.",
        },
        OneSpike { channel: String, first: Quantity } => {
            en: "Channel \"{channel}\": 1 single sample stands out of its neighbours by 25 times what is usual, at {first}: it adds noise, and damping comes out wrong; look at the cable.",
            ko: "채널 \"{channel}\": 주변보다 25배 이상 튀는 단일 표본이 1개 있다({first}). 잡음이 되어 감쇠비가 틀리게 되므로 케이블을 점검해야 한다.",
        },
        Spikes { channel: String, count: usize, first: Quantity } => {
            en: "Channel \"{channel}\": {count} single samples stand out of their neighbours by 25 times what is usual, the first at {first}: they add noise, and damping comes out wrong; look at the cable.",
            ko: "채널 \"{channel}\": 주변보다 25배 이상 튀는 단일 표본이 {count}개 있다(첫 위치 {first}). 잡음이 되어 감쇠비가 틀리게 되므로 케이블을 점검해야 한다.",
        },
        Clipped { channel: String, value: Quantity, samples: usize, first: Quantity } => {
            en: "Channel \"{channel}\" is clipped: samples that stand at exactly {value}: {samples}, first at {first}; cut the record to a part within range, or leave the channel out.",
            ko: "채널 \"{channel}\": 포화(클리핑). 표본 {samples}개가 정확히 {value}에 머물며 처음은 {first}이다. 범위 안의 구간만 쓰거나 채널을 제외해야 한다.",
        },
        Duplicated { channel: String, other: String, factor: Quantity } => {
            en: "Channels \"{channel}\" and \"{other}\" hold the same signal (factor {factor}): one cable on two inputs, or one column twice; leave one of them out.",
            ko: "채널 \"{channel}\"와(과) \"{other}\"의 신호가 같다(배율 {factor}). 한 케이블이 두 입력에 연결되었거나 같은 열이 중복되었으므로 하나를 제외해야 한다.",
        },
    }
}

/// The sentence of a fault.
pub(crate) fn fault_words(fault: &ChannelFault) -> Sentence {
    let time = |time_s: f64, decimals| Quantity::new(time_s, Unit::si("s"), Digits::Fixed(decimals));
    match fault.clone() {
        ChannelFault::Constant { channel, value } => Faults::Constant {
            channel,
            value: plain(value),
        },
        ChannelFault::Faint {
            channel,
            deviation,
            typical,
        } => Faults::Faint {
            channel,
            deviation: Quantity::ratio(deviation, 4),
            typical: Quantity::ratio(typical, 4),
        },
        ChannelFault::Stuck {
            channel,
            value,
            from_s,
            to_s,
        } => Faults::Stuck {
            channel,
            value: plain(value),
            from: time(from_s, 2),
            to: time(to_s, 2),
        },
        ChannelFault::Faded {
            channel,
            factor,
            from_s,
            to_s,
        } => Faults::Faded {
            channel,
            factor: fixed(factor, 0),
            from: time(from_s, 0),
            to: time(to_s, 0),
        },
        ChannelFault::Loose {
            channel,
            factor,
            share,
            times,
            first_s,
        } => Faults::Loose {
            channel,
            factor: fixed(factor, 1),
            times,
            share: percent(share, 0),
            first: time(first_s, 0),
        },
        ChannelFault::Alike {
            channel,
            other,
            correlation,
        } => Faults::Alike {
            channel,
            other,
            correlation: fixed(correlation, 6),
        },
        ChannelFault::Drifts { channel, rise } => Faults::Drifts {
            channel,
            rise: fixed(rise, 0),
        },
        ChannelFault::Spikes {
            channel,
            count,
            first_s,
        } => match (count, time(first_s, 2)) {
            (1, first) => Faults::OneSpike { channel, first },
            (count, first) => Faults::Spikes {
                channel,
                count,
                first,
            },
        },
        ChannelFault::Clipped {
            channel,
            value,
            samples,
            first_s,
        } => Faults::Clipped {
            channel,
            value: plain(value),
            samples,
            first: seconds(first_s),
        },
        ChannelFault::Duplicated {
            channel,
            other,
            factor,
        } => Faults::Duplicated {
            channel,
            other,
            factor: fixed(factor, 6),
        },
    }
    .into()
}
