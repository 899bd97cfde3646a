//! `dolmen motion` on a terminal.

use super::{files, matched, measures, spectra};
use crate::brief_rows::BriefText;
use crate::document::{Block, Document, TextStyle, document_text, heading_text};
use crate::simulated::steps_of;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::motion::{MotionReport, MotionSeries};

/// One of this many periods of a spectrum is printed; the second number is for a short answer.
const STEP: usize = 10;
const STEP_BRIEF: usize = 50;
/// PGA, PGV and PGD: the measures in a short answer with spectra.
const MEASURES_BESIDE_SPECTRA: usize = 3;

messages! {
    /// The head of a motion.
    pub(crate) enum Motion in "motion" {
        Head(name: String) => { en: "Motion {name}", ko: "지반운동 {name}" },
        Duration(duration: Quantity) => { en: "Duration {duration}.", ko: "지속시간 {duration}." },
        Done(steps: Sentence) => { en: "Done to it: {steps}.", ko: "처리: {steps}." },
    }
}

/// The history, the measures, the match and the spectra of a motion, and its files.
pub fn motion_report_text(report: &MotionReport, style: TextStyle) -> String {
    let Some(first) = report.series.first() else {
        return document_text(&sections(report), style);
    };
    let head = Motion::Head(first.motion.name().to_owned());
    let head = heading_text(&Sentence::from(head).text(style.language));
    match style.is_full {
        true => head + &document_text(&sections(report), style),
        false => head + &brief(report, style),
    }
}

fn lead(first: &MotionSeries) -> Block<'static> {
    let duration = Quantity::new(first.motion.duration_s(), Unit::si("s"), Digits::Fixed(2));
    let mut said = vec![Motion::Duration(duration).into()];
    said.extend(steps_of(first.motion.history()).map(|steps| Motion::Done(steps).into()));
    Block::Paragraph(said)
}

fn sections(report: &MotionReport) -> Document<'static> {
    let mut document = Document {
        blocks: report.series.first().map(lead).into_iter().collect(),
    };
    for (file, channels) in &report.files {
        files::section(&mut document, file, channels);
    }
    if let Some(answer) = &report.matched {
        matched::section(&mut document, answer);
    }
    document.put(Block::Table(measures::table(&report.series)));
    for drift in measures::drifts(&report.series) {
        document.note(drift);
    }
    let spectra = spectra::table(&report.series, STEP).map(Block::Table);
    document.blocks.extend(spectra);
    document
}

/// Files, match and problems, and the first measures.
fn brief(report: &MotionReport, style: TextStyle) -> String {
    let mut brief = BriefText::new(style);
    brief.blocks(report.series.first().map(lead));
    if let Some(answer) = &report.matched {
        let said = vec![matched::lead(answer), matched::nearness(answer)];
        brief.block(Block::Paragraph(said));
        brief.blocks(matched::fault(answer).map(Block::Warning));
    }
    for (file, channels) in &report.files {
        brief.block(Block::Paragraph(vec![files::file_words(file, channels)]));
    }
    brief.blocks(measures::drifts(&report.series).into_iter().map(Block::Note));
    let measures = measures::table(&report.series);
    // the lines above give the accuracy of a matched motion
    let spectra = match report.matched {
        Some(_) => None,
        None => spectra::table(&report.series, STEP_BRIEF),
    };
    let most = match &spectra {
        Some(_) => MEASURES_BESIDE_SPECTRA,
        None => measures.rows.len(),
    };
    brief.table(&measures, most);
    if let Some(spectra) = spectra {
        brief.table(&spectra, spectra.rows.len());
    }
    brief.finish()
}
