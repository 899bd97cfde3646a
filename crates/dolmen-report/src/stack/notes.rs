//! Notes on the numbers of a stack.

use super::words::{in_g, place, value};
use crate::simulated::milli;
use dolmen::assess::{Gaps, StackNote};
use dolmen::structure::stack::{Body, Stack};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Notes on the limits of a stack.
    pub(crate) enum Notes in "stack.notes" {
        SharedLoad => {
            en: "Stones share their load, so the joints one by one give an upper bound; the limit analysis decides.",
            ko: "여러 부재가 하중을 나누어 지지하므로 접합면별 값은 상한이며, 한계해석으로 판정한다.",
        },
        Lower { analysis: Quantity, joints: Quantity } => {
            en: "The limit analysis finds {analysis}, less than the {joints} of the joints one by one: parts move together, twist, or slide and open.",
            ko: "한계해석의 결과는 {analysis}(으)로 접합면별 값 {joints}보다 작다. 여러 부재가 함께 움직이거나 비틀리거나 미끄러지며 벌어진다.",
        },
        LowerAlone { analysis: Quantity } => {
            en: "Only the limit analysis gives a limit: {analysis}.",
            ko: "한계해석만이 한계를 준다: {analysis}.",
        },
        Between { at_least: Quantity, analysis: Quantity } => {
            en: "The limit analysis found balance in every direction up to {at_least}, and none at {analysis} in one: the lower counts.",
            ko: "한계해석에서 모든 방향으로 {at_least}까지는 평형이 확인되었고 한 방향에서 {analysis}에는 평형이 없다. 낮은 값을 기준으로 판정한다.",
        },
        Falls => {
            en: "Joint by joint it seems to stand, but no forces in the joints balance its weight.",
            ko: "접합면별로는 서 있는 것으로 보이나, 자중에 평형을 이루는 접합력이 존재하지 않는다.",
        },
        LoadsWithoutMass => {
            en: "Static loads press on stones, but have no mass in an earthquake: what rests on the stones and shakes with them is a block of its own.",
            ko: "정하중은 석재를 누르나 지진 시 질량이 없다. 석재 위에 놓여 함께 흔들리는 것은 별도의 블록으로 입력한다.",
        },
        LoadsHold { with: Quantity, without: Quantity } => {
            en: "Static loads press on stones and have no mass in an earthquake. With all of them it begins to move at {with}, without those that hold it at {without}: the demand of the site is held against the worse of both. What rests on the stones and shakes with them is a block of its own.",
            ko: "정하중은 석재를 누르나 지진 시 질량이 없다. 모든 정하중이 있으면 {with}에서, 안정에 기여하는 정하중이 없으면 {without}에서 움직이기 시작하므로 부지의 요구는 둘 중 불리한 쪽으로 판정하였다. 석재 위에 놓여 함께 흔들리는 것은 별도의 블록으로 입력한다.",
        },
        LoadsHoldUp => {
            en: "Static loads press on stones and have no mass in an earthquake, and without those that hold it up it does not stand. What rests on the stones and shakes with them is a block of its own.",
            ko: "정하중은 석재를 누르나 지진 시 질량이 없으며, 안정에 기여하는 정하중이 없으면 서 있지 못한다. 석재 위에 놓여 함께 흔들리는 것은 별도의 블록으로 입력한다.",
        },
        FrictionCarries => {
            en: "Friction carries it: forces that balance the weight exist, which is necessary but does not prove that it stands, since joints that slip may choose other forces. No run under its own weight was made, so the verdict is no better than marginal.",
            ko: "하중 지지에 마찰이 필요하다. 자중과 평형을 이루는 힘이 존재하나 이는 필요조건이며, 미끄러지는 접합면은 다른 힘을 택할 수 있으므로 서 있음을 증명하지는 않는다. 자중에 대한 시간이력해석을 하지 않았으므로 판정은 '여유 부족'을 넘지 않는다.",
        },
        FrictionStood => {
            en: "Friction carries it: forces that balance the weight exist, which alone does not prove that it stands; in a run under its own weight, on the springs of its joints, it stood.",
            ko: "하중 지지에 마찰이 필요하다. 자중과 평형을 이루는 힘이 존재하며(필요조건), 접촉 스프링 위의 자중 시간이력해석에서 안정을 유지하였다.",
        },
        FrictionFell { stone: String } => {
            en: "Friction would have to carry it: forces that balance the weight exist, but in a run under its own weight, on the springs of its joints, '{stone}' fell.",
            ko: "하중 지지에 마찰이 필요하다. 자중과 평형을 이루는 힘은 존재하나, 접촉 스프링 위에서 자중에 대한 시간이력해석을 한 결과 ‘{stone}’이(가) 떨어졌다.",
        },
        FrictionNoRest => {
            en: "Friction would have to carry it: forces that balance the weight exist, but a run under its own weight, on the springs of its joints, found no rest. It is not known to stand.",
            ko: "하중 지지에 마찰이 필요하다. 자중과 평형을 이루는 힘은 존재하나, 접촉 스프링 위에서 자중에 대한 시간이력해석이 정지 상태에 이르지 않아 서 있다고 판정할 수 없다.",
        },
        FrictionNotRun { stones: usize, most: usize } => {
            en: "Friction carries it: forces that balance the weight exist, which alone does not prove that it stands. A run under its own weight would; with {stones} stones, more than {most}, a check makes none: simulate it.",
            ko: "하중 지지에 마찰이 필요하다. 자중과 평형을 이루는 힘이 존재하나 이는 필요조건이며 서 있음을 증명하지는 않는다. 부재가 {stones}개로 {most}개를 넘어 자중에 대한 시간이력해석을 하지 않았다. simulate로 해석한다.",
        },
        StrengthInside => {
            en: "The limit analysis takes what joints of finite strength bear from inside, as mixtures of blocks of full stress: on the safe side, by at most 1.3 % of the moment about an edge and 4 % askew (6 % and 12 % with more than 25 joints).",
            ko: "한계해석은 압축강도가 있는 접합면의 저항을 등가 응력 블록의 조합으로 안쪽에서 근사한다(안전측). 저항 모멘트의 오차는 모서리 방향 1.3 %, 비스듬한 방향 4 % 이내이다(접합면이 25개를 넘으면 6 %, 12 %).",
        },
        NoSideSupports => {
            en: "Side supports are left out of all thresholds; what they hold is not counted, which is on the safe side.",
            ko: "측면 지지는 모든 한계값에서 제외하였다(안전측).",
        },
        Cohesion => {
            en: "Cohesion counts against sliding in full in every joint at once; a bond breaks brittle and one joint after the other, so this is on the unsafe side.",
            ko: "점착력은 모든 접합면에서 동시에 전부 작용하는 것으로 보았으나, 실제 부착은 취성으로 하나씩 파괴되므로 불안전측이다.",
        },
        NoTension => {
            en: "The tensile strength of joints is left out of all thresholds, which is on the safe side.",
            ko: "접합면의 인장강도는 모든 한계값에서 제외하였다(안전측).",
        },
        KineticLess { slides_at: Quantity } => {
            en: "Sliding is found with the static friction; a joint that moves once has the kinetic one, and with that in every joint sliding begins at {slides_at}.",
            ko: "미끄러짐은 정지마찰로 구하였다. 한번 움직인 접합면에는 운동마찰이 작용하며, 모든 접합면에 운동마찰을 적용하면 {slides_at}에서 미끄러진다.",
        },
        WithoutDilatancy { dilating: Quantity, without: Quantity } => {
            en: "Joints slide as it begins to move. Friction that lets them rise would hold {dilating}, which is an upper bound; joints may slide without rising from {without} on, and that counts.",
            ko: "움직이기 시작할 때 미끄러지는 접합면이 있다. 미끄러지며 벌어지는 것으로 보는 마찰(연합 흐름)로는 {dilating}(상한값)이나, 벌어지지 않고 미끄러지면 {without}부터 움직일 수 있으므로 이 값으로 판정한다.",
        },
        UpperBound => {
            en: "The acceleration is an upper bound: joints slide while others open, and the limit analysis lets sliding joints rise, which real ones do not.",
            ko: "이 가속도는 상한값이다. 다른 접합면이 벌어질 때 미끄러지는 접합면이 있는데, 한계해석은 미끄러지는 접합면이 들리는 것으로 가정하나 실제는 그렇지 않다.",
        },
        BondCarries => {
            en: "Held by bond: without the cohesion of its joints no forces balance the weight. A bond breaks brittle and one joint after the other, so the verdict is no better than marginal.",
            ko: "부착으로 지탱된다: 접합면의 점착력이 없으면 자중과 평형을 이루는 힘이 존재하지 않는다. 부착은 취성으로 하나씩 파괴되므로 판정은 '여유 부족'을 넘지 않는다.",
        },
        GapClosed { widest: Sentence, joints: usize } => {
            en: "Taken as closed: {widest}, the widest gap (joints drawn with one: {joints}), for a stone would float without them. Mortar or shims must fill them.",
            ko: "닫힌 것으로 보았다: {widest}(간격을 두고 입력한 접합면 {joints}개 중 가장 넓은 것). 그렇지 않으면 부재가 떠 있게 된다. 모르타르나 쐐기로 채워져 있어야 한다.",
        },
        GapFalls { widest: Sentence, joints: usize } => {
            en: "Taken as closed: {widest}, the widest gap (joints drawn with one: {joints}). With them open it does not stand, so the verdict is no better than marginal: see whether they are filled.",
            ko: "닫힌 것으로 보았다: {widest}(간격을 두고 입력한 접합면 {joints}개 중 가장 넓은 것). 벌어진 것으로 보면 서 있지 못하므로 판정은 '여유 부족'을 넘지 않는다. 채워져 있는지 확인한다.",
        },
        GapOpen { widest: Sentence, joints: usize, closed: Sentence } => {
            en: "Left open: {widest}, the widest gap (joints drawn with one: {joints}). Closed they would let it begin to move at {closed}. If they are filled, draw the stones touching.",
            ko: "벌어진 것으로 보았다: {widest}(간격을 두고 입력한 접합면 {joints}개 중 가장 넓은 것). 닫혀 있으면 {closed}에서 움직이기 시작한다. 채워져 있으면 부재를 맞닿게 입력한다.",
        },
        Gap { lower: Sentence, upper: String, width: Quantity } => {
            en: "{lower} – {upper}, {width} apart",
            ko: "{lower} – {upper}, 간격 {width}",
        },
        SliversLeftOut { lower: Sentence, upper: String, width: Quantity, contacts: usize } => {
            en: "Contacts that carry nothing, because they are narrower than a drawing is accurate: {contacts}; the widest is {lower} – {upper}, {width} wide. Where stones do lie on each other, measure the bed and draw it.",
            ko: "폭이 도면의 정확도보다 좁아 힘을 전달하지 않는 것으로 본 접촉: {contacts}곳. 가장 넓은 것은 {lower} – {upper}, 폭 {width}. 실제로 걸쳐 있으면 폭을 측정하여 입력한다.",
        },
        SliversCarry { lower: Sentence, upper: String, width: Quantity, contacts: usize } => {
            en: "“{upper}” does not stand without a contact {width} wide ({lower} – {upper}), and that is narrower than a drawing is accurate (such contacts: {contacts}). The verdict is no better than marginal: measure the bed.",
            ko: "‘{upper}’은(는) 폭 {width}의 접촉({lower} – {upper})이 없으면 서 있지 못하며, 이 폭은 도면의 정확도보다 좁다(이런 접촉 {contacts}곳). 판정은 '여유 부족'을 넘지 않는다. 접합면의 폭을 측정한다.",
        },
        OnlyCorners { lower: Sentence, upper: String, off: Quantity, change: Quantity } => {
            en: "The mesh shows only the corners of the bed of '{upper}' on {lower}, so its exactness cannot be seen: if they are {off} off, the acceleration at which it begins to move is up to {change} smaller or larger. Scan this bed more closely, or measure it.",
            ko: "{lower} 위 '{upper}'의 접합면은 메시에 모서리의 꼭짓점만 있어 그 정확도를 알 수 없다. 꼭짓점이 {off} 어긋나면 거동 시작 가속도가 {change}까지 작거나 크다. 이 접합면을 더 촘촘히 스캔하거나 실측한다.",
        },
        KineticShared { moves_at: Quantity } => {
            en: "With the kinetic friction in every joint, which a joint that moves once has, it begins to move at {moves_at}.",
            ko: "한번 움직인 접합면에는 운동마찰이 작용한다. 모든 접합면에 운동마찰을 적용하면 {moves_at}에서 움직이기 시작한다.",
        },
        KineticFalls => {
            en: "With the kinetic friction in every joint, which a joint that moves once has, it does not stand: no forces balance the weight. The verdict is no better than marginal.",
            ko: "한번 움직인 접합면에는 운동마찰이 작용한다. 모든 접합면에 운동마찰을 적용하면 자중과 평형을 이루는 힘이 없어 서 있지 못하므로 판정은 '여유 부족'을 넘지 않는다.",
        },
        NoTies => {
            en: "Ties are left out of the capacity, which is on the safe side; thresholds with ties at their strength stand in the table of the joints.",
            ko: "연결재는 거동 시작 가속도에 포함하지 않았으며(안전측), 강도까지 작용할 때의 값은 접합면별 한계 표에 있다.",
        },
        NoPeriod => {
            en: "The first period is not known, so what elastic joints add to the shaking is not in the comparison.",
            ko: "1차 주기를 알 수 없어 탄성 접합면에 의한 증폭은 비교에 포함되지 않는다.",
        },
    }
}

