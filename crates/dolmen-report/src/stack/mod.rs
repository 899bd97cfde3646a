//! Answers about a stack of stones: findings, and the sections of its check.

mod beside;
mod crushing;
mod findings;
mod frequencies;
mod frequency_by_height;
mod lean;
mod limits;
mod local_mechanisms;
mod mechanism;
mod narrow_beds;
mod notes;
mod soil;
mod standing;
mod supports;
mod variants;
mod verdict;
mod words;

pub(crate) use beside::beside;
pub(crate) use findings::findings;
pub(crate) use lean::lean;
pub(crate) use mechanism::{joint_rows, joints_moving, moving_columns};
pub(crate) use notes::widest;
pub(crate) use supports::movements;
pub(crate) use variants::comparison;
pub(crate) use verdict::{banner, thresholds};
pub(crate) use words::{direction, megapascals, place};

use crate::document::{Document, Figure};
use crate::figures::{
    Shaking, direction_series, stack_capacity, stack_directions, stack_governing, stack_view, stone_series,
};
use dolmen_project::Structure;
use dolmen_words::{Sentence, Template, messages};
use dolmen_work::answer::ProjectReport;
use dolmen_work::state::{SpringFit, StackAnswer};
use std::collections::BTreeSet;

messages! {
    /// The head and figures of a stack.
    pub(crate) enum Drawn in "stack" {
        Head => { en: "The stack and the limits of its joints", ko: "적층 구조와 접합면의 한계" },
        Model => { en: "The stack as modelled.", ko: "해석 모델." },
        ModelParts { blocks: Sentence, joints: Sentence } => {
            en: "{blocks}, {joints}; to scale, seen from the front right.",
            ko: "{blocks}, {joints}; 축척에 맞게 오른쪽 앞에서 본 모습.",
        },
        Block => { en: "1 block", ko: "블록 1개" },
        Blocks { count: usize } => { en: "{count} blocks", ko: "블록 {count}개" },
        Joint => { en: "1 joint", ko: "접합면 1개" },
        Joints { count: usize } => { en: "{count} joints", ko: "접합면 {count}개" },
        Governing => { en: "What governs each joint.", ko: "접합면별 지배 거동." },
        GoverningMeaning => {
            en: "Points on the slope rock first, points on the level slide first. B/H is the slope from the centroid of what stands on the joint to its nearer edge.",
            ko: "경사선 위의 점은 로킹이, 수평선 위의 점은 미끄러짐이 먼저 일어난다. B/H는 접합면 상부의 무게중심에서 가까운 모서리까지의 기울기이다.",
        },
        Capacity => {
            en: "Capacity of each joint alone, lowest at the bottom; several stones may move together before (table above).",
            ko: "접합면별 거동 시작 가속도(아래가 최하단). 여러 부재가 함께 더 일찍 움직일 수 있다(위의 표).",
        },
        CapacityTinted => {
            en: "In the tinted part the ground alone moves it.",
            ko: "바탕색 범위에서는 지반 가속도만으로 움직인다.",
        },
        CapacityElastic => {
            en: "Elastic joints amplify what the ground does; a line shows it for the joint that moves first on them.",
            ko: "탄성 접합면은 지반 가속도를 증폭시키며, 이를 고려할 때 가장 먼저 움직이는 접합면에 대한 값을 선으로 표시한다.",
        },
        Directions => { en: "Limits by direction.", ko: "방향별 한계." },
        DirectionsMeaning => {
            en: "Acceleration of the stones at which some joint opens, in each direction of the plan; the ground accelerates the other way. The circle of sliding is its least value.",
            ko: "평면의 각 방향에서 접합면이 벌어지기 시작하는 부재의 가속도(지반 가속도는 반대 방향). 미끄러짐의 원은 최솟값이다.",
        },
    }
}

/// Templates of the sentences on stacks.
pub(crate) const TEMPLATES: [&[Template]; 18] = [
    verdict::Judged::TEMPLATES,
    findings::Found::TEMPLATES,
    narrow_beds::Narrow::TEMPLATES,
    lean::Leaning::TEMPLATES,
    standing::Reason::TEMPLATES,
    notes::Notes::TEMPLATES,
    crushing::Crushes::TEMPLATES,
    words::Words::TEMPLATES,
    Drawn::TEMPLATES,
    limits::Limits::TEMPLATES,
    mechanism::Moving::TEMPLATES,
    local_mechanisms::Local::TEMPLATES,
    soil::OnSoil::TEMPLATES,
    supports::Supports::TEMPLATES,
    beside::Beside::TEMPLATES,
    frequencies::Frequencies::TEMPLATES,
    frequency_by_height::ByHeight::TEMPLATES,
    variants::Variants::TEMPLATES,
];

