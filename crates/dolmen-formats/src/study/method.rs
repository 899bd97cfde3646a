//! How a study was computed, in words: every result says it.

use super::answer::StudyAnswer;
use super::run::StudyKind;
use crate::Language;
use crate::number::trimmed;
use crate::project::LawPart;
use dolmen::blocks::Springs;

/// Time after the motion in which a frame swings on if nothing else is said, s. As for a single simulation.
pub const FRAME_REST_S: f64 = 20.0;

impl StudyAnswer {
    /// Time after the motion, s.
    pub fn rest_s(&self) -> f64 {
        let usual = match self.kind {
            StudyKind::Stack => Springs::default().rest_s,
            StudyKind::Frame => FRAME_REST_S,
        };
        self.study.rest_s.unwrap_or(usual)
    }

    /// The contact law of a stack; `None` of a frame.
    pub fn law(&self) -> Option<&'static str> {
        (self.kind == StudyKind::Stack).then_some(match self.study.law {
            LawPart::Springs => "springs",
            LawPart::Rigid => "rigid",
        })
    }

    /// Law, points, rest, refinement, seeds and version.
    pub fn method(&self, language: Language) -> String {
        let study = &self.study;
        let mut words = Vec::new();
        if let Some(law) = self.law() {
            let korean = match study.law {
                LawPart::Springs => "스프링 법칙",
                LawPart::Rigid => "강체 법칙",
            };
            words.push(language.pick(format!("{law} law"), korean.to_owned()));
            let points = study.points;
            words.push(language.pick(
                format!("{points} contact points a joint"),
                format!("접합면당 접촉점 {points}개"),
            ));
        }
        if study.scan.is_some() {
            let rest = trimmed(self.rest_s(), 3);
            words.push(language.pick(
                format!("{rest} s after the motion"),
                format!("지진동 종료 후 {rest}초"),
            ));
            let part = part_of_step(study.refine);
            words.push(language.pick(
                format!("first fall to {part} of a step"),
                match study.refine {
                    0 => "최초 낙하는 한 단계까지".to_owned(),
                    _ => format!("최초 낙하는 단계의 {part}까지"),
                },
            ));
        }
        if study.samples.is_some() {
            let seed = study.seed;
            words.push(language.pick(format!("samples from seed {seed}"), format!("표본 시드 {seed}")));
        }
        if let Some(made) = &study.artificial {
            let seed = made.seed;
            words.push(language.pick(
                format!("noise from seed {seed}"),
                format!("인공 지진동 시드 {seed}"),
            ));
        }
        words.push(format!("Dolmen {}", self.version));
        words.join(", ")
    }
}

/// To what part of a step of the scan so many halvings lead.
pub fn part_of_step(halvings: u32) -> String {
    match halvings {
        0 => "the whole".to_owned(),
        n => format!("1/{}", 1_u64 << n.min(63)),
    }
}
