//! Simulated motions of a chain: their outcome, link by link, over time; versions side by side.

use super::side_supports::{in_time, table};
use super::simulation_ending::{
    beyond_small, ending, leans, loads, simulation_findings, tilt_left_out, title, together,
};
use super::simulation_run::{bed_notes, course, run};
use super::simulation_tables::{joints, links, versions};
use crate::document::{Block, Document, Figure, TextStyle, document_text, findings_text};
use crate::figures::ChainPlot;
use crate::limits;
use crate::simulated::{Simulated, capitalised, motion_section, undamped};
use dolmen_words::{Sentence, messages};
use dolmen_work::chain::ChainSimulation;

messages! {
    /// Heads and figures of simulated chains.
    pub(crate) enum Shown in "chain.simulation" {
        Pushed { of: Sentence } => { en: "Simulated push: {of}", ko: "초기 기울기 시뮬레이션: {of}" },
        Versions => { en: "Simulated versions side by side", ko: "시뮬레이션 결과 비교" },
        Rotations => { en: "Rotation of each link from the vertical.", ko: "각 부재의 연직 기준 회전각." },
        RotationsMeaning => {
            en: "Large rotations, up to the fall if there is one.",
            ko: "대회전을 고려하여 전도 시점까지 계산하였다.",
        },
        Openings => { en: "When the joint below each link was open.", ko: "부재 아래 접합면이 벌어진 시각." },
        OpeningsMeaning => {
            en: "Its moment is then half the width of its bed times the weight above it.",
            ko: "이때 접합면 모멘트는 상부 하중과 접합면 폭 절반의 곱이다.",
        },
        Slips => {
            en: "When the joint below each link turned against its friction.",
            ko: "부재 아래 접합면이 마찰을 이기고 회전한 시각.",
        },
        SlipsMeaning => { en: "Between the bands it sticks.", ko: "띠 사이에서는 고착 상태이다." },
        Loop { name: String } => {
            en: "Moment of the joint below ‘{name}’ against its rotation.",
            ko: "‘{name}’ 하부 접합면의 모멘트-회전각 이력곡선.",
        },
        LoopMeaning => {
            en: "Spring and friction; dashpots are not in it.",
            ko: "스프링과 마찰만 나타내며 점성감쇠는 제외하였다.",
        },
    }
}

/// The outcome; in full each link and joint and the energy balance.
pub fn chain_simulation_text(simulation: &ChainSimulation, style: TextStyle) -> String {
    let found = findings_text(&simulation_findings(&[simulation]), style);
    if !style.is_full {
        return found;
    }
    let mut document = Document::default();
    ended(&mut document, simulation);
    details(&mut document, simulation);
    found + &document_text(&document, style)
}

/// One section per simulation, and a comparison of several.
pub(crate) fn simulation_sections<'a>(simulations: &[&'a ChainSimulation]) -> Document<'a> {
    let mut document = Document::default();
    for simulation in simulations {
        ended(&mut document, simulation);
        if let Some((motion, _)) = &simulation.motion {
            motion_section(&mut document, motion);
        }
        details(&mut document, simulation);
    }
    if simulations.len() > 1 {
        document.heading(Shown::Versions);
        document.put(Block::Table(versions(simulations)));
    }
    document
}

fn ended(document: &mut Document<'_>, simulation: &ChainSimulation) {
    let of = title(simulation);
    match simulation.motion {
        Some(_) => document.heading(Simulated::Earthquake(of)),
        None => document.heading(Shown::Pushed { of }),
    }
    let said = capitalised(ending(simulation));
    document.put(match simulation.falls() {
        true => Block::Warning(said),
        false => Block::Paragraph(vec![said]),
    });
    let without = undamped(simulation.undamped.as_ref());
    document
        .blocks
        .extend(without.map(|found| Block::Note(found.sentence)));
    document
        .blocks
        .extend(together(simulation).map(|found| Block::Paragraph(vec![found.sentence])));
    document.blocks.extend(
        leans(simulation)
            .or_else(|| tilt_left_out(simulation))
            .map(|found| Block::Note(found.sentence)),
    );
    document.blocks.extend(
        loads(simulation)
            .into_iter()
            .map(|found| Block::Note(found.sentence)),
    );
    document
        .blocks
        .extend(beyond_small(simulation).map(|found| Block::Warning(found.sentence)));
}

fn details<'a>(document: &mut Document<'a>, simulation: &'a ChainSimulation) {
    document.put(Block::Paragraph(course(simulation)));
    document.put(Block::Table(joints(simulation)));
    document.put(Block::Table(links(simulation)));
    document.blocks.extend(table(simulation).map(Block::Table));
    limits::section(document, &simulation.parts(), None);
    bed_notes(document, simulation);
    let plots = ChainPlot::all(simulation).into_iter();
    for plot in plots.filter(|plot| tells(*plot, simulation)) {
        let drawn = Figure::drawn(caption(plot, simulation), move |language| {
            plot.draw(simulation, language).unwrap_or_default()
        });
        document.charted(drawn.with_series(move || plot.series(simulation)));
    }
    run(document, simulation);
}

/// Whether a figure is informative: the loop of a linear joint is a straight line.
fn tells(plot: ChainPlot, simulation: &ChainSimulation) -> bool {
    let history = &simulation.history;
    match plot {
        ChainPlot::Loop(joint) => {
            history.uplifts.iter().any(|uplift| uplift.joint == joint)
                || history.slips.iter().any(|slip| slip.joint == joint)
        }
        ChainPlot::Ground
        | ChainPlot::Rotations
        | ChainPlot::Openings
        | ChainPlot::Slips
        | ChainPlot::Supports
        | ChainPlot::Energy => true,
    }
}

fn caption(plot: ChainPlot, simulation: &ChainSimulation) -> Vec<Sentence> {
    match plot {
        ChainPlot::Ground => vec![Simulated::Ground.into(), Simulated::GroundMeaning.into()],
        ChainPlot::Rotations => vec![Shown::Rotations.into(), Shown::RotationsMeaning.into()],
        ChainPlot::Loop(joint) => {
            let name = simulation.link(joint).to_owned();
            vec![Shown::Loop { name }.into(), Shown::LoopMeaning.into()]
        }
        ChainPlot::Openings => vec![Shown::Openings.into(), Shown::OpeningsMeaning.into()],
        ChainPlot::Supports => in_time(),
        ChainPlot::Slips => vec![Shown::Slips.into(), Shown::SlipsMeaning.into()],
        ChainPlot::Energy => vec![Simulated::Energy.into(), Simulated::EnergyMeaning.into()],
    }
}
