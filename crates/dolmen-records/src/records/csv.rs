//! Reads CSV files: one line per sample, one column per channel, in any common dialect.
//!
//! A line is read in two ways. Plain numbers are parsed in place. Any other cell (with quotes, blanks or more digits than a double holds) is
//! cut out and parsed by the standard library, which also gives the errors.

use super::column_units::{NamedColumn, refuse_other_units};
use super::csv_start::{Start, TimeName, WordOfTime, time_name, unit_of_named_time};
use super::date_text::minute_of_hour;
use super::dates::{Dates, held_against};
use super::dialect::{holds_cells, line_at, unquoted};
use super::lost_samples::{Spans, UsableRows, fill};
use super::time_unit::{Time, UnitSaid, unit_s};
use super::{
    Column, CsvLayout, Delimiter, Layout, RateSource, Reading, RecordError, RecordOptions, TimeColumn,
};
use crate::number::{Number, parse_cell, scan};
use crate::quoted::shown;
use crate::text_code::decoded;
use dolmen::signal::{Channel, Processing, Record, SignalError};
use std::ops::Range;

/// Number of lines that are transposed into channel order at a time: few enough for the first-level cache, and enough to write whole cache
/// lines for each channel.
const ROWS_AT_ONCE: usize = 64;
/// Least similarity (Jaro–Winkler) for suggesting a name.
const SIMILAR: f64 = 0.7;
/// A channel is a counter or a time if all its steps agree with the first within this fraction. Our choice.
const COUNT_TOLERANCE: f64 = 1e-3;

/// Reads a record from the bytes of a CSV file.
///
/// Delimiter, decimal sign, header and time column are detected unless `options` give them. The sampling rate comes from the time stamps, which
/// must have equal steps, or from [`RecordOptions::sampling_rate_hz`].
///
/// # Errors
/// [`RecordError`], with the line and the column, for text in a column of numbers, a missing sample, a line with too many or too few cells,
/// unequal time steps, no sampling rate, or a column that does not exist.
///
/// # Limits
/// Time stamps are numbers, not dates. If the options give both the rate and the columns, the first and the last date of a column of dates are
/// compared with the rate, and the dates between are ignored. If the last line has no line end, its last number may be cut short: see
/// [`CsvLayout::last_line_ended`]. Text is UTF-8 or CP949 (EUC-KR). With another encoding, a column whose name is not ASCII gets a number as
/// its name.
///
/// # Example
/// ```
/// use dolmen_records::records::{RecordOptions, read_csv};
/// let text = b"time,ch1\n0.00,1.5\n0.01,abc\n";
/// let fault = read_csv(text, &RecordOptions::default()).unwrap_err();
/// assert!(fault.to_string().starts_with("line 3, column \"ch1\": \"abc\" is not a number"));
/// ```
pub fn read_csv(bytes: &[u8], options: &RecordOptions) -> Result<Reading, RecordError> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err(RecordError::Utf16);
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes); // byte order mark of UTF-8
    let text = decoded(bytes);
    let bytes = &*text.bytes;
    let start = Start::find(bytes, options)?;
    let time = find_time(&start, &options.time)?;
    // for a column of dates the options give all that time stamps would give
    let told =
        options.time == TimeColumn::Detect && options.sampling_rate_hz.is_some() && !options.picks.is_empty();
    let time = time.filter(|t| start.numeric[t.column] || !told);
    let mut plan = Plan::new(&start, options, time)?;
    if plan.channels.is_empty() {
        return Err(RecordError::OnlyTime {
            column: start.columns.into_iter().next().unwrap_or_default(),
        });
    }
    let told_unit_s = time.map(|t| t.unit_s);
    let time = match time {
        Some(t) => Some(Time {
            unit_s: unit_s(
                bytes,
                &start,
                (t, &start.columns[t.column]),
                options.sampling_rate_hz,
            )?,
            ..t
        }),
        None => None,
    };
    plan.time = time;
    if time.is_none() && options.sampling_rate_hz.is_none() {
        return Err(RecordError::NoRate { names: start.columns });
    }
    let table = Table::read(bytes, &start, &plan, options)?;
    let count = plan.channels.len();
    let length = table.samples.len() / count;
    if length < 2 {
        return Err(RecordError::Signal(SignalError::Empty {
            channels: count,
            samples: length,
        }));
    }
    if options.picks.is_empty() && options.time == TimeColumn::Detect {
        refuse_counts(&table.samples, length, &plan.channels)?;
    }
    let free: Vec<bool> = plan.uses.iter().map(|wanted| *wanted == Use::Nothing).collect();
    let mut dates = Dates::None;
    let (rate_hz, rate_source) = match (&table.kept, options.sampling_rate_hz) {
        (Some(kept), Some(_)) => (kept.stamps.rate_hz()?, RateSource::GivenAndStamps),
        (Some(kept), None) => (kept.stamps.rate_hz()?, RateSource::Stamps),
        (None, Some(given)) => {
            dates = held_against(bytes, (&start, &free), (given, length))?;
            (given, dates.rate_source())
        }
        (None, None) => return Err(RecordError::NoRate { names: start.columns }),
    };
    let mut samples = table.samples;
    let factor = options.unit.si();
    if factor != 1.0 {
        samples.iter_mut().for_each(|x| *x *= factor);
    }
    let mut record = Record::from_contiguous(plan.channels, samples, rate_hz)?;
    record.note(Processing::Read {
        format: "csv".into(),
        unit: options.unit.symbol().into(),
    });
    for step in table.kept.into_iter().flat_map(|kept| kept.steps) {
        record.note(step);
    }
    Ok(Reading {
        record,
        begins_s: None,
        layout: Layout::Csv(CsvLayout {
            delimiter: start.delimiter,
            decimal: start.decimal,
            header_line: start.header_line,
            time_column: time.map(|t| start.columns[t.column].clone()),
            columns: start.columns,
            rate_source,
            first_date: dates.first(),
            unread_stamps: dates.unread(),
            passed_over: start.passed_over,
            is_cp949: text.is_cp949,
            names_unread: start.names_unread,
            time_unit_s: time
                .map(|t| t.unit_s)
                .filter(|unit_s| told_unit_s != Some(*unit_s)),
            last_line_ended: bytes.ends_with(b"\n"),
        }),
    })
}

