//! Main findings of a study: capacity, doubts about it, trends, the worst state.

use super::words::{Words, g, state};
use super::{before, capacities, doubts, hazard, releases, run, scatter, tenons, trends, words};
use crate::document::{Finding, Tone};
use dolmen::assess::Reached;
use dolmen::numeric::clopper_pearson;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::study::{
    ALLOWED_DRIFT, AllowedDrift, CapacityOf, LevelRow, ScanVerdict, StudyAnswer, StudyKind, YEARS,
};
use std::collections::BTreeSet;

messages! {
    /// Findings on a study.
    pub(crate) enum Found in "study.findings" {
        OfVariant { variant: String } => {
            en: "All of this is of the variant: {variant}.",
            ko: "모두 대안의 결과이다: {variant}.",
        },
        OfSet { each: Vec<String> } => {
            en: "All of this is of values that the study sets in place of those of the file: {each}.",
            ko: "모두 study에서 파일의 값을 바꾼 결과이다: {each}.",
        },
        ByVariant { state: Sentence, each: Vec<Sentence> } => {
            en: "By variant, the weakest at which it reaches “{state}”: {each}.",
            ko: "대안별 ‘{state}’ 도달 최소 가속도: {each}.",
        },
        VariantAt { variant: String, least: Quantity } => { en: "{variant} {least}", ko: "{variant} {least}" },
        VariantAbove { variant: String, largest: Quantity } => {
            en: "{variant} not up to {largest}",
            ko: "{variant} {largest}까지 도달하지 않음",
        },
        Undamped => {
            en: "Computed with 0 % damping: neither a damping ratio nor friction is given, so that it swings more and longer than it would. «Give damping_ratio; stone|Stone» poles and timber frames have 1 to 5 %.",
            ko: "감쇠비 0 %로 해석하였다. 감쇠비와 마찰이 주어지지 않아 실제보다 크고 오래 흔들린다. «damping_ratio를 준다. »석조 당간과 목조 골조는 1~5 %이다.",
        },
        NoneFell { scans: Sentence, state: Sentence, largest: Quantity } => {
            en: "None of {scans} reached “{state}”, up to {largest}.",
            ko: "{scans} 모두 {largest}까지 ‘{state}’ 상태에 이르지 않았다.",
        },
        Fell { fell: usize, scans: Sentence, state: Sentence, least: Quantity } => {
            en: "{fell} of {scans} reached “{state}”, the weakest at {least}.",
            ko: "{scans} 중 {fell}건이 ‘{state}’ 상태에 이르렀으며, 그 최소 가속도는 {least}이다.",
        },
        FellBetween { fell: usize, scans: Sentence, state: Sentence, survived: Quantity, least: Quantity } => {
            en: "{fell} of {scans} reached “{state}”, the weakest between {survived} and {least}.",
            ko: "{scans} 중 {fell}건이 ‘{state}’ 상태에 이르렀으며, 그 최소 가속도는 {survived}~{least}이다.",
        },
        FellFrom { fell: usize, scans: Sentence, state: Sentence, least: Quantity } => {
            en: "{fell} of {scans} reached “{state}”, the weakest at {least} or below, the smallest size that was tried.",
            ko: "{scans} 중 {fell}건이 ‘{state}’ 상태에 이르렀으며, 그 최소 가속도는 시도한 최소 크기 {least} 이하이다.",
        },
        FellAlone { alone: usize, scans: Sentence, share: Quantity, lower: Quantity, upper: Quantity } => {
            en: "{alone} of {scans} fall under their own weight, without any shaking: {share} of the samples ({lower} to {upper} with 95 % confidence). They count with a capacity of 0.",
            ko: "{scans} 중 {alone}건은 지진 없이 자중으로 붕괴한다. 표본의 {share}(95 % 신뢰구간 {lower}–{upper})이며 내력 0으로 계산하였다.",
        },
        CombinationsFall { alone: usize, scans: Sentence } => {
            en: "{alone} of {scans} fall under their own weight, without any shaking. They count with a capacity of 0.",
            ko: "{scans} 중 {alone}건은 지진 없이 자중으로 붕괴하며 내력 0으로 계산하였다.",
        },
        Mixed { state: Sentence, share: Quantity, theta: Quantity, beta: Quantity } => {
            en: "The fragility of “{state}” begins at {share} without shaking: P(a) = p₀ + (1 − p₀) Φ(ln(a/θ)/β) with p₀ = {share}; θ = {theta} and β = {beta} are of the samples that stand (lognormal).",
            ko: "‘{state}’ 취약도는 지진이 없을 때 이미 {share}이다. P(a) = p₀ + (1 − p₀) Φ(ln(a/θ)/β), p₀ = {share}이며 θ = {theta}, β = {beta}는 서 있는 표본에 적합한 대수정규분포의 값이다.",
        },
        NoFiniteRate { share: Quantity } => {
            en: "Of the {share} that fall by themselves no annual rate is finite: rates are of the samples that stand, probabilities in 50 years of all.",
            ko: "자중으로 붕괴하는 {share}에는 유한한 연간 초과율이 없다. 연간 초과율은 서 있는 표본의 값이고 50년 확률은 전체의 값이다.",
        },
        DriftBeyond { beyond: usize, scans: Sentence, limit: Quantity, least: Quantity } => {
            en: "{beyond} of {scans} drifted beyond the allowable {limit} of a storey that the file sets« ([limits])», the weakest at {least}.",
            ko: "{scans} 중 {beyond}건이 파일에서 정한 허용 층간변위 {limit}«([limits])»을(를) 넘었으며, 그 최소 가속도는 {least}이다.",
        },
        DriftWithin { scans: Sentence, limit: Quantity, largest: Quantity } => {
            en: "None of {scans} drifted beyond the allowable {limit} of a storey that the file sets« ([limits])», up to {largest}.",
            ko: "{scans} 모두 {largest}까지 파일에서 정한 허용 층간변위 {limit}«([limits])» 이내이다.",
        },
        LeansBeyond { leans: usize, scans: Sentence, limit: Quantity, most: Quantity } => {
            en: "{leans} of {scans} lean beyond the allowable {limit} of a storey that the file sets« ([limits])» without any shaking, by up to {most}: the lean as surveyed, and what the weight adds to it. They count as having reached it without shaking (p₀).",
            ko: "{scans} 중 {leans}건은 조사한 기울기와 자중에 의한 증가분만으로 지진 없이 이미 파일에서 정한 허용 층간변위 {limit}«([limits])»을(를) 넘으며, 최대 {most}이다. 지진이 없을 때 도달한 것(p₀)으로 센다.",
        },
        LeansOrFalls { both: usize, scans: Sentence, limit: Quantity, leans: usize, most: Quantity, falls: usize } => {
            en: "{both} of {scans} are beyond the allowable {limit} of a storey that the file sets« ([limits])» without any shaking: {leans} lean by up to {most}, the lean as surveyed and what the weight adds to it, and {falls} fall. They count as having reached it without shaking (p₀).",
            ko: "{scans} 중 {both}건은 지진 없이 이미 파일에서 정한 허용 층간변위 {limit}«([limits])»을(를) 넘는다. {leans}건은 조사한 기울기와 자중에 의한 증가분이 최대 {most}이고 {falls}건은 붕괴한다. 지진이 없을 때 도달한 것(p₀)으로 센다.",
        },
        OthersBeyond { beyond: usize, scans: Sentence, least: Quantity } => {
            en: "Of the other {scans}, {beyond} drifted beyond it, the weakest at {least}.",
            ko: "나머지 {scans} 중 {beyond}건이 이를 넘었으며, 그 최소 가속도는 {least}이다.",
        },
        OthersWithin { scans: Sentence, largest: Quantity } => {
            en: "Of the other {scans} none drifted beyond it, up to {largest}.",
            ko: "나머지 {scans}은(는) {largest}까지 모두 이내이다.",
        },
        DriftMixed { share: Quantity, theta: Quantity, beta: Quantity } => {
            en: "Its fragility begins at {share} without shaking: P(a) = p₀ + (1 − p₀) Φ(ln(a/θ)/β) with p₀ = {share}; θ = {theta} and β = {beta} are of the scans that are within it at rest (lognormal).",
            ko: "그 취약도는 지진이 없을 때 이미 {share}이다. P(a) = p₀ + (1 − p₀) Φ(ln(a/θ)/β), p₀ = {share}이며 θ = {theta}, β = {beta}는 정지 상태에서 허용값 이내인 증분해석에 적합한 대수정규분포의 값이다.",
        },
        NoFiniteRateAtRest { share: Quantity } => {
            en: "Of the {share} that are beyond the allowed drift without shaking no annual rate is finite: its rate is of those within it at rest, its probability in 50 years of all.",
            ko: "지진 없이 이미 허용 층간변위를 넘은 {share}에는 유한한 연간 초과율이 없다. 이 상태의 연간 초과율은 정지 상태에서 허용값 이내인 표본의 값이고 50년 확률은 전체의 값이다.",
        },
        DriftCurve { theta: Quantity, beta: Quantity } => {
            en: "By the curve fitted to them (lognormal) half exceed it at {theta}, scatter of the logarithm β = {beta}.",
            ko: "적합한 대수정규 취약도 곡선에서 허용 층간변위를 넘는 중앙값은 {theta}, 대수 표준편차는 β = {beta}이다.",
        },
        DriftRisk { curve: Sentence, rate: Quantity, years: Quantity, share: Quantity } => {
            en: "{curve} With the hazard of the site: {rate} a year, {share} in {years} years.",
            ko: "{curve} 부지의 재해도로 계산하면 연간 초과율은 {rate}, {years}년 확률은 {share}이다.",
        },
        FirstBeyond { before: usize, limit: Quantity } => {
            en: "In {before} scans more the motion before drifts beyond the allowable {limit} by itself.",
            ko: "그 밖의 증분해석 {before}건에서는 앞선 지반운동만으로 허용 층간변위 {limit}을(를) 넘는다.",
        },
        FellBefore { alone: usize, scans: Sentence } => {
            en: "{alone} of {scans} fall under their own weight or in the motion before: nothing is left of them. They count with a capacity of 0.",
            ko: "{scans} 중 {alone}건은 자중으로 또는 앞선 지반운동에서 붕괴하여 남은 내력이 없으며, 내력 0으로 계산하였다.",
        },
        LeanCounted { drift: Sentence, lean: Quantity } => {
            en: "{drift} The lean as surveyed takes {lean} of it.",
            ko: "{drift} 그중 {lean}은(는) 조사한 기울기이다.",
        },
        Median { state: Sentence, theta: Quantity, beta: Quantity } => {
            en: "The curve fitted to them (lognormal) has its median for “{state}” at {theta}, scatter of the logarithm β = {beta}.",
            ko: "적합한 대수정규 취약도 곡선에서 ‘{state}’ 상태의 중앙값은 {theta}, 대수 표준편차는 β = {beta}이다.",
        },
        MedianBeyond { state: Sentence, theta: Quantity, beta: Quantity } => {
            en: "Less than half of them reached “{state}”: the median of the curve fitted to them (lognormal), {theta} with a scatter of the logarithm of β = {beta}, is an extrapolation.",
            ko: "‘{state}’ 상태에 이른 것이 절반에 못 미친다. 적합한 대수정규 취약도 곡선의 중앙값 {theta}(대수 표준편차 β = {beta})은 외삽값이다.",
        },
    }
}

