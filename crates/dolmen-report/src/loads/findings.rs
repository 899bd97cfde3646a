//! What wind and static loads do, in plain words.

use crate::document::{Finding, Tone};
use crate::simulated::kilo;
use crate::stack::{direction, joints_moving};
use dolmen::assess::StackUnderLoads;
use dolmen::stability::{ChainUnderLoads, JointUnderLoads, Verdict};
use dolmen::structure::stack::Stack;
use dolmen::structure::wind::WindError;
use dolmen_project::{Project, Structure, WindPart};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::loads::{AcrossCombination, ChainCombination, CombinationAnswer, Combined, LoadsAnswer};
use dolmen_work::state::{Check, State};

/// Digits of a factor in a sentence.
const DIGITS: usize = 3;

messages! {
    /// Findings on wind and static loads.
    pub(crate) enum Found in "loads.findings" {
        NoWind => {
            en: "Wind is not in the file: the verdict is on weight alone, and a storm may ask for more than the beds bear.",
            ko: "파일에 풍하중이 없다. 판정은 자중만을 고려한 것이며, 폭풍은 접합면의 저항을 넘을 수 있다.",
        },
        Everything => { en: "Wind and static loads as they are", ko: "주어진 풍하중·정하중" },
        Wind => { en: "The wind of the file", ko: "입력한 풍하중" },
        Loads => { en: "The static loads of the file", ko: "입력한 정하중" },
        Combination { name: String } => { en: "Combination {name}", ko: "하중조합 {name}" },
        Overturns { what: Sentence, joint: usize, moment: Quantity, limit: Quantity, factor: Quantity } => {
            en: "{what}: the bed of joint {joint} does not bear it. The moment there is {moment}, and {limit} is the most that the bed passes; {factor} times the load is borne.",
            ko: "{what}: 접합면 {joint}이(가) 견디지 못한다. 작용 모멘트는 {moment}, 접합면이 전달할 수 있는 한계는 {limit}이며, 하중의 {factor}배에서 한계에 이른다.",
        },
        Bears { what: Sentence, joint: usize, moment: Quantity, limit: Quantity, factor: Quantity, stable: Quantity } => {
            en: "{what}: {factor} times the load is borne; “stable” needs {stable}. Joint {joint} governs, with a moment of {moment} against {limit} that its bed passes; beds begin to open at a third of that.",
            ko: "{what}: 하중의 {factor}배까지 견디며 ‘안정’ 판정에는 {stable}배가 필요하다. 지배 접합면은 접합면 {joint}이고 작용 모멘트 {moment}, 접합면 한계 {limit}이다. 접합면은 한계의 3분의 1에서 벌어지기 시작한다.",
        },
        OverturnsBoth { what: Sentence, joint: usize, along: Sentence, across: Sentence, factor: Quantity } => {
            en: "{what}: the bed of joint {joint} does not bear it. The moment there is {along} along and {across} across; {factor} times the load is borne.",
            ko: "{what}: 접합면 {joint}이(가) 견디지 못한다. 작용 모멘트는 운동 방향 {along}, 직각 방향 {across}이며, 하중의 {factor}배에서 한계에 이른다.",
        },
        BearsBoth { what: Sentence, joint: usize, along: Sentence, across: Sentence, factor: Quantity, stable: Quantity } => {
            en: "{what}: {factor} times the load is borne; “stable” needs {stable}. Joint {joint} governs, with a moment of {along} along and {across} across; beds begin to open at a third of that, towards their corners at a sixth.",
            ko: "{what}: 하중의 {factor}배까지 견디며 ‘안정’ 판정에는 {stable}배가 필요하다. 지배 접합면은 접합면 {joint}이고 작용 모멘트는 운동 방향 {along}, 직각 방향 {across}이다. 접합면은 한계의 3분의 1, 모서리 쪽으로는 6분의 1에서 벌어지기 시작한다.",
        },
        OfLimit { moment: Quantity, limit: Quantity } => { en: "{moment} of {limit}", ko: "{moment}(한계 {limit})" },
        Blowing { said: Sentence, towards: Sentence } => {
            en: "{said} The worst wind blows towards {towards}.",
            ko: "{said} 가장 불리한 풍향은 {towards} 방향이다.",
        },
        WindInNone => {
            en: "Wind is in the file, but no combination has a factor on it: it was not counted. Write wind = 1 into [combination.NAME].",
            ko: "파일에 풍하중이 있으나 어느 하중조합에도 계수가 없어 고려하지 않았다. [combination.이름]에 wind = 1을 쓴다.",
        },
        BeforeMoved => {
            en: "That is of the shape in the file, before its supports moved: of wind, and of more load than there is, nothing is known of the shape after it.",
            ko: "이는 지점이 이동하기 전, 파일에 입력한 형상의 값이다. 이동 후의 형상이 바람이나 지금보다 큰 하중을 받을 때의 안정은 알 수 없다.",
        },
        LoadsInNoneOfStack => {
            en: "No combination of the file counts its static loads; whether the stack stands without wind is judged with them all the same.",
            ko: "파일의 하중조합 가운데 정하중을 포함하는 것이 없다. 다만 바람이 없을 때의 안정 판정에는 정하중이 포함되어 있다.",
        },
        LoadsInNone => {
            en: "Static loads are in the file, but no combination has a factor on them: they were not counted. Write loads = 1 into [combination.NAME].",
            ko: "파일에 정하중이 있으나 어느 하중조합에도 계수가 없어 고려하지 않았다. [combination.이름]에 loads = 1을 쓴다.",
        },
        Heavy { what: Sentence, factor: Quantity, stable: Quantity } => {
            en: "{what}: it falls at {factor} times what it weighs with its loads; “stable” needs {stable}.",
            ko: "{what}: 하중의 무게를 포함한 자중의 {factor}배에서 전도되며 ‘안정’ 판정에는 {stable}배가 필요하다.",
        },
        Carried { weight: Quantity, factor: Quantity, frequency: Quantity } => {
            en: "The load factor and the frequencies above are without what the static loads weigh ({weight}); with it the load factor is {factor} and the lowest frequency {frequency}.",
            ko: "위의 하중배율과 고유진동수에는 정하중의 중량({weight})이 포함되지 않았다. 포함하면 하중배율은 {factor}, 최저 고유진동수는 {frequency}이다.",
        },
        CarriedFalls { weight: Quantity, factor: Quantity } => {
            en: "The load factor and the frequencies above are without what the static loads weigh ({weight}); with it the load factor is {factor}.",
            ko: "위의 하중배율과 고유진동수에는 정하중의 중량({weight})이 포함되지 않았다. 포함하면 하중배율은 {factor}이다.",
        },
        NothingPushes { what: Sentence } => {
            en: "{what}: nothing pushes from the side, so that the weight alone was judged.",
            ko: "{what}: 수평으로 작용하는 하중이 없어 자중만을 판정하였다.",
        },
        Falls { what: Sentence } => {
            en: "{what}: it falls under the weight of this combination alone.",
            ko: "{what}: 이 하중조합의 자중만으로도 전도된다.",
        },
        AtLeast { what: Sentence, joint: usize, moment: Quantity } => {
            en: "{what}: whether it is borne is unknown. Joint {joint} passes {moment} at the least, without what the weight adds as it leans; that needs the stiffness of the joints and the widths of their beds.",
            ko: "{what}: 저항 여부를 판정할 수 없다. 접합면 {joint}의 모멘트는 최소 {moment}이며 기울어짐에 따른 자중의 증가분은 포함되지 않았다. 접합부 강성과 접합면 폭이 필요하다.",
        },
        StackFalls { what: Sentence, factor: Quantity, moves: Sentence } => {
            en: "{what}: the stones do not bear it; {factor} times the load is borne. {moves}",
            ko: "{what}: 석재가 견디지 못한다. 하중의 {factor}배에서 한계에 이른다. {moves}",
        },
        StackBears { what: Sentence, factor: Quantity, stable: Quantity, moves: Sentence } => {
            en: "{what}: {factor} times the load is borne; “stable” needs {stable}. {moves}",
            ko: "{what}: 하중의 {factor}배까지 견디며 ‘안정’ 판정에는 {stable}배가 필요하다. {moves}",
        },
        MovesInWind { joints: Sentence, direction: Sentence } => {
            en: "Then {joints}, the wind blowing towards {direction}.",
            ko: "이때 {joints}이며 풍향은 {direction} 방향이다.",
        },
        Moves { joints: Sentence } => { en: "Then {joints}.", ko: "이때 {joints}이다." },
        Towards { direction: Sentence } => {
            en: "The worst wind blows towards {direction}.",
            ko: "가장 불리한 풍향은 {direction} 방향이다.",
        },
        NoMechanism => { en: "What moves then was not found.", ko: "이때의 거동은 찾지 못하였다." },
        NothingMoves { what: Sentence } => {
            en: "{what}: nothing that it asks moves a stone, at ten times the weight of the whole either.",
            ko: "{what}: 전체 자중의 10배에 이르도록 하중을 키워도 움직이는 석재가 없다.",
        },
        Slides => {
            en: "Stones slide there while others share their load. The limit analysis lets sliding joints rise, which real ones do not: the factor is an upper bound.",
            ko: "이때 하중을 나누어 지지하는 석재가 미끄러진다. 한계해석은 미끄러지는 접합면이 들리는 것으로 가정하나 실제는 그렇지 않으므로 저항 배수는 상한값이다.",
        },
        NotKnown { why: Sentence } => {
            en: "The wind is not compared: {why}.",
            ko: "풍하중을 검토하지 못하였다. {why}.",
        },
        NoResonance { frequency: Quantity } => {
            en: "At {frequency} gusts make it swing, and a gust as given does not hold that: what it bears above is without resonance. Give the 10-minute mean with code = \"EN 1991-1-4\" and the damping ratio.",
            ko: "고유진동수가 {frequency}이므로 돌풍에 공진할 수 있으나, 주어진 돌풍 값에는 공진 효과가 없다. 위의 저항 배수는 공진을 제외한 값이다. 10분 평균 풍속을 code = \"EN 1991-1-4\" 및 감쇠비와 함께 입력해야 한다.",
        },
    }
}

