//! A simulated motion of a stack, as text.

use super::{Table, heading_text, warnings_text};
use dolmen::blocks::{ContactLaw, ContactRule, Outcome, StackHistory};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::Component;
use dolmen_project::Project;
use dolmen_work::motion::MotionAnswer;
use dolmen_work::stack::StackSimulation;
use std::fmt::Write as _;

/// Share of the work put in that contacts may make before it is called a fault: that of the engine's own tests.
const ENERGY_MADE_MOST: f64 = 1e-3;

/// Contact points along one side of a quadrilateral joint.
pub fn points_a_side(rule: ContactRule) -> usize {
    match rule {
        ContactRule::Corners => 2,
        ContactRule::Three => 3,
        ContactRule::Four => 4,
        ContactRule::Six => 6,
    }
}

/// What went in, before the run: the project, the motion, if one moves it, and what was done to it.
pub fn simulation_inputs_text(
    project: &Project,
    file: &str,
    variant: Option<&str>,
    motion: Option<&MotionAnswer>,
) -> String {
    let mut out = heading_text(project, file);
    if let Some(variant) = variant {
        let _ = writeln!(out, "  variant {variant}");
    }
    out += &motion.map(motion_text).unwrap_or_default();
    out + &warnings_text(project)
}

fn motion_text(answer: &MotionAnswer) -> String {
    let motion = &answer.motion;
    let mut out = format!(
        "Motion {}: {} samples every {} s ({} Hz), {:.2} s\n",
        motion.name(),
        motion.length(),
        motion.time_step_s(),
        dolmen_words::number::trimmed(1.0 / motion.time_step_s(), 6),
        motion.duration_s()
    );
    let in_g = |a: f64| a / STANDARD_GRAVITY_M_S2;
    for component in Component::ALL.into_iter().filter(|c| motion.has(*c)) {
        let of = |(named, _): &&(Component, String)| *named == component;
        let _ = write!(out, "  {component}: ");
        if let Some((_, file)) = answer.files.iter().find(of) {
            let _ = write!(out, "{file}, ");
        }
        if let Some((_, read)) = answer.peaks_read_m_s2.iter().find(|(c, _)| *c == component) {
            let _ = write!(out, "peak {:.4} g as read, ", in_g(*read));
        }
        let peak = motion.component_peak_m_s2(component);
        let _ = writeln!(out, "{:.4} g ({peak:.4} m/s2) as it acts", in_g(peak));
    }
    if motion.has(Component::X) && motion.has(Component::Y) {
        let [x, y] = [Component::X, Component::Y].map(|component| motion.acceleration_m_s2(component));
        let both = x.iter().zip(y).map(|(x, y)| x.hypot(*y));
        let peak = both.fold(0.0, f64::max);
        let _ = writeln!(
            out,
            "  x and y together: {:.4} g ({peak:.4} m/s2) as they act",
            in_g(peak)
        );
    }
    let steps: Vec<String> = motion.history().iter().map(ToString::to_string).collect();
    let _ = writeln!(out, "  done to it: {}", steps.join("; "));
    for (component, away_m) in answer.drifting_m() {
        let _ = writeln!(out, "note: {}", drift_words(component.name(), away_m));
    }
    out
}

/// What to know of a component whose base line drifts.
pub(crate) fn drift_words(name: &str, away_m: f64) -> String {
    format!(
        "{name} ends {away_m:.3} m away, near its largest displacement: the base line drifts, or the ground moved for good; take it off with \
         --baseline or --high-pass"
    )
}

/// What came out: how it ended, each joint, the balance of energy.
pub fn simulation_text(simulation: &StackSimulation) -> String {
    let mut out = format!("\n{}\n", outcome_text(simulation));
    out += &joints_text(simulation);
    out += &top_text(simulation);
    out += &energy_text(simulation);
    out += &run_text(simulation);
    out
}

/// How it ended, in one sentence that begins with a fixed word.
pub fn outcome_text(simulation: &StackSimulation) -> String {
    let sentence = ending(simulation);
    match simulation.ended_before_the_motion_s() {
        Some(end_s) => simulation.motion.cut_words(end_s) + &sentence,
        None => sentence,
    }
}

