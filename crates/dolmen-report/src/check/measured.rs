//! Evidence of surveys against the model: a tilt that overturns, a frequency that the model does not have.

use super::agreement::direction_words;
use crate::document::{Finding, Tone};
use crate::engineer::damage_words;
use dolmen::assess::demand::DriftLimit;
use dolmen::stability::Verdict;
use dolmen_project::{LogKind, Project, Structure, Survey, date_of};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::felt::felt;
use dolmen_work::judgement::{SevereDamage, last_tilt, lowest_measured, tilt_against_limit};
use dolmen_work::state::{Check, FrequencyContradiction, State, TiltCheck};
use dolmen_work::watch::can_watch;

/// Digits of a tilt in a sentence.
const DIGITS: usize = 3;
/// Tilts with a smaller relative difference are the same.
const ROUNDING: f64 = 1e-9;

messages! {
    /// Surveys against the model.
    pub(crate) enum Measured in "check.measured" {
        Felt { survey: String, peak: Sentence } => {
            en: "Survey {survey} states an earthquake{peak}, and no repair or inspection followed: this check is of the structure as the file has it. Inspect the structure; then record the inspection in «works of [watch]|the list of works».",
            ko: "{survey} 조사에 지진이 기재되어 있으나{peak} 이후 보수나 점검이 없다. 이 검토는 파일에 적힌 상태의 구조물에 대한 것이다. 구조물을 점검하고 «[watch]의 works|조치 이력»에 기록한다.",
        },
        FeltPeak(peak: Quantity) => { en: " (peak acceleration {peak})", ko: "(최대가속도 {peak})" },
        FeltOnly => { en: "", ko: "" },
        OneIn(inverse: Quantity) => { en: "1/{inverse}", ko: "1/{inverse}" },
        TiltAlong { tilt: Sentence, direction: String } => {
            en: "{tilt} in direction {direction}",
            ko: "{direction} 방향 {tilt}",
        },
        TiltUnchecked { tilts: Vec<Sentence>, survey: String } => {
            en: "The measured tilt of {tilts} (survey {survey}) is not checked against overturning, because the stiffness or bed width of some joints is missing.",
            ko: "실측 기울기({tilts}, {survey} 조사)에 대한 전도 검토는 하지 못하였다. 접합부 강성과 접합면 폭이 모두 있어야 한다.",
        },
        TiltUnheld { tilt: Sentence, direction: String, survey: String } => {
            en: "The tilt of {tilt} measured in direction {direction} (survey {survey}) leans the model, but whether it holds is not known: the stiffness of that direction is not given. What leans pushes sideways with that share of its weight.",
            ko: "{direction} 방향 실측 기울기 {tilt}({survey} 조사)을 모델에 반영하였으나 그 방향의 강성이 주어지지 않아 견디는지는 알 수 없다. 기울어진 부분은 자중의 그 비율만큼 옆으로 민다.",
        },
        TiltUnused { tilt: Sentence, direction: String, survey: String } => {
            en: "The tilt of {tilt} measured in direction {direction} (survey {survey}) is not used: storeys start plumb here. What leans pushes sideways with that share of its weight.",
            ko: "{direction} 방향 실측 기울기 {tilt}({survey} 조사)은 쓰지 않았다. 이 모델의 층은 연직에서 시작한다. 기울어진 부분은 자중의 그 비율만큼 옆으로 민다.",
        },
        TiltNotInModel { tilt: Sentence, direction: String, survey: String, limit: Sentence } => {
            en: "The measured tilt of {tilt} in direction {direction} (survey {survey}) is not in this model: margins and limits are those without it. At {limit} a bed stands on its edge. The latest survey whose name begins with a date leans the model«; as_surveyed names another».",
            ko: "{direction} 방향 실측 기울기 {tilt}({survey} 조사)은 이 모델에 반영되지 않았다. 여유도와 한계는 기울기가 없는 상태의 값이다. 접합면이 모서리로만 지지되는 한계는 {limit}이다.« 이름이 날짜로 시작하는 최근 조사의 기울기가 반영되며, 다른 조사는 as_surveyed로 지정한다.»",
        },
        TiltNotTaken { tilt: Sentence, direction: String, survey: String, limit: Sentence } => {
            en: "The measured tilt of {tilt} in direction {direction} (survey {survey}) is not in this model: margins and limits are those without it. At {limit} a bed stands on its edge.",
            ko: "{direction} 방향 실측 기울기 {tilt}({survey} 조사)은 이 모델에 반영되지 않았다. 여유도와 한계는 기울기가 없는 상태의 값이다. 접합면이 모서리로만 지지되는 한계는 {limit}이다.",
        },
        FrameHolds { tilt: Sentence, direction: String, survey: String, limit: Sentence } => {
            en: "The frame is checked leaning by {tilt} in direction {direction}, from survey {survey}; its weight pushes on that, and it counts as fallen from {limit}.",
            ko: "{survey} 조사의 기울기에 따라 {direction} 방향으로 {tilt} 기운 상태에서 골조를 검토하였다. 자중이 그쪽으로 밀며, 기울기 {limit}부터 붕괴로 본다.",
        },
        FrameFalls { tilt: Sentence, direction: String, survey: String, limit: Sentence } => {
            en: "The lean of {tilt} in direction {direction}, from survey {survey}, is beyond {limit}, at which with what its weight adds a storey leans by as much as counts as fallen.",
            ko: "{survey} 조사에 따른 {direction} 방향 기울기 {tilt}이(가) {limit}을(를) 넘는다. 자중에 의한 변위를 더하면 층의 기울기가 붕괴로 보는 값에 이른다.",
        },
        BeyondDriftAtRest { survey: String, tilt: Sentence, limit: Sentence } => {
            en: "The tilt that survey {survey} measured, {tilt} by all directions together, is already beyond the storey drift of {limit} that is allowed, before any earthquake.",
            ko: "{survey} 조사의 실측 기울기는 모든 방향을 합하여 {tilt}(으)로, 지진 전에 이미 허용 층간변위비 {limit} 이상이다.",
        },
        TiltOverturns { tilt: Sentence, direction: String, survey: String, limit: Sentence } => {
            en: "The measured tilt of {tilt} in direction {direction} (survey {survey}) is beyond {limit}, at which a bed stands on its edge: it overturns, whatever the load factor.",
            ko: "{direction} 방향 실측 기울기 {tilt}({survey} 조사)은 접합면이 모서리로만 지지되는 한계 {limit}을(를) 넘는다. 하중배율과 관계없이 전도된다.",
        },
        TiltOpens { tilt: Sentence, direction: String, survey: String, limit: Sentence } => {
            en: "The measured tilt of {tilt} in direction {direction} (survey {survey}) is below {limit}, at which a bed stands on its edge; beds have begun to open, as they do from a third of that.",
            ko: "{direction} 방향 실측 기울기 {tilt}({survey} 조사)은 접합면이 모서리로만 지지되는 한계 {limit}보다 작으나, 그 3분의 1을 넘어 접합면이 벌어지기 시작하였다.",
        },
        TiltHolds { tilt: Sentence, direction: String, survey: String, limit: Sentence } => {
            en: "The measured tilt of {tilt} in direction {direction} (survey {survey}) is below {limit}, at which a bed stands on its edge; beds begin to open at a third of that.",
            ko: "{direction} 방향 실측 기울기 {tilt}({survey} 조사)은 접합면이 모서리로만 지지되는 한계 {limit}보다 작다. 접합면은 그 3분의 1에서 벌어지기 시작한다.",
        },
        TiltOpensFrom { tilt: Sentence, direction: String, survey: String, limit: Sentence, opens: Sentence } => {
            en: "The measured tilt of {tilt} in direction {direction} (survey {survey}) is below {limit}, at which a bed stands on its edge; beds have begun to open, as they do from {opens} towards that side.",
            ko: "{direction} 방향 실측 기울기 {tilt}({survey} 조사)은 접합면이 모서리로만 지지되는 한계 {limit}보다 작으나, 그쪽으로 접합면이 벌어지기 시작하는 {opens}을(를) 넘었다.",
        },
        TiltHoldsFrom { tilt: Sentence, direction: String, survey: String, limit: Sentence, opens: Sentence } => {
            en: "The measured tilt of {tilt} in direction {direction} (survey {survey}) is below {limit}, at which a bed stands on its edge; beds begin to open at {opens} towards that side.",
            ko: "{direction} 방향 실측 기울기 {tilt}({survey} 조사)은 접합면이 모서리로만 지지되는 한계 {limit}보다 작다. 접합면은 그쪽으로 {opens}에서 벌어지기 시작한다.",
        },
        BeyondItsLimit { survey: String, tilt: Sentence, limit: Sentence } => {
            en: "The tilt that survey {survey} measured, {tilt} by all directions together, is beyond the limit of {limit} that the file sets« (tilt_limit)».",
            ko: "{survey} 조사의 실측 기울기는 모든 방향을 합하여 {tilt}(으)로, 파일에서 정한 한계«(tilt_limit)» {limit}을(를) 넘는다.",
        },
        NearItsLimit { survey: String, tilt: Sentence, limit: Sentence } => {
            en: "The tilt that survey {survey} measured, {tilt} by all directions together, is near the limit of {limit} that the file sets« (tilt_limit)».",
            ko: "{survey} 조사의 실측 기울기는 모든 방향을 합하여 {tilt}(으)로, 파일에서 정한 한계«(tilt_limit)» {limit}에 가깝다.",
        },
        WithinItsLimit { survey: String, tilt: Sentence, limit: Sentence } => {
            en: "The tilt that survey {survey} measured, {tilt} by all directions together, is within the limit of {limit} that the file sets« (tilt_limit)».",
            ko: "{survey} 조사의 실측 기울기는 모든 방향을 합하여 {tilt}(으)로, 파일에서 정한 한계«(tilt_limit)» {limit} 이내이다.",
        },
        Undated(surveys: Vec<String>) => {
            en: "Surveys whose names say no date: {surveys}. Dates decide which survey is the last: beside one with a date these lean no model, their frequencies and damage give way, and «compare and watch|the comparisons of surveys» leave them out. Only their tilt counts, against «tilt_limit|the tilt limit». Begin the name with the date, 2025-04-02.",
            ko: "이름에 날짜가 없는 조사: {surveys}. 최근 조사는 날짜로 정하므로, 날짜가 있는 조사가 있으면 이 조사의 기울기는 모델에 반영되지 않고 고유진동수와 손상은 뒤로 밀리며 «compare와 watch|조사 비교와 장기 변화 검토»에서 빠진다. 기울기를 «tilt_limit|기울기 한계»와 비교하는 데만 쓴다. 이름을 2025-04-02처럼 날짜로 시작한다.",
        },
        BeyondDrift { survey: String, tilt: Sentence, limit: Sentence } => {
            en: "The tilt that survey {survey} measured, {tilt} by all directions together, is already beyond the storey drift of {limit} that is allowed: storeys start plumb here, and no comparison with that limit holds.",
            ko: "{survey} 조사의 실측 기울기는 모든 방향을 합하여 {tilt}(으)로, 이미 허용 층간변위비 {limit}을(를) 넘는다. 이 모델의 층은 연직에서 시작하므로 그 한계와의 비교는 성립하지 않는다.",
        },
        BeyondColumns { survey: String, tilt: Sentence, limit: Sentence } => {
            en: "The tilt that survey {survey} measured, {tilt} by all directions together, is beyond {limit}, at which its free-standing columns alone fall: storeys start plumb here, and what is left of their resistance is not in this model.",
            ko: "{survey} 조사의 실측 기울기는 모든 방향을 합하여 {tilt}(으)로, 독립 기둥만으로 전도되는 한계 {limit}을(를) 넘는다. 이 모델의 층은 연직에서 시작하므로 남은 저항은 반영되지 않았다.",
        },
        SevereDamage { survey: String, found: Vec<Sentence> } => {
            en: "Survey {survey} found severe damage that is not in the model: {found}. The verdict is on the structure without this damage.",
            ko: "{survey} 점검에서 심한 손상이 발견되었으나 모델에는 반영되지 않았다: {found}. 판정은 이 손상이 없는 상태에 대한 것이다.",
        },
        Damaged { part: String, what: Sentence } => { en: "“{part}”: {what}", ko: "‘{part}’ {what}" },
        Rough { survey: String, measured: Quantity, direction: Both, computed: Quantity } => {
            en: "Survey {survey} measured {measured} in direction {direction}; this model has {computed}. The measurement is too rough to tell whether they are of one structure.",
            ko: "{survey} 조사의 {direction} 실측 고유진동수는 {measured}, 해석 모델은 {computed}이다. 계측 오차가 커서 모델이 실제와 맞는지 판단할 수 없다.",
        },
        Superseded { survey: String, measured: Quantity, direction: Both, computed: Quantity, later: String } => {
            en: "Survey {survey} measured {measured} in direction {direction}; this model has {computed}, which survey {later} decides. «`dolmen compare`|The comparison of two surveys» says what changed between them.",
            ko: "{survey} 조사의 {direction} 실측 고유진동수는 {measured}, 해석 모델은 {computed}이다. 판정은 이후의 {later} 조사에 따른다. 두 조사 사이의 변화는 «`dolmen compare`|조사 비교»로 본다.",
        },
        OtherDirection { survey: String, measured: Quantity, direction: String, known: Vec<String> } => {
            en: "Survey {survey} measured {measured} in direction {direction}, which this model does not have: it is not compared. The directions of the model: {known}.",
            ko: "{survey} 조사의 실측 고유진동수 {measured}은(는) 모델에 없는 {direction} 방향의 값이어서 비교하지 않았다. 모델의 방향: {known}.",
        },
        LogsUnread(logs: Vec<Both>) => {
            en: "What loggers read of tilts and cracks is not in this answer ({logs}): «`dolmen watch`|the review of all surveys» holds it against its limits. If they show a lean, write it as the tilt of a survey.",
            ko: "기울기·균열 계측 기록({logs})은 이 검토에 반영하지 않았다. 한계와의 비교는 «`dolmen watch`|장기 변화 검토»에 나온다. 기울기가 나타나면 조사의 «tilt로|기울기로» 입력한다.",
        },
        YearsNotAsked(surveys: usize) => {
            en: "Whether an alarm is open over the years is not asked here; surveys with a date: {surveys}. «`dolmen watch`|The review of all surveys» and «`dolmen report`|the report» say so.",
            ko: "여러 해의 조사에서 조치되지 않은 경보가 있는지는 이 검토에서 다루지 않는다(날짜가 있는 조사 {surveys}회). «`dolmen watch`와 `dolmen report`|장기 변화 검토와 보고서»에 나온다.",
        },
        Likely { contradicted: Sentence, likely: Sentence } => { en: "{contradicted} {likely}", ko: "{contradicted} {likely}" },
        Contradicted { survey: String, measured: Quantity, direction: Both, computed: Quantity } => {
            en: "Survey {survey} measured {measured} in direction {direction}; this model has {computed}. Its stiffness or mass is not that of the structure measured, and the verdict is on the model.",
            ko: "{survey} 조사의 {direction} 실측 고유진동수는 {measured}이나 해석 모델은 {computed}이다. 모델의 강성 또는 질량이 실제와 다르며, 판정은 모델에 대한 것이다.",
        },
    }
}

