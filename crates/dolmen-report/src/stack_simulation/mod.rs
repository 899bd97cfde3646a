//! Answers about a stack under a motion: its outcome, joint by joint, over time.

mod crushing;
mod ending;
mod findings;
mod laws;
mod repeats;
mod run;
mod settled;
mod sliding;
mod supports;
mod tables;

pub(crate) use findings::findings;
pub(crate) use run::points_a_side;
pub use settled::settled_text;
pub(crate) use settled::{
    findings as settled_findings, laws as settled_laws, scale as settled_scale, sections as settled_sections,
};
pub use supports::supports_text;
pub(crate) use supports::{findings as supports_findings, sections as supports_sections};

use crate::document::{Block, Document, Figure, TextStyle, Tone, document_text, findings_text, table_series};
use crate::figures::{StackPlot, stack_after};
use crate::simulated::{Simulated, capitalised, motion_section};
use dolmen_words::{Sentence, Template, messages};
use dolmen_work::answer::ProjectReport;
use dolmen_work::stack::{StackRuns, StackSimulation};

/// Least yaw of a joint that is drawn, rad: below it is rounding. Our choice.
const YAW_LEAST_RAD: f64 = 1e-6;

messages! {
    /// The head and figures of a simulated stack.
    pub(crate) enum Shown in "stack-simulation" {
        Head => { en: "Simulated earthquake", ko: "지진응답 시뮬레이션" },
        After => { en: "The stack when the run ended.", ko: "해석 종료 시의 적층 구조." },
        AfterMeaning => {
            en: "Colours are the larger of peak opening and peak slip of each joint.",
            ko: "접합면의 색은 최대 벌어짐과 최대 미끄러짐 중 큰 값이다.",
        },
        States => {
            en: "DS1: a joint opened by 0.1 mm or slipped by 0.5 mm. DS2: an offset of 0.5 % of a joint's width, or 10 mm, is left. DS3: 2 % is left, a joint rocked to 0.35 of its slenderness angle, or a stone lies on the brink. DS4: a stone came down.",
            ko: "DS1: 접합면이 0.1 mm 벌어지거나 0.5 mm 미끄러진 상태. DS2: 접합면 폭의 0.5 % 또는 10 mm의 어긋남이 남은 상태. DS3: 2 %의 어긋남이 남거나, 접합면이 세장각의 0.35배까지 흔들리거나, 부재가 떨어지기 직전에 놓인 상태. DS4: 부재가 떨어진 상태.",
        },
        Top => { en: "Displacement of the highest stone.", ko: "최상부 부재의 변위." },
        TopMeaning => { en: "Against the ground, from rest.", ko: "지반에 대한 상대 변위." },
        Opening => { en: "Opening of the joints.", ko: "접합면의 벌어짐." },
        OpeningMeaning => {
            en: "The largest gap at a corner, of the joints that opened most.",
            ko: "모서리의 최대 틈이며, 가장 크게 벌어진 접합면들만 표시하였다.",
        },
        Slip => { en: "Slip of the joints.", ko: "접합면의 미끄러짐." },
        SlipMeaning => {
            en: "Shift at the middle of the joint, of the joints that slipped most.",
            ko: "접합면 중심의 이동량이며, 가장 크게 미끄러진 접합면들만 표시하였다.",
        },
        Yaw => { en: "Yaw of the joints.", ko: "접합면의 비틀림(연직축 회전)." },
        YawMeaning => {
            en: "Turn about the vertical, of the joints that turned most.",
            ko: "연직축에 대한 회전각이며, 가장 크게 회전한 접합면들만 표시하였다.",
        },
    }
}

/// Templates of the sentences on simulated stacks.
pub(crate) const TEMPLATES: [&[Template]; 10] = [
    crushing::Crushed::TEMPLATES,
    ending::Ending::TEMPLATES,
    laws::Laws::TEMPLATES,
    repeats::Repeated::TEMPLATES,
    Shown::TEMPLATES,
    sliding::Slid::TEMPLATES,
    settled::Settled::TEMPLATES,
    supports::InTime::TEMPLATES,
    tables::Tables::TEMPLATES,
    run::Run::TEMPLATES,
];

/// The outcome; in full each joint and the energy balance.
pub fn simulation_text(runs: &StackRuns, style: TextStyle) -> String {
    let found = findings(runs);
    if !style.is_full {
        return findings_text(found.iter().filter(|of| of.is_key), style);
    }
    let mut document = Document::default();
    ended(&mut document, runs);
    details(&mut document, &runs.deciding);
    findings_text(&found, style) + &document_text(&document, style)
}

/// The section of the structure as given, and of its variants.
pub(crate) fn sections(answer: &ProjectReport) -> Document<'_> {
    let mut document = Document::default();
    if let Some(runs) = answer.own_stack_runs() {
        let simulation = &runs.deciding;
        ended(&mut document, runs);
        document.put(Block::Note(Shown::States.into()));
        motion_section(&mut document, &simulation.motion);
        details(&mut document, simulation);
        if let Some(table) = tables::versions(answer) {
            document.put(Block::Table(table));
        }
    }
    document
}

fn ended(document: &mut Document<'_>, runs: &StackRuns) {
    document.heading(Shown::Head);
    let said = capitalised(laws::endings(runs));
    document.put(match findings::tone(&runs.deciding) {
        Tone::Bad => Block::Warning(said),
        Tone::Good | Tone::Warn | Tone::Plain | Tone::Unknown => Block::Paragraph(vec![said]),
    });
    if let Some(finding) = laws::finding(runs) {
        document.put(Block::Paragraph(vec![finding.sentence]));
    }
    laws::section(document, runs);
    sliding::section(document, runs);
    if let Some(repeats) = &runs.repeats {
        document.put(Block::Paragraph(vec![repeats::finding(repeats).sentence]));
    }
}

fn details<'a>(document: &mut Document<'a>, simulation: &'a StackSimulation) {
    let after = Figure::drawn(
        vec![Shown::After.into(), Shown::AfterMeaning.into()],
        |language| stack_after(simulation, language),
    );
    document.charted(after.with_series(|| table_series(&tables::joints(simulation))));
    document.put(Block::Table(tables::joints(simulation)));
    document.paragraph(run::top(simulation));
    let mut joints = simulation.history.joints.iter();
    let turns = joints.any(|joint| joint.peak_yaw_rad > YAW_LEAST_RAD);
    let shown = |plot: &StackPlot| turns || *plot != StackPlot::Yaw;
    for plot in StackPlot::ALL.into_iter().filter(shown) {
        let drawn = Figure::drawn(caption(plot), move |language| {
            plot.draw(simulation, language).unwrap_or_default()
        });
        document.charted(drawn.with_series(move || plot.series(simulation)));
    }
    run::section(document, simulation);
}

fn caption(plot: StackPlot) -> Vec<Sentence> {
    match plot {
        StackPlot::Ground => vec![Simulated::Ground.into(), Simulated::GroundMeaning.into()],
        StackPlot::Top => vec![Shown::Top.into(), Shown::TopMeaning.into()],
        StackPlot::Opening => vec![Shown::Opening.into(), Shown::OpeningMeaning.into()],
        StackPlot::Slip => vec![Shown::Slip.into(), Shown::SlipMeaning.into()],
        StackPlot::Yaw => vec![Shown::Yaw.into(), Shown::YawMeaning.into()],
    }
}
