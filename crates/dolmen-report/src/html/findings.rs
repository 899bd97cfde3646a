//! The findings in plain words, made from the values: what was not computed is called unknown.

use super::finding::{Finding, Tone};
use crate::{
    building_simulation, chain, change, check, frame_simulation, identification, modal, stack_simulation,
    tune,
};
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use maud::{Markup, html};

/// The list of all findings.
pub(super) fn list(answer: &ProjectReport, language: Language) -> Markup {
    let mut all: Vec<Finding> = Vec::new();
    if let Some(check) = answer.check() {
        all.extend(
            check::findings(check)
                .into_iter()
                .map(|of| Finding::said(of, language)),
        );
    }
    if let Some(simulated) = answer.stack_simulation() {
        let found = stack_simulation::findings(simulated).into_iter();
        all.extend(found.map(|of| Finding::said(of, language)));
    }
    let simulated = frame_simulation::findings(&answer.frame_simulations())
        .into_iter()
        .chain(chain::simulation_findings(&answer.chain_simulations()));
    all.extend(simulated.map(|of| Finding::said(of, language)));
    let tuned = tune::findings(&answer.tunings(), &answer.together()).into_iter();
    all.extend(tuned.map(|of| Finding::said(of, language)));
    let moved = building_simulation::findings(&answer.building_simulations()).into_iter();
    all.extend(moved.map(|of| Finding::said(of, language)));
    for survey in answer.surveys() {
        all.extend(
            modal::findings(survey)
                .into_iter()
                .map(|of| Finding::said(of, language)),
        );
    }
    if let Some(found) = answer.change() {
        all.extend(
            change::findings(found)
                .into_iter()
                .map(|of| Finding::said(of, language)),
        );
    }
    let stiffness = identification::findings(answer.surveys());
    all.extend(stiffness.into_iter().map(|of| Finding::said(of, language)));
    // what is worst comes first
    all.sort_by_key(|finding| finding.tone != Tone::Bad);
    html! {
        ul.findings { @for finding in &all {
            li class=(class(finding.tone)) { (finding.text) }
        } }
    }
}

fn class(tone: Tone) -> &'static str {
    match tone {
        Tone::Good => "good",
        Tone::Warn => "warn",
        Tone::Bad => "bad",
        Tone::Plain => "plain",
        Tone::Unknown => "unknown",
    }
}
