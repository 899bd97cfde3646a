//! Dates of surveys and of the report that lie in the future.

use super::reader::Reader;
use super::report::{ReportPart, calendar_day};
use super::site::judge_korean_place;
use super::survey::{Survey, date_of};
use super::wrong::Slip;

/// Earliest credible date of the clock, as year, month, day: the program is from about then. A clock that was reset shows 1970 or 2000.
const CLOCK_FROM: [u32; 3] = [2026, 11, 1];

/// Surveys and a report with a future date: such a survey would be the latest, and the verdict would depend on it.
pub(super) fn judge_dates(reader: &mut Reader, surveys: &[Survey], report: Option<&ReportPart>) {
    let Some(today) = reader.files.today().filter(|today| *today >= CLOCK_FROM) else {
        return;
    };
    let [year, month, day] = today;
    let today_text = format!("{year:04}-{month:02}-{day:02}");
    let mut dated: Vec<(String, [u32; 3])> = Vec::new();
    for survey in surveys {
        dated.extend(date_of(&survey.name).map(|date| (format!("survey.{}", survey.name), date)));
    }
    let report_day = report.and_then(|report| calendar_day(report.date.as_ref()?));
    dated.extend(report_day.map(|date| ("report.date".to_owned(), date.map(u32::from))));
    for (path, _) in dated.into_iter().filter(|(_, date)| *date > today) {
        let message = Slip::NotYetCome {
            path: path.clone(),
            today: today_text.clone(),
        };
        reader.slip(&path, message, Slip::IsTheYearRight);
    }
}

/// The place of the report.
pub(super) fn judge_report_place(reader: &mut Reader, report: Option<&ReportPart>, has_korean_name: bool) {
    let location = report.and_then(|report| report.location.as_ref());
    let degrees = location.and_then(|location| location.degrees);
    if let (Some(degrees), true) = (degrees, has_korean_name) {
        let paths = ["report.location.latitude", "report.location.longitude"];
        judge_korean_place(reader, paths, degrees, false);
    }
}
