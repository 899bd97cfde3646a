//! `dolmen identify` as text.

use super::Table;
use super::decay::decay_text;
use super::project::{heading_text, warnings_text};
use super::setups::{joint_heading, merged_text};
use super::stiffness::{data_text, masses_text, stiffness_text};
use dolmen::modal::{Method, Modes, Settings};
use dolmen::signal::{Channel, Processing};
use dolmen_words::advice::Advice as _;
use dolmen_words::number::{TWO_SIDED_95, counted};
use dolmen_work::answer::IdentifyAnswer;
use dolmen_work::surveyed::{RecordAnswer, SurveyAnswer};
use std::fmt::Write as _;

/// What was identified from every survey.
pub fn identification_text(answer: &IdentifyAnswer) -> String {
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
                    let _ = writeln!(out, "  note: {}", note.advised());
                }
            }
        }
    }
    if let Some(why) = &survey.without_stiffness {
        let _ = writeln!(out, "  note: {why}");
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

fn record_text(record: &RecordAnswer) -> String {
    let modes = &record.analysis.modes;
    let unit = if record.unit.is_empty() {
        "unit not given"
    } else {
        &record.unit
    };
    let mut out = format!(
        "\nRecord {}: {} × {} samples at {} Hz ({:.1} min), {unit}\n",
        record.file,
        counted(record.channels, "channel", "channels"),
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
        let _ = writeln!(out, "  warning: {} [channel-fault]", fault.advised());
    }
    out += &chosen_text(
        modes.method,
        &record.analysis.fdd_modes.channels,
        &record.analysis.settings,
    );
    out += &modes_text(modes);
    if let Some(decay) = &record.analysis.decay {
        out += &decay_text(decay);
    }
    for note in &record.analysis.notes {
        let _ = writeln!(out, "  note: {}", note.advised());
    }
    out
}

/// The references that were chosen, and why.
fn references_text(channels: &[Channel], chosen: &Settings) -> String {
    let Some(kept) = chosen.references_keep else {
        return String::new();
    };
    let channels = chosen.references.iter().filter_map(|&c| channels.get(c));
    let names: Vec<&str> = channels.map(|channel| channel.name.as_str()).collect();
    format!(
        "  references: {}: they keep {:.0} % of the motion at the peaks, and few make many degrees possible\n",
        names.join(", "),
        100.0 * kept
    )
}

/// What was chosen from the data.
fn chosen_text(method: Method, channels: &[Channel], chosen: &Settings) -> String {
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
            references_text(channels, chosen),
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
