//! What goes into a simulated motion.

use crate::brief::notes_text;
use crate::check::project_text;
use crate::document::{Document, TextStyle, document_text, wrapped};
use crate::simulated::{doubted, motion_section};
use dolmen_project::Project;
use dolmen_words::{Sentence, Template, messages};
use dolmen_work::motion::MotionAnswer;

messages! {
    /// What is simulated.
    pub(crate) enum Inputs in "simulated.inputs" {
        Variant { name: String } => { en: "variant {name}", ko: "대안 {name}" },
    }
}

/// The sentences on inputs as they are written.
pub(crate) const TEMPLATES: &[Template] = Inputs::TEMPLATES;

/// What went in, before the run: the project, the motions that move it, and what was done to them.
pub fn simulation_inputs_text(
    project: &Project,
    file: &str,
    variant: Option<&str>,
    motions: &[&MotionAnswer],
    style: TextStyle,
) -> String {
    let mut document = Document::default();
    if let Some(name) = variant {
        let name = name.to_owned();
        document.paragraph(Inputs::Variant { name });
    }
    for motion in motions {
        motion_section(&mut document, motion);
    }
    let mut head = project_text(project, file, style);
    for doubt in motions.iter().flat_map(|motion| motion.doubts()) {
        let said = Sentence::from(doubted(&doubt)).text(style.language);
        head += &wrapped(&said, "  ! ", "    ", style.columns());
    }
    match style.is_full {
        true => head + &document_text(&document, style) + &notes_text(project, style),
        false => head + "\n",
    }
}
