//! Readings of slow sensors over time: files of a Campbell logger (TOA5), and text tables with a time and values in each row.

use crate::log_order::{OrderedRows, OutOfOrder};
use crate::log_times::{TimeCells, UnclearDay, says_when};
use crate::number::parse_number;
use crate::sheet_error::SheetError;
use crate::text_code::decoded;
use crate::workbook::{is_workbook, workbook_as_csv};
use dolmen_words::sentences;

/// Lines of a TOA5 file before its readings: the station, names, units, and processing.
const TOA5_LINES: usize = 4;
/// First word of such a file.
const TOA5: &str = "TOA5";
/// Number of columns of a file listed in an error.
const SHOWN_MOST: usize = 12;

/// Readings of one column.
#[derive(Clone, Debug, PartialEq)]
pub struct Log {
    /// Time of each, s from 1 January 1970 in the clock of the logger; ascending, without duplicates.
    pub times_s: Vec<f64>,
    /// The values.
    pub values: Vec<f64>,
    /// Rows without a reading: "NAN", or nothing.
    pub gaps: usize,
    /// Rows with a repeated time: the last one is used.
    pub repeated: usize,
    /// Rows with an earlier time than the row before, once rows with the newest first and pasted exports are in order: the clock was set back, or the
    /// logger restarted.
    pub set_back: usize,
    /// Rows more than a day out of order, left out: the clock was wrong.
    pub misdated: usize,
    /// Whether the last row of the file is one of them, so that the newest readings may be missing.
    pub ends_misdated: bool,
    /// The unit of the column in the file: TOA5 has a line of units; tables have them in brackets at the end of a heading, "X (mm/m)".
    pub unit: Option<String>,
}

/// Why a log cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LogError {
    /// The file is not a text table.
    NotText,
    /// The workbook is refused.
    Workbook(SheetError),
    /// Ambiguous dates, whose day may be the month.
    WhichDay {
        /// The first of them.
        found: String,
    },
    /// No line has a time followed by values.
    NoRows,
    /// There is no such column.
    NoColumn {
        /// The name given.
        given: String,
        /// The columns there are.
        known: String,
    },
    /// Several columns are possible.
    WhichColumn {
        /// The possible columns.
        known: String,
    },
    /// Too many rows contradict the others in time for a wrong clock.
    OutOfOrder {
        /// These rows.
        rows: usize,
        /// All rows with a reading.
        read: usize,
    },
    /// Rows have no time.
    NoTime {
        /// The line, from 1.
        line: usize,
        /// The content found there.
        found: String,
    },
    /// A cell is not a number.
    NotANumber {
        /// The line, from 1.
        line: usize,
        /// The content found there.
        found: String,
    },
}

sentences! {
    LogError in "records.log" {
        NotText => {
            en: "the log is no text in UTF-8 or CP949: save it as TOA5 or CSV",
            ko: "기록 파일이 UTF-8이나 CP949 텍스트가 아니다. TOA5나 CSV로 저장한다",
        },
        Workbook(why) => {
            en: "the workbook {why}",
            ko: "통합 문서: {why}",
        },
        WhichDay { found } => {
            en: "the log has dates such as \"{found}\", and no row says whether their day or their month stands first: write them as 2026-11-25",
            ko: "기록 파일의 날짜 \"{found}\"에서 일과 월의 순서를 알 수 없다. 2026-11-25처럼 쓴다",
        },
        NoRows => {
            en: "the log holds no readings: a row begins with its time (\"2026-11-25 10:00\") and has values behind it",
            ko: "기록 파일에 읽은 값이 없다. 각 행은 시각(\"2026-11-25 10:00\")으로 시작하고 그 뒤에 값이 있어야 한다",
        },
        NoColumn { given, known } => {
            en: "the log has no column \"{given}\", but {known}",
            ko: "기록 파일에 열 \"{given}\"이(가) 없다. 있는 열: {known}",
        },
        WhichColumn { known } => {
            en: "the log has several columns: name one of {known}",
            ko: "기록 파일에 열이 여럿 있다. {known} 중 하나를 지정한다",
        },
        OutOfOrder { rows, read } => {
            en: "the rows of the log are not in the order of time: {rows} of {read} contradict the others, too many for a wrong clock. Sort the rows by their time",
            ko: "기록 파일의 행이 시간 순서가 아니다. {read}행 중 {rows}행이 다른 행과 어긋나 시계 오류로 보기에는 너무 많다. 행을 시각 순으로 정렬한다",
        },
        NoTime { line, found } => {
            en: "line {line} of the log begins with \"{found}\", which is no time such as \"2026-11-25 10:00:00\"",
            ko: "기록 파일의 {line}행이 \"{found}\"(으)로 시작하는데 \"2026-11-25 10:00:00\" 같은 시각이 아니다",
        },
        NotANumber { line, found } => {
            en: "line {line} of the log has \"{found}\" where a number should stand; a missing reading is empty or NAN",
            ko: "기록 파일의 {line}행에 수 대신 \"{found}\"이(가) 있다. 없는 값은 비워 두거나 NAN으로 쓴다",
        },
    }
}

