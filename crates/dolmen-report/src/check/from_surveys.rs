//! Stiffness identified from the surveys of the file: the result, before any answer that depends on it.

use crate::document::{Finding, TextStyle, Tone, wrapped};
use dolmen_project::{FromSurvey, FromSurveys, Project, Quantity as Input, StudyPart, WhyNotIdentified};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};

messages! {
    /// Stiffness from surveys.
    pub(crate) enum Identified in "check.from_surveys" {
        One { part: Sentence, survey: String, values: Values } => {
            en: "{part} is identified from survey {survey}, by the one solution that explains its modes: {values}.",
            ko: "{part}은(는) {survey} 조사의 모드를 설명하는 하나뿐인 해로 정하였다: {values}.",
        },
        OneUnchecked { part: Sentence, survey: String, values: Values } => {
            en: "{part} is identified from survey {survey}: {values}. Nothing checks it: as many unknowns as frequencies always fit.",
            ko: "{part}은 {survey} 조사에서 정하였다: {values}. 미지수만큼의 고유진동수에는 언제나 맞으므로 검증된 값이 아니다.",
        },
        Worst { part: Sentence, survey: String, number: usize, of: usize, values: Values } => {
            en: "{part} is identified from survey {survey}, which {of} solutions explain. What follows rests on solution {number}, of all the one that a check judges worst: {values}. The others stand beside it as variants; «`dolmen identify`|the identification from vibration» says which measurement tells them apart.",
            ko: "{part}은(는) {survey} 조사에서 정하였으나 이를 설명하는 해가 {of}개이다. 아래 결과는 검토에서 가장 불리한 해 {number}의 것이다: {values}. 나머지 해는 대안으로 함께 검토하며, 어떤 계측으로 가릴 수 있는지는 «`dolmen identify`|진동 평가»가 보인다.",
        },
        OfOther { part: Sentence, survey: String, number: usize, of: usize, values: Values } => {
            en: "{part} is that of solution {number} of the {of} that explain survey {survey}: {values}.",
            ko: "{part}은(는) {survey} 조사를 설명하는 해 {of}개 중 해 {number}의 값이다: {values}.",
        },
        NotKnown { part: Sentence, why: Sentence } => {
            en: "{part} was to be identified and stays unknown: {why}.",
            ko: "{part}은(는) 조사에서 구하게 되어 있으나 정해지지 않는다: {why}.",
        },
        Joints => { en: "The stiffness of the joints", ko: "접합부 강성" },
        Direction(direction: String) => {
            en: "The stiffness in direction {direction}",
            ko: "{direction} 방향의 강성",
        },
        NoSurvey => {
            en: "no survey of the file has records or frequencies«; add [survey.DATE]»",
            ko: "기록이나 고유진동수가 있는 조사가 파일에 없다«. [survey.날짜]를 추가한다»",
        },
        NoModes(survey: String) => {
            en: "survey {survey} shows no modes there; give its frequencies, or position and direction of its channels",
            ko: "{survey} 조사에 해당 모드가 없다. 고유진동수를 쓰거나 채널의 위치와 방향을 준다",
        },
        Bounded(survey: String) => {
            en: "survey {survey} tells it between wide bounds alone; «`dolmen identify`|the identification from vibration» prints them",
            ko: "{survey} 조사로는 넓은 한계만 알 수 있다. 한계는 «`dolmen identify`|진동 평가»가 출력한다",
        },
        Underdetermined(survey: String) => {
            en: "survey {survey} has fewer modes than there are unknowns",
            ko: "{survey} 조사의 모드 수가 미지수보다 적다",
        },
        Meet(survey: String) => {
            en: "two solutions for survey {survey} meet, so that none has a standard deviation; measure mode shapes",
            ko: "{survey} 조사의 두 해가 만나므로 표준편차를 알 수 없다. 모드형상을 계측한다",
        },
        Impossible(survey: String) => {
            en: "no stiffness explains the modes of survey {survey}",
            ko: "{survey} 조사의 모드를 설명하는 강성이 없다",
        },
        Doubted(survey: String) => {
            en: "the modes of survey {survey} are in doubt; «`dolmen identify`|the identification from vibration» says why",
            ko: "{survey} 조사의 모드가 의심스럽다. 까닭은 «`dolmen identify`|진동 평가»가 보인다",
        },
        TooMany(solutions: usize) => {
            en: "{solutions} solutions explain the modes, too many to judge each; measure mode shapes",
            ko: "모드를 설명하는 해가 {solutions}개로 너무 많아 모두 검토할 수 없다. 모드형상을 계측한다",
        },
    }
}

