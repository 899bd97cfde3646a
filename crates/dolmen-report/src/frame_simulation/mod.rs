//! Simulated motions of a frame: their outcome, storey by storey, over time.

mod beside;
mod ending;
mod friction;
mod run;
mod split;
mod storeys;
mod tenons;
mod title;

pub(crate) use ending::findings;

use crate::document::{Block, Document, Figure, TextStyle, document_text, findings_text};
use crate::figures::FramePlot;
use crate::limits;
use crate::simulated::{Simulated, capitalised, motion_section, undamped};
use dolmen::dynamics::FrameOutcome;
use dolmen_words::{Sentence, Template, messages};
use dolmen_work::frame::FrameSimulation;

messages! {
    /// Figures of simulated frames.
    pub(crate) enum Shown in "frame.simulation" {
        Levels => { en: "Displacement at the top of each storey.", ko: "각 층 상단의 변위." },
        LevelsMeaning => { en: "Against the ground.", ko: "지반에 대한 상대 변위." },
        Columns => {
            en: "Rotation of the columns, the frame on them alone.",
            ko: "기둥만으로 거동할 때의 기둥 회전각.",
        },
        ColumnsMeaning => {
            en: "Rigid columns that rock on rigid stones, without joints and walls; it falls beyond atan(b/h).",
            ko: "접합부와 벽체 없이 강체 초석 위에서 흔들리는 강체 기둥이며, atan(b/h)를 넘으면 전도된다.",
        },
        Path(name: String) => { en: "Drift of ‘{name}’ in plan.", ko: "‘{name}’의 평면상 층간변위." },
        PathMeaning => {
            en: "Both directions together, at the samples; the circle is the largest resultant.",
            ko: "두 방향을 합한 표본별 값이며 원은 최대 합성값이다.",
        },
        Slips => { en: "When the joints of each storey slipped.", ko: "층별 미끄러짐 시각." },
        SlipsMeaning => { en: "Between the bands they stick.", ko: "띠 사이에서는 고착 상태이다." },
        Loop(name: String) => {
            en: "Force of ‘{name}’ against its drift.",
            ko: "‘{name}’의 층 전단력-층간변위 이력곡선.",
        },
        LoopMeaning => {
            en: "The area within is what friction, crushing and damping take.",
            ko: "둘러싸인 면적이 마찰·압괴·감쇠로 소산된 에너지이다.",
        },
    }
}

/// Templates of the sentences on simulated frames.
pub(crate) const TEMPLATES: [&[Template]; 9] = [
    beside::Beside::TEMPLATES,
    ending::Ending::TEMPLATES,
    Shown::TEMPLATES,
    storeys::Storeys::TEMPLATES,
    friction::Friction::TEMPLATES,
    run::Run::TEMPLATES,
    split::Split::TEMPLATES,
    tenons::Tenons::TEMPLATES,
    title::Title::TEMPLATES,
];

/// The outcome of every direction; in full each storey and the energy balance.
pub fn frame_simulations_text(simulations: &[&FrameSimulation], style: TextStyle) -> String {
    let found = ending::of_versions(simulations);
    let each = simulations.iter().zip(&found).map(|(simulation, found)| {
        let found = findings_text(found, style);
        if !style.is_full {
            return found;
        }
        let mut document = Document::default();
        outcome(&mut document, simulation);
        details(&mut document, simulation);
        found + &document_text(&document, style)
    });
    each.collect()
}

/// One section per simulation.
pub(crate) fn sections<'a>(simulations: &[&'a FrameSimulation]) -> Document<'a> {
    let mut document = Document::default();
    for simulation in simulations {
        outcome(&mut document, simulation);
        notes(&mut document, simulation);
        motion_section(&mut document, &simulation.motion);
        details(&mut document, simulation);
    }
    document
}

fn outcome(document: &mut Document<'_>, simulation: &FrameSimulation) {
    document.heading(Simulated::Earthquake(title::title(simulation)));
    let said = capitalised(ending::ending(simulation));
    document.put(match simulation.history.outcome {
        FrameOutcome::DriftLimit { .. } => Block::Warning(said),
        FrameOutcome::Finished | FrameOutcome::Stopped { .. } => {
            Block::Paragraph(std::iter::once(said).chain(ending::state(simulation)).collect())
        }
    });
}

/// What a page says behind the outcome; in the terminal it is among the findings.
fn notes(document: &mut Document<'_>, simulation: &FrameSimulation) {
    let without = undamped(simulation.undamped.as_ref());
    let without = without
        .into_iter()
        .chain(ending::columns(simulation))
        .chain(ending::leans(simulation))
        .chain(ending::tilt_left_out(simulation))
        .chain(ending::loads(simulation))
        .chain(ending::together(simulation))
        .chain(tenons::findings(simulation));
    document
        .blocks
        .extend(without.map(|found| Block::Note(found.sentence)));
}

fn details<'a>(document: &mut Document<'a>, simulation: &'a FrameSimulation) {
    document.put(Block::Table(storeys::model(simulation)));
    friction::notes(document, &simulation.frame);
    document.put(Block::Table(storeys::response(simulation)));
    document
        .blocks
        .extend(tenons::table(simulation).map(Block::Table));
    if let Some(of) = simulation.beside.as_ref().filter(|of| !of.sensors.is_empty()) {
        document.put(Block::Table(beside::table(of)));
    }
    document
        .blocks
        .extend(storeys::together(simulation).map(Block::Table));
    limits::section(document, &simulation.parts(), simulation.drift_limit.as_ref());
    for plot in FramePlot::all(simulation) {
        let drawn = Figure::drawn(caption(plot, simulation), move |language| {
            plot.draw(simulation, language).unwrap_or_default()
        });
        document.charted(drawn.with_series(move || plot.series(simulation)));
    }
    run::run(document, simulation);
}

/// The storey with the largest resultant drift ratio.
fn worst(simulation: &FrameSimulation) -> String {
    let together = simulation.together_once();
    let storey = together.and_then(|of| simulation.storeys.get(of.worst));
    storey.cloned().unwrap_or_default()
}

fn caption(plot: FramePlot, simulation: &FrameSimulation) -> Vec<Sentence> {
    match plot {
        FramePlot::Ground => vec![Simulated::Ground.into(), Simulated::GroundMeaning.into()],
        FramePlot::Levels => vec![Shown::Levels.into(), Shown::LevelsMeaning.into()],
        FramePlot::Columns => vec![Shown::Columns.into(), Shown::ColumnsMeaning.into()],
        FramePlot::Loop(storey) => {
            let name = simulation.storeys.get(storey).cloned().unwrap_or_default();
            vec![Shown::Loop(name).into(), Shown::LoopMeaning.into()]
        }
        FramePlot::Measured(sensor) => beside::caption(simulation, sensor),
        FramePlot::Path => vec![Shown::Path(worst(simulation)).into(), Shown::PathMeaning.into()],
        FramePlot::Slips => vec![Shown::Slips.into(), Shown::SlipsMeaning.into()],
        FramePlot::Energy => vec![Simulated::Energy.into(), Simulated::EnergyMeaning.into()],
    }
}
