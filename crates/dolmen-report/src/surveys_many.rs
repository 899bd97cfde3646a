//! Many surveys in a report: one table of all, and details only of important ones.

use crate::document::{Block, Cell, Column, Document, Table, Tone};
use crate::modal;
use dolmen_project::{Project, date_of};
use dolmen_words::{Digits, Quantity, Unit, messages};
use dolmen_work::surveyed::SurveyAnswer;

/// Number of surveys from which a report details only some. Our choice: the number from which changes are sought in their history.
pub(crate) const MANY_FROM: usize = 8;

messages! {
    /// Many surveys.
    pub(crate) enum Many in "surveys.many" {
        Head => { en: "Surveys", ko: "조사" },
        Caption(surveys: usize) => {
            en: "All {surveys} surveys: temperature, tilt, and frequencies in Hz, ± standard deviation, of the records or as stated.",
            ko: "전체 조사 {surveys}회: 기온, 기울기, 고유진동수(Hz, ± 표준편차. 기록에서 구하였거나 입력한 값).",
        },
        Factor => {
            en: "Common factor: what multiplies all springs of the joints so that the stack has these frequencies.",
            ko: "공통 배율은 적층 모델의 고유진동수가 이 값이 되도록 모든 접합부 강성에 곱하는 수이다.",
        },
        Detailed(surveys: Vec<String>) => {
            en: "What follows details {surveys}: the latest survey, those on which the model rests, and those with findings of their own.« `dolmen identify --full` details all.»",
            ko: "아래에는 최근 조사, 모델의 근거가 된 조사, 따로 지적할 것이 있는 조사만 자세히 적었다: {surveys}.« 전체는 `dolmen identify --full`로 본다.»",
        },
        Survey => { en: "Survey", ko: "조사" },
        Temperature => { en: "air", ko: "기온" },
        Tilt => { en: "Tilt", ko: "기울기" },
        Modes => { en: "Frequencies", ko: "고유진동수" },
        CommonFactor => { en: "common factor", ko: "공통 배율" },
        Text(text: String) => { en: "{text}", ko: "{text}" },
    }
}

/// The surveys that a report details: all if they are few.
pub(crate) fn detailed<'a>(project: &Project, all: &'a [SurveyAnswer]) -> Vec<&'a SurveyAnswer> {
    let latest = all
        .iter()
        .filter(|survey| has_results(survey))
        .max_by_key(|survey| date_of(&survey.name));
    let behind = project.identified_from();
    let counts = |survey: &&SurveyAnswer| {
        all.len() < MANY_FROM
            || latest.is_some_and(|latest| latest.name == survey.name)
            || behind.contains(survey.name.as_str())
            || has_own_findings(survey)
    };
    all.iter().filter(counts).collect()
}

fn has_results(survey: &SurveyAnswer) -> bool {
    survey.modes().is_some()
        || !survey.stiffness.is_empty()
        || survey.plan.is_some()
        || survey.factors.is_some()
}

/// Whether its records or sensors are doubtful.
fn has_own_findings(survey: &SurveyAnswer) -> bool {
    let found = modal::findings(std::slice::from_ref(survey));
    survey.shape_doubt.is_some()
        || survey.exchanged_directions.is_some()
        || found
            .iter()
            .any(|finding| finding.is_key && matches!(finding.tone, Tone::Bad | Tone::Warn))
}

/// Whether only some are detailed, behind a table of all.
pub(crate) fn are_tabled(project: &Project, all: &[SurveyAnswer]) -> bool {
    let with_results = all.iter().filter(|survey| has_results(survey)).count();
    detailed(project, all).len() < with_results
}

/// The table of all surveys, where only some are detailed behind it.
pub(crate) fn sections<'a>(project: &Project, all: &'a [SurveyAnswer]) -> Document<'a> {
    let mut document = Document::default();
    if !are_tabled(project, all) {
        return document;
    }
    let shown = detailed(project, all);
    document.heading(Many::Head);
    document.put(Block::Table(table(project, all)));
    document.note(Many::Detailed(
        shown.iter().map(|survey| survey.name.clone()).collect(),
    ));
    document
}

fn table(project: &Project, all: &[SurveyAnswer]) -> Table {
    let has_factors = all.iter().any(|survey| survey.factors.is_some());
    let mut caption = vec![Many::Caption(all.len()).into()];
    let mut columns = vec![
        Column::words(Many::Survey),
        Column::numbers(Many::Temperature, Unit::si("°C")),
        Column::words(Many::Tilt),
        Column::words(Many::Modes),
    ];
    if has_factors {
        caption.push(Many::Factor.into());
        columns.push(Column::numbers(Many::CommonFactor, Unit::ratio()));
    }
    let row = |survey: &SurveyAnswer| {
        let mut row = cells(project, survey);
        if has_factors {
            let common = survey.factors.as_ref().map(|of| &of.found.common);
            row.push(Cell::Number(common.map(|common| Quantity {
                sd_si: Some(common.factor * common.relative_sd),
                ..Quantity::new(common.factor, Unit::ratio(), Digits::Significant(3))
            })));
        }
        row
    };
    Table {
        caption,
        columns,
        rows: all.iter().map(row).collect(),
    }
}

fn cells(project: &Project, survey: &SurveyAnswer) -> Vec<Cell> {
    let text = |text: String| {
        let text = if text.is_empty() { "–".to_owned() } else { text };
        Cell::Words(Many::Text(text).into())
    };
    let hertz = |hz: f64, sd_hz: Option<f64>| {
        let hz = Quantity {
            sd_si: sd_hz.filter(|sd| *sd > 0.0),
            ..Quantity::new(hz, Unit::si("Hz"), Digits::Significant(4))
        };
        hz.number()
    };
    let given = project.surveys.iter().find(|given| given.name == survey.name);
    let modes: Vec<String> = match survey.modes() {
        Some((modes, _)) => modes
            .modes
            .iter()
            .map(|mode| hertz(mode.frequency_hz, mode.frequency_sd_hz))
            .collect(),
        None => {
            let stated = given.into_iter().flat_map(|given| &given.modes);
            let stated =
                stated.flat_map(|(direction, modes)| modes.iter().map(move |mode| (direction, mode)));
            stated
                .map(|(direction, mode)| {
                    let frequency = &mode.frequency;
                    let sd_hz = frequency.cov.map(|_| frequency.standard_deviation());
                    format!("{direction} {}", hertz(frequency.value, sd_hz))
                })
                .collect()
        }
    };
    let tilts = given.into_iter().flat_map(|given| &given.tilt);
    let tilts: Vec<String> = tilts
        .map(|(direction, tilt)| format!("{direction} {}", tilt.written))
        .collect();
    let air = given.and_then(|given| given.temperature_c);
    vec![
        text(survey.name.clone()),
        Cell::Number(air.map(|air| Quantity::new(air, Unit::si("°C"), Digits::Trimmed(3)))),
        text(tilts.join(", ")),
        text(modes.join("; ")),
    ]
}