fn find_time(start: &Start, option: &TimeColumn) -> Result<Option<Time>, RecordError> {
    match option {
        TimeColumn::Absent => Ok(None),
        TimeColumn::At(column) => {
            let column = find_column(start, column)?;
            let (unit_s, said) = match unit_of_named_time(&start.columns[column]) {
                WordOfTime::Unit { seconds } => (seconds, UnitSaid::Clearly),
                WordOfTime::Unclear => (1.0, UnitSaid::Unclearly),
                WordOfTime::None => (1.0, UnitSaid::Clearly), // seconds by definition
            };
            Ok(Some(Time { column, unit_s, said }))
        }
        TimeColumn::Detect => {
            for (column, name) in start.columns.iter().enumerate() {
                match time_name(name.as_bytes()) {
                    TimeName::No => {}
                    TimeName::Seconds { unit_s, named } => {
                        let said = if named { UnitSaid::Clearly } else { UnitSaid::Not };
                        return Ok(Some(Time { column, unit_s, said }));
                    }
                    TimeName::Unclear => {
                        let (unit_s, said) = (1.0, UnitSaid::Unclearly);
                        return Ok(Some(Time { column, unit_s, said }));
                    }
                }
            }
            Ok(None)
        }
    }
}

fn find_column(start: &Start, column: &Column) -> Result<usize, RecordError> {
    let columns = &start.columns;
    let given = match column {
        Column::Number(n) if (1..=columns.len()).contains(n) => return Ok(n - 1),
        Column::Number(n) => {
            return Err(RecordError::ColumnNumber {
                given: *n,
                columns: columns.len(),
            });
        }
        Column::Named(name) => name,
    };
    let name = shown(given); // in the form in which column names are kept
    // the name may omit the unit, which is in the line below
    let without_unit = |c: &str| c.rsplit_once(" (").is_some_and(|(bare, _)| bare == name);
    let by_bare_name = start.units_apart && !columns.contains(&name);
    let is_asked = |c: &str| c == name || (by_bare_name && without_unit(c));
    let mut found = columns.iter().enumerate().filter(|(_, c)| is_asked(c));
    match (found.next(), found.count()) {
        (Some((at, _)), 0) => Ok(at),
        (Some(_), more) => Err(RecordError::AmbiguousColumn {
            given: given.clone(),
            count: more + 1,
        }),
        (None, _) => {
            let similar = |c: &String| strsim::jaro_winkler(&c.to_lowercase(), &name.to_lowercase());
            let nearest = columns.iter().max_by(|a, b| similar(a).total_cmp(&similar(b)));
            Err(RecordError::UnknownColumn {
                given: given.clone(),
                nearest: nearest.filter(|c| similar(c) > SIMILAR).cloned(),
                names: columns.clone(),
            })
        }
    }
}

