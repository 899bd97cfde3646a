//! Templates of all sentences, for reviewers of the Korean.

use crate::brief::Brief;
use crate::brief_rows::BriefRows;
use crate::document::Label;
use crate::html::method::Method;
use crate::identify::Nothing;
use crate::inputs_by_part::ByPart;
use crate::load_factor::LoadFactor;
use crate::other_inputs::OtherInputs;
use crate::surveys_given::Given;
use crate::surveys_many::Many;
use crate::whole::Appended;
use crate::{
    after_first, building, building_simulation, chain, change, check, damaged, demand, document, engineer,
    figures, frame, frame_simulation, headline, headline_basis, headline_damage, identification, kept,
    limits, loads, modal, motion, processing, rank, scanned, score, sensors, simulated, stack,
    stack_simulation, study, text, tune, warned, watch, wind_simulation, xlsx,
};
use dolmen_words::Template;

/// Every message of this crate, in the order of the groups.
pub fn sentences() -> Vec<Template> {
    let mut groups = vec![
        LoadFactor::TEMPLATES,
        Brief::TEMPLATES,
        Nothing::TEMPLATES,
        BriefRows::TEMPLATES,
        Method::TEMPLATES,
        ByPart::TEMPLATES,
        OtherInputs::TEMPLATES,
        Given::TEMPLATES,
        Many::TEMPLATES,
        Appended::TEMPLATES,
    ];
    groups.extend(chain::TEMPLATES);
    groups.extend(loads::TEMPLATES);
    groups.push(dolmen_work::loads::Governed::TEMPLATES);
    groups.extend(dolmen_work::judgement::SAID);
    groups.push(dolmen_work::portfolio::BasisSaid::TEMPLATES);
    groups.push(dolmen_work::study::Method::TEMPLATES);
    groups.extend(check::TEMPLATES);
    groups.push(headline::TEMPLATES);
    groups.push(headline_basis::TEMPLATES);
    groups.push(headline_damage::TEMPLATES);
    groups.push(damaged::TEMPLATES);
    groups.push(text::PROJECT_LINE);
    groups.push(dolmen_project::Warned::TEMPLATES);
    groups.push(dolmen_project::Doubted::TEMPLATES);
    groups.extend(dolmen_project::ERRORS);
    groups.extend(dolmen_records::ERRORS);
    groups.extend(dolmen_work::ERRORS);
    groups.push(dolmen_words::advice::ADVICE);
    groups.push(dolmen_words::SYSTEM);
    groups.extend(frame::TEMPLATES);
    groups.extend(demand::TEMPLATES);
    groups.extend(limits::TEMPLATES);
    groups.extend(simulated::TEMPLATES);
    groups.push(after_first::TEMPLATES);
    groups.extend(frame_simulation::TEMPLATES);
    groups.extend(stack::TEMPLATES);
    groups.push(processing::Step::TEMPLATES);
    groups.extend(building::TEMPLATES);
    groups.push(text::SIMULATION_INPUTS);
    groups.extend(stack_simulation::TEMPLATES);
    groups.extend(building_simulation::TEMPLATES);
    groups.extend(wind_simulation::TEMPLATES);
    groups.extend(tune::TEMPLATES);
    groups.extend(change::TEMPLATES);
    groups.extend(watch::TEMPLATES);
    groups.extend(study::TEMPLATES);
    groups.extend(modal::TEMPLATES);
    groups.extend(identification::TEMPLATES);
    groups.extend(motion::TEMPLATES);
    groups.extend(score::TEMPLATES);
    groups.extend(rank::TEMPLATES);
    groups.extend(scanned::TEMPLATES);
    groups.extend(sensors::TEMPLATES);
    groups.extend(kept::TEMPLATES);
    groups.extend(figures::TEMPLATES);
    groups.extend(figures::OF_SINGLE_FIGURES);
    groups.extend(engineer::TEMPLATES);
    groups.extend(crate::html::fronted::TEMPLATES);
    groups.push(document::Framed::TEMPLATES);
    groups.push(warned::Noted::TEMPLATES);
    groups.push(Label::TEMPLATES);
    groups.push(xlsx::Workbook::TEMPLATES);
    groups.into_iter().flatten().copied().collect()
}

/// The sentences as a table: identifier, English, Korean. It begins with the byte order mark by which Excel recognises UTF-8.
pub fn sentences_csv() -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let mut csv = "\u{feff}sentence,english,korean\r\n".to_owned();
    for template in sentences() {
        let cells = [&template.id(), template.english, template.korean].map(quoted);
        csv += &(cells.join(",") + "\r\n");
    }
    csv
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_no_korean_sentence_is_left_in_english() {
        // symbols, numbers and arguments are the same in both languages
        let is_symbol = |text: &str| {
            text.chars()
                .all(|c| !c.is_ascii_alphabetic() || "kcrpPHMNbmditfDSavVAyz".contains(c))
        };
        for template in sentences() {
            let bare: String = template
                .korean
                .split('{')
                .map(|part| part.split_once('}').map_or(part, |p| p.1))
                .collect();
            let is_korean = bare.chars().any(|c| ('가'..='힣').contains(&c));
            assert!(
                is_korean || is_symbol(&bare),
                "{}: {}",
                template.id(),
                template.korean
            );
        }
    }
}
