//! The time of a record: from the record itself, otherwise from the name of its file, otherwise from the file's modification time.

use crate::survey_dates::day_of_a_record;
use dolmen_project::date_of;
use dolmen_records::{start_of_text, time_text};

/// Starts before 1990, or later than the clock by a day, are rejected, s: a logger with a reset clock writes 1970 or 1980. Our choice.
const BELIEVED_FROM_S: f64 = 631_152_000.0;
const AHEAD_MOST_S: f64 = 86_400.0;
/// Characters of a date and of a date with its time: "2026-11-25", "2026-11-25 10:00:00".
const DATE: usize = 10;
const DATE_AND_TIME: usize = 19;

/// Source of the time of a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum TimeSource {
    /// The record itself.
    Record,
    /// The name of its file.
    FileName,
    /// Time of the last change of the file (UTC).
    FileTime,
}

/// The time of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordTime {
    /// "2026-11-25T10:00:00"; "2026-11-25" if only the day is known.
    pub name: String,
    /// The same, s from 1 January 1970; the start of a day.
    pub at_s: f64,
    /// Its source.
    pub source: TimeSource,
    /// The time in the record, s from 1970, if it was rejected.
    pub not_believed_s: Option<f64>,
}

/// The time of a record: `begins_s` is that in the record, s from 1 January 1970, `modified_s` when its file was last written, and `now_s` the
/// clock.
pub fn record_time(begins_s: Option<f64>, file_name: &str, modified_s: f64, now_s: f64) -> RecordTime {
    let is_believed = |at: f64| (BELIEVED_FROM_S..=now_s + AHEAD_MOST_S).contains(&at);
    // small numbers are seconds of the logger's own clock, not dates
    const YEAR_S: f64 = 3.2e7;
    let said = begins_s.filter(|at| at.abs() >= YEAR_S);
    let not_believed_s = said.filter(|at| !is_believed(*at));
    let (name, at_s, source) = match said.filter(|at| is_believed(*at)) {
        Some(at) => (moment(at), at, TimeSource::Record),
        None => match of_file_name(file_name, is_believed) {
            Some((name, at)) => (name, at, TimeSource::FileName),
            None => (moment(modified_s), modified_s, TimeSource::FileTime),
        },
    };
    RecordTime {
        name,
        at_s,
        source,
        not_believed_s,
    }
}

/// "2026-11-25T10:00:00" from seconds since 1970; fractions of a second are dropped.
fn moment(at_s: f64) -> String {
    let text: String = time_text(at_s.floor()).chars().take(DATE_AND_TIME).collect();
    text.replacen(' ', "T", 1)
}

/// The time in the name of a record's survey, s from 1 January 1970; for a day its start.
pub fn moment_of(survey: &str) -> Option<f64> {
    let day = day_of_a_record(survey)?;
    let whole = survey.get(..DATE_AND_TIME).and_then(start_of_text);
    whole.or_else(|| start_of_text(&format!("{day} 00:00:00")))
}

/// The syllables of a Korean date and time, decomposed as in file names of macOS, and composed.
const WHOLE: [(&str, &str); 8] = [
    ("\u{1102}\u{1167}\u{11ab}", "년"),
    ("\u{110b}\u{116f}\u{11af}", "월"),
    ("\u{110b}\u{1175}\u{11af}", "일"),
    ("\u{1109}\u{1175}", "시"),
    ("\u{1107}\u{116e}\u{11ab}", "분"),
    ("\u{110e}\u{1169}", "초"),
    ("\u{110b}\u{1169}\u{110c}\u{1165}\u{11ab}", "오전"),
    ("\u{110b}\u{1169}\u{1112}\u{116e}", "오후"),
];