/// The findings, doubts first.
pub(crate) fn findings(answer: &StudyAnswer) -> Vec<Finding> {
    let undamped = answer.is_undamped.then_some(Found::Undamped);
    let mut all = of_version(answer);
    all.extend(undamped.map(|said| Finding::key(Tone::Warn, said)));
    all.extend(before::findings(answer));
    let doubts = run::doubts(answer).into_iter();
    all.extend(doubts.map(|doubt| Finding::key(Tone::Bad, doubt)));
    let left_out = answer.left_out_of_runs.iter().map(|said| {
        let said = said.clone();
        Finding::key(Tone::Warn, run::Done::NotInRuns(said))
    });
    all.extend(releases::findings(answer));
    if answer.study.scan.is_none() {
        all.extend(left_out);
        return all;
    }
    all.extend(allowed_drift(answer));
    let found = capacity(answer);
    if found.is_none() {
        // only the reasons are left
        let why = run::refused_for(answer).into_iter();
        all.extend(why.map(|said| Finding::key(Tone::Bad, said)));
    }
    all.extend(fell_alone(answer));
    all.extend(found);
    all.extend(by_variant(answer));
    all.extend(tenons::finding(answer));
    all.extend(capacities::milder_states(answer).map(|said| Finding::key(Tone::Plain, said)));
    all.extend(left_out);
    all.extend(run::copies(answer).map(|said| Finding::key(Tone::Warn, said)));
    all.extend(
        doubts::doubts(answer)
            .into_iter()
            .map(|said| Finding::key(Tone::Warn, said)),
    );
    all.extend(doubts::survived_larger(answer).map(|said| Finding::key(Tone::Plain, said)));
    all.extend(median(answer));
    all.extend(no_finite_rate(answer));
    let few = scatter::few_samples(answer).into_iter();
    all.extend(few.map(|said| Finding::key(Tone::Warn, said)));
    let crossings = scatter::crossings(answer, answer.fragilities());
    all.extend(crossings.into_iter().map(|said| Finding::new(Tone::Warn, said)));
    all.extend(hazard::extrapolated(answer).map(|said| Finding::key(Tone::Warn, said)));
    all.extend(trends::findings(answer));
    all
}

