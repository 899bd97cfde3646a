//! Findings on stiffness from vibration.

use super::beside;
use super::columns;
use super::doubted;
use super::joints;
use super::left_out::left_out;
use super::notes::stiffness_note;
use super::place::{is_asked, place};
use super::plan;
use super::plan_centre::Centre;
use super::solutions::stiffness_quantities;
use super::words::{Words, counted};
use crate::document::{Finding, Tone};
use crate::simulated::kilo;
use dolmen::structure::{Choice, LeftOut, StiffnessNote};
use dolmen_project::{Project, Quantity as Input, Structure, date_of};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::surveyed::{StiffnessAnswer, StiffnessDoubt, SurveyAnswer, WithoutStiffness};

messages! {
    /// Findings on stiffness from vibration.
    pub(crate) enum Found in "identification.findings" {
        WithLoads(weight: Quantity) => {
            en: "What hangs there, {weight} of static loads, was taken to hang there in every survey, and swings along.",
            ko: "모든 조사에서 정하중 {weight}이(가) 매달려 함께 진동한 것으로 보았다.",
        },
        NoPlace => {
            en: "No stiffness is sought: no channel has both a position and a direction; give both to those that stand on the structure.",
            ko: "위치와 방향이 모두 주어진 채널이 없어 강성을 추정하지 않았다. 구조물 위의 채널에 둘 다 주어야 한다.",
        },
        AllTwist(direction: String) => {
            en: "No stiffness is sought in direction {direction}: every mode measured there twists. Check their kind; the lowest mode of translation gives the stiffness.",
            ko: "{direction} 방향에서 계측된 모드가 모두 비틀림 모드여서 강성을 추정하지 않았다. 모드의 kind를 확인해야 하며, 강성은 최저 병진 모드에서 구한다.",
        },
        OnColumnsAlone(direction: String) => {
            en: "No stiffness is sought in direction {direction}: the file gives 0, so that nothing but the beds of its columns holds it, and they give its frequency.« Write stiffness = \"unknown\" where joints may hold it.»",
            ko: "{direction} 방향은 파일의 «stiffness가|층강성이» 0으로, 기둥의 지압면만으로 지지되어 고유진동수가 정해지므로 강성을 추정하지 않았다.« 접합부가 지지할 수 있으면 stiffness = \"unknown\"으로 쓴다.»",
        },
        OffTheAxes(channels: Vec<String>) => {
            en: "No stiffness is sought: no sensor points within 15° of x or y ({channels} do not); turn the axes of the project with the sensors, or give the direction in which each measures.",
            ko: "x 또는 y축에서 15° 이내를 향하는 센서가 없어({channels}) 강성을 추정하지 않았다. 프로젝트의 축을 센서에 맞추어 돌리거나 각 센서의 계측 방향을 주어야 한다.",
        },
        Of { survey: String, place: Sentence, said: Sentence } => {
            en: "Stiffness from vibration (survey {survey}, {place}): {said}",
            ko: "진동으로 추정한 강성({survey} 조사, {place}): {said}",
        },
        PeaksBelow(peaks: Values) => {
            en: "not chosen: the record has a peak at {peaks} below the modes used that is none of them. If it is a mode of this direction, every stiffness is wrong.",
            ko: "판정하지 않는다. 사용한 모드 아래 {peaks}에 모드로 찾지 않은 피크가 있으며, 이것이 이 방향의 모드이면 모든 강성이 틀리게 된다.",
        },
        One { measured: Sentence, values: Values } => {
            en: "one solution explains {measured}; k, the lowest first: {values}.",
            ko: "{measured}을(를) 설명하는 해는 하나이다. 강성 k는 아래부터 {values}이다.",
        },
        OneUnchecked { measured: Sentence, values: Values } => {
            en: "one solution explains {measured}, and nothing checks it: with as many unknown stiffnesses as frequencies it fits whatever the structure is. k, the lowest first: {values}. A measured mode shape would check it.",
            ko: "{measured}을(를) 설명하는 해는 하나이나 검증되지 않았다. 미지 강성의 수가 고유진동수의 수와 같아 구조물이 실제로 어떻든 맞는 해가 나온다. 강성 k는 아래부터 {values}이다. 모드형상을 계측하면 검증할 수 있다.",
        },
        Bounded(measured: Sentence) => {
            en: "one solution explains {measured}, but some of its stiffness is known only between bounds or from one side: no single answer.",
            ko: "{measured}을(를) 설명하는 해는 하나이나, 일부 강성은 한쪽 한계나 넓은 범위로만 정해지므로 단일한 답이 아니다.",
        },
        Meet => {
            en: "two solutions meet here and cannot be told apart without a measured shape; none is preferred here.",
            ko: "두 해가 여기서 만나므로 계측 모드형상 없이는 구별할 수 없으며, 여기서는 어느 것도 택하지 않는다.",
        },
        Indistinguishable { solutions: usize, measured: Sentence } => {
            en: "{solutions} different solutions explain {measured} equally well. They cannot be told apart without a measured shape; none is preferred here.",
            ko: "서로 다른 해 {solutions}개가 {measured}을(를) 똑같이 잘 설명한다. 계측 모드형상 없이는 구별할 수 없으며, 여기서는 어느 것도 택하지 않는다.",
        },
        Underdetermined { modes: usize, free: usize } => {
            en: "not determined. Measured modes: {modes}; combinations of the stiffness that stay free: {free}; any solution shown is one of the many possible. Measure higher modes, or mode shapes.",
            ko: "계측 모드 {modes}개로는 강성을 모두 정할 수 없다(정해지지 않는 강성 조합 {free}개). 제시한 해는 가능한 수많은 해 가운데 하나일 뿐이다. 더 높은 모드나 모드형상을 계측한다.",
        },
        UnderdeterminedSomehow(modes: usize) => {
            en: "not determined. Measured modes: {modes}; some combinations of the stiffness stay free; any solution shown is one of the many possible. Measure higher modes, or mode shapes.",
            ko: "계측 모드 {modes}개로는 강성을 모두 정할 수 없다. 제시한 해는 가능한 수많은 해 가운데 하나일 뿐이다. 더 높은 모드나 모드형상을 계측한다.",
        },
        Impossible { modes: usize, why: Sentence } => {
            en: "no real stiffness explains the measured modes ({modes}). {why}",
            ko: "계측 모드 {modes}개를 설명하는 실수 강성이 없다. {why}",
        },
        ImpossibleSomehow(modes: usize) => {
            en: "no real stiffness explains the measured modes ({modes}).",
            ko: "계측 모드 {modes}개를 설명하는 실수 강성이 없다.",
        },
        EarlierOne { latest: String } => {
            en: "Stiffness from vibration is summed up for survey {latest} alone; 1 other survey gives one too.",
            ko: "진동으로 추정한 강성은 {latest} 조사의 것만 요약하였다. 강성을 추정한 다른 조사가 1건 더 있다.",
        },
        Earlier { earlier: usize, latest: String } => {
            en: "Stiffness from vibration is summed up for survey {latest} alone; {earlier} other surveys give one too.",
            ko: "진동으로 추정한 강성은 {latest} 조사의 것만 요약하였다. 강성을 추정한 다른 조사가 {earlier}건 더 있다.",
        },
        OfSurveys { surveys: Vec<String>, said: Sentence } => {
            en: "Survey {surveys}: {said}",
            ko: "{surveys} 조사: {said}",
        },
        Then { first: Sentence, then: Sentence } => { en: "{first} {then}", ko: "{first} {then}" },
    }
}

