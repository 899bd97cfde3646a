//! Works on the structure, by their days.

use crate::survey_dates::{date, day_of};
use dolmen_project::{Project, WorkPart};

/// Works with a date, each with its day, by time.
pub(crate) fn works_by_day(project: &Project) -> Vec<(f64, WorkPart)> {
    let works = project.watch.works.iter();
    let dated = works.filter_map(|work| Some((day_of(date(&work.date)?), work.clone())));
    let mut works: Vec<(f64, WorkPart)> = dated.collect();
    works.sort_by(|a, b| a.0.total_cmp(&b.0));
    works
}
