//! Steps of a tilt that turn its sign alone: more likely one that was written the other way round than a structure that swung through the vertical.

use super::scan::ChangeForm;
use super::tilt::{TiltChange, TiltTrend};

/// Readings on either side of a step whose means are compared, at most.
const BESIDE: usize = 3;
/// Sum of the tilts before and behind over their difference below which the sign alone turned. Chosen here.
const OPPOSITE: f64 = 0.1;
/// Standard deviations of the step from which that is asked. Chosen here.
const SIZE_LEAST: f64 = 6.0;

impl TiltTrend {
    /// Whether the tilt behind a step is that before it with the other sign.
    pub fn turns_sign(&self, step: &TiltChange) -> bool {
        let ratios = &self.series.ratios;
        let is_sound = |i: &usize| self.outliers.iter().all(|of| of.at != *i);
        let mean =
            |which: Vec<usize>| -> f64 { which.iter().map(|i| ratios[*i]).sum::<f64>() / which.len() as f64 };
        let before = mean((0..step.from).rev().filter(is_sound).take(BESIDE).collect());
        let behind = mean((step.from..ratios.len()).filter(is_sound).take(BESIDE).collect());
        let size = (behind - before).abs();
        step.form == ChangeForm::Step
            && size > SIZE_LEAST * step.sd
            && (behind + before).abs() <= OPPOSITE * size
    }

    /// Whether the first readings and the last ones have opposite signs for that reason alone: which of both is right decides where the tilt goes, so that
    /// nothing is forecast.
    pub fn is_sign_in_question(&self) -> bool {
        self.changes.iter().filter(|of| self.turns_sign(of)).count() % 2 == 1
    }
}

/// Leaves out when a limit is reached, where a sign is in question.
pub(super) fn without_forecast(trend: &mut TiltTrend) {
    if !trend.is_sign_in_question() {
        return;
    }
    if let Some(reach) = trend.slope.as_mut().and_then(|slope| slope.reach.as_mut()) {
        (reach.years, reach.years_earliest, reach.years_latest) = (None, None, None);
    }
}