/// The choice of each survey, and the reasons why some give no stiffness.
///
/// Springs of the other convention are compared in the appendix, without alarm.
pub(crate) fn findings(project: &Project, all: &[SurveyAnswer]) -> Vec<Finding> {
    let every: Vec<&SurveyAnswer> = all.iter().collect();
    let mut found = found(project, all, &every);
    found.extend(of_other_springs(project, all));
    found
}

/// The same for the summary of a report: only the latest survey that gives a stiffness.
pub(crate) fn findings_of_latest(project: &Project, all: &[SurveyAnswer]) -> Vec<Finding> {
    let gives = |of: &&SurveyAnswer| !of.stiffness.is_empty() || of.plan.is_some() || of.factors.is_some();
    let giving: Vec<&SurveyAnswer> = all.iter().filter(gives).collect();
    let latest = giving.iter().copied().max_by_key(|of| date_of(&of.name));
    let mut found = found(project, all, latest.as_slice());
    if let Some(latest) = latest.filter(|_| giving.len() > 1) {
        let name = latest.name.clone();
        let said = match giving.len() - 1 {
            1 => Found::EarlierOne { latest: name },
            earlier => Found::Earlier {
                earlier,
                latest: name,
            },
        };
        found.push(Finding::new(Tone::Plain, said));
    }
    found
}

