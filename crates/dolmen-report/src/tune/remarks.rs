//! Notes on each row of a comparison of dampers.

use super::words::{
    ROUNDING, choice_words, of_none, part, point_along, point_ratio, together_words, under_words,
};
use crate::building::{fixed, millimetres, name, significant};
use crate::document::{Block, Document};
use dolmen::damper::{Choice, Compared, DesignEnd};
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::building::{RoomCheck, TogetherAnswer, TogetherChoice, TogetherRow, TuneAnswer};
use dolmen_work::part_limit::Limited;

/// Relative difference from which numbers at tabulated frequencies are called rough.
const ROUGH: f64 = 1e-3;

messages! {
    /// Remarks on rows.
    pub(crate) enum Remark in "tune.remarks" {
        Worse { choice: Sentence, list: Vec<Sentence> } => {
            en: "Worse than no damper: ‘{choice}’, by these factors: {list}.",
            ko: "비제어보다 나쁨: ‘{choice}’, 비제어 대비 배수 {list}.",
        },
        StrokeNotKept { choice: Sentence, ratio: Quantity, most: Quantity } => {
            en: "Stroke not kept: ‘{choice}’ moves {ratio} of the stroke of the file's damper, and {most} was asked for.",
            ko: "행정 제한 불만족: ‘{choice}’의 행정은 입력한 감쇠기의 {ratio}배이며, 요구한 값은 {most}배이다.",
        },
        StrokesNotKept { choice: Sentence, list: Vec<Sentence>, most: Quantity } => {
            en: "Stroke not kept: ‘{choice}’, over that as in the file: {list}; {most} was asked for.",
            ko: "행정 제한 불만족: ‘{choice}’, 입력한 감쇠기에 대한 행정의 배수: {list}. 요구한 값은 {most}배이다.",
        },
        NoDamper { choice: Sentence, ratio: Quantity } => {
            en: "No damper: ‘{choice}’ has a damping ratio of {ratio}: above 1 nothing swings any more, and a project file refuses it.",
            ko: "감쇠기로 쓸 수 없음: ‘{choice}’의 감쇠비는 {ratio}이다. 1을 넘으면 진동하지 않으며 입력 파일에서도 거부된다.",
        },
        NoDampers { choice: Sentence, dampers: Vec<String> } => {
            en: "No damper: ‘{choice}’, a damping ratio above 1 of {dampers}: nothing swings there any more, and a project file refuses it.",
            ko: "감쇠기로 쓸 수 없음: ‘{choice}’에서 {dampers}의 감쇠비가 1을 넘는다. 1을 넘으면 진동하지 않으며 입력 파일에서도 거부된다.",
        },
        BeyondRoom { choice: Sentence, damper: String, needed: Quantity, under: Sentence, has: Quantity } => {
            en: "Beyond its room: ‘{choice}’, damper {damper} needs {needed} each way under {under} and has {has}.",
            ko: "여유 공간 초과: ‘{choice}’의 경우 {under}에서 감쇠기 {damper}의 행정은 {needed}, 여유 공간은 {has}이다.",
        },
        UnderMotion { choice: Sentence, motion: String, drift: Quantity, strokes: Vec<Sentence> } => {
            en: "Under motion {motion}, ‘{choice}’: largest drift of a storey along x or y {drift} of its height; strokes {strokes}.",
            ko: "지반운동 {motion}, ‘{choice}’: x·y 방향 최대 층간변위각 {drift}, 행정 {strokes}.",
        },
        StrokeInRoom { damper: String, stroke: Quantity, room: Quantity } => {
            en: "{damper} {stroke} (room {room})",
            ko: "{damper} {stroke}(여유 공간 {room})",
        },
        StrokeAlone { damper: String, stroke: Quantity } => { en: "{damper} {stroke}", ko: "{damper} {stroke}" },
        RuleMore { more: Quantity } => {
            en: "The rule, far from the centre of the mode, leaves {more} more than the best.",
            ko: "규칙에 따라 모드 중심에서 먼 곳에 두면 목적함수값이 최적보다 {more} 크다.",
        },
        RuleLess { less: Quantity } => {
            en: "The rule, far from the centre of the mode, leaves {less} less than the best within the limits asked for, and does not keep them.",
            ko: "규칙에 따라 모드 중심에서 먼 곳에 두면 목적함수값이 제한 조건 안의 최적보다 {less} 작지만, 그 조건을 만족하지 않는다.",
        },
        GivenMore { more: Quantity } => {
            en: "The file's damper leaves {more} more than the best.",
            ko: "입력한 감쇠기의 목적함수값은 최적보다 {more} 크다.",
        },
        GivenLess { less: Quantity } => {
            en: "The file's damper leaves {less} less than the best within the limits asked for, and does not keep them.",
            ko: "입력한 감쇠기의 목적함수값은 제한 조건 안의 최적보다 {less} 작지만, 그 조건을 만족하지 않는다.",
        },
        Rough { apart: Quantity } => {
            en: "Rough: maps, lines, tunings, curves of being out of tune and searches are off by up to {apart}: something is damped too lightly for them; the rows of the table are computed afresh.",
            ko: "정밀도 주의: 감쇠가 매우 작은 부분이 있어 평면 분포, 위치 곡선, 동조식 비교, 동조 오차 곡선과 탐색에 최대 {apart}의 오차가 있다. 표의 각 행은 따로 다시 계산한 값이다.",
        },
        Bounded { choice: Sentence, frequency: Quantity, ratio: Quantity } => {
            en: "‘{choice}’ ended where its search is bounded, at {frequency} and damping ratio {ratio}: there may be better beyond.",
            ko: "‘{choice}’의 탐색이 탐색 범위의 경계({frequency}, 감쇠비 {ratio})에서 끝났다. 그 밖에 더 나은 값이 있을 수 있다.",
        },
        AtLimit { choice: Sentence } => {
            en: "‘{choice}’ lies at the limit of a tuning that a damper may have.",
            ko: "‘{choice}’은(는) 감쇠기의 진동수 또는 감쇠의 한계값에 있다.",
        },
        Unsettled { choice: Sentence } => {
            en: "‘{choice}’ is the best that was seen, but its search did not settle to 1e-6.",
            ko: "‘{choice}’은(는) 탐색에서 얻은 가장 좋은 값이나, 탐색이 10⁻⁶까지 수렴하지 않았다.",
        },
        OfTheRule => {
            en: "The rule of Hwang, Min & Hong puts a damper as far from the centre of the mode as the floor allows. It makes the damper work more on that mode, not the points move less. Their eq. 5a gives a damper along x the sign +Y; by their own eq. 12 it is −Y, which is used here.",
            ko: "황재승·민경원·홍성목의 규칙은 감쇠기를 모드 중심에서 가장 먼 곳에 둔다. 이는 해당 모드에 대한 제어 효과를 키울 뿐이며 관측점의 응답을 최소로 하지는 않는다. 논문의 식 (5a)는 x 방향 감쇠기에 +Y를 쓰지만 식 (12)와 맞추면 −Y가 옳으며 여기서는 −Y를 쓴다.",
        },
    }
}