/// Findings from all surveys about the model.
pub(super) fn measured(project: &Project, state: &State) -> Vec<Finding> {
    let leans = matches!(&project.structure, Structure::Frame(part) if part.lean.is_some());
    let contradictions = state.contradictions.iter().map(contradiction);
    let checked = state.tilts.iter().filter(|of| !is_unchecked(of, &state.check));
    let tilts = checked.map(|of| tilt(of, &state.check, leans));
    contradictions.chain(tilts).chain(unchecked(state)).collect()
}

/// Whether the limit of the lean of a chain or stack is unknown.
fn is_unchecked(of: &TiltCheck, check: &Check) -> bool {
    of.uplift_tilt.is_none() && matches!(check, Check::Chain(_) | Check::Stack(_))
}

/// The unchecked tilts of each survey, all directions in one finding.
fn unchecked(state: &State) -> Vec<Finding> {
    let of_all = state.tilts.iter().filter(|of| is_unchecked(of, &state.check));
    let mut by_survey: Vec<(String, Vec<Sentence>)> = Vec::new();
    for of in of_all {
        let along = Measured::TiltAlong {
            tilt: one_in(of.tilt),
            direction: of.direction.clone(),
        };
        match by_survey.iter_mut().find(|(survey, _)| *survey == of.survey) {
            Some((_, tilts)) => tilts.push(along.into()),
            None => by_survey.push((of.survey.clone(), vec![along.into()])),
        }
    }
    let said = |(survey, tilts)| Finding::key(Tone::Unknown, Measured::TiltUnchecked { tilts, survey });
    by_survey.into_iter().map(said).collect()
}