messages! {
    /// Why a wind is not known.
    pub(crate) enum WhyNot in "loads.why-not" {
        Frequency => {
            en: "its code asks for the lowest natural frequency, which needs the stiffness of the joints",
            ko: "기준에 1차 고유진동수가 필요하나 접합부 강성이 주어지지 않았다",
        },
        Damping { frequency: Quantity } => {
            en: "at {frequency} resonance counts, which needs damping_ratio",
            ko: "고유진동수 {frequency}에서는 공진을 고려해야 하며 damping_ratio가 필요하다",
        },
        StackSways { frequency: Quantity } => {
            en: "on the springs of its joints it sways at {frequency}, where gusts near that frequency add to the pressure of the code. Give the gust of a wind study, or joints with a stiffness that was measured",
            ko: "접합부 스프링에 의한 고유진동수가 {frequency}이며, 이때 기준의 풍압에 공진 효과가 더해진다. 풍하중 평가의 돌풍 값이나 계측된 접합부 강성을 입력한다",
        },
        StackFrequency => {
            en: "its code asks for the lowest natural frequency, which was not found",
            ko: "기준에 1차 고유진동수가 필요하나 구하지 못하였다",
        },
        TooSoft { frequency: Quantity, least: Quantity } => {
            en: "its lowest frequency is {frequency}, and the gust factor of KDS 41 12 00 that is held here is for more than {least}: below it the resonant part comes on top. Use code = \"EN 1991-1-4\", whose Annex B holds it, or give the gust of a wind study",
            ko: "1차 고유진동수가 {frequency}이며, 여기에 구현된 KDS 41 12 00의 가스트영향계수는 {least}을(를) 넘는 강체 구조물용이다. 그 이하에서는 공진 성분이 더해진다. 부속서 B가 있는 code = \"EN 1991-1-4\"를 쓰거나 풍동실험·풍하중 평가의 돌풍 값을 준다",
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

/// Why a wind is not known.
pub(super) fn why_not(error: &WindError, is_stack: bool) -> Sentence {
    match error {
        WindError::FrequencyUnknown if is_stack => WhyNot::StackFrequency,
        WindError::DampingUnknown { frequency_hz } if is_stack => WhyNot::StackSways {
            frequency: hertz(*frequency_hz),
        },
        WindError::FrequencyUnknown => WhyNot::Frequency,
        WindError::DampingUnknown { frequency_hz } => WhyNot::Damping {
            frequency: hertz(*frequency_hz),
        },
        WindError::TooSoft {
            frequency_hz,
            least_hz,
        } => WhyNot::TooSoft {
            frequency: hertz(*frequency_hz),
            least: hertz(*least_hz),
        },
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

/// A combination by its name, or what acts.
pub(super) fn what(answer: &LoadsAnswer, combination: &CombinationAnswer) -> Sentence {
    match (&combination.name, answer.has_wind, answer.has_loads) {
        (Some(name), _, _) => Found::Combination { name: name.clone() },
        (None, true, true) => Found::Everything,
        (None, true, false) => Found::Wind,
        (None, false, _) => Found::Loads,
    }
    .into()
}

/// That a pole has no wind; of others nothing.
fn no_wind(project: &Project, state: &State) -> Option<Finding> {
    let is_silent = matches!(project.structure, Structure::Chain(_))
        && project.loads.wind == WindPart::NotSaid
        && state.verdict() != Verdict::Unstable;
    is_silent.then(|| Finding::key(Tone::Warn, Found::NoWind).with_code("no-wind"))
}

/// The findings, the worst combination alone.
pub(crate) fn findings(project: &Project, state: &State) -> Vec<Finding> {
    let Some(answer) = &state.loads else {
        return no_wind(project, state).into_iter().collect();
    };
    let mut all = Vec::new();
    if let Some(Err(why)) = &answer.wind {
        let why = why_not(why, matches!(state.check, Check::Stack(_)));
        all.push(Finding::key(Tone::Unknown, Found::NotKnown { why }));
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
    let in_none = |of: fn(&CombinationAnswer) -> f64| answer.combinations.iter().all(|each| of(each) == 0.0);
    if answer.has_wind && in_none(|of| of.wind) && !answer.combinations.is_empty() {
        all.push(Finding::key(Tone::Warn, Found::WindInNone));
    }
    if answer.has_loads && in_none(|of| of.loads) && !answer.combinations.is_empty() {
        let said = match &state.check {
            Check::Stack(_) => Found::LoadsInNoneOfStack,
            _ => Found::LoadsInNone,
        };
        all.push(Finding::key(Tone::Warn, said));
    }
    let stack = match &state.check {
        Check::Stack(answer) => Some(&answer.stack),
        _ => None,
    };
    all.extend(
        answer
            .worst()
            .and_then(|worst| of_combination(answer, worst, stack)),
    );
    if stack.is_some_and(|stack| !stack.support_movements().is_empty()) && !answer.combinations.is_empty() {
        all.push(Finding::key(Tone::Warn, Found::BeforeMoved));
    }
    let slides = answer
        .worst()
        .and_then(CombinationAnswer::stack)
        .is_some_and(|under| under.found.slides());
    if slides && stack.is_some_and(|stack| !is_pile(stack)) {
        all.push(Finding::new(Tone::Warn, Found::Slides));
    }
    if let Some(frequency_hz) = answer.lacks_resonance_at_hz() {
        let frequency = hertz(frequency_hz);
        all.push(Finding::key(Tone::Warn, Found::NoResonance { frequency }));
    }
    if !answer.has_wind {
        all.extend(no_wind(project, state));
    }
    all
}

fn of_combination(answer: &LoadsAnswer, worst: &CombinationAnswer, stack: Option<&Stack>) -> Option<Finding> {
    match (&worst.of, stack) {
        (Combined::Chain(chain), _) => of_chain(what(answer, worst), chain),
        (Combined::Stack(under), Some(stack)) => Some(of_stack(what(answer, worst), under, stack)),
        (Combined::Stack(_), None) => None,
    }
}

/// What a stack bears of a combination.
fn of_stack(what: Sentence, under: &StackUnderLoads, stack: &Stack) -> Finding {
    let verdict = under.verdict();
    let tone = Tone::of(verdict);
    let factor = under.found.factor;
    let moving = joints_moving(stack, under.found.mechanism.as_ref());
    let moves = match (moving, under.wind_to) {
        (Some(joints), Some(to)) => Found::MovesInWind {
            joints,
            direction: direction(to),
        },
        (Some(joints), None) => Found::Moves { joints },
        (None, Some(to)) => Found::Towards {
            direction: direction(to),
        },
        (None, None) => Found::NoMechanism,
    };
    let moves: Sentence = moves.into();
    let said = match (factor == 0.0, factor.is_finite(), verdict) {
        (true, ..) => Found::Falls { what },
        (_, false, _) => Found::NothingMoves { what },
        (_, _, Verdict::Unstable) => Found::StackFalls {
            what,
            factor: Quantity::beside_one(factor, DIGITS),
            moves,
        },
        _ => Found::StackBears {
            what,
            factor: Quantity::beside_one(factor, DIGITS),
            stable: Quantity::ratio(Verdict::MARGINAL_BELOW, 2),
            moves,
        },
    };
    Finding::key(tone, said)
}

fn of_chain(what: Sentence, chain: &ChainCombination) -> Option<Finding> {
    let under = &chain.under;
    let verdict = chain.verdict();
    let tone = Tone::of(verdict);
    if under.factor == Some(0.0) && under.joints.iter().all(|joint| joint.moment_n_m.is_none()) {
        return Some(Finding::key(tone, Found::Falls { what }));
    }
    let weighs_too_much = matches!(chain.weight_verdict(), Verdict::Marginal | Verdict::Unstable);
    let by_loads = under.factor.map_or(Verdict::Unknown, Verdict::of_load_factor);
    if let (true, Verdict::Stable, Some(factor)) = (weighs_too_much, by_loads, chain.weight_factor) {
        let factor = Quantity::beside_one(factor, DIGITS);
        let stable = Quantity::ratio(Verdict::MARGINAL_BELOW, 2);
        return Some(Finding::key(tone, Found::Heavy { what, factor, stable }));
    }
    if under.factor == Some(f64::INFINITY) {
        return Some(Finding::key(Tone::Plain, Found::NothingPushes { what }));
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

/// A joint of a chain of two directions; `None` where a limit is not known.
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
