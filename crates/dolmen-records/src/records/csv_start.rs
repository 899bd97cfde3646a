//! Detects the layout of a CSV file from its first lines.

use super::date_text::is_date_cell;
use super::decimal_commas::refuse_decimal_commas;
use super::dialect::{Line, holds_cells, line_at, unquoted};
use super::not_a_table::refuse_other_text;
use super::unit::unit_of_label;
use super::{Decimal, Delimiter, FileUnit, Header, RecordError, RecordOptions};
use crate::limits::{CHANNELS_MOST, LimitError};
use crate::number::parse_cell;
use crate::quoted::shown;

/// Number of lines examined for the delimiter.
const LINES_LOOKED_AT: usize = 20;
/// The layout detected in the first lines.
#[derive(Clone, Debug)]
pub(super) struct Start {
    pub(super) delimiter: Delimiter,
    pub(super) decimal: Decimal,
    pub(super) header_line: Option<usize>,
    pub(super) columns: Vec<String>,
    /// First and last line of the text above the column names.
    pub(super) passed_over: Option<[usize; 2]>,
    /// Whether some names are neither UTF-8 nor CP949.
    pub(super) names_unread: bool,
    /// Whether the units are in a separate line below the names.
    pub(super) units_apart: bool,
    /// Whether each line of samples ends with an additional delimiter.
    pub(super) trailing_delimiter: bool,
    /// Which cells of the first line of samples are numbers.
    pub(super) numeric: Vec<bool>,
    /// Position of the first sample, and the number of its line.
    pub(super) samples_at: usize,
    pub(super) samples_line: usize,
}

impl Start {
    pub(super) fn find(bytes: &[u8], options: &RecordOptions) -> Result<Self, RecordError> {
        let (mut at, mut number) = (0, 1);
        let mut lines = Vec::with_capacity(LINES_LOOKED_AT);
        while lines.len() < LINES_LOOKED_AT
            && let Some(line) = line_at(bytes, at, number)?
        {
            if number > options.skip_lines && holds_cells(line.text) {
                lines.push(line);
            }
            (at, number) = (line.next, number + 1);
        }
        lines.first().ok_or(RecordError::Empty)?;
        let (delimiter, decimal) = detect(&lines, options);
        for line in &lines {
            refuse_wide(delimiter.count(line.text), line.number)?;
        }
        let passed_over = match options.header {
            Header::Absent => 0,
            Header::Present | Header::Detect => above_names(&lines, delimiter, decimal),
        };
        // unreadable names are not quoted
        if lines.len() > passed_over + 1 || options.header == Header::Absent {
            refuse_other_text(&lines, passed_over + 1, (delimiter, decimal))?;
        }
        let first = lines[passed_over];
        let is_number = |cell: &&[u8]| parse_cell(unquoted(cell), decimal.byte()).is_some();
        let mut names = delimiter.cells(first.text);
        let has_header = match options.header {
            Header::Present => true,
            Header::Absent => false,
            Header::Detect => is_header(&names, decimal, first.number)?,
        };
        let samples = if has_header {
            lines.get(passed_over + 1)
        } else {
            Some(&first)
        };
        let samples = samples.ok_or(RecordError::OnlyHeader { line: first.number })?;
        let cells = delimiter.cells(samples.text);
        let trailing_delimiter = cells.len() > 1 && cells.last().is_some_and(|c| c.is_empty());
        let count = cells.len() - usize::from(trailing_delimiter);
        if trailing_delimiter && names.len() == cells.len() && names.last().is_some_and(|c| c.is_empty()) {
            names.pop();
        }
        if has_header && decimal == Decimal::Point {
            refuse_decimal_commas(&lines, delimiter)?;
        }
        if names.len() != count && has_header {
            return Err(RecordError::Ragged {
                line: samples.number,
                found: count,
                expected: names.len(),
                last: !samples.ended,
            });
        }
        // a line of units is between the names and the samples
        let of_units = match passed_over.checked_sub(1).map(|at| &lines[at]) {
            Some(line) if has_header && is_of_units(&names, &cells) => {
                let above = delimiter.cells(line.text);
                let is_name = |cell: &&[u8]| !cell.is_empty() && !is_number(cell);
                (above.len() == count && above.iter().all(is_name)).then_some(above)
            }
            _ => None,
        };
        let units_apart = of_units.is_some();
        let passed_over = passed_over - usize::from(units_apart);
        let ColumnNames {
            columns,
            names_unread,
        } = match has_header {
            true => ColumnNames::of(&names[..count], of_units.as_deref()),
            false => ColumnNames::numbered(count),
        };
        Ok(Start {
            delimiter,
            decimal,
            header_line: has_header.then_some(first.number),
            passed_over: match passed_over {
                0 => None,
                _ => Some([lines[0].number, lines[passed_over - 1].number]),
            },
            names_unread,
            units_apart,
            columns,
            trailing_delimiter,
            numeric: cells.iter().map(is_number).collect(),
            samples_at: samples.at,
            samples_line: samples.number,
        })
    }
}