/// A measured tilt compared with the limit in the file.
pub(super) fn against_its_limit(project: &Project) -> Option<Finding> {
    let found = tilt_against_limit(project)?;
    let (tilt, limit) = (one_in(found.tilt), one_in(found.limit));
    let survey = found.survey.clone();
    Some(match (found.is_beyond(), found.is_near()) {
        (true, _) => Finding::key(Tone::Bad, Measured::BeyondItsLimit { tilt, limit, survey }),
        (false, true) => Finding::key(Tone::Warn, Measured::NearItsLimit { tilt, limit, survey }),
        (false, false) => Finding::new(Tone::Good, Measured::WithinItsLimit { tilt, limit, survey }),
    })
}

/// Surveys without a date among dated ones, if they contain data that the last survey decides.
pub(super) fn undated(project: &Project) -> Option<Finding> {
    let (dated, undated): (Vec<&Survey>, Vec<&Survey>) = project
        .surveys
        .iter()
        .partition(|survey| date_of(&survey.name).is_some());
    let counts = |survey: &&&Survey| {
        let has_records = survey.records.is_some() || !survey.setups.is_empty();
        // assumed frequencies are not measured
        let mut modes = survey.modes.values().flatten();
        let has_modes = modes.any(|mode| !mode.frequency.is_assumed());
        has_records || has_modes || !survey.tilt.is_empty() || !survey.inspections.is_empty()
    };
    let surveys: Vec<String> = undated
        .iter()
        .filter(counts)
        .map(|survey| survey.name.clone())
        .collect();
    let is_beside = !dated.is_empty() && !surveys.is_empty();
    is_beside.then(|| Finding::key(Tone::Warn, Measured::Undated(surveys)))
}