/// Whether a stack resists less without its static loads; without a limit it does not stand.
pub(super) fn is_less(without_g: Option<f64>, with_g: Option<f64>) -> bool {
    match (without_g, with_g) {
        (Some(without), Some(with)) => without < with * (1.0 - LESS),
        (None, with) => with.is_some(),
        (Some(_), None) => false,
    }
}

/// Smallest reduction for which the answer gives both values; the error of the solver is 1e-8.
const LESS: f64 = 1e-3;

/// The lower body of a joint.
fn below(name: &str) -> Sentence {
    match name {
        "ground" => place("the ground"),
        name => place(name),
    }
}

fn millimetres(width_m: f64) -> Quantity {
    Quantity::new(width_m, milli("m"), Digits::Significant(2))
}

/// The joint with the widest gap.
pub(crate) fn widest(lower: &str, upper: String, gap_m: f64) -> Sentence {
    Notes::Gap {
        lower: below(lower),
        upper,
        width: Quantity::new(gap_m, Unit::si("m"), Digits::Fixed(4)),
    }
    .into()
}

fn loads_hold(without_g: Option<f64>, with_g: Option<f64>) -> Notes {
    match (without_g, with_g) {
        (Some(without), Some(with)) => Notes::LoadsHold {
            with: in_g(with),
            without: in_g(without),
        },
        _ => Notes::LoadsHoldUp,
    }
}

