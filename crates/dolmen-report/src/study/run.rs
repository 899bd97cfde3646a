//! Runs of a study, their outcomes, and missing results.

use super::words::{Words, both, g, name, scans};
use crate::damaged::damaged;
use crate::document::{Block, Document};
use dolmen_project::Scan;
use dolmen_words::message::Both;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::study::{RunOutcome, ScanVerdict, StudyAnswer, StudyKind};

messages! {
    /// Runs of a study.
    pub(crate) enum Done in "study.run" {
        Runs { runs: Sentence, cases: Sentence, motions: Sentence, directions: Sentence } => {
            en: "{runs} of {cases} under {motions} in {directions}, each at growing shaking.",
            ko: "{cases}, {motions}, {directions}에 대해 지반운동을 키워 가며 모두 {runs} 해석하였다.",
        },
        Samples { samples: usize, seed: String } => {
            en: "Inputs of each combination were drawn {samples} times, from seed {seed}.",
            ko: "조합마다 입력 표본 {samples}개를 추출하였다(난수 초깃값 {seed}).",
        },
        OneScale(scale: Quantity) => { en: "Every motion at scale {scale}.", ko: "입력지진의 배율은 {scale}이다." },
        OnePeak(peak: Quantity) => { en: "Peak of the ground: {peak}.", ko: "최대지반가속도는 {peak}이다." },
        Scales { count: usize, first: Quantity, last: Quantity, part: Sentence } => {
            en: "{count} scales from {first} to {last}; the first fall is sought to {part} of a step.",
            ko: "배율 {count}개({first}–{last})로 해석하였으며, 처음 한계에 이르는 크기는 간격의 {part}까지 좁혀 구하였다.",
        },
        Peaks { count: usize, first: Quantity, last: Quantity, part: Sentence } => {
            en: "{count} peaks of the ground from {first} to {last}; the first fall is sought to {part} of a step.",
            ko: "최대지반가속도 {count}개({first}–{last})로 해석하였으며, 처음 한계에 이르는 크기는 간격의 {part}까지 좁혀 구하였다.",
        },
        Whole => { en: "the whole", ko: "전체" },
        Part(inverse: String) => { en: "1/{inverse}", ko: "1/{inverse}" },
        Method(method: Sentence) => { en: "Method: {method}.", ko: "해석 조건: {method}." },
        Cases(cases: Sentence) => { en: "Computed for {cases}.", ko: "{cases}에 대해 해석하였다." },
        Ends(each: Vec<Sentence>) => { en: "How the runs ended: {each}.", ko: "해석 결과: {each}." },
        Ended { count: usize, outcome: Sentence } => { en: "{count} {outcome}", ko: "{outcome} {count}회" },
        Stood => { en: "stood", ko: "안정" },
        Uplifted => { en: "uplifted", ko: "들림" },
        Slid => { en: "slid", ko: "미끄러짐" },
        Fell => { en: "fell", ko: "낙하·전도" },
        BeyondDrift => { en: "beyond the drift limit", ko: "층간변위 한계 초과" },
        BeyondLastDrift => { en: "beyond the last drift limit", ko: "최종 층간변위 한계 초과" },
        StillMoving => { en: "still moving", ko: "거동 지속" },
        Diverged => { en: "diverged", ko: "발산" },
        Refused => { en: "refused", ko: "입력 거부" },
        RefusedScans(scans: Sentence) => {
            en: "The inputs of {scans} were refused.",
            ko: "{scans}은(는) 입력이 허용 범위를 벗어나 해석하지 않았다.",
        },
        RefusedFor { count: usize, why: Both } => {
            en: "Refused {count} ×: {why}.",
            ko: "입력 거부 {count}회: {why}.",
        },
        BeyondRoom { beyond: usize, all: usize, least: Quantity } => {
            en: "In {beyond} of {all} runs a damper needs more room than it has, from {least} on: the runs do not have its stops, and are too good there.",
            ko: "해석 {all}회 중 {beyond}회에서({least}부터) 감쇠기의 행정이 여유 공간을 넘는다. 해석에는 멈춤 장치가 없으므로 그 결과는 실제보다 유리하다.",
        },
        Unfinished { missing: usize, jobs: Sentence } => {
            en: "Not finished: {missing} of {jobs} are missing; «`dolmen study`|a study of many runs» with this folder goes on from here. What follows is of the part that is done.",
            ko: "미완료: {jobs} 중 {missing}건이 끝나지 않았다. 같은 폴더로 «`dolmen study`|반복 해석 검토»를 실행하면 이어서 해석하며, 아래 결과는 완료된 부분만의 것이다.",
        },
        InModel(each: Vec<Sentence>) => {
            en: "The model has the damage of inspections: {each}.",
            ko: "모델에 점검에서 확인된 손상을 반영하였다: {each}.",
        },
        InModelOf { runs: Both, each: Vec<Sentence> } => {
            en: "The model has the damage of inspections in the runs of {runs} only: {each}.",
            ko: "{runs}의 해석 모델에만 점검에서 확인된 손상을 반영하였다: {each}.",
        },
        NotInRuns(said: Both) => { en: "Left out: {said}.", ko: "미반영: {said}." },
        Copies(each: Vec<Sentence>) => {
            en: "Motions that are one record count as one: {each}.",
            ko: "같은 기록인 지반운동은 하나로 센다: {each}.",
        },
        Copy { motion: String, of: String } => { en: "{motion} is {of} again", ko: "{motion}은(는) {of}의 사본" },
        Note(note: Both) => { en: "{note}.", ko: "{note}." },
    }
}

