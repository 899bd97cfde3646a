//! Main findings on dampers: those worse than none, those without enough room, and the gain of the optimum.

use super::floors;
use super::words::{of_none, part, point_ratio, under_words};
use crate::building::{millimetres, name, significant};
use crate::document::{Finding, Tone};
use dolmen::damper::Choice;
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::building::{RoomCheck, TogetherAnswer, TogetherChoice, TuneAnswer, TuneLoad};

messages! {
    /// Findings on dampers.
    pub(crate) enum Found in "tune.findings" {
        Worse { damper: String, list: Vec<Sentence> } => {
            en: "Damper {damper} makes points worse than no damper: {list} of the motion without it.",
            ko: "감쇠기 {damper}은(는) 비제어보다 응답을 키운다: 비제어 대비 {list}.",
        },
        BeyondRoom { damper: String, under: Sentence, needed: Quantity, has: Quantity } => {
            en: "Damper {damper} is beyond its room under {under}: it needs {needed} each way and has {has}.",
            ko: "감쇠기 {damper}의 행정 {needed}이(가) 여유 공간 {has}을(를) 넘는다({under}).",
        },
        BeyondRoomAlone { damper: String, under: Sentence, needed: Quantity, has: Quantity } => {
            en: "Damper {damper} by itself is beyond its room under {under}: it needs {needed} each way and has {has}.",
            ko: "감쇠기 {damper}만 있을 때의 행정 {needed}이(가) 여유 공간 {has}을(를) 넘는다({under}).",
        },
        RoomUnjudged => {
            en: "The room of a damper is given, and the file has no motion or site to hold it against; the loads here have no size.",
            ko: "감쇠기의 여유 공간은 주어졌으나 비교할 지반운동이나 부지 스펙트럼이 없다. 여기의 하중은 크기가 정해져 있지 않다.",
        },
        RoomInWind => {
            en: "The room of a damper is given: «`dolmen check`|the check of stability» holds it against the wind of the file.",
            ko: "감쇠기의 여유 공간이 주어졌다. 파일의 바람에 대한 비교는 «`dolmen check`|안정성 검토»에 나온다.",
        },
        Compared { damper: String, given: Quantity, rule: Quantity, best: Quantity } => {
            en: "Damper {damper}: response over that without it {given} as in the file, {rule} at the place of the rule, {best} placed and tuned best.",
            ko: "감쇠기 {damper}: 감쇠기가 없을 때에 대한 응답비는 입력한 감쇠기 {given}, 논문의 규칙에 따른 위치 {rule}, 최적 위치와 동조 {best}이다.",
        },
        ComparedKept { damper: String, given: Quantity, rule: Quantity, best: Quantity, most: Quantity } => {
            en: "Damper {damper}: response over that without it {given} as in the file, {rule} at the place of the rule, {best} placed and tuned best, where {most} of its stroke was asked for.",
            ko: "감쇠기 {damper}: 감쇠기가 없을 때에 대한 응답비는 입력한 감쇠기 {given}, 논문의 규칙에 따른 위치 {rule}, 행정을 입력한 감쇠기의 {most}배로 제한하여 구한 최적 위치와 동조 {best}이다.",
        },
        OfDeviations { said: Sentence } => {
            en: "{said} These are standard deviations: the largest peak is sought for single dampers only.",
            ko: "{said} 이 값은 표준편차의 비이며, 최대 피크는 단일 감쇠기에 대해서만 구한다.",
        },
        OffOnlyAlone { share: Quantity } => {
            en: "Frequencies off by {share} are taken into account for each damper by itself, not for all together.",
            ko: "진동수 오차 {share}은(는) 감쇠기별 설계에만 반영하였고 전체 동시 설계에는 반영하지 않았다.",
        },
        ComparedTogether { given: Quantity, best: Quantity } => {
            en: "All dampers together: response over that without them {given} as in the file, {best} placed and tuned best together.",
            ko: "감쇠기 전체: 감쇠기가 없을 때에 대한 응답비는 입력한 감쇠기 {given}, 위치와 동조 동시 최적 {best}이다.",
        },
        ComparedTogetherKept { given: Quantity, best: Quantity, most: Quantity } => {
            en: "All dampers together: response over that without them {given} as in the file, {best} placed and tuned best together, where {most} of the strokes was asked for.",
            ko: "감쇠기 전체: 감쇠기가 없을 때에 대한 응답비는 입력한 감쇠기 {given}, 행정을 입력한 감쇠기의 {most}배로 제한하여 구한 위치와 동조 동시 최적 {best}이다.",
        },
    }
}

