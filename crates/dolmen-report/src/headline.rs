//! The headline, the same on the terminal, on pages, in workbooks and on the index: weight, earthquake, evidence, assumed inputs.

use crate::damaged::damaged;
use crate::document::{TextStyle, wrapped};
use crate::headline_basis::{left_out, resting};
use crate::headline_combined::with_earthquake;
use crate::headline_damage::damage_state;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Language, Quantity, Sentence, Template, Unit, messages};
use dolmen_work::judgement::{
    Basis, ChangedSince, DecidedBy, Earthquake, EarthquakeFinding, Evidence, Judgement, MeasuredFrequency,
    MovedBy, VersionJudgement, Weight, WindFinding, WindLimit,
};

/// Digits of ratios and frequencies.
const DIGITS: usize = 3;

messages! {
    /// The parts of a headline.
    pub(crate) enum Headline in "headline" {
        Verdict(words: Both) => { en: "VERDICT {words}", ko: "판정: {words}" },
        OwnWeight(word: Both) => { en: "Own weight: {word}", ko: "자중: {word}" },
        OwnWeightCrushes(word: Both) => {
            en: "Own weight: {word} (edges of stones crush)",
            ko: "자중: {word}(석재 모서리 압괴)",
        },
        WeightAndLoads(word: Both) => { en: "Weight and loads: {word}", ko: "자중·작용하중: {word}" },
        WithoutResonance { word: Both, frequency: Quantity } => {
            en: "Weight and loads: {word} (its resonance at {frequency} is not in the wind)",
            ko: "자중·작용하중: {word}(고유진동수 {frequency}의 공진이 풍하중에 없음)",
        },
        OwnWeightSamples { word: Both, share: Quantity } => {
            en: "Own weight: {word} (falls in {share} of samples)",
            ko: "자중: {word}(표본의 {share}에서 불안정)",
        },
        WeightAndLoadsSamples { word: Both, share: Quantity } => {
            en: "Weight and loads: {word} (at a limit in {share} of samples)",
            ko: "자중·작용하중: {word}(표본의 {share}에서 한계 도달)",
        },
        IfRight { word: Both, factor: Quantity, evidence: Sentence } => {
            en: "Own weight: {word} ({factor} if this model were right; {evidence})",
            ko: "자중: {word}(이 모델이 옳다면 {factor}; {evidence})",
        },
        UnknownSince { word: Both, evidence: Sentence } => {
            en: "Own weight: {word} ({evidence})",
            ko: "자중: {word}({evidence})",
        },
        Contradicted { survey: String, measured: Quantity, computed: Quantity } => {
            en: "survey {survey} contradicts it: {measured} measured, {computed} modelled",
            ko: "{survey} 조사와 불일치: 실측 {measured}, 모델 {computed}",
        },
        Model(evidence: Sentence) => { en: "Model: {evidence}", ko: "모델: {evidence}" },
        Calibrated(survey: String) => {
            en: "Model: not measured (calibrated to {survey})",
            ko: "모델: 독립 계측 없음({survey} 조사로 추정한 강성)",
        },
        AtSite { source: String, said: Sentence } => { en: "Earthquake {source}: {said}", ko: "지진 {source}: {said}" },
        AtSiteYears { source: String, years: usize, said: Sentence } => {
            en: "Earthquake {source}, {years} y: {said}",
            ko: "지진 {source}, 재현주기 {years}년: {said}",
        },
        UnderMotion { motion: String, said: Sentence } => { en: "Earthquake {motion}: {said}", ko: "지진 {motion}: {said}" },
        AfterMotion { motion: String, first: String, said: Sentence } => {
            en: "Earthquake {motion} after {first}: {said}",
            ko: "지진 {first} 이후 {motion}: {said}",
        },
        AtOther(said: Sentence) => { en: "Earthquake: {said}", ko: "지진: {said}" },
        Wind(said: Sentence) => { en: "Wind: {said}", ko: "풍응답: {said}" },
        StaticLoads(said: Sentence) => { en: "Static loads: {said}", ko: "정하중: {said}" },
        WithEarthquake(said: Sentence) => {
            en: "Combinations with the earthquake: {said}",
            ko: "지진을 포함한 하중조합: {said}",
        },
        WindAndLoads(said: Sentence) => { en: "Wind and static loads: {said}", ko: "풍하중·정하중: {said}" },
        WordAcceleration { word: Both, ratio: Quantity } => {
            en: "{word} (limit/acceleration {ratio})",
            ko: "{word}(한계/가속도 {ratio})",
        },
        WordDrift { word: Both, ratio: Quantity } => { en: "{word} (limit/drift {ratio})", ko: "{word}(한계/층간변위 {ratio})" },
        Falls => { en: "it falls", ko: "전도" },
        Word(word: Both) => { en: "{word}", ko: "{word}" },
        WordRatio { word: Both, ratio: Quantity } => { en: "{word} (capacity/demand {ratio})", ko: "{word}(저항/요구 {ratio})" },
        WordFalls(word: Both) => { en: "{word} (it falls)", ko: "{word}(붕괴)" },
        WordDamage { word: Both, state: Sentence } => { en: "{word} ({state})", ko: "{word}({state})" },
        WordRuns { word: Both, state: Sentence, runs: usize, all: usize } => {
            en: "{word} ({state} in {runs} of {all} runs)",
            ko: "{word}({state}, 해석 {all}회 중 {runs}회)",
        },
        WordRoom { word: Both, part: String, ratio: Quantity } => {
            en: "{word} (room/stroke of {part} {ratio})",
            ko: "{word}({part} 여유 공간/행정 {ratio})",
        },
        WordTie(word: Both) => { en: "{word} (a tie broke)", ko: "{word}(결속재 파단)" },
        WordCrushes(word: Both) => { en: "{word} (stone crushes)", ko: "{word}(석재 압괴)" },
        WordNoLimit(word: Both) => { en: "{word} (no limit is known)", ko: "{word}(판정 기준 없음)" },
        WordNoResponse(word: Both) => {
            en: "{word} (the response to this spectrum is not computed)",
            ko: "{word}(이 스펙트럼에 대한 응답을 계산하지 못함)",
        },
        WordNoBed { word: Both, part: String } => {
            en: "{word} (the bed below ‘{part}’ is not known)",
            ko: "{word}(‘{part}’ 하부 접합면의 폭 미상)",
        },
        WordStoodOnEdge { word: Both, part: String } => {
            en: "{word} (a bed stood on its edge: {part})",
            ko: "{word}(접합면이 모서리로 지지됨: {part})",
        },
        WordBeforeMoved { word: Both, ratio: Quantity } => {
            en: "{word} (capacity/demand {ratio} before its supports moved)",
            ko: "{word}(지점 이동 전 저항/요구 {ratio})",
        },
        WordMoved(word: Both) => { en: "{word} (its supports moved)", ko: "{word}(지점 이동)" },
        WordHeldByLoads(word: Both) => { en: "{word} (static loads without mass hold it)", ko: "{word}(질량 없는 정하중이 누름)" },
        WordLeansFurther { word: Both, ratio: Quantity } => {
            en: "{word} (capacity/demand {ratio} if it stood plumb)",
            ko: "{word}(연직 상태라면 저항/요구 {ratio})",
        },
        WordLeans(word: Both) => { en: "{word} (its tilt is not in the model)", ko: "{word}(기울기 미반영)" },
        WordWithoutTorsion { word: Both, ratio: Quantity } => {
            en: "{word} (capacity/demand {ratio} without accidental torsion)",
            ko: "{word}(우발비틀림을 제외하면 저항/요구 {ratio})",
        },
        WordNoTorsion(word: Both) => { en: "{word} (accidental torsion is not included)", ko: "{word}(우발비틀림 미반영)" },
        WordLiftsOff(word: Both) => { en: "{word} (columns without ties lift off their stones, where the springs of their beds tell nothing)", ko: "{word}(결구 없는 기둥의 주각이 초석에서 들리며, 그 뒤는 지압면의 강성으로 알 수 없음)" },
        WordSplit(word: Both) => { en: "{word} (how beds and joints share the stiffness is assumed)", ko: "{word}(지압면과 접합부의 강성 분담은 가정)" },
        WordNoBalance(word: Both) => { en: "{word} (feet lift off, and columns and joints have less than the spectrum asks for)", ko: "{word}(주각이 들리며 기둥과 접합부의 저항이 스펙트럼의 요구보다 작음)" },
        WordLoosePost(word: Both) => { en: "{word} (a side post with a gap may close)", ko: "{word}(틈이 있는 지주가 맞닿을 수 있음)" },
        WordNoStiffness(word: Both) => { en: "{word} (the stiffness is not known)", ko: "{word}(강성 미상)" },
        WordNoStiffnessIn { word: Both, direction: String } => {
            en: "{word} (the stiffness of direction {direction} is not known)",
            ko: "{word}({direction} 방향 강성 미상)",
        },
        WordIfRight { word: Both, ratio: Quantity } => {
            en: "{word} (capacity/demand {ratio} if this model were right)",
            ko: "{word}(이 모델이 옳다면 저항/요구 {ratio})",
        },
        WordContradicted(word: Both) => {
            en: "{word} (a survey contradicts the model)",
            ko: "{word}(모델이 계측과 불일치)",
        },
        WordDoesNotStand(word: Both) => {
            en: "{word} (it does not stand without shaking)",
            ko: "{word}(지진 없이도 서 있지 못함)",
        },
        WordOpen(word: Both) => { en: "{word} (the run is not whole)", ko: "{word}(해석 미완료)" },
        OverYears(each: Vec<Sentence>) => { en: "Over the years: {each}", ko: "경년 변화: {each}" },
        OpenAlarms(count: usize) => { en: "open alarms ({count})", ko: "조치되지 않은 경보 {count}건" },
        YearsTilt => { en: "the tilt is beyond its limit", ko: "기울기가 한계를 넘음" },
        YearsCracks(count: usize) => {
            en: "cracks or other damage beyond their limits ({count})",
            ko: "한계를 넘은 균열·손상 {count}건",
        },
        YearsChanged { from: String, to: String, changed: usize, tested: usize } => {
            en: "{changed} of {tested} frequencies changed beyond chance from {from} to {to}",
            ko: "{from} 조사에서 {to} 조사까지 고유진동수 {tested}개 중 {changed}개가 우연을 넘어 변화",
        },
        YearsChangedOrWeather { from: String, to: String, changed: usize, tested: usize } => {
            en: "{changed} of {tested} frequencies changed beyond chance from {from} to {to}, by the weather or the structure",
            ko: "{from} 조사에서 {to} 조사까지 고유진동수 {tested}개 중 {changed}개가 우연을 넘어 변화(기온 또는 구조물의 변화가 원인)",
        },
        Undamped => { en: "computed with 0 % damping (none is given)", ko: "감쇠비 0 %로 해석(입력 없음)" },
        TiltLeftOut { survey: String, tilt: String } => {
            en: "not in it: tilt {tilt} of survey {survey}",
            ko: "{survey} 조사의 기울기 {tilt} 미반영",
        },
        TiltBeyondLimit => { en: "Tilt: beyond its limit", ko: "기울기: 한계 초과" },
        TiltNearLimit => { en: "Tilt: near its limit", ko: "기울기: 한계에 가까움" },
        DamageBeyondLimit(count: usize) => { en: "Damage beyond its limit: {count}", ko: "한계를 넘은 손상: {count}건" },
        OfSolution { number: usize, words: Both } => { en: "Solution {number}: {words}", ko: "해 {number}: {words}" },
        WorstUnderMotion(number: usize) => {
            en: "Under this motion solution {number} is the worst: the verdict, and all that follows, is of it.",
            ko: "이 지반운동에서는 해 {number}이 가장 불리하다. 판정과 아래 결과는 해 {number}의 것이다.",
        },
        Solution { number: usize, of: usize } => {
            en: "stiffness: solution {number} of {of} from the survey",
            ko: "강성: 조사에서 구한 해 {of}개 중 해 {number}",
        },
        AsSurveyed { survey: String, tilt: String } => {
            en: "leaning as surveyed ({survey}: {tilt})",
            ko: "실측 기울기 반영({survey} 조사: {tilt})",
        },
        AsInspected(each: Vec<Sentence>) => {
            en: "with the damage of inspections: {each}",
            ko: "점검에서 확인된 손상 반영: {each}",
        },
        AsGiven { words: Both } => { en: "As given: {words}", ko: "현 상태: {words}" },
        WorseThan { variant: Both, words: Both } => { en: "Variant “{variant}”: {words}", ko: "대안 ‘{variant}’: {words}" },
    }
}

