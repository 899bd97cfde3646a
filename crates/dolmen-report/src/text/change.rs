//! `dolmen compare` as text.

use super::Table;
use super::project::{heading_text, warnings_text};
use dolmen::assess::{Difference, ModeChange, SurveyChange, TemperatureKnowledge};
use dolmen::modal::ObservedMode;
use dolmen_project::Project;
use dolmen_words::advice::Advice as _;
use std::fmt::Write as _;

/// What changed from one survey to another.
pub fn change_text(project: &Project, file: &str, change: &SurveyChange) -> String {
    let mut out = heading_text(project, file);
    let _ = writeln!(
        out,
        "\n== what changed from survey {} to survey {}",
        change.from, change.to
    );
    let temperature = |name: &str| {
        project
            .surveys
            .iter()
            .find(|s| s.name == name)
            .and_then(|s| s.temperature_c)
    };
    let temperatures = [temperature(&change.from), temperature(&change.to)];
    for line in doubt_lines(change) {
        let _ = writeln!(out, "{line}");
    }
    let _ = writeln!(out, "{}", temperature_sentence(change, temperatures));
    out += &frequencies_text(change);
    out += &dampings_text(change);
    for sentence in sentences(change) {
        let _ = writeln!(out, "{sentence}");
    }
    for note in &change.notes {
        let _ = writeln!(out, "  note: {}", note.advised());
    }
    out.push('\n');
    out + &warnings_text(project)
}

fn signed(value: f64, decimals: usize) -> String {
    format!("{value:+.decimals$}")
}

fn probability(p: f64) -> String {
    if p < 1e-4 {
        "< 0.0001".to_owned()
    } else {
        format!("{p:.4}")
    }
}

/// What is known of the temperatures, in a sentence.
pub(crate) fn temperature_sentence(change: &SurveyChange, temperatures_c: [Option<f64>; 2]) -> String {
    let both = match temperatures_c {
        [Some(before), Some(after)] => {
            format!("{before} and {after} °C")
        }
        _ => String::new(),
    };
    match &change.temperature {
        TemperatureKnowledge::NotMeasured => {
            "The temperature of one survey, or of both, is not given: a change may be the weather's [survey-change].".to_owned()
        }
        TemperatureKnowledge::Same => format!("Both at {} °C.", temperatures_c[0].unwrap_or(f64::NAN)),
        TemperatureKnowledge::Unexplained { .. } => format!(
            "Temperatures {both}, and what that does to this structure is not known: a change may be the weather's [survey-change]."
        ),
        TemperatureKnowledge::Corrected { .. } => {
            format!("Temperatures {both}: what they explain is taken out of the changes.")
        }
    }
}

fn frequencies_text(change: &SurveyChange) -> String {
    if change.modes.is_empty() {
        return String::new();
    }
    let mut table = Table::new(
        &[
            "mode",
            "before, Hz",
            "after, Hz",
            "weather, %",
            "change, %",
            "± 95 %",
            "p",
            "p of all",
            "seen from, %",
            "stiffness, %",
            "MAC",
        ],
        1,
    );
    for (i, mode) in change.modes.iter().enumerate() {
        let weather = mode
            .explained_by_temperature
            .map_or("-".to_owned(), |r| signed(100.0 * r, 2));
        let mut cells = vec![
            (i + 1).to_string(),
            format!("{:.4}", mode.from.frequency_hz),
            format!("{:.4}", mode.to.frequency_hz),
            weather,
        ];
        cells.extend(difference(&mode.frequency, 2));
        cells.push(signed(100.0 * mode.uniform_stiffness, 1));
        cells.push(
            mode.pair
                .assurance
                .map_or("-".to_owned(), |mac| format!("{mac:.3}")),
        );
        table.row(cells);
    }
    format!(
        "\nFrequencies\n{}  change: without what the weather explains; p: probability of such a change by chance, alone and among all of \
         them (Holm);\n  seen from: the least change found with {:.0} % probability; stiffness: if it changed alike everywhere\n",
        table.text(),
        100.0 * change.power
    ) + &fitted_text(change)
}

/// The lines over temperature, where they were fitted.
fn fitted_text(change: &SurveyChange) -> String {
    let mut out = String::new();
    for (i, mode) in change.modes.iter().enumerate() {
        if let Some(line) = &mode.fitted {
            let _ = writeln!(
                out,
                "  weather of mode {}: {:+.3} ± {:.3} % per °C (standard deviation), fitted to {} surveys at {} to {} °C, the structure taken as unchanged through them",
                i + 1,
                100.0 * line.per_c,
                100.0 * line.sd_per_c,
                line.surveys,
                line.range_c[0],
                line.range_c[1]
            );
        }
    }
    out
}

