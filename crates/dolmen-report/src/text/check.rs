//! `dolmen check` as text.

use super::Table;
use super::building::building_text;
use super::demand::demand_text;
use super::project::{heading_text, made_stones_text, warnings_text};
use super::stack::{spring_fits_text, stack_text};
use super::verdict::verdict_line;
use super::versions::{comparison, sampled_text, sensitivity_text};
use dolmen::assess::{CentroidEffect, FrameCheck};
use dolmen::stability::{ChainLimits, ChainStability, FrameStability};
use dolmen::structure::NaturalMode;
use dolmen_project::{Project, Structure};
use dolmen_words::number::{percent, prefix};
use dolmen_work::answer::CheckAnswer;
use dolmen_work::judgement::{VersionJudgement, judge_check};
use dolmen_work::state::{Check, DirectionCheck, State};
use std::fmt::Write as _;

/// Digits of a stiffness in the table of limits: as many as the theory is known to.
const LIMIT_DECIMALS: usize = 4;
/// Factors nearer to 1 than this are 1.
const ROUNDING: f64 = 1e-9;

/// The whole check of a project and its variants.
pub fn check_text(answer: &CheckAnswer) -> String {
    let mut out = heading_text(&answer.project, &answer.file);
    let Some(state) = &answer.state else {
        out += "\nNothing is modelled (kind = \"survey\"), so there is nothing to check: run `dolmen identify`.\n";
        return out + &warnings_text(&answer.project);
    };
    let judgement = judge_check(answer);
    let mut versions = judgement.versions.iter();
    if let Some(as_it_is) = versions.next() {
        out += &state_text(state, as_it_is, &answer.project);
    }
    out += &made_stones_text(&answer.project);
    for (variant, judged) in answer.variants.iter().zip(versions) {
        let title = variant.title.as_ref().map_or("", |names| names.english());
        let _ = writeln!(out, "\n== variant {} {title}", variant.name);
        let same_limits = same_limits(state, &variant.state);
        out += &verdict_line(&variant.state, judged);
        if !same_limits {
            out += &limits_of(&variant.state);
        }
        out += &stiffness_of(&variant.state);
        out += &variant
            .state
            .demand
            .as_ref()
            .map_or_else(String::new, demand_text);
        let own = answer.project.variants.iter().find(|v| v.name == variant.name);
        for warning in own.iter().flat_map(|v| &v.project.warnings) {
            if !answer.project.warnings.contains(warning) {
                let _ = writeln!(out, "  note: line {}: {}", warning.line, warning.message);
            }
        }
    }
    if !answer.variants.is_empty() {
        out += &comparison(answer);
    }
    out += &sensitivity_text(answer);
    out.push('\n');
    out += &warnings_text(&answer.project);
    out
}

fn state_text(state: &State, judged: &VersionJudgement, project: &Project) -> String {
    let mut out = verdict_line(state, judged);
    out += &limits_of(state);
    out += &spring_fits_text(&state.spring_fits);
    if let (Check::Chain(check), Structure::Chain(part)) = (&state.check, &project.structure) {
        let names: Vec<&str> = part
            .links
            .iter()
            .map(|l| l.name.as_deref().unwrap_or(""))
            .collect();
        out += &centroids_text(&check.centroids, &check.limits, &names);
    }
    out += &stiffness_of(state);
    out += &state.demand.as_ref().map_or_else(String::new, demand_text);
    out
}

fn same_limits(one: &State, other: &State) -> bool {
    match (&one.check, &other.check) {
        (Check::Chain(a), Check::Chain(b)) => a.limits == b.limits,
        (Check::Frame(a), Check::Frame(b)) => {
            let loads =
                |checks: &[DirectionCheck]| checks.iter().map(|d| d.check.geometric_n_m.clone()).collect();
            let (a, b): (Vec<_>, Vec<_>) = (loads(a), loads(b));
            a == b
        }
        (Check::Stack(a), Check::Stack(b)) => a == b,
        (Check::Building(a), Check::Building(b)) => a == b,
        _ => false,
    }
}

