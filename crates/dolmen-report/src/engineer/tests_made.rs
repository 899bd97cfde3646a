//! Tests of material and the sensors of the surveys.

use super::words::{cell, table_of, text_cell};
use crate::document::{Block, Cell, Column, Document};
use dolmen_project::{MaterialMethod, MaterialTest, ReportPart, SensorPart};
use dolmen_words::{Digits, Quantity, Unit, messages};

messages! {
    /// Tests and sensors.
    pub(crate) enum Tests in "engineer.tests" {
        Head => { en: "Material tests and sensors", ko: "재료 시험과 계측 장비" },
        HeadOfMaterial => { en: "Material tests", ko: "재료 시험" },
        HeadOfSensors => { en: "Sensors", ko: "계측 장비" },
        MaterialCaption => { en: "Tests of material, as the file gives them.", ko: "재료 시험 결과(입력 자료)." },
        SensorsCaption => { en: "Sensors and their calibration.", ko: "계측 장비와 교정." },
        Method => { en: "Method", ko: "시험 방법" },
        Ultrasonic => { en: "ultrasonic pulse velocity", ko: "초음파 속도법" },
        Rebound => { en: "rebound hammer", ko: "반발경도법" },
        Part => { en: "Part", ko: "부재" },
        Day => { en: "Date", ko: "시험일" },
        Velocity => { en: "Velocity", ko: "초음파 속도" },
        ReboundNumber => { en: "Rebound number", ko: "반발경도" },
        Strength => { en: "Compressive strength", ko: "압축강도" },
        Note => { en: "Note", ko: "비고" },
        Sensor => { en: "Sensor", ko: "장비" },
        Model => { en: "Model", ko: "제조사·모델" },
        Serial => { en: "Serial number", ko: "일련번호" },
        Calibrated => { en: "Calibrated", ko: "교정일" },
        Certificate => { en: "Certificate", ko: "교정성적서" },
    }
}

/// The section; empty if it has no content.
pub(crate) fn tests_made(report: &ReportPart) -> Document<'static> {
    let mut document = Document::default();
    document.heading(
        match (report.material_tests.is_empty(), report.sensors.is_empty()) {
            (true, true) => return document,
            (false, true) => Tests::HeadOfMaterial,
            (true, false) => Tests::HeadOfSensors,
            (false, false) => Tests::Head,
        },
    );
    if !report.material_tests.is_empty() {
        document.put(tests(&report.material_tests));
    }
    if !report.sensors.is_empty() {
        document.put(sensors(&report.sensors));
    }
    document
}

fn tests(all: &[MaterialTest]) -> Block<'static> {
    let words =
        |head: Tests, cell: fn(&MaterialTest) -> Cell| (Column::words(head), all.iter().map(cell).collect());
    let numbers = |head: Tests, unit: Unit, digits, value: fn(&MaterialTest) -> Option<f64>| {
        let of = |test: &MaterialTest| {
            Cell::Number(value(test).map(|value| Quantity::new(value, unit.clone(), digits)))
        };
        let cells: Vec<Cell> = all.iter().map(of).collect();
        (Column::numbers(head, unit.clone()), cells)
    };
    let mpa = Unit {
        symbol: "MPa".to_owned(),
        factor: 1e-6,
    };
    Block::Table(table_of(
        Tests::MaterialCaption,
        vec![
            words(Tests::Method, |test| {
                Cell::words(match test.method {
                    MaterialMethod::Ultrasonic(_) => Tests::Ultrasonic,
                    MaterialMethod::Rebound(_) => Tests::Rebound,
                })
            }),
            words(Tests::Part, |test| text_cell(test.part.as_deref())),
            words(Tests::Day, |test| text_cell(test.date.as_deref())),
            words(Tests::Note, |test| cell(test.note.as_ref())),
            numbers(
                Tests::Velocity,
                Unit::si("m/s"),
                Digits::Trimmed(4),
                |test| match test.method {
                    MaterialMethod::Ultrasonic(velocity) => velocity,
                    MaterialMethod::Rebound(_) => None,
                },
            ),
            numbers(
                Tests::ReboundNumber,
                Unit::ratio(),
                Digits::Trimmed(4),
                |test| match test.method {
                    MaterialMethod::Rebound(number) => number,
                    MaterialMethod::Ultrasonic(_) => None,
                },
            ),
            numbers(Tests::Strength, mpa, Digits::Trimmed(4), |test| {
                test.strength.as_ref().map(|strength| strength.value)
            }),
        ],
    ))
}

fn sensors(all: &[SensorPart]) -> Block<'static> {
    let words =
        |head: Tests, cell: fn(&SensorPart) -> Cell| (Column::words(head), all.iter().map(cell).collect());
    Block::Table(table_of(
        Tests::SensorsCaption,
        vec![
            words(Tests::Sensor, |sensor| cell(Some(&sensor.name))),
            words(Tests::Model, |sensor| cell(sensor.model.as_ref())),
            words(Tests::Serial, |sensor| cell(sensor.serial.as_ref())),
            words(Tests::Calibrated, |sensor| {
                text_cell(sensor.calibrated.as_deref())
            }),
            words(Tests::Certificate, |sensor| cell(sensor.certificate.as_ref())),
        ],
    ))
}
