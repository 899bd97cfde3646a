//! Findings on the demand of a site.

use super::first::first;
use super::local_mechanisms;
use super::unverified::unverified;
use super::words::{in_g, verdict_words};
use crate::document::{Finding, Tone};
use crate::limits;
use dolmen::assess::demand::{StackDemandCheck, StackDemandRow};
use dolmen::stability::stack::DemandVerdict;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, messages};
use dolmen_work::frame::UnfollowedStorey;
use dolmen_work::part_limit::{Limited, NotCompared, PartLimit, SplitDrift, WhyNotCompared, worst_part};
use dolmen_work::state::DemandAnswer;

/// Digits of accelerations and ratios.
const DIGITS: usize = 3;

messages! {
    /// Findings on the demand of a site.
    pub(crate) enum Found in "demand.findings" {
        Compared { verdict: Sentence, moves: Sentence, ground: Sentence, joints: Sentence } => {
            en: "Against the earthquake of the site it is {verdict}: {moves}; {ground}{joints}. Below demand means that something tips or slides, not that it falls.",
            ko: "부지의 지진에 대한 판정은 ‘{verdict}’이다. {moves} {ground}{joints}. ‘기준 불만족’은 돌이 들리거나 미끄러지기 시작한다는 뜻이며 붕괴를 뜻하지 않는다.",
        },
        ComparedBefore { verdict: Sentence, moves: Sentence, ground: Sentence, joints: Sentence } => {
            en: "In its shape before the supports moved it is {verdict} against the earthquake of the site: {moves}; {ground}{joints}. After the movement it is weaker, and nothing is decided of that shape. Below demand means that something tips or slides, not that it falls.",
            ko: "지점이 움직이기 전의 모양에서 부지의 지진과 비교하면 ‘{verdict}’이다. {moves} {ground}{joints}. 지점이 움직인 뒤에는 이보다 약하며, 그 모양에 대하여는 판정하지 않았다. ‘기준 불만족’은 돌이 들리거나 미끄러지기 시작한다는 뜻이며 붕괴를 뜻하지 않는다.",
        },
        Moves(left: Quantity) => {
            en: "it begins to move at {left} with the vertical acceleration of the site",
            ko: "부지의 수직 가속도를 고려한 거동 시작 가속도는 {left}이고",
        },
        MovesUnknown => {
            en: "no acceleration is known at which it begins to move with the vertical acceleration of the site",
            ko: "부지의 수직 가속도를 고려한 거동 시작 가속도는 구할 수 없으며",
        },
        Ground { source: String, ground: Quantity } => {
            en: "{source} asks for {ground} of the ground",
            ko: "{source}의 지반 가속도는 {ground}이다",
        },
        Elastic { ratio: Quantity, first: Sentence } => {
            en: ". On elastic joints, which amplify it, {ratio} times the spectrum is borne: {first}",
            ko: ". 탄성 접합면의 증폭을 고려하면 스펙트럼의 {ratio}배까지 견딘다({first})",
        },
        ElasticUnknown => {
            en: "; what elastic joints add to it is not known",
            ko: ". 탄성 접합면의 증폭은 알 수 없다",
        },
        NoStiffness => {
            en: "The demand of the site is not compared: the stiffness is not known.",
            ko: "강성을 알 수 없어 부지의 설계지진과 비교하지 않는다.",
        },
        NoStiffnessIn(direction: String) => {
            en: "Direction {direction} is not compared with the demand of the site: its stiffness is not known.",
            ko: "{direction} 방향은 강성을 알 수 없어 부지의 설계지진과 비교하지 않는다.",
        },
        Falls => {
            en: "The demand of the site is not compared: it falls under its own weight.",
            ko: "자중만으로 붕괴하므로 부지의 설계지진과 비교하지 않는다.",
        },
        FallsIn(direction: String) => {
            en: "Direction {direction} is not compared with the demand of the site: it falls under its own weight.",
            ko: "{direction} 방향은 자중만으로 붕괴하므로 부지의 설계지진과 비교하지 않는다.",
        },
        FallsSlipping => {
            en: "The demand of the site is not compared: it falls under its own weight while its joints slip.",
            ko: "접합부가 미끄러질 때 자중만으로 붕괴하므로 부지의 설계지진과 비교하지 않는다.",
        },
        FallsSlippingIn(direction: String) => {
            en: "Direction {direction} is not compared with the demand of the site: it falls under its own weight while its joints slip.",
            ko: "{direction} 방향은 접합부가 미끄러질 때 자중만으로 붕괴하므로 부지의 설계지진과 비교하지 않는다.",
        },
        NoSpectrum => {
            en: "The demand of the site is not compared: its spectrum has no value at this damping or these periods.",
            ko: "부지 스펙트럼에 이 감쇠비 또는 주기의 값이 없어 부지의 요구 수준과 비교하지 않는다.",
        },
        NoSpectrumIn(direction: String) => {
            en: "Direction {direction} is not compared with the demand of the site: its spectrum has no value at this damping or these periods.",
            ko: "{direction} 방향은 부지 스펙트럼에 이 감쇠비 또는 주기의 값이 없어 부지의 요구 수준과 비교하지 않는다.",
        },
        NotComparedIn { direction: String, why: Both } => {
            en: "Direction {direction} is not compared with the demand of the site: {why}.",
            ko: "{direction} 방향은 부지의 요구 수준과 비교하지 못하였다({why}).",
        },
        LoosePost => {
            en: "The demand of the site is not compared: a side post with a gap may close, and what is above it then asks more than without. «`dolmen simulate`|A simulation in time» follows it.",
            ko: "틈이 있는 지주가 맞닿으면 그 위의 요구 수준이 커지므로 부지의 설계지진과 비교하지 않는다. «`dolmen simulate`|지진응답 검토»로 검토한다.",
        },
        FeetLiftOff => {
            en: "The demand of the site is not compared: the columns that alone support it lift off their stones at a smaller drift than the spectrum asks for, and are softer beyond. «`dolmen simulate`|A simulation in time» follows a frame of one storey.",
            ko: "골조를 홀로 지지하는 기둥의 주각이 스펙트럼의 층간변위보다 작은 변위에서 들리고 그 뒤에는 더 유연하므로 부지의 설계지진과 비교하지 않는다. 단층 골조는 «`dolmen simulate`|지진응답 검토»로 검토한다.",
        },
        FeetLiftOffIn(direction: String) => {
            en: "Direction {direction} is not compared with the demand of the site: the columns that alone support it lift off their stones at a smaller drift than the spectrum asks for, and are softer beyond. «`dolmen simulate`|A simulation in time» follows a frame of one storey.",
            ko: "{direction} 방향은 골조를 홀로 지지하는 기둥의 주각이 스펙트럼의 층간변위보다 작은 변위에서 들리고 그 뒤에는 더 유연하므로 부지의 설계지진과 비교하지 않는다. 단층 골조는 «`dolmen simulate`|지진응답 검토»로 검토한다.",
        },
        Rubs => {
            en: "Joints with dry friction are held against the site as free and as sticking, where the whole moves with the ground: the larger moment counts. A part that sticks while others turn is not tried.",
            ko: "마찰이 있는 접합부는 자유로운 경우와 고착되어 전체가 지반과 함께 움직이는 경우 중 큰 모멘트로 부지의 지진과 비교하였다. 일부만 고착된 경우는 검토하지 않았다.",
        },
        Split { direction: String, storey: String, joints: Quantity, beds: Quantity, lifts: Quantity } => {
            en: "Direction {direction}: how beds and joints share the stiffness of ‘{storey}’ is assumed, since a frequency measures only their sum. By the spectrum it drifts by {joints} of its height with all of it in the joints, and by about {beds} with all of it in the beds of its columns, which soften where feet lift off at {lifts} (secant stiffness). «`dolmen simulate`|A simulation in time» follows both.",
            ko: "{direction} 방향: 고유진동수는 ‘{storey}’의 지압면과 접합부 강성의 합만 나타내므로 그 분담은 가정이다. 스펙트럼에 의한 층간변위는 모두 접합부의 강성이면 층고의 {joints}, 모두 기둥 지압면의 강성이면 약 {beds}이며, 뒤의 경우 {lifts}에서 주각이 들려 강성이 낮아진다(할선 강성). «`dolmen simulate`|지진응답 검토»는 두 경우를 모두 해석한다.",
        },
        SplitFalls { direction: String, storey: String, joints: Quantity, lifts: Quantity } => {
            en: "Direction {direction}: how beds and joints share the stiffness of ‘{storey}’ is assumed, since a frequency measures only their sum. By the spectrum it drifts by {joints} of its height with all of it in the joints; with all of it in the beds of its columns, which soften where feet lift off at {lifts}, the spectrum asks for more than they have. «`dolmen simulate`|A simulation in time» follows both.",
            ko: "{direction} 방향: 고유진동수는 ‘{storey}’의 지압면과 접합부 강성의 합만 나타내므로 그 분담은 가정이다. 스펙트럼에 의한 층간변위는 모두 접합부의 강성이면 층고의 {joints}이다. 모두 기둥 지압면의 강성이면 {lifts}에서 주각이 들려 강성이 낮아지며, 스펙트럼의 요구가 기둥의 저항을 넘는다. «`dolmen simulate`|지진응답 검토»는 두 경우를 모두 해석한다.",
        },
        SplitGiven { direction: String, storey: String, beds: Quantity, joints: Quantity, linear: Quantity, softened: Quantity, lifts: Quantity } => {
            en: "Direction {direction}: of the stiffness of ‘{storey}’ the beds have {beds}, as «bed_stiffness|the file» gives it, and joints and walls the other {joints}. Feet lift off at {lifts} of its height and soften it: by the spectrum it drifts by about {softened} (secant stiffness), as if linear by {linear}; the larger counts. «`dolmen simulate`|A simulation in time» follows it.",
            ko: "{direction} 방향: ‘{storey}’의 층강성 가운데 {beds}은(는) «bed_stiffness에|입력값에» 따라 지압면이, 나머지 {joints}은(는) 접합부와 벽체가 부담한다. 층고의 {lifts}에서 주각이 들려 강성이 낮아지므로 스펙트럼에 의한 층간변위는 약 {softened}(할선 강성), 선형으로는 {linear}이며 큰 값으로 판정한다. «`dolmen simulate`|지진응답 검토»로 해석할 수 있다.",
        },
        NoBalanceIn(direction: String) => {
            en: "Direction {direction} is not compared with the demand of the site: feet lift off, and by the secant stiffness the spectrum asks for a larger drift than columns and joints bear before the storey counts as fallen. «`dolmen simulate`|A simulation in time» follows it.",
            ko: "{direction} 방향은 주각이 들린 뒤 할선 강성에 의한 스펙트럼의 층간변위가 전도로 보는 변위를 넘으므로 부지의 설계지진과 비교하지 않는다. «`dolmen simulate`|지진응답 검토»로 검토한다.",
        },
        UnfollowedGiven { direction: String, storey: String, linear: Quantity, lifts: Quantity } => {
            en: "Direction {direction}: by the spectrum ‘{storey}’ drifts by {linear} of its height as if linear; on beds as stiff as «bed_stiffness|the file» says, feet lift off at {lifts} and soften it, which is followed in a frame of one storey without friction and tenons alone.",
            ko: "{direction} 방향: 스펙트럼에 의한 ‘{storey}’의 선형 층간변위는 층고의 {linear}이다. «bed_stiffness의|입력한 강성의» 지압면에서는 {lifts}에서 주각이 들려 강성이 낮아지며, 이는 마찰과 장부가 없는 단층 골조에서만 추적한다.",
        },
        UnfollowedAssumed { direction: String, storey: String, linear: Quantity, lifts: Quantity } => {
            en: "Direction {direction}: how beds and joints share the stiffness of ‘{storey}’ is assumed. By the spectrum it drifts by {linear} of its height as if linear; with all of it in the beds of its columns feet lift off from {lifts} on and soften it. No range of the drift was computed, which is done in a frame of one storey without friction and tenons alone.",
            ko: "{direction} 방향: ‘{storey}’의 지압면과 접합부의 강성 분담은 가정이다. 스펙트럼에 의한 선형 층간변위는 층고의 {linear}이며, 모두 기둥 지압면의 강성이면 {lifts}부터 주각이 들려 강성이 낮아진다. 층간변위의 범위는 마찰과 장부가 없는 단층 골조에서만 구하므로 여기서는 구하지 않았다.",
        },
        BySpectrum => { en: "by the spectrum of the site", ko: "부지 스펙트럼에 대하여" },
        NotCompared(why: Both) => {
            en: "The demand of the site is not compared: {why}.",
            ko: "부지의 설계지진과 비교하지 못하였다({why}).",
        },
    }
}

