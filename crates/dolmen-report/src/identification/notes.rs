//! Notes on a stiffness from vibration.

use super::left_out::left_out;
use super::words::{
    Words, counted, misfit_words, model_word, modes_words, numbered, of_each, proportion_words, spring_word,
    starts_words, stiffness_word,
};
use crate::figures::letter;
use dolmen::structure::{Spring, StiffnessNote, Thoroughness};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Notes on stiffness from vibration.
    pub(crate) enum Notes in "identification.notes" {
        RatioBelowLeast { ratio: Quantity, sum: Quantity, sum_least: Quantity, ratio_least: Quantity } => {
            en: "No stiffness gives these two frequencies: their ratio r = f2/f1 is {ratio}, so r + 1/r is {sum}, but two storeys on springs between them need r + 1/r ≥ 2√(1 + m2/m1) = {sum_least}, a ratio of {ratio_least} at least. Check the masses, and whether both modes move in this direction without twisting.",
            ko: "이 두 고유진동수를 갖는 강성은 없다. 진동수비 r = f2/f1은 {ratio}, r + 1/r은 {sum}이나, 층간 스프링으로 된 2층 골조에서는 r + 1/r ≥ 2√(1 + m2/m1) = {sum_least}, 즉 비가 {ratio_least} 이상이어야 한다. 질량과, 두 모드가 모두 비틀림 없이 이 방향으로 움직이는지 확인해야 한다.",
        },
        DifferenceBelowLeast { difference: Quantity, least: Quantity } => {
            en: "No stiffness gives these two frequencies: ω2² − ω1² is {difference}, but two storeys on grounded springs whose P-delta joins them need 2 (N2/l2)/√(m1 m2) = {least} at least.",
            ko: "이 두 고유진동수를 갖는 강성은 없다. ω2² − ω1²은 {difference}이나, P-델타로 연성된 지반 기준 스프링의 2층 골조에서는 2 (N2/l2)/√(m1 m2) = {least} 이상이어야 한다.",
        },
        NoneRealOne(solutions: usize) => {
            en: "No stiffness gives this frequency: none of the solutions in complex numbers ({solutions}) is real and positive. Check the masses, and whether the mode moves in this direction without twisting.",
            ko: "이 고유진동수를 갖는 강성은 없다. 복소수 해 {solutions}개 가운데 양의 실수 해가 없다. 질량과, 모드가 비틀림 없이 이 방향으로 움직이는지 확인해야 한다.",
        },
        NoneReal { frequencies: usize, solutions: usize } => {
            en: "No stiffness gives these {frequencies} frequencies: none of the solutions in complex numbers ({solutions}) is real and positive. Check the masses, and whether every mode moves in this direction without twisting.",
            ko: "고유진동수 {frequencies}개를 갖는 강성은 없다. 복소수 해 {solutions}개 가운데 양의 실수 해가 없다. 질량과, 모든 모드가 비틀림 없이 이 방향으로 움직이는지 확인해야 한다.",
        },
        NotAllSeparated { separated: usize, expected: usize } => {
            en: "Only {separated} of {expected} solutions in complex numbers were separated: some nearly coincide. A real one may be missing beside those given.",
            ko: "복소수 해 {expected}개 중 {separated}개만 분리되었다. 일부가 거의 겹쳐 있어, 제시된 해 외에 실수 해가 누락되었을 수 있다.",
        },
        NoneExplains { stiffness: Sentence, starts: Sentence, modes: Sentence, misfit: Sentence } => {
            en: "No {stiffness} was found, from {starts}, that explains the data ({modes}): the nearest is off by {misfit}. Check that no mode of the direction is left out from the lowest up, the masses, and of each sensor the sign, the place and the unit.",
            ko: "{starts}에서 탐색하였으나 자료({modes})를 설명하는 {stiffness}은(는) 찾지 못하였다. 가장 가까운 해의 오차는 {misfit}이다. 모드가 한 방향의 최저차부터 빠짐없이 주어졌는지, 질량, 각 센서의 부호·위치·단위를 확인해야 한다.",
        },
        NoneStands { stiffness: Sentence, model: Sentence } => {
            en: "No {stiffness} was found at which the {model} stands.",
            ko: "{model}이(가) 안정한 {stiffness}을(를) 찾지 못하였다.",
        },
        FitLeavesFree(stiffness: Sentence) => {
            en: "The best fit leaves some {stiffness} free: beyond some value, more of it changes no datum. The set shown is one of many that fit as well.",
            ko: "최적해에서 일부 {stiffness}이(가) 정해지지 않는다. 어느 값 이상에서는 강성이 커져도 자료가 변하지 않는다. 제시된 해는 똑같이 잘 맞는 여러 해 중 하나이다.",
        },
        TooFewData { frequencies: Sentence, independent: Sentence, stiffness: Sentence, springs: usize, proportion: Sentence } => {
            en: "{frequencies} {independent}, and {springs} values of {stiffness} are sought: they cannot be determined. The set shown fits the data and is the nearest to stiffness in proportion to {proportion}, an assumption and not a measurement. Measure more modes, or shapes at several heights.",
            ko: "{frequencies} {independent}인데 {stiffness}은(는) {springs}개이므로 정할 수 없다. 제시된 해는 자료에 맞는 해 중 {proportion}에 비례하는 강성에 가장 가까운 것으로, 가정이며 계측 결과가 아니다. 더 많은 모드 또는 여러 높이의 모드형상을 계측해야 한다.",
        },
        SeveralExplain { sets: usize, stiffness: Sentence, how: Sentence, advice: Sentence } => {
            en: "{sets} sets of {stiffness} explain the data equally well and all stand ({how}). {advice}",
            ko: "{stiffness} 조합 {sets}개가 자료를 똑같이 잘 설명하며 모두 안정하다({how}). {advice}",
        },
        Followed(solutions: usize) => {
            en: "all {solutions} solutions in complex numbers were followed, so for exactly these frequencies there is no other",
            ko: "복소수 해 {solutions}개를 모두 추적하였으므로 정확히 이 고유진동수에 대해서는 다른 해가 없다",
        },
        Searched(starts: Sentence) => {
            en: "found from {starts}; there may be more",
            ko: "{starts}에서 찾았으며 다른 해가 더 있을 수 있다",
        },
        MoreShapes => {
            en: "These data cannot tell them apart: measure the shapes at more heights or in more modes.",
            ko: "이 자료로는 구별할 수 없으므로 더 많은 높이 또는 더 많은 모드의 형상을 계측해야 한다.",
        },
        AnyShapes(spring: Sentence) => {
            en: "Frequencies alone cannot tell them apart: measure the shapes too, best with a sensor near each {spring}.",
            ko: "고유진동수만으로는 구별할 수 없으므로 모드형상도 계측해야 하며, 센서는 각 {spring} 가까이에 두는 것이 가장 좋다.",
        },
        OneWithoutProof { stiffness: Sentence, starts: Sentence } => {
            en: "Only one set of {stiffness} was found from {starts}, but frequencies alone often have several: this is no proof.",
            ko: "{starts}에서 {stiffness} 조합을 하나만 찾았으나, 고유진동수만으로는 해가 여럿인 경우가 많으므로 유일하다는 증명은 아니다.",
        },
        OddCount(stiffness: Sentence) => {
            en: "Their number is odd, but as many frequencies as values of {stiffness} have an even number of solutions: at least one more exists and was not found. Raise starts.",
            ko: "해의 수가 홀수이나, {stiffness}와(과) 같은 수의 고유진동수가 주어지면 해의 수는 짝수이므로 찾지 못한 해가 적어도 하나 더 있다. 시작점 수(starts)를 늘려야 한다.",
        },
        ListCut { found: usize, listed: usize } => {
            en: "Solutions found: {found}; listed, from the first: {listed}.",
            ko: "해 {found}개를 찾았으며 처음 {listed}개만 제시한다.",
        },
        OneShapePoint(mode: usize) => {
            en: "Mode {mode} has one shape point: its scale is free, so it says nothing and is left out.",
            ko: "모드 {mode}의 형상은 측점이 하나뿐이다. 크기 기준이 임의이므로 정보가 없어 제외하였다.",
        },
        DeviationsAssumed { frequency: Quantity, shape: Quantity } => {
            en: "Data without a standard deviation were given {frequency} of a frequency and {shape} of the largest displacement of a mode, an assumption.",
            ko: "표준편차가 없는 자료에는 고유진동수의 {frequency}, 모드별 최대 변위의 {shape}을(를) 표준편차로 가정하였다.",
        },
        NoInterval(misfit: Sentence) => {
            en: "The best set is off by {misfit}; without standard deviations of the modes no interval can be given.",
            ko: "최적해의 오차는 {misfit}이다. 모드의 표준편차가 없으므로 강성의 구간은 제시할 수 없다.",
        },
        FreeDirection(components: Vec<Sentence>) => {
            en: "Free: changes of ln k in the proportions {components} leave all data unchanged (to first order).",
            ko: "자료로 정해지지 않는 강성 조합: 각 강성의 로그를 다음 비율로 함께 바꾸어도 모든 자료가 (1차 근사로) 변하지 않는다: {components}.",
        },
        WideIntervals(deviations: Vec<Sentence>) => {
            en: "The data determine some stiffnesses only to an order of magnitude (standard deviation of {deviations}).",
            ko: "일부 강성은 자릿수 정도만 정해진다(표준편차: {deviations}).",
        },
        Unseen(springs: Vec<Sentence>) => {
            en: "The sensors hardly see the stiffness of {springs}: the data would barely change with it.",
            ko: "센서로 거의 파악되지 않는 강성: {springs}. 이 강성이 변해도 자료는 거의 변하지 않는다.",
        },
        SolutionsMeet(stiffness: Sentence) => {
            en: "Next to a double root: two sets of {stiffness} meet here, or so nearly that the scatter of the frequencies moves one into the other. No linear interval exists. Measure a shape.",
            ko: "중근 부근이다. {stiffness} 조합 두 개가 여기서 만나거나 고유진동수의 산포만으로 서로 바뀔 만큼 가까우므로 선형 구간은 존재하지 않는다. 모드형상을 계측해야 한다.",
        },
        ShapeOff { mode: usize, difference: Quantity } => {
            en: "The shape of mode {mode}, given without standard deviations, is off by up to {difference} of its largest displacement.",
            ko: "표준편차 없이 주어진 {mode}차 모드형상의 오차는 최대 변위의 {difference}까지 이른다.",
        },
        RangeIncomplete(solutions: Vec<Sentence>) => {
            en: "The range of {solutions} is incomplete: not everywhere within that range do these frequencies have a solution.",
            ko: "해 {solutions}의 범위는 완전하지 않다. 그 범위 안의 일부 고유진동수에서는 해가 없다.",
        },
        ThinRods => {
            en: "Moments of inertia that were not given are those of thin rods, which are low: stiffness comes out low too.",
            ko: "주어지지 않은 관성모멘트는 가는 봉의 값으로 보았다. 이는 작은 값이므로 강성도 작게 추정된다.",
        },
        SideSupportTaken => {
            en: "Side supports without a gap are part of the model, their stiffness taken as given.",
            ko: "측면 지지는 모델에 포함되며, 그 강성은 주어진 값으로 보았다.",
        },
        SideSupportWithGap => {
            en: "Side supports with a gap are left out: the chain is taken not to touch them while it vibrates.",
            ko: "측면 지지는 유격이 있어 제외하였다. 진동하는 동안 지지에 닿지 않는 것으로 본다.",
        },
        NoAxialForce => {
            en: "No axial force is given: P-delta is left out, so stiffness comes out low.",
            ko: "축력이 주어지지 않아 P-델타 효과를 고려하지 않았으므로 강성이 작게 추정된다.",
        },
        TiesTaken => {
            en: "The ties are part of the model, their stiffness taken as given.",
            ko: "연결재는 모델에 포함되며, 그 강성은 주어진 값으로 보았다.",
        },
        Twists(frequency: Quantity) => {
            en: "The mode at {frequency} twists in plan and is kept out of the fit.",
            ko: "{frequency} 모드는 평면 비틀림 모드이므로 강성 추정에서 제외하였다.",
        },
        OneTakenAsLowest(direction: String) => {
            en: "The one mode used is taken as the lowest of direction {direction}: if one below it was missed, every stiffness is wrong.",
            ko: "사용한 모드 1개를 {direction} 방향의 최저차 모드로 보았다. 그 아래에 누락된 모드가 있으면 모든 강성이 틀리게 된다.",
        },
        TakenAsLowest { modes: usize, direction: String } => {
            en: "The {modes} modes used are taken as the lowest of direction {direction}, none missed between them: if one was, every stiffness is wrong.",
            ko: "사용한 모드 {modes}개를 {direction} 방향의 최저차부터 빠짐없이 찾은 것으로 보았다. 누락된 모드가 있으면 모든 강성이 틀리게 된다.",
        },
    }
}

