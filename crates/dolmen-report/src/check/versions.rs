//! The sections of one version: the structure as it is, or a variant.

use super::findings::of_state;
use super::sampled;
use super::variants::title;
use crate::document::{Block, Document, Finding, TextStyle, block_text};
use crate::figures::Shaking;
use crate::{building, chain, demand, frame, loads, stack};
use dolmen_project::{Project, Structure};
use dolmen_words::message::Both;
use dolmen_words::{Language, Sentence, messages};
use dolmen_work::answer::CheckAnswer;
use dolmen_work::state::{Check, State, VariantAnswer};
use std::collections::BTreeSet;

messages! {
    /// The results of a variant in a report.
    pub(crate) enum OfVariant in "check.of-variant" {
        Head { variant: Both } => { en: "Variant “{variant}”", ko: "대안 ‘{variant}’" },
        Marked { sign: String, said: Sentence } => { en: "{sign} {said}", ko: "{sign} {said}" },
        AsItIs => {
            en: "Only what differs from the structure as it is stands here.",
            ko: "현 상태와 다른 결과만 보인다.",
        },
        Same => {
            en: "All results but those of the comparison are those of the structure as it is.",
            ko: "대안 비교에 보인 것 외에는 현 상태의 결과와 같다.",
        },
    }
}

/// Whether a head is that of the results of a variant.
pub(crate) fn is_of_variant(head: &Sentence) -> bool {
    let of_variant = OfVariant::TEMPLATES.first();
    of_variant.is_some_and(|template| template.id() == head.id)
}

/// The sections of one version, without the appendix of its kind.
fn model_sections<'a>(project: &'a Project, state: &'a State) -> Document<'a> {
    let structure = &project.structure;
    match (structure, &state.check) {
        (Structure::Chain(part), Check::Chain(check)) => chain::sections(part, check),
        (Structure::Frame(part), Check::Frame(directions)) => frame::sections(part, directions),
        (_, Check::Stack(answer)) => {
            stack::sections(structure, answer, &state.spring_fits, Shaking::default())
        }
        (_, Check::Building(of)) => building::sections(of, &project.loads),
        (_, Check::Chain(_) | Check::Frame(_)) => Document::default(),
    }
}

/// Wind, static loads and combinations of one version.
fn loads_sections<'a>(project: &'a Project, state: &'a State) -> Document<'a> {
    let of = match (&project.structure, &state.check) {
        (Structure::Chain(part), _) => loads::Loaded::Chain(chain::joint_heights_m(part)),
        (Structure::Frame(part), Check::Frame(_)) => loads::Loaded::of_frame(part),
        (_, Check::Stack(answer)) => loads::Loaded::Stack(&answer.stack),
        (_, Check::Building(answer)) => loads::Loaded::Building(&answer.floors),
        _ => return Document::default(),
    };
    loads::sections(&project.loads, state.loads.as_ref(), of)
}

/// The sections of one version with the appendix of its kind.
pub(super) fn version_sections<'a>(project: &'a Project, state: &'a State) -> Document<'a> {
    let mut document = model_sections(project, state);
    if let Check::Chain(check) = &state.check {
        document.append(chain::appendix(check));
    }
    document.append(loads_sections(project, state));
    document.append(state.demand.as_ref().map(demand::sections).unwrap_or_default());
    document
}

/// The sections of a variant; only those of its loads or its stiffness where the rest is that of the structure as it is.
pub(super) fn variant_sections<'a>(
    answer: &CheckAnswer,
    own: &'a Project,
    variant: &'a VariantAnswer,
) -> Document<'a> {
    let base = answer.state.as_ref().map(|state| &state.check);
    let mut document = match (&own.structure, &variant.state.check, base) {
        (Structure::Chain(part), Check::Chain(check), Some(Check::Chain(base)))
            if check.limits == base.limits =>
        {
            let mut document = chain::stiffness_sections(part, check);
            document.append(loads_sections(own, &variant.state));
            document
        }
        (_, Check::Stack(check), Some(Check::Stack(base))) if check == base => {
            loads_sections(own, &variant.state)
        }
        (_, Check::Building(check), Some(Check::Building(base))) if check == base => {
            loads_sections(own, &variant.state)
        }
        _ => version_sections(own, &variant.state),
    };
    document.append(sampled::of_state(&variant.state));
    document
}

/// A section for each variant: its findings and its results, as far as they differ from those of the structure as it is.
pub(crate) fn variants_in_full(answer: &CheckAnswer) -> Document<'_> {
    let mut all = Document::default();
    let Some(state) = &answer.state else {
        return all;
    };
    let (said, shown) = known(answer, state);
    for variant in &answer.variants {
        let mut projects = answer.project.variants.iter();
        let Some(own) = projects.find(|own| own.name == variant.name) else {
            continue;
        };
        let own = &own.project;
        all.heading(OfVariant::Head {
            variant: title(variant),
        });
        let found = of_state(own, &variant.state).into_iter();
        let found = found.filter(|of| of.is_key && !said.contains(&of.sentence.text(Language::English)));
        let points: Vec<Sentence> = found.map(marked).collect();
        let mut results = variant_sections(answer, own, variant);
        results.blocks.retain(|block| !is_shown(block, &shown));
        let blocks = under_one_head(results.blocks);
        match points.is_empty() && blocks.is_empty() {
            true => all.note(OfVariant::Same),
            false => all.note(OfVariant::AsItIs),
        }
        if !points.is_empty() {
            all.put(Block::List(points));
        }
        all.blocks.extend(blocks);
    }
    all
}

fn marked(finding: Finding) -> Sentence {
    let (sign, said) = (finding.tone.sign().to_string(), finding.sentence);
    match sign.as_str() {
        "-" => said,
        _ => OfVariant::Marked { sign, said }.into(),
    }
}

/// The findings and the blocks of the structure as it is.
fn known(answer: &CheckAnswer, state: &State) -> (BTreeSet<String>, BTreeSet<String>) {
    let findings = of_state(&answer.project, state);
    let mut sections = version_sections(&answer.project, state);
    sections.append(sampled::of_state(state));
    let said = findings.iter().map(|of| of.sentence.text(Language::English));
    (said.collect(), sections.blocks.iter().map(block_key).collect())
}

/// All that a block shows, to compare it with another.
fn block_key(block: &Block<'_>) -> String {
    match block {
        Block::Figures(figures) => figures
            .iter()
            .map(|figure| (figure.draw)(Language::English))
            .collect(),
        other => block_text(other, TextStyle::plain()),
    }
}

/// Whether the structure as it is shows the same; heads stay until it is known what stands below them.
fn is_shown(block: &Block<'_>, shown: &BTreeSet<String>) -> bool {
    !matches!(block, Block::Heading(_) | Block::Subheading(_)) && shown.contains(&block_key(block))
}

/// The blocks with heads of parts in place of those of sections, and without heads over nothing.
fn under_one_head(blocks: Vec<Block<'_>>) -> Vec<Block<'_>> {
    let mut all: Vec<Block<'_>> = Vec::new();
    for block in blocks {
        let block = match block {
            Block::Heading(head) => Block::Subheading(head),
            other => other,
        };
        let is_head = matches!(block, Block::Subheading(_));
        if is_head && matches!(all.last(), Some(Block::Subheading(_))) {
            all.pop();
        }
        all.push(block);
    }
    if matches!(all.last(), Some(Block::Subheading(_))) {
        all.pop();
    }
    all
}