/// A measured tilt beyond the drift at which storeys are judged, or at which free-standing columns fall in a model that starts plumb.
pub(super) fn against_drift(project: &Project) -> Vec<Finding> {
    let columns = match &project.structure {
        // its lean is in its check
        Structure::Frame(part) if part.lean.is_some() => None,
        Structure::Frame(part) => {
            let storeys = part.storeys.iter();
            let each = storeys.filter_map(|storey| {
                let foot = storey.columns.as_ref()?.foot.width();
                Some(foot.value / storey.height.value)
            });
            each.reduce(f64::min)
        }
        Structure::Building(_) => None,
        _ => return Vec::new(),
    };
    let Some((survey, tilt)) = last_tilt(project) else {
        return Vec::new();
    };
    let (survey, said_tilt) = (survey.name.clone(), || one_in(tilt));
    let limit = project.drift_limit.as_ref().map(DriftLimit::ratio);
    let leans = matches!(&project.structure, Structure::Frame(part) if part.lean.is_some());
    let drift = limit.filter(|limit| tilt >= *limit).map(|limit| {
        let (survey, tilt, limit) = (survey.clone(), said_tilt(), one_in(limit));
        match leans {
            true => Measured::BeyondDriftAtRest { survey, tilt, limit },
            false => Measured::BeyondDrift { survey, tilt, limit },
        }
    });
    let columns = columns.filter(|limit| tilt > *limit).map(|limit| {
        let (survey, tilt, limit) = (survey.clone(), said_tilt(), one_in(limit));
        Measured::BeyondColumns { survey, tilt, limit }
    });
    let all = columns.into_iter().chain(drift);
    all.map(|said| Finding::key(Tone::Bad, said)).collect()
}

