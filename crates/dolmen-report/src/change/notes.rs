//! Notes on the numbers of a change.

use super::quantities::{hertz, percent, temperature};
use dolmen::assess::ChangeNote;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Unit, Values, messages};
use dolmen_work::told_both;

messages! {
    /// Notes of a comparison.
    pub(crate) enum Noted in "change.notes" {
        NotFitted { frequency: Quantity, why: Both } => {
            en: "No coefficient of temperature could be fitted for the mode at {frequency}, so that its change is not corrected: {why}.",
            ko: "{frequency} 모드는 기온 계수를 추정할 수 없어 변화를 보정하지 않았다. {why}.",
        },
        BeyondTheLine { temperature: Quantity, coldest: Quantity, warmest: Quantity } => {
            en: "{temperature} lies beyond the {coldest} to {warmest} that the coefficients were fitted to: a line need not hold there.",
            ko: "{temperature}은(는) 계수를 추정한 기온 범위 {coldest}–{warmest}을(를) 벗어나므로 직선 관계가 성립하지 않을 수 있다.",
        },
        LineScatters { frequency: Quantity, scatter: Quantity, stated: Quantity } => {
            en: "At {frequency} the earlier surveys lie {scatter} about their line over temperature and state {stated}: the structure may have changed between them, and a change of that size is not seen here.",
            ko: "{frequency}에서 이전 조사들은 기온 직선에서 {scatter} 벗어나지만 각 조사가 제시한 편차는 {stated}이다. 그 사이에 구조물이 변하였을 수 있으며, 그 정도의 변화는 여기서 확인되지 않는다.",
        },
        RisesWithTime { frequency: Quantity, correlation: Quantity } => {
            en: "At {frequency} temperature rises from survey to survey (correlation {correlation}): weather and ageing cannot be told apart, and ageing may have been taken for weather.",
            ko: "{frequency}에서 기온이 조사 순서에 따라 높아진다(상관계수 {correlation}). 기온과 노후화의 영향을 구별할 수 없으며, 노후화를 기온의 영향으로 보았을 수 있다.",
        },
        FallsWithTime { frequency: Quantity, correlation: Quantity } => {
            en: "At {frequency} temperature falls from survey to survey (correlation {correlation}): weather and ageing cannot be told apart, and ageing may have been taken for weather.",
            ko: "{frequency}에서 기온이 조사 순서에 따라 낮아진다(상관계수 {correlation}). 기온과 노후화의 영향을 구별할 수 없으며, 노후화를 기온의 영향으로 보았을 수 있다.",
        },
        OtherShapes(frequencies: Values) => {
            en: "At {frequencies} both surveys have a mode, but with shapes unlike each other, so that it counts as lost and as new: were channels swapped, or sensors turned or moved?",
            ko: "{frequencies}에서는 두 조사에 모두 모드가 있으나 모드형상이 서로 달라, 사라진 모드와 새로운 모드로 처리하였다. 채널이 바뀌었거나 센서의 방향·위치가 달라지지 않았는지 확인이 필요하다.",
        },
        Swapped { first: String, second: String, modes: usize, assurance: Quantity, exchanged: Quantity } => {
            en: "Channels \"{first}\" and \"{second}\" look swapped in one of the surveys: mean MAC of {modes} modes {assurance} as they are, {exchanged} with the two exchanged. The modes are compared as if they were; if so, exchange their names in the project file.",
            ko: "한 조사에서 채널 \"{first}\"와(과) \"{second}\"이(가) 서로 바뀐 것으로 보인다. 모드 {modes}개의 평균 MAC가 그대로는 {assurance}, 둘을 바꾸면 {exchanged}이다. 둘을 바꾸어 모드를 비교하였으며, 바뀐 것이 맞으면 프로젝트 파일에서 두 이름을 바꾼다.",
        },
        Turned { channel: String, modes: usize, assurance: Quantity, turned: Quantity } => {
            en: "Channel \"{channel}\" looks turned round in one of the surveys: mean MAC of {modes} modes {assurance} as they are, {turned} with its sign changed. The modes are compared with the sign changed; if it was, turn its direction round in the project file.",
            ko: "한 조사에서 채널 \"{channel}\"의 방향이 반대로 된 것으로 보인다. 모드 {modes}개의 평균 MAC가 그대로는 {assurance}, 부호를 바꾸면 {turned}이다. 부호를 바꾸어 모드를 비교하였으며, 반대가 맞으면 프로젝트 파일에서 방향을 바꾼다.",
        },
        DirectionsExchanged { modes: usize, likeness: Quantity, exchanged: Quantity } => {
            en: "PROBABLY A SLIP: directions x and y are exchanged in one of the surveys. Both have the same {modes} frequencies; their modes are alike (1 for the same) to {likeness} as they are, and to {exchanged} with x and y exchanged. Correct the directions of the channels, or of the modes, and compare again: what follows is no change of the structure.",
            ko: "입력 오류 의심: 한 조사에서 x, y 방향이 서로 바뀐 것으로 보인다. 두 조사의 고유진동수 {modes}개가 같고, 모드의 유사도(같으면 1)는 그대로는 {likeness}, x와 y를 맞바꾸면 {exchanged}이다. 채널 또는 모드의 방향을 고치고 다시 비교해야 하며, 아래 결과는 구조물의 변화가 아니다.",
        },
        RateRatio { factor: Quantity, before: Quantity, after: Quantity, modes: usize } => {
            en: "PROBABLY A SLIP: the sampling rate of one survey is wrong. All {modes} frequencies are {factor} times what they were, which is the ratio of the rates {before} and {after}. Check «sampling_rate|the sampling rates», or the times in the file, before believing a change.",
            ko: "입력 오류 의심: 한 조사의 샘플링 주파수가 틀린 것으로 보인다. 고유진동수 {modes}개가 모두 이전의 {factor}배이며, 이는 두 조사의 샘플링 주파수({before}, {after})의 비와 같다. 변화로 판단하기 전에 «sampling_rate|샘플링 주파수» 또는 파일의 시각을 확인해야 한다.",
        },
        OneFactor { factor: Quantity, modes: usize } => {
            en: "PROBABLY A SLIP: no mode has a partner, and all {modes} frequencies are {factor} times what they were. Check the sampling rate of a survey, and how its frequencies were counted and written, before believing a change.",
            ko: "입력 오류 의심: 짝을 이룬 모드가 없고, 진동수 {modes}개가 모두 이전의 {factor}배이다. 변화로 판단하기 전에 한 조사의 샘플링 주파수와 진동수를 센 방법·단위를 확인한다.",
        },
        Angular(factor: Quantity) => {
            en: "PROBABLY A SLIP: one survey has angular frequencies (rad/s) where the other has frequencies (Hz): no mode has a partner, and each is {factor} times what it was, which is 2π or its reciprocal. Write Hz, and compare again.",
            ko: "입력 오류 의심: 한 조사는 각진동수(rad/s), 다른 조사는 진동수(Hz)로 적은 것으로 보인다. 짝을 이룬 모드가 없고 모두 이전의 {factor}배이며, 이는 2π 또는 그 역수이다. Hz로 고치고 다시 비교해야 한다.",
        },
        Periods => {
            en: "PROBABLY A SLIP: one survey has periods (s) where the other has frequencies (Hz): no mode has a partner, and the values of one are the reciprocals of those of the other. Write Hz, and compare again.",
            ko: "입력 오류 의심: 한 조사는 주기(s), 다른 조사는 진동수(Hz)로 적은 것으로 보인다. 짝을 이룬 모드가 없고 한 조사의 값이 다른 조사 값의 역수이다. Hz로 고치고 다시 비교해야 한다.",
        },
    }
}

