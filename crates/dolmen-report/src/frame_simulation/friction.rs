//! Friction and dashpots of simulated frames.

use crate::document::Document;
use crate::simulated::kilo;
use dolmen::dynamics::{FrictionActsOn, FrictionFrame, Sliders, StoreyFriction};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// Relative difference below which the damping ratios while sticking and while slipping are equal.
const SAME_RATIO: f64 = 1e-6;

messages! {
    /// Friction of a storey, and its dashpots.
    pub(crate) enum Friction in "frame.simulation.friction" {
        None => { en: "none", ko: "없음" },
        Coulomb(force: Sentence) => { en: "Coulomb, {force}", ko: "쿨롱, {force}" },
        Jenkins { force: Sentence, stiffness: Quantity } => {
            en: "Jenkins, {force} on {stiffness}",
            ko: "젠킨스, {force}, 고착 강성 {stiffness}",
        },
        Force(slips: Quantity) => { en: "{slips}", ko: "{slips}" },
        TwoForces { holds: Quantity, slips: Quantity } => {
            en: "{holds} then {slips}",
            ko: "정지 {holds}, 운동 {slips}",
        },
        Dashpots(ratio: Quantity) => {
            en: "Dashpots: {ratio} of critical in the first mode.",
            ko: "점성감쇠: 1차 모드 {ratio}.",
        },
        TwoDashpots { stuck: Quantity, slipping: Quantity } => {
            en: "Dashpots: {stuck} of critical in the first mode while every joint sticks; the same ones are {slipping} while every joint slips.",
            ko: "점성감쇠: 모두 고착일 때 1차 모드 {stuck}, 같은 감쇠기가 모두 미끄러질 때는 {slipping}.",
        },
        WithinSlack { within: Quantity, bearing: Quantity } => {
            en: "Dashpots: {within} of critical in the first mode within the slack of the tenons; the same ones are {bearing} with all tenons bearing.",
            ko: "점성감쇠: 장부의 유격 안에서 1차 모드 {within}, 같은 감쇠기가 모든 장부가 닿았을 때는 {bearing}.",
        },
        Bearing(bearing: Quantity) => {
            en: "Dashpots: {bearing} of critical in the first mode with all tenons bearing. Within their slack the frame does not hold itself upright and has no such mode; the same dashpots act there.",
            ko: "점성감쇠: 모든 장부가 닿았을 때 1차 모드 {bearing}. 유격 안에서는 골조가 스스로 서지 못하여 진동 모드가 없으며, 같은 감쇠기가 그대로 작용한다.",
        },
        Printed => {
            en: "Friction acts on the displacement against the ground, as eq. 11 of Park and Min (2010) is printed: for reproduction, not for judgement.",
            ko: "마찰이 박성아·민경원(2010)의 식 (11)대로 지반에 대한 변위에 작용한다. 재현용이며 판단에 쓰지 않는다.",
        },
    }
}

/// The unit of stiffness of storeys.
pub(super) fn kilonewtons_a_millimetre() -> Unit {
    Unit {
        symbol: "kN/mm".to_owned(),
        factor: 1e-6,
    }
}

/// The slider of a storey.
pub(super) fn friction(of: &StoreyFriction) -> Friction {
    match *of {
        StoreyFriction::None => Friction::None,
        StoreyFriction::Coulomb {
            static_force_n,
            kinetic_force_n,
        } => Friction::Coulomb(force(static_force_n, kinetic_force_n)),
        StoreyFriction::Jenkins {
            stuck_stiffness_n_m,
            static_force_n,
            kinetic_force_n,
        } => Friction::Jenkins {
            force: force(static_force_n, kinetic_force_n),
            stiffness: Quantity::new(
                stuck_stiffness_n_m,
                kilonewtons_a_millimetre(),
                Digits::Trimmed(6),
            ),
        },
    }
}

fn force(static_n: f64, kinetic_n: f64) -> Sentence {
    let kilonewtons = |force_n: f64| Quantity::new(force_n, kilo("N"), Digits::Significant(4));
    let slips = kilonewtons(kinetic_n);
    match static_n == kinetic_n {
        true => Friction::Force(slips).into(),
        false => Friction::TwoForces {
            holds: kilonewtons(static_n),
            slips,
        }
        .into(),
    }
}

/// The damping of the first mode by the dashpots, while the joints stick and while they slip; `None` without any.
fn dashpots(frame: &FrictionFrame) -> Option<Friction> {
    let first = |sliders| frame.damping_ratios(sliders).ok()?.first().copied()?;
    let stuck: f64 = first(Sliders::Stuck).filter(|ratio| *ratio > 0.0)?;
    let differs = |slipping: &f64| (slipping / stuck - 1.0).abs() >= SAME_RATIO;
    let ratio = Quantity::percent(stuck, 3);
    Some(match first(Sliders::Slipping).filter(differs) {
        None => Friction::Dashpots(ratio),
        Some(slipping) => Friction::TwoDashpots {
            stuck: ratio,
            slipping: Quantity::percent(slipping, 3),
        },
    })
}

/// The same with the tenons bearing; `None` without tenons or dashpots.
fn dashpots_of_tenons(frame: &FrictionFrame) -> Option<Friction> {
    let first = |of: Vec<Option<f64>>| of.first().copied().flatten();
    let has_tenons = frame.tenons().iter().any(Option::is_some);
    let bearing = first(frame.damping_ratios_bearing().ok()?);
    let bearing = bearing.filter(|ratio| *ratio > 0.0 && has_tenons)?;
    let within = first(frame.damping_ratios(Sliders::Stuck).ok()?);
    let bearing = Quantity::percent(bearing, 3);
    Some(match within {
        Some(within) => Friction::WithinSlack {
            within: Quantity::percent(within, 3),
            bearing,
        },
        None => Friction::Bearing(bearing),
    })
}

/// The dashpots, and the displacement on which friction acts if it is not the drift.
pub(super) fn notes(document: &mut Document<'_>, frame: &FrictionFrame) {
    let of_tenons = dashpots_of_tenons(frame);
    let of_joints = dashpots(frame);
    let of_joints =
        of_joints.filter(|said| of_tenons.is_none() || matches!(said, Friction::TwoDashpots { .. }));
    for said in of_joints.into_iter().chain(of_tenons) {
        document.note(said);
    }
    if frame.acts_on() == FrictionActsOn::Displacement {
        document.note(Friction::Printed);
    }
}
