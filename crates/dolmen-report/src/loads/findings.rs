//! Findings on wind and static loads.

use super::words::{DIGITS, Found, what};
use super::{on_buildings, on_frames};
use crate::document::{Finding, Role, Tone};
use crate::simulated::kilo;
use crate::stack::{direction, joints_moving};
use dolmen::assess::StackUnderLoads;
use dolmen::stability::{ChainUnderLoads, JointUnderLoads, Verdict};
use dolmen::structure::stack::Stack;
use dolmen::structure::wind::WindError;
use dolmen_project::{Project, Quantity as Input, Structure, WindPart, WindSpeed};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::judgement::Evidence;
use dolmen_work::loads::{AcrossCombination, ChainCombination, CombinationAnswer, Combined, LoadsAnswer};
use dolmen_work::state::{Check, State};

messages! {
    /// Why a wind is unknown.
    pub(crate) enum WhyNot in "loads.why-not" {
        Frequency => {
            en: "its code asks for the lowest natural frequency, which needs the stiffness of the joints",
            ko: "기준에 1차 고유진동수가 필요하나 접합부 강성이 주어지지 않았다",
        },
        Damping(frequency: Quantity) => {
            en: "at {frequency} resonance counts, which needs «damping_ratio|the damping ratio»",
            ko: "고유진동수 {frequency}에서는 공진을 고려해야 하며 «damping_ratio|감쇠비»가 필요하다",
        },
        StackSways(frequency: Quantity) => {
            en: "on the springs of its joints it sways at {frequency}, where gusts near that frequency add to the pressure of the code. Give the gust of a wind study, or joints with a stiffness that was measured",
            ko: "접합부 스프링에 의한 고유진동수가 {frequency}이며, 이때 기준의 풍압에 공진 효과가 더해진다. 풍하중 평가의 돌풍 값이나 계측된 접합부 강성을 입력한다",
        },
        StackFrequency => {
            en: "its code asks for the lowest natural frequency, which was not found",
            ko: "기준에 1차 고유진동수가 필요하나 구하지 못하였다",
        },
        Height { height: Quantity, most: Quantity } => {
            en: "its top is at {height}, and the profile of the code ends at {most}",
            ko: "최상단 높이 {height}이(가) 기준의 적용 높이 {most}을(를) 넘는다",
        },
        NotAMean => {
            en: "a gust or a pressure is given, and turbulence goes with the 10-minute mean of a code",
            ko: "돌풍이나 압력으로 주어졌으나 난류는 기준에 따른 10분 평균 풍속이 있어야 정해진다",
        },
        NotPositive { quantity: String, given: Quantity } => {
            en: "{quantity} is {given}, but must be above 0",
            ko: "{quantity} = {given}은(는) 0보다 커야 한다",
        },
    }
}

/// Whether every stone stands on one joint.
fn is_pile(stack: &Stack) -> bool {
    stack.joints().len() == stack.blocks().len()
}

fn hertz(frequency_hz: f64) -> Quantity {
    Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Significant(DIGITS))
}

/// Why a wind is unknown.
pub(super) fn why_not(error: &WindError, is_stack: bool) -> Sentence {
    match error {
        WindError::FrequencyUnknown if is_stack => WhyNot::StackFrequency,
        WindError::DampingUnknown { frequency_hz } if is_stack => WhyNot::StackSways(hertz(*frequency_hz)),
        WindError::FrequencyUnknown => WhyNot::Frequency,
        WindError::DampingUnknown { frequency_hz } => WhyNot::Damping(hertz(*frequency_hz)),
        WindError::Height { given, most_m } => WhyNot::Height {
            height: Quantity::engineering(*given, "m", DIGITS),
            most: Quantity::engineering(*most_m, "m", DIGITS),
        },
        WindError::NotAMean => WhyNot::NotAMean,
        WindError::NotPositive { quantity, given } => WhyNot::NotPositive {
            quantity: (*quantity).to_owned(),
            given: Quantity::ratio(*given, DIGITS),
        },
    }
    .into()
}

