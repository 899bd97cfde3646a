//! Why a peak of the spectrum is not a mode, with the key of the project file that would accept it.

use super::values::{fixed, hertz, percent};
use dolmen::modal::{Refusal, RefusedPeak};
use dolmen_words::{Quantity, Sentence, messages};

messages! {
    /// What refused a peak.
    pub(crate) enum Refused in "modal.refused" {
        Unsaid { at: Quantity } => { en: "{at}", ko: "{at}" },
        NoPole { at: Quantity } => {
            en: "{at} (no model has a pole there«; order_most raises the highest order»)",
            ko: "{at}(어느 차수의 모델에도 극점이 없다«. order_most로 최대 차수를 올릴 수 있다»)",
        },
        OutOfRange { at: Quantity, low: Quantity, high: Quantity } => {
            en: "{at} (outside of {low} to {high}«; frequency_low_hz and frequency_high_hz set the range»)",
            ko: "{at}(탐색 범위 {low}–{high} 밖이다«. 범위는 frequency_low_hz, frequency_high_hz로 정한다»)",
        },
        TooLight { at: Quantity, damping: Quantity, least: Quantity } => {
            en: "{at} (damping ratio {damping}, below {least}«; damping_least lowers the bound»)",
            ko: "{at}(감쇠비 {damping}이(가) 하한 {least}보다 작다«. damping_least로 하한을 낮출 수 있다»)",
        },
        TooHeavy { at: Quantity, damping: Quantity, most: Quantity } => {
            en: "{at} (damping ratio {damping}, above {most}«; damping_most raises the bound»)",
            ko: "{at}(감쇠비 {damping}이(가) 상한 {most}보다 크다«. damping_most로 상한을 올릴 수 있다»)",
        },
        Complex { at: Quantity, found: Quantity, least: Quantity } => {
            en: "{at} (its channels do not move in or against phase: collinearity {found}, at least {least} is asked)",
            ko: "{at}(채널의 위상이 0° 또는 180°가 아니다: 위상 공선성 {found}, 하한 {least})",
        },
        Scattered { at: Quantity, found: Quantity, most: Quantity } => {
            en: "{at} (its frequency scatters {found} times as much as so long a record explains, at most {most} times is asked; a longer record helps where the structure does not change in it)",
            ko: "{at}(진동수의 산포가 기록 길이로 설명되는 값의 {found}배이다. 상한 {most}배. 구조물이 변하지 않는 동안의 더 긴 기록이면 나아진다)",
        },
        FewOrders { at: Quantity, orders: usize, wanted: usize } => {
            en: "{at} (model orders that show it: {orders}, at least {wanted} are asked«; order_most raises the highest order»)",
            ko: "{at}(나타나는 모델 차수가 {orders}개로 하한 {wanted}개보다 적다«. order_most로 최대 차수를 올릴 수 있다»)",
        },
        SplitsOff { at: Quantity } => { en: "{at} (part of another mode)", ko: "{at}(다른 모드의 일부)" },
        Blend { at: Quantity, damping: Quantity } => {
            en: "{at} (several modes in one, damping ratio {damping})",
            ko: "{at}(여러 모드가 합쳐진 것, 감쇠비 {damping})",
        },
        Narrow { at: Quantity, least: Quantity } => {
            en: "{at} (narrower or steadier than a mode with a damping ratio of {least}«; damping_least lowers the bound»)",
            ko: "{at}(감쇠비 {least}인 모드보다 폭이 좁거나 세기가 일정하다«. damping_least로 하한을 낮출 수 있다»)",
        },
        InSpells { at: Quantity } => {
            en: "{at} (nothing stands there while the structure is quiet)",
            ko: "{at}(구조물이 조용한 동안에는 나타나지 않는다)",
        },
        Clipping { at: Quantity } => { en: "{at} (the clipping of a channel makes it)", ko: "{at}(채널의 포화가 만든 것)" },
        Machine { at: Quantity } => { en: "{at} (a machine)", ko: "{at}(기계 진동)" },
    }
}

/// The peak with its reason.
pub(super) fn refused_words(peak: &RefusedPeak) -> Sentence {
    let at = hertz(peak.frequency_hz);
    match peak.refusal {
        None => Refused::Unsaid { at },
        Some(Refusal::NoPole) => Refused::NoPole { at },
        Some(Refusal::OutOfRange { low_hz, high_hz }) => Refused::OutOfRange {
            at,
            low: hertz(low_hz),
            high: hertz(high_hz),
        },
        Some(Refusal::Damping {
            damping_ratio, least, ..
        }) if damping_ratio < least => Refused::TooLight {
            at,
            damping: percent(damping_ratio, 3),
            least: percent(least, 3),
        },
        Some(Refusal::Damping {
            damping_ratio, most, ..
        }) => Refused::TooHeavy {
            at,
            damping: percent(damping_ratio, 1),
            most: percent(most, 1),
        },
        Some(Refusal::Complex {
            phase_collinearity,
            least,
        }) => Refused::Complex {
            at,
            found: fixed(phase_collinearity, 2),
            least: fixed(least, 2),
        },
        Some(Refusal::Scattered { over_floor, most }) => Refused::Scattered {
            at,
            found: fixed(over_floor, 1),
            most: fixed(most, 1),
        },
        Some(Refusal::FewOrders { orders, wanted }) => Refused::FewOrders { at, orders, wanted },
        Some(Refusal::SplitsOff) => Refused::SplitsOff { at },
        Some(Refusal::Blend { damping_ratio }) => Refused::Blend {
            at,
            damping: percent(damping_ratio, 1),
        },
        Some(Refusal::Machine) => Refused::Machine { at },
        Some(Refusal::Narrow { least }) => Refused::Narrow {
            at,
            least: percent(least, 3),
        },
        Some(Refusal::InSpells) => Refused::InSpells { at },
        Some(Refusal::Clipping) => Refused::Clipping { at },
    }
    .into()
}