/// Templates of the sentences of headlines.
pub(crate) const TEMPLATES: &[Template] = Headline::TEMPLATES;

/// The headline of one version in one line.
pub(crate) fn headline(judged: &VersionJudgement, language: Language) -> String {
    let parts = parts(judged).into_iter().map(|part| part.text(language));
    parts.collect::<Vec<_>>().join(" · ")
}

/// The verdict of a simulation, for the terminal.
pub fn simulation_headline_text(judgement: &Judgement, style: TextStyle) -> String {
    let lines = judgement
        .versions
        .iter()
        .filter(|version| !parts(version).is_empty());
    let has_own = judgement.versions.iter().any(|version| version.variant.is_none());
    let each = lines.map(|version| match version.variant.as_deref().filter(|_| has_own) {
        Some(variant) => {
            let said = worse(Both::from(variant), version).text(style.language);
            wrapped(&said, "  ", "    ", style.columns())
        }
        None => verdict_line(version, style),
    });
    each.collect()
}

/// The verdict of each of several solutions of a stiffness, by their numbers; `worst`: the decisive one, if it differs from the worst of a check.
pub fn solution_headlines_text(
    judged: &[(usize, Judgement)],
    worst: Option<usize>,
    style: TextStyle,
) -> String {
    let worst = worst.map(Headline::WorstUnderMotion);
    let each = judged.iter().filter_map(|(number, judgement)| {
        let version = judgement.headline()?;
        Some(Headline::OfSolution {
            number: *number,
            words: Both::of(|language| headline(version, language)),
        })
    });
    let said = worst.into_iter().chain(each).map(Sentence::from);
    said.map(|said| wrapped(&said.text(style.language), "  ", "    ", style.columns()))
        .collect()
}