/// Use of a cell of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Use {
    Nothing,
    Time,
    /// The channel with this index.
    Channel(usize),
}

/// The cells to read in each line.
#[derive(Debug)]
struct Plan {
    uses: Vec<Use>,
    channels: Vec<Channel>,
    time: Option<Time>,
}

impl Plan {
    fn new(start: &Start, options: &RecordOptions, time: Option<Time>) -> Result<Self, RecordError> {
        let mut uses = vec![Use::Nothing; start.columns.len()];
        let mut channels = Vec::new();
        if options.picks.is_empty() {
            for (column, name) in start.columns.iter().enumerate() {
                if time.is_none_or(|t| t.column != column) {
                    uses[column] = Use::Channel(channels.len());
                    channels.push(Channel::named(name));
                }
            }
        }
        for pick in &options.picks {
            let column = find_column(start, &pick.column)?;
            let taken = match uses[column] {
                Use::Channel(other) => Some(channels[other].name.clone()),
                _ => None,
            };
            if let Some(first) = taken {
                return Err(RecordError::PickedTwice {
                    column: start.columns[column].clone(),
                    first,
                    second: pick.channel.name.clone(),
                });
            }
            uses[column] = Use::Channel(channels.len());
            channels.push(pick.channel.clone());
        }
        if let Some(t) = time {
            if let Use::Channel(channel) = uses[t.column] {
                return Err(RecordError::PickedTwice {
                    column: start.columns[t.column].clone(),
                    first: "time".into(),
                    second: channels[channel].name.clone(),
                });
            }
            uses[t.column] = Use::Time;
        }
        for channel in &mut channels {
            channel.quantity = options.unit.quantity();
        }
        let named = |(column, wanted): (usize, &Use)| match wanted {
            Use::Channel(channel) => Some(NamedColumn {
                name: &start.columns[column],
                is_scaled: options
                    .picks
                    .get(*channel)
                    .is_some_and(|pick| pick.scale.is_some()),
            }),
            _ => None,
        };
        let read: Vec<NamedColumn<'_>> = uses.iter().enumerate().filter_map(named).collect();
        refuse_other_units(&read, options.unit, options.scale.is_some())?;
        Ok(Plan { uses, channels, time })
    }
}

/// Samples and time stamps of all lines.
#[derive(Debug)]
struct Table {
    /// All samples of the first channel, then those of the next.
    samples: Vec<f64>,
    kept: Option<UsableRows>,
}

