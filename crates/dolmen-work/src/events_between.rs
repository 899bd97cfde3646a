//! Events between two surveys, from the project file.

use crate::answer::CompareAnswer;
use crate::survey_dates::{date, days_of};
use dolmen_project::{WorkKind, WorkPart};

/// An event that may have changed the structure.
#[derive(Clone, Debug, PartialEq)]
pub enum EventBetween {
    /// A work or an event of `[watch]`.
    Work(WorkPart),
    /// A survey whose record holds an earthquake, as the file states.
    Earthquake(String),
}

impl CompareAnswer {
    /// Works and earthquakes between the two surveys, including both days, by time. Inspections change nothing and are left out.
    pub fn between(&self) -> Vec<EventBetween> {
        let days = |name: &str| date(name).map(days_of);
        let (Some([from, _]), Some([_, to])) = (days(&self.from), days(&self.to)) else {
            return Vec::new();
        };
        let [from, to] = [from.min(to), from.max(to)];
        let within = |name: &str| days(name).filter(|[first, last]| *last >= from && *first <= to);
        let works = self.project.watch.works.iter();
        let works = works.filter(|work| work.kind != WorkKind::Inspection);
        let works = works.filter_map(|work| Some((within(&work.date)?, EventBetween::Work(work.clone()))));
        let surveys = self
            .project
            .surveys
            .iter()
            .filter(|survey| survey.earthquake.is_some());
        let felt = surveys.filter_map(|survey| {
            Some((
                within(&survey.name)?,
                EventBetween::Earthquake(survey.name.clone()),
            ))
        });
        let mut all: Vec<([f64; 2], EventBetween)> = works.chain(felt).collect();
        all.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        all.into_iter().map(|(_, of)| of).collect()
    }
}