/// The headline of one version as a line of a terminal.
pub(crate) fn verdict_line(judged: &VersionJudgement, style: TextStyle) -> String {
    let words = Both::of(|language| headline(judged, language));
    let said = Sentence::from(Headline::Verdict(words)).text(style.language);
    wrapped(&said, "", "  ", style.columns())
}

/// The headline of the structure as given, where a worse variant stands beside it.
pub(crate) fn as_given(judged: &VersionJudgement) -> Sentence {
    let words = Both::of(|language| headline(judged, language));
    Headline::AsGiven { words }.into()
}

/// A variant that is worse than the structure as it is, whose headline states the basis.
pub(crate) fn worse(variant: Both, judged: &VersionJudgement) -> Sentence {
    let judged = VersionJudgement {
        basis: Basis::default(),
        ..judged.clone()
    };
    let words = Both::of(|language| headline(&judged, language));
    Headline::WorseThan { variant, words }.into()
}

/// Open findings of the surveys over the years, which the verdicts on weight and shaking do not contain.
pub(crate) fn over_the_years(judgement: &Judgement) -> Option<Sentence> {
    let alarming = judgement.alarming;
    let mut each: Vec<Sentence> = Vec::new();
    let cracks = alarming.cracks_beyond;
    // a tilt and cracks beyond their limits are one alarm each, and have words of their own here
    let own = usize::from(alarming.is_tilt_beyond) + usize::from(cracks > 0);
    let alarms = alarming.open_alarms.saturating_sub(own);
    each.extend((alarms > 0).then(|| Headline::OpenAlarms(alarms).into()));
    each.extend(alarming.is_tilt_beyond.then(|| Headline::YearsTilt.into()));
    each.extend((cracks > 0).then(|| Headline::YearsCracks(cracks).into()));
    each.extend(judgement.changed.as_ref().map(changed));
    (!each.is_empty()).then(|| Headline::OverYears(each).into())
}

