//! Notes on the modes of a free decay.

use super::values::{all_hertz, fixed, hertz, percent};
use dolmen::modal::{Decay, ModeDecay};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};

/// Share of the motion explained by the poles below which there is a warning. Our choice.
const EXPLAINED_LEAST: f64 = 0.8;
/// Deviations, relative to white noise, from which there is a note. Our choice: one record of white noise in 20 exceeds 2.
const FAR: f64 = 3.0;
/// Relative distance within which a peak belongs to a mode's frequency. Our choice.
const NEAR: f64 = 0.05;

messages! {
    /// Remarks on a free decay.
    pub(crate) enum Remarks in "modal.decay-remarks" {
        BentOneChannel { mode: Quantity, poles: Values } => {
            en: "The mode at {mode} is no single exponential: poles of one shape at {poles} stand for it. Either its frequency and damping follow the size of its swings, or these are several modes: one channel cannot tell, a second place can; the strongest pole's frequency is shown, and the median damping of its swings where they are clear, without a deviation.",
            ko: "{mode} 모드는 단일 지수감쇠가 아니며 같은 형상의 극점 {poles}이(가) 이를 나타낸다. 진동수와 감쇠비가 진폭에 따라 변하거나 여러 모드이다. 채널 하나로는 구별할 수 없고 다른 위치의 채널이 있으면 구별된다. 진동수는 가장 강한 극점의 값을, 감쇠비는 진폭별 값이 분명하면 그 중앙값을 표준편차 없이 제시하였다.",
        },
        Bent { mode: Quantity, poles: Values } => {
            en: "The mode at {mode} is no single exponential: poles of one shape at {poles} stand for it. Its frequency and damping follow the size of its swings; the strongest pole's frequency is shown, and the median damping of its swings where they are clear, without a deviation.",
            ko: "{mode} 모드는 단일 지수감쇠가 아니며 같은 형상의 극점 {poles}이(가) 이를 나타낸다. 진동수와 감쇠비가 진폭에 따라 변한다. 진동수는 가장 강한 극점의 값을, 감쇠비는 진폭별 값이 분명하면 그 중앙값을 표준편차 없이 제시하였다.",
        },
        DampingFollows { mode: Quantity } => {
            en: "The damping of the mode at {mode} follows the size of its swings, as friction makes it: take it at the size that matters; the one ratio is a mean, without a deviation.",
            ko: "{mode} 모드의 감쇠비는 마찰에서처럼 진폭에 따라 변하므로 관심 있는 진폭의 값을 써야 한다. 하나로 제시한 감쇠비는 평균이며 표준편차가 없다.",
        },
        Hidden { at: Values } => {
            en: "Whether frequency and damping follow the amplitude cannot be told at {at}: too few clear swings, or another mode too near.",
            ko: "{at}에서는 뚜렷한 진동이 너무 적거나 다른 모드가 너무 가까워 진동수와 감쇠비가 진폭에 따르는지 알 수 없다.",
        },
        NotWhite { unexplained: Quantity } => {
            en: "What is left is not white: the structure is still shaken; {unexplained} of the motion is unexplained.",
            ko: "남은 운동이 백색잡음이 아니다. 구조물이 아직 가진되고 있으며 운동의 {unexplained}은(는) 설명되지 않는다.",
        },
        Peaks { peaks: Values, unexplained: Quantity } => {
            en: "What is left is not white, with peaks at {peaks}: the structure is still shaken; {unexplained} of the motion is unexplained.",
            ko: "남은 운동이 백색잡음이 아니며 {peaks}에 피크가 있다. 구조물이 아직 가진되고 있으며 운동의 {unexplained}은(는) 설명되지 않는다.",
        },
        Deviations { said: Sentence, times: Quantity } => {
            en: "{said} Deviations are up to {times} times those in white noise.",
            ko: "{said} 표준편차는 백색잡음에서의 최대 {times}배이다.",
        },
        NoMode { said: Sentence, at: Values } => {
            en: "{said} No mode is shown at {at}: lost in that motion, or a machine.",
            ko: "{said} {at}에서는 모드를 제시하지 않는다. 그 운동에 묻혔거나 기계 진동이다.",
        },
        LittleExplained { explained: Quantity } => {
            en: "Only {explained} of the motion is that of modes which die away: look at the record for noise, a second blow or a recorder at its limit before these numbers are used.",
            ko: "감쇠하는 모드가 설명하는 운동은 {explained}뿐이다. 이 값을 쓰기 전에 잡음, 두 번째 타격, 측정 범위 초과가 없는지 기록을 확인해야 한다.",
        },
    }
}