/// The comparison, and unverified parts of the code.
///
/// `has_moved`: the supports of the structure moved, and the comparison is for its shape before. `drift_left`: the share of the allowable drift
/// that a tilt outside the model leaves.
pub(crate) fn findings(
    answer: Option<&DemandAnswer>,
    has_moved: bool,
    drift_left: Option<f64>,
) -> Vec<Finding> {
    let Some(answer) = answer else {
        return Vec::new();
    };
    let source = &answer.site.spectrum.source;
    let compared = answer
        .stack
        .as_ref()
        .and_then(|stack| compared(stack, source, has_moved));
    // otherwise with the direction
    let refused = answer
        .refused
        .clone()
        .filter(|_| answer.compared.parts.is_empty());
    let refused = refused.map(|why| Finding::key(Tone::Unknown, Found::NotCompared(why)));
    let parts = limits::findings(
        &answer.compared.parts,
        answer.drift_limit.as_ref(),
        Some(Found::BySpectrum.into()),
    );
    let leans = drift_left.is_some_and(|left| {
        let drifts = worst_part(&answer.compared.parts, Limited::Drift).and_then(PartLimit::ratio);
        drifts.is_some_and(|ratio| DemandVerdict::of_ratio(ratio * left) != DemandVerdict::of_ratio(ratio))
    });
    let parts = parts.into_iter().map(|part| match part.tone {
        Tone::Good | Tone::Warn if leans => Finding {
            tone: Tone::Unknown,
            ..part
        },
        _ => part,
    });
    // without a balance the finding on its beds and joints says so
    let without = answer.compared.not_compared.iter();
    let without = without.filter(|of| of.why != WhyNotCompared::NoBalance);
    let without = without.map(|of| {
        let said = match (of.why, &of.direction, &answer.refused) {
            (WhyNotCompared::NoSpectrum, Some(direction), Some(why)) => Found::NotComparedIn {
                direction: direction.clone(),
                why: why.clone(),
            },
            _ => not_compared(of),
        };
        Finding::key(Tone::Unknown, said)
    });
    let rubs = answer
        .compared
        .rubs
        .then(|| Finding::key(Tone::Plain, Found::Rubs));
    let splits = answer.compared.splits.iter();
    let splits = splits.map(|of| Finding::key(Tone::Warn, split(of)));
    let unfollowed = answer.compared.unfollowed.iter();
    let unfollowed = unfollowed.map(|(direction, of)| Finding::key(Tone::Warn, springs_alone(direction, of)));
    let parts = parts.chain(splits).chain(unfollowed).chain(rubs);
    let unverified = unverified(&answer.site).map(|said| Finding::new(Tone::Warn, said));
    let compared = compared.into_iter().chain(refused).chain(without).chain(parts);
    let local = local_mechanisms::finding(&answer.local_mechanisms);
    compared.chain(local).chain(unverified).collect()
}