/// Findings on each damper alone, and on all together.
pub(crate) fn findings(tunings: &[&TuneAnswer], together: &[&TogetherAnswer]) -> Vec<Finding> {
    let mut all: Vec<Finding> = tunings.iter().flat_map(|answer| of_one(answer)).collect();
    all.extend(together.iter().flat_map(|answer| of_all(answer)));
    let mut rooms = tunings.iter().map(|answer| &answer.room);
    let mut others = together.iter().map(|answer| &answer.room);
    if rooms.any(RoomCheck::is_unjudged) || others.any(RoomCheck::is_unjudged) {
        let alone = tunings.iter().map(|answer| answer.load);
        let mut loads = alone.chain(together.iter().map(|answer| answer.load));
        let rooms = tunings.iter().map(|answer| &answer.room);
        let mut rooms = rooms.chain(together.iter().map(|answer| &answer.room));
        let said = match loads.any(|load| load == TuneLoad::Gusts) || rooms.any(|room| room.has_wind) {
            true => Finding::key(Tone::Plain, Found::RoomInWind),
            false => Finding::key(Tone::Unknown, Found::RoomUnjudged),
        };
        all.push(said);
    }
    all
}

/// Whether a finding only points at a check, which a report has.
pub(crate) fn points_at_check(finding: &Finding) -> bool {
    finding.sentence == Sentence::from(Found::RoomInWind)
}

fn of_one(answer: &TuneAnswer) -> Vec<Finding> {
    let comparison = &answer.comparison;
    let worse = comparison.row(Choice::Given).map(|row| answer.worse(row));
    let list = worse.unwrap_or_default().into_iter();
    let list: Vec<Sentence> = list
        .map(|(point, ratio)| point_ratio(name(&point.name), ratio, 3))
        .collect();
    let mut all = Vec::new();
    if !list.is_empty() {
        let damper = answer.damper.clone();
        all.push(Finding::key(Tone::Bad, Found::Worse { damper, list }));
    }
    all.extend(beyond_room(&answer.room, answer.others > 0, |row| {
        let row = comparison.rows.get(row);
        row.is_some_and(|row| row.choice == Choice::Given)
    }));
    let ratio = |choice| {
        let row = comparison.row(choice)?;
        Some(of_none(row.cost / comparison.cost_without, 3))
    };
    if let (Some(given), Some(best), Some(rule)) =
        (ratio(Choice::Given), ratio(Choice::Best), ratio(Choice::Rule))
    {
        let damper = answer.damper.clone();
        let said = match answer.stroke_most.map(part) {
            None => Found::Compared {
                damper,
                given,
                rule,
                best,
            },
            Some(most) => Found::ComparedKept {
                damper,
                given,
                rule,
                best,
                most,
            },
        };
        all.push(Finding::key(Tone::Plain, said));
    }
    all.extend(floors::findings(answer));
    all
}

fn of_all(answer: &TogetherAnswer) -> Vec<Finding> {
    let mut all = beyond_room(&answer.room, false, |row| {
        let row = answer.rows.get(row);
        row.is_some_and(|row| row.choice == TogetherChoice::Given)
    });
    let ratio = |choice: TogetherChoice| {
        let row = answer.rows.iter().find(|row| row.choice == choice)?;
        Some(of_none(answer.cost_ratio(row), 3))
    };
    if let (Some(given), Some(best)) = (ratio(TogetherChoice::Given), ratio(TogetherChoice::Best)) {
        let said = match answer.stroke_most.map(part) {
            None => Found::ComparedTogether { given, best },
            Some(most) => Found::ComparedTogetherKept { given, best, most },
        };
        let said = match answer.peaks_not_sought {
            true => Found::OfDeviations { said: said.into() },
            false => said,
        };
        all.push(Finding::key(Tone::Plain, said));
    }
    if answer.off_by > 0.0 {
        let share = Quantity::percent(answer.off_by, 3);
        all.push(Finding::key(Tone::Plain, Found::OffOnlyAlone { share }));
    }
    all
}

/// Dampers of the file that need more room than they have; `alone`: without the file's other dampers.
fn beyond_room(room: &RoomCheck, alone: bool, is_given: impl Fn(usize) -> bool) -> Vec<Finding> {
    let beyond = room.beyond().filter(|of| is_given(of.row));
    let said = beyond.map(|of| {
        let (damper, under) = (of.damper.clone(), under_words(of));
        let needed = significant(of.stroke_m, millimetres(), 4);
        let has = significant(of.room_m, millimetres(), 4);
        match alone {
            true => Found::BeyondRoomAlone {
                damper,
                under,
                needed,
                has,
            },
            false => Found::BeyondRoom {
                damper,
                under,
                needed,
                has,
            },
        }
    });
    said.map(|said| Finding::key(Tone::Bad, said)).collect()
}