/// The readings of one column of a log. `column` is optional if there is only one.
///
/// # Errors
/// [`LogError`].
///
/// # Example
/// ```
/// use dolmen_records::read_log;
/// let text = "\"TOA5\",\"gate\",\"CR1000\"\n\"TIMESTAMP\",\"RECORD\",\"Air_Avg\"\n\"TS\",\"RN\",\"Deg C\"\n\"\",\"\",\"Avg\"\n\"2026-11-25 10:00:00\",7,3.5\n";
/// let log = read_log(text.as_bytes(), Some("Air_Avg"))?;
/// assert_eq!((log.times_s[0], log.values[0]), (1_795_600_800.0, 3.5));
/// # Ok::<(), dolmen_records::LogError>(())
/// ```
pub fn read_log(bytes: &[u8], column: Option<&str>) -> Result<Log, LogError> {
    let table;
    let bytes = match is_workbook(bytes) {
        true => {
            table = workbook_as_csv(bytes).map_err(LogError::Workbook)?;
            &table
        }
        false => bytes,
    };
    let turned = decoded(bytes);
    let text = std::str::from_utf8(&turned.bytes).map_err(|_| LogError::NotText)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines: Vec<&str> = text.lines().collect();
    let is_toa5 = lines
        .first()
        .is_some_and(|line| cells(line, ',').first().is_some_and(|cell| cell == TOA5));
    let (sign, names, first) = match is_toa5 {
        true => (
            ',',
            cells(lines.get(1).copied().unwrap_or_default(), ','),
            TOA5_LINES,
        ),
        false => headed(&lines).ok_or(LogError::NoRows)?,
    };
    let units = match is_toa5 {
        true => cells(lines.get(2).copied().unwrap_or_default(), ','),
        false => Vec::new(),
    };
    let first_row = cells(lines.get(first).copied().unwrap_or_default(), sign);
    let dates = lines.iter().skip(first).map(|line| first_cell(line, sign));
    let times = TimeCells::of(&first_row, dates).map_err(|UnclearDay(found)| LogError::WhichDay { found })?;
    // the record number of a Campbell logger is not a reading
    let is_reading = |at: usize, name: &str| at >= times.cells() && !(is_toa5 && name == "RECORD");
    let at = place(&names, column, is_reading)?;
    let mut rows = Vec::new();
    let mut log = Log {
        times_s: Vec::new(),
        values: Vec::new(),
        gaps: 0,
        repeated: 0,
        set_back: 0,
        misdated: 0,
        ends_misdated: false,
        unit: match is_toa5 {
            true => units.get(at).filter(|unit| !unit.is_empty()).cloned(),
            false => names.get(at).and_then(|name| unit_in_head(name)),
        },
    };
    for (line, row) in lines.iter().enumerate().skip(first) {
        if row.trim().is_empty() {
            continue;
        }
        let row = cells(row, sign);
        let at_s = times.at(&row).ok_or_else(|| LogError::NoTime {
            line: line + 1,
            found: shown(&row[..row.len().min(times.cells())].join(" ")),
        })?;
        let cell = row.get(at).map_or("", String::as_str);
        match reading(cell, sign) {
            Some(Some(value)) => rows.push((at_s, value)),
            Some(None) => log.gaps += 1,
            None => {
                return Err(LogError::NotANumber {
                    line: line + 1,
                    found: shown(cell),
                });
            }
        }
    }
    let read = rows.len();
    let OrderedRows {
        rows,
        set_back,
        misdated,
        ends_misdated,
    } = OrderedRows::of(rows).map_err(|OutOfOrder(rows)| LogError::OutOfOrder { rows, read })?;
    (log.set_back, log.misdated, log.ends_misdated) = (set_back, misdated, ends_misdated);
    for (at_s, value) in rows {
        match log.times_s.last() == Some(&at_s) {
            true => {
                log.repeated += 1;
                log.values.pop();
            }
            false => log.times_s.push(at_s),
        }
        log.values.push(value);
    }
    match log.values.is_empty() {
        true => Err(LogError::NoRows),
        false => Ok(log),
    }
}