/// The range of the drift of a storey whose beds and joints share its stiffness.
fn split(of: &SplitDrift) -> Found {
    let share = |ratio: f64| Quantity::percent(ratio, DIGITS);
    let (direction, storey) = (of.direction.clone(), of.in_beds.part.name().to_owned());
    let (joints, lifts) = (share(of.in_joints), share(of.uplift));
    let [beds, others] = of
        .shares_n_m
        .map(|value| Quantity::engineering(value, "N/m", DIGITS));
    match (of.beds.is_file(), of.in_beds.demand.is_finite()) {
        (true, true) => Found::SplitGiven {
            direction,
            storey,
            beds,
            joints: others,
            linear: joints,
            softened: share(of.in_beds.demand),
            lifts,
        },
        (true, false) => Found::NoBalanceIn(direction),
        (false, true) => Found::Split {
            direction,
            storey,
            joints,
            beds: share(of.in_beds.demand),
            lifts,
        },
        (false, false) => Found::SplitFalls {
            direction,
            storey,
            joints,
            lifts,
        },
    }
}

/// A storey by springs alone, whose feet lift off.
fn springs_alone(direction: &str, of: &UnfollowedStorey) -> Found {
    let share = |ratio: f64| Quantity::percent(ratio, DIGITS);
    let (direction, storey) = (direction.to_owned(), of.name.clone());
    let (linear, lifts) = (share(of.drift), share(of.uplift));
    match of.beds.is_file() {
        true => Found::UnfollowedGiven {
            direction,
            storey,
            linear,
            lifts,
        },
        false => Found::UnfollowedAssumed {
            direction,
            storey,
            linear,
            lifts,
        },
    }
}

