//! `dolmen identify` as text.

use super::Table;
use super::project::{convention_words, heading_text, warnings_text};
use crate::answer::{Answer, StiffnessAnswer, SurveyAnswer};
use crate::number::prefix;
use dolmen::structure::{Choice, StiffnessSolution, Visibility};
use std::fmt::Write as _;

/// Half width of a 95 % interval, in standard deviations of a normal variable.
const TWO_SIDED_95: f64 = 1.96;
/// Solutions printed in full; the rest are counted.
const SOLUTIONS_SHOWN: usize = 24;

/// What was identified from every survey.
pub fn identification_text(answer: &Answer) -> String {
    let mut out = heading_text(&answer.project, &answer.file);
    if answer.surveys.is_empty() {
        out +=
            "\nThe file has no [survey.NAME] with frequencies or records, so there is nothing to identify.\n";
    }
    for survey in &answer.surveys {
        out += &survey_text(survey);
    }
    out.push('\n');
    out + &warnings_text(&answer.project)
}

fn survey_text(survey: &SurveyAnswer) -> String {
    let mut out = format!("\n== survey {}\n", survey.name);
    let mut direction = "";
    for stiffness in &survey.stiffness {
        if stiffness.direction != direction {
            out += &data_text(stiffness);
            direction = &stiffness.direction;
        }
        out += &stiffness_text(stiffness);
    }
    out
}

fn data_text(stiffness: &StiffnessAnswer) -> String {
    let frequencies: Vec<String> = stiffness.frequencies_hz.iter().map(f64::to_string).collect();
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

fn stiffness_text(stiffness: &StiffnessAnswer) -> String {
    let mut out = String::new();
    if let Some(convention) = stiffness.convention {
        let _ = writeln!(out, "\n Convention {}", convention_words(convention));
    }
    let found = &stiffness.solutions;
    let (part, unit) = words(stiffness);
    let all: Vec<f64> = found
        .solutions
        .iter()
        .flat_map(|s| s.stiffness.iter().copied())
        .collect();
    let unit = prefix(&all, unit);
    if !found.solutions.is_empty() {
        let parts = found.solutions[0].stiffness.len();
        let mut heads: Vec<String> = vec!["solution".into()];
        heads.extend((1..=parts).map(|i| format!("k{i}")));
        heads.extend(["misfit".into(), "stands".into()]);
        let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
        let mut table = Table::new(&heads, 1);
        for (i, solution) in found.solutions.iter().take(SOLUTIONS_SHOWN).enumerate() {
            let mut cells = vec![(i + 1).to_string()];
            cells.extend(
                solution
                    .stiffness
                    .iter()
                    .map(|k| format!("{:.4}", k * unit.factor)),
            );
            cells.push(format!("{:.1e}", solution.misfit));
            cells.push(if solution.stands { "yes" } else { "no" }.into());
            table.row(cells);
            if let Some(sd) = &solution.stiffness_sd {
                let mut cells = vec!["  ± 95 %".to_owned()];
                cells.extend(
                    sd.iter()
                        .map(|sd| format!("{:.4}", TWO_SIDED_95 * sd * unit.factor)),
                );
                table.row(cells);
            }
        }
        let _ = writeln!(
            out,
            "  stiffness of each {part}, {} ({part} 1 is the lowest)",
            unit.unit
        );
        out += &table.text();
        if found.solutions.len() > SOLUTIONS_SHOWN {
            let _ = writeln!(
                out,
                "  … and {} more (--json prints all)",
                found.solutions.len() - SOLUTIONS_SHOWN
            );
        }
        out += &shapes_text(&found.solutions);
    }
    let _ = writeln!(out, "  {}", choice_text(found.choice, found.solutions.len()));
    if let Some(visibility) = &found.visibility {
        out += &visibility_text(visibility, part);
    }
    for note in &found.notes {
        let _ = writeln!(out, "  note: {note}");
    }
    out
}

fn shapes_text(solutions: &[StiffnessSolution]) -> String {
    let mut table = Table::new(&["solution", "mode", "f, Hz", "displacement, lowest first"], 1);
    for (i, solution) in solutions.iter().take(SOLUTIONS_SHOWN).enumerate() {
        for (j, mode) in solution.modes.iter().enumerate() {
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
        let _ = write!(out, "; {} directions stay free", visibility.free_directions);
    }
    out.push('\n');
    out
}
