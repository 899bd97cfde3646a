//! Findings on the worst storey and the worst joint compared with their limits.

use super::words::where_words;
use crate::document::{Finding, Tone};
use crate::simulated::{capitalised, kilo};
use dolmen::assess::demand::{DRIFT_RATIO_MOST, DriftLimit};
use dolmen::stability::stack::DemandVerdict;
use dolmen_words::{Digits, Quantity, Sentence, messages};
use dolmen_work::part_limit::{Limited, PartLimit, worst_part};

/// Digits of drifts, moments and ratios.
const DIGITS: usize = 3;

messages! {
    /// Parts against their limits.
    pub(crate) enum Found in "limits.findings" {
        Drift { part: Sentence, drift: Quantity, allowed: Quantity, ratio: Quantity } => {
            en: "{part} drifts {drift} of its height, and {allowed} is allowed: capacity over demand {ratio}.",
            ko: "{part}의 층간변위비는 {drift}, 허용값은 {allowed}이다(저항/요구 {ratio}).",
        },
        DriftBy { part: Sentence, drift: Quantity, allowed: Quantity, source: String, ratio: Quantity } => {
            en: "{part} drifts {drift} of its height, and {allowed} is allowed ({source}): capacity over demand {ratio}.",
            ko: "{part}의 층간변위비는 {drift}, 허용값은 {allowed}이다({source}, 저항/요구 {ratio}).",
        },
        DriftLeft { part: Sentence, drift: Quantity, allowed: Quantity, left: Quantity, taken: Quantity, ratio: Quantity } => {
            en: "{part} drifts {drift} of its height; of the {allowed} allowed its lean, along and across, takes {taken} and leaves {left}: capacity over demand {ratio}.",
            ko: "{part}의 층간변위비는 {drift}이다. 허용값 {allowed}에서 기울기(해당 방향과 직각 방향)의 몫 {taken}을(를) 뺀 값은 {left}이다(저항/요구 {ratio}).",
        },
        DriftLeftBy { part: Sentence, drift: Quantity, allowed: Quantity, source: String, left: Quantity, taken: Quantity, ratio: Quantity } => {
            en: "{part} drifts {drift} of its height; of the {allowed} allowed ({source}) its lean, along and across, takes {taken} and leaves {left}: capacity over demand {ratio}.",
            ko: "{part}의 층간변위비는 {drift}이다. 허용값 {allowed}({source})에서 기울기(해당 방향과 직각 방향)의 몫 {taken}을(를) 뺀 값은 {left}이다(저항/요구 {ratio}).",
        },
        DriftNoneLeft { part: Sentence, drift: Quantity, lean: Quantity, allowed: Quantity } => {
            en: "{part} drifts {drift} of its height; its lean of {lean} without shaking already uses up the {allowed} allowed: capacity over demand 0.",
            ko: "{part}의 층간변위비는 {drift}이며, 지진 전 기울기 {lean}만으로 이미 허용값 {allowed}에 이른다(저항/요구 0).",
        },
        DriftWithout { part: Sentence, drift: Quantity } => {
            en: "{part} drifts {drift} of its height; without an allowable drift nothing is decided.« Write [limits] with code and importance, or storey_drift.»",
            ko: "{part}의 층간변위비는 {drift}이나 허용 층간변위가 없어 판정하지 않는다.« [limits]에 code와 importance, 또는 storey_drift를 입력한다.»",
        },
        Falls { part: Sentence, drift: Quantity, most: Quantity } => {
            en: "{part} drifts {drift} of its height, beyond the {most} up to which small drifts can tell: it falls.",
            ko: "{part}의 층간변위비가 {drift}(으)로, 미소변형 모델의 범위 {most}을(를) 넘는다. 붕괴로 본다.",
        },
        BedEdge { part: Sentence, moment: Quantity, most: Quantity, ratio: Quantity } => {
            en: "{part} has a moment of {moment}, and its bed stands on its edge at {most}: capacity over demand {ratio}.",
            ko: "{part}의 모멘트는 {moment}, 접합면이 모서리로만 지지되는 모멘트는 {most}이다(저항/요구 {ratio}).",
        },
        BedEdgeLeft { part: Sentence, moment: Quantity, left: Quantity, taken: Quantity, ratio: Quantity } => {
            en: "{part} has a moment of {moment}; of what its bed passes, tilt and loads take {taken} and leave {left}: capacity over demand {ratio}.",
            ko: "{part}의 모멘트는 {moment}이다. 접합면의 전도 모멘트에서 기울기와 정하중의 몫 {taken}을(를) 뺀 값은 {left}이다(저항/요구 {ratio}).",
        },
        NoBed { part: Sentence, moment: Quantity } => {
            en: "{part} has a moment of {moment}; without «bed_width|bed width» nothing is decided.",
            ko: "{part}의 모멘트는 {moment}이나 «bed_width가|접합면 폭이» 없어 판정하지 않는다.",
        },
        Of { of: Sentence, said: Sentence } => { en: "{of}, {said}", ko: "{of}: {said}" },
    }
}