/// Why a direction was not compared.
pub(super) fn not_compared(of: &NotCompared) -> Found {
    match (of.why, of.direction.clone()) {
        (WhyNotCompared::LoosePost, _) => Found::LoosePost,
        (WhyNotCompared::FeetLiftOff, None) => Found::FeetLiftOff,
        (WhyNotCompared::FeetLiftOff, Some(direction)) => Found::FeetLiftOffIn(direction),
        (WhyNotCompared::StiffnessUnknown, None) => Found::NoStiffness,
        (WhyNotCompared::StiffnessUnknown, Some(direction)) => Found::NoStiffnessIn(direction),
        (WhyNotCompared::NoBalance, direction) => Found::NoBalanceIn(direction.unwrap_or_default()),
        (WhyNotCompared::NoSpectrum, None) => Found::NoSpectrum,
        (WhyNotCompared::NoSpectrum, Some(direction)) => Found::NoSpectrumIn(direction),
        (WhyNotCompared::Falls, None) => Found::Falls,
        (WhyNotCompared::Falls, Some(direction)) => Found::FallsIn(direction),
        (WhyNotCompared::FallsSlipping, None) => Found::FallsSlipping,
        (WhyNotCompared::FallsSlipping, Some(direction)) => Found::FallsSlippingIn(direction),
    }
}

