//! A plan for sensors as files.

use super::named::NamedFile;
use crate::figures::planned_drawing;
use crate::json::sensors_json;
use crate::sensors::channel_lines;
use dolmen_words::{Language, keeping_names};
use dolmen_work::sensors::SensorsAnswer;

/// The plan as JSON, the lines for a survey, and the drawing.
pub fn sensors_files(answer: &SensorsAnswer, language: Language) -> Vec<NamedFile> {
    let mut files = vec![
        NamedFile::json("sensors.json", &keeping_names(|| sensors_json(answer))),
        NamedFile::new("sensors.toml", channel_lines(answer)),
    ];
    files.extend(planned_drawing(answer, language).map(|svg| NamedFile::svg("sensors", &svg)));
    files
}