/// The first date in a name, with the time after it: "gate_20261125_100000.csv", "2026-11-25T10-00-00Z", "2026.11.25", "2026년 7월 1일 오후 3시".
fn of_file_name(name: &str, is_believed: impl Fn(f64) -> bool) -> Option<(String, f64)> {
    let whole = WHOLE
        .iter()
        .fold(name.to_owned(), |name, (parts, whole)| name.replace(parts, whole));
    let signs: Vec<char> = whole.chars().collect();
    (0..signs.len()).find_map(|at| {
        let begins = at == 0 || !signs[at - 1].is_ascii_digit();
        let found =
            || date_at(&signs[at..], &is_believed).or_else(|| written_date(&signs[at..], &is_believed));
        begins.then(found).flatten()
    })
}

/// A date as people write it, months and days with one digit or two: "2026년 7월 1일 오후 3시 5분", "2026. 7. 1.".
fn written_date(signs: &[char], is_believed: &impl Fn(f64) -> bool) -> Option<(String, f64)> {
    let text: String = signs.iter().collect();
    let [year, month, day] = date_of(&text).filter(|[_, _, day]| *day > 0)?;
    let date = format!("{year:04}-{month:02}-{day:02}");
    let at_s = |time: &str| {
        let at = start_of_text(&format!("{date} {time}"))?;
        // 30 February does not exist
        (moment(at).starts_with(&date) && is_believed(at)).then_some(at)
    };
    let time = text.split_once('일').and_then(|(_, rest)| korean_time(rest));
    if let Some(at) = time.as_deref().and_then(at_s) {
        return Some((moment(at), at));
    }
    Some((date.clone(), at_s("00:00:00")?))
}

/// "오후 3시 5분 10초" as "15:05:10".
fn korean_time(text: &str) -> Option<String> {
    let mut rest = text.trim_start();
    let mut noon = None;
    for (half, is_after) in [("오전", false), ("오후", true)] {
        if let Some(behind) = rest.strip_prefix(half) {
            (rest, noon) = (behind.trim_start(), Some(is_after));
        }
    }
    let mut number = |unit: char| -> Option<u32> {
        let (value, behind) = rest.split_once(unit)?;
        let value = value.trim().parse().ok()?;
        rest = behind;
        Some(value)
    };
    let hour = number('시')?;
    let (minute, second) = (number('분').unwrap_or(0), number('초').unwrap_or(0));
    let hour = match noon {
        Some(is_after) if (1..=12).contains(&hour) => hour % 12 + if is_after { 12 } else { 0 },
        Some(_) => return None,
        None => hour,
    };
    (hour < 24 && minute < 60 && second < 60).then(|| format!("{hour:02}:{minute:02}:{second:02}"))
}

fn date_at(signs: &[char], is_believed: &impl Fn(f64) -> bool) -> Option<(String, f64)> {
    let mut read = Digits { signs, at: 0 };
    let year = read.digits(4)?;
    read.passed_over("-_.");
    let month = read.digits(2)?;
    read.passed_over("-_.");
    let day = read.digits(2)?;
    let date = Digits { ..read };
    read.passed_over("T_- ");
    let time = (|| {
        let hour = read.digits(2)?;
        read.passed_over(":-_.h");
        let minute = read.digits(2)?;
        let after_minute = read.at;
        read.passed_over(":-_.m");
        let second = read.digits(2).unwrap_or_else(|| {
            read.at = after_minute;
            "00".to_owned()
        });
        (!read.is_digit()).then(|| format!("{hour}{minute}{second}"))
    })();
    let is_day = |at: &f64| moment(*at).starts_with(&format!("{year}-{month}-{day}")); // 30 February does not exist
    let at_s = |time: &str| {
        let at = start_of_text(&format!("{year}{month}{day}{time}"))?;
        (is_day(&at) && is_believed(at)).then_some(at)
    };
    if let Some(at) = time.as_deref().and_then(at_s) {
        return Some((moment(at), at));
    }
    let is_alone = !date.is_digit();
    let at = at_s("000000").filter(|_| is_alone)?;
    Some((moment(at).chars().take(DATE).collect(), at))
}

/// Reads groups of digits one after the other.
#[derive(Clone, Copy)]
struct Digits<'a> {
    signs: &'a [char],
    at: usize,
}