/// The runs, the method, and the outcomes.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    let mut said = vec![runs(answer).into()];
    said.extend(samples(answer).map(Sentence::from));
    said.extend(sizes(answer).map(Sentence::from));
    document.put(Block::Paragraph(said));
    let method = both(|language| answer.method(language));
    document.put(Block::Paragraph(vec![
        Done::Method(method).into(),
        ends(answer).into(),
    ]));
    notes(document, answer);
    document
        .blocks
        .extend(copies(answer).map(|said| Block::Warning(said.into())));
    let capacities = answer.capacities();
    let refused = capacities
        .iter()
        .filter(|scan| scan.verdict == ScanVerdict::Refused);
    let refused = refused.count();
    if refused > 0 {
        document.note(Done::RefusedScans(scans(refused)));
    }
    for said in refused_for(answer) {
        document.note(said);
    }
    for doubt in doubts(answer) {
        document.put(Block::Warning(doubt.into()));
    }
}

/// The same for a study without scans.
pub(super) fn unscanned(document: &mut Document<'_>, answer: &StudyAnswer) {
    let cases = match answer.cases.len() {
        1 => Words::OneCase.into(),
        count => Words::Cases { count }.into(),
    };
    let method = both(|language| answer.method(language));
    document.put(Block::Paragraph(vec![
        Done::Cases(cases).into(),
        Done::Method(method).into(),
    ]));
    notes(document, answer);
}

fn notes(document: &mut Document<'_>, answer: &StudyAnswer) {
    for said in damage(answer) {
        document.put(Block::Warning(said.into()));
    }
    for said in &answer.left_out_of_runs {
        let said = said.clone();
        document.put(Block::Warning(Done::NotInRuns(said).into()));
    }
    for note in &answer.notes {
        document.note(Done::Note(note.clone()));
    }
}

/// Damage of inspections in the models, by the runs that have it.
pub(super) fn damage(answer: &StudyAnswer) -> Vec<Done> {
    let mut by_runs: Vec<(&Option<Both>, Vec<Sentence>)> = Vec::new();
    for of in &answer.model_damage {
        let said = damaged(&of.damage);
        match by_runs.iter_mut().find(|(only_in, _)| **only_in == of.only_in) {
            Some((_, each)) => each.push(said),
            None => by_runs.push((&of.only_in, vec![said])),
        }
    }
    let each = by_runs.into_iter().map(|(only_in, each)| match only_in {
        None => Done::InModel(each),
        Some(runs) => Done::InModelOf {
            runs: runs.clone(),
            each,
        },
    });
    each.collect()
}

/// Each reason for which scans were refused.
pub(super) fn refused_for(answer: &StudyAnswer) -> Vec<Done> {
    let each = answer.refusals().into_iter();
    let each = each.map(|(why, count)| Done::RefusedFor {
        count,
        why: why.clone(),
    });
    each.collect()
}

