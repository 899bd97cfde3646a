//! What follows the amplitude of a free decay, as text.

use super::Table;
use dolmen::modal::{AtAmplitude, Decay, ModeDecay};
use dolmen_words::Language;

/// Share of the motion that the poles explain below which it is warned. Chosen here.
const EXPLAINED_LEAST: f64 = 0.8;

/// How well the decay is one of linear modes, and each mode at its largest, middle and smallest swings.
pub(super) fn decay_text(decay: &Decay) -> String {
    let mut out = format!(
        "  the poles found explain {:.2} % of the motion [free-decay]\n",
        100.0 * decay.explained
    );
    let mut table = Table::new(
        &[
            "mode, Hz",
            "swings at, s",
            "size",
            "f, Hz",
            "damping, %",
            "± 95 %",
        ],
        1,
    );
    for mode in &decay.modes {
        for at in shown(&mode.swings) {
            table.row(vec![
                format!("{:.3}", mode.frequency_hz),
                format!("{:.2}", at.time_s),
                format!("{:.3e}", at.amplitude),
                format!("{:.4}", at.frequency_hz),
                format!("{:.3}", 100.0 * at.damping_ratio),
                at.half_width_95()
                    .map_or("-".to_owned(), |half| format!("{:.3}", 100.0 * half)),
            ]);
        }
    }
    if decay.modes.iter().any(|mode| !mode.swings.is_empty()) {
        out += "\nBy the size of the swings (logarithmic decrement of the channel that shows most of each mode)\n";
        out += &table.text();
    }
    for sentence in remarks(decay, Language::English) {
        out += &format!("  note: {sentence}\n");
    }
    out
}

/// What must be known beside the modes.
pub(crate) fn remarks(decay: &Decay, language: Language) -> Vec<String> {
    let list = |hz: &[f64]| {
        hz.iter()
            .map(|f| format!("{f:.3}"))
            .collect::<Vec<_>>()
            .join(", ")
    };
    let bent = decay.modes.iter().filter(|mode| mode.poles_hz.len() > 1);
    let mut said: Vec<String> = bent
        .map(|mode| {
            let why = match decay.channels {
                1 => language.pick(
                    "Either its frequency and damping follow the size of its swings, or these are several modes: one channel cannot tell, a second \
                     place can",
                    "진동수와 감쇠비가 진폭에 따라 변하거나 여러 모드이다. 채널 하나로는 구별할 수 없고 다른 위치의 채널이 있으면 구별된다",
                ),
                _ => language.pick(
                    "Its frequency and damping follow the size of its swings",
                    "진동수와 감쇠비가 진폭에 따라 변한다",
                ),
            };
            let (hz, poles) = (mode.frequency_hz, list(&mode.poles_hz));
            language.pick(
                format!(
                    "the mode at {hz:.3} Hz is no single exponential: poles of one shape at {poles} Hz stand for it. {why}; the strongest pole's are \
                     shown without a deviation"
                ),
                format!(
                    "{hz:.3} Hz 모드는 단일 지수감쇠가 아니며 같은 형상의 극점 {poles} Hz가 이를 나타낸다. {why}. 가장 강한 극점의 값을 표준편차 없이 제시하였다"
                ),
            )
        })
        .collect();
    said.extend(decay.modes.iter().filter(|mode| mode.damping_follows && mode.poles_hz.len() == 1).map(|mode| {
        let hz = mode.frequency_hz;
        language.pick(
            format!(
                "the damping of the mode at {hz:.3} Hz follows the size of its swings, as friction makes it: take it at the size that matters; the one \
                 ratio is a mean, without a deviation"
            ),
            format!(
                "{hz:.3} Hz 모드의 감쇠비는 마찰에서처럼 진폭에 따라 변하므로 관심 있는 진폭의 값을 써야 한다. 하나로 제시한 감쇠비는 평균이며 표준편차가 없다"
            ),
        )
    }));
    let of = |mode: &ModeDecay| mode.frequency_hz;
    let hidden: Vec<f64> = decay
        .modes
        .iter()
        .filter(|m| m.swings.is_empty())
        .map(of)
        .collect();
    if !hidden.is_empty() {
        let hz = list(&hidden);
        said.push(language.pick(
            format!("whether frequency and damping follow the amplitude cannot be told at {hz} Hz: too few clear swings, or another mode too near"),
            format!("{hz} Hz에서는 뚜렷한 진동이 너무 적거나 다른 모드가 너무 가까워 진동수와 감쇠비가 진폭에 따르는지 알 수 없다"),
        ));
    }
    said.extend(still_shaken(decay, language));
    if decay.explained < EXPLAINED_LEAST {
        let percent = 100.0 * decay.explained;
        said.push(language.pick(
            format!(
                "only {percent:.0} % of the motion is that of modes which die away: look at the record for noise, a second blow or a recorder at its \
                 limit before these numbers are used"
            ),
            format!(
                "감쇠하는 모드가 설명하는 운동은 {percent:.0} %뿐이다. 이 값을 쓰기 전에 잡음, 두 번째 타격, 측정 범위 초과가 없는지 기록을 확인해야 한다"
            ),
        ));
    }
    said
}

