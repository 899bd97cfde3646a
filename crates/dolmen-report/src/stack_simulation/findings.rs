//! Conclusions from a simulated stack.

use super::ending::Ending;
use super::run::{Run, made_too_much};
use super::{crushing, laws, repeats, sliding};
use crate::document::{Finding, Tone};
use crate::stack::{lean, widest};
use dolmen::blocks::{ContactLaw, Outcome, StackHistory};
use dolmen::signal::Component;
use dolmen::structure::stack::Body;
use dolmen_words::{Digits, Quantity, Unit};
use dolmen_work::judgement::Earthquake;
use dolmen_work::stack::{StackRuns, StackSimulation};

/// Excess of the restitution over that of an impact at the edge from which it is a finding: smaller values are rounding of
/// measurements. Our choice.
const ABOVE_EDGE_LEAST: f64 = 0.005;

/// The outcome and its conclusions, the most important first.
pub(crate) fn findings(runs: &StackRuns) -> Vec<Finding> {
    let simulation = &runs.deciding;
    let of = &simulation.motion.motion;
    let motion = of.name().to_owned();
    let peak = Quantity::new(
        simulation.peak_horizontal_g(),
        Unit::si("g"),
        Digits::Significant(3),
    );
    let ending = laws::endings(runs);
    let said = match of.has(Component::X) && of.has(Component::Y) {
        true => Ending::Under { motion, peak, ending },
        false => Ending::UnderOne { motion, peak, ending },
    };
    let variant = simulation.variant.clone();
    let variant = variant.map(|variant| Finding::key(Tone::Plain, Ending::OfVariant { variant }));
    let mut all: Vec<Finding> = variant.into_iter().collect();
    all.extend(repeats::falls(runs));
    all.push(Finding::key(tone(simulation), said));
    all.extend(laws::finding(runs));
    all.extend(sliding::finding(runs));
    all.extend(runs.repeats.as_ref().map(repeats::finding));
    all.extend(simulation.lean.as_ref().map(lean));
    all.extend(simulation.tilt_left_out.clone().map(|of| {
        let (survey, tilt) = (of.survey, of.written);
        Finding::key(Tone::Warn, Ending::TiltLeftOut { survey, tilt })
    }));
    all.extend(simulation.gaps.as_ref().map(|of| {
        let (gap, joints) = (&of.gap, of.gap.joints);
        let widest = widest(&gap.lower, gap.upper.clone(), gap.gap_m);
        let said = match of.are_open {
            true => Ending::GapsOpen { widest, joints },
            false => Ending::GapsClosed { widest, joints },
        };
        Finding::key(Tone::Warn, said)
    }));
    if !simulation.stack.static_loads().is_empty() {
        all.push(Finding::key(Tone::Plain, Ending::LoadsAct));
    }
    if !simulation.stack.support_movements().is_empty() {
        all.push(Finding::key(Tone::Warn, Ending::SupportsAsDrawn));
    }
    let histories: Vec<&StackHistory> = runs.each().map(|run| &run.history).collect();
    all.extend(crushing::findings(&simulation.stack, &histories));
    let is_rigid = |run: &StackSimulation| matches!(run.law, ContactLaw::Rigid(_));
    if !simulation.loosened.is_empty() && runs.each().any(is_rigid) {
        let stones = simulation.loosened.clone();
        all.push(Finding::key(Tone::Warn, Ending::Unseen { stones }));
    }
    if simulation.without_wind {
        all.push(Finding::key(Tone::Plain, Ending::NoWind));
    }
    let made = runs.each().find_map(made_too_much);
    all.extend(made.map(|said| Finding::key(Tone::Warn, said)));
    if runs.other.is_none() && leaves_restitution_out(simulation) {
        all.push(Finding::key(Tone::Warn, Run::RestitutionUnused));
    }
    all.extend(rocks_on_more(simulation));
    let is_rigid = |run: &StackSimulation| matches!(run.law, ContactLaw::Rigid(_));
    if simulation.stack.soil().is_some() && runs.each().any(is_rigid) {
        all.push(Finding::key(Tone::Warn, Run::SoilLeftOut));
    }
    if runs.repeats.is_none() && runs.each().any(|run| is_sensitive(&run.history.outcome)) {
        all.push(match simulation.may_be_worse() && simulation.is_whole() {
            true => Finding::key(Tone::Warn, Run::OneCaseOfMany),
            false => Finding::key(Tone::Plain, Run::OneCase),
        });
    }
    all
}

fn leaves_restitution_out(simulation: &StackSimulation) -> bool {
    let joints = simulation.stack.joints();
    match simulation.law {
        ContactLaw::Springs(_) => joints
            .iter()
            .any(|joint| joint.material.rocking_restitution.is_some()),
        ContactLaw::Rigid(_) => false,
    }
}

/// The joint whose `rocking_restitution` exceeds Housner's 1 − 1.5 sin²α most, where tan α is the acceleration at which it opens.
fn rocks_on_more(simulation: &StackSimulation) -> Option<Finding> {
    let stack = &simulation.stack;
    let cuts = simulation.limits.cuts.iter();
    let each = cuts.filter_map(|limits| {
        let joints = limits.cut.joints.iter().map(|&joint| &stack.joints()[joint]);
        let (of, given) = joints
            .filter_map(|of| Some((of, of.material.rocking_restitution?)))
            .max_by(|a, b| a.1.total_cmp(&b.1))?;
        let edge = 1.0 - 1.5 * limits.uplift?.acceleration_g.atan().sin().powi(2);
        (given > edge + ABOVE_EDGE_LEAST).then_some((of, given, edge))
    });
    let (of, given, edge) = each.max_by(|a, b| (a.1 - a.2).total_cmp(&(b.1 - b.2)))?;
    let share = |value: f64| Quantity::ratio(value, 3);
    let said = Run::RocksOnMore {
        upper: stack.name(Body::Block(of.upper)).to_owned(),
        given: share(given),
        edge: share(edge),
    };
    Some(Finding::key(Tone::Plain, said))
}

/// Whether stones moved relative to each other so much that small differences of the input matter.
fn is_sensitive(outcome: &Outcome) -> bool {
    matches!(
        outcome,
        Outcome::Uplifted { .. } | Outcome::Slid { .. } | Outcome::Fell { .. } | Outcome::StillMoving { .. }
    )
}

pub(super) fn tone(simulation: &StackSimulation) -> Tone {
    match simulation.history.outcome {
        Outcome::Fell { .. } => Tone::Bad,
        Outcome::StillMoving { margin_ratio, .. } if margin_ratio <= 0.0 => Tone::Bad,
        _ if simulation.ended_before_the_motion_s().is_some() => Tone::Unknown,
        _ if simulation.shifted().is_some() && !simulation.falls() => Tone::Warn,
        Outcome::Stood if simulation.crushes() => Tone::Warn,
        Outcome::Stood => Tone::Good,
        // the colour of the word on the earthquake
        _ if Earthquake::of_damage(simulation.counted_damage()) == Earthquake::BelowDemand => Tone::Bad,
        Outcome::Uplifted { .. } | Outcome::Slid { .. } => Tone::Warn,
        Outcome::StillMoving { .. }
        | Outcome::Stopped { .. }
        | Outcome::NotConverged { .. }
        | Outcome::Diverged { .. } => Tone::Unknown,
    }
}