fn limits_of(state: &State) -> String {
    match &state.check {
        Check::Chain(check) => chain_limits_text(&check.limits),
        Check::Frame(directions) => directions
            .first()
            .map_or_else(String::new, |d| frame_limits_text(&d.check)),
        Check::Stack(answer) => stack_text(answer),
        Check::Building(answer) => building_text(answer),
    }
}

fn stiffness_of(state: &State) -> String {
    let mut out = String::new();
    match &state.check {
        Check::Chain(check) => {
            if let Some(stability) = &check.stability {
                out += &chain_stability_text(stability);
            }
            out += &modes_text(&check.modes, "link tops");
        }
        Check::Frame(directions) => {
            for DirectionCheck {
                direction,
                check,
                slipping,
            } in directions
            {
                let _ = writeln!(out, "\nDirection {direction}");
                match &check.stability {
                    Some(stability) => out += &frame_stability_text(stability),
                    None => out += "  stiffness not known: run `dolmen identify`\n",
                }
                out += &modes_text(&check.modes, "levels");
                if let Some(slipping) = slipping {
                    out += &slipping_text(slipping);
                }
                for note in &check.notes {
                    let _ = writeln!(out, "  note: {note}");
                }
            }
        }
        Check::Stack(_) | Check::Building(_) => {}
    }
    if let Some(sampled) = &state.sampled {
        out += &sampled_text(sampled);
    }
    out
}

/// The frame while every joint slips, in a line.
fn slipping_text(check: &FrameCheck) -> String {
    let frequencies: Vec<String> = check
        .modes
        .iter()
        .map(|m| format!("{:.4}", m.frequency_hz))
        .collect();
    let stability = check.stability.as_ref().map_or_else(String::new, |stability| {
        format!(
            "load factor {:.4}: {}; ",
            stability.load_factor,
            stability.verdict.word()
        )
    });
    format!(
        "  while every joint slips: {stability}{} Hz\n",
        frequencies.join(", ")
    )
}

fn chain_limits_text(limits: &ChainLimits) -> String {
    let unit = prefix(&limits.necessary_n_m_rad, "N·m/rad");
    let number = |x: f64| format!("{:.*}", LIMIT_DECIMALS, x * unit.factor);
    let heads = [
        "joint",
        "G",
        "published k_cr",
        "published P·H",
        "P·H/k_cr",
        "exact limit M",
    ];
    let mut table = Table::new(&heads, 1);
    for i in 0..limits.necessary_n_m_rad.len() {
        table.row(vec![
            (i + 1).to_string(),
            number(limits.gravity_moment_n_m_rad[i]),
            number(limits.published_critical_n_m_rad[i]),
            number(limits.published_buckling_n_m_rad[i]),
            format!("{:.2}", limits.published_ratio[i]),
            number(limits.necessary_n_m_rad[i]),
        ]);
    }
    let factor = |x: f64| format!("{x:.6}");
    table.row(vec![
        "factor".into(),
        String::new(),
        limits.published_critical_factor.map_or("none".into(), factor),
        factor(limits.published_buckling_factor),
        String::new(),
        factor(limits.necessary_factor),
    ]);
    let mut out = format!(
        "\nJoint stiffness that the weights ask for, {} (joint 1 is the lowest)\n",
        unit.unit
    );
    out += &table.text();
    out += "  factor: what the whole column must be multiplied with before the chain stands (1/λ)\n";
    let equal = number(limits.equal_joints_n_m_rad);
    let _ = writeln!(
        out,
        "  all joints equal: {equal} {} each is just enough",
        unit.unit
    );
    out += &unsafe_text(limits);
    out
}