/// A measured tilt beyond its limit, before any shaking.
pub(crate) fn tilt_beyond(project: &Project) -> Vec<Finding> {
    let all = against_its_limit(project)
        .into_iter()
        .chain(against_drift(project));
    all.filter(|finding| finding.tone == Tone::Bad).collect()
}

/// Severe damage that is not in the model: for each part, from the last survey that lists it.
pub(super) fn severe_damage(project: &Project) -> Vec<Finding> {
    let left_out = SevereDamage::left_out(project);
    let each = left_out.chunk_by(|a, b| a.survey == b.survey).map(|of_survey| {
        let found = of_survey.iter().map(|one| {
            let (part, what) = (one.part.clone(), damage_words(&one.what));
            Measured::Damaged { part, what }.into()
        });
        let survey = of_survey
            .first()
            .map(|one| one.survey.clone())
            .unwrap_or_default();
        let found = found.collect();
        Finding::key(Tone::Warn, Measured::SevereDamage { survey, found })
    });
    each.collect()
}

/// Findings over the years that this answer does not contain.
pub(crate) fn over_the_years(project: &Project) -> Vec<Finding> {
    let logs = project.watch.logs.iter();
    let logs = logs.filter(|log| log.kind != LogKind::Temperature);
    let logs: Vec<Both> = logs.map(|log| log.name.as_str().into()).collect();
    let mut all = Vec::new();
    if !logs.is_empty() {
        all.push(Finding::key(Tone::Unknown, Measured::LogsUnread(logs)));
    } else if can_watch(project) {
        let dated = project
            .surveys
            .iter()
            .filter(|survey| date_of(&survey.name).is_some());
        let surveys = dated.count();
        all.push(Finding::key(Tone::Plain, Measured::YearsNotAsked(surveys)));
    }
    all
}

