//! Scatter, sensitivity and versions side by side, as text.

use super::Table;
use super::stack::stack_comparison;
use dolmen::structure::NaturalMode;
use dolmen_words::number::percent;
use dolmen_work::answer::CheckAnswer;
use dolmen_work::state::{Check, Sampled, SensitivityOf};

/// Elasticities below this are not listed: less than a hundredth of a per cent for one per cent of input.
const ELASTICITY_SHOWN_LEAST: f64 = 5e-5;

pub(super) fn sampled_text(sampled: &Sampled) -> String {
    let p = sampled.unstable;
    let plain = |share: f64| percent(share, 3).replace('\u{202f}', " ");
    let at = |share: f64| {
        let last = sampled.load_factors.len().saturating_sub(1);
        sampled
            .load_factors
            .get((share * last as f64).round() as usize)
            .copied()
            .unwrap_or(f64::NAN)
    };
    format!(
        "\nProbability that it falls under its own weight alone: {} ({:.0} % interval {} to {}; {} of {} samples, seed {}) [probability]\n  \
         {} inputs drawn; load factor 5 % / 50 % / 95 %: {:.3} / {:.3} / {:.3}\n",
        plain(p.estimate),
        100.0 * p.confidence,
        plain(p.lower),
        plain(p.upper),
        p.count,
        p.samples,
        p.seed,
        sampled.inputs.len(),
        at(0.05),
        at(0.5),
        at(0.95)
    )
}

pub(super) fn comparison(answer: &CheckAnswer) -> String {
    if matches!(answer.state.as_ref().map(|s| &s.check), Some(Check::Stack(_))) {
        return stack_comparison(answer);
    }
    let mut table = Table::new(
        &["version", "verdict", "load factor", "f1, Hz", "P(falls), 95 %"],
        2,
    );
    let own = answer.state.iter().map(|state| ("as it is", state));
    let others = answer
        .variants
        .iter()
        .map(|variant| (variant.name.as_str(), &variant.state));
    for (name, state) in own.chain(others) {
        let first = match &state.check {
            Check::Chain(check) => check.modes.first(),
            Check::Frame(directions) => directions.iter().find_map(|d| d.check.modes.first()),
            Check::Stack(_) | Check::Building(_) => None,
        };
        let building = match &state.check {
            Check::Building(answer) => {
                let modes = answer.stands.as_ref().map(|standing| &standing.modes.modes);
                modes
                    .and_then(|modes| modes.first())
                    .map(|mode| format!("{:.4}", mode.frequency_hz))
            }
            _ => None,
        };
        let dash = || "-".to_owned();
        table.row(vec![
            name.to_owned(),
            state.verdict().word().to_owned(),
            state.load_factor().map_or_else(dash, |x| format!("{x:.4}")),
            building.unwrap_or_else(|| first.map_or_else(dash, first_frequency)),
            state
                .sampled
                .as_ref()
                .map_or_else(dash, |s| format!("{:.4}", s.unstable.estimate)),
        ]);
    }
    format!("\nSide by side\n{}", table.text())
}

fn first_frequency(mode: &NaturalMode) -> String {
    if mode.omega_squared > 0.0 {
        format!("{:.4}", mode.frequency_hz)
    } else {
        "falls".to_owned()
    }
}

pub(super) fn sensitivity_text(answer: &CheckAnswer) -> String {
    let sensitivities = &answer.sensitivities;
    let of = match answer.sensitivity_of {
        SensitivityOf::LoadFactor => "load factor",
        SensitivityOf::EqualJoints => "stiffness that equal joints need",
        SensitivityOf::FirstMotion => "acceleration at which it begins to move",
    };
    if sensitivities.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["input", "value, SI", "% of it per % of input", "cov"], 1);
    for s in sensitivities
        .iter()
        .filter(|s| s.elasticity.abs() >= ELASTICITY_SHOWN_LEAST)
    {
        let cov = s.cov.map_or("-".to_owned(), |cov| format!("{cov}"));
        table.row(vec![
            s.input.clone(),
            format!("{:.6}", s.value),
            format!("{:+.4}", s.elasticity),
            cov,
        ]);
    }
    format!("\nSensitivity of the {of}, strongest first\n{}", table.text())
}
