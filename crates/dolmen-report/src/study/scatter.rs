//! Contributions to β, and crossing curves.

use super::words::{CONFIDENCE, fixed, g, of_case, state};
use crate::document::{Block, Document};
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::study::{CombinationFragility, CrossingSide, StateFragility, StudyAnswer};

/// Number of samples that is advised. Our choice: their standard deviation is then known to a factor of 1.5 (95 %).
const SAMPLES_ADVISED: usize = 20;

messages! {
    /// Scatter and crossings.
    pub(crate) enum Scatter in "study.scatter" {
        Split { state: Sentence, motions: Quantity, inputs: Quantity, lower: Quantity, upper: Quantity } => {
            en: "β of {state}: {motions} from motion to motion, {inputs} ({lower} to {upper}) from what is not known of the structure.",
            ko: "{state}의 β: 입력지진에 의한 값 {motions}, 구조물의 불확실성에 의한 값 {inputs}({lower}–{upper}).",
        },
        Without { without: usize, samples: usize } => {
            en: "{without} of {samples} samples have no curve.",
            ko: "표본 {samples}개 중 {without}개는 곡선이 없다.",
        },
        OneSample => {
            en: "ONE DRAW OF THE INPUTS STANDS FOR THE STRUCTURE: medians, β, rates and their intervals are of that draw alone, and another may lie far from it. Set samples to 20 or more.",
            ko: "입력값을 한 번만 추출한 구조물의 결과: 중앙값, β, 초과율과 그 구간은 이 표본 하나의 것이며 다른 표본은 크게 다를 수 있다. samples를 20 이상으로 한다.",
        },
        SamplesNotIn { state: Sentence, samples: usize } => {
            en: "{state}: the intervals are of the choice of motions alone. What {samples} samples of the structure leave open is not in them, as β cannot be split: take the medians as less certain, and set samples to 20 or more.",
            ko: "{state}: 구간은 입력지진의 선택만 반영한다. β를 나눌 수 없어 표본 {samples}개로 인한 불확실성은 포함하지 않으므로 중앙값의 신뢰도는 더 낮다. samples를 20 이상으로 한다.",
        },
        NotSplitOf { state: Sentence, samples: usize } => {
            en: "{state}: the intervals are of the choice of motions alone. What {samples} samples of the structure leave open is not in them, as β cannot be split: take the medians as less certain, and scan from smaller to larger sizes in finer steps, so that each sample has a curve of its own.",
            ko: "{state}: 구간은 입력지진의 선택만 반영한다. β를 나눌 수 없어 표본 {samples}개로 인한 불확실성은 포함하지 않으므로 중앙값의 신뢰도는 더 낮다. 표본마다 곡선을 구할 수 있도록 더 작은 크기부터 더 큰 크기까지 더 촘촘한 간격으로 해석한다.",
        },
        MoreSamples { state: Sentence, samples: usize, lower: Quantity, upper: Quantity } => {
            en: "{state}: {samples} samples of the structure leave its median at {lower} to {upper} (95 %), and more motions do not help: draw more samples.",
            ko: "{state}: 구조물 표본 {samples}개로는 중앙값이 {lower}–{upper}(95 %)까지만 정해지며 입력지진을 늘려도 나아지지 않는다. samples를 늘린다.",
        },
        FewSamples { state: Sentence, samples: usize, lower: Quantity, upper: Quantity } => {
            en: "{state}: {samples} samples of the structure leave its median at {lower} to {upper} (95 %), and more motions do not help: set samples to 20 or more.",
            ko: "{state}: 구조물 표본 {samples}개로는 중앙값이 {lower}–{upper}(95 %)까지만 정해지며 입력지진을 늘려도 나아지지 않는다. samples를 20 이상으로 한다.",
        },
        NotSplit => {
            en: "Where β is not split: fewer than three samples have a curve of their own, more than a tenth of them have none, or both parts together lie outside the interval of β.",
            ko: "β를 나누지 못한 경우는 곡선이 있는 표본이 3개 미만이거나 표본의 10분의 1 넘게 곡선이 없거나 두 값을 합한 것이 β의 신뢰구간을 벗어난 경우이다.",
        },
        CrossBelow { mild: Sentence, severe: Sentence, at: Quantity, probability: Quantity } => {
            en: "The curves of {mild} and {severe} cross at {at}, where both have {probability}: below it the worse state is called likelier than the milder one, which cannot be.",
            ko: "{mild}와(과) {severe}의 곡선이 {at}(확률 {probability})에서 교차한다. 그보다 작은 지반운동에서는 심한 상태의 확률이 더 크게 나타나므로 사용할 수 없다.",
        },
        CrossAbove { mild: Sentence, severe: Sentence, at: Quantity, probability: Quantity } => {
            en: "The curves of {mild} and {severe} cross at {at}, where both have {probability}: above it the worse state is called likelier than the milder one, which cannot be.",
            ko: "{mild}와(과) {severe}의 곡선이 {at}(확률 {probability})에서 교차한다. 그보다 큰 지반운동에서는 심한 상태의 확률이 더 크게 나타나므로 사용할 수 없다.",
        },
    }
}

