//! Description of the input, printed before any result.

use super::from_surveys::{from_surveys_of_studies, from_surveys_text};
use crate::damaged::damaged;
use crate::document::{TextStyle, wrapped};
use crate::headline_basis::NAMED_MOST;
use crate::warned::slip;
use dolmen::structure::stack::Body;
use dolmen_project::{
    Axial, BuildingPart, ChainPart, FramePart, Heaviness, Pick, Project, Quantity as Input, StackPart,
    Structure, StudyPart, WarningKind,
};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::judgement::Evidence;

messages! {
    /// The size of a structure.
    pub(crate) enum Size in "check.size" {
        Contradicted { survey: String, measured: Quantity, computed: Quantity } => {
            en: "✕ Survey {survey} contradicts the model on which this answer rests: {measured} measured, {computed} modelled. What follows is not of the structure measured.",
            ko: "✕ {survey} 조사가 이 결과의 바탕인 모델과 일치하지 않는다: 실측 {measured}, 모델 {computed}. 아래 결과는 계측한 구조물의 것이 아니다.",
        },
        Doubtful { line: usize, said: Sentence } => {
            en: "! PROBABLY A SLIP, line {line}: {said}",
            ko: "! 입력 오류 의심, {line}행: {said}",
        },
        Chain { links: usize, height: Quantity, weight: Quantity, gravity: Quantity } => {
            en: "chain, links: {links}, {height} high, {weight}, g {gravity}",
            ko: "체인 모델, 부재 {links}개, 높이 {height}, 무게 {weight}, g {gravity}",
        },
        Frame { storeys: usize, height: Quantity, mass: Quantity, axial: Sentence } => {
            en: "frame, storeys: {storeys}, {height} high, {mass}, {axial}",
            ko: "골조 모델, {storeys}층, 높이 {height}, 질량 {mass}, {axial}",
        },
        AxialStorey => { en: "axial force given a storey", ko: "층별 축력 입력" },
        AxialLevel => { en: "axial force given a level", ko: "바닥별 축하중 입력" },
        AxialFromMasses => { en: "axial force from the masses", ko: "축력은 질량에서 계산" },
        Stack { blocks: usize, height: Quantity, mass: Quantity, joints: usize, feet: usize, gravity: Quantity } => {
            en: "stack, blocks: {blocks}, {height} high, {mass}, joints: {joints} ({feet} on the ground), g {gravity}",
            ko: "적층 모델, 부재 {blocks}개, 높이 {height}, 질량 {mass}, 접합면 {joints}개(지반 위 {feet}개), g {gravity}",
        },
        Loose { blocks: usize, height: Quantity, mass: Quantity, gravity: Quantity } => {
            en: "loose stones, blocks: {blocks}, {height} high as drawn, {mass}, no joints, g {gravity}",
            ko: "돌무더기 모델, 부재 {blocks}개, 입력 높이 {height}, 질량 {mass}, 접합면 없음, g {gravity}",
        },
        StackFault(why: String) => { en: "stack that cannot be: {why}", ko: "성립할 수 없는 적층 모델: {why}" },
        Building { floors: usize, height: Quantity, mass: Quantity, p_delta: Sentence } => {
            en: "building, floors: {floors}, {height} high, {mass}, {p_delta}",
            ko: "건물 모델, 바닥 {floors}개, 높이 {height}, 질량 {mass}, {p_delta}",
        },
        PDelta => { en: "P-delta from the masses", ko: "질량에 의한 P-델타 고려" },
        NoPDelta => { en: "P-delta left out", ko: "P-델타 제외" },
        BuildingFault(why: String) => { en: "building that cannot be: {why}", ko: "성립할 수 없는 건물 모델: {why}" },
        AsInspected(each: Vec<Sentence>) => {
            en: "the model has the damage of inspections: {each}«; as_inspected = \"none\" leaves that out»",
            ko: "모델에 점검에서 확인된 손상을 반영하였다: {each}«. 제외하려면 as_inspected = \"none\"으로 한다»",
        },
        MadeUp(surveys: Vec<String>) => {
            en: "made up, not measured: survey {surveys}; what follows from it is an illustration",
            ko: "실측이 아닌 가상 조사: {surveys}. 이에 따른 결과는 예시이다",
        },
        MadeUpMany { count: usize, first: String, last: String } => {
            en: "made up, not measured: {count} surveys, {first} to {last}; what follows from them is an illustration",
            ko: "실측이 아닌 가상 조사 {count}회({first}~{last})이며 이로부터 나온 결과는 예시이다",
        },
        Survey => { en: "measured, not modelled", ko: "계측만 하고 모델링하지 않음" },
        File { file: String, size: Sentence } => { en: "{file}: {size}", ko: "{file}: {size}" },
        Source(source: String) => { en: "source: {source}", ko: "출처: {source}" },
    }
}