struct ColumnNames {
    columns: Vec<String>,
    /// Whether some names are neither UTF-8 nor CP949.
    names_unread: bool,
}

impl ColumnNames {
    fn numbered(count: usize) -> Self {
        ColumnNames {
            columns: (1..=count).map(|n| format!("ch{n}")).collect(),
            names_unread: false,
        }
    }

    /// The names as written; `above` are the names above a line of units.
    fn of(names: &[&[u8]], above: Option<&[&[u8]]>) -> Self {
        let mut named = Self::numbered(names.len());
        for (at, (column, name)) in named.columns.iter_mut().zip(names).enumerate() {
            let name = match std::str::from_utf8(unquoted(name)) {
                Ok("") if above.is_none() => continue,
                Ok(name) => name,
                Err(_) => {
                    named.names_unread = true;
                    continue;
                }
            };
            *column = match above.map(|above| String::from_utf8_lossy(unquoted(above[at]))) {
                // dates have no unit
                Some(above) if !is_unit(name.as_bytes()) => shown(above.trim()),
                Some(above) => {
                    let unit = name.trim_matches(['(', ')', '[', ']']);
                    shown(&format!("{} ({unit})", above.trim()))
                }
                // names of fixed width are filled with zero bytes
                None => shown(name.trim_matches(char::is_control)),
            };
        }
        named
    }
}

/// Whether a line is a header: it contains no number, or a name for time.
fn is_header(cells: &[&[u8]], decimal: Decimal, line: usize) -> Result<bool, RecordError> {
    // an empty cell is a missing sample, not a name
    let texts = cells.iter().filter(|c| !c.is_empty());
    let is_number = |cell: &&&[u8]| parse_cell(unquoted(cell), decimal.byte()).is_some();
    let numbers = texts.clone().filter(is_number).count();
    let has_time = texts
        .clone()
        .any(|c| matches!(time_name(unquoted(c)), TimeName::Seconds { .. }));
    if numbers > 0 && numbers < texts.count() && !has_time {
        return Err(RecordError::UnclearHeader { line });
    }
    Ok(numbers == 0 || has_time)
}

/// Whether a cell is only a unit, of motion or of time.
fn is_unit(cell: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(cell) else {
        return false;
    };
    let label = text.trim().trim_matches(['(', ')', '[', ']']);
    let of_time = format!("t ({label})");
    matches!(unit_of_label(label), FileUnit::Known(_))
        || matches!(
            time_name(of_time.as_bytes()),
            TimeName::Seconds { named: true, .. }
        )
}

/// Whether a line contains units: one per cell, and above dates any text or none.
fn is_of_units(names: &[&[u8]], samples: &[&[u8]]) -> bool {
    let is_unit = |name: &&[u8]| is_unit(unquoted(name));
    let fits = |(name, sample): (&&[u8], &&[u8])| is_unit(name) || is_date_cell(sample);
    names.iter().any(is_unit) && names.iter().zip(samples).all(fits)
}

/// Refuses more columns than any recorder has; the delimiter at the end of every line may add one.
fn refuse_wide(found: usize, line: usize) -> Result<(), LimitError> {
    match found.saturating_sub(1) <= CHANNELS_MOST {
        true => Ok(()),
        false => Err(LimitError::Columns {
            line,
            found,
            most: CHANNELS_MOST,
        }),
    }
}

