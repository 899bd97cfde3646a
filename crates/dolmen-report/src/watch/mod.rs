//! The structure over the years: findings, and the section on its surveys over time.

mod cause;
mod chance;
mod dated_changes;
mod doubts;
mod earthquakes;
mod exchanged;
mod failing;
mod findings;
mod inspected;
mod inspected_tables;
mod last;
mod latest;
mod log_limits;
mod log_table;
mod logs;
mod lost;
mod none_judged;
mod numbers;
mod parts;
mod sensors_moved;
mod tables;
mod tilts;
mod unsearched;

pub(crate) use findings::findings;
pub(crate) use inspected::{beyond_limits, damage_name};
pub(crate) use numbers::label;

use crate::document::{Block, Document, Figure};
use crate::figures::{years, years_series};
use dolmen_words::{Quantity, Sentence, Template, messages};
use dolmen_work::watched::WatchAnswer;
use numbers::percent;

messages! {
    /// Heading and figure of the section, and its limitations.
    pub(crate) enum Years in "watch" {
        Head => { en: "The structure over the years", ko: "여러 해에 걸친 구조물의 변화" },
        Drawn => {
            en: "Frequencies with what explains them, and each survey against those before it.",
            ko: "고유진동수와 모델의 설명값, 이전 조사로 예측한 값과의 차이.",
        },
        Panels => {
            en: "From above: relative frequency of each mode (dots) with weather, works and changes (lines); the moving average of each mode over its limit, beyond ±1 an alarm; T² of all modes over its limit; tilt; what is logged, with the trend (line) and its limit; sizes of damage as inspections read them (dots), with the limit. Panels without values are left out. Upright lines are works and events, numbered as in the list.",
            ko: "위에서부터 모드별 상대 고유진동수(점)와 기온·보수·변화로 설명되는 값(선), 모드별 이동평균의 한계 대비 값(±1을 벗어나면 경보), 전체 모드의 T²의 한계 대비 값, 기울기, 연속 기록과 그 추세(선) 및 한계, 점검에서 잰 손상의 크기(점)와 한계. 값이 없는 그래프는 생략하였다. 세로선은 보수와 사건이며 번호는 목록과 같다.",
        },
        Work { number: usize, date: String, what: String } => {
            en: "{number}. {date}: {what}",
            ko: "{number}. {date}: {what}",
        },
        LeftOut { names: String } => {
            en: "Left out, since their names begin with no date, they have no modes, or another survey is of the same day and their names say more than when: {names}.",
            ko: "이름이 날짜로 시작하지 않거나, 모드가 없거나, 이름에 시각 외의 말이 있고 같은 날의 다른 조사가 있어 제외한 조사: {names}.",
        },
        Several { days: usize, surveys: usize } => {
            en: "Surveys of one day count as one, the medians of what they read: {surveys} surveys on {days} days.",
            ko: "같은 날의 조사는 중앙값을 취하여 하나로 보았다: {days}일의 조사 {surveys}건.",
        },
        Without { survey: String, channels: String } => {
            en: "Survey {survey} was identified without sensors that failed: {channels}.",
            ko: "{survey} 조사는 고장 난 센서를 빼고 해석하였다: {channels}.",
        },
        NoProof { share: Quantity } => {
            en: "The search for changes finds one where there is none with {share} probability, all modes together; false alarms are not in it. Frequencies also follow moisture, added mass and the strength of the motion. No change shown is no proof that nothing changed.",
            ko: "실제로는 변화가 없는데 변화로 판정할 확률은 모든 모드를 합하여 {share}이다. 경보의 오경보 확률은 여기에 포함되지 않는다. 고유진동수는 습도, 부가 질량, 진동의 세기에 따라서도 변한다. 변화가 확인되지 않았다는 것은 변화가 없다는 증명이 아니다.",
        },
    }
}

/// Templates of the sentences on a history.
pub(crate) const TEMPLATES: [&[Template]; 23] = [
    parts::Dated::TEMPLATES,
    inspected::Inspections::TEMPLATES,
    inspected_tables::InspectedTable::TEMPLATES,
    doubts::Doubted::TEMPLATES,
    earthquakes::Felt::TEMPLATES,
    logs::Logged::TEMPLATES,
    log_limits::Limited::TEMPLATES,
    log_table::LogTable::TEMPLATES,
    Years::TEMPLATES,
    findings::Found::TEMPLATES,
    last::Last::TEMPLATES,
    last::Unjudged::TEMPLATES,
    latest::Latest::TEMPLATES,
    lost::Missing::TEMPLATES,
    none_judged::NoneJudged::TEMPLATES,
    sensors_moved::Moved::TEMPLATES,
    tilts::Tilted::TEMPLATES,
    exchanged::Exchanged::TEMPLATES,
    cause::Cause::TEMPLATES,
    chance::Chance::TEMPLATES,
    unsearched::Unsearched::TEMPLATES,
    failing::Failing::TEMPLATES,
    tables::Listed::TEMPLATES,
];

/// The section on the surveys of a project over time.
pub(crate) fn sections(answer: &WatchAnswer) -> Document<'_> {
    let mut document = Document::default();
    document.heading(Years::Head);
    let drawn = Figure::drawn(vec![Years::Drawn.into(), Years::Panels.into()], |language| {
        years(answer, language)
    });
    document.charted(drawn.with_series(|| years_series(answer)));
    let works: Vec<Sentence> = answer
        .works
        .iter()
        .enumerate()
        .map(|(i, (_, work))| {
            let what = work.what.clone().unwrap_or_default();
            let date = work.date.clone();
            Years::Work {
                number: i + 1,
                date,
                what,
            }
            .into()
        })
        .collect();
    if !works.is_empty() {
        document.put(Block::List(works));
    }
    tables::put(&mut document, answer);
    parts::put(&mut document, answer);
    log_table::put(&mut document, answer);
    inspected_tables::put(&mut document, answer);
    if !answer.several.is_empty() {
        document.note(Years::Several {
            days: answer.several.len(),
            surveys: answer.several.iter().map(|(_, surveys)| surveys).sum(),
        });
    }
    for (survey, channels) in &answer.sensors_left_out {
        document.note(Years::Without {
            survey: survey.clone(),
            channels: channels.join(", "),
        });
    }
    if !answer.left_out.is_empty() {
        document.note(Years::LeftOut {
            names: answer.left_out.join(", "),
        });
    }
    if !answer.watched.modes.is_empty() {
        document.paragraph(Years::NoProof {
            share: percent(answer.watched.significance, 0),
        });
    }
    document
}
