//! Histories without viscous damping, and the damping ratio from a survey.

use crate::survey_dates::date;
use dolmen_project::{ModeKind, Survey};

/// A note that a history has no viscous damping.
#[derive(Clone, Debug, PartialEq)]
pub struct Undamped {
    /// The damping of the lowest mode in the latest survey with damping; `None` without one.
    pub identified: Option<IdentifiedDamping>,
}

/// An identified damping ratio.
#[derive(Clone, Debug, PartialEq)]
pub struct IdentifiedDamping {
    /// The survey.
    pub survey: String,
    /// ζ of its lowest mode of translation.
    pub damping_ratio: f64,
}

impl Undamped {
    /// The damping from surveys, in one direction or in any.
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