/// What the runs have in place of the structure of the file: a variant, values that the study sets, damage of inspections.
fn of_version(answer: &StudyAnswer) -> Vec<Finding> {
    let mut all = Vec::new();
    if let [variant] = answer.study.variants.as_slice() {
        let variant = variant.clone();
        all.push(Finding::key(Tone::Plain, Found::OfVariant { variant }));
    }
    if !answer.set_shown.is_empty() {
        let each = answer.set_shown.clone();
        all.push(Finding::key(Tone::Plain, Found::OfSet { each }));
    }
    let damage = run::damage(answer).into_iter();
    all.extend(damage.map(|said| Finding::key(Tone::Warn, said)));
    all
}

/// The smallest peak at which each of several variants reaches the last state.
fn by_variant(answer: &StudyAnswer) -> Option<Finding> {
    if answer.study.variants.len() < 2 {
        return None;
    }
    let variants = answer.study.variants.len();
    let mut levels = answer.levels();
    levels.truncate(variants);
    if levels.iter().all(|level| level.fell() == 0) {
        return None;
    }
    let each = levels.into_iter().filter_map(|level| {
        let variant = level.text.clone();
        Some(match level.least_m_s2()? {
            Reached::At(least) => Found::VariantAt {
                variant,
                least: g(answer, least),
            },
            Reached::Above(largest) => Found::VariantAbove {
                variant,
                largest: g(answer, largest),
            },
        })
    });
    let each: Vec<Sentence> = each.map(Sentence::from).collect();
    let state = state(answer, answer.kind.states().len() - 1);
    (!each.is_empty()).then(|| Finding::key(Tone::Plain, Found::ByVariant { state, each }))
}

