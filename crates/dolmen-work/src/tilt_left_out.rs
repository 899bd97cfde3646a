//! A measured tilt that a run does not start from.

use dolmen_project::Survey;

/// A tilt that was measured and is not in the model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TiltLeftOut {
    /// The survey.
    pub survey: String,
    /// As written, by direction: "x 1/177, y 1/540".
    pub written: String,
}

impl TiltLeftOut {
    /// That of the last survey that states any.
    pub(crate) fn of(surveys: &[Survey]) -> Option<Self> {
        let survey = surveys.iter().rev().find(|survey| !survey.tilt.is_empty())?;
        let each = survey.tilt.iter();
        let written = each.map(|(direction, tilt)| format!("{direction} {}", tilt.written));
        Some(TiltLeftOut {
            survey: survey.name.clone(),
            written: written.collect::<Vec<_>>().join(", "),
        })
    }
}
