//! Histories that run without viscous damping, and the damping ratio that a survey would give them.

use crate::survey_dates::date;
use dolmen_project::{ModeKind, Survey};

/// That a history ran without viscous damping.
#[derive(Clone, Debug, PartialEq)]
pub struct Undamped {
    /// What the latest survey that identified damping measured in the lowest mode; `None` if none did.
    pub identified: Option<IdentifiedDamping>,
}

/// A damping ratio that was identified.
#[derive(Clone, Debug, PartialEq)]
pub struct IdentifiedDamping {
    /// The survey.
    pub survey: String,
    /// ζ of its lowest mode of translation.
    pub damping_ratio: f64,
}

impl Undamped {
    /// What surveys say, in one direction or in any.
    pub(crate) fn of(surveys: &[Survey], direction: Option<&str>) -> Undamped {
        let each = surveys.iter().filter_map(|survey| {
            let of_direction = |name: &str| direction.is_none_or(|direction| direction == name);
            let directions = survey.modes.iter().filter(|(name, _)| of_direction(name));
            let modes = directions.flat_map(|(_, modes)| modes.iter());
            let identified = modes
                .filter(|mode| mode.kind == ModeKind::Translation)
                .filter_map(|mode| Some((mode.frequency.value, mode.damping_ratio.as_ref()?)))
                .filter(|(_, damping)| !damping.is_assumed() && damping.value > 0.0);
            let (_, lowest) = identified.min_by(|a, b| a.0.total_cmp(&b.0))?;
            Some(IdentifiedDamping {
                survey: survey.name.clone(),
                damping_ratio: lowest.value,
            })
        });
        Undamped {
            identified: each.max_by_key(|of| date(&of.survey)),
        }
    }
}