fn changed(of: &ChangedSince) -> Sentence {
    let (from, to) = (of.from.clone(), of.to.clone());
    let (changed, tested) = (of.changed, of.tested);
    match of.may_be_weather {
        false => Headline::YearsChanged {
            from,
            to,
            changed,
            tested,
        },
        true => Headline::YearsChangedOrWeather {
            from,
            to,
            changed,
            tested,
        },
    }
    .into()
}

fn parts(judged: &VersionJudgement) -> Vec<Sentence> {
    let mut all = Vec::new();
    let contradicted = match &judged.evidence {
        Evidence::Contradicted(of) => Some(contradicted(of)),
        _ => None,
    };
    let is_unknown = matches!(judged.weight, Some(Weight::Unknown { .. }));
    all.extend(
        judged
            .weight
            .map(|weight| own_weight(judged, weight, contradicted.clone())),
    );
    all.extend(earthquake(judged));
    let alone = deciding(judged).and_then(|of| of.ratio);
    all.extend(with_earthquake(&judged.wind, alone).map(of_wind));
    all.extend(WindFinding::deciding(&judged.wind).map(of_wind));
    all.extend(judged.is_undamped.then(|| Headline::Undamped.into()));
    all.extend(judged.tilt_beyond_limit.then(|| Headline::TiltBeyondLimit.into()));
    all.extend(judged.tilt_near_limit.then(|| Headline::TiltNearLimit.into()));
    let damage = judged.damage_beyond_limit;
    all.extend((damage > 0).then(|| Headline::DamageBeyondLimit(damage).into()));
    match (contradicted, &judged.evidence) {
        // stated in addition to the weight
        (Some(_), _) if is_unknown && judged.governed_by.is_none() => {}
        (Some(evidence), _) => all.push(Headline::Model(evidence).into()),
        (
            None,
            Evidence::NotMeasured {
                calibrated_to: Some(survey),
            },
        ) => all.push(Headline::Calibrated(survey.clone()).into()),
        (None, Evidence::InDoubt(_)) => {
            let word = Both::of(|language| judged.evidence.words(language));
            let evidence = Headline::Word(word).into();
            all.push(Headline::Model(evidence).into());
        }
        (None, _) => {}
    }
    all.extend(left_out(&judged.basis));
    all.extend(judged.tilt_left_out.clone().map(|of| {
        let (survey, tilt) = (of.survey, of.written);
        Headline::TiltLeftOut { survey, tilt }.into()
    }));
    all.extend(judged.leans.clone().map(|of| {
        let (survey, tilt) = (of.survey, of.tilt);
        Headline::AsSurveyed { survey, tilt }.into()
    }));
    if !judged.damage.is_empty() {
        let each = judged.damage.iter().map(damaged).collect();
        all.push(Headline::AsInspected(each).into());
    }
    all.extend(judged.solution.map(|of| {
        let (number, of) = (of.number, of.of);
        Headline::Solution { number, of }.into()
    }));
    all.extend(resting(&judged.basis));
    all
}