/// The separator of columns, their names, and the first line of readings.
fn headed(lines: &[&str]) -> Option<(char, Vec<String>, usize)> {
    let first = lines.iter().position(|line| {
        [',', ';', '\t'].iter().any(|sign| {
            let row = cells(line, *sign);
            row.len() > 1 && says_when(&row[0])
        })
    })?;
    let sign = [';', '\t', ','].into_iter().find(|sign| {
        let row = cells(lines[first], *sign);
        row.len() > 1 && says_when(&row[0])
    })?;
    let names = match first.checked_sub(1).and_then(|above| lines.get(above)) {
        Some(head) => cells(head, sign),
        None => (1..=cells(lines[first], sign).len())
            .map(|number| number.to_string())
            .collect(),
    };
    Some((sign, names, first))
}

fn place(
    names: &[String],
    column: Option<&str>,
    is_reading: impl Fn(usize, &str) -> bool,
) -> Result<usize, LogError> {
    let is_reading = |(at, name): &(usize, &String)| is_reading(*at, name);
    let all: Vec<(usize, &String)> = names.iter().enumerate().filter(is_reading).collect();
    let known = || {
        let names: Vec<String> = all.iter().take(SHOWN_MOST).map(|(_, name)| shown(name)).collect();
        names.join(", ")
    };
    match (column, all.as_slice()) {
        (Some(given), all) => {
            let found = all.iter().find(|(_, name)| *name == given);
            found.map(|(at, _)| *at).ok_or_else(|| LogError::NoColumn {
                given: shown(given),
                known: known(),
            })
        }
        (None, [(at, _)]) => Ok(*at),
        (None, []) => Err(LogError::NoRows),
        (None, _) => Err(LogError::WhichColumn { known: known() }),
    }
}

/// The unit in brackets at the end of a heading: "경사 X (mm/m)". A compass direction, (S), and a number, (2), are not units.
fn unit_in_head(head: &str) -> Option<String> {
    let inside = head.trim_end().strip_suffix([')', ']', '）'])?;
    let (_, unit) = inside.rsplit_once(['(', '[', '（'])?;
    let unit = unit.trim();
    let is_side = matches!(unit, "N" | "S" | "E" | "W" | "n" | "s" | "e" | "w");
    let is_unit = unit
        .chars()
        .any(|sign| sign.is_alphabetic() || "%°℃℉″′".contains(sign));
    (is_unit && !is_side).then(|| unit.to_owned())
}

/// Cells of a row; quotes around a cell are removed, and a separator within them belongs to the cell.
fn cells(row: &str, sign: char) -> Vec<String> {
    let (mut all, mut cell, mut is_quoted) = (Vec::new(), String::new(), false);
    for letter in row.chars() {
        match letter {
            '"' => is_quoted = !is_quoted,
            letter if letter == sign && !is_quoted => all.push(std::mem::take(&mut cell)),
            letter => cell.push(letter),
        }
    }
    all.push(cell);
    all.iter().map(|cell| cell.trim().to_owned()).collect()
}

/// The first cell of a row, which contains no separator.
fn first_cell(row: &str, sign: char) -> &str {
    let cell = row.split(sign).next().unwrap_or_default();
    cell.trim().trim_matches('"').trim()
}

