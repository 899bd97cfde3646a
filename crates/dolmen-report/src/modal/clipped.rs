//! Modes that the clipping of a channel creates.

use super::values::hertz;
use dolmen::modal::FromClipping;
use dolmen_words::{Quantity, Sentence, messages};

messages! {
    /// Where such a mode comes from.
    pub(crate) enum Clipped in "modal.clipped" {
        Unknown { frequency: Quantity, channel: String } => {
            en: "{frequency} (clipped channel \"{channel}\")",
            ko: "{frequency}(포화된 채널 \"{channel}\")",
        },
        Beside { frequency: Quantity, base: Quantity, channel: String } => {
            en: "{frequency} (beside the mode at {base}, clipped channel \"{channel}\")",
            ko: "{frequency}({base} 모드 옆, 포화된 채널 \"{channel}\")",
        },
        Multiple { frequency: Quantity, times: usize, base: Quantity, channel: String } => {
            en: "{frequency} ({times} × {base}, clipped channel \"{channel}\")",
            ko: "{frequency}({times} × {base}, 포화된 채널 \"{channel}\")",
        },
        Sum { frequency: Quantity, m: usize, a: Quantity, n: usize, b: Quantity, channel: String } => {
            en: "{frequency} ({m} × {a} + {n} × {b}, clipped channel \"{channel}\")",
            ko: "{frequency}({m} × {a} + {n} × {b}, 포화된 채널 \"{channel}\")",
        },
        Difference { frequency: Quantity, m: usize, a: Quantity, n: usize, b: Quantity, channel: String } => {
            en: "{frequency} ({m} × {a} − {n} × {b}, clipped channel \"{channel}\")",
            ko: "{frequency}({m} × {a} − {n} × {b}, 포화된 채널 \"{channel}\")",
        },
    }
}

/// The mode with the frequencies that it comes from.
pub(super) fn from_clipping_words(of: &FromClipping) -> Sentence {
    let (frequency, channel) = (hertz(of.frequency_hz), of.channel.clone());
    let factor = |n: i32| n.unsigned_abs() as usize;
    match of.terms[..] {
        [(1, hz)] => Clipped::Beside {
            frequency,
            base: hertz(hz),
            channel,
        },
        [(n, hz)] => Clipped::Multiple {
            frequency,
            times: factor(n),
            base: hertz(hz),
            channel,
        },
        [(m, a_hz), (n, b_hz)] if m > 0 && n > 0 => Clipped::Sum {
            frequency,
            m: factor(m),
            a: hertz(a_hz),
            n: factor(n),
            b: hertz(b_hz),
            channel,
        },
        [(m, a_hz), (n, b_hz)] => Clipped::Difference {
            frequency,
            m: factor(m),
            a: hertz(a_hz),
            n: factor(n),
            b: hertz(b_hz),
            channel,
        },
        _ => Clipped::Unknown { frequency, channel },
    }
    .into()
}
