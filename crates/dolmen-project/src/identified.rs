//! Numbers identified from a survey of the file.

use super::content::{Project, Structure, Variant};
use super::error::Fault;
use super::file_number::{EvidenceRaw, QuantityTable};
use super::quantity::Quantity;
use super::wrong::WrongNumber;
use std::ops::Range;

/// The survey that a number was identified from.
///
/// # Errors
/// One of source = "identified" and survey without the other.
pub(super) fn identified_from(
    table: &QuantityTable,
    path: &str,
    at: &Range<usize>,
) -> Result<Option<String>, Box<Fault>> {
    let is_identified = matches!(table.source, Some(EvidenceRaw::Identified));
    let path_named = || path.to_owned();
    match (is_identified, &table.survey) {
        (true, Some(survey)) => Ok(Some(survey.value.clone())),
        (true, None) => {
            let message = WrongNumber::IdentifiedFromWhat(path_named());
            let fault = Fault::new(at.clone(), path, message);
            Err(Box::new(fault.help(WrongNumber::SurveyBeside)))
        }
        (false, Some(survey)) => {
            let message = WrongNumber::SurveyWithoutSource(path_named());
            let fault = Fault::new(survey.span.clone(), path, message);
            Err(Box::new(fault.help(WrongNumber::SourceIdentified)))
        }
        (false, None) => Ok(None),
    }
}

/// Numbers identified from a survey that is not in the file; `place` gives the place of each.
pub(super) fn without_survey(
    inputs: &[&Quantity],
    surveys: &[&str],
    place: impl Fn(&str) -> Range<usize>,
) -> Vec<Fault> {
    let each = inputs.iter().filter_map(|of| Some((of, of.survey.as_deref()?)));
    let unknown = each.filter(|(_, survey)| !surveys.contains(survey));
    let faults = unknown.map(|(of, survey)| {
        let message = WrongNumber::IdentifiedFromNone {
            path: of.path.clone(),
            survey: survey.to_owned(),
        };
        let known = surveys.join(", ");
        Fault::new(place(&of.path), &of.path, message).help(WrongNumber::SurveysOfFile(known))
    });
    faults.collect()
}

/// Stiffness to identify from a survey that is not in the file.
pub(super) fn sought_in_none(
    structure: &Structure,
    surveys: &[&str],
    place: impl Fn(&str) -> Range<usize>,
) -> Vec<Fault> {
    let each = structure.sought().into_iter();
    let named = each.filter_map(|(path, sought)| Some((path, sought.survey.as_deref()?)));
    let unknown = named.filter(|(_, survey)| !surveys.contains(survey));
    let faults = unknown.map(|(path, survey)| {
        let message = WrongNumber::IdentifiedFromNone {
            path: path.clone(),
            survey: survey.to_owned(),
        };
        let known = surveys.join(", ");
        Fault::new(place(&path), &path, message).help(WrongNumber::SurveysOfFile(known))
    });
    faults.collect()
}

/// Stiffness that only a variant leaves to a survey: a survey belongs to the structure of the file.
pub(super) fn sought_by_variant(variant: &Variant, project: &Project) -> Vec<Fault> {
    let own = project.structure.sought();
    let each = variant.project.structure.sought().into_iter();
    let faults = each.filter(|of| !own.contains(of)).map(|(path, _)| {
        let message = WrongNumber::IdentifiedInVariant {
            name: variant.name.clone(),
            path: path.clone(),
        };
        let span = variant.project.spans.get(&path).cloned().unwrap_or(0..0);
        Fault::new(span, &path, message).help(WrongNumber::IdentifiedAsItIs)
    });
    faults.collect()
}
