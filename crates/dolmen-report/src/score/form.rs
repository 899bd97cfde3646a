//! The form to fill in at a pagoda: its name and the six factors, one row each.

use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_words::{Sentence, Unit, messages};

messages! {
    /// The words of the form.
    pub(crate) enum Form in "score.form" {
        Title => { en: "Field form of the six-factor score", ko: "여섯 인자 점수 현장 조사표" },
        Fill => {
            en: "Fill the column of values, save the workbook, and score it: dolmen score FORM.xlsx",
            ko: "값 열을 채워 저장한 뒤 점수를 계산한다: dolmen score FORM.xlsx",
        },
        Caption => { en: "The pagoda and its six factors.", ko: "석탑과 여섯 인자." },
        Key => { en: "Key", ko: "키" },
        What => { en: "What to measure", ko: "조사 항목" },
        UnitOf => { en: "Unit", ko: "단위" },
        Value => { en: "Value", ko: "값" },
        Remark => { en: "Source or remark", ko: "출처 또는 비고" },
        Name => { en: "Name of the pagoda", ko: "석탑 이름" },
        Storeys => { en: "Number of storeys", ko: "층수" },
        BodyHeight => { en: "Height of all storeys, without base and finial", ko: "탑신 전체 높이(기단과 상륜 제외)" },
        BodySlenderness => {
            en: "Height of all storeys over the width of the first storey's body (λ); or the next row",
            ko: "탑신 전체 높이를 1층 탑신 폭으로 나눈 값(λ). 아래 항목으로 대신할 수 있음",
        },
        SlendernessAngle => {
            en: "Half width over the height of the centroid above it, the least of all joints (tan α); or the row above",
            ko: "접합면 반폭을 그 위 무게중심 높이로 나눈 값 중 최소(tan α). 위 항목으로 대신할 수 있음",
        },
        Taper => { en: "Angle by which the body narrows upwards (φ)", ko: "탑신이 위로 좁아지는 각도(체감도 φ)" },
        BaseRatio => { en: "Height of all storeys over the height of the base", ko: "탑신 전체 높이를 기단 높이로 나눈 값" },
        Degrees => { en: "deg", ko: "°" },
        Metres => { en: "m", ko: "m" },
        None => { en: "–", ko: "–" },
        OneOfTwo => {
            en: "Of λ and tan α fill one: the other follows from it.",
            ko: "λ와 tan α는 하나만 기입한다. 나머지는 그 값으로 정해진다.",
        },
    }
}

/// The rows of the form: the key, the measured quantity, the unit.
fn rows() -> [(&'static str, Form, Form); 7] {
    [
        ("name", Form::Name, Form::None),
        ("storeys", Form::Storeys, Form::None),
        ("body_height", Form::BodyHeight, Form::Metres),
        ("body_slenderness", Form::BodySlenderness, Form::None),
        ("slenderness_angle", Form::SlendernessAngle, Form::None),
        ("taper", Form::Taper, Form::Degrees),
        ("body_base_height_ratio", Form::BaseRatio, Form::None),
    ]
}

/// The form as a document.
pub(crate) fn form() -> Document<'static> {
    let mut document = Document::default();
    document.paragraph(Form::Fill);
    let empty = || Cell::Words(Sentence::of_symbol(""));
    let row = |(key, what, unit)| {
        let key = Cell::Words(Sentence::of_symbol(key));
        vec![key, Cell::words(what), Cell::words(unit), empty(), empty()]
    };
    document.put(Block::Table(Table {
        caption: vec![Form::Caption.into()],
        columns: vec![
            Column::words(Form::Key),
            Column::words(Form::What),
            Column::words(Form::UnitOf),
            Column::numbers(Form::Value, Unit::ratio()),
            Column::words(Form::Remark),
        ],
        rows: rows().into_iter().map(row).collect(),
    }));
    document.note(Form::OneOfTwo);
    document.note(super::pagoda::conditions());
    document.note(super::pagoda::Pagoda::NoProof);
    document
}
