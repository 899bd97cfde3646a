//! Loose stones: where they come to rest, by each law, and what a motion then does to them.

use crate::document::{
    Block, Cell, Column, Document, Figure, Finding, Table, TextStyle, Tone, document_text, findings_text,
    table_series,
};
use crate::figures::stack_settled;
use crate::simulated::{milli, millimetres, seconds};
use dolmen::blocks::{ContactLaw, LooseEnding, LooseMargin, LooseStones};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::{SettledRun, SettledSimulation};

messages! {
    /// Loose stones.
    pub(crate) enum Settled in "stack-simulation.settled" {
        Head => { en: "Loose stones come to rest", ko: "돌무더기의 안착" },
        HeadOfVariant { variant: String } => {
            en: "Loose stones come to rest: variant “{variant}”",
            ko: "돌무더기의 안착: 대안 ‘{variant}’",
        },
        OfVariant { variant: String, said: Sentence } => {
            en: "Variant “{variant}”: {said}",
            ko: "대안 ‘{variant}’: {said}",
        },
        Springs { ending: Sentence } => { en: "With springs between the stones {ending}", ko: "접촉 스프링 해석: {ending}" },
        Rigid { ending: Sentence } => { en: "With rigid stones {ending}", ko: "강체 접촉 해석: {ending}" },
        Rests { count: usize, block: String, moved: Quantity, turned: Quantity } => {
            en: "all {count} stones come to rest where they lie; '{block}' moves farthest, by {moved} and {turned}.",
            ko: "돌 {count}개가 모두 제자리에 안착한다. 가장 많이 움직인 ‘{block}’의 이동은 {moved}, 회전은 {turned}이다.",
        },
        RestsAlone { block: String, moved: Quantity, turned: Quantity } => {
            en: "'{block}' comes to rest where it lies, after {moved} and {turned}.",
            ko: "‘{block}’이(가) 제자리에 안착한다. 이동은 {moved}, 회전은 {turned}이다.",
        },
        Left { count: usize, block: String, moved: Quantity, turned: Quantity } => {
            en: "{count} of the stones leave their places before all are at rest, '{block}' farthest, by {moved} and {turned}.",
            ko: "돌 {count}개가 자리를 벗어난 뒤에야 모두 멈춘다. 가장 많이 벗어난 ‘{block}’의 이동은 {moved}, 회전은 {turned}이다.",
        },
        LeftOne { block: String, moved: Quantity, turned: Quantity } => {
            en: "'{block}' leaves its place before all are at rest, by {moved} and {turned}.",
            ko: "‘{block}’이(가) 자리를 벗어난 뒤에야 모두 멈춘다. 이동은 {moved}, 회전은 {turned}이다.",
        },
        Moving { block: String, length: Quantity } => {
            en: "'{block}' still moves after {length}: there is no verdict.",
            ko: "{length} 뒤에도 ‘{block}’이(가) 멈추지 않아 판정하지 않는다.",
        },
        Sank { block: String } => {
            en: "'{block}' overlaps what it lies on by more than 5 mm at the end: there is no verdict. Draw the stones closer to where they lie«; for springs, also leave normal_stiffness out».",
            ko: "끝에서 ‘{block}’이(가) 받치는 것과 5 mm 넘게 겹쳐 판정하지 않는다. 돌을 실제 놓인 자리에 더 가깝게 입력한다.« 접촉 스프링 해석에서는 normal_stiffness도 삭제한다.»",
        },
        Lost { length: Quantity } => {
            en: "the run could not be used from {length} on: take the other law, or half the step.",
            ko: "{length} 이후의 해석 결과는 쓸 수 없다. 다른 접촉 모델이나 절반의 시간 간격을 쓴다.",
        },
        UnderSprings { motion: String, ending: Sentence } => { en: "Under {motion}, with springs between the stones {ending}", ko: "{motion}에서 접촉 스프링 해석: {ending}" },
        UnderRigid { motion: String, ending: Sentence } => { en: "Under {motion}, with rigid stones {ending}", ko: "{motion}에서 강체 접촉 해석: {ending}" },
        Same { block: String, distance: Quantity } => {
            en: "Both laws agree: the two places of rest of each stone are at most {distance} apart ('{block}').",
            ko: "두 접촉 모델의 판정이 같다. 돌마다 두 안착 위치의 차이는 최대 {distance}(‘{block}’)이다.",
        },
        Differ { block: String, distance: Quantity } => {
            en: "The two laws differ: '{block}' ends {distance} apart. Where it comes to rest is not certain: draw it closer to where it lies.",
            ko: "두 접촉 모델의 결과가 다르다. ‘{block}’의 두 위치가 {distance} 떨어져 있어 안착 위치가 확실하지 않다. 실제 놓인 자리에 더 가깝게 입력한다.",
        },
        Margin { at: Quantity } => {
            en: "Where they lie the stones begin to move at {at} horizontal, by a limit analysis of their contacts.",
            ko: "접촉의 한계해석에 따르면 돌은 놓인 상태에서 수평 {at}에 움직이기 시작한다.",
        },
        MarginSmall { at: Quantity, least: Quantity } => {
            en: "Where they lie the stones begin to move at {at} horizontal, by a limit analysis of their contacts; “stable” needs {least}.",
            ko: "접촉의 한계해석에 따르면 돌은 놓인 상태에서 수평 {at}에 움직이기 시작한다. ‘안정’은 {least} 이상이다.",
        },
        Balanced => {
            en: "A stone is only balanced where it lies, on an edge or a point: the smallest push topples it. Draw it as it lies.",
            ko: "모서리나 꼭짓점 위에서 균형만 잡은 돌이 있어 아주 작은 힘에도 쓰러진다. 실제 놓인 자세대로 입력한다.",
        },
        MarginUnknown => {
            en: "How far the stones are from motion where they lie is not known: the limit analysis of their contacts gave no answer.",
            ko: "놓인 상태에서 움직이기까지의 여유를 알 수 없다. 접촉의 한계해석이 답을 주지 못하였다.",
        },
        OneLaw => { en: "Only one law gave a result: the other may differ.", ko: "한 접촉 모델의 결과만 있으며 다른 모델의 결과와 다를 수 있다." },
        Scale => {
            en: "stable: by both laws all stones come to rest in their places and begin to move there from 0.02 g on · marginal: below 0.02 g · unstable: by both some leave their places, wherever they come to rest, or a stone is only balanced · unknown: the laws differ, or a run has no end. An earthquake is not in this word.",
            ko: "안정: 두 접촉 모델 모두에서 모든 돌이 제자리에 안착하고 0.02 g 이상에서 움직이기 시작함 · 여유 부족: 0.02 g 미만에서 움직이기 시작함 · 불안정: 모두에서 일부가 자리를 벗어나거나(멈춘 위치와 무관) 균형만 잡은 돌이 있음 · 판정 불가: 두 모델의 결과가 다르거나 해석이 끝나지 않음. 이 판정에 지진은 포함되지 않는다.",
        },
        NoRun => { en: "No run was made.", ko: "해석하지 않았다." },
        LeftOut { law: Sentence, why: String } => {
            en: "No run could be made with {law}: {why}",
            ko: "{law} 해석을 할 수 없었다: {why}",
        },
        SpringsLaw => { en: "springs", ko: "접촉 스프링" },
        RigidLaw => { en: "rigid stones", ko: "강체 접촉" },
        Hulls => {
            en: "Stones touch with their convex hulls, and two stones on one face or edge: hollows are bridged. Stones go down slowly, without swinging, and are then released: a stone that moved by more than half its least thickness, or turned by more than 45°, has left its place.",
            ko: "돌은 볼록 껍질로, 두 돌은 한 면이나 모서리로 맞닿는 것으로 보아 오목한 곳은 메워진다. 돌을 흔들림 없이 천천히 가라앉힌 다음 놓아준다. 최소 두께의 절반 넘게 움직이거나 45° 넘게 돌면 자리를 벗어난 것으로 본다.",
        },
        Drawn => { en: "The stones as drawn, and where they came to rest.", ko: "입력한 돌과 안착한 자리." },
        DrawnMeaning => {
            en: "If all stay in their places, displacements are enlarged by the stated factor.",
            ko: "모두 제자리에 안착하면 변위를 표시한 배율로 확대한다.",
        },
        Caption => { en: "How far each stone goes to rest.", ko: "돌별 안착 이동량." },
        Stone => { en: "stone", ko: "돌" },
        Law => { en: "law", ko: "접촉 모델" },
        Moved => { en: "moved", ko: "이동" },
        Dropped => { en: "downwards", ko: "아래로" },
        Turned => { en: "turned", ko: "회전" },
        Allowed => { en: "leaves its place from", ko: "자리를 벗어나는 이동" },
    }
}