/// The remarks on a free decay.
pub(crate) fn decay_remarks(decay: &Decay) -> Vec<Sentence> {
    let bent = decay.modes.iter().filter(|mode| mode.poles_hz.len() > 1);
    let mut said: Vec<Remarks> = bent.map(|mode| bent_words(mode, decay.channels)).collect();
    let follows = |mode: &&ModeDecay| mode.damping_follows && mode.poles_hz.len() == 1;
    let following = decay.modes.iter().filter(follows);
    said.extend(following.map(|mode| Remarks::DampingFollows {
        mode: hertz(mode.frequency_hz),
    }));
    let hidden = decay.modes.iter().filter(|mode| mode.swings.is_empty());
    let hidden: Vec<f64> = hidden.map(|mode| mode.frequency_hz).collect();
    if !hidden.is_empty() {
        let at = all_hertz(&hidden);
        said.push(Remarks::Hidden { at });
    }
    said.extend(still_shaken(decay));
    if decay.explained < EXPLAINED_LEAST {
        let explained = percent(decay.explained, 0);
        said.push(Remarks::LittleExplained { explained });
    }
    said.into_iter().map(Sentence::from).collect()
}

fn bent_words(mode: &ModeDecay, channels: usize) -> Remarks {
    let poles = all_hertz(&mode.poles_hz);
    let mode = hertz(mode.frequency_hz);
    match channels {
        1 => Remarks::BentOneChannel { mode, poles },
        _ => Remarks::Bent { mode, poles },
    }
}

/// Finding that the residual has peaks, or the modes' own frequencies: the excitation continues.
fn still_shaken(decay: &Decay) -> Option<Remarks> {
    // the residual of a mode that is not exponential belongs to that mode
    let is_one = |mode: &&ModeDecay| mode.poles_hz.len() == 1 && !mode.damping_follows;
    let over = decay.modes.iter().filter(is_one).map(|mode| mode.over_white);
    let most = over.filter(|times| *times > FAR).fold(0.0, f64::max);
    let of_no_mode = |hz: &f64| {
        let mut poles = decay.modes.iter().flat_map(|mode| &mode.poles_hz);
        poles.all(|pole| (hz / pole - 1.0).abs() > NEAR)
    };
    let lost: Vec<f64> = decay.left_peaks_hz.iter().copied().filter(of_no_mode).collect();
    if most == 0.0 && lost.is_empty() {
        return None;
    }
    let unexplained = percent(1.0 - decay.explained, 2);
    let mut said = match decay.left_peaks_hz.as_slice() {
        [] => Remarks::NotWhite { unexplained },
        peaks => Remarks::Peaks {
            peaks: coarse(peaks),
            unexplained,
        },
    };
    if most > 0.0 {
        said = Remarks::Deviations {
            said: said.into(),
            times: fixed(most, 1),
        };
    }
    if !lost.is_empty() {
        said = Remarks::NoMode {
            said: said.into(),
            at: coarse(&lost),
        };
    }
    Some(said)
}

/// Peaks are known only to the width of a spectral line.
fn coarse(frequency_hz: &[f64]) -> Values {
    let one = |hz: &f64| Quantity::new(*hz, Unit::si("Hz"), Digits::Fixed(2));
    Values(frequency_hz.iter().map(one).collect())
}