/// The scans compared with the allowable drift of the file.
fn allowed_drift(answer: &StudyAnswer) -> Vec<Finding> {
    let Some(found) = answer.allowed_drift() else {
        return Vec::new();
    };
    let mut all = match found.at_rest {
        0 => vec![drift_in_shaking(answer, &found)],
        _ => drift_at_rest(answer, &found),
    };
    all.extend(allowed_drift_curve(answer).map(|said| Finding::key(Tone::Plain, said)));
    if found.before > 0 {
        let limit = Quantity::percent(found.limit, 3);
        let before = found.before;
        all.push(Finding::key(Tone::Warn, Found::FirstBeyond { before, limit }));
    }
    all
}

/// The drift of structures that are within the allowable one at rest.
fn drift_in_shaking(answer: &StudyAnswer, found: &AllowedDrift) -> Finding {
    let scans = words::scans(found.scans);
    let limit = Quantity::percent(found.limit, 3);
    let (tone, said) = match found.least_m_s2 {
        Some(least) => {
            let said = Found::DriftBeyond {
                beyond: found.beyond,
                scans,
                limit,
                least: g(answer, least),
            };
            (Tone::Warn, said)
        }
        None => {
            let largest = g(answer, found.largest_m_s2);
            let said = Found::DriftWithin {
                scans,
                limit,
                largest,
            };
            (Tone::Plain, said)
        }
    };
    Finding::key(tone, with_lean(said, found))
}

