//! The whole answer on one project: its findings, and its sections as one document.

use crate::document::{Block, Document, Finding, Tone};
use crate::engineer::{self, Pictures};
use crate::html::method::method;
use crate::on_paper::{document_on_paper, findings_on_paper};
use crate::{
    building, building_simulation, chain, change, check, demand, frame, frame_simulation, identification,
    loads, modal, stack, stack_simulation, study, surveys_many, tune, watch,
};
use dolmen_project::Structure;
use dolmen_words::{Language, Sentence, messages};
use dolmen_work::answer::ProjectReport;
use dolmen_work::state::{Check, State};
use std::collections::BTreeSet;

messages! {
    /// What stands behind the sections.
    pub(crate) enum Appended in "appendix" {
        Appendix { head: Sentence } => { en: "Appendix: {head}", ko: "부록: {head}" },
        Given => { en: "What was given", ko: "입력 자료" },
    }
}

/// All findings, the worst first; a finding that several runs share is listed once.
pub(crate) fn all_findings(answer: &ProjectReport) -> Vec<Finding> {
    // of loose stones, where they come to rest is the verdict
    let settled = answer.settled_stones();
    let mut all: Vec<Finding> = settled.flat_map(stack_simulation::settled_findings).collect();
    all.extend(answer.check().map_or(Vec::new(), check::findings));
    if answer.watch().is_some() {
        // findings that the check leaves to the report
        let left = check::over_the_years(&answer.project);
        all.retain(|finding| !left.contains(finding));
    }
    if let Some(runs) = answer.own_stack_runs() {
        all.extend(stack_simulation::findings(runs));
    }
    for run in answer.moved_supports() {
        all.extend(stack_simulation::supports_findings(run));
    }
    all.extend(frame_simulation::findings(&answer.frame_simulations()));
    all.extend(chain::simulation_findings(&answer.chain_simulations()));
    all.extend(tune::findings(&answer.tunings(), &answer.together()));
    if answer.check().is_some() {
        all.retain(|finding| !tune::points_at_check(finding));
    }
    all.extend(building_simulation::findings(&answer.building_simulations()));
    all.extend(modal::findings(answer.surveys()));
    all.extend(answer.change().into_iter().flat_map(change::findings));
    all.extend(answer.watch().into_iter().flat_map(watch::findings));
    all.extend(identification::findings_of_latest(
        &answer.project,
        answer.surveys(),
    ));
    all.sort_by_key(|finding| finding.tone != Tone::Bad);
    findings_on_paper(&mut all);
    let mut said = BTreeSet::new();
    all.retain(|finding| said.insert(finding.sentence.text(Language::English)));
    all
}

/// All sections in the order in which they are read: place, surveys, the model, earthquakes, dampers, studies, change over the years, variants,
/// opinion, method; behind them appendices.
pub(crate) fn whole_document(answer: &ProjectReport) -> Document<'_> {
    let mut whole = Document::default();
    let given = answer.project.report.as_ref();
    if let Some(given) = given {
        whole.append(engineer::place(given, Pictures::of(answer)));
    }
    whole.append(engineer::structure(&answer.project));
    if let Some(given) = given {
        whole.append(engineer::tests_made(given));
    }
    whole.append(engineer::damage(&answer.project, Pictures::of(answer)));
    whole.append(surveys_many::sections(&answer.project, answer.surveys()));
    let detailed = surveys_many::detailed(&answer.project, answer.surveys());
    for survey in &detailed {
        whole.append(modal::sections(survey));
    }
    whole.append(identification::sections(&answer.project, &detailed));
    if let Some(state) = answer.state() {
        model(&mut whole, answer, state);
        if let Some(demand) = &state.demand {
            whole.append(demand::sections(demand));
        }
    }
    whole.append(stack_simulation::sections(answer));
    for run in answer.moved_supports() {
        whole.append(stack_simulation::supports_sections(run));
    }
    for run in answer.settled_stones() {
        whole.append(stack_simulation::settled_sections(run));
    }
    whole.append(frame_simulation::sections(&answer.frame_simulations()));
    whole.append(chain::simulation_sections(&answer.chain_simulations()));
    whole.append(tune::sections(&answer.tunings(), &answer.together()));
    whole.append(building_simulation::sections(&answer.building_simulations()));
    for found in answer.studies() {
        whole.append(study::sections(found));
    }
    if let Some(found) = answer.change() {
        whole.append(change::sections(found));
    }
    if let Some(found) = answer.watch() {
        whole.append(watch::sections(found));
    }
    if let (Some(check), Some(state)) = (answer.check(), answer.state()) {
        if let Check::Stack(_) = &state.check {
            whole.append(stack::comparison(state, answer.variants()));
        }
        whole.append(check::variants_section(check));
        whole.append(check::variants_in_full(check));
    }
    if let Some(given) = given {
        whole.append(engineer::opinion(given));
    }
    whole.append(method(&answer.project));
    if let Some(check) = answer.check() {
        whole.append(appendix(check::scatter_sections(check)));
    }
    if let Some(Check::Chain(check)) = answer.state().map(|state| &state.check) {
        whole.append(appendix(chain::appendix(check)));
    }
    whole.append(appendix(identification::appendix(&answer.project, &detailed)));
    document_on_paper(&mut whole);
    whole
}

/// The same, its heads marked as those of an appendix.
fn appendix(mut document: Document<'_>) -> Document<'_> {
    for block in &mut document.blocks {
        if let Block::Heading(head) = block {
            *head = Appended::Appendix { head: head.clone() }.into();
        }
    }
    document
}

/// The structure as it is computed.
fn model<'a>(whole: &mut Document<'a>, answer: &'a ProjectReport, state: &'a State) {
    match (&answer.project.structure, &state.check) {
        (Structure::Chain(part), Check::Chain(check)) => {
            whole.append(chain::sections(part, check));
            let heights_m = chain::joint_heights_m(part);
            whole.append(loads::sections(
                &answer.project.loads,
                state.loads.as_ref(),
                loads::Loaded::Chain(heights_m),
            ));
        }
        (Structure::Frame(part), Check::Frame(all)) => {
            whole.append(frame::sections(part, all));
            whole.append(loads::sections(
                &answer.project.loads,
                state.loads.as_ref(),
                loads::Loaded::of_frame(part),
            ));
        }
        (structure, Check::Stack(check)) => {
            let shaking = stack::peak_g(answer, check);
            whole.append(stack::sections(structure, check, &state.spring_fits, shaking));
            whole.append(loads::sections(
                &answer.project.loads,
                state.loads.as_ref(),
                loads::Loaded::Stack(&check.stack),
            ));
        }
        (_, Check::Building(check)) => {
            whole.append(building::sections(check, &answer.project.loads));
            whole.append(loads::sections(
                &answer.project.loads,
                state.loads.as_ref(),
                loads::Loaded::Building(&check.floors),
            ));
        }
        (_, Check::Chain(_) | Check::Frame(_)) => {}
    }
}