/// Number of text lines above the column names, as recorders write them: those before the last line without a number that has as many cells as the
/// samples below it. Zero if any of them could be samples.
fn above_names(lines: &[Line<'_>], delimiter: Delimiter, decimal: Decimal) -> usize {
    let rows: Vec<Vec<&[u8]>> = lines.iter().map(|line| delimiter.cells(line.text)).collect();
    let is_number = |c: &&[u8]| parse_cell(unquoted(c), decimal.byte()).is_some();
    let is_sample = |c: &&[u8]| is_number(c) || is_date_cell(c);
    let whole =
        |cells: &Vec<&[u8]>| cells.len() > 1 && cells.iter().any(&is_number) && cells.iter().all(is_sample);
    let Some(samples) = rows.iter().position(whole) else {
        return 0;
    };
    let is_name = |c: &&[u8]| !c.is_empty() && !is_sample(c);
    match samples.checked_sub(1) {
        Some(names)
            if rows[names].len() == rows[samples].len()
                && (rows[names].iter().all(is_name) || is_of_units(&rows[names], &rows[samples]))
                && rows[..names]
                    .iter()
                    .all(|cells| cells.first().is_some_and(is_name)) =>
        {
            names
        }
        _ => 0,
    }
}

/// Delimiter and decimal sign with the highest score for the first lines. Among equal scores the order is `;`, tab, `,`, white space, and the point
/// before the comma.
fn detect(lines: &[Line<'_>], options: &RecordOptions) -> (Delimiter, Decimal) {
    let mut best = (Delimiter::Semicolon, Decimal::Point);
    let mut best_score = None;
    for delimiter in [
        Delimiter::Semicolon,
        Delimiter::Tab,
        Delimiter::Comma,
        Delimiter::WhiteSpace,
    ] {
        for decimal in [Decimal::Point, Decimal::Comma] {
            let given = options.delimiter.is_none_or(|d| d == delimiter)
                && options.decimal.is_none_or(|d| d == decimal);
            let both_commas = delimiter == Delimiter::Comma && decimal == Decimal::Comma;
            if !given || (both_commas && options.decimal.is_none()) {
                continue;
            }
            let score = score(lines, delimiter, decimal);
            if best_score.is_none_or(|s| score > s) {
                (best, best_score) = ((delimiter, decimal), Some(score));
            }
        }
    }
    best
}

/// Score of the lines: 4 for each line with the usual width and only numbers, 2 if it has mostly numbers and dates; 4 if the first line has the usual
/// width; 1 if that width is more than one cell.
fn score(lines: &[Line<'_>], delimiter: Delimiter, decimal: Decimal) -> usize {
    let rows: Vec<Vec<&[u8]>> = lines
        .iter()
        .map(|line| {
            let mut cells = delimiter.cells(line.text);
            if cells.len() > 1 && cells.last().is_some_and(|c| c.is_empty()) {
                cells.pop();
            }
            cells
        })
        .collect();
    let mut widths: Vec<usize> = rows.iter().map(Vec::len).collect();
    widths.sort_unstable();
    let width = widths[widths.len() / 2];
    let sense = |cells: &Vec<&[u8]>| {
        let is_number = |c: &&&[u8]| parse_cell(unquoted(c), decimal.byte()).is_some();
        let numbers = cells.iter().filter(is_number).count();
        let samples = |least: usize| {
            let more = cells.iter().filter(|c| !is_number(c) && is_date_cell(c));
            2 * (numbers + more.count()) > least
        };
        match cells.len() == width {
            true if numbers == width => 4,
            true if numbers > 0 && samples(width) => 2,
            _ => 0,
        }
    };
    let first = if rows[0].len() == width { 4 } else { 0 };
    rows.iter().map(sense).sum::<usize>() + first + usize::from(width > 1)
}

/// Meaning of a column name for time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum TimeName {
    /// Not a time column.
    No,
    /// Time stamps.
    Seconds {
        /// Seconds per unit of the time stamps.
        unit_s: f64,
        /// Whether the name states the unit.
        named: bool,
    },
    /// Time in an unknown unit.
    Unclear,
}

/// Meaning of a word as a unit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum WordOfTime {
    /// Not a unit.
    None,
    /// A unit.
    Unit {
        /// Seconds per unit.
        seconds: f64,
    },
    /// A unit that is ambiguous or may mean a time of day: 시 is an hour, and o'clock.
    Unclear,
}

/// Recognises a unit of time in lower-case letters.
pub(super) fn unit_of_time(word: &str) -> WordOfTime {
    let seconds = match word {
        "s" | "sec" | "secs" | "second" | "seconds" | "초" => 1.0,
        "ms" | "msec" | "msecs" | "millisecond" | "milliseconds" | "밀리초" => 1e-3,
        "us" | "µs" | "μs" | "usec" | "microsecond" | "microseconds" | "마이크로초" => 1e-6,
        "min" | "mins" | "minute" | "minutes" | "분" => 60.0,
        "h" | "hr" | "hrs" | "hour" | "hours" => 3600.0,
        "시" | "일" | "day" | "days" | "hh" | "ss" | "hms" => return WordOfTime::Unclear,
        _ => return WordOfTime::None,
    };
    WordOfTime::Unit { seconds }
}

/// The unit in the name of the time column: its last word, "경과 시간 [분]", "t_ms".
pub(super) fn unit_of_named_time(name: &str) -> WordOfTime {
    let lower = name.to_lowercase();
    let mut words = lower
        .split(|c: char| !c.is_alphanumeric() && c != 'µ' && c != 'μ')
        .filter(|w| !w.is_empty());
    words.next_back().map_or(WordOfTime::None, unit_of_time)
}

/// Reads names like "t", "Time (s)", "time_ms", "Zeit [s]", "seconds".
pub(super) fn time_name(name: &[u8]) -> TimeName {
    let lower = String::from_utf8_lossy(name).to_lowercase();
    let mut words = lower
        .split(|c: char| !c.is_alphanumeric() && c != 'µ' && c != 'μ')
        .filter(|w| !matches!(*w, "" | "elapsed" | "경과"));
    let unit = |word: &str| match unit_of_time(word) {
        WordOfTime::Unit { seconds } => Some(seconds),
        WordOfTime::Unclear | WordOfTime::None => None,
    };
    let is_time = |word: &str| {
        matches!(
            word,
            "t" | "time" | "times" | "zeit" | "timestamp" | "timestamps" | "시간" | "시각" | "경과시간"
        )
    };
    let (first, second, more) = (words.next(), words.next(), words.next());
    match (first, second) {
        (Some(first), None) if is_time(first) => TimeName::Seconds {
            unit_s: 1.0,
            named: false,
        },
        (Some("sec" | "second" | "seconds"), None) => TimeName::Seconds {
            unit_s: 1.0,
            named: true,
        },
        (Some(first), Some(word)) if is_time(first) => match unit(word) {
            Some(unit_s) if more.is_none() => TimeName::Seconds { unit_s, named: true },
            _ => TimeName::Unclear,
        },
        _ => TimeName::No,
    }
}

#[cfg(test)]
mod tests {
    use crate::records::{Column, Layout, Pick, RateSource, RecordOptions, Unit, read_csv, read_record};
    use dolmen::signal::Channel;

    fn refusal(bytes: &[u8]) -> String {
        let options = RecordOptions {
            sampling_rate_hz: Some(100.0),
            ..Default::default()
        };
        read_csv(bytes, &options).unwrap_err().to_string()
    }

    #[test]
    fn refuses_a_line_of_megabytes() {
        let said = |count: usize| {
            format!(
                "line 1 has {count} bytes, but at most 1048576 are read: write one line a sample, or a face of a mesh; are rows and columns swapped?"
            )
        };
        assert_eq!(refusal(&b"1,".repeat(2_000_000)), said(4_000_000));
        assert_eq!(refusal(&vec![b'7'; 4_000_000]), said(4_000_000));
        assert_eq!(refusal(&vec![0; 4_000_000]), said(4_000_000));
        let late = [b"1,2\n".repeat(100), b"1,".repeat(2_000_000), b"\n".to_vec()].concat();
        assert!(refusal(&late).starts_with("line 101 has 4000000 bytes"));
    }

    #[test]
    fn exact_units_may_stand_below_the_names() {
        let text = "Station 7,a,b\n시간,EW,NS\ns,gal,(gal)\n0.00,1,2\n0.01,3,4\n";
        let read = read_record(text.as_bytes(), &RecordOptions::default()).unwrap();
        let names: Vec<&str> = read.record.channels().iter().map(|of| of.name.as_str()).collect();
        assert_eq!(names, ["EW (gal)", "NS (gal)"]);
        assert!((read.record.sampling_rate_hz() - 100.0).abs() < 1e-9);
        // a line of units without names above it contains the names
        let alone = read_csv(b"t,g,mg\n0.00,1,2\n0.01,3,4\n", &RecordOptions::default()).unwrap();
        assert_eq!(alone.record.channels()[0].name, "g");
    }

    #[test]
    fn exact_titles_stand_above_names_where_times_are_dates() {
        let dates = "일시,X (gal),Y (gal)\n2026-10-14 10:00:00.00,1,2\n2026-10-14 10:00:00.01,3,4\n";
        let apart = "Date,Clock,X (gal),Y (gal)\n2026-10-14,10:00:00.00,1,2\n2026-10-14,10:00:00.01,3,4\n";
        let units = "일시,X,Y\n,gal,gal\n2026-10-14 10:00:00.00,1,2\n2026-10-14 10:00:00.01,3,4\n";
        let form = "일시,X,Y\nYYYY-MM-DD,(gal),gal\n2026-10-14 10:00:00.00,1,2\n2026-10-14 10:00:00.01,3,4\n";
        let pick = |column: &str| Pick {
            column: Column::Named(column.into()),
            channel: Channel::named(column),
            scale: None,
        };
        let with = |columns: [&str; 2]| RecordOptions {
            sampling_rate_hz: Some(100.0),
            unit: Unit::Gal,
            picks: columns.map(pick).to_vec(),
            ..Default::default()
        };
        for titles in ["", "Logger,DL-2000\nPlace,Pagoda\n", "오층석탑 상시진동\n"] {
            for (table, columns) in [
                (dates, ["X (gal)", "Y (gal)"]),
                (apart, ["X (gal)", "Y (gal)"]),
                (units, ["X (gal)", "Y (gal)"]),
                (units, ["X", "Y"]),
                (form, ["X", "Y (gal)"]),
            ] {
                let read = read_csv(format!("{titles}{table}").as_bytes(), &with(columns)).unwrap();
                assert_eq!(read.record.samples(0), [0.01, 0.03], "{titles}{table}");
                assert_eq!(read.record.samples(1), [0.02, 0.04], "{titles}{table}");
                let Layout::Csv(csv) = read.layout else {
                    panic!("{titles}{table}")
                };
                assert_eq!(csv.rate_source, RateSource::GivenAndDates);
                assert_eq!(
                    csv.passed_over.map(|[_, last]| last),
                    (!titles.is_empty()).then(|| titles.lines().count())
                );
            }
        }
        // the unit below a name is still used
        let other = units.replace("gal", "g");
        assert!(read_csv(other.as_bytes(), &with(["X", "Y"])).is_err());
        // a missing first sample is not a title
        let missing = "일시,X (gal),Y (gal)\n2026-10-14 10:00:00.00,,2\n2026-10-14 10:00:00.01,3,4\n";
        assert!(read_csv(missing.as_bytes(), &with(["X (gal)", "Y (gal)"])).is_err());
    }

    #[test]
    fn refuses_more_columns_than_any_recorder_has() {
        let wide = |count: usize| format!("{}1\n", "1,".repeat(count - 1)).repeat(3);
        assert_eq!(
            refusal(wide(5000).as_bytes()),
            "line 1 holds 5000 cells, but at most 4096 are read, more than any recorder has: are rows and columns swapped? write one line a \
             sample"
        );
        let record = read_csv(
            wide(4096).as_bytes(),
            &RecordOptions {
                sampling_rate_hz: Some(100.0),
                ..Default::default()
            },
        );
        assert_eq!(record.unwrap().record.channels().len(), 4096);
        // for one wide line among others the error gives the number of its cells
        let ragged = format!("1,2\n3,4\n{}1\n", "1,".repeat(9999));
        assert!(
            refusal(ragged.as_bytes()).starts_with("line 3 holds 10000 cells, but"),
            "{}",
            refusal(ragged.as_bytes())
        );
    }

    #[test]
    fn holds_what_is_quoted_is_short_and_harmless() {
        let name = format!("x\u{1b}]0;{}\0", "long ".repeat(100));
        let text = format!("time,{name}\n0.00,1\n0.01,{}\n", "\u{1b}[2J".repeat(100));
        let said = read_record(text.as_bytes(), &RecordOptions::default())
            .unwrap_err()
            .to_string();
        assert!(
            said.starts_with("line 3, column \"x\\u{1b}]0;long long"),
            "{said}"
        );
        assert!(said.chars().count() < 600 && !said.contains('\u{1b}'), "{said}");
        let names: Vec<String> = (1..=300).map(|n| format!("sensor {n}")).collect();
        let numbers: Vec<String> = (1..=300).map(|n| (n * n % 7).to_string()).collect();
        let text = format!(
            "{}\n{}\n{}\n",
            names.join(","),
            numbers.join(","),
            numbers.join(",")
        );
        let said = read_record(text.as_bytes(), &RecordOptions::default())
            .unwrap_err()
            .to_string();
        assert!(
            said.contains("sensor 19, sensor 20 and 280 more); give sampling_rate"),
            "{said}"
        );
    }
}
