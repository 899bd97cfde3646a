//! Stiffness from measured modes, as text: every solution, what tells them apart, and what the data leave open.

use super::Table;
use super::project::convention_words;
use dolmen::stability::Verdict;
use dolmen::structure::{Choice, NaturalMode, StiffnessBounds, StiffnessSolution, Visibility};
use dolmen_project::{Project, Quantity, Structure};
use dolmen_words::Language;
use dolmen_words::number::{Prefixed, TWO_SIDED_95, beside_one, prefix, trimmed};
use dolmen_work::surveyed::{StiffnessAnswer, SurveyAnswer};
use std::fmt::Write as _;

/// Significant digits of a frequency that went in.
const FREQUENCY_DIGITS: usize = 5;
/// Solutions printed in full; the rest are counted.
const SOLUTIONS_SHOWN: usize = 24;

pub(super) fn data_text(stiffness: &StiffnessAnswer) -> String {
    let frequencies: Vec<String> = stiffness
        .frequencies_hz
        .iter()
        .map(|f| trimmed(*f, FREQUENCY_DIGITS))
        .collect();
    let shapes = if stiffness.with_shapes {
        "with measured shapes"
    } else {
        "no shapes"
    };
    format!(
        "\nDirection {}: {} Hz, {shapes}\n",
        stiffness.direction,
        frequencies.join(", ")
    )
}

/// The parts of a kind of structure in words, and the unit of their stiffness.
fn words(stiffness: &StiffnessAnswer) -> (&'static str, &'static str) {
    match stiffness.convention {
        None => ("joint", "N·m/rad"),
        Some(_) => ("storey", "N/m"),
    }
}

pub(super) fn stiffness_text(stiffness: &StiffnessAnswer) -> String {
    let mut out = String::new();
    if let Some(convention) = stiffness.convention {
        let _ = writeln!(out, "\n Convention {}", convention_words(convention));
    }
    let found = &stiffness.solutions;
    let (part, unit) = words(stiffness);
    let all: Vec<f64> = found.solutions.iter().flat_map(stiffness_shown).collect();
    let unit = prefix(&all, unit);
    if !found.solutions.is_empty() {
        let parts = found.solutions[0].stiffness.len();
        let mut heads: Vec<String> = vec!["solution".into()];
        heads.extend((1..=parts).map(|i| format!("k{i}")));
        heads.extend(["misfit".into(), "load factor".into(), "verdict".into()]);
        let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
        let mut table = Table::new(&heads, 1);
        for (i, solution) in found.solutions.iter().take(SOLUTIONS_SHOWN).enumerate() {
            let mut cells = vec![(i + 1).to_string()];
            cells.extend(stiffness_cells(solution, &unit));
            cells.push(format!("{:.1e}", solution.misfit));
            let factor = stiffness.load_factors.get(i).copied().flatten();
            cells.push(factor.map_or("-".into(), |factor| beside_one(factor, 4)));
            let verdict = match stiffness.peaks_below_hz.is_empty() {
                true => solution_verdict(found.choice, solution, factor),
                false => Verdict::Unknown,
            };
            cells.push(verdict.word().into());
            table.row(cells);
            if let Some(sd) = &solution.stiffness_sd {
                let mut cells = vec!["  ± 95 %".to_owned()];
                cells.extend(
                    sd.iter()
                        .map(|sd| format!("{:.4}", TWO_SIDED_95 * sd * unit.factor)),
                );
                table.row(cells);
            }
            if let Some(range) = &solution.stiffness_range {
                for (name, ends) in [("  least", &range.lower), ("  most", &range.upper)] {
                    let mut cells = vec![name.to_owned()];
                    cells.extend(ends.iter().map(|k| format!("{:.4}", k * unit.factor)));
                    table.row(cells);
                }
            }
        }
        let _ = writeln!(
            out,
            "  stiffness of each {part}, {} ({part} 1 is the lowest)",
            unit.unit
        );
        out += &table.text();
        if found
            .solutions
            .iter()
            .any(|solution| solution.stiffness_bounds.is_some())
        {
            out += "  above, below, to: what the data allow (95 %, the others free); the load factor is of the lowest that they allow\n";
        }
        if let Some(range) = found
            .solutions
            .iter()
            .find_map(|solution| solution.stiffness_range.as_ref())
        {
            let widths: Vec<String> = range.half_width_hz.iter().map(|w| format!("{w:.3}")).collect();
            let _ = writeln!(
                out,
                "  least, most: while each frequency moves by {} Hz",
                widths.join(", ")
            );
        }
        if found.solutions.len() > SOLUTIONS_SHOWN {
            let _ = writeln!(
                out,
                "  … and {} more (--json prints all)",
                found.solutions.len() - SOLUTIONS_SHOWN
            );
        }
        out += &shapes_text(&found.solutions, stiffness.frequencies_hz.len());
    }
    let choice = match stiffness.peaks_below_hz.as_slice() {
        [] => choice_text(found.choice, found.solutions.len()),
        peaks => {
            let peaks: Vec<String> = peaks.iter().map(|hz| format!("{hz:.3}")).collect();
            format!(
                "NOT CHOSEN: the record has a peak at {} Hz below the modes used that is none of them: if it is a mode of this direction, \
                 every stiffness is wrong [mode-missing].",
                peaks.join(", ")
            )
        }
    };
    let _ = writeln!(out, "  {choice}");
    if let Some(visibility) = &found.visibility {
        out += &visibility_text(visibility, part);
    }
    for note in &found.notes {
        let _ = writeln!(out, "  note: {note}");
    }
    out
}

