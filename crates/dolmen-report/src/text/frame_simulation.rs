//! A simulated motion of a frame, as text.

use super::Table;
use dolmen::dynamics::{FrameOutcome, FrictionActsOn, FrictionFrame, Sliders, StoreyFriction};
use dolmen::signal::Component;
use dolmen_words::Language;
use dolmen_words::number::significant;
use dolmen_work::frame::FrameSimulation;
use std::fmt::Write as _;

/// How it ended, each storey, the balance of energy.
pub fn frame_simulation_text(simulation: &FrameSimulation) -> String {
    let mut out = format!("\nDirection {}\n", simulation.direction);
    if simulation.motion.motion.has(Component::Z) {
        out += "  note: z does not act: a frame knows no vertical shaking\n";
    }
    out += &frame_text(simulation);
    let _ = writeln!(out, "\n{}", frame_outcome_text(simulation));
    out += &storeys_text(simulation);
    out += &energy_text(simulation);
    out
}

/// How it ended, in one sentence that begins with a fixed word.
pub fn frame_outcome_text(simulation: &FrameSimulation) -> String {
    let sentence = ending(simulation);
    match simulation.ended_before_the_motion_s() {
        Some(end_s) => simulation.motion.cut_words(end_s) + &sentence,
        None => sentence,
    }
}

fn ending(simulation: &FrameSimulation) -> String {
    let history = &simulation.history;
    let name = |storey: usize| simulation.storeys.get(storey).map_or("", String::as_str);
    match history.outcome {
        FrameOutcome::Finished if history.slips.is_empty() && has_friction(simulation) => {
            "STUCK: no joint slipped".to_owned()
        }
        FrameOutcome::Finished => {
            let rest = history.rest_m.last().copied().unwrap_or(0.0);
            let state = if history.at_rest {
                "at rest"
            } else {
                "still moving, and comes to rest"
            };
            format!(
                "STOOD: no storey leaned by more than {} % of its height; at the end the top is {state} {:.3} mm from where it was",
                100.0 * simulation.options.drift_ratio_most,
                1e3 * rest
            )
        }
        FrameOutcome::DriftLimit { storey, at_s } => format!(
            "DRIFT LIMIT: '{}' leaned by more than {} % of its height at {at_s:.2} s, beyond what small drifts can tell of: count it \
             as fallen",
            name(storey),
            100.0 * simulation.options.drift_ratio_most
        ),
        FrameOutcome::Stopped { at_s } => format!(
            "STOPPED at {at_s:.2} s before its end: what follows is of the part that was done, and no verdict"
        ),
    }
}

fn has_friction(simulation: &FrameSimulation) -> bool {
    let mut each = simulation.frame.friction().iter();
    each.any(|friction| *friction != StoreyFriction::None)
}

/// What a storey's slider is, in words.
pub fn friction_words(friction: &StoreyFriction) -> String {
    let force = |static_force_n: f64, kinetic_force_n: f64| {
        if static_force_n == kinetic_force_n {
            format!("{:.1} kN", 1e-3 * kinetic_force_n)
        } else {
            format!(
                "{:.1} then {:.1} kN",
                1e-3 * static_force_n,
                1e-3 * kinetic_force_n
            )
        }
    };
    match *friction {
        StoreyFriction::None => "none".to_owned(),
        StoreyFriction::Coulomb {
            static_force_n,
            kinetic_force_n,
        } => format!("Coulomb, {}", force(static_force_n, kinetic_force_n)),
        StoreyFriction::Jenkins {
            stuck_stiffness_n_m,
            static_force_n,
            kinetic_force_n,
        } => format!(
            "Jenkins, {} on {:.4} kN/mm",
            force(static_force_n, kinetic_force_n),
            1e-6 * stuck_stiffness_n_m
        ),
    }
}