fn gaps_noted(widest: Sentence, joints: usize, gaps: &Gaps) -> Notes {
    match gaps {
        Gaps::Closed => Notes::GapClosed { widest, joints },
        Gaps::FallsOpen => Notes::GapFalls { widest, joints },
        Gaps::Open { closed_g } => Notes::GapOpen {
            widest,
            joints,
            closed: closed_g.map_or_else(|| Sentence::of_symbol("–"), |at| value(in_g(at))),
        },
    }
}

fn lower(joints_g: Option<f64>, analysis_g: f64) -> Notes {
    let analysis = in_g(analysis_g);
    match joints_g.map(in_g) {
        Some(joints) => Notes::Lower { analysis, joints },
        None => Notes::LowerAlone { analysis },
    }
}

/// A note of the check.
pub(super) fn note(of: &StackNote, stack: &Stack) -> Sentence {
    let said = match of {
        StackNote::SharedLoad => Notes::SharedLoad,
        StackNote::AnalysisLower { joints_g, analysis_g } => lower(*joints_g, *analysis_g),
        StackNote::AnalysisBetween {
            at_least_g,
            analysis_g,
        } => Notes::Between {
            at_least: in_g(*at_least_g),
            analysis: in_g(*analysis_g),
        },
        StackNote::LoadsWithoutMass { with_g, without_g } if is_less(*without_g, *with_g) => {
            loads_hold(*without_g, *with_g)
        }
        StackNote::LoadsWithoutMass { .. } => Notes::LoadsWithoutMass,
        StackNote::AnalysisFalls => Notes::Falls,
        StackNote::FrictionCarries => Notes::FrictionCarries,
        StackNote::FrictionStood => Notes::FrictionStood,
        StackNote::FrictionFell { block } => Notes::FrictionFell {
            stone: stack.name(Body::Block(*block)).to_owned(),
        },
        StackNote::FrictionNoRest => Notes::FrictionNoRest,
        StackNote::FrictionNotRun { stones, most } => Notes::FrictionNotRun {
            stones: *stones,
            most: *most,
        },
        StackNote::StrengthFromInside => Notes::StrengthInside,
        StackNote::SideSupportsLeftOut => Notes::NoSideSupports,
        StackNote::CohesionCounted => Notes::Cohesion,
        StackNote::TensionLeftOut => Notes::NoTension,
        StackNote::KineticLess { slides_at_g } => Notes::KineticLess {
            slides_at: in_g(*slides_at_g),
        },
        StackNote::WithoutDilatancy {
            dilating_g,
            without_g,
        } => Notes::WithoutDilatancy {
            dilating: in_g(*dilating_g),
            without: in_g(*without_g),
        },
        StackNote::UpperBound => Notes::UpperBound,
        StackNote::BondCarries => Notes::BondCarries,
        StackNote::KineticShared { moves_at_g } => Notes::KineticShared {
            moves_at: in_g(*moves_at_g),
        },
        StackNote::KineticFalls => Notes::KineticFalls,
        StackNote::Gaps {
            lower,
            upper,
            gap_m,
            joints,
            gaps,
        } => {
            let upper = stack.name(Body::Block(*upper)).to_owned();
            gaps_noted(widest(stack.name(*lower), upper, *gap_m), *joints, gaps)
        }
        StackNote::SliversLeftOut {
            lower,
            upper,
            width_m,
            contacts,
        } => Notes::SliversLeftOut {
            lower: below(stack.name(*lower)),
            upper: stack.name(Body::Block(*upper)).to_owned(),
            width: millimetres(*width_m),
            contacts: *contacts,
        },
        StackNote::SliversCarry {
            lower,
            upper,
            width_m,
            contacts,
        } => Notes::SliversCarry {
            lower: below(stack.name(*lower)),
            upper: stack.name(Body::Block(*upper)).to_owned(),
            width: millimetres(*width_m),
            contacts: *contacts,
        },
        StackNote::OnlyCorners {
            lower,
            upper,
            off_m,
            change,
        } => Notes::OnlyCorners {
            lower: below(stack.name(*lower)),
            upper: stack.name(Body::Block(*upper)).to_owned(),
            off: millimetres(*off_m),
            change: Quantity::percent(*change, 2),
        },
        StackNote::TiesLeftOut => Notes::NoTies,
        StackNote::PeriodUnknown => Notes::NoPeriod,
    };
    said.into()
}