/// Finding that a pole or a frame has no wind; none for other kinds.
fn no_wind(project: &Project, state: &State) -> Option<Finding> {
    let said = match &project.structure {
        Structure::Chain(_) => Found::NoWind,
        Structure::Frame(_) => Found::NoWindOnFrame,
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => return None,
    };
    let is_silent = project.loads.wind == WindPart::NotSaid && state.verdict() != Verdict::Unstable;
    is_silent.then(|| Finding::key(Tone::Warn, said).with_code("no-wind"))
}

/// The findings, only for the worst combination.
pub(crate) fn findings(project: &Project, state: &State) -> Vec<Finding> {
    let Some(answer) = &state.loads else {
        return no_wind(project, state).into_iter().collect();
    };
    let mut all = Vec::new();
    if let Some(Err(why)) = &answer.wind {
        let why = why_not(why, matches!(state.check, Check::Stack(_)));
        all.push(Finding::key(Tone::Unknown, Found::NotKnown(why)));
    }
    if let Some(of) = &answer.carried {
        let (weight, factor) = (
            Quantity::new(of.weight_n, kilo("N"), Digits::Significant(DIGITS)),
            Quantity::beside_one(of.load_factor, DIGITS),
        );
        all.push(match of.frequency_hz {
            Some(frequency_hz) => Finding::key(
                Tone::Plain,
                Found::Carried {
                    weight,
                    factor,
                    frequency: hertz(frequency_hz),
                },
            ),
            None => Finding::key(Tone::Warn, Found::CarriedFalls { weight, factor }),
        });
    }
    // the wind on a building is judged without a combination too
    if answer.leaves_wind_out() && !matches!(state.check, Check::Building(_)) {
        all.push(Finding::key(Tone::Warn, Found::WindInNone));
    }
    if answer.leaves_loads_out() {
        let said = match &state.check {
            Check::Stack(_) => Found::LoadsInNoneOfStack,
            _ => Found::LoadsInNone,
        };
        all.push(Finding::key(Tone::Warn, said));
    }
    let hangs_n = project.loads.weight_n(&mut Input::nominal);
    if matches!(project.structure, Structure::Frame(_)) && hangs_n != 0.0 {
        let weight = Quantity::new(hangs_n, kilo("N"), Digits::Significant(DIGITS));
        all.push(Finding::key(Tone::Plain, Found::FrameCarries(weight)));
    }
    let stack = match &state.check {
        Check::Stack(answer) => Some(&answer.stack),
        _ => None,
    };
    all.extend(on_frames::slipping(answer));
    all.extend(on_frames::drifts(project, answer));
    if matches!(state.check, Check::Building(_)) {
        let is_contradicted = Evidence::of(project, &state.check).is_contradicted();
        all.extend(on_buildings::findings(answer, is_contradicted));
    }
    all.extend(
        answer
            .worst()
            .map(|worst| of_combination((project, answer), worst, stack))
            .unwrap_or_default(),
    );
    if stack.is_some_and(|stack| !stack.support_movements().is_empty()) && !answer.combinations.is_empty() {
        all.push(Finding::qualifies(Tone::Warn, Found::BeforeMoved));
    }
    let under = answer.worst().and_then(CombinationAnswer::stack);
    all.extend(under.into_iter().flat_map(lessened));
    match under.and_then(|under| under.dilating_factor) {
        Some(dilating) => {
            let dilating = Quantity::beside_one(dilating, DIGITS);
            all.push(Finding::qualifies(Tone::Warn, Found::SlidesSmooth(dilating)));
        }
        None if under.is_some_and(|under| under.found.slides())
            && stack.is_some_and(|stack| !is_pile(stack)) =>
        {
            all.push(Finding::qualifies(Tone::Warn, Found::Slides));
        }
        None => {}
    }
    if let Some(frequency_hz) = answer.lacks_resonance_at_hz() {
        let frequency = hertz(frequency_hz);
        let by_code = project
            .loads
            .wind()
            .is_some_and(|wind| matches!(wind.speed, WindSpeed::Kds41 { .. }));
        let said = match by_code {
            true => Found::NoResonanceOfKds(frequency),
            false => Found::NoResonance(frequency),
        };
        all.push(Finding::qualifies(Tone::Warn, said));
    }
    if !answer.has_wind {
        all.extend(no_wind(project, state));
    }
    all
}

