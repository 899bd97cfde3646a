//! What follows the amplitude of a free decay, in the report.

use super::record_words::sentence;
use super::table::{Cell, table};
use crate::text::{decay_remarks, shown_swings};
use dolmen::modal::Decay;
use dolmen_words::Language;
use dolmen_words::number::{fixed, significant};
use maud::{Markup, html};

/// How well the decay is one of linear modes, and each mode at its largest, middle and smallest swings.
pub(super) fn section(decay: &Decay, language: Language) -> Markup {
    let explained = fixed(100.0 * decay.explained, 2);
    let head = [
        language.pick("Mode (Hz)", "모드 (Hz)"),
        language.pick("time (s)", "시각 (s)"),
        language.pick("size of the swings", "진폭"),
        language.pick("frequency (Hz)", "고유진동수 (Hz)"),
        language.pick("damping ratio (%)", "감쇠비 (%)"),
        "± 95 %",
    ]
    .map(str::to_owned);
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    for mode in &decay.modes {
        for at in shown_swings(&mode.swings) {
            rows.push(vec![
                significant(mode.frequency_hz, 4).into(),
                fixed(at.time_s, 2).into(),
                significant(at.amplitude, 3).into(),
                significant(at.frequency_hz, 5).into(),
                significant(100.0 * at.damping_ratio, 3).into(),
                at.half_width_95()
                    .map_or("–".to_owned(), |half| significant(100.0 * half, 2))
                    .into(),
            ]);
        }
    }
    let caption = language.pick(
        "Frequency and damping by the size of the swings. Logarithmic decrement of the channel that shows most of each mode; loose joints show as a frequency that rises while the swings die.",
        "진폭에 따른 고유진동수와 감쇠비. 각 모드가 가장 크게 나타나는 채널의 대수감쇠율이며, 헐거운 접합면은 진폭이 줄면서 진동수가 높아지는 것으로 나타난다.",
    );
    html! {
        p { (language.pick(
            format!("A free decay: the poles found explain {explained} % of the motion."),
            format!("자유감쇠 기록: 찾은 극점이 운동의 {explained} %를 설명한다."),
        )) }
        @if !rows.is_empty() { (table(caption, 1, &head, &rows)) }
        @for remark in decay_remarks(decay, language) { p.note { (sentence(&remark)) } }
    }
}
