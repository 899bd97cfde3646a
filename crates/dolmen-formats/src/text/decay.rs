//! What follows the amplitude of a free decay, as text.

use super::Table;
use dolmen::modal::{AtAmplitude, Decay, ModeDecay};

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
    for sentence in remarks(decay) {
        out += &format!("  note: {sentence}\n");
    }
    out
}

/// What must be known beside the modes.
pub(crate) fn remarks(decay: &Decay) -> Vec<String> {
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
                1 => {
                    "Either its frequency and damping follow the size of its swings, or these are several modes: one channel cannot tell, a second \
                     place can"
                }
                _ => "Its frequency and damping follow the size of its swings",
            };
            format!(
                "the mode at {:.3} Hz is no single exponential: poles of one shape at {} Hz stand for it. {why}; the strongest pole's are shown \
                 without a deviation",
                mode.frequency_hz,
                list(&mode.poles_hz)
            )
        })
        .collect();
    said.extend(decay.modes.iter().filter(|mode| mode.damping_follows && mode.poles_hz.len() == 1).map(|mode| {
        format!(
            "the damping of the mode at {:.3} Hz follows the size of its swings, as friction makes it: take it at the size that matters; the one ratio is \
             a mean, without a deviation",
            mode.frequency_hz
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
        said.push(format!(
            "whether frequency and damping follow the amplitude cannot be told at {} Hz: too few clear swings, or another mode too near",
            list(&hidden)
        ));
    }
    said.extend(still_shaken(decay));
    if decay.explained < EXPLAINED_LEAST {
        said.push(format!(
            "only {:.0} % of the motion is that of modes which die away: look at the record for noise, a second blow or a recorder at its \
             limit before these numbers are used",
            100.0 * decay.explained
        ));
    }
    said
}

/// That what is left has peaks, or the modes' own frequencies: something goes on.
fn still_shaken(decay: &Decay) -> Option<String> {
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
    let mut said = match all.is_empty() {
        true => "what is left is not white".to_owned(),
        false => format!("what is left is not white, with peaks at {} Hz", all.join(", ")),
    };
    said += &format!(
        ": the structure is still shaken; {:.2} % of the motion is unexplained",
        100.0 * (1.0 - decay.explained)
    );
    if most > 0.0 {
        said += &format!(", and deviations are up to {most:.1} times those in white noise");
    }
    if !of_no_mode.is_empty() {
        said += &format!(
            ". No mode is shown at {} Hz: lost in that motion, or a machine",
            of_no_mode.join(", ")
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