/// Earthquakes stated in surveys without a later inspection; the verbs that read records find those in them.
pub(super) fn felt_since(project: &Project) -> Vec<Finding> {
    let open = felt(project, |_| None).into_iter().filter(|of| !of.is_answered);
    let said = open.map(|of| {
        let peak = of.part.peak_m_s2.map_or(Measured::FeltOnly, |peak| {
            Measured::FeltPeak(Quantity::new(peak, Unit::si("m/s²"), Digits::Significant(DIGITS)))
        });
        let (survey, peak) = (of.survey, peak.into());
        Finding::key(Tone::Warn, Measured::Felt { survey, peak }).with_code("earthquake")
    });
    said.collect()
}

/// Measured frequencies in directions that the model does not have.
pub(super) fn other_directions(project: &Project, check: &Check) -> Vec<Finding> {
    let known: Vec<String> = match check {
        Check::Chain(chain) if chain.across.is_some() => ["x", "y"].map(str::to_owned).to_vec(),
        // a chain is the same in all directions
        Check::Chain(_) => return Vec::new(),
        Check::Frame(all) => all.iter().map(|of| of.direction.clone()).collect(),
        Check::Stack(_) | Check::Building(_) => ["x", "y", "torsion"].map(str::to_owned).to_vec(),
    };
    let each = project
        .surveys
        .iter()
        .flat_map(|survey| survey.modes.iter().map(move |of| (survey, of)));
    let each = each.filter(|(_, (direction, _))| !known.contains(direction));
    let found = each.filter_map(|(survey, (direction, modes))| {
        let said = Measured::OtherDirection {
            survey: survey.name.clone(),
            measured: hertz(lowest_measured(modes)?.frequency.value),
            direction: direction.clone(),
            known: known.clone(),
        };
        Some(Finding::key(Tone::Unknown, said))
    });
    found.collect()
}

fn hertz(value: f64) -> Quantity {
    Quantity::new(value, Unit::si("Hz"), Digits::Significant(4))
}

fn one_in(ratio: f64) -> Sentence {
    let inverse = Quantity::ratio(1.0 / ratio.abs(), DIGITS);
    Measured::OneIn(inverse).into()
}

