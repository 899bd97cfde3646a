//! Reduces the surveys of each day to one, for a history of a structure.

use crate::survey_dates::day_of_a_record;
use dolmen::monitoring::{HistorySurvey, MonitoringError, Tracking, pooled};

/// Surveys by time, one per day.
pub(crate) struct Days {
    pub(crate) surveys: Vec<HistorySurvey>,
    /// Days with several surveys, and their numbers.
    pub(crate) several: Vec<(String, usize)>,
    /// Names of surveys left out because another one is of the same day.
    pub(crate) left_out: Vec<String>,
}

/// Reduces the surveys of each day to one. Surveys named only by time, such as records of a logger, are [pooled]. Of the others the first
/// counts, and only on days without those.
///
/// Several surveys of one day are not a separate history: effects of sun and traffic within a day do not represent the scatter of days and
/// seasons, and would cause false alarms in the afternoon.
pub(crate) fn days(mut surveys: Vec<HistorySurvey>, tracking: &Tracking) -> Result<Days, MonitoringError> {
    surveys.sort_by(|a, b| a.day.total_cmp(&b.day));
    let mut found = Days {
        surveys: Vec::with_capacity(surveys.len()),
        several: Vec::new(),
        left_out: Vec::new(),
    };
    let mut surveys = surveys.into_iter().peekable();
    while let Some(first) = surveys.next() {
        let day = first.day;
        let mut all = vec![first];
        while let Some(next) = surveys.next_if(|next| next.day == day) {
            all.push(next);
        }
        let is_of_day = |survey: &HistorySurvey| day_of_a_record(&survey.name).is_some();
        let (mut plain, mut others): (Vec<_>, Vec<_>) = all.into_iter().partition(is_of_day);
        if plain.is_empty() {
            plain = others.drain(..1).collect();
        }
        found
            .left_out
            .extend(others.into_iter().map(|survey| survey.name));
        let mut one = pooled(&plain, tracking)?;
        if plain.len() > 1 {
            if let Some(date) = day_of_a_record(&one.name) {
                one.name = date.to_owned();
            }
            found.several.push((one.name.clone(), plain.len()));
        }
        found.surveys.push(one);
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn survey(name: &str, day: f64) -> HistorySurvey {
        HistorySurvey {
            name: name.to_owned(),
            day,
            temperature_c: Some(day),
            modes: Vec::new(),
            tilts: Vec::new(),
        }
    }

    #[test]
    fn holds_records_of_one_day_are_one_and_surveys_with_words_stand_back() {
        let all = vec![
            survey("2026-01-02T13:00", 2.0),
            survey("2026-01-01 after", 1.0),
            survey("2026-01-02", 2.0),
            survey("2026-01-01 before", 1.0),
            survey("2026-01-02 by hand", 2.0),
            survey("2026-01-03T10:00:00", 3.0),
        ];
        let found = days(all, &Tracking::default()).unwrap();
        let names: Vec<&str> = found.surveys.iter().map(|survey| survey.name.as_str()).collect();
        assert_eq!(names, ["2026-01-01 after", "2026-01-02", "2026-01-03T10:00:00"]);
        assert_eq!(found.several, [("2026-01-02".to_owned(), 2)]);
        assert_eq!(found.left_out, ["2026-01-01 before", "2026-01-02 by hand"]);
    }
}
