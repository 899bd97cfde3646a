//! Logs of tilts and cracks as tables, and the rows left out of their files.

use super::numbers::{HALF_95, label, logged, logged_unit, plain};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_words::message::Both;
use dolmen_words::{Unit, messages};
use dolmen_work::date_text;
use dolmen_work::watched::WatchAnswer;
use dolmen_work::watched_log::WatchedLog;

messages! {
    /// Tables of logs.
    pub(crate) enum LogTable in "watch.log.table" {
        Tilts => {
            en: "Logged tilts, one median a day. The slope stands beside a wave of one year of the given half height, what goes with temperature, and shifts at works; it rests on medians of so many days, which of 1, 7 and 30 say least.",
            ko: "기울기 연속 기록(하루 중앙값). 추세는 연주기 변동(반진폭), 온도 영향, 보수·사건 때의 변화를 함께 추정하여 구하였으며 1일, 7일, 30일 중앙값 가운데 가장 불확실한 것에 따른다.",
        },
        Cracks => {
            en: "Logged cracks, one median a day; the slope is sought as that of a tilt, beside the season, temperature and shifts at works.",
            ko: "균열 폭 연속 기록(하루 중앙값). 추세는 기울기와 같이 계절 변동, 온도 영향, 보수·사건 때의 변화를 함께 추정하였다.",
        },
        Log => { en: "log", ko: "기록" },
        From => { en: "from", ko: "시작" },
        To => { en: "to", ko: "끝" },
        Days => { en: "days", ko: "일수" },
        Now => { en: "now", ko: "현재" },
        Limit => { en: "limit", ko: "한계" },
        PerYear => { en: "a year", ko: "연간 변화" },
        Half => { en: "± 95 %", ko: "± 95 %" },
        SeenFrom => { en: "seen from", ko: "검출 한계" },
        Season => { en: "season", ko: "계절" },
        PerC => { en: "per °C", ko: "1 °C당" },
        Block => { en: "medians of", ko: "중앙값" },
        Name { label: Both } => { en: "{label}", ko: "{label}" },
        Text { text: String } => { en: "{text}", ko: "{text}" },
        Thinned { label: Both, readings: usize, days: usize } => {
            en: "{label}: {readings} readings are taken as the medians of {days} days.",
            ko: "{label}: 읽은 값 {readings}개를 {days}일의 중앙값으로 줄였다.",
        },
        Rows { label: Both, gaps: usize, repeated: usize, set_back: usize } => {
            en: "{label}: rows without a reading {gaps}; of a time that is there already {repeated}, the last one counts; before the row above {set_back}.",
            ko: "{label}: 값이 없는 행 {gaps}개, 시각이 겹치는 행 {repeated}개(마지막 값 사용), 앞 행보다 이른 행 {set_back}개.",
        },
        Clock { label: Both, count: usize } => {
            en: "{label}: the clock of the logger was wrong; readings left out: {count}. If their dates are right, put the rows of the file in order.",
            ko: "{label}: 기록계의 시각이 틀려 제외한 값이 {count}개이다. 날짜가 맞다면 파일의 행을 시간순으로 정렬한다.",
        },
        Spikes { label: Both, days: String } => {
            en: "{label}: days far from the fortnight around them are left out: {days}.",
            ko: "{label}: 앞뒤 2주의 값과 동떨어져 제외한 날: {days}.",
        },
        OfWorks { label: Both, days: usize } => {
            en: "{label}: days of works and events, and beside them, left out: {days}.",
            ko: "{label}: 보수·사건이 있던 날과 그 전후로 제외한 날이 {days}일이다.",
        },
        Cold { label: Both, days: usize } => {
            en: "{label}: days left out since their temperature is not known: {days}.",
            ko: "{label}: 온도를 알 수 없어 제외한 날이 {days}일이다.",
        },
    }
}

/// Number of days that a cell names.
const NAMED_MOST: usize = 6;