impl Table {
    fn read(bytes: &[u8], start: &Start, plan: &Plan, options: &RecordOptions) -> Result<Self, RecordError> {
        let count = plan.channels.len();
        let body = &bytes[start.samples_at..];
        // every line but the last has a line end, and each cell takes at least two bytes: this bounds the memory
        let lines_most = memchr::memchr_iter(b'\n', body).count() + 1;
        let rows_most = lines_most.min(body.len() / (2 * plan.uses.len()) + 1);
        let mut samples = vec![0.0; rows_most * count];
        let mut block = vec![0.0; ROWS_AT_ONCE * count];
        let (given_hz, lost_samples) = (options.sampling_rate_hz, options.lost_samples);
        let mut stamps = plan.time.map(|t| match start.numeric[t.column] {
            true => Spans::new(t.unit_s, given_hz, lost_samples),
            false => Spans::new(1.0, given_hz, lost_samples).of_hours(),
        });
        let (mut rows, mut flushed) = (0, 0);
        let (mut at, mut number) = (start.samples_at, start.samples_line);
        while let Some(line) = line_at(bytes, at, number)? {
            (at, number) = (line.next, number + 1);
            if !holds_cells(line.text) {
                continue;
            }
            let row = &mut block[(rows - flushed) * count..][..count];
            let reader = LineReader {
                text: line.text,
                number: line.number,
                start,
                uses: &plan.uses,
                last: !line.ended,
            };
            reader.read(row, stamps.as_mut())?;
            rows += 1;
            if rows - flushed == ROWS_AT_ONCE {
                transpose(&block, &mut samples, flushed, rows_most);
                flushed = rows;
            }
        }
        transpose(
            &block[..(rows - flushed) * count],
            &mut samples,
            flushed,
            rows_most,
        );
        let kept = stamps.map(Spans::longest).transpose()?;
        let used = kept.as_ref().map_or(0..rows, |kept| kept.rows.clone());
        for channel in 0..count {
            let from = channel * rows_most + used.start;
            samples.copy_within(from..from + used.len(), channel * used.len());
        }
        samples.truncate(used.len() * count);
        if let Some(filled) = kept
            .as_ref()
            .map(|kept| kept.filled.as_slice())
            .filter(|f| !f.is_empty())
        {
            samples = with_filled(&samples, used.len(), filled)?;
        }
        Ok(Table { samples, kept })
    }
}

/// The series, each of `length` samples, with lost samples filled.
fn with_filled(series: &[f64], length: usize, lost: &[Range<usize>]) -> Result<Vec<f64>, SignalError> {
    let missing: usize = lost.iter().map(Range::len).sum();
    let mut all = Vec::with_capacity((length + missing) * (series.len() / length));
    for there in series.chunks_exact(length) {
        let (begin, mut rest) = (all.len(), there);
        for run in lost {
            let (before, after) = rest.split_at(run.start - (all.len() - begin));
            all.extend_from_slice(before);
            all.resize(begin + run.end, 0.0);
            rest = after;
        }
        all.extend_from_slice(rest);
        fill(&mut all[begin..], lost)?;
    }
    Ok(all)
}

/// Writes rows of cells into series of length `stride`, from sample `from` on.
fn transpose(rows: &[f64], series: &mut [f64], from: usize, stride: usize) {
    let count = series.len() / stride;
    for (channel, samples) in series.chunks_exact_mut(stride).enumerate() {
        let cells = rows.iter().skip(channel).step_by(count);
        samples[from..].iter_mut().zip(cells).for_each(|(s, c)| *s = *c);
    }
}

/// One line, and which of its cells to read.
struct LineReader<'a> {
    text: &'a [u8],
    number: usize,
    start: &'a Start,
    uses: &'a [Use],
    last: bool,
}