/// A note in words.
pub(super) fn note(note: &ChangeNote) -> Noted {
    let mac = |value: f64| Quantity::new(value, Unit::ratio(), Digits::Fixed(2));
    match note {
        ChangeNote::NotFitted { frequency_hz, why } => Noted::NotFitted {
            frequency: hertz(*frequency_hz),
            why: told_both(&**why),
        },
        ChangeNote::BeyondTheLine {
            temperature_c,
            range_c,
        } => Noted::BeyondTheLine {
            temperature: temperature(*temperature_c),
            coldest: temperature(range_c[0]),
            warmest: temperature(range_c[1]),
        },
        ChangeNote::LineScatters {
            frequency_hz,
            scatter_hz,
            stated_hz,
        } => Noted::LineScatters {
            frequency: hertz(*frequency_hz),
            scatter: percent(scatter_hz / frequency_hz, 2),
            stated: percent(stated_hz / frequency_hz, 2),
        },
        ChangeNote::LineWithTime {
            frequency_hz,
            correlation,
        } => with_time(hertz(*frequency_hz), *correlation),
        ChangeNote::OtherShapes { frequencies_hz } => {
            Noted::OtherShapes(Values(frequencies_hz.iter().copied().map(hertz).collect()))
        }
        ChangeNote::Swapped(swapped) => {
            let [first, second] = swapped.channels.clone();
            Noted::Swapped {
                first,
                second,
                modes: swapped.modes,
                assurance: mac(swapped.assurance),
                exchanged: mac(swapped.exchanged),
            }
        }
        ChangeNote::Turned(turned) => Noted::Turned {
            channel: turned.channel.clone(),
            modes: turned.modes,
            assurance: mac(turned.assurance),
            turned: mac(turned.turned),
        },
        ChangeNote::DirectionsExchanged(found) => Noted::DirectionsExchanged {
            modes: found.modes,
            likeness: mac(found.likeness),
            exchanged: mac(found.exchanged),
        },
        ChangeNote::RateRatio {
            factor,
            rates_hz: [before, after],
            modes,
        } => {
            let rate = |hz: f64| Quantity::new(hz, Unit::si("Hz"), Digits::Trimmed(5));
            Noted::RateRatio {
                factor: Quantity::new(*factor, Unit::ratio(), Digits::Fixed(4)),
                before: rate(*before),
                after: rate(*after),
                modes: *modes,
            }
        }
        ChangeNote::Reciprocals { .. } => Noted::Periods,
        ChangeNote::OneFactor { factor, modes } => {
            let shown = Quantity::new(*factor, Unit::ratio(), Digits::Fixed(3));
            match note.is_angular() {
                true => Noted::Angular(shown),
                false => Noted::OneFactor {
                    factor: shown,
                    modes: *modes,
                },
            }
        }
    }
}

fn with_time(frequency: Quantity, correlation: f64) -> Noted {
    let shown = Quantity::new(correlation, Unit::ratio(), Digits::Fixed(2));
    match correlation > 0.0 {
        true => Noted::RisesWithTime {
            frequency,
            correlation: shown,
        },
        false => Noted::FallsWithTime {
            frequency,
            correlation: shown,
        },
    }
}