/// β split if inputs are random, and a warning for each crossing.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer, shown: &[CombinationFragility]) {
    let mut points = Vec::new();
    for one in shown {
        for own in &one.states {
            points.extend(split(answer, one, own));
        }
    }
    if !points.is_empty() {
        document.put(Block::List(points));
    }
    let is_open = |state: &StateFragility| state.scatter.is_none() && state.by_acceleration.is_ok();
    let drawn = answer.study.samples.is_some_and(|samples| samples > 1);
    if drawn && shown.iter().flat_map(|one| &one.states).any(is_open) {
        document.note(Scatter::NotSplit);
    }
    for crossing in crossings(answer, shown) {
        document.put(Block::Warning(crossing.into()));
    }
}

/// Samples too few for the structure: one alone, ones that are not in the intervals, or ones that determine the median less than the motions do.
pub(super) fn few_samples(answer: &StudyAnswer) -> Vec<Scatter> {
    let Some(samples) = answer.study.samples else {
        return Vec::new();
    };
    let has_curve = |own: &&StateFragility| own.by_acceleration.is_ok();
    let all = || {
        answer
            .fragilities()
            .iter()
            .flat_map(|one| one.states.iter().map(move |own| (one, own)))
    };
    if samples == 1 {
        let is_any = all().any(|(_, own)| has_curve(&own));
        return is_any.then_some(Scatter::OneSample).into_iter().collect();
    }
    let each = all().filter(|(_, own)| has_curve(own)).filter_map(|(one, own)| {
        let fit = own.by_acceleration.as_ref().ok()?;
        let state = of_case(answer, state(answer, own.state), one.job);
        let Some(of) = fit.of_samples else {
            return Some(match samples < SAMPLES_ADVISED {
                true => Scatter::SamplesNotIn { state, samples },
                false => Scatter::NotSplitOf { state, samples },
            });
        };
        let of_motions = fit.ln_theta_error_of_motions();
        let is_few = fit.ln_theta_error > 2f64.sqrt() * of_motions && own.motions_enough().is_none();
        let interval = fit.theta_interval(CONFIDENCE).ok().filter(|_| is_few)?;
        let (lower, upper) = (g(answer, interval.lower), g(answer, interval.upper));
        let with_curve = of.samples;
        Some(match samples < SAMPLES_ADVISED {
            true => Scatter::FewSamples {
                state,
                samples: with_curve,
                lower,
                upper,
            },
            false => Scatter::MoreSamples {
                state,
                samples: with_curve,
                lower,
                upper,
            },
        })
    });
    each.collect()
}

fn split(answer: &StudyAnswer, one: &CombinationFragility, own: &StateFragility) -> Vec<Sentence> {
    let Some(split) = &own.scatter else {
        return Vec::new();
    };
    let Ok(interval) = split.of_inputs_interval(CONFIDENCE) else {
        return Vec::new();
    };
    let said = Scatter::Split {
        state: of_case(answer, state(answer, own.state), one.job),
        motions: fixed(split.of_motions, 2),
        inputs: fixed(split.of_inputs, 2),
        lower: fixed(interval.lower, 2),
        upper: fixed(interval.upper, 2),
    };
    let without = (split.without_curve > 0).then_some(Scatter::Without {
        without: split.without_curve,
        samples: split.without_curve + split.samples,
    });
    std::iter::once(said).chain(without).map(Sentence::from).collect()
}

/// Pairs of curves that cross at relevant probabilities.
pub(super) fn crossings(answer: &StudyAnswer, shown: &[CombinationFragility]) -> Vec<Scatter> {
    let mut found = Vec::new();
    for one in shown {
        for of in one.crossings() {
            let mild = of_case(answer, state(answer, of.milder), one.job);
            let severe = state(answer, of.worse);
            let at = g(answer, of.at.intensity);
            let probability = fixed(of.at.probability, 2);
            found.push(match of.likelier_is_worse {
                CrossingSide::Below => Scatter::CrossBelow {
                    mild,
                    severe,
                    at,
                    probability,
                },
                CrossingSide::Above => Scatter::CrossAbove {
                    mild,
                    severe,
                    at,
                    probability,
                },
            });
        }
    }
    found
}