impl LineReader<'_> {
    #[inline]
    fn read(&self, row: &mut [f64], mut stamps: Option<&mut Spans>) -> Result<(), RecordError> {
        let (delimiter, decimal_sign) = (self.start.delimiter, self.start.decimal.byte());
        let mut at = self.skip_blanks(0);
        for (column, wanted) in self.uses.iter().enumerate() {
            if column > 0 {
                at = self.next_cell(at, column)?;
            }
            if *wanted == Use::Nothing {
                at = self.cell_end(at);
                continue;
            }
            let number = match scan(self.text, at, decimal_sign) {
                Some(n) if self.text.get(n.end).is_none_or(|b| delimiter.is(*b)) => n,
                _ => self.read_slowly(at, column)?,
            };
            at = number.end;
            match wanted {
                Use::Channel(channel) => row[*channel] = number.value,
                Use::Time => {
                    if let Some(stamps) = stamps.as_deref_mut() {
                        stamps.push(number, self.number)?;
                    }
                }
                Use::Nothing => {}
            }
        }
        let rest = &self.text[at..];
        // only blanks may follow, or the delimiter with which some files end every line
        let rest = match rest.split_first() {
            Some((first, more)) if self.start.trailing_delimiter && delimiter.is(*first) => more,
            _ => rest,
        };
        if rest.trim_ascii().is_empty() && (delimiter != Delimiter::Tab || rest.is_empty()) {
            Ok(())
        } else {
            Err(self.ragged())
        }
    }

    /// Skips the delimiter before cell `column`, which must exist.
    #[inline]
    fn next_cell(&self, at: usize, column: usize) -> Result<usize, RecordError> {
        debug_assert!(column > 0);
        match self.text.get(at) {
            Some(b) if self.start.delimiter.is(*b) => {
                let at = self.skip_blanks(at + 1);
                if self.start.delimiter == Delimiter::WhiteSpace && at == self.text.len() {
                    return Err(self.ragged());
                }
                Ok(at)
            }
            _ => Err(self.ragged()),
        }
    }

    /// Skips blanks, unless they are delimiters.
    #[inline]
    fn skip_blanks(&self, mut at: usize) -> usize {
        let tabs_part = self.start.delimiter == Delimiter::Tab;
        while let Some(b' ' | b'\t') = self.text.get(at) {
            if tabs_part && self.text[at] == b'\t' {
                break;
            }
            at += 1;
        }
        at
    }

    /// End of the cell that begins at `at`. A delimiter inside quotes is part of the cell.
    fn cell_end(&self, at: usize) -> usize {
        let mut quoted = false;
        let end = self.text[at..].iter().position(|b| {
            quoted ^= *b == b'"';
            !quoted && self.start.delimiter.is(*b)
        });
        end.map_or(self.text.len(), |end| at + end)
    }

    #[cold]
    fn read_slowly(&self, at: usize, column: usize) -> Result<Number, RecordError> {
        let end = self.cell_end(at);
        let cell = unquoted(self.text[at..end].trim_ascii());
        let (line, name) = (self.number, || self.start.columns[column].clone());
        let text = || String::from_utf8_lossy(cell).into_owned();
        if cell.is_empty() {
            // a line that is too short is reported as such, not as an empty last cell
            return Err(if end == self.text.len() && self.cells() < self.uses.len() {
                self.ragged()
            } else {
                RecordError::EmptyCell { line, column: name() }
            });
        }
        match parse_cell(cell, self.start.decimal.byte()) {
            Some(number) if number.value.is_finite() => Ok(Number { end, ..number }),
            Some(_) => Err(RecordError::NotFinite {
                line,
                column: name(),
                text: text(),
            }),
            None if text() == self.start.columns[column] => Err(RecordError::HeaderAgain { line }),
            None if self.uses[column] == Use::Time => match minute_of_hour(&text()) {
                Some(at) => Ok(at.printed(end)),
                None => Err(RecordError::TimeText {
                    line,
                    column: name(),
                    text: text(),
                }),
            },
            None => Err(RecordError::NotANumber {
                line,
                column: name(),
                text: text(),
            }),
        }
    }

    fn cells(&self) -> usize {
        self.start.delimiter.count(self.text)
    }

    #[cold]
    fn ragged(&self) -> RecordError {
        let trailing =
            usize::from(self.start.trailing_delimiter && self.text.ends_with(&[self.start.delimiter.byte()]));
        RecordError::Ragged {
            line: self.number,
            found: self.cells() - trailing,
            expected: self.uses.len(),
            last: self.last,
        }
    }
}

/// Refuses a channel with constant positive steps: it is a time column that was not recognised, or a line counter.
pub(super) fn refuse_counts(samples: &[f64], length: usize, channels: &[Channel]) -> Result<(), RecordError> {
    for (x, channel) in samples.chunks_exact(length).zip(channels) {
        if length <= 2 {
            continue;
        }
        let step = x[1] - x[0];
        if step > 0.0
            && x.windows(2)
                .all(|w| (w[1] - w[0] - step).abs() <= COUNT_TOLERANCE * step)
        {
            return Err(RecordError::LooksLikeTime {
                column: channel.name.clone(),
                step,
            });
        }
    }
    Ok(())
}