/// Name, file, kind and size of the project.
pub(crate) fn project_text(project: &Project, file: &str, style: TextStyle) -> String {
    let language = style.language;
    let (own, other) = language.pick(
        (project.name.english(), project.name.korean()),
        (project.name.korean(), project.name.english()),
    );
    let names = match own == other {
        true => own.to_owned(),
        false => format!("{own} ({other})"),
    };
    let line = |sentence: Size| {
        wrapped(
            &Sentence::from(sentence).text(language),
            "  ",
            "    ",
            style.columns(),
        )
    };
    let mut out = wrapped(&names, "", "  ", style.columns());
    out += &line(Size::File {
        file: file.to_owned(),
        size: size(project),
    });
    if let Some(source) = project.source.as_ref().filter(|_| style.is_full) {
        out += &line(Size::Source(source.clone()));
    }
    out += &damage_text(project, style);
    out + &doubtful_text(project, style)
}

/// The damage of inspections in the model; empty without any.
fn damage_text(project: &Project, style: TextStyle) -> String {
    if project.damage.is_empty() {
        return String::new();
    }
    let each = project.damage.iter().map(damaged).collect();
    let said = Sentence::from(Size::AsInspected(each)).text(style.language);
    wrapped(&said, "  ", "    ", style.columns())
}

/// Note that surveys of the file were not measured; empty if all were. A check has it in its verdict.
pub(crate) fn made_up_text(project: &Project, style: TextStyle) -> String {
    let made_up = project.surveys.iter().filter(|survey| survey.is_made_up);
    let surveys: Vec<String> = made_up.map(|survey| survey.name.clone()).collect();
    if surveys.is_empty() {
        return String::new();
    }
    let said = match surveys.as_slice() {
        [first, .., last] if surveys.len() > NAMED_MOST => {
            let (count, first, last) = (surveys.len(), first.clone(), last.clone());
            Size::MadeUpMany { count, first, last }
        }
        _ => Size::MadeUp(surveys),
    };
    let said = Sentence::from(said).text(style.language);
    wrapped(&said, "  ", "    ", style.columns())
}

/// Probable mistakes in the file, for a document, before any answer.
pub(crate) fn doubtful(project: &Project) -> Vec<Sentence> {
    let warnings = project.warnings.iter();
    let doubtful = warnings.filter(|warning| warning.kind == WarningKind::Doubtful);
    doubtful.map(|warning| slip(project, warning)).collect()
}

/// The same for readers of the file.
fn doubtful_lines(project: &Project) -> Vec<Sentence> {
    let warnings = project.warnings.iter();
    let doubtful = warnings.filter(|warning| warning.kind == WarningKind::Doubtful);
    let each = doubtful.map(|warning| Size::Doubtful {
        line: warning.line,
        said: warning.message.clone(),
    });
    each.map(Sentence::from).collect()
}

/// Notes that must precede an answer, for a terminal: damage in the model, a mistake in the file, a survey that contradicts its model.
/// Empty without any.
pub fn against_text(project: &Project, evidence: &Evidence, style: TextStyle) -> String {
    let damage = damage_text(project, style);
    damage
        + &doubtful_text(project, style)
        + &contradicted_text(evidence, style)
        + &from_surveys_text(project, style)
}

/// A survey that contradicts the model; empty without one.
fn contradicted_text(evidence: &Evidence, style: TextStyle) -> String {
    let contradicted = match evidence {
        Evidence::Contradicted(of) => Some(Sentence::from(Size::Contradicted {
            survey: of.survey.clone(),
            measured: Quantity::new(of.measured_hz, Unit::si("Hz"), Digits::Significant(3)),
            computed: Quantity::new(of.computed_hz, Unit::si("Hz"), Digits::Significant(3)),
        })),
        _ => None,
    };
    contradicted.map_or(String::new(), |said| {
        wrapped(&said.text(style.language), "  ", "    ", style.columns())
    })
}