/// The sentence that the published criterion is unsafe, with its factors.
fn unsafe_text(limits: &ChainLimits) -> String {
    if limits
        .published_critical_factor
        .is_some_and(|factor| factor <= 1.0 + ROUNDING)
    {
        return "\nOf a single link the published k_cr is the exact limit.\n".to_owned();
    }
    let by = match limits.published_critical_factor {
        Some(factor) => format!("by a factor of {factor:.6}"),
        None => "whatever it is multiplied with".to_owned(),
    };
    let mut out = format!(
        "\nUNSAFE: the published criterion k_cr (Choi 2021, eqs 38-42) is too low {by} [unsafe-criterion].\n  \
         It sets each diagonal term of the stiffness matrix to zero; a symmetric matrix with zeros on its diagonal\n  \
         and anything off it is indefinite, so a chain with those stiffnesses falls"
    );
    if let Some(least) = limits.published_eigenvalues_n_m_rad.first() {
        let unit = prefix(&limits.published_eigenvalues_n_m_rad, "N·m/rad");
        let _ = write!(
            out,
            " (smallest eigenvalue {:.4} {})",
            least * unit.factor,
            unit.unit
        );
    }
    let _ = writeln!(out, ".");
    if limits.published_buckling_factor > 1.0 {
        let _ = writeln!(
            out,
            "  The published buckling stiffness P·H (eq. 43) is too low too, by a factor of {:.6}.",
            limits.published_buckling_factor
        );
    }
    out += "  M is exact for one joint with all others rigid: necessary, not sufficient together. Exact for all: \
            load factor > 1.\n";
    out
}

fn centroids_text(effects: &[CentroidEffect], limits: &ChainLimits, names: &[&str]) -> String {
    let unit = prefix(&limits.necessary_n_m_rad, "N·m/rad");
    let joints = limits.necessary_n_m_rad.len();
    let mut heads = vec!["lowered".to_owned()];
    heads.extend((1..=joints).map(|joint| format!("k_cr,{joint}")));
    heads.push("all equal".to_owned());
    heads.push(String::new());
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let mut table = Table::new(&heads, 1);
    let mut row = |name: String, published: &[f64], equal: f64, remark: String| {
        let mut cells = vec![name];
        cells.extend(
            published
                .iter()
                .map(|k| format!("{:.*}", LIMIT_DECIMALS, k * unit.factor)),
        );
        cells.push(format!("{:.*}", LIMIT_DECIMALS, equal * unit.factor));
        cells.push(remark);
        table.row(cells);
    };
    row(
        "none".into(),
        &limits.published_critical_n_m_rad,
        limits.equal_joints_n_m_rad,
        String::new(),
    );
    let mut change = 0.0;
    for effect in effects {
        let before = &limits.published_critical_n_m_rad;
        let rises: Vec<String> = (0..joints)
            .filter(|&i| effect.published_critical_n_m_rad[i] > before[i])
            .map(|i| (i + 1).to_string())
            .collect();
        let remark = if rises.is_empty() {
            String::new()
        } else {
            format!("\"rises\": {}", rises.join(" "))
        };
        let name = names.get(effect.link - 1).map_or("", |n| n);
        change = effect.change;
        let label = format!("link {} {name}", effect.link);
        row(
            label.trim_end().to_owned(),
            &effect.published_critical_n_m_rad,
            effect.equal_joints_n_m_rad,
            remark,
        );
    }
    format!(
        "\nOne centroid {} lower: published k_cr (Choi 2021, Table 3, whose last digits are cut off), and the exact \
         equal\nstiffness, {}. Where a k_cr \"rises\" it is an artefact of that criterion: a lower centroid can only \
         help.\n{}",
        percent(-change, 2).replace('\u{202f}', " "),
        unit.unit,
        table.text()
    )
}