fn found(project: &Project, all: &[SurveyAnswer], shown: &[&SurveyAnswer]) -> Vec<Finding> {
    let each = || {
        let each = shown.iter().copied();
        each.flat_map(|survey| survey.stiffness.iter().map(move |answer| (survey, answer)))
    };
    let own = each().filter(|(_, answer)| is_asked(project, answer));
    let own = own.map(|(survey, answer)| choice(&survey.name, answer));
    let soil = |direction: &str| match &project.structure {
        Structure::Chain(part) => part.soil_towards(part.axis_of(direction), &mut Input::nominal),
        _ => None,
    };
    let beds = each().filter_map(|(survey, answer)| {
        let lowest = answer
            .solutions
            .solutions
            .first()
            .filter(|_| answer.is_chosen())?;
        Some(crate::chain::identified(
            &soil(&answer.direction)?,
            &survey.name,
            *lowest.stiffness.first()?,
        ))
    });
    let in_plan = shown
        .iter()
        .filter_map(|survey| Some((survey, survey.plan.as_ref()?)));
    let in_plan = in_plan.flat_map(|(survey, answer)| plan::findings(&survey.name, answer));
    let joint_by_joint = shown
        .iter()
        .filter_map(|survey| Some((survey, survey.factors.as_ref()?)));
    let joint_by_joint = joint_by_joint.flat_map(|(survey, answer)| joints::findings(&survey.name, answer));
    let hangs = match &project.structure {
        Structure::Chain(_) | Structure::Frame(_) => project.loads.weight_n(&mut Input::nominal),
        _ => 0.0,
    };
    let hangs = (hangs != 0.0 && each().next().is_some()).then(|| {
        let weight = Quantity::new(hangs, kilo("N"), Digits::Significant(3));
        Finding::key(Tone::Plain, Found::WithLoads(weight))
    });
    let turns = each().filter(|(_, answer)| is_asked(project, answer));
    let turns = turns.flat_map(|(_, answer)| turning(answer));
    // faults of the sensors come before the resulting stiffness
    let sensors = all.iter().filter_map(doubted::finding);
    let beside = shown.iter().flat_map(|survey| beside::findings(survey));
    let apart = all.iter().flat_map(columns::findings);
    sensors
        .chain(apart)
        .chain(turns)
        .chain(own)
        .chain(hangs)
        .chain(beside)
        .chain(beds)
        .chain(in_plan)
        .chain(joint_by_joint)
        .chain(unsought(all))
        .collect()
}

/// Modes of torsion that were left out of a direction.
fn turning(answer: &StiffnessAnswer) -> impl Iterator<Item = Finding> {
    let notes = answer.solutions.notes.iter();
    notes.filter_map(|note| match note {
        StiffnessNote::LeftOut(why @ LeftOut::Turns { .. }) => Some(Finding::key(Tone::Plain, left_out(why))),
        _ => None,
    })
}

/// The stiffness of the other convention.
fn of_other_springs(project: &Project, all: &[SurveyAnswer]) -> Vec<Finding> {
    let each = all
        .iter()
        .flat_map(|survey| survey.stiffness.iter().map(move |answer| (survey, answer)));
    let others = each.filter(|(_, answer)| !is_asked(project, answer));
    let others = others.map(|(survey, answer)| Finding {
        tone: Tone::Plain,
        is_key: false,
        ..choice(&survey.name, answer)
    });
    others.collect()
}

/// Reasons why surveys give no stiffness; surveys with the same reason share one.
fn unsought(all: &[SurveyAnswer]) -> Vec<Finding> {
    let mut reasons: Vec<(&WithoutStiffness, Vec<String>)> = Vec::new();
    for survey in all {
        let Some(why) = &survey.without_stiffness else {
            continue;
        };
        match reasons.iter_mut().find(|(known, _)| *known == why) {
            Some((_, surveys)) => surveys.push(survey.name.clone()),
            None => reasons.push((why, vec![survey.name.clone()])),
        }
    }
    let each = reasons.into_iter().map(|(why, surveys)| match all.len() {
        1 => without(why),
        _ => {
            let found = without(why);
            let said = found.sentence;
            Finding {
                sentence: Found::OfSurveys { surveys, said }.into(),
                ..found
            }
        }
    });
    each.collect()
}

fn without(why: &WithoutStiffness) -> Finding {
    let said: Sentence = match why {
        WithoutStiffness::NoPlace => Found::NoPlace.into(),
        WithoutStiffness::AllTwist { direction } => Found::AllTwist(direction.clone()).into(),
        WithoutStiffness::OnColumnsAlone { direction } => Found::OnColumnsAlone(direction.clone()).into(),
        WithoutStiffness::OffTheAxes { channels } => Found::OffTheAxes(channels.clone()).into(),
        WithoutStiffness::Floors { floors } => plan::Plan::WhatFloors(*floors).into(),
        WithoutStiffness::Dampers { dampers } => plan::Plan::WhatDampers(dampers.clone()).into(),
        WithoutStiffness::SideSupportOneWay { number, stone } => joints::Joints::WhatOneWay {
            number: *number,
            stone: stone.clone(),
        }
        .into(),
        WithoutStiffness::WallsTurned => plan::Plan::WhatTurned.into(),
        WithoutStiffness::OnlyRecord => Centre::Record.into(),
        WithoutStiffness::FloorNotRigid { unexplained } => {
            let unexplained = Quantity::percent(*unexplained, 2);
            Centre::NotRigid { unexplained }.into()
        }
        WithoutStiffness::Plan(why) => plan::refused(why).into(),
        WithoutStiffness::NoStackModes { has_record: false } => joints::Joints::NoModes.into(),
        WithoutStiffness::NoStackModes { has_record: true } => joints::Joints::NoModesInRecord.into(),
        WithoutStiffness::OtherDirections { directions } => {
            joints::Joints::OtherDirections(directions.clone()).into()
        }
        WithoutStiffness::Stack(why) => joints::refused(why).into(),
    };
    Finding::key(Tone::Warn, said)
}