/// The ground motion in the figures: the site demand, and the peak of the simulated motion.
pub(crate) fn peak_g(whole: &ProjectReport, answer: &StackAnswer) -> Shaking {
    let demand = whole.state().and_then(|state| state.demand.as_ref());
    let gravity_m_s2 = answer.stack.gravity_m_s2();
    let site = demand.map(|demand| {
        Shaking::of_site(
            &demand.site,
            demand.stack.as_ref(),
            &answer.check.limits,
            gravity_m_s2,
        )
    });
    Shaking {
        motion: whole.stack_simulation().map(|run| run.peak_horizontal_g()),
        ..site.unwrap_or_default()
    }
}

/// The sections of a stack; `shaking` is the ground motion.
pub(crate) fn sections<'a>(
    structure: &Structure,
    answer: &'a StackAnswer,
    fits: &[SpringFit],
    shaking: Shaking,
) -> Document<'a> {
    let check = &answer.check;
    let mut document = Document::default();
    document.heading(Drawn::Head);
    let model = Figure::drawn(vec![Drawn::Model.into(), parts(answer).into()], |language| {
        stack_view(&answer.stack, language)
    });
    document.charted(model.with_series(|| stone_series(&answer.stack)));
    limits::section(&mut document, check);
    mechanism::section(&mut document, answer);
    if is_cut_through(answer) {
        by_joints(&mut document, answer, shaking);
    }
    directions(&mut document, answer, shaking);
    supports::section(&mut document, answer);
    frequencies::section(&mut document, structure, answer, fits);
    frequency_by_height::section(&mut document, answer);
    local_mechanisms::section(&mut document, answer);
    document
}

/// Whether at least half of the joints are in cuts through the whole stack. In an arch hardly any are, and its cuts do not describe its motion.
fn is_cut_through(answer: &StackAnswer) -> bool {
    let cuts = answer.check.limits.cuts.iter();
    let joints: BTreeSet<usize> = cuts.flat_map(|of| of.cut.joints.iter().copied()).collect();
    2 * joints.len() >= answer.stack.joints().len()
}

/// The resistance of each joint.
fn by_joints<'a>(document: &mut Document<'a>, answer: &'a StackAnswer, shaking: Shaking) {
    let check = &answer.check;
    let caption = vec![Drawn::Governing.into(), Drawn::GoverningMeaning.into()];
    let governing = Figure::drawn(caption, move |language| {
        stack_governing(&check.limits, &shaking, language)
    });
    document.charted(governing.with_series(|| limits::series(check)));
    let mut caption = vec![Drawn::Capacity.into()];
    caption.extend(shaking.ground_g().map(|_| Drawn::CapacityTinted.into()));
    caption.extend(shaking.site_by_modes.map(|_| Drawn::CapacityElastic.into()));
    let capacity = Figure::drawn(caption, move |language| {
        stack_capacity(&check.limits, &shaking, language)
    });
    document.charted(capacity.with_series(|| limits::series(check)));
}

fn parts(answer: &StackAnswer) -> Drawn {
    let blocks = match answer.stack.blocks().len() {
        1 => Drawn::Block,
        count => Drawn::Blocks { count },
    };
    let joints = match answer.stack.joints().len() {
        1 => Drawn::Joint,
        count => Drawn::Joints { count },
    };
    Drawn::ModelParts {
        blocks: blocks.into(),
        joints: joints.into(),
    }
}

fn directions<'a>(document: &mut Document<'a>, answer: &'a StackAnswer, shaking: Shaking) {
    let (limits, gravity_m_s2) = (&answer.check.limits, answer.stack.gravity_m_s2());
    let draw = move |language| stack_directions(limits, &shaking, gravity_m_s2, language);
    if draw(dolmen_words::Language::English).is_some() {
        let caption = vec![Drawn::Directions.into(), Drawn::DirectionsMeaning.into()];
        let drawn = Figure::drawn(caption, move |language| draw(language).unwrap_or_default());
        document.charted(drawn.with_series(move || direction_series(limits, gravity_m_s2)));
    }
}
