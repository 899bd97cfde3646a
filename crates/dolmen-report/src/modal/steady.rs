//! Motion too steady for random forces.

use super::values::{fixed, hertz, percent};
use dolmen::modal::{InSpells, Kurtosis, Tone, ToneOnMode, Wander};
use dolmen_words::{Quantity, Sentence, messages};

messages! {
    /// Peaks and modes caused by machines.
    pub(crate) enum Steady in "modal.steady" {
        Tone { frequency: Quantity, width: Quantity } => {
            en: "{frequency} (width {width})",
            ko: "{frequency}(폭 {width})",
        },
        ToneWithKurtosis { frequency: Quantity, width: Quantity, kurtosis: Sentence } => {
            en: "{frequency} (width {width}, {kurtosis})",
            ko: "{frequency}(폭 {width}, {kurtosis})",
        },
        Mode { frequency: Quantity, kurtosis: Sentence } => {
            en: "{frequency} ({kurtosis})",
            ko: "{frequency}({kurtosis})",
        },
        OnMode { frequency: Quantity, mode: Quantity, strength: Quantity } => {
            en: "{frequency} ({strength} of the power of the mode at {mode})",
            ko: "{frequency}({mode} 모드 세기의 {strength})",
        },
        Wanders { frequency: Quantity, along: Quantity } => {
            en: "{frequency} ({along})",
            ko: "{frequency}({along})",
        },
        InSpells { frequency: Quantity, all: Quantity, quiet: Quantity } => {
            en: "{frequency} ({all} times what is beside it, {quiet} in quiet times)",
            ko: "{frequency}(주변의 {all}배, 조용한 동안 {quiet}배)",
        },
        Kurtosis { kurtosis: Quantity } => { en: "kurtosis {kurtosis}", ko: "첨도 {kurtosis}" },
        Runs { kurtosis: Quantity, share: Quantity } => {
            en: "kurtosis {kurtosis} in the {share} of the record in which it runs",
            ko: "기록 중 가동하는 {share}에서 첨도 {kurtosis}",
        },
    }
}

fn kurtosis_words(of: &Kurtosis) -> Sentence {
    let kurtosis = fixed(of.kurtosis, 2);
    match of.share < 1.0 {
        true => Steady::Runs {
            kurtosis,
            share: percent(of.share, 0),
        },
        false => Steady::Kurtosis { kurtosis },
    }
    .into()
}

/// Motion present only in intervals.
pub(super) fn in_spells_words(of: &InSpells) -> Sentence {
    Steady::InSpells {
        frequency: hertz(of.frequency_hz),
        all: fixed(of.stands_out, 1),
        quiet: fixed(of.stands_out_quiet, 1),
    }
    .into()
}

/// A peak of a machine.
pub(super) fn tone_words(tone: &Tone) -> Sentence {
    let (frequency, width) = (hertz(tone.frequency_hz), hertz(tone.width_hz));
    match &tone.kurtosis {
        None => Steady::Tone { frequency, width },
        Some(of) => Steady::ToneWithKurtosis {
            frequency,
            width,
            kurtosis: kurtosis_words(of),
        },
    }
    .into()
}

/// A mode due to a machine.
pub(super) fn steady_words(of: &Kurtosis) -> Sentence {
    Steady::Mode {
        frequency: hertz(of.frequency_hz),
        kurtosis: kurtosis_words(of),
    }
    .into()
}

/// A mode whose frequency wanders like that of a machine.
pub(super) fn wander_words(of: &Wander) -> Sentence {
    Steady::Wanders {
        frequency: hertz(of.frequency_hz),
        along: Quantity {
            sd_si: Some(of.deviation),
            ..fixed(of.along, 2)
        },
    }
    .into()
}

/// A machine that runs at the frequency of a mode.
pub(super) fn on_mode_words(tone: &ToneOnMode) -> Sentence {
    Steady::OnMode {
        frequency: hertz(tone.frequency_hz),
        mode: hertz(tone.mode_hz),
        strength: percent(tone.strength, 0),
    }
    .into()
}