/// The tables, and notes on omitted rows.
pub(super) fn put(document: &mut Document<'_>, answer: &WatchAnswer) {
    for is_tilt in [true, false] {
        let of_kind: Vec<&WatchedLog> = answer
            .logs
            .iter()
            .filter(|log| log.is_tilt() == is_tilt)
            .collect();
        if !of_kind.is_empty() {
            document.put(Block::Table(table(&of_kind, is_tilt)));
        }
    }
    for log in &answer.logs {
        notes(document, log);
    }
}

fn table(logs: &[&WatchedLog], is_tilt: bool) -> Table {
    let numbers = |head: LogTable| Column::numbers(head, logged_unit(is_tilt));
    Table {
        caption: vec![
            if is_tilt {
                LogTable::Tilts
            } else {
                LogTable::Cracks
            }
            .into(),
        ],
        columns: vec![
            Column::words(LogTable::Log),
            Column::words(LogTable::From),
            Column::words(LogTable::To),
            Column::numbers(LogTable::Days, Unit::ratio()),
            numbers(LogTable::Now),
            numbers(LogTable::Limit),
            numbers(LogTable::PerYear),
            numbers(LogTable::Half),
            numbers(LogTable::SeenFrom),
            numbers(LogTable::Season),
            numbers(LogTable::PerC),
            Column::numbers(LogTable::Block, Unit::si("d")),
        ],
        rows: logs.iter().map(|log| row(log, is_tilt)).collect(),
    }
}

fn row(log: &WatchedLog, is_tilt: bool) -> Vec<Cell> {
    let (trend, slope) = (&log.trend, log.trend.slope.as_ref().ok());
    let date = |day: Option<f64>| {
        let text = day.map_or_else(String::new, date_text);
        Cell::words(LogTable::Text { text })
    };
    let size = |value: f64, decimals| logged(value, is_tilt, decimals);
    let per_year = slope.map(|slope| size(slope.per_year, 3));
    vec![
        Cell::words(LogTable::Name { label: label(log) }),
        date(log.span().map(|span| span[0])),
        date(log.span().map(|span| span[1])),
        Cell::number(plain(trend.daily.days.len() as f64, 0)),
        match log.is_beyond() {
            true => Cell::Bad(size(trend.size_to_judge(), 2)),
            false => Cell::number(size(trend.now, 2)),
        },
        Cell::Number(trend.limit.map(|limit| size(limit.size, 2))),
        Cell::Number(per_year),
        Cell::Number(slope.map(|slope| size(HALF_95 * slope.sd_per_year, 3))),
        Cell::Number(slope.map(|slope| size(slope.seen_from_per_year, 3))),
        Cell::Number(trend.season.map(|season| size(season, 2))),
        Cell::Number(trend.per_c.map(|(per_c, _)| size(per_c, 3))),
        Cell::Number(slope.map(|_| plain(trend.block_days, 0))),
    ]
}

fn notes(document: &mut Document<'_>, log: &WatchedLog) {
    let (rows, trend) = (&log.rows, &log.trend);
    let (readings, days) = (trend.daily.readings, trend.daily.days.len());
    if readings > days {
        document.note(LogTable::Thinned {
            label: label(log),
            readings,
            days,
        });
    }
    if rows.gaps + rows.repeated + rows.set_back > 0 {
        document.note(LogTable::Rows {
            label: label(log),
            gaps: rows.gaps,
            repeated: rows.repeated,
            set_back: rows.set_back,
        });
    }
    let count = rows.misdated + trend.daily.stray;
    if count > 0 {
        document.note(LogTable::Clock {
            label: label(log),
            count,
        });
    }
    if !trend.spikes.is_empty() {
        let mut named: Vec<String> = trend
            .spikes
            .iter()
            .take(NAMED_MOST)
            .map(|day| date_text(*day))
            .collect();
        if trend.spikes.len() > NAMED_MOST {
            named.push(format!("… ({})", trend.spikes.len()));
        }
        document.note(LogTable::Spikes {
            label: label(log),
            days: named.join(", "),
        });
    }
    if trend.of_works > 0 {
        document.note(LogTable::OfWorks {
            label: label(log),
            days: trend.of_works,
        });
    }
    if trend.without_temperature > 0 {
        document.note(LogTable::Cold {
            label: label(log),
            days: trend.without_temperature,
        });
    }
}