impl Digits<'_> {
    fn is_digit(&self) -> bool {
        self.signs.get(self.at).is_some_and(char::is_ascii_digit)
    }

    fn digits(&mut self, count: usize) -> Option<String> {
        let group = self.signs.get(self.at..self.at + count)?;
        if !group.iter().all(char::is_ascii_digit) {
            return None;
        }
        self.at += count;
        Some(group.iter().collect())
    }

    fn passed_over(&mut self, signs: &str) {
        let is_one = self.signs.get(self.at).is_some_and(|sign| signs.contains(*sign));
        self.at += usize::from(is_one);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOW_S: f64 = 1_795_600_000.0; // 2026-11-25
    const AT_S: f64 = 1_795_600_000.25;

    fn of(begins_s: Option<f64>, name: &str) -> (String, TimeSource) {
        let found = record_time(begins_s, name, NOW_S - 60.0, NOW_S);
        (found.name, found.source)
    }

    #[test]
    fn exact_the_record_then_the_name_then_the_file_say_when() {
        // `date -u -d @1795600000` of coreutils
        assert_eq!(
            of(Some(AT_S), "2020-01-01.csv"),
            ("2026-11-25T09:46:40".into(), TimeSource::Record)
        );
        assert_eq!(
            of(None, "a.csv"),
            ("2026-11-25T09:45:40".into(), TimeSource::FileTime)
        );
        for (name, told) in [
            ("gate_20261124_100001.csv", "2026-11-24T10:00:01"),
            ("2026-11-24T10-00-01Z.mseed", "2026-11-24T10:00:01"),
            ("2026-11-24T10:00.csv", "2026-11-24T10:00:00"),
            ("20261124100001", "2026-11-24T10:00:01"),
            ("sn123456789-2026.11.24.csv", "2026-11-24"),
            ("2026_11_24 (2).csv", "2026-11-24"),
            ("2026-11-24-99.csv", "2026-11-24"),
            ("탑 2026-11-24.csv", "2026-11-24"),
            ("남산당간 2025년 7월 21일.csv", "2025-07-21"),
            ("2025년7월21일 오후 3시 5분.csv", "2025-07-21T15:05:00"),
            ("2025년 12월 1일 오전 12시 30분 (2).csv", "2025-12-01T00:30:00"),
            // decomposed, as macOS writes it
            (
                "2025\u{1102}\u{1167}\u{11ab} 7\u{110b}\u{116f}\u{11af} 1\u{110b}\u{1175}\u{11af}.csv",
                "2025-07-01",
            ),
            ("탑 2025. 7. 1.csv", "2025-07-01"),
        ] {
            assert_eq!(of(None, name), (told.into(), TimeSource::FileName), "{name}");
        }
        for name in [
            "2026-13-24.csv",
            "2026년 2월 30일.csv",
            "2026년 7월.csv",
            "2026-02-30.csv",
            "202611245.csv",
            "2090-01-01.csv",
            "$(x)",
            "../2",
        ] {
            assert_eq!(of(None, name).1, TimeSource::FileTime, "{name}");
        }
    }

    #[test]
    fn exact_names_of_surveys_are_moments() {
        assert_eq!(moment_of("2026-11-25T09:46:40 (2)"), Some(1_795_600_000.0));
        assert_eq!(moment_of("2026-11-25"), Some(1_795_564_800.0));
        assert_eq!(moment_of("2026-11 x"), None);
    }

    #[test]
    fn holds_a_clock_that_was_reset_is_not_believed_and_seconds_of_its_own_are_no_date() {
        for wrong in [315_964_800.0, NOW_S + 2.0 * 86_400.0] {
            let found = record_time(Some(wrong), "2026-11-24.csv", NOW_S, NOW_S);
            assert_eq!(
                (found.source, found.not_believed_s),
                (TimeSource::FileName, Some(wrong))
            );
        }
        let own = record_time(Some(12.5), "a.csv", NOW_S, NOW_S);
        assert_eq!((own.source, own.not_believed_s), (TimeSource::FileTime, None));
    }
}