fn frequency(value_hz: f64) -> Quantity {
    Quantity::new(value_hz, Unit::si("Hz"), Digits::Significant(DIGITS))
}

fn contradicted(of: &MeasuredFrequency) -> Sentence {
    Headline::Contradicted {
        survey: of.survey.clone(),
        measured: frequency(of.measured_hz),
        computed: frequency(of.computed_hz),
    }
    .into()
}

fn own_weight(judged: &VersionJudgement, weight: Weight, contradicted: Option<Sentence>) -> Sentence {
    let word = Both::of(|language| weight.word(language));
    if let Some(by) = &judged.governed_by {
        let word = Both::of(|language| judged.weight_words(weight, language));
        return match (by.is_weight() && !judged.with_loads, judged.lacks_resonance_at_hz) {
            (true, _) => Headline::OwnWeight(word).into(),
            (false, Some(frequency_hz)) => Headline::WithoutResonance {
                word,
                frequency: frequency(frequency_hz),
            }
            .into(),
            (false, None) => Headline::WeightAndLoads(word).into(),
        };
    }
    match (weight, contradicted) {
        (
            Weight::Unknown {
                load_factor_if_right: Some(factor),
            },
            Some(evidence),
        ) => Headline::IfRight {
            word,
            factor: Quantity::beside_one(factor, DIGITS),
            evidence,
        },
        (Weight::Unknown { .. }, Some(evidence)) => Headline::UnknownSince { word, evidence },
        (Weight::Stable | Weight::Marginal, _) if judged.falling_share.is_some() => {
            let share = Quantity::percent(judged.falling_share.unwrap_or_default(), 2);
            match judged.with_loads {
                true => Headline::WeightAndLoadsSamples { word, share },
                false => Headline::OwnWeightSamples { word, share },
            }
        }
        _ if judged.crushes => Headline::OwnWeightCrushes(word),
        _ if judged.with_loads => Headline::WeightAndLoads(word),
        _ => Headline::OwnWeight(word),
    }
    .into()
}