/// What the dashpots are of the first mode, while the joints stick and while they slip; `None` without any.
pub(crate) fn damping_words(frame: &FrictionFrame, language: Language) -> Option<String> {
    let first = |sliders| Some(100.0 * frame.damping_ratios(sliders).ok()?.first().copied()??);
    let stuck = first(Sliders::Stuck).filter(|ratio| *ratio > 0.0)?;
    let same = |slipping: &f64| (slipping / stuck - 1.0).abs() < 1e-6;
    let slipping = first(Sliders::Slipping).filter(|slipping| !same(slipping));
    let stuck = significant(stuck, 3);
    Some(match slipping.map(|slipping| significant(slipping, 3)) {
        None => language.pick(
            format!("dashpots: {stuck} % of critical in the first mode"),
            format!("점성감쇠: 1차 모드 {stuck} %"),
        ),
        Some(slipping) => language.pick(
            format!("dashpots: {stuck} % of critical in the first mode while every joint sticks; the same ones are {slipping} % while every joint slips"),
            format!("점성감쇠: 모두 고착일 때 1차 모드 {stuck} %, 같은 감쇠기가 모두 미끄러질 때는 {slipping} %"),
        ),
    })
}

fn frame_text(simulation: &FrameSimulation) -> String {
    let frame = &simulation.frame;
    let mut table = Table::new(&["storey", "spring, kN/mm", "friction"], 1);
    for (i, name) in simulation.storeys.iter().enumerate() {
        table.row(vec![
            name.clone(),
            format!("{:.4}", 1e-6 * frame.stiffness_n_m()[i]),
            friction_words(&frame.friction()[i]),
        ]);
    }
    let mut out = table.text();
    if let Some(words) = damping_words(frame, Language::English) {
        let _ = writeln!(out, "  {words}");
    }
    if frame.acts_on() == FrictionActsOn::Displacement {
        out += "  friction on the displacement against the ground, as eq. 11 of Park and Min (2010) is printed: for reproduction\n";
    }
    out
}

fn storeys_text(simulation: &FrameSimulation) -> String {
    let history = &simulation.history;
    let heads = [
        "storey",
        "drift, mm",
        "of height, %",
        "at, s",
        "level, mm",
        "slipped, mm",
        "of the time, %",
        "drift left, mm",
    ];
    let mut table = Table::new(&heads, 1);
    let heights = simulation.frame.frame().storeys();
    for (i, name) in simulation.storeys.iter().enumerate() {
        let peak = history.drift_peaks[i];
        let below = i.checked_sub(1).map_or(0.0, |j| history.rest_m[j]);
        table.row(vec![
            name.clone(),
            format!("{:.3}", 1e3 * peak.value_m.abs()),
            format!("{:.3}", 100.0 * peak.value_m.abs() / heights[i].height_m),
            format!("{:.2}", peak.at_s),
            format!("{:.3}", 1e3 * history.displacement_peaks[i].value_m.abs()),
            format!("{:.3}", 1e3 * history.slipped_way_m(i)),
            format!("{:.1}", 100.0 * history.slipping_share(i)),
            format!("{:.3}", 1e3 * (history.rest_m[i] - below) + 0.0),
        ]);
    }
    format!(
        "Peaks of each storey between the samples too; left: where it comes to rest if nothing slips any more\n{}",
        table.text()
    )
}

fn energy_text(simulation: &FrameSimulation) -> String {
    let history = &simulation.history;
    let end = history.energy.last().copied().unwrap_or_default();
    format!(
        "Energy, J: put in {:.3e} = moving {:.3e} + in springs {:.3e} + friction {:.3e} + dashpots {:.3e}; left over at most {:.1e} of \
         it\nRun: exact between {} events, {} series, {:.2} s\n",
        end.input_j,
        end.kinetic_j,
        end.stored_j,
        end.friction_j,
        end.damping_j,
        history.energy_left_over_ratio(),
        history.events,
        history.steps,
        history.time_s.last().copied().unwrap_or_default()
    )
}