/// Notes on one damper.
pub(super) fn of_one(document: &mut Document<'_>, answer: &TuneAnswer) {
    let rows = &answer.comparison.rows;
    let choice = |row: &Compared| choice_words(row.choice, answer.mode);
    for row in rows {
        let each = answer.worse(row).into_iter();
        worse(
            document,
            choice(row),
            each.map(|(point, ratio)| point_ratio(name(&point.name), ratio, 4)),
        );
        if answer.is_beyond_stroke(row) {
            warn(
                document,
                Remark::StrokeNotKept {
                    choice: choice(row),
                    ratio: of_none(answer.stroke_ratio(row), 4),
                    most: part(answer.stroke_most.unwrap_or_default()),
                },
            );
        }
        if row.damper.damping_ratio > 1.0 {
            let ratio = of_none(row.damper.damping_ratio, 3);
            warn(
                document,
                Remark::NoDamper {
                    choice: choice(row),
                    ratio,
                },
            );
        }
    }
    rooms(document, &answer.room, |row| rows.get(row).map(choice));
    // a single damper out of several does not represent the structure of the file
    let given = |row: usize| {
        rows.get(row)
            .filter(|row| row.choice == Choice::Given && answer.others == 0)
            .map(choice)
    };
    under_motions(document, &answer.room, given);
    for said in costs(answer) {
        document.note(said);
    }
    if answer.comparison.apart > ROUGH {
        let apart = fixed(answer.comparison.apart, Unit::percent(), 1);
        document.note(Remark::Rough { apart });
    }
    for row in rows {
        let choice = choice(row);
        match row.end {
            Some(DesignEnd::Limit) => document.note(Remark::Bounded {
                choice,
                frequency: fixed(row.damper.frequency_hz, Unit::si("Hz"), 5),
                ratio: of_none(row.damper.damping_ratio, 5),
            }),
            Some(DesignEnd::Stalled) => document.note(Remark::Unsettled { choice }),
            None | Some(DesignEnd::Optimum) => {}
        }
    }
    document.note(Remark::OfTheRule);
}

