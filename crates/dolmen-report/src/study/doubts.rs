//! Doubts about capacities: unusable scans, falls at the smallest size, sizes survived above a fall.

use super::capacities::Capacities;
use super::words::{g, scan, scans};
use crate::document::{Block, Document};
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::study::{CapacityOf, ScanVerdict, StudyAnswer, StudyKind};

/// Largest number of scans that a doubt names; capacities.csv has the others.
const NAMED_MOST: usize = 10;

messages! {
    /// Unusable scans.
    pub(crate) enum LeftOut in "study.left-out" {
        Unusable { out: usize, jobs: Sentence } => {
            en: "{out} of {jobs} cannot be used and are in no quantile and no trend: runs below their first fall were refused or gave no result. Their brackets are in capacities.csv.",
            ko: "{jobs} 중 {out}건은 최초 붕괴보다 작은 지반운동에서 결과를 얻지 못하여 사용할 수 없으며, 분위수와 경향에서 제외하였다. 붕괴 가속도의 범위는 capacities.csv에 있다.",
        },
        One { number: usize, scan: Sentence, why: Sentence } => {
            en: "Scan {number} ({scan}): {why}.",
            ko: "증분해석 {number}({scan}): {why}.",
        },
        Refused => { en: "its inputs were refused", ko: "입력이 거부되었다" },
        Missing => { en: "not finished", ko: "완료되지 않았다" },
        Unknown(above: Quantity) => { en: "survived up to {above}, unknown above", ko: "{above}까지 견뎠으며 그 위는 알 수 없다" },
        Between { above: Quantity, fell: Quantity } => {
            en: "survived up to {above}, unknown above, fell at {fell}",
            ko: "{above}까지 견뎠고 {fell}에서 붕괴하였으며 그 사이는 알 수 없다",
        },
        Below(fell: Quantity) => { en: "unknown below {fell}, where it fell", ko: "{fell}에서 붕괴하였으며 그 아래는 알 수 없다" },
        Nothing => { en: "no run of it can be used", ko: "사용할 수 있는 해석이 없다" },
        More(more: usize) => { en: "And {more} more: capacities.csv.", ko: "그 밖의 {more}건은 capacities.csv에 있다." },
    }
}

/// The doubts, and the information of each unusable scan.
pub(super) fn section(document: &mut Document<'_>, answer: &StudyAnswer) {
    for doubt in doubts(answer) {
        document.put(Block::Warning(doubt));
    }
    let capacities = answer.capacities();
    let unusable = capacities.iter().filter(|scan| !scan.verdict.is_usable());
    let unusable: Vec<&CapacityOf> = unusable.collect();
    let mut named: Vec<Sentence> = unusable
        .iter()
        .take(NAMED_MOST)
        .map(|of| one(answer, of).into())
        .collect();
    if unusable.len() > NAMED_MOST {
        let more = unusable.len() - NAMED_MOST;
        named.push(LeftOut::More(more).into());
    }
    if !named.is_empty() {
        document.put(Block::List(named));
    }
    document
        .blocks
        .extend(survived_larger(answer).map(|said| Block::Paragraph(vec![said])));
}

/// The warnings.
pub(super) fn doubts(answer: &StudyAnswer) -> Vec<Sentence> {
    let mut said = Vec::new();
    let out = answer.left_out().saturating_sub(answer.missing.len()); // another sentence counts unfinished scans
    if out > 0 {
        let jobs = scans(answer.jobs());
        said.push(LeftOut::Unusable { out, jobs }.into());
    }
    let at_once = answer.fell_at_the_least();
    if at_once > 0 && answer.kind != StudyKind::Building {
        let all = scans(usable(answer));
        said.push(Capacities::FellAtLeast { at_once, all }.into());
    }
    said
}

/// Number of scans that survived a size above their first fall, if any did.
pub(super) fn survived_larger(answer: &StudyAnswer) -> Option<Sentence> {
    let capacities = answer.capacities();
    let survived = |scan: &&CapacityOf| scan.verdict.is_usable() && !scan.survived_above_m_s2().is_empty();
    let above = capacities.iter().filter(survived).count();
    let all = scans(usable(answer));
    (above > 0).then(|| Capacities::SurvivedLarger { above, all }.into())
}

fn usable(answer: &StudyAnswer) -> usize {
    let capacities = answer.capacities();
    capacities.iter().filter(|scan| scan.verdict.is_usable()).count()
}

fn one(answer: &StudyAnswer, of: &CapacityOf) -> LeftOut {
    let survived = of.survived_m_s2();
    let why = match (of.verdict, of.fell_m_s2()) {
        (ScanVerdict::Refused, _) => LeftOut::Refused,
        (ScanVerdict::Missing, _) => LeftOut::Missing,
        (_, Some(fell)) if survived > 0.0 => LeftOut::Between {
            above: g(answer, survived),
            fell: g(answer, fell),
        },
        (_, None) if survived > 0.0 => LeftOut::Unknown(g(answer, survived)),
        (_, Some(fell)) => LeftOut::Below(g(answer, fell)),
        (_, None) => LeftOut::Nothing,
    };
    LeftOut::One {
        number: of.job + 1,
        scan: scan(answer, of.job),
        why: why.into(),
    }
}