/// What the data say of each stiffness: bounds where they give no more, else the value.
fn stiffness_shown(solution: &StiffnessSolution) -> Vec<f64> {
    match &solution.stiffness_bounds {
        None => solution.stiffness.clone(),
        Some(bounds) => bounds
            .iter()
            .flat_map(|bound| [bound.lower, bound.upper])
            .flatten()
            .collect(),
    }
}

fn stiffness_cells(solution: &StiffnessSolution, unit: &Prefixed) -> Vec<String> {
    match &solution.stiffness_bounds {
        None => {
            let each = solution.stiffness.iter();
            each.map(|k| format!("{:.4}", k * unit.factor)).collect()
        }
        Some(bounds) => bounds
            .iter()
            .map(|bound| bounds_words(bound, unit, Language::English))
            .collect(),
    }
}

/// A stiffness that the data only bound, in the unit given.
pub(crate) fn bounds_words(bound: &StiffnessBounds, unit: &Prefixed, language: Language) -> String {
    let number = |k: f64| unit.number(k, 3);
    match (bound.lower, bound.upper) {
        (Some(lower), Some(upper)) => {
            let (lower, upper) = (number(lower), number(upper));
            language.pick(format!("{lower} to {upper}"), format!("{lower} ~ {upper}"))
        }
        (Some(lower), None) => language.pick(
            format!("above {}", number(lower)),
            format!("{} 이상", number(lower)),
        ),
        (None, Some(upper)) => language.pick(
            format!("below {}", number(upper)),
            format!("{} 이하", number(upper)),
        ),
        (None, None) => language.pick("any", "임의").into(),
    }
}

/// What can be said of standing: one member of a family decides nothing, bounds only that it stands at the lowest.
fn solution_verdict(choice: Choice, solution: &StiffnessSolution, factor: Option<f64>) -> Verdict {
    match (factor, &solution.stiffness_bounds) {
        (Some(factor), None) if choice != Choice::Underdetermined => Verdict::of_load_factor(factor),
        (Some(factor), Some(_)) if Verdict::of_load_factor(factor) == Verdict::Stable => Verdict::Stable,
        _ => Verdict::Unknown,
    }
}