/// The result for the stiffness that a project identifies from its surveys.
pub(super) fn findings(project: &Project) -> Vec<Finding> {
    let Some(told) = &project.from_surveys else {
        return Vec::new();
    };
    let tone = |part: &FromSurvey| match (part.unknown, told.of) {
        (Some(_), _) => Tone::Unknown,
        (None, 1) if part.is_unchecked => Tone::Unknown,
        (None, 1) => Tone::Plain,
        (None, _) => Tone::Warn,
    };
    let each = told.parts.iter().filter(|part| uses(project, part));
    each.map(|part| Finding::key(tone(part), said(project, told, part)).with_code("indistinguishable"))
        .map(|finding| match finding.tone {
            Tone::Warn => finding,
            _ => Finding {
                code: None,
                ..finding
            },
        })
        .collect()
}

/// Whether the structure has the stiffness of a survey, or would if it were known; a variant may have its own.
fn uses(project: &Project, part: &FromSurvey) -> bool {
    match part.unknown {
        Some(_) => project
            .structure
            .sought()
            .iter()
            .any(|(path, _)| *path == part.path),
        None => !identified(project, &part.path).is_empty(),
    }
}

/// The same above studies: of the structures that their runs have, each sentence once.
pub(crate) fn from_surveys_of_studies(project: &Project, studies: &[&StudyPart], style: TextStyle) -> String {
    let mut said: Vec<String> = Vec::new();
    for study in studies {
        let variants = project.variants.iter();
        let own = variants.filter(|variant| study.variants.contains(&variant.name));
        let mut versions: Vec<&Project> = own.map(|variant| &variant.project).collect();
        if study.variants.is_empty() {
            versions.push(project);
        }
        let is_set = |path: &str| study.set.iter().any(|set| set.path == path);
        for version in versions {
            let mut version = version.clone();
            if let Some(told) = &mut version.from_surveys {
                told.parts.retain(|part| !is_set(&part.path));
            }
            let text = from_surveys_text(&version, style);
            if !said.contains(&text) {
                said.push(text);
            }
        }
    }
    said.concat()
}

/// The same on a terminal, above an answer.
pub(crate) fn from_surveys_text(project: &Project, style: TextStyle) -> String {
    let found = findings(project).into_iter();
    found
        .map(|of| wrapped(&of.sentence.text(style.language), "  ", "    ", style.columns()))
        .collect()
}

fn said(project: &Project, told: &FromSurveys, part: &FromSurvey) -> Identified {
    let name = Sentence::from(match part.path.strip_prefix("direction.") {
        Some(rest) => Identified::Direction(rest.trim_end_matches(".stiffness").to_owned()),
        None => Identified::Joints,
    });
    let survey = part.survey.clone().unwrap_or_default();
    if let Some(why) = part.unknown {
        let why = Sentence::from(not_known(why, survey));
        return Identified::NotKnown { part: name, why };
    }
    let values = values(project, &part.path);
    match (told.of, told.number) {
        (1, _) if part.is_unchecked => Identified::OneUnchecked {
            part: name,
            survey,
            values,
        },
        (1, _) => Identified::One {
            part: name,
            survey,
            values,
        },
        (of, number) if project.variants.is_empty() => Identified::OfOther {
            part: name,
            survey,
            number,
            of,
            values,
        },
        (of, number) => Identified::Worst {
            part: name,
            survey,
            number,
            of,
            values,
        },
    }
}

fn not_known(why: WhyNotIdentified, survey: String) -> Identified {
    match why {
        WhyNotIdentified::NoSurvey => Identified::NoSurvey,
        WhyNotIdentified::NoModes => Identified::NoModes(survey),
        WhyNotIdentified::Bounded => Identified::Bounded(survey),
        WhyNotIdentified::Underdetermined => Identified::Underdetermined(survey),
        WhyNotIdentified::Meet => Identified::Meet(survey),
        WhyNotIdentified::Impossible => Identified::Impossible(survey),
        WhyNotIdentified::Doubted => Identified::Doubted(survey),
        WhyNotIdentified::TooMany { solutions } => Identified::TooMany(solutions),
    }
}

/// The identified inputs below a path.
fn identified<'a>(project: &'a Project, path: &str) -> Vec<&'a Input> {
    let mut own = project.structure.inputs();
    own.retain(|input| input.path.starts_with(&format!("{path}[")) && input.survey.is_some());
    own
}

/// The values below a path, lowest first, with their deviations.
fn values(project: &Project, path: &str) -> Values {
    let own = identified(project, path);
    let numbers: Vec<f64> = own.iter().map(|input| input.value).collect();
    let si = match path {
        "joints" => "N·m/rad",
        _ => "N/m",
    };
    let unit = Unit::of(&numbers, si);
    let quantity = |input: &&Input| {
        let sd = input.standard_deviation();
        Quantity {
            sd_si: Some(sd).filter(|sd| *sd > 0.0),
            ..Quantity::new(input.value, unit.clone(), Digits::Significant(4))
        }
    };
    Values(own.iter().map(quantity).collect())
}