/// What makes the factor of a stack less: edges that crush, and the footing that turns on its soil.
fn lessened(under: &StackUnderLoads) -> Vec<Finding> {
    let crushed = under
        .uncrushed_factor
        .map(|uncrushed| match uncrushed.is_finite() {
            true => Found::EdgesCrush(Quantity::beside_one(uncrushed, DIGITS)),
            false => Found::EdgesCrushAlone,
        });
    let turned = under.rigid_ground_factor.map(|rigid| match rigid.is_finite() {
        true => Found::FootingTurns(Quantity::beside_one(rigid, DIGITS)),
        false => Found::FootingTurnsAlone,
    });
    let all = crushed.into_iter().chain(turned);
    all.map(|said| Finding::qualifies(Tone::Warn, said)).collect()
}

fn of_combination(
    (project, answer): (&Project, &LoadsAnswer),
    worst: &CombinationAnswer,
    stack: Option<&Stack>,
) -> Vec<Finding> {
    let only = match (&worst.of, stack) {
        (Combined::Chain(chain), _) => of_chain(what(answer, worst), chain),
        (Combined::Stack(under), Some(stack)) => return of_stack(what(answer, worst), under, stack),
        (Combined::Frame(frame), _) => on_frames::borne(project, what(answer, worst), frame),
        (Combined::Stack(_), None) | (Combined::Building(_), _) => None,
    };
    let answers = only.map(|found| Finding {
        role: Role::Answer,
        ..found
    });
    answers.into_iter().collect()
}

/// The capacity of a stack under a combination, and what moves at its limit.
fn of_stack(what: Sentence, under: &StackUnderLoads, stack: &Stack) -> Vec<Finding> {
    let verdict = under.verdict();
    let tone = Tone::of(verdict);
    let factor = under.found.factor;
    if factor == 0.0 {
        return vec![Finding::answer(tone, Found::Falls(what))];
    }
    if factor.is_infinite() {
        return vec![Finding::answer(tone, Found::NothingMoves(what))];
    }
    let moving = joints_moving(stack, under.found.mechanism.as_ref());
    let moves = match (moving, under.wind_to.map(direction)) {
        (Some(joints), Some(direction)) => Found::MovesInWind {
            what: what.clone(),
            joints,
            direction,
        },
        (Some(joints), None) => Found::Moves {
            what: what.clone(),
            joints,
        },
        (None, Some(direction)) => Found::Towards {
            what: what.clone(),
            direction,
        },
        (None, None) => Found::NoMechanism { what: what.clone() },
    };
    let factor = Quantity::beside_one(factor, DIGITS);
    let borne = match verdict {
        Verdict::Unstable => Found::StackFalls { what, factor },
        Verdict::Stable | Verdict::Marginal | Verdict::Unknown => Found::StackBears {
            what,
            factor,
            stable: Quantity::ratio(Verdict::MARGINAL_BELOW, 2),
        },
    };
    vec![Finding::answer(tone, borne), Finding::new(Tone::Plain, moves)]
}

