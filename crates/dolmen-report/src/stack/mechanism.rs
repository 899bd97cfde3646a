//! Mechanism by which several stones begin to move: opening and sliding joints.

use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::stability::stack::{JointMotion, LimitAnalysisStatus, Mechanism, MovingJoint};
use dolmen::structure::stack::{Body, Stack};
use dolmen_words::message::Run;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::state::StackAnswer;

/// Largest number of joints that a sentence names one by one; the table has all.
const NAMED_MOST: usize = 6;
/// Number that it names where there are more.
const NAMED_OF_MORE: usize = 3;

messages! {
    /// The mechanism of a stack.
    pub(crate) enum Moving in "stack.mechanism" {
        Caption => { en: "The mechanism.", ko: "메커니즘." },
        Falls => {
            en: "The joints at which it falls under its own weight.",
            ko: "자중으로 붕괴할 때 움직이는 접합면.",
        },
        Sways => {
            en: "The joints that move first when it is shaken the way that it bears least.",
            ko: "가장 불리한 방향으로 흔들릴 때 먼저 움직이는 접합면.",
        },
        Joint => { en: "Joint", ko: "접합면" },
        Motion => { en: "motion", ko: "거동" },
        ClosedX => { en: "stays closed at x", ko: "접촉 유지 위치 x" },
        ClosedY => { en: "y", ko: "y" },
        ClosedZ => { en: "z", ko: "z" },
        Between { lower: Sentence, upper: Sentence } => { en: "{lower} – {upper}", ko: "{lower} – {upper}" },
        Ground => { en: "ground", ko: "지반" },
        Name { name: String } => { en: "{name}", ko: "{name}" },
        Opens => { en: "opens", ko: "벌어짐" },
        Slides => { en: "slides", ko: "미끄러짐" },
        Both => { en: "opens and slides", ko: "벌어지며 미끄러짐" },
        Crushes => { en: "crushes", ko: "압괴" },
        CrushAt { joints: Sentence } => { en: "joints crush at {joints}", ko: "압괴하는 접합면은 {joints}" },
        AndCrushAt { others: Sentence, joints: Sentence } => {
            en: "{others}; joints crush at {joints}",
            ko: "{others}, 압괴하는 접합면은 {joints}",
        },
        More { joints: Sentence, more: usize } => { en: "{joints} and {more} more", ko: "{joints} 외 {more}곳" },
        OpenAt { joints: Sentence } => { en: "joints open at {joints}", ko: "벌어지는 접합면은 {joints}" },
        SlideAt { joints: Sentence } => { en: "joints slide at {joints}", ko: "미끄러지는 접합면은 {joints}" },
        OpenAndSlideAt { opening: Sentence, sliding: Sentence } => {
            en: "joints open at {opening} and slide at {sliding}",
            ko: "벌어지는 접합면은 {opening}, 미끄러지는 접합면은 {sliding}",
        },
    }
}

/// Opening and sliding joints, without a full stop. `None` without a mechanism.
pub(super) fn moving(answer: &StackAnswer) -> Option<Sentence> {
    joints_moving(&answer.stack, mechanism(answer))
}

/// The same of a mechanism.
pub(crate) fn joints_moving(stack: &Stack, mechanism: Option<&Mechanism>) -> Option<Sentence> {
    let mechanism = mechanism?;
    let of = |motions: &[JointMotion]| {
        let joints = mechanism.joints.iter();
        let names: Vec<Sentence> = joints
            .filter(|moving| motions.contains(&moving.motion))
            .map(|moving| between(stack, moving))
            .collect();
        match names.len() {
            0 => None,
            count if count > NAMED_MOST => Some(
                Moving::More {
                    joints: listed(&names[..NAMED_OF_MORE]),
                    more: count - NAMED_OF_MORE,
                }
                .into(),
            ),
            _ => Some(listed(&names)),
        }
    };
    let crushing = of(&[JointMotion::Crushes]);
    let others: Option<Sentence> = match (
        of(&[JointMotion::Opens, JointMotion::OpensAndSlides]),
        of(&[JointMotion::Slides, JointMotion::OpensAndSlides]),
    ) {
        (Some(opening), Some(sliding)) => Some(Moving::OpenAndSlideAt { opening, sliding }.into()),
        (Some(joints), None) => Some(Moving::OpenAt { joints }.into()),
        (None, Some(joints)) => Some(Moving::SlideAt { joints }.into()),
        (None, None) => None,
    };
    match (others, crushing) {
        (Some(others), Some(joints)) => Some(Moving::AndCrushAt { others, joints }.into()),
        (None, Some(joints)) => Some(Moving::CrushAt { joints }.into()),
        (others, None) => others,
    }
}