/// The outcome; in full with every stone.
pub fn settled_text(of: &SettledSimulation, style: TextStyle) -> String {
    let found = findings(of);
    if !style.is_full {
        return findings_text(found.iter().filter(|of| of.is_key), style);
    }
    findings_text(&found, style) + &document_text(&sections(of), style)
}

pub(crate) fn sections(of: &SettledSimulation) -> Document<'_> {
    let mut document = Document::default();
    document.heading(match of.variant.clone() {
        Some(variant) => Settled::HeadOfVariant { variant },
        None => Settled::Head,
    });
    if !of.runs.is_empty() {
        let caption = vec![Settled::Drawn.into(), Settled::DrawnMeaning.into()];
        let drawn = Figure::drawn(caption, |language| stack_settled(of, language));
        document.charted(drawn.with_series(|| table_series(&stones(of))));
    }
    document.put(Block::Table(stones(of)));
    document.note(Settled::Hulls);
    document
}

pub(crate) fn findings(of: &SettledSimulation) -> Vec<Finding> {
    let all = findings_of_version(of).into_iter();
    let Some(variant) = &of.variant else {
        return all.collect();
    };
    let named = all.map(|finding| {
        let (variant, said) = (variant.clone(), finding.sentence);
        Finding {
            sentence: Settled::OfVariant { variant, said }.into(),
            ..finding
        }
    });
    named.collect()
}