fn choice(survey: &str, answer: &StiffnessAnswer) -> Finding {
    let (tone, said, code): (Tone, Sentence, Option<&'static str>) = match answer.peaks_below_hz.as_slice() {
        [] => match answer.doubted {
            Some(doubt) => {
                let code = match doubt {
                    StiffnessDoubt::Sensors | StiffnessDoubt::Shapes { .. } => "sensor-slip",
                    StiffnessDoubt::MoreModes => "indistinguishable",
                    StiffnessDoubt::Machine { .. } => "harmonics",
                };
                (Tone::Warn, doubted::not_chosen(answer, doubt).into(), Some(code))
            }
            None => (tone(answer), chosen(answer).into(), code(answer.solutions.choice)),
        },
        peaks => {
            let hertz = |hz: &f64| Quantity::new(*hz, Unit::si("Hz"), Digits::Fixed(3));
            let peaks = Values(peaks.iter().map(hertz).collect());
            (Tone::Warn, Found::PeaksBelow(peaks).into(), Some("mode-missing"))
        }
    };
    let found = Found::Of {
        survey: survey.to_owned(),
        place: place(answer),
        said,
    };
    Finding {
        code,
        ..Finding::key(tone, found)
    }
}

fn tone(answer: &StiffnessAnswer) -> Tone {
    match answer.solutions.choice {
        Choice::One if answer.fits_by_construction() => Tone::Unknown,
        Choice::One => Tone::Good,
        Choice::Bounded | Choice::Indistinguishable | Choice::Underdetermined => Tone::Warn,
        Choice::Impossible => Tone::Bad,
    }
}

/// The code of the longer answer.
fn code(choice: Choice) -> Option<&'static str> {
    match choice {
        Choice::One => None,
        Choice::Bounded | Choice::Underdetermined => Some("underdetermined"),
        Choice::Indistinguishable => Some("indistinguishable"),
        Choice::Impossible => Some("no-real-root"),
    }
}

fn chosen(answer: &StiffnessAnswer) -> Found {
    let found = &answer.solutions;
    let modes = answer.frequencies_hz.len();
    let measured = measured_words(answer);
    match found.choice {
        Choice::One => {
            let values = found.solutions.first();
            let values = values.map_or_else(Vec::new, |one| stiffness_quantities(answer, one));
            let values = Values(values);
            match answer.fits_by_construction() {
                true => Found::OneUnchecked { measured, values },
                false => Found::One { measured, values },
            }
        }
        Choice::Bounded => Found::Bounded(measured),
        Choice::Indistinguishable => match found.solutions.len() {
            1 => Found::Meet,
            solutions => Found::Indistinguishable { solutions, measured },
        },
        Choice::Underdetermined => match &found.visibility {
            Some(visibility) => Found::Underdetermined {
                modes,
                free: visibility.free_directions,
            },
            None => Found::UnderdeterminedSomehow(modes),
        },
        Choice::Impossible => match all_notes(&found.notes) {
            Some(why) => Found::Impossible { modes, why },
            None => Found::ImpossibleSomehow(modes),
        },
    }
}

/// "the 2 frequencies and the measured shapes".
fn measured_words(answer: &StiffnessAnswer) -> Sentence {
    let count = answer.frequencies_hz.len();
    match answer.with_shapes {
        true => counted(
            count,
            Words::OneMeasuredWithShapes,
            Words::MeasuredWithShapes(count),
        ),
        false => counted(count, Words::OneMeasured, Words::Measured(count)),
    }
}

/// The notes in order. If no stiffness explains the modes, that note already advises to look for a wrong mode, so another note need not.
fn all_notes(notes: &[StiffnessNote]) -> Option<Sentence> {
    let none_explains = notes
        .iter()
        .any(|note| matches!(note, StiffnessNote::NoneExplains { .. }));
    let says_more =
        |note: &&StiffnessNote| !(none_explains && matches!(note, StiffnessNote::TakenAsLowest { .. }));
    let each = notes.iter().filter(says_more).map(stiffness_note);
    each.reduce(|first, then| Found::Then { first, then }.into())
}