/// The same where some lean beyond it at rest: these first, then the others.
fn drift_at_rest(answer: &StudyAnswer, found: &AllowedDrift) -> Vec<Finding> {
    let scans = words::scans(found.scans);
    let (limit, most) = (
        Quantity::percent(found.limit, 3),
        Quantity::percent(found.at_rest_most, 3),
    );
    let without_shaking = found.at_rest + found.fell_alone;
    let said = match found.fell_alone {
        0 => Found::LeansBeyond {
            leans: found.at_rest,
            scans,
            limit,
            most,
        },
        falls => Found::LeansOrFalls {
            both: without_shaking,
            scans,
            limit,
            leans: found.at_rest,
            most,
            falls,
        },
    };
    let mut all = vec![Finding::key(Tone::Bad, said)];
    let others = found.scans - without_shaking;
    if others == 0 {
        return all;
    }
    let scans = words::scans(others);
    let said = match found.least_m_s2 {
        Some(least) => Found::OthersBeyond {
            beyond: found.beyond - without_shaking,
            scans,
            least: g(answer, least),
        },
        None => Found::OthersWithin {
            scans,
            largest: g(answer, found.largest_m_s2),
        },
    };
    all.push(Finding::key(Tone::Warn, with_lean(said, found)));
    all
}

/// With the surveyed lean that the drifts contain.
fn with_lean(said: Found, found: &AllowedDrift) -> Sentence {
    match found.lean > 0.0 {
        true => Found::LeanCounted {
            drift: said.into(),
            lean: Quantity::percent(found.lean, 3),
        }
        .into(),
        false => said.into(),
    }
}

/// The curve of the allowable drift and its risk, for a single combination.
fn allowed_drift_curve(answer: &StudyAnswer) -> Option<Sentence> {
    let [one] = answer.fragilities() else {
        return None;
    };
    let own = one.states.iter().find(|own| own.state == ALLOWED_DRIFT)?;
    let fit = own.by_acceleration.as_ref().ok()?;
    let (theta, beta) = (g(answer, fit.curve.theta()), Quantity::ratio(fit.curve.beta(), 2));
    if own.leans_beyond > 0 {
        let share = Quantity::percent(own.share_alone(), 2);
        return Some(Found::DriftMixed { share, theta, beta }.into());
    }
    if own.fell_alone > 0 {
        return None;
    }
    let curve = Found::DriftCurve { theta, beta };
    Some(match own.annual_rate().zip(own.probability_in_years()) {
        None => curve.into(),
        Some((rate, share)) => Found::DriftRisk {
            curve: curve.into(),
            rate: Quantity::ratio(rate, 2),
            years: Quantity::ratio(YEARS, 2),
            share: Quantity::percent(share, 2),
        }
        .into(),
    })
}

/// Number of scans that fall without shaking.
fn fell_alone(answer: &StudyAnswer) -> Option<Finding> {
    let capacities = answer.capacities();
    let usable: Vec<_> = capacities
        .iter()
        .filter(|scan| scan.verdict.is_usable())
        .collect();
    let is_alone = |scan: &&&CapacityOf| scan.verdict == ScanVerdict::FellAlone;
    let alone = usable.iter().filter(is_alone).count();
    if alone == 0 {
        return None;
    }
    // scans of one sample fall together, so samples are counted, not scans
    let samples = |of: &mut dyn Iterator<Item = &&CapacityOf>| {
        let cases: BTreeSet<usize> = of.map(|scan| answer.case_of(scan.job)).collect();
        cases.len()
    };
    let all = samples(&mut usable.iter());
    let fallen = samples(&mut usable.iter().filter(is_alone));
    let scans = words::scans(usable.len());
    let interval = clopper_pearson(fallen, all, words::CONFIDENCE).ok();
    let drawn = answer.study.samples.is_some_and(|samples| samples > 1) && answer.study.combinations() == 1;
    let said = match interval.filter(|_| drawn) {
        _ if answer.study.after.is_some() => Found::FellBefore { alone, scans },
        Some(interval) => Found::FellAlone {
            alone,
            scans,
            share: Quantity::percent(fallen as f64 / all as f64, 2),
            lower: Quantity::percent(interval.lower, 2),
            upper: Quantity::percent(interval.upper, 2),
        },
        None => Found::CombinationsFall { alone, scans },
    };
    Some(Finding::key(Tone::Bad, said))
}

