//! The check of a stack, as text.

use super::Table;
use dolmen::assess::{StackCheck, StackNote};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{CutLimits, Governing, LimitKind, StackLimitStates, Threshold};
use dolmen_work::answer::CheckAnswer;
use dolmen_work::state::{Check, MODES_SHOWN, SpringFit, StackAnswer, StackFrequencies};
use std::fmt::Write as _;

/// Directions nearer to an axis than this are that axis, rad.
const ON_AXIS: f64 = 1e-6;

/// What the verdict rests on, and what moves first.
pub(super) fn stack_verdict(answer: &StackAnswer) -> String {
    let check = &answer.check;
    let limits = &check.limits;
    if !limits.standing.stands() {
        return format!("{} [gravity-margin]", limits.standing);
    }
    if check.notes.contains(&StackNote::AnalysisFalls) {
        return format!("{} [limit-analysis]", StackNote::AnalysisFalls);
    }
    let least = Verdict::MARGINAL_BELOW_MARGIN;
    let mut out = limits.standing.to_string();
    if let Some(margin) = limits.gravity_margin {
        let side = if margin < least { "less than" } else { "at least" };
        let _ = write!(out, "; margin {margin:.3}, {side} {least:.3} [gravity-margin]");
    }
    if let Some(capacity) = &check.capacity {
        let _ = write!(
            out,
            "\nFIRST MOTION at {} horizontal: {} [first-motion]",
            in_g(capacity),
            first_words(answer, capacity)
        );
    }
    if let (Some(with), Some(first)) = (&limits.governing_with_ties, &limits.governing)
        && with.threshold.acceleration_g > first.threshold.acceleration_g
    {
        let _ = write!(
            out,
            "\n  with every tie at its strength {}: {}",
            in_g(&with.threshold),
            joint_words(limits, with)
        );
    }
    out
}

/// What moves first: a joint, or several stones as the limit analysis finds.
fn first_words(answer: &StackAnswer, capacity: &Threshold) -> String {
    match &answer.check.limits.governing {
        Some(first) if !moves_together(&answer.check) => joint_words(&answer.check.limits, first),
        _ => format!(
            "several stones move together towards {} [limit-analysis]",
            direction_word(capacity.direction)
        ),
    }
}

/// Whether the limit analysis finds less than the joints one by one.
fn moves_together(check: &StackCheck) -> bool {
    let lower = |note: &StackNote| matches!(note, StackNote::AnalysisLower { .. });
    check.notes.iter().any(lower)
}

fn joint_words(limits: &StackLimitStates, first: &Governing) -> String {
    let above = limits.cuts.get(first.cut).map_or("", |cut| cut.above.as_str());
    let direction = direction_word(first.threshold.direction);
    match first.kind {
        LimitKind::Uplift => format!("what stands on {above} rocks towards {direction}"),
        LimitKind::Sliding => format!("what stands on {above} slides towards {direction}"),
    }
}

fn in_g(threshold: &Threshold) -> String {
    if threshold.acceleration_g.is_finite() {
        format!("{:.3} g", threshold.acceleration_g)
    } else {
        "no acceleration".to_owned()
    }
}

/// "+x", "-y", or degrees from +x towards +y.
fn direction_word(direction: [f64; 2]) -> String {
    let [x, y] = direction;
    if y.abs() < ON_AXIS {
        return if x > 0.0 { "+x" } else { "-x" }.to_owned();
    }
    if x.abs() < ON_AXIS {
        return if y > 0.0 { "+y" } else { "-y" }.to_owned();
    }
    format!("{:.0}°", y.atan2(x).to_degrees())
}

/// Joint by joint.
pub(super) fn stack_text(answer: &StackAnswer) -> String {
    let limits = &answer.check.limits;
    let heads = [
        "what stands on",
        "z, m",
        "weight, kN",
        "area, m2",
        "kPa",
        "margin",
        "rocks at, g",
        "towards",
        "slides at, g",
        "towards",
    ];
    let mut table = Table::new(&heads, 1);
    for cut in &limits.cuts {
        table.row(row(cut));
    }
    let mut out = format!(
        "\nAt what horizontal acceleration it begins to move, joint by joint\n{}",
        table.text()
    );
    out += "  margin: what is left, without shaking, of the way from the middle of the joint to its edge, or of friction. \
            towards:\n  the way the part moves. Thresholds are those of first motion, not of collapse; vertical shaking a_z \
            scales them by 1 + a_z/g.\n";
    for note in &answer.check.notes {
        let _ = writeln!(out, "  note: {note}");
    }
    if !limits.not_planar.is_empty() {
        let _ = writeln!(
            out,
            "  note: {} parts rest on joints of different planes: only the limit analysis judges them",
            limits.not_planar.len()
        );
    }
    let thumb = &answer.check.period_of_thumb;
    let _ = writeln!(
        out,
        "  first frequency by its height alone: {:.1} Hz, wrong by a factor of two for two of the eight pagodas it was fitted to",
        1.0 / thumb.period_s
    );
    match &answer.frequencies {
        Some(frequencies) => out + &frequencies_text(frequencies),
        None => out,
    }
}