/// A number; `Some(None)` without a reading, `None` for other text.
fn reading(cell: &str, sign: char) -> Option<Option<f64>> {
    let missing = [
        "", "NAN", "NA", "N/A", "NULL", "INF", "-INF", "+INF", "7999", "-7999",
    ];
    if missing.iter().any(|word| cell.eq_ignore_ascii_case(word)) {
        return Some(None);
    }
    let cell = match sign {
        ',' => cell.to_owned(),
        _ => cell.replace(',', "."),
    };
    parse_number(cell.as_bytes())
        .filter(|value| value.is_finite())
        .map(Some)
}

fn shown(text: &str) -> String {
    const MOST: usize = 40;
    text.chars()
        .filter(|sign| !sign.is_control())
        .take(MOST)
        .collect()
}

impl Log {
    /// The mean of the readings between two times; without any, the reading nearest to their middle within `within_s`.
    pub fn around(&self, from_s: f64, to_s: f64, within_s: f64) -> Option<f64> {
        let begin = self.times_s.partition_point(|at| *at < from_s);
        let end = self.times_s.partition_point(|at| *at <= to_s);
        if let Some(read) = self.values.get(begin..end).filter(|read| !read.is_empty()) {
            return Some(read.iter().sum::<f64>() / read.len() as f64);
        }
        let middle_s = f64::midpoint(from_s, to_s);
        let away = |at: usize| self.times_s.get(at).map(|time_s| (time_s - middle_s).abs());
        let near = [begin.checked_sub(1), Some(begin)].into_iter().flatten();
        let (_, at) = near
            .filter_map(|at| Some((away(at).filter(|away| *away <= within_s)?, at)))
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        self.values.get(at).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEN_S: f64 = 1_795_600_800.0; // 2026-11-25 10:00 by `date -u`

    #[test]
    fn exact_gaps_repeats_and_a_clock_set_back_are_counted() {
        let text = "\"TOA5\",\"gate\",\"CR1000\",\"1\"\n\"TIMESTAMP\",\"RECORD\",\"Air, deg\",\"Tilt\"\n\"TS\",\"RN\",\"Deg C\",\"deg\"\n\"\",\"\",\"Avg\",\"Avg\"\n\
            \"2026-11-25 10:00:00\",0,3.5,1\n\"2026-11-25 10:10:00\",1,\"NAN\",1\n\"2026-11-25 10:20:00\",2,4.5,1\n\
            \"2026-11-25 10:20:00\",0,5.5,1\n\"2026-11-25 09:50:00\",1,2.5,1\n\n\"2026-11-25 10:30:00.5\",2,-7999,1\n";
        let log = read_log(text.as_bytes(), Some("Air, deg")).unwrap();
        assert_eq!(log.times_s, [TEN_S - 600.0, TEN_S, TEN_S + 1200.0]);
        assert_eq!(log.values, [2.5, 3.5, 5.5]);
        assert_eq!((log.gaps, log.repeated, log.set_back), (2, 1, 1));
        assert_eq!((log.misdated, log.unit.as_deref()), (0, Some("Deg C")));
        assert_eq!(log.around(TEN_S, TEN_S + 1200.0, 0.0), Some(4.5));
        assert_eq!(log.around(TEN_S + 1300.0, TEN_S + 1400.0, 600.0), Some(5.5));
        assert_eq!(log.around(TEN_S + 1300.0, TEN_S + 1400.0, 60.0), None);
    }

    #[test]
    fn exact_a_logger_that_started_anew_and_one_time_far_ahead() {
        let row = |day: usize, value: usize| format!("2026-11-{day:02} 10:00,{value}\n");
        let mut text = "Time,Tilt\n".to_owned();
        text += &(1..=4).map(|day| row(day, day)).collect::<String>();
        text += "2096-11-05 10:00,99\n"; // a bit of its clock flipped
        text += &(5..=6).map(|day| row(day, day)).collect::<String>();
        text += "1990-01-01 00:00,99\n1990-01-01 00:10,99\n1990-01-03 00:10,99\n"; // its battery was empty
        text += &(9..=12).map(|day| row(day, day)).collect::<String>();
        let log = read_log(text.as_bytes(), None).unwrap();
        assert_eq!(log.values, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 9.0, 10.0, 11.0, 12.0]);
        assert_eq!((log.misdated, log.set_back), (4, 2));
    }

