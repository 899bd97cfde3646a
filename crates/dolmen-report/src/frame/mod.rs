//! Answers about a frame of rigid storeys: findings, and the sections of its check.

mod columns;
mod findings;
mod modes;
mod notes;
mod slipping;
mod storeys;
mod tenons;

pub(crate) use findings::findings;

use crate::document::{Document, Figure};
use crate::figures::{columns_seen, frame_series, frame_sketch};
use dolmen::structure::{Convention, Frame};
use dolmen_project::{FramePart, Quantity as Input};
use dolmen_words::{Sentence, Template, messages};
use dolmen_work::state::DirectionCheck;

messages! {
    /// The head and figure of the stability of a frame.
    pub(crate) enum Stability in "frame.stability" {
        Head => { en: "Stability", ko: "안정성" },
        Sketch => { en: "The frame as modelled.", ko: "해석 모델." },
        SketchMeaning(springs: Sentence) => {
            en: "Rigid storeys with P-delta; {springs}.",
            ko: "P-델타를 고려한 강체 층 모델; {springs}.",
        },
        OnDrift => { en: "spring on storey drift", ko: "층간변위에 작용하는 스프링" },
        Grounded => {
            en: "spring on displacement from the ground (as printed)",
            ko: "지반 기준 변위에 작용하는 스프링(논문 표기)",
        },
        SameColumns { storey: usize, direction: String } => {
            en: "The columns of storey {storey} hold the same as in direction {direction}.",
            ko: "{storey}층 기둥의 복원력은 {direction} 방향과 같다.",
        },
        Direction(direction: String) => { en: "Direction {direction}", ko: "{direction} 방향" },
    }
}

/// Templates of the sentences on frames.
pub(crate) const TEMPLATES: [&[Template]; 9] = [
    findings::Found::TEMPLATES,
    notes::Loads::TEMPLATES,
    Stability::TEMPLATES,
    storeys::Storeys::TEMPLATES,
    modes::Modes::TEMPLATES,
    slipping::Slipping::TEMPLATES,
    columns::Found::TEMPLATES,
    columns::FreeColumns::TEMPLATES,
    tenons::Tenons::TEMPLATES,
];

/// The sections of a frame.
pub(crate) fn sections<'a>(part: &FramePart, directions: &'a [DirectionCheck]) -> Document<'a> {
    let frame = part.build(&mut Input::nominal).ok();
    let mut document = Document::default();
    document.heading(Stability::Head);
    if let Some(frame) = frame.clone() {
        let names: Vec<Option<String>> = part.storeys.iter().map(|storey| storey.name.clone()).collect();
        let columns = part
            .storeys
            .iter()
            .map(|storey| columns_seen(storey.columns.as_ref()));
        sketch(&mut document, frame, (names, columns.collect()), directions);
    }
    for (at, direction) in directions.iter().enumerate() {
        document.subheading(Stability::Direction(direction.direction.clone()));
        storeys::section(&mut document, &direction.check);
        modes::section(&mut document, frame.clone(), &direction.check);
        if let Some(slipping) = &direction.slipping {
            slipping::section(&mut document, slipping);
        }
        if let Some(tenons) = &direction.tenons {
            tenons::section(&mut document, tenons);
        }
        for columns in &direction.columns {
            // round columns on rigid stones have the same resistance in every direction
            let mut before = directions[..at].iter();
            match before.find(|other| other.columns.contains(columns)) {
                Some(other) => document.note(Stability::SameColumns {
                    storey: columns.storey,
                    direction: other.direction.clone(),
                }),
                None => columns::section(&mut document, columns),
            }
        }
    }
    document
}

fn sketch<'a>(
    document: &mut Document<'a>,
    frame: Frame,
    (names, columns): (Vec<Option<String>>, Vec<usize>),
    directions: &'a [DirectionCheck],
) {
    let springs: Sentence = match frame.convention() {
        Convention::Drift => Stability::OnDrift,
        Convention::Grounded => Stability::Grounded,
    }
    .into();
    let caption = vec![Stability::Sketch.into(), Stability::SketchMeaning(springs).into()];
    // one sketch cannot show margins of several directions
    let known = match directions {
        [one] => one.check.stability.as_ref(),
        _ => None,
    };
    let (of, named) = (frame.clone(), names.clone());
    let sketch = Figure::drawn(caption, move |language| {
        frame_sketch(&frame, (&names, &columns), known, language)
    });
    document.charted(sketch.with_series(move || frame_series(&of, &named)));
}
