//! What was given: every input with its unit, scatter and source, and what rests on assumptions.

use super::table::{Cell, table};
use super::variants;
use super::words::{evidence_word, listed, path_words, unit_text};
use dolmen_project::{Project, Quantity, Structure, Warning, WarningKind};
use dolmen_words::Language;
use dolmen_words::number;
use dolmen_work::answer::ProjectReport;
use dolmen_work::state::VariantAnswer;
use maud::{Markup, html};

/// The section "what was given".
pub(super) fn section(answer: &ProjectReport, language: Language) -> Markup {
    let project = &answer.project;
    let inputs = project.inputs();
    html! {
        h2 { (language.pick("What was given", "입력 자료")) }
        @if let Some(description) = &project.description { p { (description) } }
        @if inputs.is_empty() {
            p { (language.pick(
                "No dimensions were given: only what was measured is reported.",
                "치수가 주어지지 않아 계측 결과만 보고한다.",
            )) }
        } @else {
            @let gravity = format!("g = {}{}m/s²", number::trimmed(project.gravity_m_s2, 6), number::NARROW_SPACE);
            @let caption = language.pick(
                format!("Inputs. Values marked as assumed are tinted; {gravity}."),
                format!("입력값. 가정한 값은 바탕색으로 표시하였다; {gravity}."),
            );
            (inputs_table(&caption, &inputs, language))
        }
        @for variant in answer.variants() {
            @if !variant.own_inputs.is_empty() {
                @let inputs: Vec<&Quantity> = variant.own_inputs.iter().collect();
                @let title = variants::title(variant, language);
                (inputs_table(&language.pick(
                    format!("Inputs of the variant “{title}”. Where they differ from those above; values marked as assumed are tinted."),
                    format!("대안 ‘{title}’의 입력값. 위와 다른 값만 제시하며, 가정한 값은 바탕색으로 표시하였다."),
                ), &inputs, language))
            }
        }
        (surveys(project, language))
        @if !project.warnings.is_empty() {
            h3 { (language.pick("Warnings on reading the file", "입력 파일에 대한 경고")) }
            ul { @for warning in &project.warnings {
                li { (warning_words(warning, language)) " (" code { (warning.path) } ", " (language.pick("line", "행")) " " (warning.line) ")" }
            } }
        }
    }
}

fn inputs_table(caption: &str, inputs: &[&Quantity], language: Language) -> Markup {
    let with_cov = inputs.iter().any(|q| q.cov.is_some());
    let with_note = inputs.iter().any(|q| q.note.is_some());
    let mut head = vec![language.pick("Input", "입력"), language.pick("Source", "출처")];
    let words = head.len();
    head.extend([
        language.pick("As written", "기재값"),
        language.pick("SI value", "SI 값"),
    ]);
    if with_cov {
        head.push(language.pick("Coefficient of variation", "변동계수"));
    }
    if with_note {
        head.push(language.pick("Note", "비고"));
    }
    let head: Vec<String> = head.into_iter().map(String::from).collect();
    let rows: Vec<Vec<Cell>> = inputs
        .iter()
        .map(|q| {
            let source = evidence_word(q.source, language);
            let mut row: Vec<Cell> = vec![
                path_words(&q.path, language).into(),
                if q.is_assumed() {
                    Cell::assumed(source)
                } else {
                    source.into()
                },
                q.written.clone().into(),
                format!(
                    "{}{}{}",
                    number::trimmed(q.value, 6),
                    number::NARROW_SPACE,
                    unit_text(q.unit)
                )
                .into(),
            ];
            if with_cov {
                row.push(q.cov.map_or("–".into(), |cov| number::percent(cov, 2)).into());
            }
            if with_note {
                row.push(Cell::wrapping(q.note.clone().unwrap_or_default()));
            }
            row
        })
        .collect();
    table(caption, words, &head, &rows)
}

/// The sentence of the reader of the file; in Korean what it is about, and the sentence as it stands.
fn warning_words(warning: &Warning, language: Language) -> String {
    let korean = match warning.kind {
        WarningKind::CapLeftOut => "최상부 부재가 제외되어 불안전측이다",
        WarningKind::Assumed => "가정한 값이 있다",
        WarningKind::ThinRod => "관성모멘트가 주어지지 않아 가는 봉으로 보았다",
        WarningKind::AxialFromMasses => "축력이 주어지지 않아 질량으로부터 구하였다",
        WarningKind::JointDefaults => "접합면 물성 일부가 주어지지 않아 기본값으로 가정하였다",
        WarningKind::Allowed => "의심스러운 값을 allow 항목에 따라 허용하였다",
        WarningKind::AllowedInVain => "allow 항목 중 쓰이지 않은 것이 있다",
    };
    language.pick(warning.message.clone(), format!("{korean} [{}]", warning.message))
}