/// Notes that rates leave out scans that are in a state without shaking.
pub(super) fn no_finite_rate(answer: &StudyAnswer) -> Vec<Finding> {
    let states = answer.fragilities().iter().flat_map(|one| &one.states);
    let (mut falls, mut leans) = (0.0_f64, 0.0_f64);
    for own in states.filter(|own| own.risk.is_some()) {
        let most = match own.leans_beyond {
            0 => &mut falls,
            _ => &mut leans,
        };
        *most = most.max(own.share_alone());
    }
    let share = |of: f64| (of > 0.0).then(|| Quantity::percent(of, 2));
    let falls = share(falls).map(|share| Found::NoFiniteRate { share });
    let leans = share(leans).map(|share| Found::NoFiniteRateAtRest { share });
    let each = falls.into_iter().chain(leans);
    each.map(|said| Finding::key(Tone::Bad, said)).collect()
}

/// Number of scans that reached the last state, and the smallest such peak: of those that stand by themselves.
fn capacity(answer: &StudyAnswer) -> Option<Finding> {
    let capacities = answer.capacities();
    let usable = capacities
        .iter()
        .filter(|scan| scan.verdict.is_usable() && scan.verdict != ScanVerdict::FellAlone);
    let all = LevelRow {
        input: None,
        text: String::new(),
        value: None,
        scans: usable.cloned().collect(),
    };
    let scans = match all.scans.len() {
        0 => return None,
        1 => Words::OneScan.into(),
        count => Words::Scans { count }.into(),
    };
    let state = state(answer, answer.kind.states().len() - 1);
    let said = match all.least_m_s2()? {
        Reached::Above(largest) => {
            let largest = g(answer, largest);
            Found::NoneFell {
                scans,
                state,
                largest,
            }
        }
        Reached::At(at_m_s2) => {
            let (fell, least) = (all.fell(), g(answer, at_m_s2));
            let survived = all.least_survived_m_s2();
            match answer.kind != StudyKind::Building && all.least_is_bound() {
                true => Found::FellFrom {
                    fell,
                    scans,
                    state,
                    least,
                },
                false if capacities::is_interval(survived, at_m_s2) => Found::FellBetween {
                    fell,
                    scans,
                    state,
                    survived: g(answer, survived),
                    least,
                },
                false => Found::Fell {
                    fell,
                    scans,
                    state,
                    least,
                },
            }
        }
    };
    Some(Finding::key(Tone::Plain, said))
}

/// The median of the worst state with a curve, for a single combination.
fn median(answer: &StudyAnswer) -> Option<Finding> {
    let [one] = answer.fragilities() else {
        return None;
    };
    let states = one.states.iter().filter(|own| own.state != ALLOWED_DRIFT);
    let mut worst = states.rev();
    let (own, fit) = worst.find_map(|own| Some((own, own.by_acceleration.as_ref().ok()?)))?;
    let of = own.state;
    let (name, theta) = (state(answer, of), g(answer, fit.curve.theta()));
    let beta = Quantity::ratio(fit.curve.beta(), 2);
    if own.fell_alone > 0 {
        let said = Found::Mixed {
            state: name,
            share: Quantity::percent(own.share_alone(), 2),
            theta,
            beta,
        };
        return Some(Finding::key(Tone::Bad, said));
    }
    let usable = answer.capacities();
    let usable: Vec<_> = usable.iter().filter(|scan| scan.verdict.is_usable()).collect();
    let reached = usable
        .iter()
        .filter(|scan| scan.first_m_s2.is_some_and(|first| first[of].is_reached()));
    Some(match 2 * reached.count() < usable.len() {
        true => Finding::key(
            Tone::Warn,
            Found::MedianBeyond {
                state: name,
                theta,
                beta,
            },
        ),
        false => Finding::key(
            Tone::Plain,
            Found::Median {
                state: name,
                theta,
                beta,
            },
        ),
    })
}