/// Change, interval, p, p of all, least seen.
fn difference(d: &Difference, decimals: usize) -> Vec<String> {
    let mut cells = vec![signed(100.0 * d.relative, decimals)];
    match &d.evidence {
        Some(e) => cells.extend([
            format!("{:.decimals$}", 100.0 * e.half_width_95),
            probability(e.p),
            probability(e.p_holm),
            format!("{:.decimals$}", 100.0 * e.detectable),
        ]),
        None => cells.extend(["-"; 4].map(str::to_owned)),
    }
    cells
}

fn dampings_text(change: &SurveyChange) -> String {
    if change.modes.iter().all(|m| m.damping.is_none()) {
        return String::new();
    }
    let mut table = Table::new(
        &[
            "mode",
            "before, %",
            "after, %",
            "change, %",
            "± 95 %",
            "p",
            "p of all",
            "seen from, %",
        ],
        1,
    );
    for (i, mode) in change.modes.iter().enumerate() {
        let Some(damping) = &mode.damping else { continue };
        let percent = |zeta: Option<f64>| zeta.map_or("-".to_owned(), |z| format!("{:.3}", 100.0 * z));
        let mut cells = vec![
            (i + 1).to_string(),
            percent(mode.from.damping_ratio),
            percent(mode.to.damping_ratio),
        ];
        cells.extend(difference(damping, 0));
        table.row(cells);
    }
    format!(
        "\nDamping ratios (relative changes; they follow the strength of the motion too)\n{}\n",
        table.text()
    )
}

/// What was not compared at all, and how else modes may be paired: said before anything else.
fn doubt_lines(change: &SurveyChange) -> Vec<String> {
    let mut lines = Vec::new();
    if !change.other_pairing_hz.is_empty() {
        let pairs = change.other_pairing_hz.iter();
        let each: Vec<String> = pairs
            .map(|[before, after]| {
                format!(
                    "{before:.3} -> {after:.3} Hz ({:+.1} %)",
                    100.0 * (after / before - 1.0)
                )
            })
            .collect();
        lines.push(format!(
            "PAIRING NOT SURE: more modes find a partner by {}; what is below rests on the nearest pairs [survey-change]",
            each.join(", ")
        ));
    }
    for lost in &change.not_compared {
        let (which, comma) = match lost.is_lowest {
            true => ("the lowest mode, ", ","),
            false => ("", ""),
        };
        let mut line = format!(
            "NOT COMPARED: {which}{:.3} Hz{comma} was not found again",
            lost.from.frequency_hz
        );
        if let (Some(may_be), Some([r, stiffness])) = (&lost.may_be, lost.change()) {
            let shape = lost
                .assurance
                .map_or(String::new(), |mac| format!(", shape alike (MAC {mac:.2})"));
            let _ = write!(
                line,
                "; {:.3} Hz is new{shape}: if it is the same mode it {} by {:.0} % ({:+.0} % of stiffness)",
                may_be.frequency_hz,
                if r < 0.0 { "fell" } else { "rose" },
                100.0 * r.abs(),
                100.0 * stiffness
            );
        }
        lines.push(line + " [survey-change]");
    }
    let damping: Vec<f64> = change
        .damping_changed()
        .map(|(_, d)| 100.0 * d.relative)
        .collect();
    let least = damping.iter().copied().fold(f64::INFINITY, f64::min);
    let most = damping.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if let Some(range) = match damping.len() {
        0 => None,
        1 => Some(format!("{most:+.0} %")),
        _ => Some(format!("{least:+.0} to {most:+.0} %")),
    } {
        lines.push(format!(
            "DAMPING CHANGED beyond chance in {} of {} modes ({range}) [survey-change]",
            damping.len(),
            change.damping_tested()
        ));
    }
    lines
}