fn surveys(project: &Project, language: Language) -> Markup {
    html! {
        @for survey in &project.surveys {
            h3 { (language.pick("Survey", "조사")) " " (survey.name) }
            ul {
                @if let Some(note) = &survey.note { li { (note) } }
                @if let Some(source) = &survey.source { li { (language.pick("Source: ", "출처: ")) (source) } }
                @if let Some(temperature) = survey.temperature_c {
                    li { (language.pick("Air temperature ", "기온 ")) (number::significant(temperature, 3)) "\u{202f}°C" }
                } @else {
                    li { (language.pick("Air temperature: unknown", "기온: 미상")) }
                }
                @if let Some(datum) = &survey.datum { li { (language.pick("Datum: ", "기준점: ")) (datum) } }
                @if !survey.tilt.is_empty() {
                    li { (language.pick("Tilt: ", "기울기: "))
                        @for (i, (direction, tilt)) in survey.tilt.iter().enumerate() {
                            @if i > 0 { ", " } (direction) " " (tilt.written)
                        } }
                }
                @if let Some(records) = &survey.records {
                    li { (language.pick("Vibration records: ", "진동 기록: ")) code { (records.file) } }
                }
            }
        }
    }
}

/// The assumed inputs of a variant by name, for the findings: every result of the variant rests on them. `None` if it adds none.
pub(super) fn assumptions_of_variant(variant: &VariantAnswer, language: Language) -> Option<String> {
    let assumed = variant.own_inputs.iter().filter(|input| input.is_assumed());
    let words = assumed.map(|input| format!("{} {}", path_words(&input.path, language), input.written));
    let words: Vec<String> = words.collect();
    let title = variants::title(variant, language);
    (!words.is_empty()).then(|| {
        let words = listed(&words, language);
        language.pick(
            format!("Every result of the variant “{title}” rests on what is assumed, not measured: {words}."),
            format!("대안 ‘{title}’의 모든 결과는 실측이 아닌 가정값에 의존한다: {words}."),
        )
    })
}

/// What the assumed inputs make uncertain, for the findings: `None` if nothing is assumed.
pub(super) fn assumptions(project: &Project, language: Language) -> Option<String> {
    let assumed: Vec<&Quantity> = project.inputs().into_iter().filter(|q| q.is_assumed()).collect();
    if assumed.is_empty() {
        return None;
    }
    let is_stiffness = |q: &&Quantity| q.path.ends_with("stiffness") || q.path.contains("stiffness[");
    let is_damping = |q: &&Quantity| q.path.contains("damping");
    let stiffness = assumed.iter().filter(|q| is_stiffness(q)).count();
    let damping = assumed.iter().filter(|q| is_damping(q)).count();
    let surveyed = assumed
        .iter()
        .filter(|q| q.path.starts_with("survey.") && !is_damping(q))
        .count();
    let body = assumed.len() - stiffness - damping - surveyed;
    let stack = matches!(project.structure, Structure::Stack(_));
    let mut parts = Vec::new();
    if body > 0 {
        let (english, korean) = if stack {
            ("dimensions, densities and frictions", "치수·밀도·마찰")
        } else {
            ("dimensions and weights", "치수·무게")
        };
        parts.push(language.pick(
            format!("{body} of the {english} (every result that uses them)"),
            format!("{korean} {body}개(이를 사용한 모든 결과)"),
        ));
    }
    if stiffness > 0 && stack {
        parts.push(language.pick(
            format!("{stiffness} stiffness values (natural frequencies, demand on elastic joints and simulated motion rest on them; the verdict and the limits do not)"),
            format!("강성 {stiffness}개(고유진동수, 탄성 접합면의 요구 수준, 지진응답이 이에 의존하며 판정과 한계 가속도는 무관하다)"),
        ));
    } else if stiffness > 0 {
        let (chain, frame) = (
            language.pick(
                "the verdict, the load factor, the margins and the modes",
                "판정, 하중배율, 여유도, 모드",
            ),
            language.pick(
                "the verdict, the load factor and the modes",
                "판정, 하중배율, 모드",
            ),
        );
        let rests = if matches!(project.structure, Structure::Chain(_)) {
            chain
        } else {
            frame
        };
        parts.push(language.pick(
            format!(
                "{stiffness} stiffness values ({rests} rest on them; limits from weights and lengths do not)"
            ),
            format!(
                "강성 {stiffness}개({rests}가 이에 의존하며, 무게와 길이로만 정해지는 한계값은 무관하다)"
            ),
        ));
    }
    if surveyed > 0 {
        parts.push(language.pick(
            format!(
                "{surveyed} frequencies (the stiffness found from them is an illustration, not a finding)"
            ),
            format!("고유진동수 {surveyed}개(이로부터 추정한 강성은 예시일 뿐 결과가 아니다)"),
        ));
    }
    if damping > 0 && matches!(project.structure, Structure::Building(_)) {
        parts.push(language.pick(
            format!("{damping} damping values (the response to spectra and motions rests on them; verdict and modes do not)"),
            format!("감쇠 {damping}개(스펙트럼과 지진에 대한 응답이 이에 의존하며 판정과 모드는 무관하다)"),
        ));
    } else if damping > 0 && stack {
        parts.push(language.pick(
            format!("{damping} damping values (simulated motion alone rests on them)"),
            format!("감쇠 {damping}개(지진응답만 이에 의존한다)"),
        ));
    } else if damping > 0 {
        parts.push(language.pick(
            format!("{damping} damping values (nothing on this page rests on them but changes from survey to survey)"),
            format!("감쇠 {damping}개(조사 사이의 변화 외에는 이 보고서의 결과와 무관)"),
        ));
    }
    let parts = listed(&parts, language);
    Some(language.pick(
        format!("Assumed, not measured: {parts}."),
        format!("실측이 아닌 가정값: {parts}."),
    ))
}