fn of_chain(what: Sentence, chain: &ChainCombination) -> Option<Finding> {
    let under = &chain.under;
    let verdict = chain.verdict();
    let tone = Tone::of(verdict);
    if under.factor == Some(0.0) && under.joints.iter().all(|joint| joint.moment_n_m.is_none()) {
        return Some(Finding::key(tone, Found::Falls(what)));
    }
    let weighs_too_much = matches!(chain.weight_verdict(), Verdict::Marginal | Verdict::Unstable);
    let by_loads = under.factor.map_or(Verdict::Unknown, Verdict::of_load_factor);
    if let (true, Verdict::Stable, Some(factor)) = (weighs_too_much, by_loads, chain.weight_factor) {
        let factor = Quantity::beside_one(factor, DIGITS);
        let stable = Quantity::ratio(Verdict::MARGINAL_BELOW, 2);
        return Some(Finding::key(tone, Found::Heavy { what, factor, stable }));
    }
    if under.factor == Some(f64::INFINITY) {
        return Some(Finding::key(Tone::Plain, Found::NothingPushes(what)));
    }
    let joint = under.governing_joint.unwrap_or(1);
    let of = under.joints.get(joint - 1)?;
    let acting_on =
        |of: &JointUnderLoads| of.moment_n_m.unwrap_or(of.rigid_moment_n_m).abs() + of.tilt_moment_n_m.abs();
    let across = chain.across.as_ref();
    let across = across
        .and_then(|across| across.under.joints.get(joint - 1))
        .map(acting_on);
    let acting = acting_on(of).hypot(across.unwrap_or(0.0));
    let moment = Quantity::engineering(acting, "N·m", DIGITS);
    if let Some(across) = &chain.across
        && let Some(said) = of_both(what.clone(), chain, across)
    {
        return Some(Finding::key(tone, said));
    }
    let said = match (verdict, of.limit_n_m, of.factor) {
        (Verdict::Unstable, Some(limit), Some(factor)) => Found::Overturns {
            what,
            joint,
            moment,
            limit: Quantity::engineering(limit, "N·m", DIGITS),
            factor: Quantity::beside_one(factor, DIGITS),
        },
        (Verdict::Stable | Verdict::Marginal, Some(limit), Some(factor)) => Found::Bears {
            what,
            joint,
            moment,
            limit: Quantity::engineering(limit, "N·m", DIGITS),
            factor: Quantity::beside_one(factor, DIGITS),
            stable: Quantity::ratio(Verdict::MARGINAL_BELOW, 2),
        },
        _ => Found::AtLeast { what, joint, moment },
    };
    Some(Finding::key(tone, said))
}

/// A joint of a chain with two directions; `None` if a limit is unknown.
fn of_both(what: Sentence, chain: &ChainCombination, across: &AcrossCombination) -> Option<Sentence> {
    let joint = chain.under.governing_joint?;
    let of_limit = |under: &ChainUnderLoads| -> Option<Sentence> {
        let of = under.joints.get(joint - 1)?;
        let acting = of.moment_n_m.unwrap_or(of.rigid_moment_n_m).abs() + of.tilt_moment_n_m.abs();
        let moment = |value: f64| Quantity::engineering(value, "N·m", DIGITS);
        Some(
            Found::OfLimit {
                moment: moment(acting),
                limit: moment(of.limit_n_m?),
            }
            .into(),
        )
    };
    let (along, other) = (of_limit(&chain.under)?, of_limit(&across.under)?);
    let factor = Quantity::beside_one(chain.under.factor?, DIGITS);
    let said = match chain.verdict() {
        Verdict::Unknown => return None,
        Verdict::Unstable => Found::OverturnsBoth {
            what,
            joint,
            along,
            across: other,
            factor,
        },
        Verdict::Stable | Verdict::Marginal => Found::BearsBoth {
            what,
            joint,
            along,
            across: other,
            factor,
            stable: Quantity::ratio(Verdict::MARGINAL_BELOW, 2),
        },
    };
    let said = Sentence::from(said);
    Some(match across.wind_towards_deg {
        None => said,
        Some(degrees) => {
            let angle = degrees.to_radians();
            let towards = direction([angle.cos(), angle.sin()]);
            Found::Blowing { said, towards }.into()
        }
    })
}