fn tilt(of: &TiltCheck, check: &Check, leans: bool) -> Finding {
    let (tilt, direction, survey) = (one_in(of.tilt), of.direction.clone(), of.survey.clone());
    let Some(uplift) = of.uplift_tilt else {
        let said = match leans {
            true => Measured::TiltUnheld {
                tilt,
                direction,
                survey,
            },
            false => Measured::TiltUnused {
                tilt,
                direction,
                survey,
            },
        };
        return Finding::key(Tone::Warn, said);
    };
    let limit = one_in(uplift);
    if let Check::Frame(_) = check {
        return frame_tilt(of, limit);
    }
    let opens = of.opens_tilt.unwrap_or(TiltCheck::OPENS * uplift);
    match of.verdict() {
        Verdict::Unstable => Finding::key(
            Tone::Bad,
            Measured::TiltOverturns {
                tilt,
                direction,
                survey,
                limit,
            },
        ),
        // a date alone does not bring it into a model without a lean, such as one on several stones
        _ if matches!(check, Check::Stack(_)) && date_of(&survey).is_some() => Finding::key(
            Tone::Warn,
            Measured::TiltNotTaken {
                tilt,
                direction,
                survey,
                limit,
            },
        ),
        _ if matches!(check, Check::Stack(_)) => Finding::key(
            Tone::Warn,
            Measured::TiltNotInModel {
                tilt,
                direction,
                survey,
                limit,
            },
        ),
        // towards a corner, a bed opens at less than a third of the limit
        verdict if (opens / (TiltCheck::OPENS * uplift) - 1.0).abs() > ROUNDING => {
            let opened = of.tilt.abs() >= opens;
            let opens = one_in(opens);
            let said = match opened {
                true => Measured::TiltOpensFrom {
                    tilt,
                    direction,
                    survey,
                    limit,
                    opens,
                },
                false => Measured::TiltHoldsFrom {
                    tilt,
                    direction,
                    survey,
                    limit,
                    opens,
                },
            };
            Finding::key(Tone::of(verdict), said)
        }
        verdict if of.tilt.abs() >= TiltCheck::OPENS * uplift => Finding::key(
            Tone::of(verdict),
            Measured::TiltOpens {
                tilt,
                direction,
                survey,
                limit,
            },
        ),
        verdict => Finding::key(
            Tone::of(verdict),
            Measured::TiltHolds {
                tilt,
                direction,
                survey,
                limit,
            },
        ),
    }
}

/// The tilt of a frame compared with that at which it falls.
fn frame_tilt(of: &TiltCheck, limit: Sentence) -> Finding {
    let (tilt, direction, survey) = (one_in(of.tilt), of.direction.clone(), of.survey.clone());
    let verdict = of.verdict();
    let said = match verdict {
        Verdict::Unstable => Measured::FrameFalls {
            tilt,
            direction,
            survey,
            limit,
        },
        _ => Measured::FrameHolds {
            tilt,
            direction,
            survey,
            limit,
        },
    };
    let tone = match verdict {
        Verdict::Stable => Tone::Plain,
        verdict => Tone::of(verdict),
    };
    Finding::key(tone, said)
}

fn contradiction(found: &FrequencyContradiction) -> Finding {
    let (survey, direction) = (found.survey.clone(), direction_words(&found.direction));
    let (measured, computed) = (hertz(found.measured_hz), hertz(found.computed_hz));
    if let Some(later) = found.superseded_by.clone() {
        let said = Measured::Superseded {
            survey,
            measured,
            direction,
            computed,
            later,
        };
        return Finding::new(Tone::Plain, said);
    }
    if found.is_too_rough {
        let said = Measured::Rough {
            survey,
            measured,
            direction,
            computed,
        };
        return Finding::key(Tone::Unknown, said);
    }
    let contradicted = Measured::Contradicted {
        survey,
        measured,
        direction,
        computed,
    };
    match found.likely() {
        None => Finding::key(Tone::Bad, contradicted),
        Some(likely) => {
            let (contradicted, likely) = (contradicted.into(), likely.into());
            Finding::key(Tone::Bad, Measured::Likely { contradicted, likely })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_words::Language;

    #[test]
    fn holds_a_tilt_beyond_the_limit_is_bad_and_one_that_is_not_used_amber() {
        let found = |ratio: f64, uplift_tilt, leans| {
            let of = TiltCheck {
                survey: "s".into(),
                direction: "x".into(),
                tilt: ratio,
                uplift_tilt,
                opens_tilt: None,
            };
            tilt(&of, &Check::Frame(Vec::new()), leans)
        };
        let of = |ratio: f64, uplift_tilt| found(ratio, uplift_tilt, true);
        let beyond = of(0.2, Some(0.1));
        let said = beyond.sentence.text(Language::English);
        assert!(
            beyond.tone == Tone::Bad && said.contains("1/5.00") && said.contains("1/10.0"),
            "{said}"
        );
        assert_eq!(of(0.2, None).tone, Tone::Warn);
        // a tilt in the model is not left out
        for (leans, said) in [(true, "leans the model"), (false, "is not used")] {
            let words = found(0.01, None, leans).sentence.text(Language::English);
            assert!(words.contains(said), "{words}");
        }
        assert_eq!(of(-0.001, Some(0.1)).tone, Tone::Plain);
        let holds = of(0.05, Some(0.1)).sentence.text(Language::English);
        assert!(holds.contains("counts as fallen from 1/10"), "{holds}");
    }
}