fn ending(simulation: &StackSimulation) -> String {
    let history = &simulation.history;
    let least_mm = 1e3 * StackHistory::UPLIFT_LEAST_M;
    let state = simulation.damage.state.number();
    let opened = match history.outcome {
        Outcome::Uplifted { joint, at_s } => {
            let [upper, lower] = simulation.joint_names(joint);
            format!("first '{upper}' on '{lower}' by more than {least_mm} mm at {at_s:.2} s")
        }
        _ => String::new(),
    };
    if let (Outcome::Stood | Outcome::Uplifted { .. }, Some((joint, of))) =
        (&history.outcome, simulation.shifted())
    {
        let [upper, lower] = simulation.joint_names(joint);
        let mut out = format!(
            "SHIFTED: no stone fell, but '{upper}' on '{lower}' slipped by up to {:.1} mm and lies {:.1} mm from its place, {:.1} % of the \
             width of the joint (DS{state})",
            1e3 * of.peak_slip_m,
            1e3 * of.residual_slip_m,
            100.0 * of.residual_slip_ratio
        );
        if !opened.is_empty() {
            let _ = write!(out, "; joints opened, {opened}");
        }
        return out;
    }
    match history.outcome {
        Outcome::Stood => {
            let slipped = simulation.slipped().map(|(joint, of)| {
                let [upper, lower] = simulation.joint_names(joint);
                format!(
                    ", but '{upper}' on '{lower}' slipped by up to {:.1} mm (DS{state})",
                    1e3 * of.peak_slip_m
                )
            });
            format!(
                "STOOD: no joint opened by more than {least_mm} mm{}",
                slipped.unwrap_or_default()
            )
        }
        Outcome::Uplifted { .. } => {
            format!("UPLIFTED: every stone stayed up, but joints opened, {opened} (DS{state})")
        }
        Outcome::Slid {
            block,
            slip_m,
            margin_ratio,
        } => {
            let name = simulation.stack.blocks().get(block).map_or("", |b| &b.name);
            format!(
                "SLID: no stone fell, but '{name}' lies {:.1} mm from its place; from its plumb line to the edge that carries it \
                 {:.0} % of the way at rest is left",
                1e3 * slip_m,
                100.0 * margin_ratio
            )
        }
        Outcome::Fell { block, joint, at_s } => {
            let name = simulation.stack.blocks().get(block).map_or("", |b| &b.name);
            let [upper, lower] = simulation.joint_names(joint);
            format!(
                "FELL: '{name}' came down, first of all, at {at_s:.2} s; by then '{upper}' on '{lower}' had opened or slipped farthest"
            )
        }
        Outcome::StillMoving {
            block,
            at_s,
            margin_ratio,
        } => {
            let name = simulation.stack.blocks().get(block).map_or("", |b| &b.name);
            format!(
                "STILL MOVING at its end, {at_s:.2} s: '{name}' is not at rest, {:.0} % of the way from its plumb line to the edge that carries it \
                 is left; no verdict. Give a longer --duration",
                100.0 * margin_ratio
            )
        }
        Outcome::Stopped { at_s } => {
            format!(
                "STOPPED at {at_s:.2} s before its end: what follows is of the part that was done, and no verdict"
            )
        }
        Outcome::NotConverged { at_s, residual_m_s } => {
            format!(
                "NOT CONVERGED at {at_s:.4} s: no velocities found that obey the law of every joint, nearest {residual_m_s:.1e} m/s; what \
                 follows is of the part before, and no verdict. Try half the step"
            )
        }
        Outcome::Diverged { at_s } => {
            format!(
                "DIVERGED at {at_s:.4} s: nothing of this run can be used. Lower the step, and report the input"
            )
        }
    }
}

fn joints_text(simulation: &StackSimulation) -> String {
    let heads = [
        "stone",
        "on",
        "opening, mm",
        "slip, mm",
        "yaw, mrad",
        "left: slip, mm",
        "yaw, mrad",
    ];
    let mut table = Table::new(&heads, 2);
    for (number, joint) in simulation.history.joints.iter().enumerate() {
        let [upper, lower] = simulation.joint_names(number);
        let (slip, yaw) = (joint.residual_slip_m(), joint.residual_yaw_rad());
        let mut cells = vec![upper.to_owned(), lower.to_owned()];
        let values = [
            joint.peak_opening_m,
            joint.peak_slip_m,
            joint.peak_yaw_rad,
            slip,
            yaw,
        ];
        cells.extend(values.map(|value| thousandths(1e3 * value)));
        table.row(cells);
    }
    format!(
        "Peaks of each joint, and what is left at the end\n{}",
        table.text()
    )
}

/// A number of millimetres or milliradians to a thousandth.
fn thousandths(value: f64) -> String {
    let text = format!("{value:.3}");
    if text == "-0.000" {
        "0.000".to_owned()
    } else {
        text
    }
}

