//! The figures of a study.

use crate::document::{Document, Figure};
use crate::figures::{StudyDrawing, StudyFigure, study_drawings, study_series};
use dolmen_words::{Language, Sentence, messages};
use dolmen_work::study::StudyAnswer;
use std::cell::OnceCell;
use std::rc::Rc;

/// Number of figures of one study on a page; the folder of the study has all. Our choice.
const FIGURES_MOST: usize = 8;

messages! {
    /// Captions.
    pub(crate) enum Drawn in "study.figures" {
        Capacity => { en: "Capacity against an input.", ko: "입력변수에 따른 내진성능." },
        CapacityDots => {
            en: "Each dot is one scan, shown with medians and the 5–95 % range.",
            ko: "점은 증분해석 1건이며, 중앙값과 5–95 % 범위를 함께 표시하였다.",
        },
        Survived => { en: "What failed and what survived.", ko: "붕괴한 경우와 견딘 경우." },
        SurvivedDots => {
            en: "Each dot is one simulation. A structure may survive a stronger motion than one under which it failed.",
            ko: "점은 해석 1회이다. 붕괴한 지진동보다 큰 지진동을 견디기도 한다.",
        },
        Fragility => { en: "Fragility.", ko: "취약도." },
        FragilityBands => {
            en: "Probability of reaching each damage state against peak ground acceleration; bands from resampled motions.",
            ko: "최대지반가속도에 따른 손상상태 도달 확률과 지반운동 재표집에 따른 범위.",
        },
        Growth => { en: "As the shaking grows.", ko: "지반운동 증가에 따른 변화." },
        GrowthOf => {
            en: "Largest over the storeys, or links and joints.",
            ko: "층(또는 부재·접합면) 중 최댓값.",
        },
        Harmonic => { en: "Sticking and moving.", ko: "고착과 움직임." },
        HarmonicShare => {
            en: "Share of the time in which a storey slips, or a joint opens or slips, under a harmonic ground.",
            ko: "조화 지반운동에서 층이 미끄러지거나 접합면이 벌어지거나 미끄러지는 시간의 비율.",
        },
        Release => { en: "Let go from a large displacement.", ko: "큰 변위에서의 자유진동." },
        ReleaseDots => { en: "Each dot is one half-cycle.", ko: "점은 반주기 1회." },
    }
}

/// The first figures; each language is drawn once for all of them.
pub(super) fn section<'a>(document: &mut Document<'a>, answer: &'a StudyAnswer) {
    let english = study_drawings(answer, Language::English);
    let shown: Vec<StudyFigure> = english.iter().map(|drawing| drawing.shows).collect();
    let drawn = Rc::new([OnceCell::from(svgs(english)), OnceCell::new()]);
    for (at, shows) in shown.into_iter().enumerate().take(FIGURES_MOST) {
        let drawn = Rc::clone(&drawn);
        let figure = Figure::drawn(caption(shows), move |language| {
            let all = drawn[language.pick(0, 1)].get_or_init(|| svgs(study_drawings(answer, language)));
            all.get(at).cloned().unwrap_or_default()
        });
        document.charted(figure.with_series(move || study_series(answer, shows)));
    }
}

fn svgs(drawings: Vec<StudyDrawing>) -> Vec<String> {
    let drawings = drawings.into_iter();
    drawings.map(|drawing| drawing.figure.svg).collect()
}

fn caption(shows: StudyFigure) -> Vec<Sentence> {
    let both = match shows {
        StudyFigure::Capacity => [Drawn::Capacity, Drawn::CapacityDots],
        StudyFigure::Survived => [Drawn::Survived, Drawn::SurvivedDots],
        StudyFigure::Fragility => [Drawn::Fragility, Drawn::FragilityBands],
        StudyFigure::Growth => [Drawn::Growth, Drawn::GrowthOf],
        StudyFigure::Harmonic => [Drawn::Harmonic, Drawn::HarmonicShare],
        StudyFigure::Release => [Drawn::Release, Drawn::ReleaseDots],
    };
    both.map(Sentence::from).to_vec()
}