/// The finding that decides: among those with the worst word, the one with the smallest margin.
fn deciding(judged: &VersionJudgement) -> Option<&EarthquakeFinding> {
    let word = judged.earthquake_word();
    let worst = judged.earthquake.iter().filter(|of| of.word == word);
    let in_hand = |of: &EarthquakeFinding| match of.decided_by {
        DecidedBy::Fall => f64::NEG_INFINITY,
        _ => of.ratio.unwrap_or(f64::INFINITY),
    };
    worst.min_by(|a, b| in_hand(a).total_cmp(&in_hand(b)))
}

fn earthquake(judged: &VersionJudgement) -> Option<Sentence> {
    let of = deciding(judged)?;
    let said = Sentence::from(word(of));
    Some(
        match (&of.motion, &judged.demand_source) {
            (Some(of), _) if judged.after.as_ref().is_some_and(|both| *of != both.first) => {
                let both = judged.after.clone();
                let (first, motion) = both.map(|both| (both.first, both.second)).unwrap_or_default();
                Headline::AfterMotion { motion, first, said }
            }
            (Some(motion), _) => Headline::UnderMotion {
                motion: motion.clone(),
                said,
            },
            (None, Some((source, Some(years)))) => Headline::AtSiteYears {
                source: source.clone(),
                years: *years as usize,
                said,
            },
            (None, Some((source, None))) => Headline::AtSite {
                source: source.clone(),
                said,
            },
            // pushed: no earthquake
            (None, None) if of.decided_by == DecidedBy::Fall => Headline::Falls,
            (None, None) => Headline::AtOther(said),
        }
        .into(),
    )
}

/// A response to wind, static loads or a combination compared with its limit.
fn of_wind(of: &WindFinding) -> Sentence {
    let word = Both::of(|language| of.word.word(language));
    let said = match (
        of.limit,
        of.ratio.map(|ratio| Quantity::beside_one(ratio, DIGITS)),
    ) {
        (Some(WindLimit::Acceleration), Some(ratio)) => Headline::WordAcceleration { word, ratio },
        // it does not bear the wind, or its drift at rest is beyond the limit: there is no ratio
        (Some(WindLimit::Drift), Some(_)) if of.ratio == Some(0.0) => Headline::Word(word),
        (Some(WindLimit::Drift), Some(ratio)) => Headline::WordDrift { word, ratio },
        (Some(WindLimit::Room), Some(ratio)) => Headline::WordRoom {
            word,
            part: of.part.clone().unwrap_or_default(),
            ratio,
        },
        (Some(WindLimit::NotGiven), _) => Headline::WordNoLimit(word),
        (_, None) | (None, _) => Headline::Word(word),
    };
    let said = said.into();
    match of.by {
        MovedBy::Wind => Headline::Wind(said),
        MovedBy::Loads => Headline::StaticLoads(said),
        MovedBy::Both => Headline::WindAndLoads(said),
        MovedBy::WithEarthquake => Headline::WithEarthquake(said),
    }
    .into()
}

