//! What `dolmen motion` prints.

use super::Table;
use super::simulation::drift_words;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_work::motion::base_line_drifts;
use dolmen_work::motion::{MatchAnswer, MotionReport, MotionSeries};
use std::fmt::Write as _;

/// Files and channels, the history, the measures, the match and the spectrum.
pub fn motion_report_text(report: &MotionReport) -> String {
    let mut out = String::new();
    for (file, channels) in &report.files {
        let format = channels.first().map_or("", |channel| channel.format.name());
        let plural = if channels.len() == 1 { "" } else { "s" };
        let _ = writeln!(out, "File {file}: {format}, {} channel{plural}", channels.len());
        for channel in channels {
            let name = if channel.name.is_empty() {
                "-"
            } else {
                &channel.name
            };
            let way = channel
                .orientation
                .map_or("direction not given".to_owned(), |way| way.to_string());
            let count = channel.acceleration_m_s2.len();
            let peak = channel
                .acceleration_m_s2
                .iter()
                .fold(0.0, |peak, a| f64::max(peak, a.abs()));
            let rate = dolmen_words::number::trimmed(1.0 / channel.time_step_s, 6);
            let _ = writeln!(
                out,
                "  {name}: {way}, {count} samples every {} s ({rate} Hz), in {}, peak {:.4} g",
                channel.time_step_s,
                channel.unit.symbol(),
                peak / STANDARD_GRAVITY_M_S2
            );
            if !channel.title.is_empty() {
                let _ = writeln!(out, "    {}", channel.title);
            }
            if let Some(mean) = channel.mean_subtracted_m_s2 {
                let _ = writeln!(
                    out,
                    "    its mean, {mean:.6} m/s², is taken off, as the format defines it"
                );
            }
        }
    }
    if let Some(first) = report.series.first() {
        let steps: Vec<String> = first.motion.history().iter().map(ToString::to_string).collect();
        let _ = writeln!(
            out,
            "Motion {}: {:.2} s{}{}",
            first.motion.name(),
            first.motion.duration_s(),
            if steps.is_empty() { "" } else { "; " },
            steps.join("; ")
        );
    }
    if let Some(answer) = &report.matched {
        let (before, after) = (answer.matched.before, answer.matched.after);
        let percent = |part: f64| 100.0 * part;
        let _ = writeln!(
            out,
            "Matched to {}: seed times {:.3}, then {} rounds of wavelets\n  misfit of the scaled seed {:.1} % (root mean square), {:+.1} to {:+.1} %\n  misfit of the motion      {:.1} %, {:+.1} to {:+.1} %",
            answer.demand,
            answer.matched.factor,
            answer.matched.rounds,
            percent(before.root_mean_square),
            percent(before.lowest),
            percent(before.highest),
            percent(after.root_mean_square),
            percent(after.lowest),
            percent(after.highest)
        );
        let [below, above] = answer.outside;
        let band = [answer.matched.periods_s.first(), answer.matched.periods_s.last()]
            .map(|t| t.copied().unwrap_or(0.0));
        let _ = writeln!(
            out,
            "  not matched: below {} s {:+.0} to {:+.0} %, above {} s {:+.0} to {:+.0} %",
            dolmen_words::number::trimmed(band[0], 3),
            percent(below.lowest),
            percent(below.highest),
            dolmen_words::number::trimmed(band[1], 3),
            percent(above.lowest),
            percent(above.highest)
        );
        if !answer.is_close() {
            let _ = writeln!(
                out,
                "NOT MATCHED: more than {} % off in the mean or {} % short somewhere; take a longer seed, or one of another kind",
                percent(MatchAnswer::MISFIT_MOST),
                percent(MatchAnswer::SHORT_MOST)
            );
        }
    }
    out += &measures(&report.series);
    out += &drifts(&report.series);
    out += &spectra(&report.series);
    out
}

fn measures(series: &[MotionSeries]) -> String {
    let mut names = vec!["measure".to_owned(), "unit".to_owned()];
    names.extend(series.iter().map(|one| one.name.clone()));
    let heads: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut table = Table::new(&heads, 2);
    let mut row = |name: &str, unit: &str, value: &dyn Fn(&MotionSeries) -> Option<f64>| {
        let cell = |one: &MotionSeries| value(one).map_or("-".to_owned(), figure);
        let mut cells = vec![name.to_owned(), unit.to_owned()];
        cells.extend(series.iter().map(cell));
        table.row(cells);
    };
    row("PGA", "g", &|one| {
        Some(one.measures.peak_acceleration_m_s2 / STANDARD_GRAVITY_M_S2)
    });
    row("PGV", "m/s", &|one| Some(one.measures.peak_velocity_m_s));
    row("PGD", "m", &|one| Some(one.measures.peak_displacement_m));
    row("velocity at the end", "m/s", &|one| {
        Some(one.measures.last_velocity_m_s)
    });
    row("displacement at the end", "m", &|one| {
        Some(one.measures.last_displacement_m)
    });
    row("Arias intensity", "m/s", &|one| {
        Some(one.measures.arias_intensity_m_s)
    });
    row("CAV", "m/s", &|one| {
        Some(one.measures.cumulative_absolute_velocity_m_s)
    });
    row("Housner intensity", "m", &|one| one.measures.housner_intensity_m);
    row("duration 5-95 %", "s", &|one| {
        Some(one.measures.significant_duration_s)
    });
    row("mean period", "s", &|one| one.measures.mean_period_s);
    row("predominant period", "s", &|one| {
        one.measures.predominant_period_s
    });
    table.text()
}

/// Four decimals; what rounds to zero has no sign.
fn figure(value: f64) -> String {
    let text = format!("{value:.4}");
    let is_zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    if is_zero { text.replace('-', "") } else { text }
}

/// What to know about series whose base line drifts.
fn drifts(series: &[MotionSeries]) -> String {
    let mut out = String::new();
    for one in series {
        let m = &one.measures;
        if base_line_drifts([m.last_displacement_m, m.peak_displacement_m]) {
            let _ = writeln!(out, "note: {}", drift_words(&one.name, m.last_displacement_m));
        }
    }
    out
}

/// A line for every tenth period of the spectra.
fn spectra(series: &[MotionSeries]) -> String {
    const PRINTED: usize = 10;
    let Some(first) = series.first().filter(|one| !one.spectrum.is_empty()) else {
        return String::new();
    };
    let mut names = vec!["period s".to_owned()];
    for one in series {
        names.push(format!("{} Sd mm", one.name));
        names.push(format!("{} PSA g", one.name));
    }
    let heads: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut table = Table::new(&heads, 0);
    for (k, ordinate) in first.spectrum.iter().enumerate().step_by(PRINTED) {
        let mut cells = vec![format!("{:.4}", ordinate.period_s)];
        for one in series {
            cells.push(format!("{:.3}", 1e3 * one.spectrum[k].displacement_m));
            cells.push(format!(
                "{:.4}",
                one.spectrum[k].pseudo_acceleration_m_s2() / STANDARD_GRAVITY_M_S2
            ));
        }
        table.row(cells);
    }
    let damping = 100.0 * first.spectrum[0].damping_ratio;
    format!(
        "Response spectrum, damping {damping} %, every tenth of {} periods\n{}",
        first.spectrum.len(),
        table.text()
    )
}
