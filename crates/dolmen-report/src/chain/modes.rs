//! The natural modes of a chain.

use crate::document::Document;
use crate::figures::{ShapePanel, mode_shapes};
use dolmen::assess::ChainCheck;
use dolmen::structure::{Chain, Inertia};
use dolmen_words::{Language, messages};

messages! {
    /// Natural modes.
    pub(crate) enum Modes in "chain.modes" {
        Head => { en: "Natural modes", ko: "고유진동수와 모드형상" },
        Caption => { en: "Natural modes.", ko: "고유모드." },
        CaptionMeaning => {
            en: "Lateral displacement of each link's top, the largest drawn alike; undamped.",
            ko: "각 부재 상단의 횡변위이며 최댓값을 같게 그렸다(비감쇠).",
        },
        ThinRods => {
            en: "Links without a given moment of inertia or breadth are taken as thin rods; this changes frequencies, not stability.",
            ko: "관성모멘트나 폭이 주어지지 않은 부재는 가는 봉으로 보았다. 이는 진동수에만 영향을 주고 안정성에는 영향이 없다.",
        },
        Mode { number: usize } => { en: "mode {number}", ko: "모드 {number}" },
    }
}

/// Shapes of the modes, if there are any.
pub(super) fn section<'a>(document: &mut Document<'a>, chain: Option<Chain>, check: &'a ChainCheck) {
    if check.modes.is_empty() {
        return;
    }
    document.heading(Modes::Head);
    let Some(chain) = chain else { return };
    let thin = chain.links().iter().any(|link| link.inertia == Inertia::ThinRod);
    let caption = vec![Modes::Caption.into(), Modes::CaptionMeaning.into()];
    document.figure(caption, move |language| drawn(&chain, check, language));
    if thin {
        document.note(Modes::ThinRods);
    }
}

fn drawn(chain: &Chain, check: &ChainCheck, language: Language) -> String {
    let tops = chain.links().iter().scan(0.0, |height, link| {
        *height += link.length_m;
        Some(*height)
    });
    let heights: Vec<f64> = tops.collect();
    let panel = |(i, mode)| ShapePanel {
        title: dolmen_words::Sentence::from(Modes::Mode { number: i + 1 }).text(language),
        mode,
        measured: &[],
    };
    let panels: Vec<ShapePanel<'_>> = check.modes.iter().enumerate().map(panel).collect();
    mode_shapes(&heights, &panels, language)
}
