//! `dolmen identify` as text.

use super::Table;
use super::decay::decay_text;
use super::project::{convention_words, heading_text, warnings_text};
use super::setups::{joint_heading, merged_text};
use crate::answer::{Answer, RecordAnswer, StiffnessAnswer, SurveyAnswer};
use crate::number::{beside_one, prefix, trimmed};
use crate::project::{Project, Quantity, Structure};
use dolmen::modal::{Method, Modes, Settings};
use dolmen::signal::Processing;
use dolmen::stability::Verdict;
use dolmen::structure::{Choice, StiffnessSolution, Visibility};
use std::fmt::Write as _;

/// Half width of a 95 % interval, in standard deviations of a normal variable.
const TWO_SIDED_95: f64 = 1.96;
/// Significant digits of a frequency that went in.
const FREQUENCY_DIGITS: usize = 5;
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
        out += &masses_text(survey, &answer.project);
    }
    out.push('\n');
    out + &warnings_text(&answer.project)
}

fn survey_text(survey: &SurveyAnswer) -> String {
    let mut out = format!("\n== survey {}\n", survey.name);
    if let Some(record) = &survey.records {
        out += &record_text(record);
    }
    if let Some(setups) = &survey.setups {
        for (i, record) in setups.records.iter().enumerate() {
            let _ = writeln!(out, "\n-- setup {}", i + 1);
            out += &record_text(record);
        }
        out += &merged_text(setups);
        match &setups.joint {
            None => out += &channel_shapes_text(&setups.merged.modes),
            Some(joint) => {
                out += &joint_heading(joint);
                out += &modes_text(&joint.modes);
                for note in &joint.notes {
                    let _ = writeln!(out, "  note: {note}");
                }
            }
        }
    }
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

/// Intervals of stiffness are of the measured frequencies: what the masses add.
fn masses_text(survey: &SurveyAnswer, project: &Project) -> String {
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

fn record_text(record: &RecordAnswer) -> String {
    let modes = &record.analysis.modes;
    let unit = if record.unit.is_empty() {
        "unit not given"
    } else {
        &record.unit
    };
    let mut out = format!(
        "\nRecord {}: {} channels × {} samples at {} Hz ({:.1} min), {unit}\n",
        record.file,
        record.channels,
        record.samples,
        record.sampling_rate_hz,
        record.samples as f64 / record.sampling_rate_hz / 60.0
    );
    for remark in &record.remarks {
        let _ = writeln!(out, "  file: {remark}");
    }
    for step in &modes.history {
        let _ = match step {
            Processing::LongestSpan { .. } => writeln!(out, "  warning: {step} [lost-samples]"),
            _ => writeln!(out, "  done: {step}"),
        };
    }
    for fault in &record.faults {
        let _ = writeln!(out, "  warning: {fault} [channel-fault]");
    }
    out += &chosen_text(modes, &record.analysis.settings);
    out += &modes_text(modes);
    if let Some(decay) = &record.analysis.decay {
        out += &decay_text(decay);
    }
    for note in &record.analysis.notes {
        let _ = writeln!(out, "  note: {note}");
    }
    out
}

/// The references that were chosen, and why.
fn references_text(modes: &Modes, chosen: &Settings) -> String {
    let Some(kept) = chosen.references_keep else {
        return String::new();
    };
    let channels = chosen.references.iter().filter_map(|&c| modes.channels.get(c));
    let names: Vec<&str> = channels.map(|channel| channel.name.as_str()).collect();
    format!(
        "  references: {}: they keep {:.0} % of the motion at the peaks, and few make many degrees possible\n",
        names.join(", "),
        100.0 * kept
    )
}

/// What was chosen from the data.
fn chosen_text(modes: &Modes, chosen: &Settings) -> String {
    let method = modes.method;
    let [low, high] = chosen.range_hz;
    if method == Method::Era {
        return format!(
            "  era: a free decay, {} block rows, model of order {}, modes sought in {low:.3} to {high:.3} Hz\n",
            chosen.block_rows, chosen.order_most
        );
    }
    if method == Method::Plscf {
        return format!(
            "  plscf, chosen from the data: {} lines of half spectra at {:.4} Hz, from {} lags, orders to {} ({} degrees),\n  \
             modes sought in {low:.3} to {high:.3} Hz; shapes have no standard deviation [block-rows]\n{}",
            chosen.lines,
            chosen.sampling_rate_hz,
            2 * chosen.block_rows - 1,
            chosen.order_most,
            chosen.order_most / chosen.references.len().max(1),
            references_text(modes, chosen),
        );
    }
    let method = method.name();
    if chosen.lines > 0 {
        return format!(
            "  {method}: peaks of a spectrum of {} lines, modes sought in {low:.3} to {high:.3} Hz\n",
            chosen.lines
        );
    }
    format!(
        "  {method}, chosen from the data: {} block rows at {:.4} Hz (at least {} for the lowest peak, {:.3} Hz), orders to {}, \
         modes\n  sought in {low:.3} to {high:.3} Hz [block-rows]\n",
        chosen.block_rows,
        chosen.sampling_rate_hz,
        chosen.block_rows_least,
        chosen.lowest_hz,
        chosen.order_most,
    )
}

fn modes_text(modes: &Modes) -> String {
    if modes.modes.is_empty() {
        return "\nNo mode was found.\n".to_owned();
    }
    let of_peaks = matches!(modes.method, Method::Fdd | Method::Efdd | Method::Fsdd);
    let heads = [
        "mode",
        "f, Hz",
        "± 95 %",
        "damping, %",
        "± 95 %",
        "floor ±, %",
        "MPC",
        "cycles",
        "kurtosis",
        if of_peaks { "window bias, %" } else { "orders" },
    ];
    let mut table = Table::new(&heads, 1);
    for (i, mode) in modes.modes.iter().enumerate() {
        let some = |x: Option<f64>, decimals: usize| x.map_or("-".to_owned(), |x| format!("{x:.decimals$}"));
        let floor = mode
            .damping_ratio
            .filter(|_| modes.method != Method::Era) // the floor is that of ambient vibration
            .map(|zeta| 100.0 * TWO_SIDED_95 * zeta * mode.damping_floor());
        table.row(vec![
            (i + 1).to_string(),
            format!("{:.4}", mode.frequency_hz),
            some(mode.frequency_sd_hz.map(|sd| TWO_SIDED_95 * sd), 4),
            some(mode.damping_ratio.map(|zeta| 100.0 * zeta), 3),
            some(mode.damping_ratio_sd.map(|sd| 100.0 * TWO_SIDED_95 * sd), 3),
            some(floor, 3),
            format!("{:.3}", mode.phase_collinearity),
            format!("{:.0}", mode.cycles),
            some(mode.kurtosis.map(|k| k.kurtosis), 2),
            if of_peaks {
                some(mode.window_bias.map(|bias| 100.0 * bias), 1)
            } else {
                mode.orders.len().to_string()
            },
        ]);
    }
    let mut out = format!(
        "\nModes\n{}  floor: what any method can reach at best in this many cycles [damping-floor]; kurtosis: 3 random, 1.5 a \
         machine [harmonics]\n",
        table.text()
    );
    if of_peaks {
        out += "  window bias: what the window of the spectrum would have added to the damping ratio; it has been taken out\n";
    }
    out += &channel_shapes_text(modes);
    out
}

/// Shapes at the sensors: modulus with the sign of its phase, the largest 1.
fn channel_shapes_text(modes: &Modes) -> String {
    let mut heads: Vec<String> = vec!["channel".into(), "place, m".into(), "direction".into()];
    heads.extend(
        modes
            .modes
            .iter()
            .map(|mode| format!("{:.3} Hz", mode.frequency_hz)),
    );
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let mut table = Table::new(&heads, 3);
    for (c, channel) in modes.channels.iter().enumerate() {
        let numbers = |v: [f64; 3]| format!("{} {} {}", v[0], v[1], v[2]);
        let dash = || "-".to_owned();
        let mut row = vec![
            channel.name.clone(),
            channel.position_m.map_or_else(dash, numbers),
            channel.direction.map_or_else(dash, numbers),
        ];
        row.extend(modes.modes.iter().map(|mode| {
            let component = mode.shape[c];
            format!("{:+.3}", component.norm().copysign(component.re))
        }));
        table.row(row);
    }
    format!(
        "  shapes at the sensors (modulus, signed by phase)\n{}",
        table.text()
    )
}

fn data_text(stiffness: &StiffnessAnswer) -> String {
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
        heads.extend(["misfit".into(), "load factor".into(), "verdict".into()]);
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
            let factor = stiffness.load_factors.get(i).copied().unwrap_or(f64::NAN);
            cells.push(beside_one(factor, 4));
            let verdict = match found.choice {
                Choice::Underdetermined => Verdict::Unknown, // one member of a family
                _ => Verdict::of_load_factor(factor),
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