fn chain_stability_text(stability: &ChainStability) -> String {
    let softest = stability
        .joints
        .iter()
        .map(|joint| joint.stiffness_n_m_rad)
        .fold(f64::INFINITY, f64::min);
    let unit = prefix(&[softest], "N·m/rad"); // the softest joint keeps its digits
    let some = |x: Option<f64>, decimals: usize| x.map_or("-".to_owned(), |x| format!("{x:.decimals$}"));
    let mut table = Table::new(
        &["joint", "k", "k,min", "margin k/k,min", "uplift tilt", "lean"],
        1,
    );
    for (i, joint) in stability.joints.iter().enumerate() {
        let tilt = joint
            .uplift_tilt_rad
            .map_or("-".to_owned(), |tilt| format!("1/{:.0}", 1.0 / tilt));
        table.row(vec![
            (i + 1).to_string(),
            format!("{:.*}", LIMIT_DECIMALS, joint.stiffness_n_m_rad * unit.factor),
            some(
                joint.stiffness_least_n_m_rad.map(|k| k * unit.factor),
                LIMIT_DECIMALS,
            ),
            some(joint.margin, 4),
            tilt,
            some(stability.lean_amplification.get(i).copied(), 4),
        ]);
    }
    let mut out = format!("\nWith the joints as given, {}\n{}", unit.unit, table.text());
    let _ = writeln!(
        out,
        "  k,min: least stiffness of that joint, the others as they are. lean: rotation of the link under gravity \
         per\n  unit of a common tilt. uplift tilt: common tilt at which weight alone no longer closes the bed (needs bed_width)."
    );
    let _ = writeln!(
        out,
        "  load factor {:.6}; 1/λ = {:.6}, within its bracket {:.4} to {:.4}",
        stability.load_factor,
        stability.stiffness_factor,
        stability.stiffness_factor_least,
        stability.stiffness_factor_most
    );
    if let Some(joint) = stability.failing_joint {
        let _ = writeln!(
            out,
            "  it falls: the test from the top first fails at joint {joint}"
        );
    }
    out
}

fn frame_limits_text(check: &FrameCheck) -> String {
    let unit = prefix(&check.geometric_n_m, "N/m");
    let mut table = Table::new(&["storey", "N/l", "level load / weight of its mass"], 1);
    for (i, k) in check.geometric_n_m.iter().enumerate() {
        let ratio = check
            .level_load_ratios
            .get(i)
            .map_or("-".into(), |r| format!("{r:.3}"));
        table.row(vec![
            (i + 1).to_string(),
            format!("{:.3}", k * unit.factor),
            ratio,
        ]);
    }
    format!(
        "\nWhat P-delta takes from each storey's stiffness, {} (storey 1 is the lowest)\n{}",
        unit.unit,
        table.text()
    )
}

fn frame_stability_text(stability: &FrameStability) -> String {
    let softest = stability
        .storeys
        .iter()
        .map(|storey| storey.stiffness_n_m)
        .fold(f64::INFINITY, f64::min);
    let unit = prefix(&[softest], "N/m");
    let mut table = Table::new(&["storey", "k", "k,min", "margin k/k,min"], 1);
    for (i, storey) in stability.storeys.iter().enumerate() {
        let some = |x: Option<f64>| x.map_or("-".to_owned(), |x| format!("{x:.3}"));
        table.row(vec![
            (i + 1).to_string(),
            format!("{:.3}", storey.stiffness_n_m * unit.factor),
            some(storey.stiffness_least_n_m.map(|k| k * unit.factor)),
            some(storey.margin),
        ]);
    }
    let word = stability.verdict.word();
    format!(
        "  load factor {:.4}: {word}; stiffness in {}\n{}",
        stability.load_factor,
        unit.unit,
        table.text()
    )
}

fn modes_text(modes: &[NaturalMode], points: &str) -> String {
    if modes.is_empty() {
        return String::new();
    }
    let mut table = Table::new(
        &[
            "mode",
            "f, Hz",
            &format!("displacement of the {points}, lowest first"),
        ],
        1,
    );
    for (i, mode) in modes.iter().enumerate() {
        let shape: Vec<String> = mode.displacement.iter().map(|u| format!("{u:8.4}")).collect();
        let frequency = if mode.omega_squared > 0.0 {
            format!("{:.6}", mode.frequency_hz)
        } else {
            "falls".to_owned()
        };
        table.row(vec![(i + 1).to_string(), frequency, shape.join(" ")]);
    }
    format!("\nNatural modes\n{}", table.text())
}
