//! Answers about records and modes: findings, and the sections of records, setups and free decays.

mod beside_model;
mod cautions;
mod clipped;
mod clocks;
mod decay;
mod decay_remarks;
mod driven;
mod earthquake;
mod earthquake_section;
mod earthquake_words;
mod faults;
mod findings;
mod joint;
mod notes;
mod record;
mod refused;
mod seen;
mod settings;
mod setup_remarks;
mod setups;
mod shapes;
mod steady;
mod steps;
mod tables;
mod values;

pub(crate) use decay_remarks::decay_remarks;
pub(crate) use faults::fault_words;
pub(crate) use findings::findings;
pub(crate) use setup_remarks::setup_remarks;

use crate::document::Document;
use dolmen_words::{Template, messages};
use dolmen_work::surveyed::SurveyAnswer;

messages! {
    /// Origin of a record.
    pub(crate) enum Of in "modal" {
        Survey { survey: String } => { en: "{survey}", ko: "{survey}" },
        Setup { survey: String, number: usize } => {
            en: "{survey}, setup {number}",
            ko: "{survey}, 배치 {number}",
        },
    }
}

/// Templates of the sentences on records.
pub(crate) const TEMPLATES: [&[Template]; 23] = [
    cautions::Cautions::TEMPLATES,
    findings::Found::TEMPLATES,
    Of::TEMPLATES,
    beside_model::Beside::TEMPLATES,
    record::Record::TEMPLATES,
    faults::Faults::TEMPLATES,
    steps::Steps::TEMPLATES,
    tables::Tables::TEMPLATES,
    shapes::Shapes::TEMPLATES,
    settings::Chosen::TEMPLATES,
    notes::Notes::TEMPLATES,
    refused::Refused::TEMPLATES,
    seen::Seen::TEMPLATES,
    steady::Steady::TEMPLATES,
    clocks::Clocks::TEMPLATES,
    clipped::Clipped::TEMPLATES,
    decay::Decays::TEMPLATES,
    decay_remarks::Remarks::TEMPLATES,
    driven::Drivens::TEMPLATES,
    earthquake_words::Quake::TEMPLATES,
    setups::Setups::TEMPLATES,
    joint::Joint::TEMPLATES,
    setup_remarks::Remarks::TEMPLATES,
];

/// The sections of the records of a survey.
pub(crate) fn sections(survey: &SurveyAnswer) -> Document<'_> {
    let mut document = Document::default();
    let name = || survey.name.clone();
    if let Some(record) = &survey.records {
        record::section(&mut document, Of::Survey { survey: name() }.into(), record);
    }
    if let Some(setups) = &survey.setups {
        for (at, record) in setups.records.iter().enumerate() {
            let of = Of::Setup {
                survey: name(),
                number: at + 1,
            };
            record::section(&mut document, of.into(), record);
        }
        setups::section(&mut document, &survey.name, setups);
    }
    if let Some(model) = &survey.model {
        beside_model::section(&mut document, &survey.name, model);
    }
    document
}