/// Excess of the rule and of the file's damper over the optimum.
fn costs(answer: &TuneAnswer) -> Vec<Remark> {
    let share = |of: f64| fixed(of.abs(), Unit::percent(), 1);
    let rule = answer.costs(Choice::Rule, Choice::Best);
    let rule = rule.map(|of| match of >= 0.0 {
        true => Remark::RuleMore { more: share(of) },
        false => Remark::RuleLess { less: share(of) },
    });
    let given = answer.costs(Choice::Given, Choice::Best);
    let given = given.map(|of| match of >= 0.0 {
        true => Remark::GivenMore { more: share(of) },
        false => Remark::GivenLess { less: share(of) },
    });
    rule.into_iter().chain(given).collect()
}

/// Notes on all dampers together.
pub(super) fn of_all(document: &mut Document<'_>, answer: &TogetherAnswer) {
    let choice = |row: &TogetherRow| together_words(&row.choice);
    rooms(document, &answer.room, |row| answer.rows.get(row).map(choice));
    let rows = &answer.rows;
    let given = |row: usize| {
        rows.get(row)
            .filter(|row| row.choice == TogetherChoice::Given)
            .map(choice)
    };
    under_motions(document, &answer.room, given);
    for row in &answer.rows {
        let each = answer.points.iter().zip(answer.ratios(row));
        let each = each.filter(|(_, ratio)| *ratio > 1.0 + ROUNDING);
        worse(
            document,
            choice(row),
            each.map(|((point, degrees), ratio)| point_ratio(point_along(&point.name, *degrees), ratio, 4)),
        );
        let over = row.dampers.iter().filter(|damper| damper.is_overdamped());
        let dampers: Vec<String> = over.map(|damper| damper.name.clone()).collect();
        if !dampers.is_empty() {
            let choice = choice(row);
            warn(document, Remark::NoDampers { choice, dampers });
        }
        let beyond = answer.beyond_stroke(row).into_iter();
        let list: Vec<Sentence> = beyond
            .map(|(damper, ratio)| point_ratio(name(&damper), ratio, 4))
            .collect();
        if !list.is_empty() {
            warn(
                document,
                Remark::StrokesNotKept {
                    choice: choice(row),
                    list,
                    most: part(answer.stroke_most.unwrap_or_default()),
                },
            );
        }
        match row.end {
            Some(DesignEnd::Limit) => document.note(Remark::AtLimit { choice: choice(row) }),
            Some(DesignEnd::Stalled) => document.note(Remark::Unsettled { choice: choice(row) }),
            None | Some(DesignEnd::Optimum) => {}
        }
    }
}

/// Points with more motion in a row.
fn worse(document: &mut Document<'_>, choice: Sentence, points: impl Iterator<Item = Sentence>) {
    let list: Vec<Sentence> = points.collect();
    if !list.is_empty() {
        warn(document, Remark::Worse { choice, list });
    }
}

/// Dampers of any row that need more room than they have.
fn rooms(document: &mut Document<'_>, room: &RoomCheck, choice: impl Fn(usize) -> Option<Sentence>) {
    for of in room.beyond() {
        let Some(choice) = choice(of.row) else { continue };
        warn(
            document,
            Remark::BeyondRoom {
                choice,
                damper: of.damper.clone(),
                needed: significant(of.stroke_m, millimetres(), 4),
                under: under_words(of),
                has: significant(of.room_m, millimetres(), 4),
            },
        );
    }
}

/// The numbers behind the verdict on the dampers of the file under its motions.
fn under_motions(document: &mut Document<'_>, room: &RoomCheck, given: impl Fn(usize) -> Option<Sentence>) {
    for run in &room.runs {
        let Some(choice) = given(run.row) else { continue };
        let drifts = run.parts.iter().filter(|part| part.limited == Limited::Drift);
        let drift = drifts.map(|part| part.demand).fold(0.0, f64::max);
        let strokes = run.parts.iter().filter(|part| part.limited == Limited::Room);
        let length = |length_m: f64| significant(length_m, millimetres(), 4);
        let strokes = strokes.map(|part| {
            let (damper, stroke) = (part.part.name().to_owned(), length(part.demand));
            match part.capacity.map(length) {
                Some(room) => Remark::StrokeInRoom { damper, stroke, room }.into(),
                None => Remark::StrokeAlone { damper, stroke }.into(),
            }
        });
        document.note(Remark::UnderMotion {
            choice,
            motion: run.motion.clone(),
            drift: Quantity::percent(drift, 3),
            strokes: strokes.collect(),
        });
    }
}

fn warn(document: &mut Document<'_>, said: Remark) {
    document.put(Block::Warning(said.into()));
}
