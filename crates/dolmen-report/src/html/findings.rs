//! The findings in plain words, made from the values: what was not computed is called unknown.

use super::finding::{Finding, Tone};
use super::given::{assumptions, assumptions_of_variant};
use super::{
    building, building_simulation, chain_simulation, change, demand, frame, frame_simulation, identification,
    measured, modal, samples, setups, simulation, stack, tune, variants,
};
use crate::chain;
use dolmen_project::{Cap, Structure};
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use dolmen_work::state::Check;
use maud::{Markup, html};

/// The list of all findings.
pub(super) fn list(answer: &ProjectReport, language: Language) -> Markup {
    let mut all = Vec::new();
    if let Some(state) = answer.state() {
        match &state.check {
            Check::Chain(check) => {
                all.extend(
                    chain::findings(check)
                        .into_iter()
                        .map(|of| Finding::said(of, language)),
                );
            }
            Check::Frame(directions) => all.extend(frame::findings(directions, language)),
            Check::Stack(check) => all.extend(stack::findings(check, language)),
            Check::Building(check) => all.extend(building::findings(check, language)),
        }
        all.extend(demand::findings(state.demand.as_ref(), language));
        all.extend(measured::findings(state, language));
        all.extend(samples::findings(state.sampled.as_ref(), language));
    }
    all.extend(variants::findings(answer, language));
    all.extend(building::variant_findings(answer.variants(), language));
    if let Some(simulated) = answer.stack_simulation() {
        all.extend(simulation::findings(simulated, language));
    }
    all.extend(frame_simulation::findings(&answer.frame_simulations(), language));
    all.extend(chain_simulation::findings(&answer.chain_simulations(), language));
    all.extend(tune::findings(&answer.tunings(), language));
    all.extend(tune::findings_together(&answer.together(), language));
    all.extend(building_simulation::findings(
        &answer.building_simulations(),
        language,
    ));
    for survey in answer.surveys() {
        if let Some(record) = &survey.records {
            all.extend(modal::findings(record, language));
        }
        if let Some(found) = &survey.setups {
            all.push(setups::finding(found, language));
        }
    }
    if let Some(found) = answer.change() {
        all.extend(change::findings(found, language));
    }
    all.extend(identification::findings(answer.surveys(), language));
    let cap_left_out =
        matches!(&answer.project.structure, Structure::Chain(part) if part.cap == Cap::LeftOut);
    if cap_left_out {
        all.push(Finding::new(
            Tone::Warn,
            language.pick(
                "The part at the very top (cap stone) is left out of the model: the true limits are higher and the true margins lower than stated.",
                "최상부 부재(옥개석)가 모델에서 제외되었다. 실제 한계 강성은 여기 값보다 크고 실제 여유도는 작다.",
            ),
        ));
    }
    let scatters = answer
        .project
        .inputs()
        .into_iter()
        .filter(|q| q.is_scatter_assumed())
        .count();
    let sampled = answer.state().is_some_and(|s| s.sampled.is_some());
    if sampled && scatters > 0 {
        all.push(Finding::new(
            Tone::Warn,
            language.pick(
                format!(
                    "The scatter of {scatters} inputs is itself assumed, and the probability rests on it."
                ),
                format!("입력 {scatters}개의 변동계수 자체가 가정값이며, 확률은 이에 의존한다."),
            ),
        ));
    }
    if let Some(text) = assumptions(&answer.project, language) {
        all.push(Finding::new(Tone::Warn, text));
    }
    for variant in answer.variants() {
        all.extend(assumptions_of_variant(variant, language).map(|text| Finding::new(Tone::Warn, text)));
    }
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