fn compared(stack: &StackDemandCheck, source: &str, has_moved: bool) -> Option<Finding> {
    let tone = match stack.verdict {
        DemandVerdict::Above if has_moved => Tone::Warn,
        DemandVerdict::Above => Tone::Good,
        DemandVerdict::Near => Tone::Warn,
        DemandVerdict::Below => Tone::Bad,
        DemandVerdict::Unknown => Tone::Unknown,
    };
    let row = stack.rows.last()?;
    let rigid = &row.comparison.rigid;
    let acceleration = |m_s2| in_g(m_s2, Digits::Significant(DIGITS));
    let moves = rigid
        .capacity_m_s2
        .map_or(Found::MovesUnknown, |m_s2| Found::Moves(acceleration(m_s2)));
    let ground = Found::Ground {
        source: source.to_owned(),
        ground: acceleration(rigid.demand_m_s2),
    };
    let (verdict, moves, ground) = (verdict_words(stack.verdict), moves.into(), ground.into());
    let joints = elastic_joints(row);
    let found = match has_moved {
        true => Found::ComparedBefore {
            verdict,
            moves,
            ground,
            joints,
        },
        false => Found::Compared {
            verdict,
            moves,
            ground,
            joints,
        },
    };
    Some(Finding::key(tone, found))
}

fn elastic_joints(row: &StackDemandRow) -> Sentence {
    match &row.by_modes {
        Some(by_modes) => Found::Elastic {
            ratio: Quantity::ratio(by_modes.ratio, DIGITS),
            first: first(by_modes),
        },
        None => Found::ElasticUnknown,
    }
    .into()
}