/// Modes that were not measured hang on every stiffness: they are shown where the data give each a value.
fn modes_shown(solution: &StiffnessSolution, measured: usize) -> &[NaturalMode] {
    let most = match solution.stiffness_bounds {
        Some(_) => measured.min(solution.modes.len()),
        None => solution.modes.len(),
    };
    &solution.modes[..most]
}

fn shapes_text(solutions: &[StiffnessSolution], measured: usize) -> String {
    let mut table = Table::new(&["solution", "mode", "f, Hz", "displacement, lowest first"], 1);
    for (i, solution) in solutions.iter().take(SOLUTIONS_SHOWN).enumerate() {
        for (j, mode) in modes_shown(solution, measured).iter().enumerate() {
            let shape: Vec<String> = mode.displacement.iter().map(|u| format!("{u:7.3}")).collect();
            let name = if j == 0 {
                (i + 1).to_string()
            } else {
                String::new()
            };
            table.row(vec![
                name,
                (j + 1).to_string(),
                format!("{:.4}", mode.frequency_hz),
                shape.join(" "),
            ]);
        }
    }
    format!("  mode shapes that tell them apart\n{}", table.text())
}

/// What the data allow to say, in one sentence.
fn choice_text(choice: Choice, solutions: usize) -> String {
    match choice {
        Choice::One => "The data choose this solution.".to_owned(),
        Choice::Bounded => {
            "One solution fits, but the data give some of its stiffness only bounds: no single answer [underdetermined]."
                .to_owned()
        }
        Choice::Indistinguishable if solutions == 1 => {
            "Two solutions meet here: no choice is made without a measured shape [indistinguishable]."
                .to_owned()
        }
        Choice::Indistinguishable => format!(
            "All {solutions} explain the frequencies equally well: no choice is made without a measured shape \
             [indistinguishable]."
        ),
        Choice::Underdetermined => {
            "Fewer data than unknowns: these are members of a family, not an answer [underdetermined]."
                .to_owned()
        }
        Choice::Impossible => "No stiffness gives these frequencies [no-real-root].".to_owned(),
    }
}

fn visibility_text(visibility: &Visibility, part: &str) -> String {
    let seen: Vec<String> = visibility
        .seen
        .iter()
        .map(|s| format!("{:.0} %", 100.0 * s))
        .collect();
    let mut out = format!("  seen by the data, {part} 1 first: {}", seen.join(", "));
    if visibility.free_directions > 0 {
        let plural = if visibility.free_directions == 1 {
            " stays"
        } else {
            "s stay"
        };
        let _ = write!(out, "; {} direction{plural} free", visibility.free_directions);
    }
    out.push('\n');
    out
}

/// Intervals of stiffness are of the measured frequencies: what the masses add.
pub(super) fn masses_text(survey: &SurveyAnswer, project: &Project) -> String {
    let mut each = survey
        .stiffness
        .iter()
        .flat_map(|found| &found.solutions.solutions);
    if !each.any(|solution| solution.stiffness_sd.is_some()) {
        return String::new();
    }
    let masses: Vec<&Quantity> = match &project.structure {
        Structure::Chain(part) => part.links.iter().map(|link| link.heaviness.quantity()).collect(),
        Structure::Frame(part) => part
            .storeys
            .iter()
            .map(|storey| storey.heaviness.quantity())
            .collect(),
        _ => Vec::new(),
    };
    let most = masses.iter().filter_map(|mass| mass.cov).fold(0.0, f64::max);
    let given = match most > 0.0 {
        true => format!(
            "; the file gives them a scatter of up to {:.0} %, which adds up to ± {:.0} % to every interval above (95 %, all off together)",
            100.0 * most,
            100.0 * TWO_SIDED_95 * most
        ),
        false => String::new(),
    };
    format!(
        "\n  intervals of stiffness: of the frequencies alone, masses taken as exact; 1 % more mass is 1 % more of every k{given}\n"
    )
}