/// That what is left has peaks, or the modes' own frequencies: something goes on.
fn still_shaken(decay: &Decay, language: Language) -> Option<String> {
    const FAR: f64 = 3.0; // deviations over those in white noise that are worth a word; chosen here: above 2 one record of white noise in 20 is
    const NEAR: f64 = 0.05; // of a frequency: a peak of the mode's own; chosen here
    // what a mode that is no exponential leaves is its own
    let one = |mode: &&ModeDecay| mode.poles_hz.len() == 1 && !mode.damping_follows;
    let shaken = decay
        .modes
        .iter()
        .filter(one)
        .filter(|mode| mode.over_white > FAR);
    let most = shaken.map(|mode| mode.over_white).fold(0.0, f64::max);
    let of_no_mode: Vec<String> = decay
        .left_peaks_hz
        .iter()
        .filter(|hz| {
            let mut poles = decay.modes.iter().flat_map(|mode| &mode.poles_hz);
            poles.all(|pole| (*hz / pole - 1.0).abs() > NEAR)
        })
        .map(|hz| format!("{hz:.2}"))
        .collect();
    if most == 0.0 && of_no_mode.is_empty() {
        return None;
    }
    let all: Vec<String> = decay.left_peaks_hz.iter().map(|hz| format!("{hz:.2}")).collect();
    let (all, lost, percent) = (
        all.join(", "),
        of_no_mode.join(", "),
        100.0 * (1.0 - decay.explained),
    );
    let mut said = match all.is_empty() {
        true => language
            .pick("what is left is not white", "남은 운동이 백색잡음이 아니다")
            .to_owned(),
        false => language.pick(
            format!("what is left is not white, with peaks at {all} Hz"),
            format!("남은 운동이 백색잡음이 아니며 {all} Hz에 봉우리가 있다"),
        ),
    };
    said += &language.pick(
        format!(": the structure is still shaken; {percent:.2} % of the motion is unexplained"),
        format!(". 구조물이 아직 가진되고 있으며 운동의 {percent:.2} %는 설명되지 않는다"),
    );
    if most > 0.0 {
        said += &language.pick(
            format!(", and deviations are up to {most:.1} times those in white noise"),
            format!(". 표준편차는 백색잡음에서의 최대 {most:.1}배이다"),
        );
    }
    if !of_no_mode.is_empty() {
        said += &language.pick(
            format!(". No mode is shown at {lost} Hz: lost in that motion, or a machine"),
            format!(". {lost} Hz에서는 모드를 제시하지 않는다. 그 운동에 묻혔거나 기계 진동이다"),
        );
    }
    Some(said)
}

/// The largest, the middle and the smallest.
pub(crate) fn shown(swings: &[AtAmplitude]) -> Vec<AtAmplitude> {
    let mut places = vec![0, swings.len() / 2, swings.len().saturating_sub(1)];
    places.dedup();
    places
        .into_iter()
        .filter_map(|i| swings.get(i).copied())
        .collect()
}
