//! Sentences for the reader of an identification.

use super::Sprung;
use super::options::Weighting;
use super::search::{Count, EXACT, Search, rank};
use crate::structure::{Choice, Visibility};
use dolmen_linalg::Svd;

/// A spring whose direction the data determine by less than this share is named as not seen.
const SEEN_LEAST: f64 = 0.5;
/// Components of a free direction below this are left out of the sentence.
const COMPONENT_LEAST: f64 = 0.05;

pub(super) fn of_solutions<S: Sprung>(search: &Search<'_, S>, count: &Count, choice: Choice) -> Vec<String> {
    let (kind, spring) = (S::KIND, S::SPRING);
    let mut notes = Vec::new();
    let parts = search.parts();
    let modes = search.modes.len();
    let shapes = search.modes.iter().filter(|mode| mode.shape.len() >= 2).count();
    let Count {
        starts,
        solutions,
        as_good,
        nearest,
        odd,
        ref roots,
    } = *count;
    let complete = roots.as_ref().is_some_and(|roots| roots.complete);
    let how_found = match roots {
        Some(roots) if roots.complete => format!(
            "all {} solutions in complex numbers were followed, so there is no other",
            roots.solutions_complex
        ),
        _ => format!("found from {starts} starts; there may be more"),
    };
    if let Some(roots) = roots {
        notes.extend(roots.notes.iter().cloned());
    }
    match choice {
        Choice::Impossible if complete => {}
        Choice::Impossible => notes.push(match nearest {
            Some(misfit) => format!(
                "No {spring} stiffness was found, from {starts} starts, that explains the {modes} modes: the nearest is off by {}. Check that they are the lowest \
                 modes of one direction with none left out between them, and the masses.",
                off(search.weighting, misfit)
            ),
            None => format!("No {spring} stiffness was found at which the {kind} stands."),
        }),
        Choice::Underdetermined if search.independent >= parts => notes.push(format!(
            "The best fit leaves some {spring} stiffness free: beyond some value, more of it changes no datum. The set \
             shown is one of many that fit as well."
        )),
        Choice::Underdetermined => notes.push(format!(
            "{modes} {}{} {} {} independent {} for {parts} {spring} stiffnesses: they cannot be determined. The set \
             shown fits the data and is the nearest to stiffness in proportion to {}, an assumption and not \
             a measurement. Measure more modes, or shapes at several heights.",
            if modes == 1 { "frequency" } else { "frequencies" },
            if shapes > 0 { " with shape points" } else { "" },
            if modes == 1 { "gives" } else { "give" },
            search.independent,
            if search.independent == 1 { "datum" } else { "data" },
            search.structure.proportion_words()
        )),
        Choice::Indistinguishable => notes.push(format!(
            "{as_good} sets of {spring} stiffness explain the data equally well and all stand ({how_found}). {} cannot \
             tell them apart: {}.",
            if shapes == 0 { "Frequencies alone" } else { "These data" },
            if shapes == 0 {
                format!("measure the shapes too, best with a sensor near each {spring}")
            } else {
                "measure the shapes at more heights or in more modes".to_string()
            }
        )),
        Choice::One if shapes == 0 && parts > 1 && !complete => notes.push(format!(
            "Only one set of {spring} stiffness was found from {starts} starts, but frequencies alone often have several: \
             this is no proof."
        )),
        Choice::One => {}
    }
    if odd {
        notes.push(format!(
            "Their number is odd, but as many frequencies as {spring}s have an even number of solutions: at least one \
             more exists and was not found. Raise starts."
        ));
    }
    if solutions > search.options.solutions_most {
        notes.push(format!(
            "{solutions} solutions were found; the first {} are listed.",
            search.options.solutions_most
        ));
    }
    for (j, mode) in search.modes.iter().enumerate() {
        if mode.shape.len() == 1 {
            notes.push(format!(
                "Mode {} has one shape point: its scale is free, so it says nothing and is left out.",
                j + 1
            ));
        }
    }
    if search.weighting == Weighting::PartlyAssumed {
        notes.push(format!(
            "Data without a standard deviation were given {} % of a frequency and {} % of the largest displacement of a \
             mode, an assumption.",
            100.0 * search.options.frequency_sd_assumed,
            100.0 * search.options.shape_sd_assumed
        ));
    }
    let explained = matches!(choice, Choice::One | Choice::Indistinguishable);
    if let (Weighting::Relative, Some(misfit)) = (search.weighting, nearest)
        && explained
        && misfit >= EXACT
    {
        notes.push(format!(
            "The best set is off by {}; without standard deviations of the modes no interval can be given.",
            off(search.weighting, misfit)
        ));
    }
    notes.extend(search.structure.assumptions());
    notes
}

fn off(weighting: Weighting, misfit: f64) -> String {
    match weighting {
        Weighting::Relative => format!("{:.2} % (root mean square)", 100.0 * misfit),
        _ => format!("{misfit:.1} standard deviations (root mean square)"),
    }
}

/// What can change without any datum changing.
pub(super) fn of_free_directions(spring: &str, jacobian: &Svd, choice: Choice) -> Vec<String> {
    if choice != Choice::Underdetermined {
        return Vec::new();
    }
    let n = jacobian.v.rows();
    (rank(&jacobian.s)..n)
        .map(|direction| {
            let parts: Vec<String> = (0..n)
                .filter(|&i| jacobian.v[(i, direction)].abs() >= COMPONENT_LEAST)
                .map(|i| format!("{spring} {} {:+.2}", i + 1, jacobian.v[(i, direction)]))
                .collect();
            format!(
                "Free: changes of ln k in the proportions {} leave all data unchanged (to first order).",
                parts.join(", ")
            )
        })
        .collect()
}

pub(super) fn of_unseen(spring: &str, visibility: &Visibility) -> Option<String> {
    let unseen = visibility
        .seen
        .iter()
        .enumerate()
        .filter(|(_, seen)| **seen < SEEN_LEAST);
    let unseen: Vec<String> = unseen.map(|(i, _)| (i + 1).to_string()).collect();
    if unseen.is_empty() {
        return None;
    }
    Some(format!(
        "The sensors hardly see {spring}{} {}: the data would barely change with {} stiffness.",
        if unseen.len() == 1 { "" } else { "s" },
        unseen.join(", "),
        if unseen.len() == 1 { "its" } else { "their" }
    ))
}

/// Springs whose interval is too wide to be linear.
pub(super) fn of_wide_intervals(spring: &str, relative_sd: &[f64]) -> Option<String> {
    const LINEAR_MOST: f64 = 0.3; // beyond it ln k and k differ by more than a seventh
    let wide = relative_sd
        .iter()
        .enumerate()
        .filter(|(_, sd)| **sd > LINEAR_MOST);
    let each: Vec<String> = wide
        .map(|(i, sd)| format!("{spring} {} by {:.0} %", i + 1, 100.0 * sd))
        .collect();
    if each.is_empty() {
        return None;
    }
    Some(format!(
        "The data determine some stiffnesses only to an order of magnitude (standard deviation of {}).",
        each.join(", ")
    ))
}