fn top_text(simulation: &StackSimulation) -> String {
    let block = simulation.highest_block();
    let moved = simulation.displacement_m(block);
    let far = |d: &[f64; 3]| d[0].hypot(d[1]);
    let peak = moved.iter().map(far).fold(0.0, f64::max);
    let left = moved.last().map_or(0.0, far);
    let name = simulation.stack.blocks().get(block).map_or("", |b| &b.name);
    format!(
        "  The highest stone, '{name}', moved by up to {} mm against the ground, {} mm at the end\n",
        thousandths(1e3 * peak),
        thousandths(1e3 * left)
    )
}

fn energy_text(simulation: &StackSimulation) -> String {
    let history = &simulation.history;
    let end = history.energy.last().copied().unwrap_or_default();
    let start = history.energy.first().copied().unwrap_or_default();
    let kept = end.kinetic_j - start.kinetic_j + end.potential_j - start.potential_j + end.stored_j;
    let gap = end.input_j - kept - end.friction_j - end.damping_j - end.clipping_j;
    let scale = history.energy.iter().map(|e| e.input_j.abs()).fold(0.0, f64::max);
    let share = |value: f64| if scale > 0.0 { 100.0 * value / scale } else { 0.0 };
    let mut out = format!(
        "Energy, J: put in {:.3e} = moving {:.3e} + raised {:.3e} + in springs {:.3e} + friction {:.3e} + {} {:.3e}; \
         left over {:.1e} %\n",
        end.input_j,
        end.kinetic_j - start.kinetic_j,
        end.potential_j - start.potential_j,
        end.stored_j,
        end.friction_j,
        lost_in(&simulation.law),
        end.damping_j,
        share(gap)
    );
    let made = history.energy_made_ratio();
    let _ = writeln!(
        out,
        "  made by contacts: {:.1e} % of the most put in",
        100.0 * made
    );
    if made > ENERGY_MADE_MOST {
        let _ = writeln!(
            out,
            "  warning: that is more than {} %: do not use this run, try half the step",
            100.0 * ENERGY_MADE_MOST
        );
    }
    out
}

/// Where energy goes that friction does not take.
fn lost_in(law: &ContactLaw) -> &'static str {
    match law {
        ContactLaw::Springs(_) => "dashpots",
        ContactLaw::Rigid(_) => "impacts, small ones of a step included",
    }
}

fn run_text(simulation: &StackSimulation) -> String {
    let history = &simulation.history;
    let side = points_a_side(simulation.law.contact_rule());
    let stable = match simulation.law {
        ContactLaw::Springs(_) => format!(" (longest stable {:.3e} s)", history.longest_step_s),
        ContactLaw::Rigid(_) => String::new(),
    };
    let mut out = format!(
        "Run: {} law, {} steps of {:.3e} s{stable} for {:.2} s; {} contact points ({side} × {side} a joint)\n",
        simulation.law.name(),
        history.steps,
        history.time_step_s,
        history.time_s.last().copied().unwrap_or_default(),
        history.contact_points
    );
    match history.rigid {
        Some(rigid) => {
            let _ = writeln!(
                out,
                "  {} of the steps at rest on the ground, {} impacts; every joint obeys its law to {:.1e} m/s, no stone lies deeper than \
                 {:.1e} m in another",
                rigid.steps_at_rest, rigid.impacts, rigid.residual_most_m_s, rigid.penetration_most_m
            );
            if rigid.loose_solutions + rigid.halvings > 0 {
                let _ = writeln!(
                    out,
                    "  {} of {} solutions are farther than 1e-6 m/s from the law, {} times a step was halved to find one",
                    rigid.loose_solutions, rigid.solutions, rigid.halvings
                );
            }
        }
        None => {
            let _ = writeln!(
                out,
                "  settled before it by {:.4} mm at the highest stone",
                1e3 * history.settlement_m
            );
        }
    }
    if !history.broken_ties.is_empty() {
        let ties: Vec<String> = history
            .broken_ties
            .iter()
            .map(|tie| format!("{}", tie + 1))
            .collect();
        let _ = writeln!(out, "  broken ties: {}", ties.join(", "));
    }
    if matches!(
        history.outcome,
        Outcome::Uplifted { .. } | Outcome::Slid { .. } | Outcome::Fell { .. } | Outcome::StillMoving { .. }
    ) {
        out += "  note: a stack that rocks is sensitive to every input: one run is one case, not a probability\n";
    }
    out
}