fn word(of: &EarthquakeFinding) -> Headline {
    let word = Both::of(|language| of.word.word(language));
    let ratio = |ratio: f64| Quantity::beside_one(ratio, DIGITS);
    match (&of.decided_by, of.ratio) {
        (DecidedBy::Fall, _) if of.word == Earthquake::BelowDemand => Headline::WordFalls(word),
        (DecidedBy::Drift, None) if of.word == Earthquake::BelowDemand => Headline::WordFalls(word),
        (DecidedBy::DamageState(state), _) => {
            let state = damage_state(*state);
            Headline::WordDamage { word, state }
        }
        (DecidedBy::DamageOfRuns { state, runs, all }, _) => Headline::WordRuns {
            word,
            state: damage_state(*state),
            runs: *runs,
            all: *all,
        },
        (DecidedBy::Strength, _) => Headline::WordTie(word),
        (DecidedBy::Crushing, _) => Headline::WordCrushes(word),
        (DecidedBy::NoLimit, _) => Headline::WordNoLimit(word),
        (DecidedBy::NoResponse, _) => Headline::WordNoResponse(word),
        (DecidedBy::BedUnknown, _) => Headline::WordNoBed {
            word,
            part: of.part.clone().unwrap_or_default(),
        },
        (DecidedBy::LoosePost, _) => Headline::WordLoosePost(word),
        (DecidedBy::FeetLiftOff, _) => Headline::WordLiftsOff(word),
        (DecidedBy::NoBalance, _) => Headline::WordNoBalance(word),
        (DecidedBy::SplitAssumed, _) => Headline::WordSplit(word),
        (DecidedBy::StiffnessUnknown, _) => match of.part.clone() {
            None => Headline::WordNoStiffness(word),
            Some(direction) => Headline::WordNoStiffnessIn { word, direction },
        },
        (DecidedBy::Contradicted, Some(known)) if known.is_finite() => Headline::WordIfRight {
            word,
            ratio: ratio(known),
        },
        (DecidedBy::Contradicted, _) => Headline::WordContradicted(word),
        (DecidedBy::StoodOnEdge, _) => Headline::WordStoodOnEdge {
            word,
            part: of.part.clone().unwrap_or_default(),
        },
        (DecidedBy::SupportsMoved, Some(known)) if known.is_finite() => Headline::WordBeforeMoved {
            word,
            ratio: ratio(known),
        },
        (DecidedBy::SupportsMoved, _) => Headline::WordMoved(word),
        (DecidedBy::HeldByLoads, _) => Headline::WordHeldByLoads(word),
        (DecidedBy::LeansFurther, Some(known)) if known.is_finite() => Headline::WordLeansFurther {
            word,
            ratio: ratio(known),
        },
        (DecidedBy::LeansFurther, _) => Headline::WordLeans(word),
        (DecidedBy::WithoutTorsion, Some(known)) if known.is_finite() => Headline::WordWithoutTorsion {
            word,
            ratio: ratio(known),
        },
        (DecidedBy::WithoutTorsion, _) => Headline::WordNoTorsion(word),
        (DecidedBy::DoesNotStand, _) => Headline::WordDoesNotStand(word),
        (DecidedBy::Unfinished, _) => Headline::WordOpen(word),
        (DecidedBy::Room, Some(of_room)) => Headline::WordRoom {
            word,
            part: of.part.clone().unwrap_or_default(),
            ratio: ratio(of_room),
        },
        (_, Some(known)) if known.is_finite() => Headline::WordRatio {
            word,
            ratio: ratio(known),
        },
        _ => Headline::Word(word),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_work::judgement::{AssumedInputs, WindWord, judge};

    fn judged() -> VersionJudgement {
        VersionJudgement {
            variant: None,
            governed_by: None,
            lacks_resonance_at_hz: None,
            with_loads: false,
            crushes: false,
            falling_share: None,
            weight: Some(Weight::Unknown {
                load_factor_if_right: Some(1.95),
            }),
            earthquake: vec![
                EarthquakeFinding {
                    word: Earthquake::BelowDemand,
                    decided_by: DecidedBy::BedEdge,
                    motion: None,
                    part: Some("pole".into()),
                    ratio: Some(0.17),
                },
                EarthquakeFinding {
                    word: Earthquake::Above,
                    decided_by: DecidedBy::Drift,
                    motion: None,
                    part: None,
                    ratio: Some(3.0),
                },
            ],
            wind: Vec::new(),
            evidence: Evidence::Contradicted(MeasuredFrequency {
                survey: "2009".into(),
                direction: "x".into(),
                measured_hz: 2.1,
                sd_hz: None,
                computed_hz: 0.233,
            }),
            demand_source: Some(("KDS".into(), Some(2400))),
            tilt_left_out: None,
            tilt_beyond_limit: false,
            tilt_near_limit: false,
            damage_beyond_limit: 0,
            leans: None,
            after: None,
            solution: None,
            basis: Basis {
                inputs: AssumedInputs { assumed: 3, all: 12 },
                ..Basis::default()
            },
            damage: Vec::new(),
            is_undamped: false,
        }
    }

    #[test]
    fn exact_a_contradicted_model_is_never_called_stable() {
        let english = headline(&judged(), Language::English);
        assert_eq!(
            english,
            "Own weight: unknown (1.95 if this model were right; survey 2009 contradicts it: 2.10\u{202f}Hz measured, 0.233\u{202f}Hz \
             modelled) · Earthquake KDS, 2400 y: below demand (capacity/demand 0.170) · assumed inputs: 3 of 12"
        );
        let korean = headline(&judged(), Language::Korean);
        assert!(
            korean.contains("판정 불가(이 모델이 옳다면 1.95; 2009 조사와 불일치"),
            "{korean}"
        );
        let weight = Some(Weight::Stable);
        let said = headline(&VersionJudgement { weight, ..judged() }, Language::English);
        assert!(said.contains("· Model: survey 2009 contradicts it"), "{said}");
    }

    #[test]
    fn holds_a_combination_with_the_earthquake_is_named_where_it_leaves_less_than_the_earthquake() {
        let of = |by, ratio| WindFinding {
            word: WindWord::Within,
            by,
            limit: Some(WindLimit::Drift),
            part: None,
            ratio: Some(ratio),
        };
        let combined = |ratio| VersionJudgement {
            weight: Some(Weight::Stable),
            earthquake: vec![EarthquakeFinding {
                word: Earthquake::Near,
                decided_by: DecidedBy::Drift,
                motion: None,
                part: None,
                ratio: Some(1.19),
            }],
            wind: vec![of(MovedBy::Both, 1.05), of(MovedBy::WithEarthquake, ratio)],
            ..judged()
        };
        let said = |ratio| headline(&combined(ratio), Language::English);
        assert!(
            said(1.11).contains("1.19") && said(1.11).contains("1.11"),
            "{}",
            said(1.11)
        );
        assert!(!said(1.21).contains("1.21"), "{}", said(1.21));
    }

    #[test]
    fn exact_the_years_name_what_is_open_and_nothing_else() {
        let said = |of: &Judgement, language| over_the_years(of).map(|said| said.text(language));
        let mut judgement = judge(&[]);
        assert_eq!(said(&judgement, Language::English), None);
        judgement.alarming.open_alarms = 2;
        let korean = said(&judgement, Language::Korean).unwrap_or_default();
        assert_eq!(korean, "경년 변화: 조치되지 않은 경보 2건");
        (judgement.alarming.open_alarms, judgement.alarming.is_tilt_beyond) = (0, true);
        let english = said(&judgement, Language::English).unwrap_or_default();
        assert_eq!(english, "Over the years: the tilt is beyond its limit");
        // the tilt and the cracks are two of the three alarms
        (judgement.alarming.open_alarms, judgement.alarming.cracks_beyond) = (3, 2);
        let english = said(&judgement, Language::English).unwrap_or_default();
        assert_eq!(
            english,
            "Over the years: open alarms (1), the tilt is beyond its limit and cracks or other damage beyond their limits (2)"
        );
        judgement.alarming = judge(&[]).alarming;
        judgement.changed = Some(ChangedSince {
            from: "2024-03-05".to_owned(),
            to: "2026-03-07".to_owned(),
            changed: 2,
            tested: 4,
            may_be_weather: false,
        });
        let english = said(&judgement, Language::English).unwrap_or_default();
        assert_eq!(
            english,
            "Over the years: 2 of 4 frequencies changed beyond chance from 2024-03-05 to 2026-03-07"
        );
    }
}