/// The same above studies, which name the damage in their models themselves; of stiffness from surveys only what their runs use.
pub fn against_studies_text(
    project: &Project,
    studies: &[&StudyPart],
    evidence: &Evidence,
    style: TextStyle,
) -> String {
    doubtful_text(project, style)
        + &contradicted_text(evidence, style)
        + &from_surveys_of_studies(project, studies, style)
}

/// The same of the file alone.
fn doubtful_text(project: &Project, style: TextStyle) -> String {
    let each = doubtful_lines(project).into_iter();
    each.map(|said| wrapped(&said.text(style.language), "  ", "    ", style.columns()))
        .collect()
}

fn size(project: &Project) -> Sentence {
    let gravity = project.gravity_m_s2;
    let size = match &project.structure {
        Structure::Chain(part) => chain(part, gravity),
        Structure::Frame(part) => frame(part, gravity),
        Structure::Stack(part) => stack(part, gravity),
        Structure::Building(part) => building(part),
        Structure::Survey => Size::Survey,
    };
    size.into()
}

fn metres(height_m: f64) -> Quantity {
    Quantity::new(height_m, Unit::si("m"), Digits::Fixed(2))
}

fn tonnes(mass_kg: f64) -> Quantity {
    let unit = Unit {
        symbol: "t".to_owned(),
        factor: 1e-3,
    };
    Quantity::new(mass_kg, unit, Digits::Fixed(2))
}

fn acceleration(gravity_m_s2: f64) -> Quantity {
    Quantity::new(gravity_m_s2, Unit::si("m/s²"), Digits::Trimmed(6))
}

fn total_mass<'a>(all: impl Iterator<Item = &'a Heaviness>, gravity: f64) -> f64 {
    let pick: Pick<'_> = &mut Input::nominal;
    all.map(|heaviness| heaviness.mass_kg(gravity, pick)).sum()
}

fn chain(part: &ChainPart, gravity: f64) -> Size {
    let lengths = part.links.iter().map(|link| Input::nominal(&link.length));
    let mass = total_mass(part.links.iter().map(|link| &link.heaviness), gravity);
    let unit = Unit {
        symbol: "kN".to_owned(),
        factor: 1e-3,
    };
    Size::Chain {
        links: part.links.len(),
        height: metres(lengths.sum()),
        weight: Quantity::new(mass * gravity, unit, Digits::Fixed(2)),
        gravity: acceleration(gravity),
    }
}

fn frame(part: &FramePart, gravity: f64) -> Size {
    let heights = part.storeys.iter().map(|storey| Input::nominal(&storey.height));
    let axial = match part.axial {
        Axial::Storey => Size::AxialStorey,
        Axial::Level => Size::AxialLevel,
        Axial::FromMasses => Size::AxialFromMasses,
    };
    Size::Frame {
        storeys: part.storeys.len(),
        height: metres(heights.sum()),
        mass: tonnes(total_mass(
            part.storeys.iter().map(|storey| &storey.heaviness),
            gravity,
        )),
        axial: axial.into(),
    }
}

fn stack(part: &StackPart, gravity: f64) -> Size {
    let built = match part.is_loose {
        true => part.build_loose(&mut Input::nominal),
        false => part.build(&mut Input::nominal),
    };
    match built {
        Ok(stack) if part.is_loose => Size::Loose {
            blocks: stack.blocks().len(),
            height: metres(stack.height_m()),
            mass: tonnes(stack.mass_kg()),
            gravity: acceleration(gravity),
        },
        Ok(stack) => {
            let joints = stack.joints();
            Size::Stack {
                blocks: stack.blocks().len(),
                height: metres(stack.height_m()),
                mass: tonnes(stack.mass_kg()),
                joints: joints.len(),
                feet: joints.iter().filter(|joint| joint.lower == Body::Ground).count(),
                gravity: acceleration(gravity),
            }
        }
        Err(fault) => Size::StackFault(fault.to_string()),
    }
}

fn building(part: &BuildingPart) -> Size {
    match part.floors_and_storeys(&mut Input::nominal) {
        Ok((floors, storeys)) => {
            let p_delta = match part.p_delta {
                true => Size::PDelta,
                false => Size::NoPDelta,
            };
            Size::Building {
                floors: floors.len(),
                height: metres(storeys.iter().map(|storey| storey.height_m).sum()),
                mass: tonnes(floors.iter().map(|floor| floor.mass_kg).sum()),
                p_delta: p_delta.into(),
            }
        }
        Err(fault) => Size::BuildingFault(fault.to_string()),
    }
}