/// What may be said, and what may not.
fn sentences(change: &SurveyChange) -> Vec<String> {
    let mut said = Vec::new();
    let tested = change.tested();
    let alpha = 100.0 * change.significance;
    let changed: Vec<&ModeChange> = change.changed().collect();
    if !changed.is_empty() {
        said.push(format!(
            "Changed beyond chance ({alpha} % for all together): {} of {tested} frequencies [survey-change].",
            changed.len()
        ));
        for mode in &changed {
            said.push(changed_sentence(mode, change.temperature.leaves_doubt()));
        }
    }
    said.extend(damping_sentence(change));
    if let Some(detectable) = change.detectable() {
        let least = 100.0 * detectable;
        let power = 100.0 * change.power;
        let lead = if changed.is_empty() {
            let all = change.modes.len() + change.lost.len();
            let of_all = if tested < all {
                format!(" of {all}")
            } else {
                String::new()
            };
            format!(
                "No change was shown in {tested}{of_all} frequencies. That does not say that there is none: "
            )
        } else {
            String::new()
        };
        said.push(format!(
            "{lead}A change of {least:.2} % of any one frequency would have been seen with {power:.0} % probability; smaller ones could have \
             been missed."
        ));
    }
    let untested = change.modes.len() - tested;
    if untested > 0 {
        said.push(format!(
            "{untested} of {} frequencies have no standard deviation in one survey or the other: whether they changed cannot be said.",
            change.modes.len()
        ));
    }
    said.extend(pairing_sentences(change));
    said
}

/// Which damping ratios changed beyond chance.
fn damping_sentence(change: &SurveyChange) -> Option<String> {
    let each: Vec<String> = change
        .damping_changed()
        .map(|(mode, damping)| {
            let half = damping.evidence.as_ref().map_or(f64::NAN, |e| e.half_width_95);
            format!(
                "{:.3} Hz {:+.0} ± {:.0} %",
                mode.from.frequency_hz,
                100.0 * damping.relative,
                100.0 * half
            )
        })
        .collect();
    (!each.is_empty()).then(|| {
        format!(
            "Damping changed beyond chance ({} % for all together): {} of {} ratios [survey-change]: {}. It follows the strength of the motion too; at \
             equal strength, joints or cracks that rub do this before any frequency moves.",
            100.0 * change.significance,
            each.len(),
            change.damping_tested(),
            each.join(", ")
        )
    })
}

fn changed_sentence(mode: &ModeChange, doubt: bool) -> String {
    let half = mode
        .frequency
        .evidence
        .as_ref()
        .map_or(f64::NAN, |e| e.half_width_95);
    let stiffness_half = 2.0 * (1.0 + mode.frequency.relative).abs() * half;
    let word = if mode.frequency.relative < 0.0 {
        "fell"
    } else {
        "rose"
    };
    let mut text = format!(
        "  {:.4} Hz {word} by {:.2} ± {:.2} %: {:+.1} ± {:.1} % of stiffness, if it changed alike everywhere and no mass did.",
        mode.from.frequency_hz,
        100.0 * mode.frequency.relative.abs(),
        100.0 * half,
        100.0 * mode.uniform_stiffness,
        100.0 * stiffness_half
    );
    if let (true, Some(per_c)) = (doubt, mode.explaining_per_c) {
        let _ = write!(text, " {:+.3} % per °C would explain it.", 100.0 * per_c);
    }
    text
}

fn pairing_sentences(change: &SurveyChange) -> Vec<String> {
    let list = |modes: &[ObservedMode]| {
        let all: Vec<String> = modes.iter().map(|m| format!("{:.3}", m.frequency_hz)).collect();
        all.join(", ")
    };
    let mut said = Vec::new();
    // those that are named first, NOT COMPARED, are not named again
    let said_first = |mode: &ObservedMode| change.not_compared.iter().any(|lost| lost.from == *mode);
    let others: Vec<ObservedMode> = change.lost.iter().filter(|m| !said_first(m)).cloned().collect();
    let why = "may have moved further than pairs may lie apart (frequency_within), or was not shaken.";
    if !others.is_empty() {
        said.push(format!(
            "Not found again: {} Hz. Such a mode {why}",
            list(&others)
        ));
    } else if !change.lost.is_empty() {
        said.push(format!("A mode that is not found again {why}"));
    }
    if !change.new.is_empty() {
        said.push(format!("New: {} Hz.", list(&change.new)));
    }
    let of = |which: &dyn Fn(&ModeChange) -> bool| {
        let all = change.modes.iter().filter(|m| which(m));
        let all: Vec<String> = all.map(|m| format!("{:.3}", m.from.frequency_hz)).collect();
        all.join(", ")
    };
    let by_frequency = of(&|m| m.pair.assurance.is_none());
    if !by_frequency.is_empty() {
        said.push(format!(
            "Paired by frequency alone, since fewer than two sensors are in both surveys: {by_frequency} Hz."
        ));
    }
    let doubtful = of(&|m| m.pair.doubtful());
    if !doubtful.is_empty() {
        said.push(format!(
            "Another pairing is nearly as good: {doubtful} Hz may not be the same mode in both surveys."
        ));
    }
    said
}