/// The worst storey and the worst joint, under the load that `of` names.
pub(crate) fn findings(
    parts: &[PartLimit],
    limit: Option<&DriftLimit>,
    of: Option<Sentence>,
) -> Vec<Finding> {
    let worst = [Limited::Drift, Limited::BedEdge].map(|limited| worst_part(parts, limited));
    let each = worst.into_iter().flatten().map(|part| {
        let said: Sentence = said(part, limit).into();
        let whole = match of.clone() {
            None => said,
            Some(of) => Found::Of { of, said }.into(),
        };
        Finding::key(tone(part), capitalised(whole))
    });
    each.collect()
}

fn tone(part: &PartLimit) -> Tone {
    match part.verdict() {
        DemandVerdict::Above => Tone::Good,
        DemandVerdict::Near => Tone::Warn,
        DemandVerdict::Below => Tone::Bad,
        DemandVerdict::Unknown => Tone::Unknown,
    }
}

fn said(of: &PartLimit, limit: Option<&DriftLimit>) -> Found {
    let part = where_words(of);
    let percent = |share: f64| Quantity::percent(share, DIGITS);
    let moment = |n_m: f64| Quantity::new(n_m, kilo("N·m"), Digits::Significant(DIGITS));
    let both = of.capacity.zip(of.ratio());
    match (of.limited, both) {
        _ if of.falls() => Found::Falls {
            part,
            drift: percent(of.whole_drift()),
            most: Quantity::percent(DRIFT_RATIO_MOST, 2),
        },
        (Limited::BedEdge, Some((left, ratio))) if of.taken > 0.0 => Found::BedEdgeLeft {
            part,
            moment: moment(of.demand),
            left: moment(left),
            taken: moment(of.taken),
            ratio: Quantity::beside_one(ratio, DIGITS),
        },
        (Limited::BedEdge, Some((most, ratio))) => Found::BedEdge {
            part,
            moment: moment(of.demand),
            most: moment(most),
            ratio: Quantity::beside_one(ratio, DIGITS),
        },
        (Limited::BedEdge, None) => Found::NoBed {
            part,
            moment: moment(of.demand),
        },
        (_, None) => Found::DriftWithout {
            part,
            drift: percent(of.demand),
        },
        (_, Some((left, _))) if of.taken > 0.0 && left <= 0.0 => {
            let [along, across] = of.lean;
            Found::DriftNoneLeft {
                part,
                drift: percent(of.demand),
                lean: percent(along.hypot(across)),
                allowed: percent(limit.map_or(of.taken, DriftLimit::ratio)),
            }
        }
        (_, Some((left, ratio))) if of.taken > 0.0 => {
            let drift = percent(of.demand);
            let allowed = percent(limit.map_or(left + of.taken, DriftLimit::ratio));
            let (left, taken) = (percent(left), percent(of.taken));
            let ratio = Quantity::beside_one(ratio, DIGITS);
            match limit.and_then(DriftLimit::source) {
                None => Found::DriftLeft {
                    part,
                    drift,
                    allowed,
                    left,
                    taken,
                    ratio,
                },
                Some(source) => Found::DriftLeftBy {
                    part,
                    drift,
                    allowed,
                    source,
                    left,
                    taken,
                    ratio,
                },
            }
        }
        (_, Some((allowed, ratio))) => {
            let (drift, allowed) = (percent(of.demand), percent(allowed));
            let ratio = Quantity::beside_one(ratio, DIGITS);
            match limit.and_then(DriftLimit::source) {
                None => Found::Drift {
                    part,
                    drift,
                    allowed,
                    ratio,
                },
                Some(source) => Found::DriftBy {
                    part,
                    drift,
                    allowed,
                    source,
                    ratio,
                },
            }
        }
    }
}