    #[test]
    fn exact_the_hour_that_is_there_twice_when_summer_time_ends() {
        let text = "Time,Tilt\n2026-10-25 01:30,1\n2026-10-25 02:00,2\n2026-10-25 02:30,3\n2026-10-25 02:00,4\n2026-10-25 02:30,5\n2026-10-25 03:00,6\n";
        let log = read_log(text.as_bytes(), None).unwrap();
        assert_eq!(log.values, [1.0, 4.0, 5.0, 6.0]);
        assert_eq!((log.misdated, log.set_back, log.repeated), (0, 1, 2));
        // it stays beside rows with a wrong clock
        let log = read_log(format!("{text}1990-01-01 00:00,99\n").as_bytes(), None).unwrap();
        assert_eq!(log.values, [1.0, 4.0, 5.0, 6.0]);
        assert_eq!((log.misdated, log.repeated), (1, 2));
    }

    #[test]
    fn exact_tables_with_other_separators_and_a_comma_in_numbers() {
        let semicolons = "logger 7\nTime;Air\n2026/11/25 10:00;3,5\n2026/11/25 11:00;4,5\n";
        assert_eq!(read_log(semicolons.as_bytes(), None).unwrap().values, [3.5, 4.5]);
        let days = "\u{feff}2026-11-25,3.5\n2026-11-26,4.5\n";
        let log = read_log(days.as_bytes(), None).unwrap();
        assert_eq!(log.times_s, [TEN_S - 36_000.0, TEN_S + 50_400.0]);
    }

    #[test]
    fn exact_a_log_in_cp949_with_halves_of_the_day() {
        // "시각,기온\n2026-11-25 오전 10:00,3.5\n2026-11-25 오후 12:00,4.5\n".encode("cp949") of Python 3.11
        let bytes = b"\xbd\xc3\xb0\xa2,\xb1\xe2\xbf\xc2\n2026-11-25 \xbf\xc0\xc0\xfc 10:00,3.5\n2026-11-25 \xbf\xc0\xc8\xc4 12:00,4.5\n";
        let log = read_log(bytes, Some("기온")).unwrap();
        assert_eq!(log.times_s, [TEN_S, TEN_S + 7200.0]);
        assert_eq!(log.values, [3.5, 4.5]);
    }

    #[test]
    fn exact_columns_of_date_and_time_and_days_that_stand_first() {
        let apart = "Date,Time,Tilt\n25/11/2026,10:00,1\n25/11/2026,11:00,2\n";
        let log = read_log(apart.as_bytes(), None).unwrap();
        assert_eq!(
            (log.times_s, log.values),
            (vec![TEN_S, TEN_S + 3600.0], vec![1.0, 2.0])
        );
        let dots = "Datum;Neigung\n25.11.2026 10:00;1,5\n";
        assert_eq!(read_log(dots.as_bytes(), None).unwrap().times_s, [TEN_S]);
        let unclear = "Date,Tilt\n05/11/2026,1\n06/11/2026,2\n";
        assert_eq!(
            read_log(unclear.as_bytes(), None).unwrap_err(),
            LogError::WhichDay {
                found: "05/11/2026".into()
            }
        );
    }

    #[test]
    fn refuses_what_is_no_log_and_says_where() {
        let told = |text: &str, column| read_log(text.as_bytes(), column).unwrap_err();
        let two = "time,a,b\n2026-11-25 10:00,1,2\n";
        assert_eq!(told(two, None), LogError::WhichColumn { known: "a, b".into() });
        let (given, known) = ("c".into(), "a, b".into());
        assert_eq!(told(two, Some("c")), LogError::NoColumn { given, known });
        assert_eq!(told("a,b\n1,2\n", None), LogError::NoRows);
        assert_eq!(told("", None), LogError::NoRows);
        let bad = format!("{two}yesterday,1,2\n");
        assert_eq!(
            told(&bad, Some("a")),
            LogError::NoTime {
                line: 3,
                found: "yesterday".into()
            }
        );
        let bad = format!("{two}2026-11-25 11:00,high,2\n");
        assert_eq!(
            told(&bad, Some("a")),
            LogError::NotANumber {
                line: 3,
                found: "high".into()
            }
        );
        assert_eq!(read_log(&[0xff, 0xfe], None).unwrap_err(), LogError::NotText);
    }
}