fn frequencies_text(frequencies: &StackFrequencies) -> String {
    let modes = match frequencies {
        StackFrequencies::Known { modes, .. } => modes,
        StackFrequencies::Refused(why) => return format!("\nNatural frequencies are not known: {why}\n"),
    };
    let heads = ["mode", "f, Hz", "T, s", "mass along x, %", "y, %", "z, %"];
    let mut table = Table::new(&heads, 1);
    for (i, mode) in modes.iter().take(MODES_SHOWN).enumerate() {
        let mut cells = vec![
            (i + 1).to_string(),
            format!("{:.3}", mode.frequency_hz),
            format!("{:.4}", 1.0 / mode.frequency_hz),
        ];
        cells.extend(
            mode.effective_mass_ratio
                .map(|ratio| format!("{:.1}", 100.0 * ratio)),
        );
        table.row(cells);
    }
    format!(
        "\nNatural frequencies on the springs of its joints\n{}  They are those of the stiffness given or assumed, with the joints as their own weight leaves \
         them (partly open\n  where it presses outside their middle third): no finding until a survey measures them.\n",
        table.text()
    )
}

/// What the springs must be to have the frequencies measured.
pub(super) fn spring_fits_text(fits: &[SpringFit]) -> String {
    let mut out = String::new();
    for fit in fits {
        if let Some(factor) = fit.factor {
            let each = fit.frequencies.iter().map(|(direction, found)| {
                format!(
                    "{direction} {:.3} Hz measured, {:.3} Hz then",
                    found.measured_hz, found.computed_hz
                )
            });
            let each: Vec<String> = each.collect();
            let _ = writeln!(
                out,
                "  survey {}: every joint {factor:.4} × as stiff fits its frequencies best ({})",
                fit.survey,
                each.join("; ")
            );
        }
        if !fit.not_compared.is_empty() {
            let _ = writeln!(
                out,
                "  note: survey {}: frequencies in direction {} are not compared: a stack sways along x and y",
                fit.survey,
                fit.not_compared.join(", ")
            );
        }
    }
    out
}

fn row(cut: &CutLimits) -> Vec<String> {
    let area_m2 = cut.contact.moments().area_m2;
    let mut cells = vec![
        cut.above.replace('\'', ""),
        format!("{:.3}", cut.origin_m[2]),
        format!("{:.3}", cut.weight_n / 1e3),
        format!("{area_m2:.4}"),
        format!("{:.1}", cut.weight_n / area_m2 / 1e3),
        format!("{:.3}", cut.gravity_margin),
    ];
    for threshold in [&cut.uplift, &cut.sliding] {
        match threshold {
            Some(threshold) if threshold.acceleration_g.is_finite() => {
                cells.push(format!("{:.4}", threshold.acceleration_g));
                cells.push(direction_word(threshold.direction));
            }
            Some(_) => cells.extend(["never".to_owned(), String::new()]),
            None => cells.extend(["-".to_owned(), String::new()]),
        }
    }
    cells
}

/// Versions of a stack side by side.
pub(super) fn stack_comparison(answer: &CheckAnswer) -> String {
    let mut heads = vec![
        "version",
        "verdict",
        "moves first",
        "at, g",
        "margin",
        "rocks at, g",
        "slides at, g",
    ];
    let own = answer.state.iter().map(|state| ("as it is", state));
    let others = answer.variants.iter().map(|v| (v.name.as_str(), &v.state));
    let all: Vec<_> = own.chain(others).collect();
    let with_demand = all.iter().any(|(_, state)| state.demand.is_some());
    if with_demand {
        heads.push("demand");
    }
    let mut table = Table::new(&heads, 3);
    for (name, state) in all {
        let Check::Stack(stack) = &state.check else {
            continue;
        };
        let limits = &stack.check.limits;
        let at = |first: &Option<Governing>| {
            first
                .as_ref()
                .map_or("-".to_owned(), |f| format!("{:.4}", f.threshold.acceleration_g))
        };
        let capacity = stack.check.capacity.as_ref();
        let first = match (&limits.governing, capacity) {
            (_, None) => "-".to_owned(),
            (Some(first), Some(_)) if !moves_together(&stack.check) => {
                let above = limits.cuts.get(first.cut).map_or("", |cut| &cut.above);
                let kind = match first.kind {
                    LimitKind::Uplift => "rocks on",
                    LimitKind::Sliding => "slides on",
                };
                format!("{kind} {}", above.replace('\'', ""))
            }
            _ => "several stones".to_owned(),
        };
        let mut cells = vec![
            name.to_owned(),
            state.verdict().word().to_owned(),
            first,
            capacity.map_or("-".to_owned(), |c| format!("{:.4}", c.acceleration_g)),
            limits
                .gravity_margin
                .map_or("-".to_owned(), |margin| format!("{margin:.3}")),
            at(&limits.uplift),
            at(&limits.sliding),
        ];
        if with_demand {
            cells.push(
                state
                    .demand_verdict()
                    .map_or("-", |verdict| verdict.words())
                    .to_owned(),
            );
        }
        table.row(cells);
    }
    format!("\nSide by side\n{}", table.text())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_directions_have_the_names_of_axes_or_degrees() {
        assert_eq!(direction_word([1.0, 0.0]), "+x");
        assert_eq!(direction_word([0.0, -1.0]), "-y");
        let half = 0.5f64.sqrt();
        assert_eq!(direction_word([-half, half]), "135°");
    }
}