fn mechanism(answer: &StackAnswer) -> Option<&Mechanism> {
    answer.check.analysis.as_ref()?.mechanism.as_ref()
}

/// Every joint of the mechanism, if stones share their load.
pub(super) fn section(document: &mut Document<'_>, answer: &StackAnswer) {
    let Some(found) = mechanism(answer).filter(|_| !answer.check.limits.statically_determinate) else {
        return;
    };
    let status = answer.check.analysis.as_ref().map(|analysis| analysis.status);
    let meaning = match status {
        Some(LimitAnalysisStatus::DoesNotStand) => Moving::Falls,
        Some(LimitAnalysisStatus::Limited(_) | LimitAnalysisStatus::Unlimited) | None => Moving::Sways,
    };
    document.put(Block::Table(Table {
        caption: vec![Moving::Caption.into(), meaning.into()],
        columns: moving_columns(),
        rows: joint_rows(&answer.stack, found),
    }));
}

/// The columns of a table of joints that move.
pub(crate) fn moving_columns() -> Vec<Column> {
    vec![
        Column::words(Moving::Joint),
        Column::words(Moving::Motion),
        Column::numbers(Moving::ClosedX, Unit::si("m")),
        Column::numbers(Moving::ClosedY, Unit::si("m")),
        Column::numbers(Moving::ClosedZ, Unit::si("m")),
    ]
}

pub(crate) fn joint_rows(stack: &Stack, mechanism: &Mechanism) -> Vec<Vec<Cell>> {
    let joints = mechanism.joints.iter();
    joints.map(|moving| row(stack, moving)).collect()
}

fn row(stack: &Stack, moving: &MovingJoint) -> Vec<Cell> {
    let motion = match moving.motion {
        JointMotion::Opens => Moving::Opens,
        JointMotion::Slides => Moving::Slides,
        JointMotion::OpensAndSlides => Moving::Both,
        JointMotion::Crushes => Moving::Crushes,
    };
    let mut cells = vec![Cell::words(between(stack, moving)), Cell::words(motion)];
    // values that differ from 0 only by rounding are 0
    let place =
        |value: f64| Quantity::new((value * 1e6).round() / 1e6 + 0.0, Unit::si("m"), Digits::Fixed(3));
    cells.extend((0..3).map(|axis| Cell::Number(moving.closed_at_m.map(|at| place(at[axis])))));
    cells
}

fn between(stack: &Stack, moving: &MovingJoint) -> Sentence {
    let Some(joint) = stack.joints().get(moving.joint) else {
        return Sentence::of_symbol("–");
    };
    let named = |body: Body| -> Sentence {
        match body {
            Body::Ground => Moving::Ground.into(),
            Body::Block(_) => Moving::Name {
                name: stack.name(body).to_owned(),
            }
            .into(),
        }
    };
    Moving::Between {
        lower: named(joint.lower),
        upper: named(Body::Block(joint.upper)),
    }
    .into()
}

/// One after the other with commas.
fn listed(sentences: &[Sentence]) -> Sentence {
    let mut all = Sentence::of_symbol("");
    for (i, sentence) in sentences.iter().enumerate() {
        let comma = (i > 0).then(|| Run::Text(", ".to_owned()));
        all.english
            .extend(comma.iter().cloned().chain(sentence.english.iter().cloned()));
        all.korean
            .extend(comma.iter().cloned().chain(sentence.korean.iter().cloned()));
    }
    all
}
