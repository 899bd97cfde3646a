//! A measured tilt that is not in the start of a run.

use crate::judgement::last_tilt;
use crate::survey_dates::date;
use dolmen_project::{Project, Structure, Survey, WarningKind, WorkKind};

/// A measured tilt that is not in the model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TiltLeftOut {
    /// The survey.
    pub survey: String,
    /// As written, by direction: "x 1/177, y 1/540".
    pub written: String,
}

/// Slope from which a tilt left out appears in the headline: 1/100, which timber and masonry storeys have from their construction. Our choice.
const SLOPE_SAID: f64 = 0.01;

impl TiltLeftOut {
    /// The same for a run, in which chains start plumb unless their model leans.
    pub(crate) fn of_runs(project: &Project) -> Option<Self> {
        match &project.structure {
            Structure::Chain(part) if part.lean.is_none() && !part.takes_no_tilt => Self::worst(project),
            _ => Self::of_model(project),
        }
    }

    /// The larger tilt of the latest dated survey and of those without a date, if it matters.
    fn worst(project: &Project) -> Option<Self> {
        let (survey, _) = last_tilt(project)?;
        Self::of_directions(survey, |_| true)
    }

    /// A tilt that matters and is not in the model of a project. Storeys of buildings start plumb. Stones with their own tilts or offsets keep
    /// them. Among several surveys the latest dated one decides, even if an undated one has a larger tilt, or if only an earlier one measured
    /// a direction and no repair followed. A tilt left out by `as_surveyed` is intended.
    pub(crate) fn of_model(project: &Project) -> Option<Self> {
        let is_left_out = match &project.structure {
            Structure::Stack(_) => project
                .warnings
                .iter()
                .any(|warning| warning.kind == WarningKind::SurveyTilt),
            Structure::Frame(part) => part.lean.is_none() && !part.takes_no_tilt,
            Structure::Building(_) => true,
            // its beds are checked for its tilt
            Structure::Chain(_) => false,
            Structure::Survey => return None,
        };
        let leans_as = match &project.structure {
            Structure::Stack(part) => part.lean.as_ref().map(|lean| &lean.survey),
            Structure::Chain(part) => part.lean.as_ref().map(|lean| &lean.survey),
            Structure::Frame(part) => part.lean.as_ref().map(|lean| &lean.survey),
            Structure::Building(_) | Structure::Survey => None,
        };
        let tilted = project.surveys.iter().filter(|survey| !survey.tilt.is_empty());
        if is_left_out {
            return Self::worst(project);
        }
        let used = tilted.clone().find(|survey| Some(&survey.name) == leans_as)?;
        let when = date(&used.name)?;
        // an undated survey may be the latest, so a larger tilt in it may be the present one
        let larger = tilted
            .clone()
            .filter(|survey| date(&survey.name).is_none() && survey.tilt_together() > used.tilt_together());
        let worst = larger.max_by(|a, b| a.tilt_together().total_cmp(&b.tilt_together()));
        if let Some(found) = worst.and_then(|survey| Self::of_directions(survey, |_| true)) {
            return Some(found);
        }
        let is_repaired = |day: [u32; 3]| {
            let mut works = project
                .watch
                .works
                .iter()
                .filter(|work| work.kind == WorkKind::Repair);
            works.any(|work| date(&work.date).is_some_and(|of| of >= day && of <= when))
        };
        let earlier =
            tilted.filter(|survey| date(&survey.name).is_some_and(|day| day < when && !is_repaired(day)));
        let mut found: Vec<Self> = earlier
            .filter_map(|survey| Self::of_directions(survey, |own| !used.tilt.contains_key(own)))
            .collect();
        found.pop()
    }

    /// The tilt of a survey in some of its directions, if it matters.
    fn of_directions(survey: &Survey, is_meant: impl Fn(&str) -> bool) -> Option<Self> {
        let each = || survey.tilt.iter().filter(|(direction, _)| is_meant(direction));
        let squares = each().map(|(_, tilt)| tilt.ratio * tilt.ratio);
        let counts = squares.sum::<f64>().sqrt() >= SLOPE_SAID;
        let written = each().map(|(direction, tilt)| format!("{direction} {}", tilt.written));
        counts.then(|| TiltLeftOut {
            survey: survey.name.clone(),
            written: written.collect::<Vec<_>>().join(", "),
        })
    }

    /// The tilt of the latest survey with one; without any date, of the last one listed.
    pub(crate) fn of(surveys: &[Survey]) -> Option<Self> {
        let tilted = surveys.iter().filter(|survey| !survey.tilt.is_empty());
        let survey = tilted.max_by_key(|survey| date(&survey.name))?;
        Some(TiltLeftOut {
            survey: survey.name.clone(),
            written: Self::written(survey),
        })
    }

    /// The tilt of a survey as written, by direction.
    pub(crate) fn written(survey: &Survey) -> String {
        let each = survey.tilt.iter();
        let written = each.map(|(direction, tilt)| format!("{direction} {}", tilt.written));
        written.collect::<Vec<_>>().join(", ")
    }
}