/// Motions that are copies of others.
pub(super) fn copies(answer: &StudyAnswer) -> Option<Done> {
    let each = answer.copies.iter().map(|copy| {
        let (motion, of) = (copy.motion.clone(), copy.of.clone());
        Done::Copy { motion, of }.into()
    });
    let each: Vec<Sentence> = each.collect();
    (!each.is_empty()).then_some(Done::Copies(each))
}

/// Doubts from the runs themselves.
pub(super) fn doubts(answer: &StudyAnswer) -> Vec<Done> {
    let beyond = answer.beyond_room().map(|(beyond, all, least)| Done::BeyondRoom {
        beyond,
        all,
        least: g(answer, least),
    });
    let unfinished = (!answer.missing.is_empty()).then(|| Done::Unfinished {
        missing: answer.missing.len(),
        jobs: scans(answer.jobs()),
    });
    beyond.into_iter().chain(unfinished).collect()
}

fn runs(answer: &StudyAnswer) -> Done {
    let (runs, cases) = (answer.runs.len(), answer.cases.len());
    let (motions, turns) = (answer.motions.len(), answer.study.turns_rad.len());
    let counted = |count: usize, one: Words, many: Words| match count {
        1 => one.into(),
        _ => many.into(),
    };
    Done::Runs {
        runs: counted(runs, Words::OneRun, Words::Runs { count: runs }),
        cases: counted(cases, Words::OneCase, Words::Cases { count: cases }),
        motions: counted(motions, Words::OneMotion, Words::Motions { count: motions }),
        directions: counted(turns, Words::OneDirection, Words::Directions { count: turns }),
    }
}

fn samples(answer: &StudyAnswer) -> Option<Done> {
    let samples = answer.study.samples?;
    Some(Done::Samples {
        samples,
        seed: answer.study.seed.to_string(),
    })
}

/// The sizes of shaking.
fn sizes(answer: &StudyAnswer) -> Option<Done> {
    let part = match answer.study.refine {
        0 => Done::Whole,
        halvings => Done::Part((1_u64 << halvings.min(63)).to_string()),
    };
    let part = part.into();
    let scale = |value: f64| Quantity::ratio(value, 3);
    let peak = |value: f64| {
        let mut peak = g(answer, value);
        peak.digits = dolmen_words::Digits::Significant(3);
        peak
    };
    match answer.study.scan.as_ref()? {
        Scan::Scales(values) => match values.as_slice() {
            [] => None,
            [only] => Some(Done::OneScale(scale(*only))),
            [first, .., last] => Some(Done::Scales {
                count: values.len(),
                first: scale(*first),
                last: scale(*last),
                part,
            }),
        },
        Scan::Peaks(values) => match values.as_slice() {
            [] => None,
            [only] => Some(Done::OnePeak(peak(*only))),
            [first, .., last] => Some(Done::Peaks {
                count: values.len(),
                first: peak(*first),
                last: peak(*last),
                part,
            }),
        },
    }
}

fn ends(answer: &StudyAnswer) -> Done {
    let one = |(outcome, count): (RunOutcome, usize)| {
        let outcome = ended(answer.kind, outcome).into();
        Done::Ended { count, outcome }.into()
    };
    let each: Vec<Sentence> = answer.outcomes().into_iter().map(one).collect();
    match each.is_empty() {
        true => Done::Ends(vec![name("–")]),
        false => Done::Ends(each),
    }
}

fn ended(kind: StudyKind, outcome: RunOutcome) -> Done {
    match outcome {
        RunOutcome::Stood => Done::Stood,
        RunOutcome::Uplifted => Done::Uplifted,
        RunOutcome::Slid => Done::Slid,
        RunOutcome::Fell => match kind {
            StudyKind::Frame => Done::BeyondDrift,
            StudyKind::Building => Done::BeyondLastDrift,
            StudyKind::Stack | StudyKind::Chain => Done::Fell,
        },
        RunOutcome::StillMoving => Done::StillMoving,
        RunOutcome::Diverged => Done::Diverged,
        RunOutcome::Refused => Done::Refused,
    }
}