fn findings_of_version(of: &SettledSimulation) -> Vec<Finding> {
    let mut all: Vec<Finding> = Vec::new();
    for run in &of.runs {
        let ending = ending(of, &run.settled);
        let said: Sentence = match run.law {
            ContactLaw::Springs(_) => Settled::Springs { ending }.into(),
            ContactLaw::Rigid(_) => Settled::Rigid { ending }.into(),
        };
        all.push(Finding::key(tone(&run.settled), said));
        all.extend(under_motion(of, run));
    }
    all.extend(margin(of));
    if of.runs.is_empty() {
        all.push(Finding::key(Tone::Unknown, Settled::NoRun));
    }
    if of.apart().is_some() {
        let tone = match of.laws_differ() {
            true => Tone::Unknown,
            false => Tone::Plain,
        };
        all.push(Finding::key(tone, laws(of)));
    }
    all.extend(of.left_out.iter().map(|refused| {
        let (law, why) = (law_words(&refused.law), refused.why.clone());
        Finding::key(Tone::Warn, Settled::LeftOut { law, why })
    }));
    all.push(Finding::new(Tone::Plain, Settled::Hulls));
    all
}

/// How near to motion the stones rest; `None` unless all rest in their places by every law, and if they are wedged.
fn margin(of: &SettledSimulation) -> Option<Finding> {
    let stood = |run: &SettledRun| run.settled.ending == LooseEnding::Stood;
    if of.runs.is_empty() || !of.runs.iter().all(stood) {
        return None;
    }
    let in_g = |value: f64| Quantity::new(value, Unit::si("g"), Digits::Significant(3));
    let least_g = of.least_margin_g();
    let at = in_g(least_g.unwrap_or_default());
    let said = match of.margin() {
        LooseMargin::Unknown => Settled::MarginUnknown,
        LooseMargin::Balanced => Settled::Balanced,
        LooseMargin::Small => Settled::MarginSmall {
            at,
            least: in_g(LooseStones::MARGINAL_BELOW_G),
        },
        LooseMargin::Enough if least_g.is_some_and(f64::is_infinite) => return None,
        LooseMargin::Enough => Settled::Margin { at },
    };
    let tone = match of.margin() {
        LooseMargin::Enough => Tone::Plain,
        margin => tone_of_margin(margin),
    };
    Some(Finding::key(tone, said))
}

fn tone_of_margin(margin: LooseMargin) -> Tone {
    match margin {
        LooseMargin::Enough => Tone::Good,
        LooseMargin::Small => Tone::Warn,
        LooseMargin::Balanced => Tone::Bad,
        LooseMargin::Unknown => Tone::Unknown,
    }
}

