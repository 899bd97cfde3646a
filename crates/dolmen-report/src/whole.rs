//! The whole answer on one project: its findings, and its sections as one document.

use crate::document::{Document, Finding, Tone};
use crate::{
    building, building_simulation, chain, change, check, demand, frame, frame_simulation, identification,
    modal, stack, stack_simulation, study, tune,
};
use dolmen_project::Structure;
use dolmen_work::answer::ProjectReport;
use dolmen_work::state::{Check, State};

/// All findings, what is worst first.
pub(crate) fn all_findings(answer: &ProjectReport) -> Vec<Finding> {
    let mut all = answer.check().map_or(Vec::new(), check::findings);
    if let Some(simulated) = answer.stack_simulation() {
        all.extend(stack_simulation::findings(simulated));
    }
    all.extend(frame_simulation::findings(&answer.frame_simulations()));
    all.extend(chain::simulation_findings(&answer.chain_simulations()));
    all.extend(tune::findings(&answer.tunings(), &answer.together()));
    all.extend(building_simulation::findings(&answer.building_simulations()));
    all.extend(answer.surveys().iter().flat_map(modal::findings));
    all.extend(answer.change().into_iter().flat_map(change::findings));
    all.extend(identification::findings(answer.surveys()));
    all.sort_by_key(|finding| finding.tone != Tone::Bad);
    all
}

/// All sections in the order in which they are read: the model, earthquakes, dampers, studies, variants, surveys.
pub(crate) fn whole_document(answer: &ProjectReport) -> Document<'_> {
    let mut whole = Document::default();
    if let Some(state) = answer.state() {
        model(&mut whole, answer, state);
        if let Some(demand) = &state.demand {
            whole.append(demand::sections(demand));
        }
    }
    whole.append(stack_simulation::sections(answer));
    whole.append(frame_simulation::sections(&answer.frame_simulations()));
    whole.append(chain::simulation_sections(&answer.chain_simulations()));
    whole.append(tune::sections(&answer.tunings(), &answer.together()));
    whole.append(building_simulation::sections(&answer.building_simulations()));
    for found in answer.studies() {
        whole.append(study::sections(found));
    }
    if let Some(check) = answer.check() {
        whole.append(check::variants_section(check));
        whole.append(check::scatter_sections(check));
    }
    for survey in answer.surveys() {
        whole.append(modal::sections(survey));
    }
    if let Some(found) = answer.change() {
        whole.append(change::sections(&answer.project, found));
    }
    whole.append(identification::sections(&answer.project, answer.surveys()));
    whole
}

/// The structure as it is computed.
fn model<'a>(whole: &mut Document<'a>, answer: &'a ProjectReport, state: &'a State) {
    match (&answer.project.structure, &state.check) {
        (Structure::Chain(part), Check::Chain(check)) => whole.append(chain::sections(part, check)),
        (Structure::Frame(part), Check::Frame(all)) => whole.append(frame::sections(part, all)),
        (_, Check::Stack(check)) => {
            let shaking = stack::peak_g(answer, check);
            whole.append(stack::sections(check, &state.spring_fits, shaking));
            whole.append(stack::comparison(state, answer.variants()));
        }
        (_, Check::Building(check)) => whole.append(building::sections(check)),
        (_, Check::Chain(_) | Check::Frame(_)) => {}
    }
}
