//! The modes of a survey for comparisons and histories.

use crate::surveyed::SurveyAnswer;
use dolmen::assess::Surveyed;
use dolmen::modal::{ObservedMode, ObservedPoint};
use dolmen::signal::Channel;
use dolmen_project::{ModeKind, Survey, SurveyMode};

/// The modes of a survey: from its records if it has any, otherwise those stated in the file.
pub(crate) fn surveyed(survey: &Survey, found: Option<&SurveyAnswer>) -> Surveyed {
    let mut modes = match found.and_then(SurveyAnswer::modes) {
        Some((modes, time_blocks)) => {
            let mut all = ObservedMode::all(modes, time_blocks);
            let setups = found
                .and_then(|found| found.setups.as_ref())
                .filter(|setups| setups.joint.is_none());
            let merged = setups.iter().flat_map(|setups| &setups.merged.merged);
            for (mode, merged) in all.iter_mut().zip(merged) {
                let own = merged.degrees_of_freedom.unwrap_or(f64::INFINITY);
                mode.degrees_of_freedom = mode.degrees_of_freedom.min(own);
            }
            all
        }
        None => {
            let listed = survey.modes.iter();
            listed
                .flat_map(|(direction, modes)| modes.iter().map(|mode| stated(direction, mode)))
                .collect()
        }
    };
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    Surveyed {
        name: survey.name.clone(),
        temperature_c: survey.temperature_c,
        modes,
    }
}

fn stated(direction: &str, mode: &SurveyMode) -> ObservedMode {
    let twists = mode.kind == ModeKind::Torsion;
    ObservedMode {
        accepted: false,
        frequency_hz: mode.frequency.value,
        frequency_sd_hz: mode.frequency.cov.map(|_| mode.frequency.standard_deviation()),
        damping_ratio: mode.damping_ratio.as_ref().map(|zeta| zeta.value),
        damping_ratio_sd: mode
            .damping_ratio
            .as_ref()
            .and_then(|zeta| zeta.cov.map(|_| zeta.standard_deviation())),
        degrees_of_freedom: f64::INFINITY,
        direction: Some(if twists {
            "torsion".to_owned()
        } else {
            direction.to_owned()
        }),
        shape: mode
            .shape
            .iter()
            .map(|point| {
                let name = format!("{direction} at {:.3} m", point.height_m);
                ObservedPoint::real(Channel::named(name), point.displacement)
            })
            .collect(),
    }
}
