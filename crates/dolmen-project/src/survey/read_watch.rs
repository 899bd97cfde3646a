//! Reads `[watch]`.

use super::limit_slips::judge_limit;
use super::read_logs::logs;
use super::watch::{WatchPart, WorkKind, WorkPart};
use super::watch_file::{WatchRaw, WorkKindRaw, WorkRaw};
use crate::error::Fault;
use crate::file_number::{At, NumberRaw};
use crate::reader::Reader;
use crate::report::is_day;
use crate::units::tilt_ratio;
use crate::wrong::WrongSurvey;

/// Bounds of the mean time between false alarms, years. Our choice: below a month every survey raises an alarm, beyond ten lifetimes none does.
const YEARS: (f64, f64) = (0.1, 1000.0);
/// Range of a limit of tilt, our choice: nobody sets one below 0.1 mm/m, and no structure stands at 1/4.
const TILT: (f64, f64) = (1e-4, 0.25);

/// Settings for watching many surveys.
pub(crate) fn watch(reader: &mut Reader, raw: Option<&At<WatchRaw>>) -> WatchPart {
    let Some(At { value: raw, .. }) = raw else {
        return WatchPart::default();
    };
    let listed = raw.works.iter().flatten().enumerate();
    WatchPart {
        years_between_false_alarms: reader.within(
            raw.years_between_false_alarms.as_ref(),
            "watch.years_between_false_alarms",
            YEARS.0,
            YEARS.1,
        ),
        tilt_limit: raw
            .tilt_limit
            .as_ref()
            .and_then(|given| tilt_limit(reader, given)),
        works: listed
            .filter_map(|(i, given)| work(reader, given, &format!("watch.works[{}]", i + 1)))
            .collect(),
        logs: logs(reader, raw.log.as_ref()),
    }
}

fn tilt_limit(reader: &mut Reader, given: &At<NumberRaw>) -> Option<f64> {
    const PATH: &str = "watch.tilt_limit";
    let ratio = match &given.value {
        NumberRaw::Number(ratio) => Some(*ratio),
        NumberRaw::Text(text) => tilt_ratio(text),
    };
    if let Some(ratio) = ratio.filter(|ratio| (TILT.0..=TILT.1).contains(ratio)) {
        reader.mark(PATH, &given.span);
        judge_limit(reader, PATH, ratio);
        return Some(ratio);
    }
    let fault = Fault::new(
        given.span.clone(),
        PATH,
        WrongSurvey::IsNotTiltThat(PATH.to_string()),
    );
    reader.fault(fault.allowed(WrongSurvey::MustBeRatioOf));
    None
}

/// Whether a text is only a year, a month or a day of the calendar.
fn is_date(text: &str) -> bool {
    match text.len() {
        4 => is_day(&format!("{text}-01-01")),
        7 => is_day(&format!("{text}-01")),
        _ => is_day(text),
    }
}

fn work(reader: &mut Reader, given: &At<WorkRaw>, path: &str) -> Option<WorkPart> {
    let raw = &given.value;
    let mut needed = |key: &str, is_there: bool, allowed: WrongSurvey| {
        let path = format!("{path}.{key}");
        // a wrong one has been reported
        if !is_there && !reader.is_reported(&path) {
            let fault = Fault::new(
                given.span.clone(),
                &path,
                WrongSurvey::IsMissing(path.to_string()),
            );
            reader.fault(fault.allowed(allowed));
        }
    };
    needed("date", raw.date.is_some(), WrongSurvey::NeedsDate);
    needed(
        "kind",
        raw.kind.is_some(),
        WrongSurvey::NeedsRepairInspectionSensors,
    );
    let date = raw.date.as_ref()?;
    if !is_date(&date.value) {
        let path = format!("{path}.date");
        let fault = Fault::new(
            date.span.clone(),
            &path,
            WrongSurvey::IsNotDate {
                path: path.to_string(),
                date: date.value.to_string(),
            },
        );
        reader.fault(fault.allowed(WrongSurvey::MustBeSuchAs));
        return None;
    }
    Some(WorkPart {
        date: date.value.clone(),
        what: raw.what.clone(),
        kind: match raw.kind.as_ref()?.value {
            WorkKindRaw::Repair => WorkKind::Repair,
            WorkKindRaw::Inspection => WorkKind::Inspection,
            WorkKindRaw::Sensors => WorkKind::Sensors,
            WorkKindRaw::Event => WorkKind::Event,
        },
    })
}