/// Whether the laws agree, for a headline.
pub(crate) fn laws(of: &SettledSimulation) -> Sentence {
    match of.apart() {
        Some(apart) => {
            let (block, distance) = (name(of, apart.block), millimetres(apart.distance_m));
            match of.laws_differ() {
                true => Settled::Differ { block, distance }.into(),
                false => Settled::Same { block, distance }.into(),
            }
        }
        None => Settled::OneLaw.into(),
    }
}

/// The meaning of the words on loose stones.
pub(crate) fn scale() -> Sentence {
    Settled::Scale.into()
}

/// What the motion does to the stones at rest.
fn under_motion(of: &SettledSimulation, run: &SettledRun) -> Option<Finding> {
    let shaken = run.shaken.as_ref()?;
    let motion = of.motion.as_ref()?.motion.name().to_owned();
    let ending = ending(of, shaken);
    let said: Sentence = match run.law {
        ContactLaw::Springs(_) => Settled::UnderSprings { motion, ending }.into(),
        ContactLaw::Rigid(_) => Settled::UnderRigid { motion, ending }.into(),
    };
    Some(Finding::key(tone(shaken), said))
}

fn tone(stones: &LooseStones) -> Tone {
    match stones.ending {
        LooseEnding::Stood => tone_of_margin(stones.margin()),
        LooseEnding::Fell => Tone::Bad,
        LooseEnding::StillMoving { .. } | LooseEnding::Sank { .. } | LooseEnding::Unusable => Tone::Unknown,
    }
}

fn name(of: &SettledSimulation, block: usize) -> String {
    let block = of.drawn.blocks().get(block);
    block.map_or_else(String::new, |block| block.name.clone())
}

fn law_words(law: &ContactLaw) -> Sentence {
    match law {
        ContactLaw::Springs(_) => Settled::SpringsLaw.into(),
        ContactLaw::Rigid(_) => Settled::RigidLaw.into(),
    }
}

fn turned(angle_rad: f64) -> Quantity {
    Quantity::new(angle_rad.to_degrees(), Unit::si("°"), Digits::Significant(3))
}

/// How the stones ended, in a sentence that begins with a small letter.
fn ending(of: &SettledSimulation, stones: &LooseStones) -> Sentence {
    let farthest = stones.farthest();
    let stone = &stones.stones[farthest];
    let (block, moved, turned) = (
        name(of, farthest),
        millimetres(stone.moved_m),
        turned(stone.turned_rad),
    );
    let length = seconds(stones.end_s());
    let ending = match stones.ending {
        LooseEnding::Stood if stones.stones.len() == 1 => Settled::RestsAlone { block, moved, turned },
        LooseEnding::Stood => Settled::Rests {
            count: stones.stones.len(),
            block,
            moved,
            turned,
        },
        LooseEnding::Fell if stones.left().len() == 1 => Settled::LeftOne { block, moved, turned },
        LooseEnding::Fell => Settled::Left {
            count: stones.left().len(),
            block,
            moved,
            turned,
        },
        LooseEnding::StillMoving { block } => Settled::Moving {
            block: name(of, block),
            length,
        },
        LooseEnding::Sank { block } => Settled::Sank {
            block: name(of, block),
        },
        LooseEnding::Unusable => Settled::Lost { length },
    };
    ending.into()
}

/// Every stone by every law.
fn stones(of: &SettledSimulation) -> Table {
    let mut rows = Vec::new();
    for run in &of.runs {
        for (block, stone) in run.settled.stones.iter().enumerate() {
            rows.push(vec![
                Cell::words(Sentence::of_symbol(&name(of, block))),
                Cell::words(law_words(&run.law)),
                Cell::number(millimetres(stone.moved_m)),
                Cell::number(Quantity::new(stone.dropped_m, milli("m"), Digits::Significant(4))),
                Cell::number(turned(stone.turned_rad)),
                Cell::number(millimetres(stone.allowed_m)),
            ]);
        }
    }
    Table {
        caption: vec![Settled::Caption.into()],
        columns: vec![
            Column::words(Settled::Stone),
            Column::words(Settled::Law),
            Column::numbers(Settled::Moved, milli("m")),
            Column::numbers(Settled::Dropped, milli("m")),
            Column::numbers(Settled::Turned, Unit::si("°")),
            Column::numbers(Settled::Allowed, milli("m")),
        ],
        rows,
    }
}
