//! The engineer's opinion: grade, opinion, recommendations, maintenance.

use super::words::said;
use crate::document::{Block, Cell, Document};
use dolmen_project::{Grade, GradeScale, Names, PeriodicGrade, ReportPart};
use dolmen_words::{Sentence, messages};

messages! {
    /// The opinion of the engineer.
    pub(crate) enum Opinion in "engineer.opinion" {
        Head => { en: "Opinion", ko: "종합의견" },
        ByEngineer => {
            en: "Grade, opinion and recommendations are the engineer’s; Dolmen did not compute them.",
            ko: "등급, 종합의견, 보수·보강 방안은 기술자가 판단한 것이며 계산 결과가 아니다.",
        },
        Grade => { en: "Grade", ko: "등급" },
        Reason => { en: "Reason", ko: "판정 사유" },
        Periodic { grade: String, word: Sentence } => {
            en: "{grade} {word} (periodic inspection, A to F)",
            ko: "{grade} {word}(정기조사 A–F)",
        },
        OtherScale { grade: Sentence, scale: Sentence } => { en: "{grade} ({scale})", ko: "{grade}({scale})" },
        A => { en: "good", ko: "양호" },
        B => { en: "minor repair", ko: "경미보수" },
        C => { en: "observe", ko: "주의관찰" },
        D => { en: "detailed diagnosis", ko: "정밀진단" },
        E => { en: "repair", ko: "보수" },
        F => { en: "immediate action", ko: "즉시조치" },
        Recommendations => { en: "Recommendations", ko: "보수·보강 방안" },
        Maintenance => { en: "Maintenance", ko: "유지관리 방안" },
    }
}

/// The section; empty if no data are given.
pub(crate) fn opinion(report: &ReportPart) -> Document<'static> {
    let mut document = Document::default();
    let lists = [&report.opinion, &report.recommendations, &report.maintenance];
    if report.grade.is_none() && lists.iter().all(|list| list.is_empty()) {
        return document;
    }
    document.heading(Opinion::Head);
    if let Some(grade) = &report.grade {
        document.put(Block::KeyValues(vec![
            (Opinion::Grade.into(), Cell::words(grade_words(grade))),
            (Opinion::Reason.into(), Cell::words(said(&grade.reason))),
        ]));
    }
    for paragraph in &report.opinion {
        document.paragraph(said(paragraph));
    }
    points(&mut document, Opinion::Recommendations, &report.recommendations);
    points(&mut document, Opinion::Maintenance, &report.maintenance);
    document.note(Opinion::ByEngineer);
    document
}

fn points(document: &mut Document<'_>, head: Opinion, points: &[Names]) {
    if !points.is_empty() {
        document.subheading(head);
        document.put(Block::List(points.iter().map(said).collect()));
    }
}

/// "C observe (periodic inspection, A to F)".
fn grade_words(grade: &Grade) -> Sentence {
    match &grade.scale {
        GradeScale::Periodic(letter) => Opinion::Periodic {
            grade: grade.value.english().to_owned(),
            word: match letter {
                PeriodicGrade::A => Opinion::A,
                PeriodicGrade::B => Opinion::B,
                PeriodicGrade::C => Opinion::C,
                PeriodicGrade::D => Opinion::D,
                PeriodicGrade::E => Opinion::E,
                PeriodicGrade::F => Opinion::F,
            }
            .into(),
        },
        GradeScale::Other(scale) => Opinion::OtherScale {
            grade: said(&grade.value),
            scale: said(scale),
        },
    }
    .into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_words::Language;

    #[test]
    fn published_the_six_words_of_the_periodic_inspection() {
        let words = ["양호", "경미보수", "주의관찰", "정밀진단", "보수", "즉시조치"];
        let grades = [
            ("A", PeriodicGrade::A),
            ("B", PeriodicGrade::B),
            ("C", PeriodicGrade::C),
            ("D", PeriodicGrade::D),
            ("E", PeriodicGrade::E),
            ("F", PeriodicGrade::F),
        ];
        for ((letter, own), word) in grades.into_iter().zip(words) {
            let names = |text: &str| Names {
                en: Some(text.to_owned()),
                ko: None,
            };
            let grade = Grade {
                value: names(letter),
                scale: GradeScale::Periodic(own),
                reason: names("why"),
            };
            assert_eq!(
                grade_words(&grade).text(Language::Korean),
                format!("{letter} {word}(정기조사 A–F)")
            );
        }
    }
}