/// The sentence of a note.
pub(super) fn stiffness_note(note: &StiffnessNote) -> Sentence {
    match note {
        StiffnessNote::RatioBelowLeast { ratio, ratio_least } => Notes::RatioBelowLeast {
            ratio: four(*ratio),
            sum: four(ratio + 1.0 / ratio),
            sum_least: four(ratio_least + 1.0 / ratio_least),
            ratio_least: four(*ratio_least),
        },
        StiffnessNote::DifferenceBelowLeast {
            difference_rad2_s2,
            difference_least_rad2_s2,
        } => Notes::DifferenceBelowLeast {
            difference: squared(*difference_rad2_s2),
            least: squared(*difference_least_rad2_s2),
        },
        StiffnessNote::NoneReal {
            frequencies,
            solutions_complex,
        } => match frequencies {
            1 => Notes::NoneRealOne(*solutions_complex),
            _ => Notes::NoneReal {
                frequencies: *frequencies,
                solutions: *solutions_complex,
            },
        },
        StiffnessNote::NotAllSeparated { separated, expected } => Notes::NotAllSeparated {
            separated: *separated,
            expected: *expected,
        },
        StiffnessNote::NoneExplains {
            spring,
            starts,
            modes,
            misfit,
        } => Notes::NoneExplains {
            stiffness: stiffness_word(*spring),
            starts: starts_words(*starts),
            modes: modes_words(*modes),
            misfit: misfit_words(*misfit),
        },
        StiffnessNote::NoneStands { spring } => Notes::NoneStands {
            stiffness: stiffness_word(*spring),
            model: model_word(*spring),
        },
        StiffnessNote::FitLeavesFree { spring } => Notes::FitLeavesFree(stiffness_word(*spring)),
        StiffnessNote::TooFewData {
            spring,
            springs,
            frequencies,
            with_shapes,
            independent,
            proportion,
        } => Notes::TooFewData {
            frequencies: given(*frequencies, *with_shapes),
            independent: counted(*independent, Words::OneDatum, Words::Data(*independent)),
            stiffness: stiffness_word(*spring),
            springs: *springs,
            proportion: proportion_words(*proportion),
        },
        StiffnessNote::SeveralExplain {
            spring,
            sets,
            thoroughness,
            with_shapes,
        } => Notes::SeveralExplain {
            sets: *sets,
            stiffness: stiffness_word(*spring),
            how: how_words(*thoroughness),
            advice: advice(*spring, *with_shapes),
        },
        StiffnessNote::OneWithoutProof { spring, starts } => Notes::OneWithoutProof {
            stiffness: stiffness_word(*spring),
            starts: starts_words(*starts),
        },
        StiffnessNote::OddCount { spring } => Notes::OddCount(stiffness_word(*spring)),
        StiffnessNote::ListCut { found, listed } => Notes::ListCut {
            found: *found,
            listed: *listed,
        },
        StiffnessNote::OneShapePoint { mode } => Notes::OneShapePoint(*mode),
        StiffnessNote::DeviationsAssumed { frequency, shape } => Notes::DeviationsAssumed {
            frequency: percent(*frequency, Digits::Trimmed(3)),
            shape: percent(*shape, Digits::Trimmed(3)),
        },
        StiffnessNote::NoInterval { misfit } => Notes::NoInterval(misfit_words(*misfit)),
        StiffnessNote::FreeDirection { spring, components } => {
            Notes::FreeDirection(of_each(*spring, components, &Unit::ratio(), Digits::Fixed(2)))
        }
        StiffnessNote::WideIntervals { spring, relative_sd } => {
            Notes::WideIntervals(of_each(*spring, relative_sd, &Unit::percent(), Digits::Fixed(0)))
        }
        StiffnessNote::Unseen { spring, numbers } => {
            Notes::Unseen(numbers.iter().map(|n| numbered(*spring, *n)).collect())
        }
        StiffnessNote::SolutionsMeet { spring } => Notes::SolutionsMeet(stiffness_word(*spring)),
        StiffnessNote::ShapeOff { mode, difference } => Notes::ShapeOff {
            mode: *mode,
            difference: percent(*difference, Digits::Fixed(1)),
        },
        StiffnessNote::RangeIncomplete { solutions } => Notes::RangeIncomplete(
            solutions
                .iter()
                .map(|n| Sentence::of_symbol(&letter(n.saturating_sub(1))))
                .collect(),
        ),
        StiffnessNote::ThinRods => Notes::ThinRods,
        StiffnessNote::SideSupportTaken => Notes::SideSupportTaken,
        StiffnessNote::SideSupportWithGap => Notes::SideSupportWithGap,
        StiffnessNote::NoAxialForce => Notes::NoAxialForce,
        StiffnessNote::TiesTaken => Notes::TiesTaken,
        StiffnessNote::LeftOut(why) => return left_out(why),
        StiffnessNote::Twists { frequency_hz } => {
            Notes::Twists(Quantity::new(*frequency_hz, Unit::si("Hz"), Digits::Trimmed(5)))
        }
        StiffnessNote::TakenAsLowest { modes: 1, direction } => Notes::OneTakenAsLowest(direction.clone()),
        StiffnessNote::TakenAsLowest { modes, direction } => Notes::TakenAsLowest {
            modes: *modes,
            direction: direction.clone(),
        },
    }
    .into()
}

fn four(value: f64) -> Quantity {
    Quantity::new(value, Unit::ratio(), Digits::Fixed(4))
}

fn squared(value: f64) -> Quantity {
    Quantity::new(value, Unit::si("(rad/s)²"), Digits::Fixed(4))
}

fn percent(share: f64, digits: Digits) -> Quantity {
    Quantity::new(share, Unit::percent(), digits)
}

fn given(count: usize, with_shapes: bool) -> Sentence {
    match with_shapes {
        true => counted(
            count,
            Words::OneFrequencyWithShapes,
            Words::FrequenciesWithShapes(count),
        ),
        false => counted(count, Words::OneFrequency, Words::Frequencies(count)),
    }
}

fn how_words(thoroughness: Thoroughness) -> Sentence {
    match thoroughness {
        Thoroughness::All { solutions_complex } => Notes::Followed(solutions_complex),
        Thoroughness::Searched { starts } => Notes::Searched(starts_words(starts)),
    }
    .into()
}

fn advice(spring: Spring, with_shapes: bool) -> Sentence {
    match with_shapes {
        true => Notes::MoreShapes,
        false => Notes::AnyShapes(spring_word(spring)),
    }
    .into()
}
